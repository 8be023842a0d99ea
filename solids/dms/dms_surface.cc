// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_surface.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "robust/base/check.h"
#include "robust/base/parallel.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_piece.h"

namespace veritope {
namespace {

constexpr std::size_t kMapsOfChunk = 128;

// The first components of the map on a tile.
BezierTriangle<Rational> map_on(DmsPieces& pieces, int degree, std::size_t num_components,
                                const DmsTile& tile) {
  const auto parts = pieces.components(tile.corners, num_components);
  VT_CHECK(parts.has_value(), "points of the boundary lie in the closed domain");
  BezierTriangle<Rational> out(degree, static_cast<int>(num_components), false);
  for (std::size_t c = 0; c < num_components; ++c)
    std::copy((*parts)[c].begin(), (*parts)[c].end(), out.component(static_cast<int>(c)).begin());
  return out;
}

std::variant<std::vector<DmsTile>, DmsOpenFace> all_tiles(const DmsModel& model,
                                                          const TetrahedralComplex& complex,
                                                          const DmsTileOptions& options) {
  const auto tiled = tile_boundary(model, complex, options);
  if (const auto* const open = std::get_if<DmsOpenFace>(&tiled)) return *open;
  std::vector<DmsTile> tiles;
  for (const auto& of_face : std::get<0>(tiled))
    tiles.insert(tiles.end(), of_face.begin(), of_face.end());
  return tiles;
}

// Tiles of one chunk are of one face or of neighbours, and share what DmsPieces keeps.
std::vector<BezierTriangle<Rational>> maps_on(const DmsModel& model, const DmsEvaluator& evaluator,
                                              std::size_t num_components,
                                              const std::vector<DmsTile>& tiles,
                                              const DmsTileOptions& options) {
  std::vector<BezierTriangle<Rational>> out(
      tiles.size(),
      BezierTriangle<Rational>(model.degree, static_cast<int>(num_components), false));
  WorkStep step(options.work, static_cast<double>(tiles.size()));
  parallel_for(tiles.size(), kMapsOfChunk, options.jobs,
               [&](std::size_t, std::size_t begin, std::size_t end) {
                 DmsPieces pieces(model, evaluator);
                 for (std::size_t k = begin; k < end; ++k)
                   out[k] = map_on(pieces, model.degree, num_components, tiles[k]);
                 step.add(static_cast<double>(end - begin));
               });
  return out;
}

}  // namespace

std::vector<BezierTriangle<Rational>> patches_on(const DmsModel& model,
                                                 const DmsEvaluator& evaluator,
                                                 const std::vector<DmsTile>& tiles,
                                                 const DmsTileOptions& options) {
  return maps_on(model, evaluator, 3, tiles, options);
}

std::variant<std::vector<BezierTriangle<Rational>>, DmsOpenFace> boundary_patches(
    const DmsModel& model, const TetrahedralComplex& complex, const DmsTileOptions& options) {
  const auto tiles = all_tiles(model, complex, options);
  if (const auto* const open = std::get_if<DmsOpenFace>(&tiles)) return *open;
  return patches_on(model, DmsEvaluator(model), std::get<0>(tiles), options);
}

std::variant<std::vector<DmsBoundaryPiece>, DmsOpenFace> boundary_pieces(
    const DmsModel& model, const TetrahedralComplex& complex, const DmsTileOptions& options) {
  const auto found = all_tiles(model, complex, options);
  if (const auto* const open = std::get_if<DmsOpenFace>(&found)) return *open;
  const std::vector<DmsTile>& tiles = std::get<0>(found);
  auto maps = maps_on(model, DmsEvaluator(model), model.num_components(), tiles, options);
  std::vector<DmsBoundaryPiece> out;
  for (std::size_t k = 0; k < tiles.size(); ++k)
    out.push_back({tiles[k].corners, std::move(maps[k])});
  return out;
}

}  // namespace veritope
