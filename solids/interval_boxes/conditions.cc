// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/interval_boxes/conditions.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "solids/interval_boxes/box_sets_internal.h"
#include "solids/interval_boxes/cover_check_internal.h"

namespace veritope {

const char* name_of(PaperCondition condition) {
  constexpr const char* kNames[] = {"A", "B1", "B2", "C1", "C2", "C3", "C3*"};
  return kNames[static_cast<std::size_t>(condition)];
}

const char* to_string(Answer answer) {
  return answer == Answer::kTrue ? "true" : answer == Answer::kFalse ? "false" : "undecided";
}

std::string to_string(const BoxOffence& offence) {
  std::string out;
  for (const std::uint32_t b : offence.boxes) out += (out.empty() ? "" : ", ") + std::to_string(b);
  if (!out.empty()) out = (offence.boxes.size() == 1 ? "box " : "boxes ") + out + ": ";
  using Why = BoxOffence::Why;
  switch (offence.why) {
    case Why::kTouching: out += "they touch without a common interior"; break;
    case Why::kMissed: out += "V misses it"; break;
    case Why::kEuler:
      out += "V inside has the Euler characteristic " + std::to_string(offence.euler);
      break;
    case Why::kUncovered: out += "V is not covered"; break;
    case Why::kUndecided: out += "not decided"; break;
    case Why::kTooMany: out += "more distinct intersections than the cap"; break;
  }
  const auto number = [](double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", x);
    return std::string(text);
  };
  out += ", at ";
  for (std::size_t k = 0; k < 3; ++k)
    out += (k > 0 ? " x [" : "[") + number(offence.place.lo[k]) + ", " +
           number(offence.place.hi[k]) + "]";
  return out;
}

namespace internal {

void Findings::add(BoxOffence offence) {
  ++(offence.is_refutation() ? result_.num_false : result_.num_undecided);
  auto& list = offence.is_refutation() ? refuted_ : undecided_;
  if (list.size() < max_listed_) list.push_back(std::move(offence));
}

ConditionResult Findings::finish() {
  result_.answer = result_.num_false > 0       ? Answer::kFalse
                   : result_.num_undecided > 0 ? Answer::kUndecided
                                               : Answer::kTrue;
  result_.offences = std::move(refuted_);
  for (BoxOffence& o : undecided_)
    if (result_.offences.size() < max_listed_) result_.offences.push_back(std::move(o));
  return std::move(result_);
}

}  // namespace internal

namespace {

using internal::Findings;
using Why = BoxOffence::Why;

class Decider {
 public:
  // boxes: in the forest's coordinates.
  Decider(BoundaryModel& model, std::vector<Box3d> boxes, const ConditionOptions& options)
      : model_(model),
        boxes_(std::move(boxes)),
        options_(options),
        cells_left_(options.max_cells) {}

  PaperConditions run() {
    PaperConditions out;
    const auto at = [&](PaperCondition c) -> ConditionResult& {
      return out.results[static_cast<std::size_t>(c)];
    };
    at(PaperCondition::kA) =
        in_model_units(decide_a(boxes_, model_.dimension(), options_.max_listed));
    const internal::CoverOptions cover{options_.max_pieces, options_.max_listed};
    at(PaperCondition::kB1) = in_model_units(internal::decide_b1(model_, boxes_, cover));
    at(PaperCondition::kC1) = in_model_units(internal::decide_c1(model_, boxes_, cover));
    at(PaperCondition::kB2) = b2();
    // C2 and C3 are the parts of C3* with one and with two boxes.
    at(PaperCondition::kC2) = each_box();
    at(PaperCondition::kC3) = each_pair();
    const PaperCondition part = out[PaperCondition::kC2].answer == Answer::kFalse
                                    ? PaperCondition::kC2
                                    : PaperCondition::kC3;
    const bool is_refuted = out[part].answer == Answer::kFalse;
    if (!is_refuted || !options_.stops_at_refutation)
      at(PaperCondition::kC3Star) = each_intersection();
    if (is_refuted && out[PaperCondition::kC3Star].answer != Answer::kFalse)  // none, or the cap
      at(PaperCondition::kC3Star) = out[part];
    return out;
  }

 private:
  ConditionResult in_model_units(ConditionResult result) {
    for (BoxOffence& o : result.offences) o.place = model_.from_forest(o.place);
    return result;
  }

