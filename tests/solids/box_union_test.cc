// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/interval_boxes/box_union.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "solids/interval_boxes/conditions.h"

namespace veritope {
namespace {

using Boxes = std::vector<Box3d>;

std::string text(const Boxes& boxes) {
  std::string out;
  for (const Box3d& b : boxes) {
    out += "{{" + std::to_string(b.lo[0]) + "," + std::to_string(b.lo[1]) + "," +
           std::to_string(b.lo[2]) + "},{";
    out += std::to_string(b.hi[0]) + "," + std::to_string(b.hi[1]) + "," + std::to_string(b.hi[2]) +
           "}} ";
  }
  return out;
}

UnionTopology topology(const Boxes& boxes) { return union_topology(boxes).value(); }

TEST(BoxUnion, ContactsInFacesEdgesAndPointsAreSeen) {
  const Box3d unit{{0, 0, 0}, {1, 1, 1}};
  EXPECT_TRUE(topology({unit}).is_ball());
  EXPECT_TRUE(topology({unit, {{1, 0, 0}, {2, 1, 1}}}).is_ball()) << "a common face";
  EXPECT_FALSE(topology({unit, {{1, 1, 0}, {2, 2, 1}}}).is_manifold) << "a common edge";
  EXPECT_FALSE(topology({unit, {{1, 1, 1}, {2, 2, 2}}}).is_manifold) << "a common corner";
  EXPECT_FALSE(topology({unit, {{1, 1, 1}, {2, 2, 2}}}).defect.empty());
  EXPECT_FALSE(topology({unit, {{0.5, 1, 1}, {2, 2, 2}}}).is_manifold) << "a part of an edge";
  const auto two = topology({unit, {{3, 0, 0}, {4, 1, 1}}});
  EXPECT_TRUE(two.is_manifold);
  EXPECT_EQ(two.bodies, 2u);
  EXPECT_FALSE(two.is_solid());
}

TEST(BoxUnion, AShellOfSixSlabsHasTwoSpheresAndIsFilledByItsInside) {
  Boxes slabs;
  for (std::size_t k = 0; k < 3; ++k)
    for (const double at : {0.0, 4.0}) {
      Box3d b{{-0.5, -0.5, -0.5}, {4.5, 4.5, 4.5}};
      b.lo[k] = at - 0.5, b.hi[k] = at + 0.5;
      slabs.push_back(b);
    }
  const auto shell = topology(slabs);
  EXPECT_TRUE(shell.is_solid());
  EXPECT_EQ(shell.boundary_euler, (std::vector<std::int64_t>{2, 2}));
  const BoxGrid grid = BoxGrid::make(slabs).value();
  const auto inside = [](const Point3d& p) { return std::optional(p[0] > 0 && p[0] < 4); };
  EXPECT_TRUE(topology_of(grid.filled_where(inside).value()).value().is_ball());
  EXPECT_FALSE(grid.filled_where([](const Point3d&) { return std::optional<bool>(); }).has_value());
}

TEST(BoxUnion, BadBoxesAreRefused) {
  EXPECT_EQ(union_topology({}).error().code, Code::kEmpty);
  const Boxes flat{{{0, 0, 0}, {1, 0, 1}}}, open{{{0, 0, 0}, {1, 1.0 / 0.0, 1}}};
  EXPECT_EQ(union_topology(flat).error().code, Code::kBadArgument);
  EXPECT_EQ(union_topology(open).error().code, Code::kBadArgument);
  Boxes many;
  for (int i = 0; i < 300; ++i) {
    const double x = i;
    many.push_back({{x, x, x}, {x + 0.5, x + 0.5, x + 0.5}});
  }
  EXPECT_EQ(union_topology(many).error().code, Code::kOverLimit);
}

// On a small lattice contacts in faces, edges and corners are frequent.
Boxes random_boxes(Random& random) {
  const auto lattice = random.between(3, 6);
  Boxes out(static_cast<std::size_t>(random.between(2, 9)));
  for (Box3d& b : out)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto lo = random.between(0, lattice - 1), hi = random.between(lo + 1, lattice);
      b.lo[k] = static_cast<double>(lo) / 3, b.hi[k] = static_cast<double>(hi) / 3;
    }
  return out;
}

// Proposition 2.1: if A holds, |B| is a 3-manifold with boundary. Corollary 2.1: connected, a solid.
TEST(BoxUnionLaw, ConditionAMakesAManifoldOn10000RandomSets) {
  int with_a = 0, refuted = 0, touching = 0;
  for (std::uint64_t seed = 1; seed <= 10000; ++seed) {
    Random random(seed);
    const Boxes boxes = random_boxes(random);
    const ConditionResult a = decide_a(boxes);
    const UnionTopology t = topology(boxes);
    ASSERT_NE(a.answer, Answer::kUndecided);
    if (a.answer == Answer::kTrue) {
      ++with_a;
      ASSERT_TRUE(t.is_manifold) << "seed " << seed << ": " << text(boxes) << t.defect;
    } else {
      ++touching;
      refuted += !t.is_manifold;
    }
  }
  EXPECT_GE(with_a, 1000);
  EXPECT_GE(touching, 5000);
  EXPECT_GE(refuted, 1000) << "the link test sees contacts in edges and corners";
}

BoundaryModel sphere() {
  return BoundaryModel::make(make_patch_complex(patch_shapes::octant_sphere()).value()).value();
}
// Points of the box inside and outside of the unit sphere.
bool is_crossed(const Box3d& b) {
  double near = 0, far = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double n = std::max({b.lo[k], -b.hi[k], 0.0}), f = std::max(-b.lo[k], b.hi[k]);
    near += n * n, far += f * f;
  }
  return near < 1 && far > 1;
}

