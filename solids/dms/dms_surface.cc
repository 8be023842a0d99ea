// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_surface.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "robust/base/check.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_piece.h"

namespace veritope {
namespace {

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
                                                          const TetrahedralComplex& complex) {
  const auto tiled = tile_boundary(model, complex);
  if (const auto* const open = std::get_if<DmsOpenFace>(&tiled)) return *open;
  std::vector<DmsTile> tiles;
  for (const auto& of_face : std::get<0>(tiled))
    tiles.insert(tiles.end(), of_face.begin(), of_face.end());
  return tiles;
}

}  // namespace

std::vector<BezierTriangle<Rational>> patches_on(const DmsModel& model,
                                                 const DmsEvaluator& evaluator,
                                                 const std::vector<DmsTile>& tiles) {
  DmsPieces pieces(model, evaluator);
  std::vector<BezierTriangle<Rational>> out;
  for (const DmsTile& tile : tiles) out.push_back(map_on(pieces, model.degree, 3, tile));
  return out;
}

std::variant<std::vector<BezierTriangle<Rational>>, DmsOpenFace> boundary_patches(
    const DmsModel& model, const TetrahedralComplex& complex) {
  const auto tiles = all_tiles(model, complex);
  if (const auto* const open = std::get_if<DmsOpenFace>(&tiles)) return *open;
  DmsEvaluator evaluator(model);
  return patches_on(model, evaluator, std::get<0>(tiles));
}

std::variant<std::vector<DmsBoundaryPiece>, DmsOpenFace> boundary_pieces(
    const DmsModel& model, const TetrahedralComplex& complex) {
  const auto tiles = all_tiles(model, complex);
  if (const auto* const open = std::get_if<DmsOpenFace>(&tiles)) return *open;
  const DmsEvaluator evaluator(model);
  DmsPieces pieces(model, evaluator);
  std::vector<DmsBoundaryPiece> out;
  for (const DmsTile& tile : std::get<0>(tiles))
    out.push_back({tile.corners, map_on(pieces, model.degree, model.num_components(), tile)});
  return out;
}

}  // namespace veritope
