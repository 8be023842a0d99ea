// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/interval_boxes/c3_exceptions.h"

#include <algorithm>
#include <cmath>

#include "solids/interval_boxes/box_sets_internal.h"
#include "solids/interval_boxes/box_union.h"
#include "solids/interval_boxes/cover_check_internal.h"
#include "solids/base/box_hierarchy.h"

namespace veritope {
namespace {

using Indices = std::vector<std::uint32_t>;

class Explainer {
 public:
  Explainer(BoundaryModel& model, std::vector<Box3d> boxes, const ExceptionOptions& options)
      : model_(model), boxes_(std::move(boxes)), tree_(boxes_), options_(options) {}

  C3Failure explain(const BoxOffence& offence) {
    C3Failure out;
    out.i = offence.boxes[0], out.j = offence.boxes[1];
    if (offence.why == BoxOffence::Why::kTouching) {
      out.exception = C3Exception::kContact;
      out.resized = resized(out.i, out.j);
      if (!out.resized) out.resized = resized(out.j, out.i);
      return out;
    }
    const BoxTrace around = trace_of(surroundings(out.i, out.j));
    out.exception = around.kind == BoxTrace::Kind::kSurface && !around.is_connected
                        ? C3Exception::kSelfDistance
                    : would_meet(out.i, out.j) ? C3Exception::kSmallFeature
                                               : C3Exception::kVaryingSize;
    if (offence.why == BoxOffence::Why::kMissed) out.sub_collection = sub_collection(out.i, out.j);
    return out;
  }

 private:
  BoxTrace trace_of(const Box3d& box) { return trace(model_, box, options_.conditions.trace); }

  // Half the size of the smaller box around both, so that V may leave a flat box and come back.
  Box3d surroundings(std::uint32_t i, std::uint32_t j) const {
    const int n = model_.dimension();
    const double margin = 0.5 * std::min(size_of(boxes_[i], n), size_of(boxes_[j], n));
    Box3d out = hull(boxes_[i], boxes_[j]);
    for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k)
      out.lo[k] -= margin, out.hi[k] += margin;
    return out;
  }

  // Cubes of the smaller box's size around both middles.
  bool would_meet(std::uint32_t i, std::uint32_t j) const {
    const int n = model_.dimension();
    const double size = std::min(size_of(boxes_[i], n), size_of(boxes_[j], n));
    const Point3d a = approx_centre(boxes_[i]), b = approx_centre(boxes_[j]);
    for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k)
      if (std::abs(a[k] - b[k]) > size) return false;
    return true;
  }

  Indices neighbours(const Box3d& box) const {
    Indices out;
    tree_.visit([&](const Box3d& b) { return meets(b, box); },
                [&](std::uint32_t k) { out.push_back(k); });
    std::sort(out.begin(), out.end());
    return out;
  }

  Indices sub_collection(std::uint32_t i, std::uint32_t j) {
    const Box3d common = common_part(boxes_[i], boxes_[j]);
    Indices near = neighbours(hull(boxes_[i], boxes_[j]));
    std::erase_if(near, [&](std::uint32_t k) { return k == i || k == j; });
    const auto distance = [&](std::uint32_t k) {
      const Point3d a = approx_centre(boxes_[k]), b = approx_centre(common);
      return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    };
    std::sort(near.begin(), near.end(),
              [&](std::uint32_t a, std::uint32_t b) { return distance(a) < distance(b); });
    if (near.size() > options_.max_candidates) near.resize(options_.max_candidates);
    // Smaller collections first.
    for (std::size_t size = 1; size <= options_.max_sub_collection; ++size) {
      Indices chosen;
      if (choose(near, 0, size, i, j, &chosen)) {
        std::sort(chosen.begin(), chosen.end());
        return chosen;
      }
    }
    return {};
  }
  bool choose(const Indices& from, std::size_t at, std::size_t left, std::uint32_t i,
              std::uint32_t j, Indices* chosen) {
    if (left == 0) return mends(*chosen, i, j);
    for (; at + left <= from.size(); ++at) {
      chosen->push_back(from[at]);
      if (choose(from, at + 1, left - 1, i, j, chosen)) return true;
      chosen->pop_back();
    }
    return false;
  }

  // Remark 3.1.
  bool mends(const Indices& chosen, std::uint32_t i, std::uint32_t j) {
    const auto parts = [&](const Box3d& within) {
      std::vector<Box3d> out;
      for (const std::uint32_t k : chosen)
        if (meets(boxes_[k], within)) out.push_back(common_part(boxes_[k], within));
      return out;
    };
    const auto in_both = parts(common_part(boxes_[i], boxes_[j]));
    if (in_both.empty() || !is_ball(in_both)) return false;
    std::vector<Box3d> all;
    for (const std::uint32_t k : chosen) all.push_back(boxes_[k]);
    for (const auto& set : {parts(boxes_[i]), parts(boxes_[j]), all})
      if (set.empty() || !is_ball_with_c2(model_, set, options_.conditions.trace)) return false;
    return true;
  }
  bool is_ball(const std::vector<Box3d>& boxes) const {
    for (const Box3d& b : boxes)
      if (!is_solid(b, model_.dimension())) return false;
    const auto topology = union_topology(boxes, model_.dimension());
    return topology && topology->is_ball();
  }

