// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solids/micro/cage/field_fit_internal.h"
#include "solids/micro/cage/principal_axes.h"
#include "solids/micro/cage/scale_floor_internal.h"
#include "solids/vmodel/jacobian_sign.h"
#include "solids/vmodel/v_model.h"
#include "splines/convert.h"
#include "splines/knot_insertion.h"

namespace veritope::internal {
namespace {

constexpr double kUnit = 0x1p-20;
constexpr double kWide = 0.25;          // of the diagonal, around the first box
constexpr double kWorkingMargin = 0.1;  // of the parameters, while the fit goes on
constexpr double kBeyond = 1;  // spans outside of the domain in which points are still found
constexpr double kLeastScale = 0x1p-7;  // of the mean determinant
constexpr int kScaleHalvings = 6;
constexpr int kMostTries = 6, kCutHalvings = 5;
constexpr double kLeastDamping = 0x1p-30, kFirstBrake = 0x1p-16;
constexpr double kFirstSmooth = 1, kCoarseSmooth = 1e-3, kLeastSmooth = 1e-10;
constexpr std::size_t kHeldOut = 8;      // one vector in so many
constexpr std::size_t kFewVectors = 64;  // with fewer, none is held out

// The mean axis and two directions across it: u, v, w of the first box, right-handed.
std::array<Point3d, 3> first_frame(const std::vector<Point3d>& directions) {
  SymmetricTensor sum{};
  for (const Point3d& d : directions) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += d[k] * d[k];
      sum[3 + k] += d[k] * d[(k + 1) % 3];
    }
  }
  Point3d w = approx_principal_axes(sum).directions[0];
  std::size_t most = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(w[k]) > std::abs(w[most]) + 0x1p-20) most = k;
  if (w[most] < 0)
    for (double& x : w) x = -x;
  Point3d u{};
  u[(most + 1) % 3] = 1;
  add_times(u, -w[(most + 1) % 3], w);
  const double length = std::sqrt(dot(u, u));
  for (double& x : u) x /= length;
  return {u, cross(w, u), w};
}

double rounded(double x) { return std::nearbyint(x / kUnit) * kUnit; }

}  // namespace

FieldFit::FieldFit(const FieldData& data, const CageGrid& grid, unsigned jobs)
    : data_(data),
      grid_(grid),
      jobs_(jobs),
      state_{FieldNet(grid), {}},
      weights_(data.points.size(), 1.0),
      smoothness_(state_.net, {1, 1, 1}) {
  begin();
}

void FieldFit::begin() {
  const auto frame = first_frame(data_.directions);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Point3d low = {kInfinity, kInfinity, kInfinity}, high = {-kInfinity, -kInfinity, -kInfinity};
  for (const std::vector<Point3d>* points : {&data_.points, &data_.corners})
    for (const Point3d& p : *points)
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], dot(p, frame[k]));
        high[k] = std::max(high[k], dot(p, frame[k]));
      }
  double diagonal = 0;
  for (std::size_t k = 0; k < 3; ++k) diagonal += (high[k] - low[k]) * (high[k] - low[k]);
  const double wide = std::max(kWide * std::sqrt(diagonal), 1.5 * data_.margin);
  FieldNet& net = state_.net;
  Parameters3 rate;
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] -= wide;
    high[k] += wide;
    rate[k] = (high[k] - low[k]) / static_cast<double>(grid_.spans[k]);
  }
  std::array<std::vector<double>, 3> greville;
  for (std::size_t k = 0; k < 3; ++k) greville[k] = net.axes[k].greville();
  for (std::size_t n = 0; n < net.points.size(); ++n) {
    const auto i = net.grid.index_of(n);
    Point3d p{};
    for (std::size_t k = 0; k < 3; ++k)
      add_times(p, low[k] + rate[k] * greville[k][i[k]], frame[k]);
    for (double& x : p) x = rounded(x);
    net.points[n] = p;
  }
  const auto parameters = [&](const Point3d& p) {
    Parameters3 at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = (dot(p, frame[k]) - low[k]) / rate[k];
    return at;
  };
  for (const Point3d& p : data_.points) state_.at.push_back(parameters(p));
  for (const Point3d& p : data_.corners) corner_at_.push_back(parameters(p));
  const std::vector<Parameters3> from = state_.at;
  relocate(state_, from, Inside::kYes);
  take_measure();
}

Point3d FieldFit::lengths(const FieldNet& net) const {
  Point3d out{};
  for (std::size_t k = 0; k < 3; ++k) {
    Point3d sum{};
    double count = 0;
    const std::size_t stride = net.grid.stride(k), last = (net.grid.size[k] - 1) * stride;
    net.grid.for_each_line(k, [&](std::size_t first) {
      add_times(sum, 1, net.points[first + last]);
      add_times(sum, -1, net.points[first]);
      count += 1;
    });
    out[k] = std::max(std::sqrt(dot(sum, sum)) / count, 0x1p-10);
  }
  return out;
}

