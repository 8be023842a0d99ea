// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/literal_chain.h"

#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "tests/solids/literal_support.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

using literal::tetrahedron_with;

TEST(LiteralChain, AllHypothesesHoldForPnTrianglesOfRegularSolids) {
  for (const Patches& patches : {literal::pn_octahedron(), literal::pn_tetrahedron()}) {
    const PatchComplex complex = complex_of(patches);
    const LiteralHypotheses h = LiteralChain(complex).hypotheses();
    EXPECT_EQ(h.planes_share_lines.holds(), true) << h.planes_share_lines.first;
    EXPECT_EQ(h.curves_in_planes.holds(), true) << h.curves_in_planes.first;
    EXPECT_EQ(h.graphs.holds(), true) << h.graphs.first;
    EXPECT_EQ(h.planes_share_lines.places, complex.num_vertices());
    EXPECT_EQ(h.curves_in_planes.places, complex.num_edges());
    EXPECT_EQ(h.graphs.places, patches.size());
    EXPECT_EQ(h.graphs.first, "");
  }
}

TEST(LiteralChain, PlanesInGeneralPositionShareNoLine) {
  // A flat tetrahedron without a symmetry: three planes at each vertex.
  const PatchComplex complex = complex_of(tetrahedron_with({}));
  const LiteralHypotheses h = LiteralChain(complex).hypotheses();
  EXPECT_EQ(h.planes_share_lines.holds(), false);
  EXPECT_EQ(h.planes_share_lines.violations, 4u);
  EXPECT_EQ(h.planes_share_lines.first,
            "the vertex at (0, 0, 0) of patch 0: the planes of its 3 edges have no line in common");
  EXPECT_EQ(h.curves_in_planes.holds(), true);
  EXPECT_EQ(h.graphs.holds(), true);
}

}  // namespace
}  // namespace veritope
