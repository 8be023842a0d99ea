// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_draw_clouds.cc: clouds drawn at random and made smaller until they are admissible
// (solids/dms/dms_make.h).
#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "predicates/exact_point.h"
#include "robust/base/box3d.h"
#include "robust/base/random.h"
#include "solids/base/box_hierarchy.h"
#include "solids/dms/dms_make.h"

namespace veritope {
namespace {

constexpr int kMaxDraws = 64;     // for a knot that must lie on no inner side of a face
constexpr int kMaxHalvings = 40;  // of a cloud, before it collapses
constexpr std::int64_t kSteps = std::int64_t{1} << 20;  // drawn numbers are multiples of 1 / kSteps

Rational largest_difference(const DmsPoint& a, const DmsPoint& b) {
  Rational most;
  for (std::size_t c = 0; c < 3; ++c) most = std::max(most, abs(a[c] - b[c]));
  return most;
}

class CloudDraw {
 public:
  CloudDraw(DmsModel& model, const DmsCloudDraw& draw)
      : model_(model),
        draw_(draw),
        complex_(model.tetrahedra, static_cast<std::uint32_t>(model.clouds.size())),
        faces_at_(model.clouds.size()),
        halvings_(model.clouds.size()) {
    for (const DmsCloud& cloud : model.clouds) vertices_.emplace_back(cloud[0]);
    for (const TetrahedronFace f : complex_.boundary())
      for (const std::uint32_t v : complex_.vertices(f)) faces_at_[v].push_back(f);
  }

  void run() {
    if (model_.degree == 1) return;  // t_1 has no effect
    for (std::uint32_t v = 0; v < model_.clouds.size(); ++v) draw_cloud(v);
    for (std::set<std::uint32_t> bad = inadmissible(); !bad.empty(); bad = inadmissible())
      for (const std::uint32_t v : bad) halve(v);
  }

 private:
  void draw_cloud(std::uint32_t v) {
    const auto at = complex_.tetrahedra_at(v);
    if (at.empty() || draw_.radius.sign() == Sign::kZero) return;
    std::optional<Rational> shortest;
    for (const std::uint32_t t : at)
      for (const std::uint32_t w : model_.tetrahedra[t]) {
        if (w == v) continue;
        Rational edge = largest_difference(model_.clouds[v][0], model_.clouds[w][0]);
        if (!shortest || edge < *shortest) shortest = std::move(edge);
      }
    Random random(draw_.seed ^ (std::uint64_t{v} * 0x9e3779b97f4a7c15u));
    for (int i = 1; i < model_.degree; ++i)
      model_.clouds[v].push_back(draw_knot(v, draw_.radius * *shortest, random));
  }
  DmsPoint draw_knot(std::uint32_t v, const Rational& reach, Random& random) const {
    for (int i = 0; i < kMaxDraws; ++i) {
      DmsPoint knot = model_.clouds[v][0];
      for (Rational& c : knot)
        c += reach * Rational(random.between(-kSteps, kSteps)) / Rational(kSteps);
      const ExactPoint3 exact(knot);
      const bool is_outward =
          std::all_of(faces_at_[v].begin(), faces_at_[v].end(),
                      [&](TetrahedronFace f) { return side_of_face(f, exact) != Sign::kNegative; });
      if (is_outward) return knot;
    }
    return model_.clouds[v][0];
  }
  // Positive on the outer side of the plane of a face.
  Sign side_of_face(TetrahedronFace f, const ExactPoint3& p) const {
    const auto v = complex_.vertices(f);
    return orient3d(vertices_[v[0]], vertices_[v[1]], vertices_[v[2]], p);
  }
  bool is_collapsed(std::uint32_t v) const { return model_.clouds[v].size() == 1; }

  void halve(std::uint32_t v) {
    DmsCloud& cloud = model_.clouds[v];
    if (++halvings_[v] > kMaxHalvings) cloud.resize(1);
    for (std::size_t i = 1; i < cloud.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) cloud[i][c] = (cloud[i][c] + cloud[0][c]) / Rational(2);
  }