  std::optional<C3Failure::Resized> resized(std::uint32_t i, std::uint32_t j) {
    const int n = model_.dimension();
    double step = std::exp2(std::floor(std::log2(size_of(boxes_[i], n)))) / 2;
    for (int halving = 0; halving < options_.max_halvings; ++halving) {
      step /= 2;
      for (const double by : {step, -step}) {
        const auto box = moved(i, j, by);
        if (!box || !is_solid(*box, n) || !keeps_relations(i, j, *box)) continue;
        return C3Failure::Resized{model_.from_forest(*box),
                                  std::ldexp(by, -model_.forest().scale())};
      }
    }
    return std::nullopt;
  }
  // Box i with the sides on which it touches j moved outward by a step; nothing if a sum is not exact.
  std::optional<Box3d> moved(std::uint32_t i, std::uint32_t j, double step) const {
    Box3d out = boxes_[i];
    for (std::size_t k = 0; k < static_cast<std::size_t>(model_.dimension()); ++k) {
      double* side = nullptr;
      double by = 0;
      if (boxes_[i].hi[k] == boxes_[j].lo[k]) side = &out.hi[k], by = step;
      if (boxes_[i].lo[k] == boxes_[j].hi[k]) side = &out.lo[k], by = -step;
      if (side == nullptr) continue;
      const double before = *side;
      *side += by;
      if (*side - before != by || *side - by != before) return std::nullopt;
    }
    return out;
  }
  bool keeps_relations(std::uint32_t i, std::uint32_t j, const Box3d& box) {
    Indices before = neighbours(boxes_[i]), after = neighbours(box);
    std::erase(before, j), std::erase(after, j);
    if (before != after || !trace_of(box).is_disk()) return false;
    const bool shrank = !meets(box, boxes_[j]);
    if (!shrank && !has_c3(box, boxes_[j])) return false;
    for (const std::uint32_t k : before) {
      if (k == i || !is_solid(common_part(boxes_[i], boxes_[k]), model_.dimension())) continue;
      if (!is_solid(common_part(box, boxes_[k]), model_.dimension())) return false;
      if (has_c3(boxes_[i], boxes_[k]) && !has_c3(box, boxes_[k])) return false;
    }
    if (!shrank) return true;
    std::vector<Box3d> all = boxes_;
    all[i] = box;
    const internal::CoverOptions cover{options_.conditions.max_pieces, 1};
    return internal::decide_c1(model_, all, cover).answer == Answer::kTrue;
  }
  bool has_c3(const Box3d& a, const Box3d& b) {
    const Box3d common = common_part(a, b);
    return is_solid(common, model_.dimension()) && trace_of(common).is_disk();
  }

  BoundaryModel& model_;
  std::vector<Box3d> boxes_;
  BoxHierarchy tree_;
  const ExceptionOptions& options_;
};

}  // namespace

const char* to_string(C3Exception exception) {
  switch (exception) {
    case C3Exception::kSelfDistance: return "self-distance";
    case C3Exception::kVaryingSize: return "varying size";
    case C3Exception::kSmallFeature: return "small feature";
    case C3Exception::kContact: return "contact";
  }
  return "";
}

std::vector<C3Failure> explain_c3(BoundaryModel& model, std::span<const Box3d> boxes,
                                  const ConditionResult& c3, const ExceptionOptions& options) {
  std::vector<Box3d> scaled;
  for (const Box3d& b : boxes) scaled.push_back(model.to_forest(b).value());
  Explainer explainer(model, std::move(scaled), options);
  std::vector<C3Failure> out;
  for (const BoxOffence& o : c3.offences)
    if (o.is_refutation() && out.size() < options.max_failures) out.push_back(explainer.explain(o));
  return out;
}

bool is_ball_with_c2(BoundaryModel& model, std::span<const Box3d> boxes,
                     const TraceOptions& options) {
  if (boxes.size() > kMaxBallBoxes) return false;
  for (const Box3d& b : boxes)
    if (!is_solid(b, model.dimension())) return false;
  const auto topology = union_topology(boxes, model.dimension());
  if (!topology || !topology->is_ball()) return false;
  // chi of V in the union, by inclusion and exclusion; and whether the parts in single boxes hang together.
  int euler = 0;
  const std::size_t n = boxes.size();
  std::vector<std::size_t> part(n);
  std::vector<bool> is_met(n, false);
  for (std::size_t k = 0; k < n; ++k) part[k] = k;
  for (unsigned set = 1; set < 1u << n; ++set) {
    std::optional<Box3d> common;
    std::vector<std::size_t> members;
    for (std::size_t k = 0; k < n; ++k) {
      if ((set >> k & 1) == 0) continue;
      members.push_back(k);
      if (members.size() > 1 && (!common || !meets(*common, boxes[k])))
        common = std::nullopt;
      else
        common = members.size() == 1 ? boxes[k] : common_part(*common, boxes[k]);
      if (!common) break;
    }
    if (!common) continue;
    if (!is_solid(*common, model.dimension())) return false;
    const BoxTrace t = trace(model, *common, options);
    if (t.kind == BoxTrace::Kind::kUndecided) return false;
    if (t.is_missed()) continue;
    euler += members.size() % 2 == 1 ? t.euler : -t.euler;
    if (members.size() == 1 && !t.is_connected) return false;
    if (members.size() == 1) is_met[members[0]] = true;
    if (members.size() == 2) {
      const std::size_t from = part[members[1]], to = part[members[0]];
      std::replace(part.begin(), part.end(), from, to);
    }
  }
  std::optional<std::size_t> only;
  for (std::size_t k = 0; k < n; ++k) {
    if (!is_met[k]) continue;
    if (only && *only != part[k]) return false;
    only = part[k];
  }
  return only.has_value() && euler == 1;
}

}  // namespace veritope
