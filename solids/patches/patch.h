// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/patch.h: one piece of a surface: a tensor-product Bezier piece or a Bezier triangle in space,
// polynomial or rational, with exact coefficients; its sides and corners in the counterclockwise order of the domain.
// Design: docs/design/0015-patch-complex.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "robust/base/box3d.h"
#include "robust/base/result.h"
#include "splines/bezier.h"
#include "splines/bezier_triangle.h"

namespace veritope {

/// The greatest degree, along each axis or of a triangle, that a sound patch complex may have; a patch of a greater
/// degree is read, matched and reported as a finding (PatchDefect::kDegree). A patch of degree greater than
/// kMaxSplineDegree is refused.
inline constexpr int kMaxPatchDegree = 15;

using PatchPoint = std::array<Rational, 3>;

/// Where a patch comes from, for messages.
struct PatchOrigin {
  enum class Kind { kBuilt, kSurface, kFacet, kTriangle };
  Kind kind = Kind::kBuilt;
  std::uint64_t number = 0;  ///< of the surface, facet, triangle or built patch, from 0
  /// For a surface: which of its pieces, along each axis, from 0.
  std::array<std::uint32_t, 2> span{};
  friend bool operator==(const PatchOrigin&, const PatchOrigin&) = default;
};
/// "surface 3, span (0, 2)", "facet 17", "triangle 2", "patch 4".
std::string to_string(const PatchOrigin& origin);

/// A map of [0,1]^2, S(u, v) with u = axis 0 and v = axis 1, or of the standard triangle, into space. Its normal is S_u
/// x S_v; for a flat triangle that is (corner 1 - corner 0) x (corner 2 - corner 0).
/// Corners: (0,0), (1,0), (1,1), (0,1); of a triangle its corners 0, 1, 2. Side s runs from corner s to corner s + 1
/// (the last one to corner 0): counterclockwise, seen from where the normal points.
class Patch {
 public:
  using Tensor = BezierSurface<Rational>;
  using Triangle = BezierTriangle<Rational>;
  using Curve = BezierCurve<Rational>;

  bool is_triangle() const { return std::holds_alternative<Triangle>(map_); }
  bool is_rational() const;
  /// REQUIRES !is_triangle().
  const Tensor& tensor() const;
  /// REQUIRES is_triangle().
  const Triangle& triangle() const;
  const PatchOrigin& origin() const { return origin_; }
  /// A triangle of degree 1.
  bool is_flat_triangle() const { return is_triangle() && triangle().degree() == 1; }
  /// The greater of a tensor's degrees.
  int max_degree() const;

  /// 3 or 4; there are equally many corners.
  std::uint32_t num_sides() const { return is_triangle() ? 3 : 4; }
  /// The side as a curve in its direction of travel; homogeneous iff is_rational(). REQUIRES side < num_sides().
  Curve side(std::uint32_t side) const;
  /// The number of control points of a side, and where in a component the i-th of them is.
  std::size_t side_length(std::uint32_t side) const;
  std::size_t side_index(std::uint32_t side, std::size_t i) const;
  /// The homogeneous coefficients of a corner: 3, or 4 with the weight last. REQUIRES corner < num_sides().
  std::vector<Rational> corner(std::uint32_t corner) const;
  /// All control points, one component after the other; see Bezier and BezierTriangle.
  std::span<const Rational> coefficients() const;
  std::span<const Rational> component(int c) const;
  /// The number of control points.
  std::size_t num_control() const { return component(0).size(); }

  friend bool operator==(const Patch&, const Patch&) = default;

 private:
  friend Result<Patch> make_patch(Tensor map, PatchOrigin origin);
  friend Result<Patch> make_patch(Triangle map, PatchOrigin origin);
  Patch(std::variant<Tensor, Triangle> map, PatchOrigin origin)
      : map_(std::move(map)), origin_(origin) {}

  std::variant<Tensor, Triangle> map_;
  PatchOrigin origin_;
};

/// @error kBadArgument unless the map has three coordinates and all degrees are 1 or more; kOverLimit for a degree over
///        kMaxSplineDegree. Weights are not examined: see PatchDefect::kWeight.
Result<Patch> make_patch(Patch::Tensor map, PatchOrigin origin = {});
Result<Patch> make_patch(Patch::Triangle map, PatchOrigin origin = {});

/// The patch with its normal reversed and all its points kept: a tensor with its axes exchanged, a triangle with
/// corners 1 and 2 exchanged. Side s becomes side num_sides() - 1 - s, travelled the other way, and corner c becomes
/// corner (num_sides() - c) mod num_sides(). Reversing twice gives the patch itself.
Patch reversed(const Patch& patch);
/// Turns the domain so that corner `by` becomes corner 0. Sides and corners are renumbered, nothing else changes.
Patch turned(const Patch& patch, std::uint32_t by);

/// The point of homogeneous coefficients (three, or four with the weight last); nothing if the weight is 0.
std::optional<PatchPoint> point_of(std::span<const Rational> homogeneous);
/// Each coordinate rounded to nearest: for messages and searches. NaN where there is no point.
Point3d approx_point(std::span<const Rational> homogeneous);

}  // namespace veritope
