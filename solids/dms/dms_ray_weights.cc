// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_ray_weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "robust/base/check.h"
#include "robust/base/fp_guard.h"
#include "solids/dms/dms_ray_plan_internal.h"

namespace veritope {
namespace {

using internal::RayCell;
using internal::RayClip;
using internal::RayCoordinate;
using internal::RayNode;
using internal::RayPlan;
using internal::RaySpan;
using internal::RayTerm;

constexpr double kUnit = internal::kRayUnit;
constexpr std::size_t kMostMoments = kMaxDmsDegree + 1;

// Part of a ray in the domain.
struct RayPart {
  double begin = 0, end = 0;
  double error = 0;  // of the end, and of the begin in one tetrahedron
};
// A bound of the part in one tetrahedron.
struct RayEnd {
  double t = 0, error = 0;
};

// Moments of a spline along the parts of a ray in the domain, integrals of s^k M dt: the exact ones differ from them
// by at most `error`, and are at most the exact moment 0, up to roundings that errors pay for, because |s| <= 1 there.
struct RayMoments {
  std::array<double, kMostMoments> at{};
  double error = 0;
  bool is_zero = true;

  double most() const { return 1.01 * (std::abs(at[0]) + 2 * error); }
};

// Coordinates of one ray.
struct RayPlace {
  double at = 0, along = 0, error = 0;  // of at, plus that of along
  RayPlace(const RayCoordinate& c, double i, double j)
      : at(c.at.on(i, j)), along(c.along), error(c.at.error + c.along_error) {}
  double size() const { return std::abs(at) + std::abs(along); }
};

// One ray after another. The sums of weights lie in an array for all control points; few of them are not zero.
class RayCalculator {
 public:
  RayCalculator(const DmsModel& model, double tolerance)
      : is_separate_(model.control.is_separate),
        degree_(model.degree),
        tolerance_(tolerance),
        weights_(model.num_control()),
        is_touched_(model.num_control()) {}

  // Appends the ray; false, and nothing is appended, if its error is not known to be small enough.
  bool add(std::span<const RayPlan* const> plans, std::size_t column, std::size_t row,
           DmsRayRow& out) {
    i_ = static_cast<double>(column), j_ = static_cast<double>(row);
    if (!find_parts(plans, column)) return false;
    error_ = 0;
    size_ = 0;
    num_terms_ = 0;
    bool is_sure = true;
    if (!parts_.empty())
      for (const RayPlan* plan : plans)
        is_sure = is_sure && (!has(*plan, column) || add_plan(*plan));
    // Each weight is a sum of at most num_terms_ terms.
    const double error = 1.0000001 * (error_ + static_cast<double>(num_terms_) * kUnit * size_) +
                         (num_terms_ == 0 ? 0 : 0x1p-1000);
    is_sure = is_sure && error <= tolerance_;
    for (const std::uint32_t control : touched_) {
      if (is_sure) {
        out.control.push_back(control);
        out.weight.push_back(weights_[control]);
      }
      weights_[control] = 0;
      is_touched_[control] = 0;
    }
    touched_.clear();
    if (is_sure) out.error.push_back(error), out.first.push_back(out.control.size());
    return is_sure;
  }

 private:
  static bool has(const RayPlan& plan, std::size_t column) {
    return plan.first_column <= column && column < plan.end_column;
  }

  // Where the ray is in the domain: unions of the parts in its tetrahedra. Neighbours have a bound in common, up to
  // errors; gaps that the errors of both sides can explain are closed. What is added or missing lies near bounds of
  // tetrahedra's parts, within twice the error of each, and has at most three times its length.
  bool find_parts(std::span<const RayPlan* const> plans, std::size_t column) {
    parts_.clear();
    ends_.clear();
    for (const RayPlan* plan : plans) {
      if (!has(*plan, column)) continue;
      move_to(*plan);
      RaySpan span = whole_;
      const RayClip clip = clip_ray(plan->cells[0], place_i_, place_j_, span);
      if (clip == RayClip::kUnsure) return false;
      if (clip == RayClip::kMiss) continue;
      const RayPart part{plan->centre + plan->radius * span.begin,
                         plan->centre + plan->radius * span.end,
                         1.0000001 * (plan->radius * span.slack + 16 * kUnit)};
      parts_.push_back(part);
      ends_.push_back({part.begin, part.error});
      ends_.push_back({part.end, part.error});
    }
    std::sort(parts_.begin(), parts_.end(),
              [](const RayPart& a, const RayPart& b) { return a.begin < b.begin; });
    std::size_t count = 0;
    for (const RayPart& part : parts_) {
      RayPart* const last = count > 0 ? &parts_[count - 1] : nullptr;
      if (last == nullptr || part.begin > last->end + (last->error + part.error))
        parts_[count++] = part;
      else if (last->end < part.end)
        last->end = part.end, last->error = part.error;
    }
    parts_.resize(count);
    return true;
  }
  // What the domain's errors add to a part of the ray, from t = begin to t = end, at most.
  double error_of_ends(double begin, double end) const {
    double error = 0;
    for (const RayEnd& e : ends_)
      if (begin - 4 * e.error <= e.t && e.t <= end + 4 * e.error) error += 4 * e.error;
    return error;
  }

