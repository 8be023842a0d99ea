// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/octree_shapes.h: octree cells of known topology: covers of voxel surfaces, and changes that keep it.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "robust/base/random.h"
#include "topology/octree_key.h"

namespace veritope::octree_shapes {

using Cells = std::vector<OctreeCell>;
using Voxel = std::array<int, 3>;

/// Cells as text that pastes into a test: "{3,1,0,7}, ...".
std::string text(const Cells& cells);

/// A solid of voxels of one level, 2^level along each axis.
class VoxelSolid {
 public:
  VoxelSolid(unsigned level, const std::function<bool(int, int, int)>& contains);
  unsigned level() const { return level_; }
  /// The number of its voxels in [low, high) (clipped to the root).
  std::int64_t count(Voxel low, Voxel high) const;
  /// Whether the closed cell meets the solid's boundary (walls of the root excluded).
  bool boundary_meets(const OctreeCell& cell) const;

 private:
  unsigned level_;
  std::vector<std::int64_t> sum_;  // the number of voxels below (x, y, z)
};

/// Cells that the solid's boundary meets: the root is split until wanted_level(cell) <= the cell's level.
Cells cover(const VoxelSolid& solid,
            const std::function<unsigned(const OctreeCell&)>& wanted_level);

/// Solids whose features are 5 or more voxels of level 5 wide: their covers at level 5 and finer are collars.
VoxelSolid ball(unsigned level);
VoxelSolid solid_torus(unsigned level);
VoxelSolid double_torus(unsigned level);

/// All cells of `level` in low <= (i, j, k) < high.
Cells block(unsigned level, Voxel low, Voxel high);
Cells without(const Cells& cells, const Cells& removed);
/// Replaces each cell for which `chosen` holds by its 8 children.
Cells refine(const Cells& cells, const std::function<bool(const OctreeCell&)>& chosen);
/// Replaces 8 children by their parent wherever all of them exist, once.
Cells coarsen(const Cells& cells);
/// The cells moved two octants deeper: the root becomes the cell (1, i, j, k).
Cells into_octant(const Cells& cells, std::uint32_t i, std::uint32_t j, std::uint32_t k);
/// One of the 48 symmetries of the root: axes permuted, then mirrored by the bits of `mirror`.
Cells transformed(const Cells& cells, std::array<unsigned, 3> axes, unsigned mirror);

/// Arbitrary disjoint cells: a node is a cell, empty or split, with the given chances in 1/16.
Cells random_cells(Random& random, unsigned max_level, unsigned cell_chance, unsigned empty_chance);

/// A closed lattice path of unit voxels with the given corners.
std::vector<Voxel> closed_path(const std::vector<Voxel>& corners);
/// A slab with a hole through it, minus a closed tube around the hole whose core has a local trefoil (knotted) or is
/// unknotted: the example of THEORY 2 that homology cannot distinguish from a product. Level 6.
Cells tube_in_torus(bool knotted);

}  // namespace veritope::octree_shapes
