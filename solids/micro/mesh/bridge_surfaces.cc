// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "interval/upward.h"
#include "robust/base/check.h"
#include "robust/base/parallel.h"
#include "solids/micro/bridge_front.h"
#include "solids/micro/mesh/bridge_surfaces_internal.h"
#include "solids/micro/mesh/quad_gap_internal.h"

namespace veritope::internal {
namespace {

constexpr std::size_t kBridgesInChunk = 4;
// The errors along the axis and across it may each be this part of the chord; the rest is for gaps.
constexpr double kBridgeShare = 0.125;
// Along the axis the error is at most this part of the size, too, so that short bridges keep their bend.
constexpr double kSizeShare = 1.0 / 16;

Error too_many_parts(const char* what) {
  return {Code::kOverLimit,
          {},
          std::string("a mesh with this chord has more than 2^20 parts along ") + what};
}

// How far a bridge may be from its facets: at most half of its size, so that short ones do not cross themselves.
double own_chord(double size, double chord) {
  return size > 0 ? std::min(chord, 0.5 * size) : chord;
}

// The vertex of the tile's mesh at the point (i, j) of the bridge's rim.
std::uint32_t rim_vertex(const TileMesh& mesh, std::uint32_t patch, unsigned symmetry,
                         std::uint32_t i, std::uint32_t j) {
  const auto [m, n] = mesh.parts()[patch];
  if ((symmetry & 1) != 0) std::swap(i, j);
  const std::uint32_t x = (symmetry & 2) != 0 ? m - i : i, y = (symmetry & 4) != 0 ? n - j : j;
  const std::uint32_t side = 4 * patch;
  if (y == 0) return mesh.vertex_of_side(side, x);
  if (x == m) return mesh.vertex_of_side(side + 1, y);
  if (y == n) return mesh.vertex_of_side(side + 2, m - x);
  return mesh.vertex_of_side(side + 3, n - y);
}

// The points (i, j) around a square of m x n parts, counterclockwise from (0, 0).
std::vector<std::array<std::uint32_t, 2>> rim_of_square(std::uint32_t m, std::uint32_t n) {
  std::vector<std::array<std::uint32_t, 2>> out;
  for (std::uint32_t i = 0; i < m; ++i) out.push_back({i, 0});
  for (std::uint32_t j = 0; j < n; ++j) out.push_back({m, j});
  for (std::uint32_t i = m; i > 0; --i) out.push_back({i, n});
  for (std::uint32_t j = n; j > 0; --j) out.push_back({0, j});
  return out;
}

}  // namespace

struct BridgeSurfaces::FacetWriter {
  const std::vector<Vec3d>& positions;
  Placed& bridge;
  std::array<std::uint32_t, 3>* to;
  bool is_left_handed;

