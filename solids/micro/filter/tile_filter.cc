// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/filter/tile_filter.h"

#include <utility>

#include "interval/upward.h"
#include "robust/base/check.h"
#include "solids/micro/filter/mesh_model_internal.h"
#include "solids/micro/filter/patch_model_internal.h"
#include "solids/micro/filter/tile_walk_internal.h"
#include "splines/bezier_domain.h"

namespace veritope {

ExactPoint CellMap::image(const PatchPoint& at) const {
  PatchPoint p;
  for (std::size_t a = 0; a < 3; ++a) p[a] = lo[a] + (hi[a] - lo[a]) * at[a];
  const std::vector<Rational> x = evaluate<Rational, 3>(*map, p);
  const auto out = point_of(x);
  VT_CHECK(out.has_value(), "the weight of a cell's map is 0 at a point of the cell");
  return *out;
}

ExactPoint CellMap::image(const TileShape& tile, const TilePatchPoint& at) const {
  const auto p = evaluate<Rational, 2>(tile.patches()[at.patch].exact, {at.u, at.v});
  return image(PatchPoint{p[0], p[1], p[2]});
}

TileFilter::TileFilter(std::unique_ptr<const Model> model) : model_(std::move(model)) {}
TileFilter::TileFilter(TileFilter&&) noexcept = default;
TileFilter::~TileFilter() = default;

Result<TileFilter> TileFilter::make(const TriangleMesh& mesh) {
  Result<MeshClassifier> classifier = MeshClassifier::make(mesh, nullptr, LookupDetail::kForBoxes);
  if (!classifier) return classifier.error();
  return TileFilter(
      std::make_unique<const internal::MeshModel>(mesh, std::move(classifier.value())));
}

TileFilter TileFilter::make(const PatchComplex& complex) {
  return TileFilter(std::make_unique<const internal::PatchModel>(complex));
}

CellFinding TileFilter::find(const CellMap& cell, const TileShape& tile,
                             const TileFilterLimits& limits) const {
  BezierVolume<Rational> part = *cell.map;
  for (std::size_t a = 0; a < 3; ++a) part = restricted(part, a, cell.lo[a], cell.hi[a]);
  const ScopedUpward upward;
  return model_->find(internal::CellNet(part), cell, tile, limits);
}

CellFinding TileFilter::Model::find(const internal::CellNet& net, const CellMap& cell,
                                    const TileShape& tile, const TileFilterLimits& limits) const {
  const Value3 value = this->value(net.hull());
  if (!is_constant(value)) return internal::TileWalk(*this, net, cell, tile, limits).run();
  CellFinding out;
  out.status = value == Value3::kOne ? CellStatus::kKept : CellStatus::kOutside;
  return out;
}

}  // namespace veritope
