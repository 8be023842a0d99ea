// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_core.h"

#include <algorithm>
#include <utility>

#include "robust/base/box3d.h"
#include "solids/base/box_hierarchy.h"
#include "solids/dms/dms_exact_knots_internal.h"
#include "solids/dms/dms_half_spaces.h"

namespace veritope {
namespace {

using internal::DmsExactKnots;
using internal::side_of;

// h is positive on the inner side of the face opposite to corner m; the face is given in the order of
// kTetrahedronFaces. Its value is d of the tetrahedron with u as corner m.
DmsHalfSpace beyond_face(const DmsPoint& q, const DmsPoint& r, const DmsPoint& s) {
  DmsPoint outward = cross_product(difference(r, q), difference(s, q));
  DmsHalfSpace out;
  out.number = dot_product(outward, q);
  for (Rational& x : outward) x.negate();
  out.vector = std::move(outward);
  return out;
}

// visit(m, γ with γ[m] = 0): the faces of all W_γ with |γ| <= N, each once, those of γ = 0 first.
template <typename Visit>
void for_each_inner_face(const DmsModel& model, const TetrahedronCorners& v, Visit visit) {
  const auto is_new = [&](std::uint32_t vertex, int i) {
    return i == 0 || static_cast<std::size_t>(i) < model.clouds[vertex].size();
  };
  for (int sum = 0; sum <= model.condition_degree(); ++sum)
    for_each_tetrahedral_index(sum, [&](const TetrahedralIndex& gamma) {
      for (std::size_t m = 0; m < 4; ++m)
        if (!is_new(v[m], gamma[m])) return;
      for (std::size_t m = 0; m < 4; ++m)
        if (gamma[m] == 0) visit(m, gamma);
    });
}

ExactPoint3 barycentre(const DmsModel& model, const TetrahedronCorners& v) {
  DmsPoint sum;
  for (const std::uint32_t w : v)
    for (std::size_t c = 0; c < 3; ++c) sum[c] += model.knot(w, 0)[c];
  for (Rational& x : sum) x *= Rational::power_of_two(-2);
  return ExactPoint3(std::move(sum));
}

class CoreSearch {
 public:
  CoreSearch(const DmsModel& model, const std::vector<bool>& is_left_out)
      : model_(model), is_left_out_(is_left_out), knots_(model) {}

  std::vector<DmsNoCore> run() const {
    std::vector<DmsNoCore> out;
    for (std::uint32_t t = 0; t < model_.tetrahedra.size(); ++t) {
      if (is_left_out_[t] || is_plain(t) || has_middle_as_core(t)) continue;
      auto core = find_core(model_, t);
      if (auto* const weights = std::get_if<1>(&core)) out.push_back({t, std::move(*weights)});
    }
    return out;
  }

 private:
  bool is_plain(std::uint32_t t) const {
    const TetrahedronCorners& v = model_.tetrahedra[t];
    return std::all_of(v.begin(), v.end(), [&](std::uint32_t w) { return knots_.size(w) == 1; });
  }
  bool has_middle_as_core(std::uint32_t t) const {
    const TetrahedronCorners& v = model_.tetrahedra[t];
    const ExactPoint3 middle = barycentre(model_, v);
    bool is_inside = true;
    for_each_inner_face(model_, v, [&](std::size_t m, const TetrahedralIndex& gamma) {
      if (!is_inside) return;
      const auto& f = kTetrahedronFaces[m];
      is_inside = side_of({&knots_.at(v[f[0]], gamma[f[0]]), &knots_.at(v[f[1]], gamma[f[1]]),
                           &knots_.at(v[f[2]], gamma[f[2]])},
                          middle) == Sign::kNegative;
    });
    return is_inside;
  }

  const DmsModel& model_;
  const std::vector<bool>& is_left_out_;
  const DmsExactKnots knots_;
};

class HullSearch {
 public:
  HullSearch(const DmsModel& model, const TetrahedralComplex& complex)
      : model_(model), complex_(complex), exact_(model), knots_(model) {}

  std::vector<DmsHullInside> run() {
    for (const TetrahedronFace f : complex_.boundary()) search(f);
    return std::move(out_);
  }

 private:
  void search(TetrahedronFace f) {
    const auto v = complex_.vertices(f);
    std::vector<DmsPoint> points;
    std::vector<const ExactPoint3*> exact;
    for (const std::uint32_t w : v)
      for (int i = 0; i <= model_.condition_degree() && exact_.has(w, i); ++i) {
        points.push_back(model_.knot(w, i));
        exact.push_back(&exact_.at(w, i));
      }
    if (exact.size() == 3) return;  // the face itself
    const bool is_outward = is_off(corners_of(f), exact, Sign::kNegative);
    std::vector<std::uint32_t> near;
    for (const std::uint32_t t : knots_.tetrahedra_near(box_around(points)))
      if (!(is_outward && is_inward(f, t)) && !is_parted(t, exact)) near.push_back(t);
    if (near.empty()) return;
    const int sum = model_.condition_degree();
    for (int j = sum; j >= 0; --j)
      for (int k = sum - j; k >= 0; --k) search_hull(f, {j, k, sum - j - k}, near);
  }

