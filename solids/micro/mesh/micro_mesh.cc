// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/mesh/micro_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "interval/upward.h"
#include "robust/base/check.h"
#include "robust/base/fp_guard.h"
#include "robust/base/parallel.h"
#include "solids/micro/mesh/bridge_surfaces_internal.h"
#include "solids/micro/mesh/cap_links_internal.h"
#include "solids/micro/mesh/cell_plans_internal.h"
#include "solids/micro/mesh/grid_map_internal.h"
#include "solids/micro/mesh/part_numbers_internal.h"
#include "solids/micro/mesh/patch_bend_internal.h"
#include "solids/micro/mesh/tile_mesh_internal.h"
#include "solids/micro/mesh/vertex_rounding_internal.h"

namespace veritope {
namespace {

using internal::BridgeSurfaces;
using internal::CapLinks;
using internal::CellMapBounds;
using internal::CellOnCage;
using internal::CellPlan;
using internal::CellPlans;
using internal::Greatest;
using internal::GridMap;
using internal::LinkedCell;
using internal::PartNumbers;
using internal::PatchBend;
using internal::PatchError;
using internal::PatchParts;
using internal::PointColumns;
using internal::RimLink;
using internal::SharedRim;
using internal::TileMesh;
using internal::TileTriangle;

constexpr std::size_t kRowsInChunk = 4, kCellsInChunk = 256, kKindsInChunk = 16;
// The rounding of vertices is at most this part of the chord.
constexpr double kRoundingShare = 0x1p-6;

// Bounds of the maps of the cells of a kind.
struct KindBounds {
  std::array<Greatest, 3> first;
  std::array<Greatest, 6> second;
  Greatest is_loose;  // 1 if better ones may be had

  void reach(const CellMapBounds& b) {
    for (std::size_t a = 0; a < first.size(); ++a) first[a].reach(b.first[a]);
    for (std::size_t k = 0; k < second.size(); ++k) second[k].reach(b.second[k]);
  }
  CellMapBounds value() const {
    CellMapBounds out;
    for (std::size_t a = 0; a < first.size(); ++a) out.first[a] = first[a].value();
    for (std::size_t k = 0; k < second.size(); ++k) out.second[k] = second[k].value();
    return out;
  }
};

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
    for (const MicroGrid& g : micro.grids) {
      const Grid<3> shape = g.shape();
      first_row_.push_back(first_row_.back() + shape.size[0] * shape.size[1]);
      cages_.emplace_back(micro.cage[g.volume], g);
    }
    const ScopedUpward upward;
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
    kind_bounds_ = std::vector<KindBounds>(links_.kinds.size());
    gaps_ = std::vector<Greatest>(numbers_.num_patches());
  }

