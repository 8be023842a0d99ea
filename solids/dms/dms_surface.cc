// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_surface.h"

#include <cstddef>
#include <utility>

#include "robust/base/check.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_piece.h"

namespace veritope {
namespace {

BezierTriangle<Rational> patch_of(int degree, std::vector<DmsPoint> coefficients) {
  BezierTriangle<Rational> out(degree, 3, false);
  for (int c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < coefficients.size(); ++i)
      out.component(c)[i] = std::move(coefficients[i][static_cast<std::size_t>(c)]);
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
  const auto tiled = tile_boundary(model, complex);
  if (const auto* const open = std::get_if<DmsOpenFace>(&tiled)) return *open;
  std::vector<DmsTile> tiles;
  for (const auto& of_face : std::get<0>(tiled))
    tiles.insert(tiles.end(), of_face.begin(), of_face.end());
  DmsEvaluator evaluator(model);
  return patches_on(model, evaluator, tiles);
}

}  // namespace veritope