  bool is_done(const Findings& found) const {
    return options_.stops_at_refutation && found.is_refuted();
  }

  ConditionResult b2() {
    Findings out(options_.max_listed);
    for (std::uint32_t i = 0; i < boxes_.size() && !is_done(out); ++i) {
      out.count();
      if (is_met(model_, boxes_[i])) continue;
      const BoxTrace t = trace_of(boxes_[i]);
      if (t.kind == BoxTrace::Kind::kSurface) continue;
      out.add(
          {t.is_missed() ? Why::kMissed : Why::kUndecided, {i}, model_.from_forest(boxes_[i]), 0});
    }
    return out.finish();
  }

  void judge(const Box3d& box, const std::vector<std::uint32_t>& set, Findings* out) {
    out->count();
    const auto place = model_.from_forest(box);
    if (!is_solid(box, model_.dimension())) {
      out->add({Why::kTouching, set, place, 0});
      return;
    }
    const BoxTrace t = trace_of(box);
    if (t.is_disk()) return;
    const Why why = t.is_missed() ? Why::kMissed : t.is_no_disk() ? Why::kEuler : Why::kUndecided;
    out->add({why, set, place, t.euler});
  }

  ConditionResult each_box() {
    Findings out(options_.max_listed);
    for (std::uint32_t i = 0; i < boxes_.size() && !is_done(out); ++i) judge(boxes_[i], {i}, &out);
    return out.finish();
  }
  ConditionResult each_pair() {
    Findings out(options_.max_listed);
    for (const auto& [i, j] : meeting_pairs(boxes_)) {
      if (is_done(out)) break;
      judge(common_part(boxes_[i], boxes_[j]), {i, j}, &out);
    }
    return out.finish();
  }
  ConditionResult each_intersection() {
    Findings out(options_.max_listed);
    const DistinctIntersections all = distinct_intersections(boxes_, options_.max_intersections);
    if (!all.is_complete) {
      out.add({Why::kTooMany, {}, model_.from_forest(boxes_[0]), 0});
      return out.finish();
    }
    for (const auto& item : all.items) {
      if (is_done(out)) break;
      judge(item.box, item.boxes, &out);
    }
    return out.finish();
  }

  // Pairs and cliques repeat boxes: each is traced once.
  const BoxTrace& trace_of(const Box3d& box) {
    const auto [it, is_new] = traces_.try_emplace(
        std::array<double, 6>{box.lo[0], box.lo[1], box.lo[2], box.hi[0], box.hi[1], box.hi[2]});
    if (!is_new || cells_left_ == 0) return it->second;  // a new one: undecided
    TraceOptions options = options_.trace;
    options.max_cells = std::min<std::uint64_t>(options.max_cells, cells_left_);
    it->second = trace(model_, box, options);
    cells_left_ -= std::min<std::uint64_t>(it->second.cells, cells_left_);
    return it->second;
  }

  BoundaryModel& model_;
  std::vector<Box3d> boxes_;
  const ConditionOptions& options_;
  std::uint64_t cells_left_;
  std::map<std::array<double, 6>, BoxTrace> traces_;
};

}  // namespace

ConditionResult decide_a(std::span<const Box3d> boxes, int dimension, std::size_t max_listed) {
  Findings out(max_listed);
  for (const auto& [i, j] : meeting_pairs(boxes)) {
    out.count();
    const Box3d common = common_part(boxes[i], boxes[j]);
    if (!is_solid(common, dimension)) out.add({Why::kTouching, {i, j}, common, 0});
  }
  return out.finish();
}

Result<PaperConditions> decide_conditions(BoundaryModel& model, std::span<const Box3d> boxes,
                                          const ConditionOptions& options) {
  if (boxes.empty()) return Error{Code::kEmpty, {}, "a set without a box"};
  std::vector<Box3d> scaled;
  for (const Box3d& b : boxes) {
    const auto box = model.to_forest(b);
    const std::string name = "box " + std::to_string(scaled.size());
    if (!box)
      return Error{Code::kBadArgument, {}, name + ": a coordinate is not finite or out of range"};
    if (!is_solid(*box, model.dimension()))
      return Error{Code::kBadArgument, {}, name + ": a side has no positive length"};
    scaled.push_back(*box);
  }
  return Decider(model, std::move(scaled), options).run();
}

}  // namespace veritope