  Result<MicroMesh> run() {
    if (auto error = bridges_.find_errors()) return std::move(*error);
    reset_measures();
    for (const GridMap& g : cages_) rounding_->reach(g.least_rounding());
    if (auto error = rounding_error()) return std::move(*error);
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
  // CellOnCage.
  template <typename Choose, typename Visit>
  void for_each_map(Choose is_visited, Visit visit) const {
    parallel_for(first_row_.back(), kRowsInChunk, options_.jobs,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   const ScopedDefaultFp fp;
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
    std::optional<CellOnCage> map;
    for (std::size_t k = 0; k < length; ++k) {
      const std::uint32_t number = links_.numbers[g][in_grid * length + k];
      if (number == CapLinks::kNoCell || !is_visited(number)) continue;
      if (!map.has_value()) map.emplace(cages_[g]).enter_row(i, j);
      map->enter_cell(k);
      visit(number, links_.cells[number], *map, grid.numbers_of({i, j, k}));
    }
  }

  // Bounds of the derivatives of the maps of all cells, then of the bends of the patches of each kind. Better bounds of
  // the maps are found only where a patch has three parts or more.
  void find_bends() {
    const std::size_t cells = links_.cells.size();
    const int depth = cells <= 1000 ? 3 : cells <= 10000 ? 2 : 1;
    errors_.resize(numbers_.num_patches());
    for_each_map([](std::uint32_t) { return true; },
                 [&](std::uint32_t, const LinkedCell& cell, CellOnCage& map, const WallNumbers&) {
                   bool is_loose = false;
                   KindBounds& bounds = kind_bounds_[cell.kind];
                   bounds.reach(map.bounds(is_loose));
                   if (is_loose) bounds.is_loose.reach(1);
                 });
    std::vector<std::uint8_t> is_refined(links_.kinds.size(), 0);
    for_each_kind([&](std::uint32_t k) {
      const bool is_large = find_bends_of(k, kind_bounds_[k]) > 4 * options_.chord;
      is_refined[k] = is_large && kind_bounds_[k].is_loose.value() > 0 ? 1 : 0;
    });
    if (std::find(is_refined.begin(), is_refined.end(), 1) == is_refined.end()) return;
    std::vector<KindBounds> refined(links_.kinds.size());
    for_each_map([&](std::uint32_t number) { return is_refined[links_.cells[number].kind] != 0; },
                 [&](std::uint32_t, const LinkedCell& cell, CellOnCage& map, const WallNumbers&) {
                   refined[cell.kind].reach(map.refined_bounds(depth));
                 });
    for_each_kind([&](std::uint32_t k) {
      if (is_refined[k] != 0) find_bends_of(k, refined[k]);
    });
  }
  template <typename Visit>
  void for_each_kind(Visit visit) const {
    parallel_for(links_.kinds.size(), kKindsInChunk, options_.jobs,
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   const ScopedUpward upward;
                   for (std::size_t k = begin; k < end; ++k) visit(static_cast<std::uint32_t>(k));
                 });
  }
  // By walls: the least and the greatest number in the cells of a kind.
  std::array<std::array<std::int32_t, 2>, 6> numbers_of_kind(std::uint32_t kind) const {
    const internal::MeshKind& k = links_.kinds[kind];
    const MicroGrid& grid = micro_.grids[k.grid];
    const Grid<3> shape = grid.shape();
    std::array<std::array<std::int32_t, 2>, 6> out;
    out.fill({kMaxWallNumber, 0});
    std::array<std::size_t, 3> at;
    for (at[0] = k.block[0][0]; at[0] < k.block[0][1]; ++at[0])
      for (at[1] = k.block[1][0]; at[1] < k.block[1][1]; ++at[1])
        for (at[2] = k.block[2][0]; at[2] < k.block[2][1]; ++at[2]) {
          if (grid.tiles[shape.at(at)] != k.tile + 1) continue;
          const WallNumbers numbers = grid.numbers_of(at);
          for (std::size_t w = 0; w < out.size(); ++w)
            out[w] = {std::min(out[w][0], numbers[w]), std::max(out[w][1], numbers[w])};
        }
    return out;
  }
  // Sets the errors of the patches of a kind. The greatest one of those that some cell keeps.
  double find_bends_of(std::uint32_t kind, const KindBounds& bounds) {
    const AnalysedTile& tile = tile_of(kind);
    const auto& patches = patch_bends_[links_.kinds[kind].tile];
    const auto range = numbers_of_kind(kind);
    const CellMapBounds map = bounds.value();
    double most = 0;
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const std::uint32_t cap = tile.cap_of_patch[p];
      if (cap != AnalysedTile::kNoCap && cells_with_cap_[kind][cap] == 0) continue;
      Interval t;
      if (const auto& wall = tile.tile.patches[p].wall; wall.has_value()) {
        const auto [low, high] = range[static_cast<std::size_t>(*wall)];
        t = Interval::from_bounds(low * 0x1p-20, high * 0x1p-20);
      }
      const std::array<double, 2> bends = patches[p].of(map, t);
      errors_[numbers_.number(kind, p)].along = bends;
      most = std::max({most, bends[0], bends[1]});
    }
    return most;
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
  // Measures the quadrilaterals of the patches that are kept.
  void measure_gaps(std::uint32_t kind, const TileMesh& mesh, const CellPlan& plan,
                    const PointColumns& points, std::vector<double>& gaps) {
    gaps.resize(mesh.quads().size());
    for (const auto& [begin, end] : plan.quads)
      internal::quad_gaps(points, mesh.quads().data() + begin, end - begin, gaps.data() + begin);
    for (const std::uint32_t p : plan.patches) {
      double most = 0;
      for (std::uint32_t q = mesh.first_quad(p); q < mesh.first_quad(p + 1); ++q)
        most = gaps[q] <= most ? most : gaps[q];
      if (!(most <= std::numeric_limits<double>::max()))
        most = std::numeric_limits<double>::infinity();
      gaps_[numbers_.number(kind, p)].reach(most);
    }
  }
  // What GridMap::rounding_of knows about the vertices of all cells.
  void reach_roundings() {
    std::vector<std::array<double, 3>> first(cages_.size());
    for (std::uint32_t k = 0; k < links_.kinds.size(); ++k) {
      const std::array<double, 3> own = kind_bounds_[k].value().first;
      std::array<double, 3>& most = first[links_.kinds[k].grid];
      for (std::size_t a = 0; a < 3; ++a) most[a] = std::max(most[a], own[a]);
    }
    const TileMesh* last = nullptr;
    for (std::uint32_t k = 0; k < links_.kinds.size(); ++k) {
      const std::uint32_t grid = links_.kinds[k].grid;
      if (meshes_[k].get() == last && k > 0 && links_.kinds[k - 1].grid == grid) continue;
      last = meshes_[k].get();
      rounding_->reach(cages_[grid].rounding_of(*last, first[grid]));
    }
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
    reach_roundings();
    for_each_map(
        [&](std::uint32_t number) { return is_sampled_[number]; },
        [&](std::uint32_t, const LinkedCell& cell, CellOnCage& map, const WallNumbers& numbers) {
          const TileMesh& mesh = *meshes_[cell.kind];
          CellPlans plans;
          const CellPlan& plan = plans[plans.number_of(tile_of(cell.kind), mesh, cell)];
          const PointColumns& points = map.place(mesh, 0, mesh.num_vertices(), numbers, *rounding_);
          std::vector<double> gaps;
          measure_gaps(cell.kind, mesh, plan, points, gaps);
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
    std::uint32_t first_vertex = 0, first_facet = 0, plan = 0;
  };
  const CellPlan& plan_of(std::size_t cell) const { return plans_[places_[cell].plan]; }
  std::optional<Error> place_cells() {
    plans_.clear();
    places_.resize(links_.cells.size());
    std::uint64_t vertices = 0, facets = 0;
    for (std::size_t n = 0; n < links_.cells.size(); ++n) {
      const LinkedCell& cell = links_.cells[n];
      places_[n] = {static_cast<std::uint32_t>(vertices), static_cast<std::uint32_t>(facets),
                    plans_.number_of(tile_of(cell.kind), *meshes_[cell.kind], cell)};
      vertices += plan_of(n).num_vertices;
      facets += plan_of(n).num_triangles;
      if (facets > options_.max_facets || facets > kMaxMicroFacets || vertices >= 0xffffffff)
        return too_many_facets();
    }
    out_.mesh.positions.resize(vertices);
    out_.mesh.faces.resize(facets);
    return std::nullopt;
  }
  void make_vertices() {
    reach_roundings();
    for_each_map([](std::uint32_t) { return true; },
                 [&, this](std::uint32_t number, const LinkedCell& cell, CellOnCage& map,
                           const WallNumbers& numbers) {
                   Vec3d* to = out_.mesh.positions.data() + places_[number].first_vertex;
                   for (const auto& [begin, end] : plan_of(number).own) {
                     const PointColumns& points =
                         map.place(*meshes_[cell.kind], begin, end, numbers, *rounding_);
                     for (std::size_t v = 0; v < end - begin; ++v)
                       *to++ = {points.at[0][v], points.at[1][v], points.at[2][v]};
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
    for (const auto& [begin, end] : plan_of(number).own)
      for (std::uint32_t v = begin; v < end; ++v) ids[v] = own++;
    std::size_t link = cell.first_link;
    for (std::uint64_t caps = cell.borrowed; caps != 0; caps &= caps - 1) {
      const std::size_t rim =
          TileMesh::rim_of_cap(static_cast<std::size_t>(std::countr_zero(caps)));
      const RimLink& l = links_.links[link++];
      const std::size_t owner_rim = TileMesh::rim_of_cap(links_.rims[l.rim].owner_cap);
      const std::uint32_t first =
          places_[l.owner].first_vertex + plan_of(l.owner).first_of_group[owner_rim];
      const std::uint32_t* const from = shared[l.rim].data();
      std::uint32_t* const to = ids.data() + mesh.group_begin(rim);
      for (std::uint32_t v = 0; v < mesh.group_size(rim); ++v) to[v] = first + from[v];
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
                   const ScopedDefaultFp fp;
                   std::vector<std::uint32_t> ids;
                   PointColumns points;
                   std::vector<double> gaps;
                   for (std::size_t n = begin; n < end; ++n) {
                     number_vertices_of(static_cast<std::uint32_t>(n), shared, ids);
                     make_facets_of(n, ids);
                     measure_gaps_of(n, ids, points, gaps);
                   }
                 });
  }
  void make_facets_of(std::size_t number, const std::vector<std::uint32_t>& ids) {
    const LinkedCell& cell = links_.cells[number];
    const TileMesh& mesh = *meshes_[cell.kind];
    const MicroGrid& grid = micro_.grids[links_.kinds[cell.kind].grid];
    const bool is_left_handed = cage_.hand(grid.volume) == Sign::kNegative;
    auto* to = out_.mesh.faces.data() + places_[number].first_facet;
    for (const auto& [begin, end] : plan_of(number).triangles)
      for (std::uint32_t k = begin; k < end; ++k) {
        const TileTriangle& t = mesh.triangles()[k];
        *to++ = {ids[t[0]], ids[t[is_left_handed ? 2 : 1]], ids[t[is_left_handed ? 1 : 2]]};
      }
  }
  void measure_gaps_of(std::size_t number, const std::vector<std::uint32_t>& ids,
                       PointColumns& points, std::vector<double>& gaps) {
    const TileMesh& mesh = *meshes_[links_.cells[number].kind];
    points.resize(mesh.num_vertices());
    double *const x = points.at[0].data(), *const y = points.at[1].data(),
                  *const z = points.at[2].data();
    for (const auto& [begin, end] : plan_of(number).present)
      for (std::uint32_t v = begin; v < end; ++v) {
        const Vec3d& p = out_.mesh.positions[ids[v]];
        x[v] = p.x;
        y[v] = p.y;
        z[v] = p.z;
      }
    measure_gaps(links_.cells[number].kind, mesh, plan_of(number), points, gaps);
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
  std::vector<GridMap> cages_;
  std::vector<std::vector<PatchBend>> patch_bends_;  // by tiles
  std::vector<std::vector<std::uint64_t>>
      cells_with_cap_;  // by kinds: of each cap, the cells that keep it; at the end, all cells
  std::vector<KindBounds> kind_bounds_;
  std::vector<PatchError> errors_;  // by patches of kinds
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
  CellPlans plans_;
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
