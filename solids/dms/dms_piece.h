// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_piece.h: the Bernstein coefficients of a solid's map on simplices on which it is one polynomial, by
// the recurrences of the simplex splines with polynomials in the place of numbers.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_knots.h"

namespace veritope {

namespace internal {
class DmsFrames;
class DmsMonomials;
}  // namespace internal

/// Keeps what does not depend on the simplex, for the tetrahedra that were needed last; so one thread at a time.
class DmsPieces {
 public:
  /// The model and its evaluator must outlive this object.
  /// REQUIRES a model without defects (solids/dms/dms_defects.h).
  DmsPieces(const DmsModel& model, const DmsEvaluator& evaluator);
  ~DmsPieces();

  /// x, y, z of the map on the triangle or the tetrahedron of these corners, exactly: coefficients in the order of
  /// triangle_index or tetrahedral_index. Nothing if the mean of the corners lies outside of the closed domain.
  /// REQUIRES three corners, not on one line, in a face of the boundary, or four, not in one plane; and that no
  /// triangle of knots of a V_γ that contains inner points of their simplex reaches into it, but those in the plane of
  /// three corners.
  /// @cost each simplex spline whose knots' hull contains the mean of the corners, once, in integers over one common
  /// denominator each; at the end one greatest common divisor for each number
  std::optional<std::vector<DmsPoint>> coefficients(std::span<const DmsPoint> corners);
  /// The coefficients of each of the first components of the map, as above. REQUIRES at most as many as there are.
  std::optional<std::vector<std::vector<Rational>>> components(std::span<const DmsPoint> corners,
                                                               std::size_t num_components);

 private:
  internal::DmsFrames& frames(std::uint32_t tetrahedron);

  const DmsModel& model_;
  const DmsEvaluator& evaluator_;
  std::array<std::unique_ptr<internal::DmsMonomials>, 2>
      monomials_;  // of three coordinates, and of four
  std::unordered_map<std::uint32_t, std::unique_ptr<internal::DmsFrames>> frames_;
};

}  // namespace veritope
