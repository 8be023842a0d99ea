// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tests/support/collar_examples.h"

#include "robust/base/check.h"

#include <utility>

namespace veritope::octree_shapes {
namespace {

Cells joined(Cells a, const Cells& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::function<unsigned(const OctreeCell&)> level(unsigned l) {
  return [l](const OctreeCell&) { return l; };
}

/// Levels that are one coarser where i is in the lower half.
std::function<unsigned(const OctreeCell&)> two_levels(unsigned fine) {
  return [fine](const OctreeCell& c) { return c.i * 2 < (1u << c.level) ? fine - 1 : fine; };
}

Cells scattered_children(const Cells& cells, std::uint64_t seed) {
  Random random(seed);
  return refine(cells, [&](const OctreeCell&) { return random.below(8) == 0; });
}

void add_shells(std::vector<CollarExample>& out) {
  const std::vector<std::pair<std::string, VoxelSolid (*)(unsigned)>> solids{
      {"sphere", ball}, {"torus", solid_torus}, {"double torus", double_torus}};
  for (int genus = 0; genus < 3; ++genus) {
    const auto& [name, solid] = solids[static_cast<std::size_t>(genus)];
    const Cells fine = cover(solid(5), level(5));
    out.push_back({name, fine, CollarOutcome::kCollar, {genus}});
    out.push_back({name + ", coarser", coarsen(fine), CollarOutcome::kCollar, {genus}});
    out.push_back(
        {name + ", two levels", cover(solid(5), two_levels(5)), CollarOutcome::kCollar, {genus}});
    out.push_back({name + ", some cells in eight",
                   scattered_children(fine, 7),
                   CollarOutcome::kCollar,
                   {genus}});
  }
}

void add_walls(std::vector<CollarExample>& out) {
  const Cells wall = thick_wall();  // 4 to 28, cavity 10 to 22
  const auto add = [&](std::string name, Cells cells, CollarOutcome outcome,
                       std::vector<int> genus) {
    out.push_back({std::move(name), std::move(cells), outcome, std::move(genus)});
  };
  add("wall", wall, CollarOutcome::kCollar, {0});
  add("wall, coarser", coarsen(coarsen(wall)), CollarOutcome::kCollar, {0});
  add("fin", joined(wall, block(5, {28, 10, 15}, {31, 20, 16})), CollarOutcome::kCollar, {0});
  add("bump inwards", joined(wall, block(5, {10, 12, 12}, {16, 14, 14})), CollarOutcome::kCollar,
      {0});
  add("pit", without(wall, block(5, {4, 12, 12}, {8, 14, 14})), CollarOutcome::kCollar, {0});
  add("hole", without(wall, block(5, {4, 15, 15}, {10, 16, 16})), CollarOutcome::kNotProduct, {});
  add("tunnel", without(wall, block(5, {6, 4, 15}, {7, 28, 16})), CollarOutcome::kNotProduct, {});
  const Cells arch =
      joined(joined(block(5, {28, 10, 15}, {31, 11, 16}), block(5, {28, 20, 15}, {31, 21, 16})),
             block(5, {30, 11, 15}, {31, 20, 16}));
  add("handle", joined(wall, arch), CollarOutcome::kNotProduct, {});
  add("void in the wall", without(wall, block(5, {6, 15, 15}, {8, 17, 17})),
      CollarOutcome::kNotProduct, {});
  const Cells inner =
      without(block(5, {12, 12, 12}, {20, 20, 20}), block(5, {15, 15, 15}, {17, 17, 17}));
  add("two bodies", joined(wall, inner), CollarOutcome::kCollar, {0, 0});
  add("walls merged", joined(joined(wall, inner), block(5, {10, 15, 15}, {12, 16, 16})),
      CollarOutcome::kNotProduct, {});
  add("solid block", block(3, {1, 1, 1}, {5, 5, 5}), CollarOutcome::kNotProduct, {});
  add("one cell", {{0, 0, 0, 0}}, CollarOutcome::kNotProduct, {});
}

}  // namespace

Cells thick_wall() {
  return without(block(5, {4, 4, 4}, {28, 28, 28}), block(5, {10, 10, 10}, {22, 22, 22}));
}

Cells edge_contact_of_different_length() {
  Cells cells = without(block(3, {0, 0, 0}, {7, 7, 7}), block(3, {2, 2, 2}, {5, 5, 5}));
  cells.push_back({3, 3, 3, 7});
  cells.push_back({4, 8, 8, 14});
  return cells;
}

Cells pits_with_common_vertex() {
  const Cells wall = without(block(4, {0, 0, 0}, {9, 9, 9}), block(4, {3, 3, 3}, {6, 6, 6}));
  return without(wall, {{4, 3, 3, 8}, {4, 5, 4, 8}, {4, 5, 4, 7}, {4, 4, 4, 7}});
}

Cells pits_with_common_edge() {
  const Cells wall = without(block(4, {0, 0, 0}, {9, 9, 9}), block(4, {3, 3, 3}, {6, 6, 6}));
  return without(wall, {{4, 3, 3, 8}, {4, 4, 4, 8}});
}

std::vector<CollarExample> collar_examples() {
  std::vector<CollarExample> out;
  add_shells(out);
  add_walls(out);
  out.push_back({"edge contact of different length",
                 edge_contact_of_different_length(),
                 CollarOutcome::kNotManifold,
                 {}});
  out.push_back(
      {"pits with a common vertex", pits_with_common_vertex(), CollarOutcome::kNotManifold, {}});
  out.push_back(
      {"pits with a common edge", pits_with_common_edge(), CollarOutcome::kNotManifold, {}});
  out.push_back(
      {"torus collar with a local knot", tube_in_torus(true), CollarOutcome::kUndecided, {}});
  out.push_back({"the same without the knot", tube_in_torus(false), CollarOutcome::kCollar, {1}});
  return out;
}

CommonSubdivision build(const Cells& cells) {
  return CommonSubdivision::build(OctreeKeySet::make(std::span<const OctreeCell>(cells)).value())
      .value();
}

oracle::GridPoint grid(const CommonSubdivision& complex, std::uint32_t vertex) {
  const unsigned up = OctreeKey::kMaxLevel - complex.cells().finest_level();
  const auto p = complex.point(vertex);
  for (const std::uint32_t x : p)
    VT_CHECK(x >> up << up == x, "a vertex is a corner of cells of the finest level");
  return {static_cast<int>(p[0] >> up), static_cast<int>(p[1] >> up), static_cast<int>(p[2] >> up)};
}

}  // namespace veritope::octree_shapes