void FieldFit::take_measure() {
  smoothness_ = Smoothness(state_.net, lengths(state_.net));
  moments_.emplace(state_.net, state_.at);
  brakes_.assign(state_.net.points.size(), 0.0);
}

bool FieldFit::relocate(State& state, const std::vector<Parameters3>& from, Inside inside) const {
  const double beyond = inside == Inside::kYes ? 0 : kBeyond;
  state.at.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    const auto at = state.net.locate(data_.points[i], from[i], beyond);
    if (!at) return false;
    state.at[i] = *at;
  }
  return true;
}

double FieldFit::energy(const State& state) const {
  double sum = 0, weight = 0;
  for (std::size_t i = 0; i < state.at.size(); ++i) {
    if (weights_[i] == 0) continue;
    const FieldJet j = state.net.jet(state.net.weights(state.at[i]));
    sum += weights_[i] * squared_chord(j.along[2], data_.directions[i]);
    weight += weights_[i];
  }
  return sum / weight + smooth_ * smoothness_.energy(state.net.points) + moments_->energy(state.at);
}

double FieldFit::held_out_error() const {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < state_.at.size(); ++i) {
    if (weights_[i] != 0) continue;
    const FieldJet j = state_.net.jet(state_.net.weights(state_.at[i]));
    sum += squared_chord(j.along[2], data_.directions[i]);
    count += 1;
  }
  return sum / count;
}

bool FieldFit::is_proved(const FieldNet& net, std::optional<FitStop>* stop) const {
  const CellVolume cell = net.cell(grid_, Rational(1), {});
  if (const auto low = low_span(net, cell)) {
    if (stop != nullptr) *stop = stop_in(net, *low);
    return false;
  }
  const auto model = make_v_model({cell}, VOrientation::kKeep);
  if (!model) return false;
  JacobianOptions options;
  options.jobs = jobs_;
  const VDeterminants answer = decide_determinants(*model, options);
  if (answer.is_proved()) return true;
  if (stop == nullptr) return false;
  std::array<std::size_t, 3> span;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [a, b] = answer.findings.front().box[k];
    const double m = nearest_double((a + b) / Rational(2));
    span[k] = std::min(static_cast<std::size_t>(std::max(m, 0.0)), grid_.spans[k] - 1);
  }
  *stop = stop_in(net, span);
  return false;
}

std::optional<std::array<std::size_t, 3>> FieldFit::low_span(const FieldNet& net,
                                                             const CellVolume& cell) const {
  const Point3d length = lengths(net);
  double least = kLeastScale;
  for (std::size_t k = 0; k < 3; ++k) least *= length[k] / static_cast<double>(grid_.spans[k]);
  const auto pieces = bezier_pieces(nearest_double(cell).value());
  const Grid<3> grid = pieces.grid();
  for (std::size_t n = 0; n < grid.count(); ++n)
    if (!has_scale(pieces.pieces[n], least, kScaleHalvings)) return grid.index_of(n);
  return std::nullopt;
}

FitStop FieldFit::stop_in(const FieldNet& net, const std::array<std::size_t, 3>& span) {
  Parameters3 middle;
  for (std::size_t k = 0; k < 3; ++k) middle[k] = static_cast<double>(span[k]) + 0.5;
  return {span, net.jet(net.weights(middle)).point};
}

bool FieldFit::step(Inside inside) {
  std::vector<FieldRow> rows;
  for (std::size_t i = 0; i < state_.at.size(); ++i)
    if (weights_[i] != 0) rows.push_back(field_row(state_.net, state_.at[i], data_.directions[i]));
  const auto wide = moments_->rows(state_.net, state_.at);
  const double before = energy(state_);
  std::optional<FitStop> stop;
  for (int tries = 0; tries < kMostTries; ++tries) {
    FieldSolve solve;
    solve.smooth = smooth_;
    for (const double brake : brakes_) solve.damping.push_back(damping_ + brake);
    const auto moves = solve_field(state_.net, rows, wide, smoothness_, solve);
    stop.reset();
    for (const double part : {1.0, 0.5}) {
      State trial = state_;
      for (std::size_t n = 0; n < moves.size(); ++n) {
        add_times(trial.net.points[n], part, moves[n]);
        for (double& x : trial.net.points[n]) x = rounded(x);
      }
      const bool is_found = relocate(trial, state_.at, inside);
      const double after = is_found ? energy(trial) : 0;
      if (is_found && after < before && is_proved(trial.net, &stop)) {
        state_ = std::move(trial);
        ++steps_;
        if (part == 1) damping_ = std::max(damping_ / 8, kLeastDamping);
        stop_.reset();
        for (double& brake : brakes_) brake = brake < kLeastDamping ? 0 : brake / 4;
        return after < before * (1 - 1e-3);
      }
      if (stop) blocked_ = stop;
      ++shortened_;
    }
    if (stop)
      brake(stop->span);
    else
      damping_ *= 16;
  }
  if (!stop) damping_ /= 256;
  stop_ = std::move(stop);
  return false;
}