  // Vertices whose clouds are not proved to be admissible and are not collapsed.
  std::set<std::uint32_t> inadmissible() const {
    std::set<std::uint32_t> bad;
    const auto add = [&](const auto& vertices) {
      for (const std::uint32_t v : vertices)
        if (!is_collapsed(v)) bad.insert(v);
    };
    for (std::uint32_t t = 0; t < model_.tetrahedra.size(); ++t)
      if (!has_core(t)) add(model_.tetrahedra[t]);
    const BoxHierarchy boxes(corner_boxes());
    for (const TetrahedronFace f : complex_.boundary())
      if (!misses_inside(f, boxes)) add(complex_.vertices(f));
    return bad;
  }

  // Whether d(W_γ) > 0 and the barycentre is inside W_γ for all γ with |γ| < degree: this implies (a) and (b).
  bool has_core(std::uint32_t t) const {
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
  bool is_as_before(const TetrahedronCorners& v, const TetrahedralIndex& gamma) const {
    for (std::size_t m = 0; m < 4; ++m)
      if (gamma[m] > 0 && is_collapsed(v[m])) return true;
    return false;
  }
  bool contains(const TetrahedronCorners& v, const TetrahedralIndex& gamma,
                const ExactPoint3& core) const {
    std::vector<ExactPoint3> w;
    for (std::size_t m = 0; m < 4; ++m) w.emplace_back(model_.knot(v[m], gamma[m]));
    return orient3d(w[0], w[1], w[2], w[3]) == Sign::kPositive &&
           orient3d(core, w[1], w[2], w[3]) == Sign::kPositive &&
           orient3d(w[0], core, w[2], w[3]) == Sign::kPositive &&
           orient3d(w[0], w[1], core, w[3]) == Sign::kPositive &&
           orient3d(w[0], w[1], w[2], core) == Sign::kPositive;
  }

  Box3d box_of_points(const std::vector<const DmsPoint*>& points) const {
    Box3d box = empty_box();
    constexpr double kMost = std::numeric_limits<double>::max();
    for (const DmsPoint* p : points)
      for (std::size_t c = 0; c < 3; ++c) {
        box.lo[c] = std::min(box.lo[c], std::clamp(round_down((*p)[c]), -kMost, kMost));
        box.hi[c] = std::max(box.hi[c], std::clamp(round_up((*p)[c]), -kMost, kMost));
      }
    return box;
  }
  std::vector<Box3d> corner_boxes() const {
    std::vector<Box3d> boxes;
    for (const TetrahedronCorners& t : model_.tetrahedra)
      boxes.push_back(box_of_points({&model_.clouds[t[0]][0], &model_.clouds[t[1]][0],
                                     &model_.clouds[t[2]][0], &model_.clouds[t[3]][0]}));
    return boxes;
  }

  // Whether the hull of all knots of the face's vertices is separated from each tetrahedron by the plane of the face, a
  // plane of an axis, or the plane of a face of the tetrahedron: this implies (c).
  bool misses_inside(TetrahedronFace face, const BoxHierarchy& boxes) const {
    std::vector<const DmsPoint*> knots;
    for (const std::uint32_t v : complex_.vertices(face))
      for (const DmsPoint& knot : model_.clouds[v]) knots.push_back(&knot);
    if (knots.size() == 3) return true;
    std::vector<ExactPoint3> exact;
    for (const DmsPoint* knot : knots) exact.emplace_back(*knot);
    const Box3d hull_box = box_of_points(knots);
    bool is_off = true;
    boxes.visit([&](const Box3d& box) { return is_off && meets(box, hull_box); },
                [&](std::uint32_t t) { is_off = is_off && is_separated(face, exact, t); });
    return is_off;
  }
  bool is_separated(TetrahedronFace face, const std::vector<ExactPoint3>& knots,
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

  DmsModel& model_;
  const DmsCloudDraw& draw_;
  TetrahedralComplex complex_;
  std::vector<ExactPoint3> vertices_;
  std::vector<std::vector<TetrahedronFace>> faces_at_;  // of the boundary
  std::vector<int> halvings_;
};

}  // namespace

void internal::draw_clouds(DmsModel& model, const DmsCloudDraw& draw) {
  CloudDraw(model, draw).run();
}

}  // namespace veritope
