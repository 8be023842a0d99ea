// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "interval/numeric.h"
#include "robust/base/check.h"
#include "solids/micro/mesh/tile_mesh_internal.h"
#include "splines/binomial.h"

namespace veritope::internal {
namespace {

constexpr std::uint32_t kUnplaced = 0xffffffff;
constexpr std::uint8_t kNoWall = 6;

// The Bernstein polynomials of a degree at i / n.
std::vector<Interval> basis_at(int degree, std::uint32_t i, std::uint32_t n) {
  const Rational t = Rational(i) / Rational(n);
  const Interval x = enclose(t), y = enclose(Rational(1) - t);
  std::vector<Interval> out;
  for (int k = 0; k <= degree; ++k) {
    Interval b = enclose(Rational(binomial(degree, k)));
    for (int l = 0; l < degree; ++l) b *= l < k ? x : y;
    out.push_back(b);
  }
  return out;
}

std::vector<std::vector<Interval>> bases_of(int degree, std::uint32_t parts) {
  std::vector<std::vector<Interval>> out;
  for (std::uint32_t i = 0; i <= parts; ++i) out.push_back(basis_at(degree, i, parts));
  return out;
}

// A point that lies in the unit cube is known to do so.
Interval in_unit(const Interval& x) {
  return x.lo() >= 0 && x.hi() <= 1 ? x : intersection(x, Interval::from_bounds(0, 1));
}

// The ends of an edge of the mesh, the lesser first, and the triangle that uses it.
struct MeshEdge {
  std::uint32_t low, high;
  std::uint32_t patch;
  bool is_forward;  // the triangle passes it from low to high
  auto key() const { return std::pair(low, high); }
};

}  // namespace

std::size_t triangles_of(const TileQuad& quad, std::array<TileTriangle, 2>& out) {
  const auto [a, b, c, d] = quad;
  if (a == b) return out[0] = {a, c, d}, 1;
  if (b == c) return out[0] = {a, b, d}, 1;
  if (c == d || d == a) return out[0] = {a, b, c}, 1;
  out = {{{a, b, c}, {a, c, d}}};
  return 2;
}

TileMesh::TileMesh(const AnalysedTile& tile, std::vector<PatchParts> parts)
    : tile_(tile), parts_(std::move(parts)) {
  number_vertices();
  place_vertices();
  fill_table();
  add_facets();
}

void TileMesh::number_vertices() {
  const TileSurface& surface = tile_.surface;
  const std::size_t patches = surface.num_patches();
  constexpr std::uint32_t kOffCaps = AnalysedTile::kNoCap;
  const auto inside = [&](std::uint32_t cap) {
    return cap == kOffCaps ? std::size_t{0} : inside_of_cap(cap);
  };
  // Corners: on a rim if a side of the rim ends there.
  std::vector<std::size_t> corner_group(surface.num_vertices, 0), side_group(4 * patches, 0);
  std::vector<bool> is_on_rim(surface.num_vertices, false);
  for (std::uint32_t p = 0; p < patches; ++p)
    for (std::size_t c = 0; c < kTileSides; ++c)
      corner_group[surface.vertex(p, c)] =
          std::max(corner_group[surface.vertex(p, c)], inside(tile_.cap_of_patch[p]));
  for (std::uint32_t side = 0; side < surface.mates.size(); ++side) {
    const std::uint32_t mate = surface.mates[side];
    if (mate == TileSurface::kCollapsed) continue;
    const std::uint32_t cap = tile_.cap_of_patch[side / kTileSides],
                        other = tile_.cap_of_patch[mate / kTileSides];
    if (cap == other) {
      side_group[side] = inside(cap);
      continue;
    }
    VT_CHECK(cap == kOffCaps || other == kOffCaps, "two caps have no common side");
    side_group[side] = rim_of_cap(cap == kOffCaps ? other : cap);
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      const std::uint32_t v = surface.vertex(side / kTileSides, side % kTileSides + end);
      corner_group[v] = side_group[side];
      is_on_rim[v] = true;
    }
  }
  std::vector<std::uint32_t> size(2 * tile_.caps.size() + 1, 0);
  const auto for_each_part =
      [&](auto visit) {  // visit(group, the number of vertices, where their first one is kept)
        for (std::size_t v = 0; v < surface.num_vertices; ++v)
          visit(corner_group[v], 1u, corner_[v]);
        for (std::uint32_t side = 0; side < surface.mates.size(); ++side)
          if (surface.mates[side] != TileSurface::kCollapsed && side < surface.mates[side])
            visit(side_group[side], parts_[side / kTileSides][side % 2] - 1, side_[side]);
        for (std::uint32_t p = 0; p < patches; ++p)
          visit(inside(tile_.cap_of_patch[p]), (parts_[p][0] - 1) * (parts_[p][1] - 1), inner_[p]);
      };
  corner_.resize(surface.num_vertices);
  side_.resize(surface.mates.size());
  inner_.resize(patches);
  for_each_part(
      [&](std::size_t group, std::uint32_t count, std::uint32_t&) { size[group] += count; });
  group_begin_.assign(1, 0);
  for (const std::uint32_t n : size) group_begin_.push_back(group_begin_.back() + n);
  std::vector<std::uint32_t> next(group_begin_.begin(), group_begin_.end() - 1);
  for_each_part([&](std::size_t group, std::uint32_t count, std::uint32_t& first) {
    first = next[group];
    next[group] += count;
  });
}