// Corollary 2.2 and Remark 2.1: with A, B1 and B2 both |B| = V∪|B| and V_I∪|B| are solids. Boxes of random size around the places of a grid that the
// sphere meets: always B1 and B2, and A but for contacts of equal coordinates.
TEST(BoxUnionLaw, CoversOfASphereAreSolidsOn1000RandomSets) {
  BoundaryModel model = sphere();
  int solids = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    Random random(seed);
    // Few different coordinates: the grid stays small.
    const double cell = 0.75 + 0.5 * random.unit(), shift = random.unit();
    Boxes boxes;
    for (int x = -3; x <= 3; ++x)
      for (int y = -3; y <= 3; ++y)
        for (int z = -3; z <= 3; ++z) {
          const int place[3] = {x, y, z};
          Box3d b;
          for (std::size_t k = 0; k < 3; ++k) {
            const double lo = (place[k] + shift) * cell;
            // Some overlaps have no width: contacts.
            const double margin = random.below(40) == 0 ? 0 : (1 + random.below(2)) * cell / 16;
            b.lo[k] = lo - margin, b.hi[k] = lo + cell + margin;
          }
          if (is_crossed(b)) boxes.push_back(b);
        }
    if (decide_a(boxes).answer != Answer::kTrue) continue;
    const UnionTopology cover = topology(boxes);
    ASSERT_TRUE(cover.is_solid()) << "seed " << seed << ": " << text(boxes);
    const BoxGrid grid = BoxGrid::make(boxes).value();
    const auto inside = [&](const Point3d& p) -> std::optional<bool> {
      Point3d q;
      for (std::size_t k = 0; k < 3; ++k) q[k] = std::ldexp(p[k], model.forest().scale());
      const auto w = winding_number(model.forest(), q);
      if (!w) return std::nullopt;
      EXPECT_EQ(*w == 1, p[0] * p[0] + p[1] * p[1] + p[2] * p[2] < 1) << "seed " << seed;
      return *w == 1;
    };
    const auto filled = grid.filled_where(inside);
    ASSERT_TRUE(filled.has_value()) << "seed " << seed;
    ASSERT_TRUE(topology_of(*filled).value().is_solid()) << "seed " << seed << ": " << text(boxes);
    ++solids;
  }
  EXPECT_GE(solids, 300);
}

}  // namespace
}  // namespace veritope