  // Coordinates of the ray in the plan, and the plan's parameters of t = 0 and 1, cut to its knots.
  void move_to(const RayPlan& plan) {
    place_i_ = i_ - plan.centre_column;
    place_j_ = j_ - plan.centre_row;
    whole_ = {std::max(-1.0, -plan.centre / plan.radius),
              std::min(1.0, (1 - plan.centre) / plan.radius), 0};
  }

  bool add_plan(const RayPlan& plan) {
    move_to(plan);
    moments_.resize(plan.cells.size() + plan.nodes.size());
    bool is_zero = true;
    for (std::size_t c = 0; c < plan.cells.size(); ++c) {
      if (!set_cell(plan, plan.cells[c], moments_[c])) return false;
      is_zero = is_zero && moments_[c].is_zero;
    }
    if (is_zero) return true;
    for (std::size_t n = 0; n < plan.nodes.size(); ++n)
      set_node(plan.nodes[n], moments_[plan.cells.size() + n]);
    for (const RayTerm& term : plan.terms) add_term(term);
    return true;
  }

  bool set_cell(const RayPlan& plan, const RayCell& cell, RayMoments& out) const {
    out.is_zero = true;
    RaySpan span = whole_;
    const RayClip clip = clip_ray(cell, place_i_, place_j_, span);
    if (clip != RayClip::kHit) return clip == RayClip::kMiss;
    const double margin = plan.radius * span.slack;
    const double slack = span.slack + 16 * kUnit +
                         1.0000001 *
                             error_of_ends(plan.centre + plan.radius * span.begin - margin,
                                           plan.centre + plan.radius * span.end + margin) /
                             plan.radius;
    double length = 0;
    for (const RayPart& part : parts_) {
      const double first = (part.begin - plan.centre) / plan.radius,
                   last = (part.end - plan.centre) / plan.radius;
      if (first > span.end + slack || last < span.begin - slack) continue;
      if (out.is_zero) out.at.fill(0);
      out.is_zero = false;
      const double a = std::max(span.begin, first), b = std::max(a, std::min(span.end, last));
      length += b - a;
      double low = a, high = b;
      for (int k = 0; k <= degree_; ++k) {
        out.at[static_cast<std::size_t>(k)] += plan.radius * cell.height * (high - low) / (k + 1);
        low *= a;
        high *= b;
      }
    }
    // Powers up to 10 of numbers up to 1.01, their differences, and sums over the parts: less than 40 u for each part.
    out.error = 1.0000001 * plan.radius *
                ((cell.height + cell.height_error) *
                     (slack + 40 * kUnit * static_cast<double>(parts_.size())) +
                 cell.height_error * length);
    return true;
  }

  void set_node(const RayNode& node, RayMoments& out) const {
    out.is_zero = true;
    const auto num_moments = static_cast<std::size_t>(degree_ - node.degree + 1);
    for (std::size_t m = 0; m < 4; ++m) {
      if (node.child[m] < 0) continue;
      const RayMoments& part = moments_[static_cast<std::size_t>(node.child[m])];
      if (part.is_zero) continue;
      if (out.is_zero) {
        out.is_zero = false;
        out.at.fill(0);
        out.error = 0;
      }
      const RayPlace place(node.coordinate[m], place_i_, place_j_);
      for (std::size_t k = 0; k < num_moments; ++k)
        out.at[k] += place.at * part.at[k] + place.along * part.at[k + 1];
      out.error += error_of(place, part);
    }
  }
  // The error of a coordinate times moments: four such products with their sums take less than 16 roundings.
  static double error_of(const RayPlace& place, const RayMoments& part) {
    const double size = place.size();
    return 1.0000001 *
           ((size + place.error) * part.error + (place.error + 16 * kUnit * size) * part.most());
  }

  void add_term(const RayTerm& term) {
    const RayMoments& part = moments_[static_cast<std::size_t>(term.set)];
    if (part.is_zero) return;
    if (is_separate_) {
      add_weight(term.control[0], term.volume * part.at[0]);
      error_ += (term.volume + term.volume_error) * part.error +
                (term.volume_error + 4 * kUnit * term.volume) * part.most();
      return;
    }
    for (std::size_t m = 0; m < 4; ++m) {
      const RayPlace place(term.coordinate[m], place_i_, place_j_);
      const double value = place.at * part.at[0] + place.along * part.at[1];
      add_weight(term.control[m], term.volume * value);
      const double error = error_of(place, part);
      error_ += (term.volume + term.volume_error) * error +
                (term.volume_error + 4 * kUnit * term.volume) * (std::abs(value) + error);
    }
  }
  void add_weight(std::uint32_t control, double weight) {
    if (is_touched_[control] == 0) {
      is_touched_[control] = 1;
      touched_.push_back(control);
    }
    weights_[control] += weight;
    size_ += std::abs(weight);
    ++num_terms_;
  }

