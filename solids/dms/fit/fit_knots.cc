// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fit/fit_knots.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solids/dms/dms_admissible.h"
#include "solids/dms/fit/fit_constraint.h"
#include "solids/dms/fit/fit_shape.h"
#include "solids/dms/fit/fit_solver.h"

namespace veritope {
namespace {

constexpr int kTries = 5;              // of one step, with more damping each time
constexpr int kMaxHalvings = 6;        // of a vertex' step, before it is zero
constexpr double kLeastGain = 2e-3;    // of the squares, for a step to be followed by another
constexpr double kLeastShare = 0.02;   // of the mean error at a vertex, for its knots to move
constexpr double kLeastShape = 0.004;  // d / longest edge^3; a regular tetrahedron has 0.71
constexpr double kLeastDistance = 1.0 / 256;

// A number of one knot that may move, or of a whole cloud: `index` 0.
struct KnotUnknown {
  std::uint32_t vertex = 0;
  int index = 0;
  std::size_t direction = 0;
};

double distance(const DmsPoint& a, const DmsPoint& b) {
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double d = nearest_double(a[c] - b[c]);
    sum += d * d;
  }
  return std::sqrt(sum);
}

class KnotStep {
 public:
  KnotStep(const FitState& state, FitKnots knots, std::span<const DmsPlane> features)
      : state_(state),
        complex_(state.model.tetrahedra, static_cast<std::uint32_t>(state.model.clouds.size())),
        constraints_(fit_constraints(state.model, complex_, features)) {
    choose(knots);
    build(knots);
  }

  /// The state after the step with this damping; nothing if no knot moves.
  std::optional<FitState> run(double damping) const {
    std::vector<double> damped(num_linear_ + unknowns_.size());
    std::fill(damped.begin() + static_cast<std::ptrdiff_t>(num_linear_), damped.end(), damping);
    const std::vector<double> step = solve_damped(rows_, smooth_, damped, state_.residuals);
    std::vector<double> share(state_.model.clouds.size(), 1);
    for (int i = 0;; ++i) {
      FitState next = moved(std::span(step).subspan(num_linear_), share);
      const std::vector<bool> bad = inadmissible(next.model);
      bool is_good = true;
      for (std::size_t v = 0; v < bad.size(); ++v)
        if (bad[v] && share[v] > 0) is_good = false, share[v] = i < kMaxHalvings ? share[v] / 2 : 0;
      if (!is_good) continue;
      if (next.model.clouds == state_.model.clouds) return std::nullopt;
      move_fit_points(next.model, next.points);
      refit(next);
      return next;
    }
  }
  bool is_empty() const { return unknowns_.empty(); }

 private:
  // The knots of vertices around which there is more than a little of the error.
  void choose(FitKnots knots) {
    const std::vector<double> errors = state_.by_tetrahedron();
    std::vector<double> at(state_.model.clouds.size());
    for (std::size_t t = 0; t < errors.size(); ++t)
      for (const std::uint32_t v : state_.model.tetrahedra[t]) at[v] += errors[t];
    const double least = kLeastShare * 4 * state_.square_sum / static_cast<double>(at.size());
    const int last = knots == FitKnots::kClouds ? state_.model.degree - 1 : 0;
    for (std::uint32_t v = 0; v < at.size(); ++v) {
      first_unknown_.push_back(unknowns_.size());
      if (at[v] <= least) continue;
      for (int i = 0; i <= last; ++i)
        for (std::size_t d = 0; d < constraints_[v].num_directions(); ++d)
          unknowns_.push_back({v, i, d});
    }
    first_unknown_.push_back(unknowns_.size());
  }

  // Rows of derivatives, for each point and attribute: control points, each attribute its own, and then knots.
  void build(FitKnots knots) {
    const std::size_t attributes = state_.num_attributes();
    const auto count = state_.control.count;
    num_linear_ = count * attributes;
    FitBasis basis(state_.model, state_.control, state_.points, true);
    const SparseRows rows = basis.rows();
    std::vector<std::pair<int, double>> entries;
    for (std::size_t i = 0; i < state_.points.size(); ++i) {
      const std::vector<KnotSlope> slopes = basis.slopes(i, state_.values, attributes);
      for (std::size_t a = 0; a < attributes; ++a) {
        entries.clear();
        for (int k = rows.first[i]; k < rows.first[i + 1]; ++k)
          entries.emplace_back(
              static_cast<int>(a * count) + rows.column[static_cast<std::size_t>(k)],
              rows.value[static_cast<std::size_t>(k)]);
        for (const KnotSlope& slope : slopes) add_slope(slope, a, knots, entries);
        rows_.add(entries);
      }
    }
    const SparseRows smooth = smoothness_rows(state_.model, state_.control);
    for (std::size_t a = 0; a < attributes; ++a)
      for (std::size_t r = 0; r < smooth.num_rows(); ++r) {
        entries.clear();
        for (int k = smooth.first[r]; k < smooth.first[r + 1]; ++k)
          entries.emplace_back(
              static_cast<int>(a * count) + smooth.column[static_cast<std::size_t>(k)],
              smooth.value[static_cast<std::size_t>(k)]);
        smooth_.add(entries);
      }
  }
  // The cloud's steps are those of its knot 0, and move all of its knots.
  void add_slope(const KnotSlope& slope, std::size_t attribute, FitKnots knots,
                 std::vector<std::pair<int, double>>& entries) const {
    for (std::size_t k = first_unknown_[slope.vertex]; k < first_unknown_[slope.vertex + 1]; ++k) {
      const KnotUnknown& unknown = unknowns_[k];
      const bool moves = unknown.index == 0 || unknown.index == slope.index;
      if (!moves || (knots == FitKnots::kVertices && unknown.index != 0)) continue;
      const auto along = constraints_[slope.vertex].direction(unknown.direction);
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c) sum += along[c] * slope.along[attribute][c];
      entries.emplace_back(static_cast<int>(num_linear_ + k), sum);
    }
  }

