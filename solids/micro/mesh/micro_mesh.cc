// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/mesh/micro_mesh.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "interval/upward.h"
#include "robust/base/check.h"
#include "robust/base/parallel.h"
#include "solids/micro/mesh/bridge_surfaces_internal.h"
#include "solids/micro/mesh/cage_cells_internal.h"
#include "solids/micro/mesh/cap_links_internal.h"
#include "solids/micro/mesh/part_numbers_internal.h"
#include "solids/micro/mesh/patch_bend_internal.h"
#include "solids/micro/mesh/quad_gap_internal.h"
#include "solids/micro/mesh/tile_mesh_internal.h"
#include "solids/micro/mesh/vertex_rounding_internal.h"

namespace veritope {
namespace {

using internal::BridgeSurfaces;
using internal::CageCells;
using internal::CageRow;
using internal::CapLinks;
using internal::CellMap;
using internal::Greatest;
using internal::LinkedCell;
using internal::MapBounds;
using internal::middle_of;
using internal::PartNumbers;
using internal::PatchBend;
using internal::PatchError;
using internal::PatchParts;
using internal::RimLink;
using internal::SharedRim;
using internal::TileMesh;
using internal::TileQuad;

constexpr std::size_t kRowsInChunk = 4, kCellsInChunk = 256;
// The rounding of vertices is at most this part of the chord.
constexpr double kRoundingShare = 0x1p-6;

class MicroMesher {
 public:
  MicroMesher(const Microstructure& micro, const VModel& cage,
              const std::vector<AnalysedTile>& tiles, const MicroMeshOptions& options,
              CapLinks links)
      : micro_(micro),
        cage_(cage),
        tiles_(tiles),
        options_(options),
        links_(std::move(links)),
        bridges_(micro, cage, tiles, options.jobs, links_),
        numbers_(links_, tiles) {
    first_row_.push_back(0);
    const ScopedUpward upward;
    for (const MicroGrid& g : micro.grids) {
      const Grid<3> shape = g.shape();
      first_row_.push_back(first_row_.back() + shape.size[0] * shape.size[1]);
      cages_.emplace_back(micro.cage[g.volume], g);
    }
    for (const AnalysedTile& t : tiles)
      for (auto& bends = patch_bends_.emplace_back(); const TilePatch& p : t.tile.patches)
        bends.emplace_back(p);
    for (const internal::MeshKind& k : links_.kinds)
      cells_with_cap_.emplace_back(tiles[k.tile].caps.size() + 1, 0);
    for (const LinkedCell& c : links_.cells) {
      std::vector<std::uint64_t>& with = cells_with_cap_[c.kind];
      ++with.back();
      for (std::size_t cap = 0; cap + 1 < with.size(); ++cap) with[cap] += ~c.dropped >> cap & 1;
    }
    bends_ = std::vector<std::array<Greatest, 2>>(numbers_.num_patches());
    gaps_ = std::vector<Greatest>(numbers_.num_patches());
    errors_.resize(numbers_.num_patches());
  }

  Result<MicroMesh> run() {
    if (auto error = bridges_.find_errors()) return std::move(*error);
    find_bends();
    choose_sample();
    for (bool measures_all = false;;) {
      if (auto error = choose_parts()) return std::move(*error);
      reset_measures();
      if (!measures_all) {
        measure_sample();
        if (auto error = rounding_error()) return std::move(*error);
        if (!is_close_enough()) continue;
        measures_all = true;
        reset_measures();
      }
      if (auto error = place_cells()) return std::move(*error);
      make_vertices();
      if (auto error = rounding_error()) return std::move(*error);
      make_facets();
      if (auto error = make_bridges()) return std::move(*error);
      if (auto error = rounding_error()) return std::move(*error);
      if (is_close_enough() &&
          bridges_.are_close_enough(meshes_, options_.chord, rounding_->value(), numbers_))
        return result();
    }
  }

 private:
  const AnalysedTile& tile_of(std::uint32_t kind) const { return tiles_[links_.kinds[kind].tile]; }

