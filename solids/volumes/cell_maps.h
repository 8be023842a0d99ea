// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/volumes/cell_maps.h: what the constructors of volumes share: exact maps in one function space, and volumes
// made of rows of surfaces.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "robust/base/result.h"
#include "splines/bspline.h"

namespace veritope {

/// A cell of a V-model: a volume in space. The first three coordinates are geometry, further ones attributes.
using CellVolume = BSplineVolume<Rational>;
using CellSurface = BSplineSurface<Rational>;
using CellCurve = BSplineCurve<Rational>;
using CellPoint = std::array<Rational, 3>;

/// The limits of what the constructors make: the degree along an axis, and the coefficients of one volume.
inline constexpr int kMaxCellDegree = 15;
inline constexpr std::size_t kMaxCellNumbers = std::size_t{1} << 22;

/// The map with the weight 1 if it is polynomial, else the map.
template <std::size_t N>
BSpline<Rational, N> homogeneous(const BSpline<Rational, N>& map);

/// The maps as elements of one space of splines: clamped, over the domain of the first, with the greatest degree along
/// each axis and the knots that any of them needs; all rational if one is. Nothing changes but the representation: two
/// of the maps are equal up to the affine change of their domains iff the results are, rational ones up to one factor.
/// REQUIRES at least one map.
/// @error  kBadArgument, with the number of the map, for one with another number of coordinates; kOverLimit for a
///         degree over kMaxCellDegree or more than `most` coefficients in one map, before anything is computed
/// @cost   that of elevate and refine
template <std::size_t N>
Result<std::vector<BSpline<Rational, N>>> in_one_space(std::vector<BSpline<Rational, N>> maps,
                                                       std::size_t most = kMaxCellNumbers);

namespace internal {

/// The clamped axis with the greatest degree, and every break as often as the least smooth of the axes needs it, on the
/// domain of the first. REQUIRES an axis.
KnotAxis<Rational> common_axis(const std::vector<KnotAxis<Rational>>& axes);
/// The map over this axis. REQUIRES that the axis is a common axis of several, one of them the map's.
template <std::size_t N>
BSpline<Rational, N> brought_to(BSpline<Rational, N> map, std::size_t axis,
                                const KnotAxis<Rational>& target);
/// @error kOverLimit for a degree over kMaxCellDegree
Status check_degree(int degree);
/// Greville abscissae, as parts of the domain: the control values of the function that rises from 0 to 1.
std::vector<Rational> rising(const KnotAxis<Rational>& axis);
/// The factor f > 0 with a = f b, if one exists. REQUIRES maps in one space.
template <std::size_t N>
std::optional<Rational> factor_between(const BSpline<Rational, N>& a,
                                       const BSpline<Rational, N>& b);

}  // namespace internal

/// Whether a surface can be a part of a cell. @error kBadArgument if it is not in space, kOverLimit for its degree
Status check_cell_surface(const CellSurface& surface);
/// Whether a volume can be a cell. @error as check_cell_surface
Status check_cell_volume(const CellVolume& volume);

/// The volume whose control points at index k of a third axis are those of rows[k]. REQUIRES surfaces on the same knots
/// with as many components, rational all or none, and a number of rows that fits the axis.
CellVolume stacked(std::span<const CellSurface> rows, KnotAxis<Rational> axis);

/// The knots 0, ..., 0, 1, ..., 1.
KnotAxis<Rational> unit_axis(int degree);

/// The volume, if all its weights are positive. @error kBadArgument with the control point
Result<CellVolume> with_positive_weights(CellVolume volume);

/// The control points of the side of a map where the parameter of `axis` begins (end = 0) or ends. REQUIRES a clamped
/// axis.
template <std::size_t N>
requires(N > 1) BSpline<Rational, N - 1> side_of(const BSpline<Rational, N>& map, std::size_t axis,
                                                 std::size_t end);

/// The sign of N = -det(F, F_u, F_v, F_w) of the homogeneous map F, which is that of the Jacobian determinant, in the
/// middle of the domain.
Sign hand_in_the_middle(const CellVolume& volume);

extern template BSpline<Rational, 1> homogeneous(const BSpline<Rational, 1>&);
extern template BSpline<Rational, 2> homogeneous(const BSpline<Rational, 2>&);
extern template BSpline<Rational, 3> homogeneous(const BSpline<Rational, 3>&);
extern template Result<std::vector<CellCurve>> in_one_space(std::vector<CellCurve>, std::size_t);
extern template Result<std::vector<CellSurface>> in_one_space(std::vector<CellSurface>,
                                                              std::size_t);
namespace internal {
extern template CellCurve brought_to(CellCurve, std::size_t, const KnotAxis<Rational>&);
extern template CellSurface brought_to(CellSurface, std::size_t, const KnotAxis<Rational>&);
extern template std::optional<Rational> factor_between(const CellCurve&, const CellCurve&);
extern template std::optional<Rational> factor_between(const CellSurface&, const CellSurface&);
}  // namespace internal
extern template BSpline<Rational, 1> side_of(const BSpline<Rational, 2>&, std::size_t, std::size_t);
extern template BSpline<Rational, 2> side_of(const BSpline<Rational, 3>&, std::size_t, std::size_t);

}  // namespace veritope