  FitState moved(std::span<const double> step, const std::vector<double>& share) const {
    FitState next;
    next.model = state_.model;
    next.points = state_.points;
    for (std::uint32_t v = 0; v < next.model.clouds.size(); ++v) {
      if (share[v] == 0 || first_unknown_[v] == first_unknown_[v + 1]) continue;
      next.model.clouds[v] = moved_cloud(v, step, share[v]);
    }
    return next;
  }
  DmsCloud moved_cloud(std::uint32_t v, std::span<const double> step, double share) const {
    const std::size_t directions = constraints_[v].num_directions();
    const auto of = [&](int index) {
      std::vector<double> out(directions);
      for (std::size_t k = first_unknown_[v]; k < first_unknown_[v + 1]; ++k)
        if (unknowns_[k].index == 0 || unknowns_[k].index == index)
          out[unknowns_[k].direction] += share * step[k];
      return out;
    };
    const bool is_open = unknowns_[first_unknown_[v + 1] - 1].index > 0;
    DmsCloud cloud = state_.model.clouds[v];
    if (is_open) cloud.resize(static_cast<std::size_t>(state_.model.degree), cloud[0]);
    for (std::size_t i = 0; i < cloud.size(); ++i)
      cloud[i] = constraints_[v].moved(cloud[i], of(static_cast<int>(i)));
    const double least = kLeastDistance * shortest_edge(v);
    bool is_collapsed = true;
    for (std::size_t i = 1; i < cloud.size(); ++i) {
      if (distance(cloud[i], cloud[0]) < least) cloud[i] = cloud[0];
      is_collapsed = is_collapsed && cloud[i] == cloud[0];
    }
    if (is_collapsed) cloud.resize(1);
    return cloud;
  }
  double shortest_edge(std::uint32_t v) const {
    double least = HUGE_VAL;
    for (const std::uint32_t t : complex_.tetrahedra_at(v))
      for (const std::uint32_t w : state_.model.tetrahedra[t])
        if (w != v)
          least = std::min(least, distance(state_.model.clouds[v][0], state_.model.clouds[w][0]));
    return least;
  }

  // Vertices of tetrahedra or boundary faces that fail a test.
  std::vector<bool> inadmissible(const DmsModel& model) const {
    std::vector<bool> bad(model.clouds.size());
    const auto add = [&](const auto& vertices) {
      for (const std::uint32_t v : vertices) bad[v] = true;
    };
    const auto is_moved = [&](std::uint32_t v) {
      return model.clouds[v] != state_.model.clouds[v];
    };
    const RoundedKnots now(model), before(state_.model);
    std::vector<std::uint32_t> doubtful;
    bool is_good = true;
    for (std::uint32_t t = 0; t < model.tetrahedra.size(); ++t) {
      const TetrahedronCorners& corners = model.tetrahedra[t];
      if (std::none_of(corners.begin(), corners.end(), is_moved)) continue;
      doubtful.push_back(t);
      const double least = std::min(kLeastShape, before.shape(corners));
      if (now.shape(corners) >= least && now.has_core(corners)) continue;
      add(corners);
      is_good = false;
    }
    if (!is_good) return bad;
    const DmsAdmissibility admissibility(model);
    for (const std::uint32_t t : doubtful)
      if (!admissibility.has_core(t)) add(model.tetrahedra[t]);
    for (const TetrahedronFace f : complex_.boundary())
      if (!admissibility.misses_inside(f)) add(complex_.vertices(f));
    return bad;
  }

  const FitState& state_;
  TetrahedralComplex complex_;
  std::vector<FitConstraint> constraints_;
  std::vector<KnotUnknown> unknowns_;
  std::vector<std::size_t> first_unknown_;  // of each vertex
  std::size_t num_linear_ = 0;
  SparseRows rows_, smooth_;
};

}  // namespace

bool improve_knots(FitState& state, FitKnots knots, std::span<const DmsPlane> features,
                   int most_steps) {
  bool has_improved = false;
  double damping = 0.01;
  for (int i = 0; i < most_steps && state.square_sum > 0; ++i) {
    const KnotStep step(state, knots, features);
    if (step.is_empty()) break;
    std::optional<FitState> best;
    for (int k = 0; k < kTries && !best; ++k) {
      best = step.run(damping);
      if (!best || !(best->square_sum < state.square_sum)) best.reset();
      damping *= best ? 0.25 : 8;
    }
    if (!best) break;
    const double gain = 1 - best->square_sum / state.square_sum;
    state = std::move(*best);
    has_improved = true;
    if (gain < kLeastGain) break;
  }
  return has_improved;
}

}  // namespace veritope
