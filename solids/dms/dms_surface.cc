// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_surface.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "robust/base/check.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_piece.h"
#include "solids/dms/dms_values.h"

namespace veritope {
namespace {

BezierTriangle<Rational> patch_of(int degree, std::vector<DmsPoint> coefficients) {
  BezierTriangle<Rational> out(degree, 3, false);
  for (int c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < coefficients.size(); ++i)
      out.component(c)[i] = std::move(coefficients[i][static_cast<std::size_t>(c)]);
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

BezierTriangle<Rational> map_on(const DmsModel& model, DmsEvaluator& evaluator,
                                const SimplexInterpolation& interpolation, const DmsTile& tile) {
  std::vector<std::vector<Rational>> values(model.num_components());
  for (const DmsPoint& p : interpolation.points(tile.corners)) {
    const auto place = evaluator.locate(p);
    VT_CHECK(place.has_value(), "points of the boundary lie in the closed domain");
    const DmsValue value = evaluator.evaluate(*place);
    for (std::size_t c = 0; c < values.size(); ++c) values[c].push_back(value.value[c]);
  }
  BezierTriangle<Rational> out(model.degree, static_cast<int>(values.size()), false);
  for (std::size_t c = 0; c < values.size(); ++c) {
    const std::vector<Rational> coefficients = interpolation.coefficients(values[c]);
    std::copy(coefficients.begin(), coefficients.end(), out.component(static_cast<int>(c)).begin());
  }
  return out;
}

}  // namespace

std::vector<BezierTriangle<Rational>> patches_on(const DmsModel& model,
                                                 const DmsEvaluator& evaluator,
                                                 const std::vector<DmsTile>& tiles) {
  DmsPieces pieces(model, evaluator);
  std::vector<BezierTriangle<Rational>> out;
  for (const DmsTile& tile : tiles) {
    auto coefficients = pieces.coefficients(tile.corners);
    VT_CHECK(coefficients.has_value(), "points of the boundary lie in the closed domain");
    out.push_back(patch_of(model.degree, std::move(*coefficients)));
  }
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
  const SimplexInterpolation interpolation(model.degree, 3);
  DmsEvaluator evaluator(model);
  std::vector<DmsBoundaryPiece> out;
  for (const DmsTile& tile : std::get<0>(tiles))
    out.push_back({tile.corners, map_on(model, evaluator, interpolation, tile)});
  return out;
}

}  // namespace veritope
