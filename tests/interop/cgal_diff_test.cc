// SPDX-License-Identifier: LGPL-3.0-or-later
// CGAL's algorithms on our predicates give what they give on CGAL's own.
#include "interop/cgal.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/convex_hull_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "robust/base/random.h"

namespace veritope {
namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point2 = Epick::Point_2;
using Point3 = Epick::Point_3;

struct Cloud {
  std::string name;
  std::vector<Point3> points;  // different ones; in the plane, z is left out and they may coincide
};

double wide(Random& random) {
  const double v = (2 * random.unit() - 1) * 2;
  return std::ldexp(v, static_cast<int>(random.between(-1000, 1000)));
}

const std::vector<Cloud>& clouds() {
  static const std::vector<Cloud> all = [] {
    std::vector<Cloud> r{{"random", {}}, {"grid", {}},    {"cospherical", {}},
                         {"flat", {}},   {"extreme", {}}, {"tiny", {}}};
    Random random(51);
    for (int i = 0; i < 3000; ++i)
      r[0].points.emplace_back(random.unit(), random.unit(), random.unit());
    for (int x = 0; x < 11; ++x) {
      for (int y = 0; y < 11; ++y) {
        for (int z = 0; z < 11; ++z) r[1].points.emplace_back(x, y, z);
      }
    }
    for (int x = -65; x <= 65; ++x) {  // 65^2 = 16^2 + 63^2 = 33^2 + 56^2 = ...
      for (int y = -65; y <= 65; ++y) {
        const int zz = 65 * 65 - x * x - y * y, z = static_cast<int>(std::sqrt(std::max(zz, 0)));
        if (z * z != zz) continue;
        r[2].points.emplace_back(x, y, z);
        if (z != 0) r[2].points.emplace_back(x, y, -z);
      }
    }
    for (int i = 0; i < 500; ++i) {  // most on one plane, which no axis lies in
      const double a = static_cast<double>(random.between(-40, 40)),
                   b = static_cast<double>(random.between(-40, 40));
      r[3].points.emplace_back(a, b, 3 * a - 2 * b + (i % 10 == 0 ? 1 : 0));
    }
    for (int i = 0; i < 250; ++i) {
      r[4].points.emplace_back(wide(random), wide(random), wide(random));
      r[4].points.emplace_back(wide(random), i % 2, random.unit());
    }
    for (int i = 0; i < 400; ++i) {
      const auto small = [&] { return static_cast<double>(random.between(-6, 6)) * 0x1p-1074; };
      r[5].points.emplace_back(small(), small(), small());
    }
    for (Cloud& c : r) {
      std::sort(c.points.begin(), c.points.end());
      c.points.erase(std::unique(c.points.begin(), c.points.end()), c.points.end());
      for (std::size_t i = c.points.size(); i > 1; --i)
        std::swap(c.points[i - 1], c.points[random.below(i)]);
    }
    return r;
  }();
  return all;
}

std::vector<Point2> flattened(const Cloud& cloud) {
  std::vector<Point2> all;
  for (const Point3& p : cloud.points) all.emplace_back(p.x(), p.y());
  return all;
}

template <typename Traits>
std::vector<std::vector<Point3>> delaunay_cells(const Cloud& cloud) {
  const CGAL::Delaunay_triangulation_3<Traits> d(cloud.points.begin(), cloud.points.end());
  EXPECT_TRUE(d.is_valid()) << cloud.name;
  std::vector<std::vector<Point3>> cells;
  for (const auto c : d.finite_cell_handles()) {
    std::vector<Point3> cell;
    for (int k = 0; k < 4; ++k) cell.push_back(c->vertex(k)->point());
    std::sort(cell.begin(), cell.end());
    cells.push_back(cell);
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}
template <typename Traits>
std::vector<std::vector<Point2>> delaunay_triangles(const Cloud& cloud) {
  const std::vector<Point2> points = flattened(cloud);
  const CGAL::Delaunay_triangulation_2<Traits> d(points.begin(), points.end());
  EXPECT_TRUE(d.is_valid()) << cloud.name;
  std::vector<std::vector<Point2>> triangles;
  for (const auto f : d.finite_face_handles()) {
    std::vector<Point2> t;
    for (int k = 0; k < 3; ++k) t.push_back(f->vertex(k)->point());
    std::sort(t.begin(), t.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

TEST(CgalTraits, GivesTheDelaunayTriangulationsOfEpick) {
  for (const Cloud& cloud : clouds()) {
    const auto ours = delaunay_cells<CgalTraits>(cloud), theirs = delaunay_cells<Epick>(cloud);
    EXPECT_GT(ours.size(), 100u) << cloud.name;
    EXPECT_EQ(ours.size(), theirs.size()) << cloud.name;
    EXPECT_TRUE(ours == theirs) << cloud.name;
    const auto flat = delaunay_triangles<CgalTraits>(cloud);
    EXPECT_GT(flat.size(), 50u) << cloud.name;
    EXPECT_TRUE(flat == delaunay_triangles<Epick>(cloud)) << cloud.name;
  }
}

using Mesh = CGAL::Surface_mesh<Point3>;
std::vector<Point3> corners(const Mesh& mesh) {
  std::vector<Point3> all;
  for (const auto v : mesh.vertices()) all.push_back(mesh.point(v));
  std::sort(all.begin(), all.end());
  return all;
}
// No point lies beyond a facet's plane, by CGAL's own predicate.
bool supports(const Mesh& hull, const std::vector<Point3>& points) {
  for (const auto f : hull.faces()) {
    std::vector<Point3> t;
    for (const auto v : hull.vertices_around_face(hull.halfedge(f))) t.push_back(hull.point(v));
    for (const Point3& p : points) {
      if (CGAL::orientation(t[0], t[1], t[2], p) == CGAL::POSITIVE) return false;
    }
  }
  return true;
}

// CGAL cuts a facet of coplanar points into triangles by the order of addresses: twice the same input
// gives two meshes, of the same corners and the same number of triangles.
TEST(CgalTraits, GivesTheConvexHullsOfEpick) {
  for (const Cloud& cloud : clouds()) {
    Mesh ours, theirs;
    CGAL::convex_hull_3(cloud.points.begin(), cloud.points.end(), ours,
                        CGAL::Convex_hull_traits_3<CgalTraits, Mesh, CGAL::Tag_false>());
    CGAL::convex_hull_3(cloud.points.begin(), cloud.points.end(), theirs);
    EXPECT_GT(ours.number_of_faces(), 3u) << cloud.name;
    EXPECT_EQ(ours.number_of_faces(), theirs.number_of_faces()) << cloud.name;
    EXPECT_TRUE(corners(ours) == corners(theirs)) << cloud.name;
    EXPECT_TRUE(supports(ours, cloud.points)) << cloud.name;

    const std::vector<Point2> points = flattened(cloud);
    std::vector<Point2> hull, epick;
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull), CgalTraits());
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(epick), Epick());
    EXPECT_GT(hull.size(), 2u) << cloud.name;
    EXPECT_EQ(hull, epick) << cloud.name;
  }
}

// Small integers: about half of the answers are zero.
TEST(CgalTraits, EveryPredicateHasTheSignsOfEpick) {
  Random random(52);
  const CgalTraits ours;
  const Epick theirs;
  long zeros = 0, coplanar = 0;
  for (int i = 0; i < 60000; ++i) {
    const int range = i % 2 == 0 ? 1 : 3;
    const double scale = std::ldexp(1, static_cast<int>(random.between(-1, 1)) * 400);
    const auto number = [&] { return static_cast<double>(random.between(-range, range)) * scale; };
    const auto point = [&] { return Point3(number(), number(), number()); };
    const Point3 p = point(), q = point(), r = point(), s = point(), t = point();
    const Point2 a(p.x(), p.y()), b(q.x(), q.y()), c(r.x(), r.y()), d(s.x(), s.y());
#define VT_SAME(functor, ...)                                                             \
  EXPECT_EQ(ours.functor##_object()(__VA_ARGS__), theirs.functor##_object()(__VA_ARGS__)) \
      << p << ", " << q << ", " << r << ", " << s << ", " << t
    VT_SAME(orientation_2, a, b, c);
    VT_SAME(left_turn_2, a, b, c);
    VT_SAME(collinear_2, a, b, c);
    VT_SAME(side_of_oriented_circle_2, a, b, c, d);
    VT_SAME(side_of_bounded_circle_2, a, b, c);
    VT_SAME(orientation_3, p, q, r, s);
    VT_SAME(coplanar_3, p, q, r, s);
    VT_SAME(collinear_3, p, q, r);
    VT_SAME(coplanar_orientation_3, p, q, r);
    VT_SAME(side_of_oriented_sphere_3, p, q, r, s, t);
    VT_SAME(side_of_bounded_sphere_3, p, q, r, s);
    if (!theirs.collinear_2_object()(a, b, c)) {
      VT_SAME(side_of_bounded_circle_2, a, b, c, d);
    }
    if (!theirs.coplanar_3_object()(p, q, r, s)) {
      VT_SAME(side_of_bounded_sphere_3, p, q, r, s, t);
    } else if (!theirs.collinear_3_object()(p, q, r)) {
      ++coplanar;
      VT_SAME(coplanar_orientation_3, p, q, r, s);
      VT_SAME(coplanar_side_of_bounded_circle_3, p, q, r, s);
    }
#undef VT_SAME
    zeros += theirs.orientation_3_object()(p, q, r, s) == CGAL::COPLANAR;
    if (HasFailure()) FAIL() << i;
  }
  EXPECT_GT(zeros, 10000);
  EXPECT_GT(coplanar, 5000);
}

// Points of circles on planes that no axis lies in, and beside them.
TEST(CgalTraits, CoplanarSideOfBoundedCircleIsExact) {
  Random random(53);
  long boundary = 0;
  for (int i = 0; i < 20000; ++i) {
    std::int64_t m[4], k = static_cast<std::int64_t>(random.between(1, 1 << 12));
    for (auto& v : m) v = random.between(-9, 9);
    // 5 (cos, sin) of the corners of 25 = 3^2 + 4^2 in the plane of two columns of a quaternion's matrix.
    const std::int64_t w = m[0], x = m[1], y = m[2], z = m[3];
    const std::int64_t u[3] = {w * w + x * x - y * y - z * z, 2 * (x * y + w * z),
                               2 * (x * z - w * y)};
    const std::int64_t v[3] = {2 * (x * y - w * z), w * w - x * x + y * y - z * z,
                               2 * (y * z + w * x)};
    constexpr int kRing[12][2] = {{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                                  {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
    const auto at = [&](int c, int s) {
      return Point3(static_cast<double>(k * (c * u[0] + s * v[0])),
                    static_cast<double>(k * (c * u[1] + s * v[1])),
                    static_cast<double>(k * (c * u[2] + s * v[2])));
    };
    const auto on_ring = [&] {
      const auto& e = kRing[random.below(12)];
      return at(e[0], e[1]);
    };
    const Point3 p = on_ring(), q = on_ring(), r = on_ring();
    const int c = static_cast<int>(random.between(-6, 6)),
              s = static_cast<int>(random.between(-6, 6));
    if (Epick().collinear_3_object()(p, q, r)) continue;
    const int side = 25 - c * c - s * s;
    EXPECT_EQ(
        CgalTraits().coplanar_side_of_bounded_circle_3_object()(p, q, r, at(c, s)),
        side > 0 ? CGAL::ON_BOUNDED_SIDE : (side < 0 ? CGAL::ON_UNBOUNDED_SIDE : CGAL::ON_BOUNDARY))
        << p << ", " << q << ", " << r << ", " << at(c, s);
    boundary += side == 0;
  }
  EXPECT_GT(boundary, 500);
}

TEST(CgalConversions, KeepEveryBit) {
  const Vec3d p{0.1, -0x1p-1074, 0x1.fffffffffffffp1023};
  EXPECT_EQ(from_cgal(to_cgal(p)), p);
  const Vec2d q{0.1, -3};
  EXPECT_EQ(from_cgal(to_cgal<CGAL::Simple_cartesian<double>>(q)), q);
  const Interval a = Interval::from_bounds(-0.1, 0x1p-1074);
  EXPECT_EQ(from_cgal(to_cgal(a)).lo(), a.lo());
  EXPECT_EQ(from_cgal(to_cgal(a)).hi(), a.hi());
}

}  // namespace
}  // namespace veritope