  void add(const TileQuad& quad) {
    std::array<std::array<std::uint32_t, 3>, 2> triangles;
    const std::size_t count = triangles_of(quad, triangles);
    for (std::size_t k = 0; k < count; ++k) {
      auto [x, y, z] = triangles[k];
      if (is_left_handed) std::swap(y, z);
      *to++ = {x, y, z};
    }
    if (count == 2)
      bridge.gap =
          std::max(bridge.gap, quad_gap(positions[quad[0]], positions[quad[1]], positions[quad[2]],
                                        positions[quad[3]], bridge.gap));
  }
};

BridgeSurfaces::BridgeSurfaces(const Microstructure& micro, const VModel& cage,
                               const std::vector<AnalysedTile>& tiles, unsigned jobs,
                               CapLinks& links)
    : micro_(micro), cage_(cage), tiles_(tiles), jobs_(jobs), links_(links) {
  for (std::uint32_t b = 0; b < micro.bridges.size() && !error_; ++b) {
    const CapPlace& place = micro.bridges[b].cap;
    const auto front = front_of(micro, cage, place);
    const auto cap = front && front->volume == micro.bridges[b].volume
                         ? cap_on_front(micro, cage, tiles, place, *front)
                         : std::nullopt;
    add(b, place, cap ? start_symmetry(micro.bridges[b], *cap) : std::nullopt, links);
  }
  for (std::uint32_t s = 0; s < micro.sweeps.size() && !error_; ++s) {
    const CapPlace& place = micro.sweeps[s].cap;
    const auto cap = cap_on_front(micro, cage, tiles, place, own_front(place));
    add(s, place, cap ? std::optional(0u) : std::nullopt, links);
  }
}

// `symmetry`: nothing if the wall does not hold one cap of one patch.
void BridgeSurfaces::add(std::uint32_t number, const CapPlace& place,
                         std::optional<unsigned> symmetry, CapLinks& links) {
  Placed& out = bridges_.emplace_back();
  out.number = number;
  out.cell = links.numbers[place.grid][place.cell];
  LinkedCell& cell = links.cells[out.cell];
  const AnalysedTile& tile = tiles_[links.kinds[cell.kind].tile];
  const auto& caps = tile.caps_of_wall[static_cast<std::size_t>(place.wall)];
  if (!symmetry || (cell.dropped >> caps[0] & 1) != 0) {
    error_ = bad_argument((micro_.sweeps.empty() ? "bridge " : "sweep ") + std::to_string(number) +
                          " does not start at a free cap");
    return;
  }
  out.patch = tile.caps[caps[0]].patches[0];
  out.symmetry = *symmetry;
  cell.dropped |= std::uint64_t{1} << caps[0];
}

// The wall in the cell's own volume.
BridgeFront BridgeSurfaces::own_front(const CapPlace& place) const {
  const MicroGrid& grid = micro_.grids[place.grid];
  BridgeFront out;
  out.volume = grid.volume;
  out.axis = static_cast<std::size_t>(place.wall / 2);
  out.is_upward = place.wall % 2 == 1;
  const std::size_t index = grid.shape().index_of(place.cell)[out.axis];
  out.at = grid.breaks[out.axis][index + static_cast<std::size_t>(place.wall % 2)];
  return out;
}

std::uint32_t BridgeSurfaces::volume_of(const Placed& b) const {
  return micro_.sweeps.empty() ? micro_.bridges[b.number].volume
                               : micro_.grids[micro_.sweeps[b.number].cap.grid].volume;
}

BridgeMesh BridgeSurfaces::in_space(const Placed& b) const {
  const VVolume& volume = micro_.cage[volume_of(b)];
  if (micro_.sweeps.empty()) return BridgeMesh(volume, micro_.bridges[b.number]);
  const MicroSweep& sweep = micro_.sweeps[b.number];
  const MicroGrid& grid = micro_.grids[sweep.cap.grid];
  const auto at = grid.shape().index_of(sweep.cap.cell);
  MicroGrid cell;
  for (std::size_t a = 0; a < 3; ++a)
    cell.breaks[a] = {grid.breaks[a][at[a]], grid.breaks[a][at[a] + 1]};
  const auto cap = cap_on_front(micro_, cage_, tiles_, sweep.cap, own_front(sweep.cap));
  return BridgeMesh(volume, cell, cap.value(), sweep);
}

template <typename Visit>
void BridgeSurfaces::for_each(Visit visit) {
  parallel_for(bridges_.size(), kBridgesInChunk, jobs_,
               [&](std::size_t, std::size_t begin, std::size_t end) {
                 const ScopedUpward upward;
                 for (std::size_t i = begin; i < end; ++i)
                   visit(bridges_[i], in_space(bridges_[i]));
               });
}

std::optional<Error> BridgeSurfaces::find_errors() {
  if (error_) return error_;
  for_each([](Placed& b, const BridgeMesh& mesh) {
    b.error = mesh.error();
    b.size = mesh.approx_size();
  });
  for (const Placed& b : bridges_)
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!(b.error.bend[axis] + b.error.crease[axis] < std::numeric_limits<double>::infinity()))
        return Error{Code::kNotFinite, {}, "the cage has no finite derivatives"};
  return std::nullopt;
}

std::optional<Error> BridgeSurfaces::choose_parts(double chord, PartNumbers& numbers) {
  if (is_empty()) return std::nullopt;
  std::vector<PatchError> across(numbers.num_patches());
  const double share = chord * kBridgeShare;
  // Errors in units of a share. A crease / n is at most c if crease^2 / c / n^2 is.
  const auto error_along = [](const Placed& b, std::size_t axis, double c) {
    return (b.error.bend[axis] + b.error.crease[axis] * b.error.crease[axis] / c) / c;
  };
  for (Placed& b : bridges_) {
    PatchError& e = across[cap_number(numbers, b)];
    for (std::size_t axis = 0; axis < 2; ++axis)
      e.along[axis] =
          std::max(e.along[axis], share * error_along(b, b.is_swapped() ? 1 - axis : axis,
                                                      own_chord(b.size, chord) * kBridgeShare));
    const double along = b.size > 0 ? std::min(share, b.size * kSizeShare) : share;
    const double parts = std::ceil(std::sqrt(error_along(b, 2, along)));
    if (!(parts <= PartNumbers::kMost)) return too_many_parts("a bridge");
    b.parts = std::max(b.parts, static_cast<std::uint32_t>(parts));
  }
  if (!numbers.raise_for(across, 2 * share)) return too_many_parts("a side of a patch");
  return std::nullopt;
}

// The parts of the cap along the bridge's own axes.
std::array<std::uint32_t, 2> BridgeSurfaces::parts_across(const TileMesh& mesh,
                                                          const Placed& b) const {
  const PatchParts& parts = mesh.parts()[b.patch];
  return b.is_swapped() ? std::array{parts[1], parts[0]} : std::array{parts[0], parts[1]};
}

// A part of a side that is a point has one facet fewer.
std::uint64_t BridgeSurfaces::num_collapsed_rim_parts(const TileMesh& mesh, const Placed& b) const {
  const TileSurface& surface = tiles_[links_.kinds[links_.cells[b.cell].kind].tile].surface;
  std::uint64_t out = 0;
  for (std::size_t s = 0; s < kTileSides; ++s)
    if (surface.is_collapsed(b.patch, s)) out += mesh.parts()[b.patch][s % 2];
  return out;
}

