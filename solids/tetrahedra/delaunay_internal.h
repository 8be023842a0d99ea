// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/tetrahedra/delaunay_internal.h: the insertion of points into a Delaunay tetrahedralization, for any kind of
// point.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "robust/base/sign.h"
#include "solids/tetrahedra/delaunay.h"
#include "topology/linked_tetrahedra.h"

namespace veritope::internal {

// Inserts points in the order of their numbers. Point n stands for a point at infinity: its tetrahedra, the ghosts, lie
// over the triangles of the hull, so that the whole is closed. With d > 0 in mind for all of them, a ghost's place of
// the point at infinity is outside of its triangle.
//
// The complex is the lower hull of the lifted points, which are moved by infinitesimal amounts (delaunay.h); the point
// at infinity lies above all of them. A new point replaces the tetrahedra that it sees from below, its conflicts. A
// ghost is one if the point is outside of its triangle's plane. For a point in that plane the lifted determinant of the
// triangle, the point and any further point is, up to a factor that does not depend on the amounts, that of the circle:
// the tetrahedron behind the triangle decides.
//
// Points is a class with
//   std::uint32_t size() const;
//   Sign orient3d(TetrahedronCorners) const;
//   Sign in_sphere(TetrahedronCorners, std::uint32_t) const;
//   bool are_collinear(std::uint32_t, std::uint32_t, std::uint32_t) const;
//   bool is_before(std::uint32_t, std::uint32_t) const;  // lexicographically
template <typename Points>
class DelaunayBuilder {
 public:
  explicit DelaunayBuilder(const Points& points)
      : points_(points), infinity_(points.size()), complex_(points.size() + 1) {}

  // Begins with four points that are not in one plane; false if no such points exist.
  bool begin();
  // Inserts the points that were not used to begin with; false if more slots are needed.
  bool insert_all(std::size_t max_slots);

