// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/points_certificate.h: the certificate about classified points, version 1, as plain data; its encoding
// and a text dump. The page: docs/certificates/points.md. Nothing here decides anything.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/format/mesh_certificate.h"
#include "verify/format/patch_entities.h"

namespace veritope::certificate {

inline constexpr std::string_view kPointsClaim = "points-1";
inline constexpr std::string_view kPointsMagic = "VTPT";

/// The answers file that the certificate speaks about, beside its model.
struct AnswersSubject {
  std::string sha256;  ///< 64 lower-case hex digits
  std::uint64_t bytes = 0;
  bool are_decimals_exact = false;  ///< false: decimals are rounded to the nearest binary64
  bool is_winding = false;          ///< points off the model have any f and no word
  std::uint64_t points = 0, on = 0, undecided = 0;
};

struct PointsBody {
  /// Spline models: of patches and entities. Expressions: of solids and operands.
  std::uint32_t num_faces = 0, num_vertex_ids = 0;
  std::uint64_t num_points = 0;
  /// For each point off the model its direction, 0 to 5; for each point on it the number of a facet, as varint, or a
  /// place on a patch. The words of the answers tell which bytes are which. In the certificate of a spline model the
  /// breaks of its surfaces come first. In that of an expression ExpressionHeader comes first, and each point has the
  /// codes of several solids.
  Bytes codes;
};

/// Where a point lies on a patch: u and v, or the barycentric coordinates of corners 1 and 2 of a triangle.
struct PointOnPatch {
  std::uint64_t patch = 0;
  std::array<Fraction, 2> parameters;
};

/// As PointOnPatch, with parameters that are polynomials in t, at a root of a polynomial in an interval. Coefficients,
/// the constant one first, of degrees up to 64.
struct AlgebraicPointOnPatch {
  std::uint64_t patch = 0;
  std::vector<Fraction> modulus;
  std::array<Fraction, 2> interval;
  std::array<std::vector<Fraction>, 2> parameters;
};

/// What PointsBody::codes has for spline models.
class PatchCodes {
 public:
  explicit PatchCodes(const std::vector<PatchEntity>& entities);
  PatchCodes(PatchCodes&&) noexcept;
  ~PatchCodes();

  void add_direction(std::uint8_t code);
  void add(const PointOnPatch& place);
  void add(const AlgebraicPointOnPatch& place);
  Bytes take();

 private:
  std::unique_ptr<internal::ByteWriter> writer_;
};

/// What PointsBody::codes begins with for expressions.
class ExpressionHeader {
 public:
  explicit ExpressionHeader(std::uint64_t num_uncovered);
  ExpressionHeader(ExpressionHeader&&) noexcept;
  ~ExpressionHeader();

  void add_mesh(std::uint32_t num_faces, std::uint32_t num_vertex_ids);
  /// @param by_faces  the patches are boundary faces of the file's volumes
  void add_patches(bool by_faces, std::uint32_t num_patches,
                   const std::vector<PatchEntity>& entities);
  Bytes take();

 private:
  std::unique_ptr<internal::ByteWriter> writer_;
};

/// What is known of the solids of an expression at one point, in the order in which the checkers ask for it.
class ExpressionCodes {
 public:
  ExpressionCodes();
  ExpressionCodes(ExpressionCodes&&) noexcept;
  ~ExpressionCodes();

  void add_off(bool is_inside, std::uint8_t direction);
  void add_on(std::uint32_t facet);
  void add_on(const PointOnPatch& place);
  void add_on(const AlgebraicPointOnPatch& place);
  void add_open();       ///< nothing is said of the solid
  void add_uncovered();  ///< nothing is said of the point
  Bytes take();

 private:
  std::unique_ptr<internal::ByteWriter> writer_;
};

Bytes encode(const PointsBody& body);
/// A whole certificate: statement, line feed, body.
Bytes encode(const Subject& subject, const AnswersSubject& answers, const PointsBody& body);
std::string explain(const PointsBody& body, std::string_view claim, std::size_t max_items);

namespace internal {
/// A whole body, with its magic.
std::optional<PointsBody> read_points(ByteReader body);
}  // namespace internal

}  // namespace veritope::certificate
