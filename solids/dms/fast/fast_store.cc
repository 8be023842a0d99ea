// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fast/fast_store_internal.h"

#include <algorithm>
#include <utility>

namespace veritope::internal {
namespace {

constexpr double kLeastControl = 0x1p-300, kMostControl = 0x1p300;

}  // namespace

FastStore::FastStore(const DmsModel& model, const DmsEvaluator& evaluator, FastCells& cells,
                     bool with_gradient, std::size_t max_bytes)
    : model_(model),
      evaluator_(evaluator),
      cells_(cells),
      with_gradient_(with_gradient),
      max_bytes_(max_bytes),
      greatest_(model.num_components()) {
  for (std::size_t i = 0; i < model.control.values.size(); ++i) {
    const Rational& c = model.control.values[i];
    double& most = greatest_[i % greatest_.size()];
    most = std::max({most, round_up(c), -round_down(c)});
  }
  for (const double most : greatest_)
    is_in_range_ = is_in_range_ && (most == 0 || (most >= kLeastControl && most <= kMostControl));
}

// Then its sets of knots have their hulls inside of it, and no value elsewhere. Thin tetrahedra, whose numbers are out
// of range, would otherwise keep their neighbours from having tables.
bool FastStore::is_collapsed(std::uint32_t t) const {
  const TetrahedronCorners& corners = model_.tetrahedra[t];
  return std::all_of(corners.begin(), corners.end(),
                     [&](std::uint32_t v) { return model_.clouds[v].size() == 1; });
}

const FastTables* FastStore::tables(std::uint32_t t) {
  const auto found = tables_.find(t);
  if (found != tables_.end()) return found->second.get();
  auto made = make_fast_tables(model_, evaluator_, t, with_gradient_, greatest_);
  std::unique_ptr<FastTables> kept;
  if (made) kept = std::make_unique<FastTables>(std::move(*made)), bytes_ += kept->bytes();
  return tables_.emplace(t, std::move(kept)).first->second.get();
}

const FastRegion* FastStore::region(std::uint32_t t) {
  const auto found = regions_.find(t);
  if (found != regions_.end()) return found->second.get();
  if (bytes_ > max_bytes_) regions_.clear(), tables_.clear(), bytes_ = 0;
  auto made = make_region(t);
  if (made) bytes_ += made->bytes();
  return regions_.emplace(t, std::move(made)).first->second.get();
}

std::unique_ptr<FastRegion> FastStore::make_region(std::uint32_t t) {
  const FastCell* const at = is_in_range_ ? cells_.cell(t) : nullptr;
  if (at == nullptr) return nullptr;
  auto made = std::make_unique<FastRegion>();
  const auto add = [&](std::uint32_t other) {
    const FastTables* const from = tables(other);
    if (from == nullptr) return false;
    auto unit = make_fast_unit(*from, model_.tetrahedra[other], *at, model_.tetrahedra[t],
                               model_.num_components());
    if (!unit) return true;
    made->num_tops += unit->tops.size();
    made->scratch = std::max(made->scratch, fast_scratch_size(unit->unit));
    made->units.push_back(std::move(unit));
    return true;
  };
  if (!add(t)) return nullptr;
  for (const std::uint32_t other : evaluator_.near(evaluator_.corner_box(t)))
    if (other != t && !is_collapsed(other) && !add(other)) return nullptr;
  return made;
}

}  // namespace veritope::internal