  const LinkedTetrahedra& complex() const { return complex_; }
  bool is_ghost(std::uint32_t t) const {
    const TetrahedronCorners& c = complex_.corners(t);
    return c[0] == infinity_ || c[1] == infinity_ || c[2] == infinity_ || c[3] == infinity_;
  }
  // For each point one at the same place that was inserted before, or itself.
  const std::vector<std::uint32_t>& same_as() const { return same_as_; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  bool are_same(std::uint32_t a, std::uint32_t b) const {
    return !points_.is_before(a, b) && !points_.is_before(b, a);
  }
  void insert(std::uint32_t p);
  std::uint32_t locate(std::uint32_t p);
  void collect_conflicts(std::uint32_t first, std::uint32_t p);
  bool is_conflict(std::uint32_t t, std::uint32_t p) const;
  bool is_conflict_on_sphere(const TetrahedronCorners& corners, std::uint32_t p) const;

  const Points& points_;
  const std::uint32_t infinity_;
  LinkedTetrahedra complex_;
  std::array<std::uint32_t, 4> first_{};
  std::vector<std::uint32_t> same_as_;
  std::uint32_t last_ = 0;    // a tetrahedron of the point that was inserted last
  std::uint32_t random_ = 1;  // of the walk
  // A slot's mark is 2 p + 1 if it is a conflict of point p, 2 p if it is known to be none.
  std::vector<std::uint32_t> mark_;
  std::vector<std::uint32_t> conflicts_;
  std::vector<TetrahedronFace> shell_;
};

template <typename Points>
bool DelaunayBuilder<Points>::begin() {
  const std::uint32_t n = points_.size();
  same_as_.resize(n);
  std::iota(same_as_.begin(), same_as_.end(), 0u);
  if (n < 4) return false;
  const auto next = [&](std::uint32_t from, auto&& wanted) {
    while (from < n && !wanted(from)) ++from;
    return from;
  };
  const std::uint32_t b = next(1, [&](std::uint32_t i) { return !are_same(0, i); });
  const std::uint32_t c =
      next(b + 1, [&](std::uint32_t i) { return !points_.are_collinear(0, b, i); });
  const std::uint32_t d = next(c + 1, [&](std::uint32_t i) {
    return points_.orient3d({0, b, c, i}) != Sign::kZero;
  });
  if (d >= n) return false;
  first_ = {0, b, c, d};
  if (points_.orient3d(first_) == Sign::kNegative) std::swap(first_[2], first_[3]);
  std::vector<std::uint32_t> all{complex_.add(first_)};
  for (std::size_t m = 0; m < 4; ++m) {
    TetrahedronCorners ghost = first_;
    ghost[m] = infinity_;
    std::swap(ghost[(m + 1) % 4], ghost[(m + 2) % 4]);
    all.push_back(complex_.add(ghost));
  }
  complex_.glue_all(all);
  last_ = all[0];
  return true;
}

template <typename Points>
bool DelaunayBuilder<Points>::insert_all(std::size_t max_slots) {
  for (std::uint32_t p = 0; p < points_.size(); ++p) {
    if (std::find(first_.begin(), first_.end(), p) == first_.end()) insert(p);
    if (complex_.num_slots() > max_slots) return false;
  }
  return true;
}

template <typename Points>
void DelaunayBuilder<Points>::insert(std::uint32_t p) {
  const std::uint32_t t = locate(p);
  for (const std::uint32_t v : complex_.corners(t))
    if (v != infinity_ && are_same(v, p)) {
      same_as_[p] = v;
      return;
    }
  collect_conflicts(t, p);
  last_ = complex_.cone(conflicts_, shell_, p);
}

// A conflict of p, or a tetrahedron of which p is a corner's place: the closed tetrahedron that contains p, or the
// ghost of a triangle that p is strictly outside of. Each step crosses a plane of which p is strictly on the other
// side: seen from p, tetrahedra of a Delaunay tetrahedralization have no cycles.
template <typename Points>
std::uint32_t DelaunayBuilder<Points>::locate(std::uint32_t p) {
  std::uint32_t t = last_;
  for (std::uint32_t m = 0; m < 4; ++m)
    if (complex_.corners(t)[m] == infinity_) {
      t = face_tetrahedron(complex_.across(4 * t + m));
      break;
    }
  TetrahedronFace entered = LinkedTetrahedra::kNoFace;
  while (!is_ghost(t)) {
    random_ = random_ * 1664525u + 1013904223u;
    TetrahedronFace left = LinkedTetrahedra::kNoFace;
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t m = (i + (random_ >> 30)) & 3u;
      if (4 * t + m == entered) continue;
      TetrahedronCorners corners = complex_.corners(t);
      corners[m] = p;
      if (points_.orient3d(corners) != Sign::kNegative) continue;
      left = 4 * t + m;
      break;
    }
    if (left == LinkedTetrahedra::kNoFace) return t;
    entered = complex_.across(left);
    t = face_tetrahedron(entered);
  }
  return t;
}

// Conflicts are connected: the new point sees a ball of the lower hull.
template <typename Points>
void DelaunayBuilder<Points>::collect_conflicts(std::uint32_t first, std::uint32_t p) {
  mark_.resize(complex_.num_slots(), kNone);
  const std::uint32_t no = 2 * p, yes = no + 1;
  conflicts_.assign(1, first);
  shell_.clear();
  mark_[first] = yes;
  for (std::size_t i = 0; i < conflicts_.size(); ++i) {
    const std::uint32_t t = conflicts_[i];
    for (std::uint32_t m = 0; m < 4; ++m) {
      const std::uint32_t u = face_tetrahedron(complex_.across(4 * t + m));
      if (mark_[u] == yes) continue;
      if (mark_[u] != no) {
        mark_[u] = is_conflict(u, p) ? yes : no;
        if (mark_[u] == yes) {
          conflicts_.push_back(u);
          continue;
        }
      }
      shell_.push_back(4 * t + m);
    }
  }
}

template <typename Points>
bool DelaunayBuilder<Points>::is_conflict(std::uint32_t t, std::uint32_t p) const {
  TetrahedronCorners corners = complex_.corners(t);
  for (std::uint32_t m = 0; m < 4; ++m) {
    if (corners[m] != infinity_) continue;
    corners[m] = p;
    const Sign outside = points_.orient3d(corners);
    if (outside != Sign::kZero) return outside == Sign::kPositive;
    return is_conflict(face_tetrahedron(complex_.across(4 * t + m)), p);
  }
  const Sign inside = points_.in_sphere(corners, p);
  return inside != Sign::kZero ? inside == Sign::kPositive : is_conflict_on_sphere(corners, p);
}

// The lifted determinant is linear in the amounts, and that of a point has the orientation of the other four as its
// factor. The largest amount with a factor that is not zero decides; that of p has d > 0, and p is lifted out.
template <typename Points>
bool DelaunayBuilder<Points>::is_conflict_on_sphere(const TetrahedronCorners& corners,
                                                    std::uint32_t p) const {
  std::array<std::uint32_t, 4> places{0, 1, 2, 3};
  std::sort(places.begin(), places.end(), [&](std::uint32_t i, std::uint32_t j) {
    return points_.is_before(corners[j], corners[i]);
  });
  for (const std::uint32_t m : places) {
    if (points_.is_before(corners[m], p)) return false;
    TetrahedronCorners moved = corners;
    moved[m] = p;
    const Sign factor = points_.orient3d(moved);
    if (factor != Sign::kZero) return factor == Sign::kPositive;
  }
  return false;
}

// The tetrahedra in numbers of the caller: order[i] is that of point i.
template <typename Points>
Result<DelaunayTetrahedra> build_delaunay(const Points& points,
                                          const std::vector<std::uint32_t>& order,
                                          const DelaunayLimits& limits) {
  DelaunayBuilder<Points> builder(points);
  if (!builder.begin())
    return bad_argument(order.size() < 4
                            ? "a tetrahedron needs four points, not " + std::to_string(order.size())
                            : "all " + std::to_string(order.size()) + " points lie in one plane");
  const std::size_t limit = std::min(limits.max_tetrahedra, TetrahedralComplex::kMaxTetrahedra);
  if (!builder.insert_all(limit))
    return Error{
        Code::kOverLimit, {}, "more than " + std::to_string(limit) + " tetrahedra are needed"};
  std::vector<std::uint32_t> first = order;  // of those at the place of each point
  const auto& same_as = builder.same_as();
  for (std::size_t i = 0; i < order.size(); ++i)
    first[same_as[i]] = std::min(first[same_as[i]], order[i]);
  DelaunayTetrahedra out;
  out.same_as.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) out.same_as[order[i]] = first[same_as[i]];
  const LinkedTetrahedra& complex = builder.complex();
  out.tetrahedra.reserve(complex.num_tetrahedra());
  for (std::uint32_t t = 0; t < complex.num_slots(); ++t) {
    if (!complex.is_used(t) || builder.is_ghost(t)) continue;
    TetrahedronCorners corners = complex.corners(t);
    for (std::uint32_t& v : corners) v = first[v];
    out.tetrahedra.push_back(corners);
  }
  return out;
}

}  // namespace veritope::internal
