// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_knots.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace veritope {
namespace {

constexpr double kMost = std::numeric_limits<double>::max();

void add_point(Box3d& box, const DmsPoint& p) {
  for (std::size_t c = 0; c < 3; ++c) {
    box.lo[c] = std::min(box.lo[c], std::clamp(round_down(p[c]), -kMost, kMost));
    box.hi[c] = std::max(box.hi[c], std::clamp(round_up(p[c]), -kMost, kMost));
  }
}

}  // namespace

DmsPoint difference(const DmsPoint& a, const DmsPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
DmsPoint cross_product(const DmsPoint& a, const DmsPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot_product(const DmsPoint& a, const DmsPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double bounded_double(const Rational& x) {
  const double d = nearest_double(x);
  return std::abs(d) <= 0x1p100 ? d : std::numeric_limits<double>::quiet_NaN();
}
std::array<double, 3> bounded_doubles(const DmsPoint& p) {
  return {bounded_double(p[0]), bounded_double(p[1]), bounded_double(p[2])};
}

Box3d box_around(std::span<const DmsPoint> points) {
  Box3d box = empty_box();
  for (const DmsPoint& p : points) add_point(box, p);
  return box;
}

DmsMatrix linear_part(const std::array<DmsPoint, 4>& points,
                      const std::array<DmsPoint, 4>& values) {
  const DmsPoint a = difference(points[1], points[0]), b = difference(points[2], points[0]),
                 c = difference(points[3], points[0]);
  const std::array<DmsPoint, 3> normals = {cross_product(b, c), cross_product(c, a),
                                           cross_product(a, b)};
  const Rational volume = dot_product(a, normals[0]);
  DmsMatrix out;
  for (std::size_t m = 0; m < 3; ++m) {
    const DmsPoint step = difference(values[m + 1], values[0]);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) out[3 * i + j] += step[i] * normals[m][j] / volume;
  }
  return out;
}

DmsKnotTable::DmsKnotTable(const DmsModel& model)
    : model_(model), stride_(static_cast<std::size_t>(model.degree) + 1) {
  for (std::uint32_t v = 0; v < model.clouds.size(); ++v)
    for (int i = 0; i <= model.degree; ++i) {
      const DmsPoint& p = model.knot(v, i);
      std::size_t same = numbers_.size() - static_cast<std::size_t>(i);
      while (same < numbers_.size() && *points_[numbers_[same]] != p) ++same;
      if (same < numbers_.size()) {
        numbers_.push_back(numbers_[same]);
      } else {
        numbers_.push_back(static_cast<std::uint32_t>(points_.size()));
        points_.push_back(&p);
        rounded_.push_back(bounded_doubles(p));
      }
    }
  for_each_tetrahedral_index(model.degree - 1,
                             [&](const TetrahedralIndex& gamma) { gammas_.push_back(gamma); });
  std::vector<Box3d> of_knots, of_corners;
  for (const TetrahedronCorners& t : model.tetrahedra) {
    Box3d wide = empty_box(), narrow = empty_box();
    for (const std::uint32_t v : t) {
      add_point(narrow, model.knot(v, 0));
      for (int i = 0; i < model.degree; ++i) add_point(wide, model.knot(v, i));
    }
    of_knots.push_back(wide);
    of_corners.push_back(narrow);
  }
  by_knots_ = BoxHierarchy(of_knots);
  by_corners_ = BoxHierarchy(of_corners);
}

std::vector<std::uint32_t> DmsKnotTable::knots(const DmsSupport& support) const {
  std::vector<std::uint32_t> out;
  const TetrahedronCorners& t = model_.tetrahedra[support.tetrahedron];
  for (std::size_t m = 0; m < 4; ++m)
    for (int i = 0; i <= support.gamma[m]; ++i) {
      const std::uint32_t n = number(t[m], i);
      if (std::find(out.begin(), out.end(), n) == out.end()) out.push_back(n);
    }
  return out;
}

std::array<DmsPoint, 4> DmsKnotTable::corners(std::uint32_t tetrahedron) const {
  const TetrahedronCorners& t = model_.tetrahedra[tetrahedron];
  return {model_.knot(t[0], 0), model_.knot(t[1], 0), model_.knot(t[2], 0), model_.knot(t[3], 0)};
}

std::vector<std::uint32_t> DmsKnotTable::find(const BoxHierarchy& tree, const Box3d& box) {
  std::vector<std::uint32_t> out;
  tree.visit([&](const Box3d& b) { return meets(b, box); },
             [&](std::uint32_t t) { out.push_back(t); });
  std::sort(out.begin(), out.end());
  return out;
}

DmsMatrix DmsKnotTable::derivative(const DmsSupport& support) const {
  const TetrahedronCorners& t = model_.tetrahedra[support.tetrahedron];
  std::array<DmsPoint, 4> places, values;
  for (std::size_t m = 0; m < 4; ++m) {
    places[m] = model_.knot(t[m], support.gamma[m]);
    const auto value =
        model_.value(control_of(model_, support.tetrahedron, raised(support.gamma, m)));
    std::copy_n(value.begin(), 3, values[m].begin());
  }
  DmsMatrix out = linear_part(places, values);
  for (Rational& x : out) x *= Rational(model_.degree);
  return out;
}

}  // namespace veritope