bool BridgeSurfaces::make(const TileMeshes& meshes, std::uint64_t most,
                          const VerticesOfCell& vertices, TriangleMesh& mesh, Greatest& rounding) {
  std::uint64_t num_vertices = mesh.positions.size(), num_facets = mesh.faces.size();
  for (Placed& b : bridges_) {
    const auto [m, n] = parts_across(mesh_of(meshes, b), b);
    b.first_vertex = num_vertices;
    b.first_facet = num_facets;
    b.gap = 0;
    const std::uint64_t rim = 2 * (std::uint64_t{m} + n);
    num_vertices += rim * b.parts + std::uint64_t{m - 1} * (n - 1);
    num_facets += 2 * rim * b.parts - num_collapsed_rim_parts(mesh_of(meshes, b), b) +
                  2 * std::uint64_t{m} * n;
    if (num_facets > most || num_vertices >= 0xffffffff) return false;
  }
  mesh.positions.resize(num_vertices);
  mesh.faces.resize(num_facets);
  for_each([&](Placed& b, const BridgeMesh& bridge) {
    std::vector<std::uint32_t> ids;
    vertices(b.cell, ids);
    make_one(b, bridge, mesh_of(meshes, b), ids, mesh, rounding);
  });
  return true;
}

void BridgeSurfaces::make_one(Placed& b, const BridgeMesh& bridge, const TileMesh& tile,
                              const std::vector<std::uint32_t>& ids, TriangleMesh& mesh,
                              Greatest& rounding) const {
  const auto across = parts_across(tile, b);
  const std::uint32_t m = across[0], n = across[1];
  const auto rim = rim_of_square(m, n);
  const auto size = static_cast<std::uint32_t>(rim.size()),
             first = static_cast<std::uint32_t>(b.first_vertex);
  std::uint32_t next = first;
  const auto place = [&](std::uint32_t i, std::uint32_t j, std::uint32_t l) {
    mesh.positions[next++] =
        middle_of(bridge.value({Rational(i) / Rational(m), Rational(j) / Rational(n),
                                Rational(l) / Rational(b.parts)}),
                  rounding);
  };
  for (std::uint32_t l = 1; l <= b.parts; ++l)
    for (const auto& at : rim) place(at[0], at[1], l);
  const std::uint32_t first_inner = next;
  for (std::uint32_t i = 1; i < m; ++i)
    for (std::uint32_t j = 1; j < n; ++j) place(i, j, b.parts);
  FacetWriter facets{mesh.positions, b, mesh.faces.data() + b.first_facet,
                     cage_.hand(volume_of(b)) == Sign::kNegative};
  const auto on_ring = [&](std::uint32_t k, std::uint32_t l) {
    k %= size;
    return l == 0 ? ids[rim_vertex(tile, b.patch, b.symmetry, rim[k][0], rim[k][1])]
                  : first + (l - 1) * size + k;
  };
  for (std::uint32_t l = 0; l < b.parts; ++l)
    for (std::uint32_t k = 0; k < size; ++k)
      facets.add({on_ring(k, l), on_ring(k + 1, l), on_ring(k + 1, l + 1), on_ring(k, l + 1)});
  const auto on_end = [&](std::uint32_t i, std::uint32_t j) {
    if (j == 0) return on_ring(i, b.parts);
    if (i == m) return on_ring(m + j, b.parts);
    if (j == n) return on_ring(m + n + (m - i), b.parts);
    if (i == 0) return on_ring(2 * m + n + (n - j), b.parts);
    return first_inner + (i - 1) * (n - 1) + j - 1;
  };
  for (std::uint32_t i = 0; i < m; ++i)
    for (std::uint32_t j = 0; j < n; ++j)
      facets.add({on_end(i, j), on_end(i + 1, j), on_end(i + 1, j + 1), on_end(i, j + 1)});
}

// REQUIRES a live ScopedUpward.
double BridgeSurfaces::distance_of(const TileMesh& mesh, const Placed& b, double rounding) const {
  const auto across = parts_across(mesh, b);
  const std::array<std::uint32_t, 3> parts = {across[0], across[1], b.parts};
  std::array<double, 3> along{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Interval k(static_cast<double>(parts[axis]));
    along[axis] = (Interval(b.error.bend[axis]) / sqr(k) + Interval(b.error.crease[axis]) / k).hi();
  }
  std::sort(along.begin(), along.end());  // a face has two of the axes
  return (Interval(along[1]) + Interval(along[2]) + Interval(b.gap) + Interval(rounding)).hi();
}

bool BridgeSurfaces::are_close_enough(const TileMeshes& meshes, double chord, double rounding,
                                      PartNumbers& numbers) {
  const ScopedUpward upward;
  distance_ = 0;
  bool is_close = true;
  for (Placed& b : bridges_) {
    const double d = distance_of(mesh_of(meshes, b), b, rounding);
    distance_ = std::max(distance_, d);
    if (d <= std::max(own_chord(b.size, chord), std::min(chord, 64 * rounding))) continue;
    is_close = false;
    b.parts *= 2;
    numbers.raise(cap_number(numbers, b));
  }
  return is_close;
}

}  // namespace veritope::internal
