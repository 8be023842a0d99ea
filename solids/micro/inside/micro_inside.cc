// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/inside/micro_inside.h"

#include <algorithm>
#include <utility>

#include "interval/upward.h"
#include "robust/base/parallel.h"
#include "solids/micro/inside/inside_parts_internal.h"
#include "splines/de_casteljau.h"

namespace veritope {

using namespace internal;

internal::VolumeMaps::VolumeMaps(const VVolume& volume) : pieces_(bezier_pieces(volume)) {
  const ScopedUpward upward;
  for (const auto& piece : pieces_.pieces)
    checkers_error_ = std::max(checkers_error_, nets_.emplace_back(piece).checkers_error());
}

ExactPoint internal::VolumeMaps::image(const TilePoint& x) const {
  std::array<std::size_t, 3> spans{};
  std::array<Rational, 3> at;
  for (std::size_t a = 0; a < 3; ++a) {
    const SpanPart p = span_part(knots(a), x[a], x[a]);
    spans[a] = p.span;
    at[a] = p.lo;
  }
  const BezierVolume<Rational>& map = exact(spans);
  std::vector<Rational> v = evaluate<Rational, 3>(map, at);
  if (map.is_rational())
    for (std::size_t c = 0; c < 3; ++c) v[c] /= v[3];
  return {v[0], v[1], v[2]};
}

std::vector<TilePoint> internal::InsideParts::exact_points(const CellPatch& at) const {
  const MicroGrid& grid = micro.grids[at.grid];
  const TilePatch& patch = micro.tiles[grid.tiles[at.cell] - 1u].patches[at.patch];
  return points_at(patch, number_of(patch, grid.numbers_of(grid.shape().index_of(at.cell))));
}

std::string internal::InsideParts::name(const CellPatch& at) const {
  const auto cell = micro.grids[at.grid].shape().index_of(at.cell);
  return "patch " + std::to_string(at.patch) + " of the tile of cell (" + std::to_string(cell[0]) +
         ", " + std::to_string(cell[1]) + ", " + std::to_string(cell[2]) + ") of grid " +
         std::to_string(at.grid);
}

namespace {

std::variant<InsideProof, InsideDefect> prove(const Microstructure& micro,
                                              const std::vector<AnalysedTile>& tiles,
                                              const std::vector<CellPatch>& first_patches,
                                              const InsideSolid& solid, unsigned jobs,
                                              const InsideLimits& limits) {
  const WorkerScope workers(std::max(1u, jobs));
  InsideParts parts{micro, tiles, solid, limits, std::max(1u, jobs), {}};
  for (const VVolume& volume : micro.cage) parts.volumes.emplace_back(volume);
  InsideProof proof;
  if (auto defect = surface_defect(parts)) return std::move(*defect);
  if (auto defect = shell_defect(parts, first_patches)) return std::move(*defect);
  if (auto defect = void_defect(parts, &proof.voids)) return std::move(*defect);
  if (auto defect = skin_defect(parts, &proof.skin)) return std::move(*defect);
  return proof;
}

}  // namespace

std::variant<InsideProof, InsideDefect> prove_inside(const Microstructure& micro,
                                                     const std::vector<AnalysedTile>& tiles,
                                                     const std::vector<CellPatch>& first_patches,
                                                     const InsideModel& model, unsigned jobs,
                                                     const InsideLimits& limits) {
  return prove(micro, tiles, first_patches, *inside_solid(model), jobs, limits);
}
std::variant<InsideProof, InsideDefect> prove_inside(const Microstructure& micro,
                                                     const std::vector<AnalysedTile>& tiles,
                                                     const std::vector<CellPatch>& first_patches,
                                                     const PatchComplex& model, unsigned jobs,
                                                     const InsideLimits& limits) {
  return prove(micro, tiles, first_patches, *inside_solid(model), jobs, limits);
}

}  // namespace veritope
