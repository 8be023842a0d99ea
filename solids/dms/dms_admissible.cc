// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_admissible.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "robust/base/box3d.h"

namespace veritope {
namespace {

Box3d box_of_points(const std::vector<const DmsPoint*>& points) {
  Box3d box = empty_box();
  constexpr double kMost = std::numeric_limits<double>::max();
  for (const DmsPoint* p : points)
    for (std::size_t c = 0; c < 3; ++c) {
      box.lo[c] = std::min(box.lo[c], std::clamp(round_down((*p)[c]), -kMost, kMost));
      box.hi[c] = std::max(box.hi[c], std::clamp(round_up((*p)[c]), -kMost, kMost));
    }
  return box;
}

std::vector<Box3d> corner_boxes(const DmsModel& model) {
  std::vector<Box3d> boxes;
  for (const TetrahedronCorners& t : model.tetrahedra)
    boxes.push_back(box_of_points({&model.clouds[t[0]][0], &model.clouds[t[1]][0],
                                   &model.clouds[t[2]][0], &model.clouds[t[3]][0]}));
  return boxes;
}

}  // namespace

DmsAdmissibility::DmsAdmissibility(const DmsModel& model)
    : model_(model),
      complex_(model.tetrahedra, static_cast<std::uint32_t>(model.clouds.size())),
      boxes_(corner_boxes(model)) {
  for (const DmsCloud& cloud : model.clouds) vertices_.emplace_back(cloud[0]);
}

Sign DmsAdmissibility::side_of_face(TetrahedronFace f, const ExactPoint3& p) const {
  const auto v = complex_.vertices(f);
  return orient3d(vertices_[v[0]], vertices_[v[1]], vertices_[v[2]], p);
}

bool DmsAdmissibility::has_core(std::uint32_t t) const {
  const TetrahedronCorners& v = model_.tetrahedra[t];
  DmsPoint middle;
  for (const std::uint32_t w : v)
    for (std::size_t c = 0; c < 3; ++c) middle[c] += model_.clouds[w][0][c];
  for (Rational& c : middle) c /= Rational(4);
  const ExactPoint3 core(std::move(middle));
  bool is_inside = true;
  for (int sum = 0; sum < model_.degree; ++sum)
    for_each_tetrahedral_index(sum, [&](const TetrahedralIndex& gamma) {
      is_inside = is_inside && (is_as_before(v, gamma) || contains(v, gamma, core));
    });
  return is_inside;
}

// Whether W_γ is that of a lesser γ, since a cloud is collapsed.
bool DmsAdmissibility::is_as_before(const TetrahedronCorners& v,
                                    const TetrahedralIndex& gamma) const {
  for (std::size_t m = 0; m < 4; ++m)
    if (gamma[m] > 0 && is_collapsed(v[m])) return true;
  return false;
}

bool DmsAdmissibility::contains(const TetrahedronCorners& v, const TetrahedralIndex& gamma,
                                const ExactPoint3& core) const {
  std::vector<ExactPoint3> w;
  for (std::size_t m = 0; m < 4; ++m) w.emplace_back(model_.knot(v[m], gamma[m]));
  return orient3d(w[0], w[1], w[2], w[3]) == Sign::kPositive &&
         orient3d(core, w[1], w[2], w[3]) == Sign::kPositive &&
         orient3d(w[0], core, w[2], w[3]) == Sign::kPositive &&
         orient3d(w[0], w[1], core, w[3]) == Sign::kPositive &&
         orient3d(w[0], w[1], w[2], core) == Sign::kPositive;
}

bool DmsAdmissibility::misses_inside(TetrahedronFace face) const {
  std::vector<const DmsPoint*> knots;
  for (const std::uint32_t v : complex_.vertices(face))
    for (const DmsPoint& knot : model_.clouds[v]) knots.push_back(&knot);
  if (knots.size() == 3) return true;
  std::vector<ExactPoint3> exact;
  for (const DmsPoint* knot : knots) exact.emplace_back(*knot);
  const Box3d hull_box = box_of_points(knots);
  bool is_off = true;
  boxes_.visit([&](const Box3d& box) { return is_off && meets(box, hull_box); },
               [&](std::uint32_t t) { is_off = is_off && is_separated(face, exact, t); });
  return is_off;
}

bool DmsAdmissibility::is_separated(TetrahedronFace face, const std::vector<ExactPoint3>& knots,
                                    std::uint32_t t) const {
  const auto no_knot_is = [&](TetrahedronFace f, Sign sign) {
    return std::none_of(knots.begin(), knots.end(),
                        [&](const ExactPoint3& p) { return side_of_face(f, p) == sign; });
  };
  const TetrahedronCorners& corners = model_.tetrahedra[t];
  const bool is_inner = std::none_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
    return side_of_face(face, vertices_[v]) == Sign::kPositive;
  });
  if (is_inner && no_knot_is(face, Sign::kNegative)) return true;
  for (std::uint32_t m = 0; m < 4; ++m)
    if (no_knot_is(4 * t + m, Sign::kNegative)) return true;
  return false;
}

}  // namespace veritope