  const bool is_separate_;
  const int degree_;
  const double tolerance_;
  std::vector<double> weights_;
  std::vector<std::uint8_t> is_touched_;
  std::vector<std::uint32_t> touched_;
  std::vector<RayPart> parts_;
  std::vector<RayEnd> ends_;  // of the parts in each tetrahedron
  std::vector<RayMoments> moments_;
  double i_ = 0, j_ = 0, error_ = 0, size_ = 0;
  // In the plan that is used: the ray, and t from 0 to 1 cut to the plan's knots.
  double place_i_ = 0, place_j_ = 0;
  RaySpan whole_;
  std::size_t num_terms_ = 0;
};

}  // namespace

class DmsRayWeights::Body {
 public:
  Body(const DmsModel& model, const DmsRayGrid& grid, double tolerance)
      : model_(model),
        grid_(grid),
        tolerance_(tolerance),
        evaluator_(model),
        integrator_(evaluator_) {
    VT_CHECK(grid.is_sound() && tolerance > 0, "a grid of rays, and a tolerance");
    const ScopedDefaultFp fp;
    plans_ = internal::make_ray_plans(model, evaluator_, grid);
  }

  const DmsRayGrid& grid() const { return grid_; }

  DmsRayRow row(std::size_t j) const {
    VT_CHECK(j < grid_.rows, "a row of the grid");
    const ScopedDefaultFp fp;
    std::vector<const RayPlan*> of_row;
    for (const RayPlan& plan : plans_)
      if (plan.first_row <= j && j < plan.end_row) of_row.push_back(&plan);
    DmsRayRow out;
    out.first.push_back(0);
    RayCalculator calculator(model_, tolerance_);
    std::vector<const RayPlan*> of_tile;
    for (std::size_t i = 0; i < grid_.columns; ++i) {
      if (i % kTile == 0) {
        of_tile.clear();
        for (const RayPlan* plan : of_row)
          if (plan->first_column < i + kTile && i < plan->end_column) of_tile.push_back(plan);
      }
      if (!calculator.add(of_tile, i, j, out)) add_exactly(i, j, out);
    }
    return out;
  }

  std::vector<Range> ranges() const {
    std::vector<Range> out(model_.num_control(),
                           Range{std::numeric_limits<std::uint32_t>::max(), 0,
                                 std::numeric_limits<std::uint32_t>::max(), 0});
    for (const RayPlan& plan : plans_)
      for (const RayTerm& term : plan.terms)
        for (const std::uint32_t control : term.control) {
          Range& r = out[control];
          r.first_column = std::min(r.first_column, plan.first_column);
          r.end_column = std::max(r.end_column, plan.end_column);
          r.first_row = std::min(r.first_row, plan.first_row);
          r.end_row = std::max(r.end_row, plan.end_row);
        }
    for (Range& r : out)
      if (r.end_row == 0) r = {};
    return out;
  }

 private:
  static constexpr std::size_t kTile = 16;

  void add_exactly(std::size_t i, std::size_t j, DmsRayRow& out) const {
    const std::lock_guard lock(mutex_);
    double error = 0;
    for (const DmsWeight& w : integrator_.weights(grid_.ray(i, j))) {
      const double weight = nearest_double(w.weight);
      out.control.push_back(static_cast<std::uint32_t>(w.control));
      out.weight.push_back(weight);
      error += std::abs(weight) * (2 * kUnit) + 0x1p-1000;
    }
    out.error.push_back(error);
    out.first.push_back(out.control.size());
    ++out.num_exact;
  }

  const DmsModel& model_;
  const DmsRayGrid grid_;
  const double tolerance_;
  mutable std::mutex mutex_;  // of the two below
  mutable DmsEvaluator evaluator_;
  mutable DmsLineIntegrator integrator_;
  std::vector<RayPlan> plans_;
};

DmsRayWeights::DmsRayWeights(const DmsModel& model, const DmsRayGrid& grid, double tolerance)
    : body_(std::make_unique<Body>(model, grid, tolerance)) {}
DmsRayWeights::~DmsRayWeights() = default;
DmsRayWeights::DmsRayWeights(DmsRayWeights&&) noexcept = default;
const DmsRayGrid& DmsRayWeights::grid() const { return body_->grid(); }
DmsRayRow DmsRayWeights::row(std::size_t j) const { return body_->row(j); }
std::vector<DmsRayWeights::Range> DmsRayWeights::ranges() const { return body_->ranges(); }

}  // namespace veritope