// Control points that count in a span whose determinant is in the way move less; the others go on.
void FieldFit::brake(const std::array<std::size_t, 3>& span) {
  Grid<3> window;
  for (std::size_t k = 0; k < 3; ++k)
    window.size[k] = static_cast<std::size_t>(grid_.degrees[k]) + 1;
  for (std::size_t i = 0; i < window.count(); ++i) {
    auto at = window.index_of(i);
    for (std::size_t k = 0; k < 3; ++k) at[k] += span[k];
    double& brake = brakes_[state_.net.grid.at(at)];
    brake = std::max({16 * brake, 16 * damping_, kFirstBrake});
  }
}

void FieldFit::descend(int most, Inside inside) {
  for (int i = 0; i < most && step(inside); ++i) continue;
}

void FieldFit::coarse() {
  for (smooth_ = kFirstSmooth; smooth_ >= kCoarseSmooth; smooth_ /= 10) {
    descend(4, Inside::kNearly);
    cut(kWorkingMargin);
  }
  smooth_ = kCoarseSmooth;
}

void FieldFit::fine() {
  const bool is_held = data_.points.size() >= kFewVectors;
  if (is_held)
    for (std::size_t i = kHeldOut - 1; i < weights_.size(); i += kHeldOut) weights_[i] = 0;
  State best = state_;
  double best_error = std::numeric_limits<double>::infinity(), best_smooth = smooth_;
  std::optional<FitStop> stop;
  for (smooth_ = kCoarseSmooth; is_held && smooth_ >= kLeastSmooth; smooth_ /= 10) {
    if (is_tight()) cut(kWorkingMargin);
    descend(6, Inside::kYes);
    const double error = held_out_error();
    // The cage gets less smooth for little.
    if (!(error < 0.99 * best_error)) break;
    best = state_;
    best_error = error;
    best_smooth = smooth_;
    stop = stop_;
    if (stop) break;
  }
  weights_.assign(weights_.size(), 1.0);
  state_ = std::move(best);
  smooth_ = best_smooth;
  stop_ = stop;
}

bool FieldFit::is_tight() const {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto spans = static_cast<double>(grid_.spans[k]);
    const double room = 0.25 * kWorkingMargin * spans;
    for (const Parameters3& at : state_.at)
      if (at[k] < room || at[k] > spans - room) return true;
  }
  return false;
}

void FieldFit::widen() {
  margin_part_ *= 2;
  cut(0);
}

bool FieldFit::cut(double least) {
  Parameters3 low, high;
  for (std::size_t k = 0; k < 3; ++k) low[k] = high[k] = state_.at.front()[k];
  const auto include = [&](const Parameters3& at) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], at[k]);
      high[k] = std::max(high[k], at[k]);
    }
  };
  for (const Parameters3& at : state_.at) include(at);
  for (std::size_t i = 0; i < data_.corners.size(); ++i) {
    const auto at = state_.net.locate(data_.corners[i], corner_at_[i], kBeyond);
    if (!at) continue;
    corner_at_[i] = *at;
    include(*at);
  }
  const Point3d length = lengths(state_.net);
  double part = 1;
  for (int halving = 0; halving < kCutHalvings; ++halving, part /= 2) {
    Parameters3 from, to;
    for (std::size_t k = 0; k < 3; ++k) {
      const double margin =
          part * margin_part_ * data_.margin / length[k] * static_cast<double>(grid_.spans[k]);
      from[k] = low[k] - margin;
      to[k] = high[k] + margin;
    }
    State trial{state_.net.on_box(from, to), state_.at};
    for (Point3d& p : trial.net.points)
      for (double& x : p) x = rounded(x);
    const auto mapped = [&](const Parameters3& at) {
      Parameters3 out;
      for (std::size_t k = 0; k < 3; ++k)
        out[k] = (at[k] - from[k]) / (to[k] - from[k]) * static_cast<double>(grid_.spans[k]);
      return out;
    };
    for (Parameters3& at : trial.at) at = mapped(at);
    const std::vector<Parameters3> places = trial.at;
    if (!relocate(trial, places, Inside::kYes) || !is_proved(trial.net, nullptr)) continue;
    state_ = std::move(trial);
    for (Parameters3& at : corner_at_) at = mapped(at);
    take_measure();
    return true;
  }
  return false;
}

void FieldFit::run() {
  coarse();
  fine();
  blocked_ = stop_;
  cut(0);
  damping_ = 0x1p-20;
  descend(6, Inside::kYes);
}

}  // namespace veritope::internal
