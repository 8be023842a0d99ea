// SPDX-License-Identifier: LGPL-3.0-or-later
// The predicates against CGAL's exact kernel [CGAL55]: other people's code, other arithmetic. A
// binary of its own, because it compiles slowly.
#include <gtest/gtest.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/segment_segment2d.h"
#include "predicates/segment_triangle.h"
#include "predicates/side_of_plane.h"
#include "predicates/triangle_triangle.h"
#include "tests/predicates/point_generators.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using generate::Points;
using generate::xy;

Kernel::Point_2 cgal(Vec2d p) { return {p.x, p.y}; }
Kernel::Point_3 cgal(const Vec3d& p) { return {p.x, p.y, p.z}; }
Kernel::Triangle_3 cgal(const std::array<Vec3d, 3>& t) {
  return {cgal(t[0]), cgal(t[1]), cgal(t[2])};
}

template <typename Check>
void on_all_kinds(long loops, Check check) {
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    Random random(300u + static_cast<unsigned>(kind));
    for (long i = 0; i < scaled(loops); ++i) {
      const Points p = generate::points(static_cast<generate::Kind>(kind), random);
      check(p);
      ASSERT_FALSE(testing::Test::HasFailure())
          << generate::kKindNames[kind] << ", case " << i << ": " << generate::text(p);
    }
  }
}

TEST(CgalDifferential, OrientationsAgree) {
  on_all_kinds(40000, [](const Points& p) {
    EXPECT_EQ(to_int(orient2d(xy(p[0]), xy(p[1]), xy(p[2]))),
              static_cast<int>(CGAL::orientation(cgal(xy(p[0])), cgal(xy(p[1])), cgal(xy(p[2])))));
    EXPECT_EQ(to_int(orient3d(p[0], p[1], p[2], p[3])),
              static_cast<int>(CGAL::orientation(cgal(p[0]), cgal(p[1]), cgal(p[2]), cgal(p[3]))));
  });
}

TEST(CgalDifferential, CirclesAndSpheresAgree) {
  on_all_kinds(20000, [](const Points& p) {
    EXPECT_EQ(to_int(in_circle(xy(p[0]), xy(p[1]), xy(p[2]), xy(p[3]))),
              static_cast<int>(CGAL::side_of_oriented_circle(cgal(xy(p[0])), cgal(xy(p[1])),
                                                             cgal(xy(p[2])), cgal(xy(p[3])))));
    // CGAL requires a non-degenerate tetrahedron in debug mode only; its determinant is defined for
    // all.
    EXPECT_EQ(to_int(in_sphere(p[0], p[1], p[2], p[3], p[4])),
              static_cast<int>(CGAL::side_of_oriented_sphere(cgal(p[0]), cgal(p[1]), cgal(p[2]),
                                                             cgal(p[3]), cgal(p[4]))));
  });
}

TEST(CgalDifferential, SidesOfPlanesAgree) {
  on_all_kinds(20000, [](const Points& p) {
    if (p[0] == Vec3d{}) return;
    const Kernel::Plane_3 plane(p[0].x, p[0].y, p[0].z, p[2].x);
    EXPECT_EQ(to_int(side_of_plane({p[0], p[2].x}, p[1])),
              static_cast<int>(plane.oriented_side(cgal(p[1]))));
  });
}

TEST(CgalDifferential, MeetingAgrees) {
  on_all_kinds(15000, [](const Points& p) {
    const Vec2d a = xy(p[0]), b = xy(p[1]), c = xy(p[2]), d = xy(p[3]);
    if (!(a == b) && !(c == d)) {
      EXPECT_EQ(segment_segment2d(a, b, c, d) != SegmentContact::kDisjoint,
                CGAL::do_intersect(Kernel::Segment_2(cgal(a), cgal(b)),
                                   Kernel::Segment_2(cgal(c), cgal(d))));
    }
    const IndexedTriangle t{{p[0], p[1], p[2]}, {0, 1, 2}};
    const Kernel::Triangle_3 cgal_t = cgal(t.point);
    if (cgal_t.is_degenerate()) return;
    if (!(p[3] == p[4])) {
      EXPECT_EQ(segment_triangle(p[3], p[4], t.point).kind != SegmentTriangleKind::kDisjoint,
                CGAL::do_intersect(cgal_t, Kernel::Segment_3(cgal(p[3]), cgal(p[4]))));
    }
    const IndexedTriangle u{{p[2], p[3], p[4]}, {3, 4, 5}};
    const Vec3d middle{(p[0].x + p[3].x) / 2, (p[0].y + p[3].y) / 2, (p[0].z + p[3].z) / 2};
    for (const IndexedTriangle& v : {u, IndexedTriangle{{middle, p[3], p[4]}, {3, 4, 5}}}) {
      if (!std::isfinite(middle.x) || !std::isfinite(middle.y) || !std::isfinite(middle.z))
        continue;
      if (cgal(v.point).is_degenerate()) continue;
      EXPECT_EQ(triangle_triangle(t, v) != TriangleContact::kDisjoint,
                CGAL::do_intersect(cgal_t, cgal(v.point)));
    }
  });
}

}  // namespace
}  // namespace veritope