std::uint32_t TileMesh::vertex_of_side(std::uint32_t side, std::uint32_t i) const {
  const TileSurface& surface = tile_.surface;
  const std::uint32_t patch = side / kTileSides, s = side % kTileSides, mate = surface.mates[side],
                      n = parts_[patch][s % 2];
  if (i == 0 || mate == TileSurface::kCollapsed) return corner_[surface.vertex(patch, s)];
  if (i == n) return corner_[surface.vertex(patch, s + 1)];
  return side < mate ? side_[side] + i - 1 : side_[mate] + n - i - 1;
}

std::uint32_t TileMesh::vertex_at(std::uint32_t patch, std::uint32_t i, std::uint32_t j) const {
  const auto [m, n] = parts_[patch];
  if (j == 0) return vertex_of_side(4 * patch, i);
  if (i == m) return vertex_of_side(4 * patch + 1, j);
  if (j == n) return vertex_of_side(4 * patch + 2, m - i);
  if (i == 0) return vertex_of_side(4 * patch + 3, n - j);
  return inner_[patch] + (i - 1) * (n - 1) + j - 1;
}

void TileMesh::place_vertices() {
  struct Source {
    std::uint32_t patch = kUnplaced, i = 0, j = 0;
  };
  std::vector<Source> source(num_vertices());
  for (std::uint32_t p = 0; p < parts_.size(); ++p)
    for (std::uint32_t i = 0; i <= parts_[p][0]; ++i)
      for (std::uint32_t j = 0; j <= parts_[p][1]; ++j)
        if (Source& s = source[vertex_at(p, i, j)]; s.patch == kUnplaced) s = {p, i, j};
  first_point_.assign(1, 0);
  for (const Source& s : source) {
    const TilePatch& patch = tile_.tile.patches[s.patch];
    wall_.push_back(patch.wall.has_value() ? static_cast<std::uint8_t>(*patch.wall) : kNoWall);
    first_point_.push_back(first_point_.back() + static_cast<std::uint32_t>(patch.points.size()));
  }
  points_.resize(first_point_.back());
  std::vector<std::vector<std::uint32_t>> of_patch(parts_.size());
  for (std::uint32_t v = 0; v < num_vertices(); ++v) of_patch[source[v].patch].push_back(v);
  for (std::uint32_t p = 0; p < parts_.size(); ++p) {
    const TilePatch& patch = tile_.tile.patches[p];
    const auto u = bases_of(patch.degrees[0], parts_[p][0]),
               w = bases_of(patch.degrees[1], parts_[p][1]);
    std::vector<std::vector<Box3>> nets;
    for (const auto& list : patch.points) {
      auto& net = nets.emplace_back();
      for (const TilePoint& q : list) net.emplace_back(enclose(q[0]), enclose(q[1]), enclose(q[2]));
    }
    for (const std::uint32_t v : of_patch[p])
      for (std::size_t power = 0; power < nets.size(); ++power) {
        Box3 sum;
        std::size_t at = 0;
        for (const Interval& a : u[source[v].i])
          for (const Interval& b : w[source[v].j]) sum = sum + a * b * nets[power][at++];
        points_[first_point_[v] + power] = sum;
      }
  }
}

Box3 TileMesh::position(std::uint32_t vertex, const WallNumbers& numbers) const {
  const std::uint32_t begin = first_point_[vertex], end = first_point_[vertex + 1];
  Box3 out = points_[end - 1];
  if (end - begin > 1) {
    const Interval t(numbers[wall_[vertex]] * 0x1p-20);
    for (std::uint32_t k = end - 1; k-- > begin;) out = t * out + points_[k];
  }
  for (std::size_t c = 0; c < 3; ++c) out[c] = in_unit(out[c]);
  return out;
}