  std::array<const ExactPoint3*, 3> corners_of(TetrahedronFace f) const {
    const auto v = complex_.vertices(f);
    return {&exact_.at(v[0], 0), &exact_.at(v[1], 0), &exact_.at(v[2], 0)};
  }
  // Whether none of the points lies on this side of the plane.
  static bool is_off(const std::array<const ExactPoint3*, 3>& plane,
                     const std::vector<const ExactPoint3*>& points, Sign side) {
    return std::none_of(points.begin(), points.end(),
                        [&](const ExactPoint3* p) { return side_of(plane, *p) == side; });
  }
  bool is_inward(TetrahedronFace f, std::uint32_t t) const {
    std::vector<const ExactPoint3*> corners;
    for (const std::uint32_t w : model_.tetrahedra[t]) corners.push_back(&exact_.at(w, 0));
    return is_off(corners_of(f), corners, Sign::kPositive);
  }
  // Whether the plane of a face of the tetrahedron parts them.
  bool is_parted(std::uint32_t t, const std::vector<const ExactPoint3*>& points) const {
    for (std::uint32_t m = 0; m < 4; ++m)
      if (is_off(corners_of(4 * t + m), points, Sign::kNegative)) return true;
    return false;
  }

  void search_hull(TetrahedronFace f, const std::array<int, 3>& last,
                   const std::vector<std::uint32_t>& near) {
    const auto v = complex_.vertices(f);
    std::vector<DmsPoint> points;
    std::vector<const ExactPoint3*> exact;
    bool has_more = false;
    for (std::size_t m = 0; m < 3; ++m)
      for (int i = 0; i <= last[m]; ++i) {
        points.push_back(model_.knot(v[m], i));
        exact.push_back(&exact_.at(v[m], i));
        has_more |= points.back() != model_.knot(v[m], 0);
      }
    if (!has_more) return;
    for (const std::uint32_t t : near) {
      if (is_parted(t, exact)) continue;
      auto parted = part_from_tetrahedron(points, knots_.corners(t));
      if (auto* const common = std::get_if<DmsCommonPoint>(&parted)) {
        out_.push_back({f, last, t, std::move(*common)});
        return;
      }
    }
  }

  const DmsModel& model_;
  const TetrahedralComplex& complex_;
  const DmsExactKnots exact_;
  const DmsKnotTable knots_;
  std::vector<DmsHullInside> out_;
};

}  // namespace

std::variant<DmsPoint, std::vector<DmsCoreWeight>> find_core(const DmsModel& model,
                                                             std::uint32_t tetrahedron) {
  const TetrahedronCorners& v = model.tetrahedra[tetrahedron];
  std::vector<DmsHalfSpace> all;
  std::vector<DmsCoreWeight> names;
  for_each_inner_face(model, v, [&](std::size_t m, const TetrahedralIndex& gamma) {
    const auto& f = kTetrahedronFaces[m];
    const auto knot = [&](std::size_t i) { return model.knot(v[f[i]], gamma[f[i]]); };
    all.push_back(beyond_face(knot(0), knot(1), knot(2)));
    names.push_back({gamma, static_cast<int>(m), {}});
  });
  auto met = meet_half_spaces(all, DmsHalfSpaceKind::kOpen);
  if (auto* const point = std::get_if<DmsPoint>(&met)) return std::move(*point);
  std::vector<DmsCoreWeight> out;
  for (DmsWeightedHalfSpace& w : std::get<1>(met)) {
    out.push_back(names[w.number]);
    out.back().weight = std::move(w.weight);
  }
  return out;
}

// A plane through no inner point of the tetrahedron: y_0 h_0 + ... + y_3 h_3 = 0, y >= 0, h the half-spaces of the
// faces. The sum of y is 1; y_0, y_1, y_2 are the unknowns of half-spaces.
std::variant<DmsPlane, DmsCommonPoint> part_from_tetrahedron(
    std::span<const DmsPoint> hull, const std::array<DmsPoint, 4>& corners) {
  std::array<DmsHalfSpace, 4> faces;
  for (std::size_t m = 0; m < 4; ++m) {
    const auto& f = kTetrahedronFaces[m];
    faces[m] = beyond_face(corners[f[0]], corners[f[1]], corners[f[2]]);
  }
  std::vector<DmsHalfSpace> all(4);
  for (std::size_t m = 0; m < 3; ++m)
    all[m].vector[m] = Rational(1), all[3].vector[m] = Rational(-1);
  all[3].number = Rational(1);
  for (const DmsPoint& p : hull) {
    const Rational last = height_in(faces[3], p);
    DmsHalfSpace h;
    for (std::size_t m = 0; m < 3; ++m) h.vector[m] = last - height_in(faces[m], p);
    h.number = -last;
    all.push_back(std::move(h));
  }
  auto met = meet_half_spaces(all, DmsHalfSpaceKind::kClosed);
  if (const auto* const y = std::get_if<DmsPoint>(&met)) {
    const std::array<Rational, 4> shares{(*y)[0], (*y)[1], (*y)[2],
                                         Rational(1) - (*y)[0] - (*y)[1] - (*y)[2]};
    DmsPlane plane;
    for (std::size_t m = 0; m < 4; ++m) {
      for (std::size_t c = 0; c < 3; ++c) plane.vector[c] += shares[m] * faces[m].vector[c];
      plane.number -= shares[m] * faces[m].number;
    }
    return plane;
  }
  DmsCommonPoint common{std::vector<Rational>(hull.size()), {}};
  Rational total;
  for (const DmsWeightedHalfSpace& w : std::get<1>(met))
    if (w.number >= 4) total += w.weight;
  for (const DmsWeightedHalfSpace& w : std::get<1>(met)) {
    if (w.number < 4) continue;
    const Rational share = w.weight / total;
    for (std::size_t c = 0; c < 3; ++c) common.point[c] += share * hull[w.number - 4][c];
    common.shares[w.number - 4] = share;
  }
  return common;
}

std::vector<DmsNoCore> find_missing_cores(const DmsModel& model,
                                          const std::vector<bool>& is_left_out) {
  return CoreSearch(model, is_left_out).run();
}

std::vector<DmsHullInside> find_hulls_inside(const DmsModel& model,
                                             const TetrahedralComplex& complex) {
  return HullSearch(model, complex).run();
}

}  // namespace veritope
