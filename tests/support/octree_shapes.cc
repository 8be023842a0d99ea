// SPDX-License-Identifier: LGPL-3.0-or-later
#include "tests/support/octree_shapes.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace veritope::octree_shapes {
namespace {

auto tied(const OctreeCell& c) { return std::tie(c.level, c.i, c.j, c.k); }
struct Less {
  bool operator()(const OctreeCell& a, const OctreeCell& b) const { return tied(a) < tied(b); }
};

OctreeCell child(const OctreeCell& c, unsigned octant) {
  return {c.level + 1, 2 * c.i + (octant & 1), 2 * c.j + (octant >> 1 & 1),
          2 * c.k + (octant >> 2 & 1)};
}

}  // namespace

std::string text(const Cells& cells) {
  std::string out;
  for (const OctreeCell& c : cells)
    out += "{" + std::to_string(c.level) + "," + std::to_string(c.i) + "," + std::to_string(c.j) +
           "," + std::to_string(c.k) + "}, ";
  return out;
}

VoxelSolid::VoxelSolid(unsigned level, const std::function<bool(int, int, int)>& contains)
    : level_(level) {
  const int n = 1 << level, m = n + 1;
  sum_.assign(static_cast<std::size_t>(m) * m * m, 0);
  const auto at = [&](int x, int y, int z) -> std::int64_t& {
    return sum_[static_cast<std::size_t>((z * m + y) * m + x)];
  };
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y) {
      std::int64_t row = 0;
      for (int x = 0; x < n; ++x) {
        row += contains(x, y, z);
        at(x + 1, y + 1, z + 1) = row + at(x + 1, y, z + 1) + at(x + 1, y + 1, z) - at(x + 1, y, z);
      }
    }
}

std::int64_t VoxelSolid::count(Voxel low, Voxel high) const {
  const int n = 1 << level_, m = n + 1;
  for (unsigned a = 0; a < 3; ++a) {
    low[a] = std::clamp(low[a], 0, n);
    high[a] = std::clamp(high[a], 0, n);
  }
  std::int64_t out = 0;
  for (int q = 0; q < 8; ++q) {
    const int x = q & 1 ? low[0] : high[0], y = q & 2 ? low[1] : high[1],
              z = q & 4 ? low[2] : high[2];
    const int flips = (q & 1) + (q >> 1 & 1) + (q >> 2);
    out += (flips % 2 == 0 ? 1 : -1) * sum_[static_cast<std::size_t>((z * m + y) * m + x)];
  }
  return out;
}

bool VoxelSolid::boundary_meets(const OctreeCell& cell) const {
  const int size = 1 << (level_ - cell.level), n = 1 << level_;
  Voxel low{static_cast<int>(cell.i) * size - 1, static_cast<int>(cell.j) * size - 1,
            static_cast<int>(cell.k) * size - 1},
      high;
  std::int64_t volume = 1;
  for (unsigned a = 0; a < 3; ++a) {
    high[a] = std::min(low[a] + size + 2, n);
    low[a] = std::max(low[a], 0);
    volume *= high[a] - low[a];
  }
  const std::int64_t in = count(low, high);
  return 0 < in && in < volume;
}

Cells cover(const VoxelSolid& solid,
            const std::function<unsigned(const OctreeCell&)>& wanted_level) {
  Cells out, open{{}};
  while (!open.empty()) {
    const OctreeCell cell = open.back();
    open.pop_back();
    if (!solid.boundary_meets(cell)) continue;
    if (cell.level >= wanted_level(cell) || cell.level == solid.level()) {
      out.push_back(cell);
    } else {
      for (unsigned q = 0; q < 8; ++q) open.push_back(child(cell, q));
    }
  }
  return out;
}

namespace {

// Calls inside(x, y, z, u) for each voxel, whose centre is (x, y, z) / u in a root [-16, 16]^3.
template <typename Inside>
VoxelSolid solid_of(unsigned level, Inside inside) {
  const std::int64_t n = 1 << level;
  return VoxelSolid(level, [&](int x, int y, int z) {
    return inside(16 * (2 * x + 1 - n), 16 * (2 * y + 1 - n), 16 * (2 * z + 1 - n), n);
  });
}

}  // namespace

VoxelSolid ball(unsigned level) {
  return solid_of(level, [](std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t u) {
    return x * x + y * y + z * z < 100 * u * u;
  });
}

VoxelSolid solid_torus(
    unsigned level) {  // R = 8, r^2 = 18: (x^2 + y^2 + z^2 + R^2 - r^2)^2 < 4 R^2 (x^2 + y^2)
  return solid_of(level, [](std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t u) {
    const std::int64_t s = x * x + y * y + z * z + (64 - 18) * u * u;
    return s * s < 4 * 64 * u * u * (x * x + y * y);
  });
}

VoxelSolid double_torus(unsigned level) {  // a plate with two square holes
  const int s = 1 << (level - 5);
  return VoxelSolid(level, [s](int x, int y, int z) {
    x /= s, y /= s, z /= s;
    const bool plate = 2 <= x && x < 30 && 8 <= y && y < 24 && 12 <= z && z < 20;
    const bool hole = 13 <= y && y < 19 && ((7 <= x && x < 12) || (20 <= x && x < 25));
    return plate && !hole;
  });
}