  // Calls visit(number, cell, map, numbers) for each cell with a tile that is to be visited, in the rounding mode of
  // intervals.
  template <typename Choose, typename Visit>
  void for_each_map(Choose is_visited, Visit visit) const {
    parallel_for(first_row_.back(), kRowsInChunk, options_.jobs,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   const ScopedUpward upward;
                   for (std::size_t row = begin; row < end; ++row)
                     visit_row(row, is_visited, visit);
                 });
  }
  template <typename Choose, typename Visit>
  void visit_row(std::size_t row, const Choose& is_visited, const Visit& visit) const {
    const auto g = static_cast<std::size_t>(
        std::upper_bound(first_row_.begin(), first_row_.end(), row) - first_row_.begin() - 1);
    const MicroGrid& grid = micro_.grids[g];
    const Grid<3> shape = grid.shape();
    const std::size_t in_grid = row - first_row_[g], j = in_grid % shape.size[1],
                      i = in_grid / shape.size[1], length = shape.size[2];
    std::optional<CellMap> map;
    CageRow shared;
    for (std::size_t k = 0; k < length; ++k) {
      const std::uint32_t number = links_.numbers[g][in_grid * length + k];
      if (number == CapLinks::kNoCell || !is_visited(number)) continue;
      if (!map.has_value()) {
        cages_[g].enter_row(i, j, shared);
        map.emplace(cages_[g].new_map());
      }
      cages_[g].cell(shared, k, *map);
      visit(number, links_.cells[number], *map, grid.numbers_of({i, j, k}));
    }
  }
  bool is_dropped(const LinkedCell& cell, std::size_t patch) const {
    const std::uint32_t cap = tile_of(cell.kind).cap_of_patch[patch];
    return cap != AnalysedTile::kNoCap && (cell.dropped >> cap & 1) != 0;
  }

  // The greatest bound of the bends of a cell's patches; the bounds go to `bends`, 0 for patches that are dropped.
  double bends_of(const LinkedCell& cell, const MapBounds& bounds, const WallNumbers& numbers,
                  std::vector<std::array<double, 2>>& bends) const {
    const AnalysedTile& tile = tile_of(cell.kind);
    const auto& patches = patch_bends_[links_.kinds[cell.kind].tile];
    bends.assign(patches.size(), {});
    double most = 0;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      if (is_dropped(cell, p)) continue;
      bends[p] = patches[p].of(bounds, number_of(tile.tile.patches[p], numbers));
      most = std::max({most, bends[p][0], bends[p][1]});
    }
    return most;
  }
  void find_bends() {
    const std::size_t cells = links_.cells.size();
    const int depth = cells <= 1000 ? 3 : cells <= 10000 ? 2 : 1;
    for_each_map(
        [](std::uint32_t) { return true; },
        [&](std::uint32_t, const LinkedCell& cell, const CellMap& map, const WallNumbers& numbers) {
          std::vector<std::array<double, 2>> bends;
          // Better bounds matter only where a patch has three parts or more.
          if (bends_of(cell, map.bounds(0), numbers, bends) > 4 * options_.chord)
            bends_of(cell, map.bounds(depth), numbers, bends);
          for (std::size_t p = 0; p < bends.size(); ++p)
            for (std::size_t axis = 0; axis < 2; ++axis)
              bends_[numbers_.number(cell.kind, p)][axis].reach(bends[p][axis]);
        });
    for (std::size_t n = 0; n < errors_.size(); ++n)
      errors_[n].along = {bends_[n][0].value(), bends_[n][1].value()};
  }

