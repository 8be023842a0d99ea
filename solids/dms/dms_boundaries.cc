// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_boundaries.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/base/box_hierarchy.h"
#include "solids/dms/dms_knots.h"

namespace veritope {
namespace {

using Triangle = std::array<DmsPoint, 3>;
using Polygon = std::vector<DmsPoint>;  // convex, in a plane, with an inside

// The closed half of a plane on the inner side of a side of a triangle.
struct Half {
  DmsPoint vector;
  Rational number;
  Rational height(const DmsPoint& p) const { return dot_product(vector, p) - number; }
};

DmsPoint normal_of(const Triangle& t) {
  return cross_product(difference(t[1], t[0]), difference(t[2], t[0]));
}
// Corners that turn either way.
std::array<Half, 3> halves_of(const Triangle& t) {
  const DmsPoint normal = normal_of(t);
  std::array<Half, 3> out;
  for (std::size_t i = 0; i < 3; ++i) {
    out[i].vector = cross_product(normal, difference(t[(i + 1) % 3], t[i]));
    out[i].number = dot_product(out[i].vector, t[i]);
  }
  return out;
}

// The parts of a polygon in a half and beside it; one without an inside is empty.
std::array<Polygon, 2> cut(const Polygon& polygon, const Half& half) {
  std::vector<Rational> height;
  bool has_inside = false, has_outside = false;
  for (const DmsPoint& p : polygon) {
    height.push_back(half.height(p));
    has_inside |= height.back().sign() == Sign::kPositive;
    has_outside |= height.back().sign() == Sign::kNegative;
  }
  if (!has_outside) return {polygon, Polygon{}};
  if (!has_inside) return {Polygon{}, polygon};
  std::array<Polygon, 2> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    if (height[i].sign() != Sign::kNegative) out[0].push_back(polygon[i]);
    if (height[i].sign() != Sign::kPositive) out[1].push_back(polygon[i]);
    if ((height[i] * height[j]).sign() != Sign::kNegative) continue;
    const Rational t = height[i] / (height[i] - height[j]);
    DmsPoint crossing = polygon[i];
    for (std::size_t c = 0; c < 3; ++c) crossing[c] += t * (polygon[j][c] - polygon[i][c]);
    out[0].push_back(crossing);
    out[1].push_back(std::move(crossing));
  }
  return out;
}

// What a triangle of its plane leaves of a polygon.
void subtract(const Polygon& polygon, const std::array<Half, 3>& halves,
              std::vector<Polygon>& out) {
  std::vector<Polygon> beside;
  Polygon rest = polygon;
  for (const Half& half : halves) {
    auto [inside, outside] = cut(rest, half);
    if (inside.empty()) {  // they do not overlap
      out.push_back(polygon);
      return;
    }
    if (!outside.empty()) beside.push_back(std::move(outside));
    rest = std::move(inside);
  }
  for (Polygon& part : beside) out.push_back(std::move(part));
}

class BoundarySet {
 public:
  explicit BoundarySet(const DmsModel& model)
      : complex_(model.tetrahedra, static_cast<std::uint32_t>(model.clouds.size())) {
    std::vector<Box3d> boxes;
    for (const TetrahedronFace f : complex_.boundary()) {
      Triangle& t = triangles_.emplace_back();
      const auto v = complex_.vertices(f);
      for (std::size_t i = 0; i < 3; ++i) t[i] = model.knot(v[i], 0);
      boxes.push_back(box_around(t));
      corners_.insert(sorted(t));
    }
    tree_ = BoxHierarchy(boxes);
  }

  /// A point inside of one of its faces that is not in the other set.
  std::optional<DmsBoundaryPoint> find_outside_of(const BoundarySet& other) const {
    for (std::size_t f = 0; f < triangles_.size(); ++f)
      if (auto point = other.find_uncovered(triangles_[f]))
        return DmsBoundaryPoint{false, complex_.boundary()[f], std::move(*point)};
    return std::nullopt;
  }

 private:
  static Triangle sorted(Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  }
  template <typename Visit>
  void visit_near(const Box3d& at, Visit visit) const {
    tree_.visit([&](const Box3d& box) { return meets(box, at); },
                [&](std::uint32_t f) { visit(triangles_[f]); });
  }

  std::optional<DmsPoint> find_uncovered(const Triangle& t) const {
    if (corners_.count(sorted(t)) > 0) return std::nullopt;
    const DmsPoint normal = normal_of(t);
    const Rational level = dot_product(normal, t[0]);
    std::vector<Polygon> rest{{t[0], t[1], t[2]}};
    visit_near(box_around(t), [&](const Triangle& face) {
      const bool is_flat = std::all_of(face.begin(), face.end(), [&](const DmsPoint& p) {
        return dot_product(normal, p) == level;
      });
      if (!is_flat) return;
      const std::array<Half, 3> halves = halves_of(face);
      std::vector<Polygon> left;
      for (const Polygon& part : rest) subtract(part, halves, left);
      rest = std::move(left);
    });
    if (rest.empty()) return std::nullopt;
    return point_off(rest.front());
  }

  // An inner point of the polygon that no face contains. Faces in its plane do not overlap it, and a parabola meets the
  // line in which another plane cuts it at most twice, so the search ends.
  DmsPoint point_off(const Polygon& polygon) const {
    DmsPoint middle;
    for (const DmsPoint& p : polygon)
      for (std::size_t c = 0; c < 3; ++c)
        middle[c] += p[c] / Rational(static_cast<std::int64_t>(polygon.size()));
    const DmsPoint first = difference(polygon[0], middle);
    DmsPoint second;
    for (const DmsPoint& p : polygon)
      if (cross_product(first, difference(p, middle)) != DmsPoint{}) second = difference(p, middle);
    Rational t;
    for (std::int64_t step = 1;; ++step) {
      DmsPoint at = middle;
      for (std::size_t c = 0; c < 3; ++c) at[c] += t * first[c] + t * t * second[c];
      if (!contains(at)) return at;
      t = Rational::power_of_two(-step);
    }
  }
  bool contains(const DmsPoint& p) const {
    bool is_found = false;
    visit_near(box_around(std::span(&p, 1)), [&](const Triangle& face) {
      const DmsPoint normal = normal_of(face);
      if (dot_product(normal, p) != dot_product(normal, face[0])) return;
      const auto halves = halves_of(face);
      is_found |= std::all_of(halves.begin(), halves.end(), [&](const Half& half) {
        return half.height(p).sign() != Sign::kNegative;
      });
    });
    return is_found;
  }

  TetrahedralComplex complex_;
  std::vector<Triangle> triangles_;  // in the order of complex_.boundary()
  std::set<Triangle> corners_;       // of each, sorted
  BoxHierarchy tree_;
};

}  // namespace

std::optional<DmsBoundaryPoint> find_boundary_difference(const DmsModel& first,
                                                         const DmsModel& second) {
  const BoundarySet a(first), b(second);
  if (auto found = a.find_outside_of(b)) return found;
  auto found = b.find_outside_of(a);
  if (found) found->is_of_second = true;
  return found;
}

}  // namespace veritope