Cells block(unsigned level, Voxel low, Voxel high) {
  Cells out;
  for (int z = low[2]; z < high[2]; ++z)
    for (int y = low[1]; y < high[1]; ++y)
      for (int x = low[0]; x < high[0]; ++x)
        out.push_back({level, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                       static_cast<std::uint32_t>(z)});
  return out;
}

Cells without(const Cells& cells, const Cells& removed) {
  const std::set<OctreeCell, Less> gone(removed.begin(), removed.end());
  Cells out;
  for (const OctreeCell& c : cells)
    if (!gone.contains(c)) out.push_back(c);
  return out;
}

Cells refine(const Cells& cells, const std::function<bool(const OctreeCell&)>& chosen) {
  Cells out;
  for (const OctreeCell& c : cells) {
    if (!chosen(c)) {
      out.push_back(c);
      continue;
    }
    for (unsigned q = 0; q < 8; ++q) out.push_back(child(c, q));
  }
  return out;
}

Cells coarsen(const Cells& cells) {
  std::map<OctreeCell, Cells, Less> families;
  Cells out;
  for (const OctreeCell& c : cells) {
    if (c.level == 0)
      out.push_back(c);
    else
      families[{c.level - 1, c.i / 2, c.j / 2, c.k / 2}].push_back(c);
  }
  for (const auto& [parent, children] : families) {
    if (children.size() == 8)
      out.push_back(parent);
    else
      out.insert(out.end(), children.begin(), children.end());
  }
  return out;
}

Cells into_octant(const Cells& cells, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  Cells out;
  for (const OctreeCell& c : cells) {
    const std::uint32_t n = 1u << c.level;
    out.push_back({c.level + 1, c.i + i * n, c.j + j * n, c.k + k * n});
  }
  return out;
}

Cells transformed(const Cells& cells, std::array<unsigned, 3> axes, unsigned mirror) {
  Cells out;
  for (const OctreeCell& c : cells) {
    const std::uint32_t from[] = {c.i, c.j, c.k}, top = (1u << c.level) - 1;
    std::uint32_t to[3];
    for (unsigned a = 0; a < 3; ++a) to[a] = mirror >> a & 1 ? top - from[axes[a]] : from[axes[a]];
    out.push_back({c.level, to[0], to[1], to[2]});
  }
  return out;
}

Cells random_cells(Random& random, unsigned max_level, unsigned cell_chance,
                   unsigned empty_chance) {
  Cells out, open{{}};
  while (!open.empty()) {
    const OctreeCell cell = open.back();
    open.pop_back();
    const std::uint64_t dice = random.below(16);
    if (cell.level > 0 && dice < empty_chance) continue;
    if (cell.level == max_level || (cell.level > 0 && dice < empty_chance + cell_chance)) {
      if (cell.level < max_level || random.below(2) == 0) out.push_back(cell);
      continue;
    }
    for (unsigned q = 0; q < 8; ++q) open.push_back(child(cell, q));
  }
  return out;
}

std::vector<Voxel> closed_path(const std::vector<Voxel>& corners) {
  std::vector<Voxel> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Voxel at = corners[i];
    const Voxel& end = corners[(i + 1) % corners.size()];
    for (unsigned a = 0; a < 3; ++a)
      while (at[a] != end[a]) {
        out.push_back(at);
        at[a] += at[a] < end[a] ? 1 : -1;
      }
  }
  return out;
}

Cells tube_in_torus(bool knotted) {
  // The strands y = 24 (from x = 30 to 12) and x = 21 (from y = 0 to 18, 18 to 44) cross; it matters which one is
  // above.
  const int a = knotted ? 2 : -2, b = -a;
  std::vector<Voxel> core{{0, 12, 0}, {0, 12, 2}, {16, 12, 2}, {16, 12, -2}, {30, 12, -2}};
  for (const Voxel& p : {Voxel{30, 12, a}, Voxel{30, 24, a}, Voxel{12, 24, a}}) core.push_back(p);
  for (const Voxel& p :
       {Voxel{12, 24, -2}, Voxel{12, 0, -2}, Voxel{12, 0, 2}, Voxel{21, 0, 2}, Voxel{21, 18, 2}})
    core.push_back(p);
  for (const Voxel& p : {Voxel{21, 18, b}, Voxel{21, 44, b}, Voxel{21, 44, -2}, Voxel{-20, 44, -2},
                         Voxel{-20, 12, -2}, Voxel{-20, 12, 0}})
    core.push_back(p);
  std::set<Voxel> tube;
  for (const Voxel& p : closed_path(core)) tube.insert(p);
  Cells out;
  for (int z = -8; z < 8; ++z)
    for (int y = -6; y < 52; ++y)
      for (int x = -28; x < 36; ++x) {
        if (-14 <= x && x < -6 && 18 <= y && y < 38) continue;
        if (tube.contains({x, y, z})) continue;
        out.push_back({6, static_cast<std::uint32_t>(x + 28), static_cast<std::uint32_t>(y + 6),
                       static_cast<std::uint32_t>(z + 8)});
      }
  return out;
}

}  // namespace veritope::octree_shapes
