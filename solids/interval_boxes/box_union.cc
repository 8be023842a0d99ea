// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/interval_boxes/box_union.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "topology/collapse.h"

namespace veritope {

Result<BoxGrid> BoxGrid::make(std::span<const Box3d> boxes) {
  if (boxes.empty()) return Error{Code::kEmpty, {}, "a set without a box"};
  BoxGrid out;
  for (std::size_t n = 0; n < boxes.size(); ++n)
    for (std::size_t k = 0; k < 3; ++k) {
      const double lo = boxes[n].lo[k], hi = boxes[n].hi[k];
      if (!std::isfinite(lo) || !std::isfinite(hi) || !(lo < hi))
        return Error{
            Code::kBadArgument,
            {},
            "box " + std::to_string(n) + ": a side is not finite or has no positive length"};
      out.at_[k].push_back(lo);
      out.at_[k].push_back(hi);
    }
  std::uint64_t cells = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    auto& at = out.at_[k];
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    out.size_[k] = static_cast<std::uint32_t>(at.size() + 1);
    cells *= out.size_[k];
    if (cells > kMaxCells)
      return Error{
          Code::kOverLimit,
          {},
          "the grid of the boxes' coordinates has over " + std::to_string(kMaxCells) + " cells"};
  }
  out.filled_.assign(cells, false);
  for (const Box3d& b : boxes) {
    std::array<std::uint32_t, 3> from, to;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& at = out.at_[k];
      const auto place = [&](double x) {
        return static_cast<std::uint32_t>(std::lower_bound(at.begin(), at.end(), x) - at.begin());
      };
      from[k] = place(b.lo[k]) + 1, to[k] = place(b.hi[k]) + 1;
    }
    for (std::uint32_t z = from[2]; z < to[2]; ++z)
      for (std::uint32_t y = from[1]; y < to[1]; ++y)
        for (std::uint32_t x = from[0]; x < to[0]; ++x) out.filled_[out.index(x, y, z)] = true;
  }
  return out;
}

Point3d BoxGrid::approx_middle(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  const std::array<std::uint32_t, 3> cell{i, j, k};
  Point3d out;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto& at = at_[a];
    const double width = at.back() - at.front();
    if (cell[a] == 0)
      out[a] = at.front() - width;
    else if (cell[a] == at.size())
      out[a] = at.back() + width;
    else
      out[a] = 0.5 * at[cell[a] - 1] + 0.5 * at[cell[a]];
  }
  return out;
}

std::optional<BoxGrid> BoxGrid::filled_where(
    const std::function<std::optional<bool>(const Point3d&)>& is_inside, int dimension) const {
  const auto axes = static_cast<std::size_t>(dimension);
  const std::uint32_t first_layer = dimension == 2 ? 1 : 0;  // the margin would join all
  BoxGrid out = *this;
  std::vector<bool> seen = filled_;
  std::vector<std::array<std::uint32_t, 3>> component;
  const std::uint32_t last_layer = dimension == 2 ? 2 : size_[2];
  for (std::uint32_t z = first_layer; z < last_layer; ++z)
    for (std::uint32_t y = 0; y < size_[1]; ++y)
      for (std::uint32_t x = 0; x < size_[0]; ++x) {
        if (seen[index(x, y, z)]) continue;
        component.assign(1, {x, y, z});
        seen[index(x, y, z)] = true;
        for (std::size_t n = 0; n < component.size(); ++n)
          for (std::size_t a = 0; a < axes; ++a)
            for (const bool up : {false, true}) {
              auto c = component[n];
              if (up ? c[a] + 1 == size_[a] : c[a] == 0) continue;
              up ? ++c[a] : --c[a];
              const std::size_t at = index(c[0], c[1], c[2]);
              if (seen[at]) continue;
              seen[at] = true;
              component.push_back(c);
            }
        // The first cell of all is in the margin, and the margin is connected.
        if (x == 0 && y == 0 && z == first_layer) continue;
        const auto inside = is_inside(approx_middle(x, y, z));
        if (!inside) return std::nullopt;
        if (!*inside) continue;
        for (const auto& c : component) out.filled_[index(c[0], c[1], c[2])] = true;
      }
  return out;
}

Result<CommonSubdivision> BoxGrid::subdivision() const {
  const std::uint32_t most = std::max({size_[0], size_[1], size_[2]});
  const auto level = static_cast<std::uint32_t>(std::bit_width(most - 1));
  if (level > OctreeKey::kMaxLevel)
    return Error{Code::kOverLimit, {}, "the grid of the boxes' coordinates is too fine"};
  std::vector<OctreeCell> cells;
  for (std::uint32_t z = 0; z < size_[2]; ++z)
    for (std::uint32_t y = 0; y < size_[1]; ++y)
      for (std::uint32_t x = 0; x < size_[0]; ++x)
        if (is_filled(x, y, z)) cells.push_back({level, x, y, z});
  auto keys = OctreeKeySet::make(cells);
  if (!keys) return keys.error();
  return CommonSubdivision::build(std::move(*keys));
}

Result<UnionTopology> topology_of(const BoxGrid& grid) {
  const auto complex = grid.subdivision();
  if (!complex) return complex.error();
  const ComplexBoundary boundary = analyse_boundary(*complex);
  UnionTopology out;
  out.is_manifold = boundary.is_manifold();
  out.bodies = boundary.bodies.size();
  if (!boundary.bad_edges.empty())
    out.defect = "in the grid of coordinates: " + name_of(*complex, 1, boundary.bad_edges[0].edge);
  else if (!boundary.bad_vertices.empty())
    out.defect =
        "in the grid of coordinates: " + name_of(*complex, 0, boundary.bad_vertices[0].vertex);
  if (out.is_manifold)
    for (const BoundaryComponent& c : boundary.components) out.boundary_euler.push_back(c.euler());
  return out;
}

Result<UnionTopology> union_topology(std::span<const Box3d> boxes, int dimension) {
  std::vector<Box3d> solid(boxes.begin(), boxes.end());
  if (dimension == 2)
    for (Box3d& b : solid) b.lo[2] = 0, b.hi[2] = 1;
  const auto grid = BoxGrid::make(solid);
  if (!grid) return grid.error();
  return topology_of(*grid);
}

}  // namespace veritope
