// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fast/fast_cells_internal.h"

#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace veritope::internal {
namespace {

void set_side(FastCell& at) {
  FastSide& s = at.side;
  s.scale = at.place.scale;
  s.low[3] = -std::numeric_limits<double>::infinity(),
  s.high[3] = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < 3; ++c) {
    s.low[c] = at.place.box.lo[c], s.high[c] = at.place.box.hi[c];
    s.origin[c] = at.place.origin[c];
  }
  for (std::size_t m = 0; m < 4; ++m) {
    for (std::size_t c = 0; c < 4; ++c) s.c[c][m] = at.frame.lambda[m].c[c];
    for (std::size_t r = 0; r < 2; ++r) s.error[r][m] = at.frame.lambda[m].error[r];
  }
}

}  // namespace

FastCells::FastCells(const DmsModel& model, const DmsEvaluator& evaluator,
                     const FastDmsKernels& kernels)
    : model_(model),
      evaluator_(evaluator),
      kernels_(kernels),
      cells_(model.tetrahedra.size()),
      sides_(model.tetrahedra.size()),
      grid_(make_grid()) {}

FastGrid FastCells::make_grid() {
  std::vector<std::array<Point3d, 4>> corners;
  for (std::uint32_t t = 0; t < model_.tetrahedra.size(); ++t) {
    places_.push_back(FastPlace::around(evaluator_.corner_box(t)));
    boxes_.push_back(places_[t] ? places_[t]->box : evaluator_.corner_box(t));
    auto& at = corners.emplace_back();
    for (std::size_t m = 0; m < 4; ++m)
      for (std::size_t c = 0; c < 3; ++c)
        at[m][c] = nearest_double(model_.knot(model_.tetrahedra[t][m], 0)[c]);
  }
  return {boxes_, corners};
}

const FastCell* FastCells::cell(std::uint32_t t) {
  if (cells_[t] || !places_[t]) return cells_[t].get();
  std::array<std::array<Rational, 3>, 4> at;
  auto made = std::make_unique<FastCell>();
  for (std::size_t m = 0; m < 4; ++m) {
    at[m] = model_.knot(model_.tetrahedra[t][m], 0);
    for (std::size_t c = 0; c < 3; ++c) made->corners[m][c] = nearest_double(at[m][c]);
  }
  const auto frame = places_[t]->round(simplex_frame<Rational>({0, 1, 2, 3}, at, Sign::kPositive));
  if (!frame) return places_[t].reset(), nullptr;
  made->place = *places_[t];
  made->box = evaluator_.corner_box(t);
  made->frame = *frame;
  cells_[t] = std::move(made);
  sides_[t] = &cells_[t]->side;
  set_side(*cells_[t]);
  return cells_[t].get();
}

std::uint32_t FastCells::locate(const Vec3d& u, double rounded) {
  if (!(std::isfinite(u.x) && std::isfinite(u.y) && std::isfinite(u.z))) return kFastUndecided;
  const double at[4] = {u.x, u.y, u.z, 0};
  std::span<const std::uint32_t> list = grid_.near(u);
  for (;;) {
    std::size_t place = 0;
    const std::uint32_t t =
        kernels_.find(list.data(), list.size(), sides_.data(), at, rounded, &place);
    if (t != kFastUnmade) return t;
    const std::uint32_t unmade = list[place];
    if (cell(unmade) == nullptr) {
      if (is_in_box(boxes_[unmade], u)) return kFastUndecided;
      ++place;
    }
    list = list.subspan(place);
  }
}

}  // namespace veritope::internal