// The middles of the points' boxes. Bound: docs/bounds/micro_mesh.md, section 3.
void TileMesh::fill_table() {
  constexpr double kUnit = 0x1p-53;
  std::size_t powers = 1;
  for (std::size_t v = 0; v < num_vertices(); ++v)
    powers = std::max<std::size_t>(powers, first_point_[v + 1] - first_point_[v]);
  table_.wall.assign(num_vertices() + kSpareLanes, PointTable::kNoWall);
  table_.of_power.resize(powers);
  for (PointColumns& list : table_.of_power) list.resize(num_vertices());
  std::copy(wall_.begin(), wall_.end(), table_.wall.begin());
  for (std::size_t v = 0; v < num_vertices(); ++v)
    for (std::size_t c = 0; c < 3; ++c) {
      Interval error;
      for (std::uint32_t k = 0; k < first_point_[v + 1] - first_point_[v]; ++k) {
        const MidRad x = mid_rad(points_[first_point_[v] + k][c]);
        table_.of_power[k].at[c][v] = x.mid;
        error += Interval(x.rad) + Interval(2 * static_cast<double>(powers) * kUnit) *
                                       Interval::from_bounds(0, std::abs(x.mid));
      }
      table_.error = std::max(table_.error, error.hi());
    }
}

void TileMesh::add_facets() {
  const auto end = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
  for (std::uint32_t p = 0; p < parts_.size(); ++p) {
    first_triangle_.push_back(end(triangles_));
    first_quad_.push_back(end(quads_));
    const auto [m, n] = parts_[p];
    for (std::uint32_t i = 0; i < m; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        const TileQuad quad = {vertex_at(p, i, j), vertex_at(p, i + 1, j),
                               vertex_at(p, i + 1, j + 1), vertex_at(p, i, j + 1)};
        std::array<TileTriangle, 2> halves;
        const std::size_t count = triangles_of(quad, halves);
        triangles_.insert(triangles_.end(), halves.begin(),
                          halves.begin() + static_cast<std::ptrdiff_t>(count));
        if (count == 2) quads_.push_back(quad);
      }
  }
  first_triangle_.push_back(end(triangles_));
  first_quad_.push_back(end(quads_));
}

std::size_t TileMesh::group_of_vertex(std::uint32_t vertex) const {
  return static_cast<std::size_t>(
             std::upper_bound(group_begin_.begin(), group_begin_.end() - 1, vertex) -
             group_begin_.begin()) -
         1;
}

std::uint32_t TileMesh::patch_with_too_few_parts(int strictness) const {
  std::vector<MeshEdge> edges;
  std::vector<std::pair<TileTriangle, std::uint32_t>> faces;
  for (std::uint32_t p = 0; p < parts_.size(); ++p)
    for (std::uint32_t k = first_triangle_[p]; k < first_triangle_[p + 1]; ++k) {
      TileTriangle t = triangles_[k];
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return p;
      for (std::size_t e = 0; e < 3; ++e) {
        const std::uint32_t a = t[e], b = t[(e + 1) % 3];
        edges.push_back({std::min(a, b), std::max(a, b), p, a < b});
      }
      std::sort(t.begin(), t.end());
      faces.emplace_back(t, p);
    }
  std::sort(faces.begin(), faces.end());
  for (std::size_t f = 1; f < faces.size(); ++f)
    if (faces[f - 1].first == faces[f].first) return faces[f].second;
  std::sort(edges.begin(), edges.end(), [](const MeshEdge& a, const MeshEdge& b) {
    return std::tuple(a.key(), a.patch, a.is_forward) < std::tuple(b.key(), b.patch, b.is_forward);
  });
  const auto rim = [&](std::uint32_t v) -> std::size_t {
    const std::size_t group = group_of_vertex(v);
    return group % 2 == 1 ? group : 0;
  };
  // Rims to which a vertex has an edge, for the strictest question.
  std::vector<std::size_t> rim_beside(strictness == 2 ? num_vertices() : 0, 0);
  for (std::size_t e = 0; e < edges.size(); e += 2) {
    const MeshEdge& edge = edges[e];
    if (e + 1 == edges.size()) return edge.patch;
    const MeshEdge& other = edges[e + 1];
    if (edge.key() != other.key() || edge.is_forward == other.is_forward) return edge.patch;
    if (e + 2 < edges.size() && edges[e + 2].key() == edge.key()) return edges[e + 2].patch;
    const std::size_t a = rim(edge.low), b = rim(edge.high);
    if (a != 0 && a == b) {  // a part of the rim, or inside of the cap, or a chord outside
      const std::uint32_t cap = static_cast<std::uint32_t>((a - 1) / 2);
      if (tile_.cap_of_patch[edge.patch] != cap && tile_.cap_of_patch[other.patch] != cap)
        return edge.patch;
    }
    if (strictness >= 1 && a != 0 && b != 0 && a != b) return edge.patch;
    if (strictness < 2) continue;
    for (const auto& [vertex, beside] : {std::pair(edge.low, b), std::pair(edge.high, a)}) {
      if (beside == 0) continue;
      if (rim_beside[vertex] != 0 && rim_beside[vertex] != beside) return edge.patch;
      rim_beside[vertex] = beside;
    }
  }
  return kNoPatch;
}

}  // namespace veritope::internal