  std::optional<Error> choose_parts() {
    for (const PatchError& e : errors_)
      if (!(e.along[0] < std::numeric_limits<double>::infinity() &&
            e.along[1] < std::numeric_limits<double>::infinity()))
        return Error{Code::kNotFinite, {}, "the cage has no finite derivatives"};
    if (!numbers_.raise_for(errors_, options_.chord * (1 - 2 * kRoundingShare)))
      return too_many("2^20 parts along a side of a patch");
    if (auto error = bridges_.choose_parts(options_.chord, numbers_)) return error;
    const ScopedUpward upward;
    for (;;) {
      std::uint64_t facets = 0;
      for (std::uint32_t k = 0; k < links_.kinds.size(); ++k) {
        const std::vector<PatchParts> parts = parts_of(k);
        for (std::size_t p = 0; p < parts.size(); ++p) {  // a facet or two for each part
          const std::uint32_t cap = tile_of(k).cap_of_patch[p];
          const std::uint64_t cells =
              cap == AnalysedTile::kNoCap ? cells_with_cap_[k].back() : cells_with_cap_[k][cap];
          facets += std::min(cells * parts[p][0] * parts[p][1], 2 * kMaxMicroFacets);
          if (facets > options_.max_facets) return too_many_facets();
        }
      }
      if (!raises_small_numbers()) return std::nullopt;
    }
  }
  Error too_many(const std::string& what) const {
    return Error{Code::kOverLimit, {}, "a mesh with this chord has more than " + what};
  }
  Error too_many_facets() const {
    return too_many(std::to_string(std::min(options_.max_facets, kMaxMicroFacets)) + " facets");
  }
  std::vector<PatchParts> parts_of(std::uint32_t kind) {
    std::vector<PatchParts> out;
    for (std::size_t p = 0; p < tile_of(kind).surface.num_patches(); ++p)
      out.push_back(numbers_.of(numbers_.number(kind, p)));
    return out;
  }
  // Makes the meshes of the kinds. Returns true if one needed more parts, and has more now.
  bool raises_small_numbers() {
    bool raises = false;
    meshes_.assign(links_.kinds.size(), nullptr);
    for (std::uint32_t k = 0; k < links_.kinds.size(); ++k) {
      const std::uint32_t tile = links_.kinds[k].tile;
      auto& made = made_[{tile, parts_of(k)}];
      if (made.mesh == nullptr)
        made.mesh = std::make_shared<const TileMesh>(tiles_[tile], parts_of(k));
      meshes_[k] = made.mesh;
      auto& patch = made.patch_with_too_few_parts[static_cast<std::size_t>(links_.strictness[k])];
      if (!patch.has_value()) patch = made.mesh->patch_with_too_few_parts(links_.strictness[k]);
      if (*patch == TileMesh::kNoPatch) continue;
      numbers_.raise(numbers_.number(k, *patch));
      raises = true;
    }
    std::erase_if(made_, [](const auto& entry) { return entry.second.mesh.use_count() == 1; });
    return raises;
  }

  void reset_measures() {
    rounding_ = std::make_unique<Greatest>();
    gaps_ = std::vector<Greatest>(gaps_.size());
  }
  void measure_gap(std::uint32_t kind, std::size_t patch, const std::array<Vec3d, 4>& at) {
    Greatest& gap = gaps_[numbers_.number(kind, patch)];
    gap.reach(internal::quad_gap(at[0], at[1], at[2], at[3], gap.value()));
  }
  static bool is_triangle(const TileQuad& q) {
    return q[0] == q[1] || q[1] == q[2] || q[2] == q[3] || q[3] == q[0];
  }
  // The first and the middle cell of each kind.
  void choose_sample() {
    std::vector<std::uint64_t> seen(links_.kinds.size(), 0);
    for (const LinkedCell& c : links_.cells) {
      const std::uint64_t n = seen[c.kind]++;
      is_sampled_.push_back(n == 0 || n == cells_with_cap_[c.kind].back() / 2);
    }
  }
  void measure_sample() {
    for_each_map(
        [&](std::uint32_t number) { return is_sampled_[number]; },
        [&](std::uint32_t, const LinkedCell& cell, const CellMap& map, const WallNumbers& numbers) {
          const TileMesh& mesh = *meshes_[cell.kind];
          std::vector<Vec3d> at;
          for (std::uint32_t v = 0; v < mesh.num_vertices(); ++v)
            at.push_back(middle_of(map.value(mesh.position(v, numbers)), *rounding_));
          for (std::size_t p = 0; p < mesh.parts().size(); ++p)
            for (std::size_t q = mesh.first_quad(p); q < mesh.first_quad(p + 1); ++q)
              if (const TileQuad& quad = mesh.quads()[q];
                  !is_dropped(cell, p) && !is_triangle(quad))
                measure_gap(cell.kind, p, {at[quad[0]], at[quad[1]], at[quad[2]], at[quad[3]]});
        });
  }
  std::optional<Error> rounding_error() const {
    const double rounding = rounding_->value();
    if (!(rounding < std::numeric_limits<double>::infinity()))
      return Error{Code::kNotFinite, {}, "a vertex of the mesh is no finite binary64 point"};
    if (rounding <= options_.chord * kRoundingShare) return std::nullopt;
    return bad_argument("the chord " + text_of_number(options_.chord) +
                        " is less than 64 times the rounding of the vertices, " +
                        text_of_number(rounding));
  }
  static std::string text_of_number(double x) { return internal::number_text("%.17g", x); }

