// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/cgal/delaunay_cgal.cc: the Delaunay tetrahedralization beside CGAL's.
#include <gtest/gtest.h>

#include "tests/predicates/test_scale.h"
#include "tests/support/cgal_delaunay.h"
#include "tests/support/delaunay_laws.h"
#include "tests/support/point_sets.h"

namespace veritope {
namespace {

TEST(DelaunayBesideCgal, HasTheSameTetrahedraAlsoOfDegenerateSets) {
  for (long round = 0; round < scaled(12); ++round)
    for (int kind = 0; kind < kPointSetKinds; ++kind) {
      if (kind == 13) continue;  // CGAL's kernel has no bound for products of subnormal numbers
      Random random(static_cast<std::uint64_t>(1000 * round + kind));
      const PointSet set =
          make_point_set(kind, 5 + random.below(round % 4 == 0 ? 2000 : 100), random);
      SCOPED_TRACE(set.kind + " " + std::to_string(round) + " " +
                   std::to_string(set.points.size()));
      const auto ours = delaunay_tetrahedra(std::span<const Vec3d>(set.points));
      ASSERT_TRUE(ours);
      std::vector<TetrahedronCorners> cgal = cgal_delaunay(set.points);
      for (TetrahedronCorners& t : cgal)
        for (std::uint32_t& v : t) v = ours->same_as[v];
      EXPECT_EQ(sorted_tetrahedra(ours->tetrahedra), sorted_tetrahedra(cgal));
    }
}

}  // namespace
}  // namespace veritope
