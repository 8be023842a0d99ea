// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/open_tile_file.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "io/splines/volumes.h"
#include "io/tile_file.h"
#include "solids/micro/open_tile.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

Status add_curve_pieces(const ExactCurve& curve, const std::string& where,
                        std::vector<TilePatch>& patches) {
  if (curve.is_rational())
    return bad_argument(where + " is rational; the curves of tiles are polynomial");
  if (curve.dimension() != 3)
    return bad_argument(where + " has " + std::to_string(curve.dimension()) +
                        " coordinates; a tile lies in space");
  if (curve.axis(0).degree > kMaxTileDegree)
    return Error{Code::kOverLimit,
                 {},
                 where + " has the degree " + std::to_string(curve.axis(0).degree) +
                     "; tiles have degrees up to " + std::to_string(kMaxTileDegree)};
  const std::size_t spans = curve.axis(0).num_control();
  if (spans > 8 * kMaxTilePatches)
    return Error{Code::kOverLimit,
                 {},
                 where + " has " + std::to_string(spans) + " control points, more than " +
                     std::to_string(8 * kMaxTilePatches)};
  for (const BezierCurve<Rational>& piece : bezier_pieces(curve).pieces) {
    TilePatch& patch = patches.emplace_back();
    patch.degrees = {piece.degree(0), 0};
    auto& points = patch.points.emplace_back();
    for (std::size_t i = 0; i < piece.grid().count(); ++i)
      points.push_back({piece.component(0)[i], piece.component(1)[i], piece.component(2)[i]});
  }
  return ok_status();
}

}  // namespace

Result<MicroTile> open_tile_of(const ModelFile& file, const std::string& name,
                               const MeshFile* polygons) {
  MicroTile out;
  const auto* const splines = std::get_if<SplineFile>(&file);
  std::optional<ModelFile> others;  // without the curves
  std::vector<TilePatch> curves;
  if (splines != nullptr) {
    const SplineModel plain =
        has_attributes(splines->model) ? without_attributes(splines->model) : splines->model;
    SplineFile rest = *splines;
    rest.model.entities.clear();
    for (std::size_t e = 0; e < plain.entities.size(); ++e) {
      const auto* const curve = std::get_if<ExactCurve>(&plain.entities[e].shape);
      if (curve == nullptr)
        rest.model.entities.push_back(plain.entities[e]);
      else if (Status status = add_curve_pieces(*curve, "the curve " + std::to_string(e), curves);
               !status)
        return status.error();
    }
    const bool lacks_shapes = std::any_of(rest.left_out.begin(), rest.left_out.end(),
                                          [](const LeftOut& l) { return l.is_geometry; });
    if (!rest.model.entities.empty() || curves.empty() || lacks_shapes)
      others.emplace(std::move(rest));
  }
  if (splines == nullptr || others) {
    Result<MicroTile> sheets =
        tile_of(others ? *others : file, name, TileFacets::kFewest, polygons);
    if (!sheets) return sheets.error();
    out = std::move(*sheets);
  }
  out.name = name;
  out.is_open = true;
  for (TilePatch& curve : curves) out.patches.push_back(std::move(curve));
  if (Status status = check_open_tile(out); !status) return status.error();
  return out;
}

}  // namespace veritope
