// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_core.h: the conditions (b) and (c) of docs/formats/dms-files.md, decided exactly: a common inner
// point of a tetrahedron's W_γ or weights that show that they have no such point; a plane that parts a hull of knots
// from a tetrahedron or a common point.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "solids/dms/dms_model.h"
#include "solids/dms/dms_region.h"

namespace veritope {

/// h(u) is d of W_γ with u in the place of its point of this corner; the sum of weight times h over one to four of
/// these is a constant <= 0.
struct DmsCoreWeight {
  TetrahedralIndex gamma{};
  int corner = 0;
  Rational weight;  ///< > 0
};
/// A point inside of all W_γ of the tetrahedron with |γ| <= N, or why there is no such point.
/// REQUIRES d(W_γ) > 0 for them. @cost a few steps of an exact linear program with two half-spaces for each γ
std::variant<DmsPoint, std::vector<DmsCoreWeight>> find_core(const DmsModel& model,
                                                             std::uint32_t tetrahedron);

/// The point is the mean of the points of a hull with these shares, which are >= 0.
struct DmsCommonPoint {
  std::vector<Rational> shares;
  DmsPoint point;
};
/// A plane that has the hull on one closed side and the tetrahedron on the other, or a point of the hull strictly
/// inside of the tetrahedron. REQUIRES at least one point, and corners with d > 0. @cost as find_core
std::variant<DmsPlane, DmsCommonPoint> part_from_tetrahedron(
    std::span<const DmsPoint> hull, const std::array<DmsPoint, 4>& corners);

/// A tetrahedron whose W_γ have no common inner point.
struct DmsNoCore {
  std::uint32_t tetrahedron = 0;
  std::vector<DmsCoreWeight> weights;
};
/// The hull of the knots q_0, ..., q_j, r_0, ..., r_k, s_0, ..., s_l of a face of the boundary reaches into a
/// tetrahedron.
struct DmsHullInside {
  TetrahedronFace face = 0;
  std::array<int, 3> last{};  ///< j, k, l
  std::uint32_t tetrahedron = 0;
  DmsCommonPoint common;  ///< a share for each knot, in this order
};

/// All tetrahedra that break (b), ascending. Those for which `is_left_out` holds are not looked at.
/// REQUIRES d(W_γ) > 0 for the others. @cost for most a sign for each of their half-spaces at one point
std::vector<DmsNoCore> find_missing_cores(const DmsModel& model,
                                          const std::vector<bool>& is_left_out);
/// All hulls that break (c), in the order of faces, each with the first tetrahedron that it reaches into.
/// REQUIRES the complex of the model, no face that is overused, d > 0 for all tetrahedra.
/// @cost near-linear: for most pairs that are near each other a few signs
std::vector<DmsHullInside> find_hulls_inside(const DmsModel& model,
                                             const TetrahedralComplex& complex);

}  // namespace veritope