  // If not, the twists in errors_ are such that more parts will be chosen.
  bool is_close_enough() {
    if (distance() <= options_.chord) return true;
    for (std::uint32_t k = 0; k < links_.kinds.size(); ++k)
      for (std::size_t p = 0; p < meshes_[k]->parts().size(); ++p) {
        const auto [m, n] = meshes_[k]->parts()[p];
        const std::size_t number = numbers_.number(k, p);
        errors_[number].twist =
            gaps_[number].value() * static_cast<double>(m) * static_cast<double>(n);
      }
    return false;
  }
  double distance() const {
    const ScopedUpward upward;
    double most = 0;
    for (std::uint32_t k = 0; k < links_.kinds.size(); ++k)
      for (std::size_t p = 0; p < meshes_[k]->parts().size(); ++p) {
        const std::size_t number = numbers_.number(k, p);
        Interval sum = Interval(gaps_[number].value()) + Interval(rounding_->value());
        for (std::size_t axis = 0; axis < 2; ++axis)
          sum += Interval(errors_[number].along[axis]) /
                 sqr(Interval(static_cast<double>(meshes_[k]->parts()[p][axis])));
        most = std::max(most, sum.hi());
      }
    return most;
  }

  // Which vertices and facets are those of a cell.
  struct CellPlace {
    std::uint32_t first_vertex = 0, first_facet = 0;
  };
  static bool is_own_group(const LinkedCell& cell, std::size_t group) {
    if (group == 0) return true;
    const std::size_t cap = (group - 1) / 2;
    return ((group % 2 == 1 ? cell.borrowed : cell.dropped) >> cap & 1) == 0;
  }
  std::uint32_t first_of_group(std::uint32_t cell, std::size_t group) const {
    const LinkedCell& c = links_.cells[cell];
    const TileMesh& mesh = *meshes_[c.kind];
    std::uint32_t at = places_[cell].first_vertex;
    for (std::size_t g = 0; g < group; ++g)
      if (is_own_group(c, g)) at += mesh.group_size(g);
    return at;
  }
  std::optional<Error> place_cells() {
    places_.assign(links_.cells.size(), {});
    std::uint64_t vertices = 0, facets = 0;
    for (std::size_t n = 0; n < links_.cells.size(); ++n) {
      const LinkedCell& cell = links_.cells[n];
      const TileMesh& mesh = *meshes_[cell.kind];
      places_[n] = {static_cast<std::uint32_t>(vertices), static_cast<std::uint32_t>(facets)};
      for (std::size_t g = 0; g < mesh.num_groups(); ++g)
        if (is_own_group(cell, g)) vertices += mesh.group_size(g);
      for (std::size_t p = 0; p < mesh.parts().size(); ++p)
        if (!is_dropped(cell, p)) facets += mesh.num_triangles(p);
      if (facets > options_.max_facets || facets > kMaxMicroFacets || vertices >= 0xffffffff)
        return too_many_facets();
    }
    out_.mesh.positions.resize(vertices);
    out_.mesh.faces.resize(facets);
    return std::nullopt;
  }
  void make_vertices() {
    for_each_map([](std::uint32_t) { return true; },
                 [&](std::uint32_t number, const LinkedCell& cell, const CellMap& map,
                     const WallNumbers& numbers) {
                   const TileMesh& mesh = *meshes_[cell.kind];
                   Vec3d* to = out_.mesh.positions.data() + places_[number].first_vertex;
                   for (std::size_t g = 0; g < mesh.num_groups(); ++g) {
                     if (!is_own_group(cell, g)) continue;
                     for (std::uint32_t v = mesh.group_begin(g); v < mesh.group_begin(g + 1); ++v)
                       *to++ = middle_of(map.value(mesh.position(v, numbers)), *rounding_);
                   }
                 });
  }

