// SPDX-License-Identifier: LGPL-3.0-or-later
// Collars of every sound example against what is known of it: homology by GUDHI, genus and nesting of the two solids by the mesh certifier's decision.
#include <gtest/gtest.h>

#include "robust/base/stopwatch.h"
#include "solids/polyhedron/validity.h"
#include "tests/certify/collar_model.h"
#include "tests/support/betti_numbers.h"
#include "verify/certify/collar_solids.h"

namespace veritope {
namespace {

using collar_model::Model;

#ifdef VT_HAVE_GUDHI
octree_shapes::Cells cells_of(const CommonSubdivision& complex) {
  octree_shapes::Cells out;
  for (const OctreeKey key : complex.cells().keys()) out.push_back(key.cell());
  return out;
}
#endif

// PROVES COLLAR-2
TEST(PatchCollarDiff, EverySoundShapeHasOneOfItsGenusHomologyAndNesting) {
  for (const patch_shapes::Shape& shape : patch_shapes::sound_shapes()) {
    SCOPED_TRACE(shape.name);
    const PatchComplex complex = collar_model::complex_of(shape.patches);
    PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kPlain).value();
    Stopwatch watch;
    const StarCover cover = find_star_cover(forest, {});
    const double seconds_cover = watch.lap();
    ASSERT_TRUE(cover.is_complete());
    const PatchCollarSearch search = find_patch_collar(forest, cover);
    const double seconds_collar = watch.lap();
    ASSERT_TRUE(search.collar.has_value()) << (search.open ? search.open->message : "");
    const PatchCollar& collar = *search.collar;
    EXPECT_EQ(collar_model::genus_of_shells(collar), shape.genus);
    std::printf(
        "%-16s %6u cells, levels to %2u, %6zu leaves, %2u rounds; star boxes %.3f s, collar %.3f "
        "s\n",
        shape.name.c_str(), collar.complex.num_cells(), collar.complex.cells().finest_level(),
        collar.place.num_leaves, search.rounds, seconds_cover, seconds_collar);

    std::int64_t genus = 0;
    for (const int g : shape.genus) genus += g;
    for (const bool outer : {true, false}) {
      const auto solid =
          outer ? outer_solid(collar, forest.scale()) : inner_solid(collar, forest.scale());
      const ValidityReport report = decide_validity(solid.value(), {});
      EXPECT_TRUE(report.is_valid) << (outer ? "outer" : "inner");
      EXPECT_EQ(report.counts.genus, std::optional(genus));
      EXPECT_EQ(report.counts.shells, shape.genus.size());
      EXPECT_EQ(report.counts.bodies, std::optional(static_cast<std::uint64_t>(shape.bodies)));
    }
#ifdef VT_HAVE_GUDHI
    // GUDHI's complex has eight cells a voxel of the finest level: the thin shell would take gigabytes.
    if (collar.complex.cells().finest_level() > 7) continue;
    const auto shells = static_cast<int>(shape.genus.size());
    EXPECT_EQ(betti_numbers(cells_of(collar.complex)),
              (Betti{shells, 2 * static_cast<int>(genus), shells}));
#endif
  }
}

}  // namespace
}  // namespace veritope
