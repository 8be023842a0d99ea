// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/collar/piece_octree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/collar/facing.h"
#include "splines/de_casteljau.h"

namespace veritope {
namespace {

struct Model {
  explicit Model(patch_shapes::Patches patches)
      : complex(make_patch_complex(std::move(patches)).value()),
        forest(PieceForest::make(complex, PieceForest::FrameChoice::kPlain).value()) {
    Box3d all = forest.node(0).hull;
    for (std::uint32_t r = 0; r < forest.num_roots(); ++r)
      all = hull(all, forest.node(forest.root(r)).hull);
    root = root_around(all).value();
  }
  PatchComplex complex;
  PieceForest forest;
  OctreeRoot root;
};

// Cells split at random cover exact points, and those without a piece near are gone.
TEST(PieceOctree, CoversTheSurfaceHoweverItIsSplit) {
  Model m(patch_shapes::torus(3, 1));
  PieceOctree octree(m.forest, m.root, std::size_t{1} << 28);
  Random random(17);
  for (int round = 0; round < 6; ++round) {
    std::vector<bool> which(octree.num_cells());
    for (std::size_t i = 0; i < which.size(); ++i)
      which[i] = octree.key(i).level() < 3 || random.below(2) == 0;
    ASSERT_TRUE(octree.split(which));
    const std::vector<OctreeKey> keys = octree.keys();
    EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
    for (int trial = 0; trial < 200; ++trial) {
      const auto p = static_cast<std::uint32_t>(random.below(m.complex.patches().size()));
      const auto q = evaluate(m.complex.patch(p).tensor(), {Rational::from_double(random.unit()),
                                                            Rational::from_double(random.unit())});
      const auto holds = [&](OctreeKey key) {
        const Box3d box = m.root.box(key);
        for (std::size_t k = 0; k < 3; ++k) {
          const Rational x = Rational::power_of_two(m.forest.scale()) * q[k] / q[3];
          if (x < Rational::from_double(box.lo[k]) || Rational::from_double(box.hi[k]) < x)
            return false;
        }
        return true;
      };
      const auto at = std::find_if(keys.begin(), keys.end(), holds);
      ASSERT_NE(at, keys.end()) << "round " << round << ", trial " << trial;
      bool has_patch = false;
      octree.for_each_piece(
          static_cast<std::size_t>(at - keys.begin()),
          [&](PieceForest::Id id) { has_patch = has_patch || m.forest.node(id).patch == p; });
      EXPECT_TRUE(has_patch);
    }
  }
  // No cell is farther from the surface than a piece may be long: |(sqrt(x^2 + y^2) - 3, z)| is 1 on it.
  const double unit = std::exp2(m.forest.scale());
  for (const OctreeKey key : octree.keys()) {
    const Box3d box = m.root.box(key);
    const Point3d c = approx_centre(box);
    const double d = std::abs(std::hypot(std::hypot(c[0], c[1]) - 3 * unit, c[2]) - unit);
    EXPECT_LE(
        d, (std::sqrt(3.0) / 2 + PieceOctree::kPiece * std::sqrt(3.0)) * extent(box) * (1 + 1e-9));
  }
}

TEST(FacingOfPieces, ASidesFacesItsWayAndATubeNowhere) {
  Model box(patch_shapes::box({0, 0, 0}, {1, 1, 1}));
  FacingOfPieces facing(box.forest);
  Facing corner = kAllDirections, all = kAllDirections;
  for (std::uint32_t r = 0; r < 6; ++r) {
    const Facing one = facing.of(box.forest.root(r));
    EXPECT_EQ(std::popcount(one), 9);  // of 26 directions, the half in front of a plane
    all &= one;
    const Point3d c = approx_centre(box.forest.node(box.forest.root(r)).hull);
    const double middle = std::exp2(box.forest.scale() - 1);
    if (c[0] + c[1] + c[2] > 3 * middle) corner &= one;  // the three faces at (1, 1, 1)
  }
  EXPECT_EQ(all, Facing{0});
  EXPECT_EQ(std::popcount(corner), 1);  // (1, 1, 1)
  Model torus(patch_shapes::torus(3, 1));
  FacingOfPieces around(torus.forest);
  Facing tube = kAllDirections;
  for (std::uint32_t r = 0; r < torus.forest.num_roots(); ++r)
    tube &= around.of_part(torus.forest.root(r), torus.root.box());
  EXPECT_EQ(tube, Facing{0});
}

}  // namespace
}  // namespace veritope