  // By rims: of each vertex of the user's rim, the number in the owner's.
  std::vector<std::vector<std::uint32_t>> shared_vertices() const {
    std::vector<std::vector<std::uint32_t>> out;
    for (const SharedRim& rim : links_.rims) {
      const TileMesh &owner = *meshes_[rim.owner_kind], &user = *meshes_[rim.user_kind];
      const std::uint32_t owner_begin = owner.group_begin(TileMesh::rim_of_cap(rim.owner_cap)),
                          user_begin = user.group_begin(TileMesh::rim_of_cap(rim.user_cap));
      auto& to = out.emplace_back(user.group_size(TileMesh::rim_of_cap(rim.user_cap)));
      for (const internal::SharedSide& s : rim.sides) {
        const std::uint32_t n = user.parts()[s.user / kTileSides][s.user % 2];
        for (std::uint32_t i = 0; i <= n; ++i)
          to[user.vertex_of_side(s.user, i) - user_begin] =
              owner.vertex_of_side(s.owner, s.is_reversed ? n - i : i) - owner_begin;
      }
    }
    return out;
  }
  void number_vertices_of(std::uint32_t number,
                          const std::vector<std::vector<std::uint32_t>>& shared,
                          std::vector<std::uint32_t>& ids) const {
    const LinkedCell& cell = links_.cells[number];
    const TileMesh& mesh = *meshes_[cell.kind];
    ids.resize(mesh.num_vertices());
    std::uint32_t own = places_[number].first_vertex;
    std::size_t link = cell.first_link;
    for (std::size_t g = 0; g < mesh.num_groups(); ++g) {
      const std::uint32_t begin = mesh.group_begin(g), end = mesh.group_begin(g + 1);
      if (is_own_group(cell, g)) {
        for (std::uint32_t v = begin; v < end; ++v) ids[v] = own++;
      } else if (g % 2 == 1) {
        const RimLink& l = links_.links[link++];
        const std::uint32_t first =
            first_of_group(l.owner, TileMesh::rim_of_cap(links_.rims[l.rim].owner_cap));
        for (std::uint32_t v = begin; v < end; ++v) ids[v] = first + shared[l.rim][v - begin];
      }
    }
  }
  std::optional<Error> make_bridges() {
    if (bridges_.is_empty()) return std::nullopt;
    const auto shared = shared_vertices();
    const std::uint64_t most = std::min(options_.max_facets, kMaxMicroFacets);
    const bool is_made = bridges_.make(
        meshes_, most,
        [&](std::uint32_t cell, std::vector<std::uint32_t>& ids) {
          number_vertices_of(cell, shared, ids);
        },
        out_.mesh, *rounding_);
    if (!is_made) return too_many_facets();
    return std::nullopt;
  }
  void make_facets() {
    const auto shared = shared_vertices();
    parallel_for(links_.cells.size(), kCellsInChunk, options_.jobs,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   const ScopedUpward upward;
                   std::vector<std::uint32_t> ids;
                   for (std::size_t n = begin; n < end; ++n) {
                     number_vertices_of(static_cast<std::uint32_t>(n), shared, ids);
                     make_facets_of(n, ids);
                   }
                 });
  }
  void make_facets_of(std::size_t number, const std::vector<std::uint32_t>& ids) {
    const LinkedCell& cell = links_.cells[number];
    const TileMesh& mesh = *meshes_[cell.kind];
    const MicroGrid& grid = micro_.grids[links_.kinds[cell.kind].grid];
    const bool is_left_handed = cage_.hand(grid.volume) == Sign::kNegative;
    const auto& positions = out_.mesh.positions;
    auto* to = out_.mesh.faces.data() + places_[number].first_facet;
    for (std::size_t p = 0; p < mesh.parts().size(); ++p) {
      if (is_dropped(cell, p)) continue;
      for (std::size_t q = mesh.first_quad(p); q < mesh.first_quad(p + 1); ++q) {
        const TileQuad& quad = mesh.quads()[q];
        std::array<std::array<std::uint32_t, 3>, 2> triangles;
        const std::size_t count = internal::triangles_of(quad, triangles);
        for (std::size_t k = 0; k < count; ++k) {
          auto [a, b, c] = triangles[k];
          if (is_left_handed) std::swap(b, c);
          *to++ = {ids[a], ids[b], ids[c]};
        }
        if (count == 2)
          measure_gap(cell.kind, p,
                      {positions[ids[quad[0]]], positions[ids[quad[1]]], positions[ids[quad[2]]],
                       positions[ids[quad[3]]]});
      }
    }
  }

  Result<MicroMesh> result() {
    out_.distance = std::max(distance(), bridges_.distance());
    out_.rounding = rounding_->value();
    for (std::uint32_t k = 0; k < links_.kinds.size(); ++k)
      out_.parts.push_back(
          {links_.kinds[k].grid, links_.kinds[k].tile, links_.kinds[k].block, meshes_[k]->parts()});
    return std::move(out_);
  }

  const Microstructure& micro_;
  const VModel& cage_;
  const std::vector<AnalysedTile>& tiles_;
  const MicroMeshOptions& options_;
  CapLinks links_;
  BridgeSurfaces bridges_;
  PartNumbers numbers_;
  std::vector<std::size_t> first_row_;  // of each grid: rows of cells along its third axis
  std::vector<CageCells> cages_;
  std::vector<std::vector<PatchBend>> patch_bends_;  // by tiles
  std::vector<std::vector<std::uint64_t>>
      cells_with_cap_;  // by kinds: of each cap, the cells that keep it; at the end, all cells
  std::vector<std::array<Greatest, 2>> bends_;  // by patches of kinds, as all that follow
  std::vector<PatchError> errors_;
  std::vector<Greatest> gaps_;
  std::unique_ptr<Greatest> rounding_;
  struct MadeMesh {
    std::shared_ptr<const TileMesh> mesh;
    std::array<std::optional<std::uint32_t>, 3> patch_with_too_few_parts;  // by strictness
  };
  std::map<std::pair<std::uint32_t, std::vector<PatchParts>>, MadeMesh>
      made_;                                             // by tiles and parts
  std::vector<std::shared_ptr<const TileMesh>> meshes_;  // by kinds
  std::vector<bool> is_sampled_;                         // by cells
  std::vector<CellPlace> places_;
  MicroMesh out_;
};

}  // namespace

Result<MicroMesh> mesh_of(const Microstructure& micro, const VModel& cage,
                          const std::vector<AnalysedTile>& tiles, const MicroMeshOptions& options) {
  if (!(options.chord > 0 && options.chord < std::numeric_limits<double>::infinity()))
    return bad_argument("the chord " + internal::number_text("%.17g", options.chord) +
                        " is not a positive number");
  auto links = internal::links_of(micro, cage, tiles);
  if (!links) return links.error();
  if (links->cells.empty()) return Error{Code::kEmpty, {}, "no cell holds a tile"};
  return MicroMesher(micro, cage, tiles, options, std::move(links.value())).run();
}

}  // namespace veritope
