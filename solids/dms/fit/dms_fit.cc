// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fit/dms_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "solids/dms/dms_make.h"
#include "solids/dms/fit/fit_knots.h"
#include "solids/dms/fit/fit_mesh.h"
#include "solids/dms/fit/fit_state.h"
#include "solids/dms/fit/fit_units.h"

namespace veritope {
namespace {

constexpr double kMarkedShare = 0.6;  // of the squared error, in the tetrahedra that a round cuts
constexpr double kMostGrowth = 0.35;  // of the number of tetrahedra in a round
constexpr double kConflictMargin = 1.02;
constexpr int kIdleRounds = 6;  // without a lesser error, before the fit ends
constexpr int kStepsOnTheWay = 2, kVertexSteps = 30, kCloudSteps = 12;

std::vector<std::string> attribute_names(const DmsModel& domain, std::size_t count) {
  std::vector<std::string> names = domain.attributes;
  names.resize(std::min(names.size(), count));
  while (names.size() < count) {
    std::string name = "a" + std::to_string(names.size() + 1);
    while (std::find(names.begin(), names.end(), name) != names.end()) name += "'";
    names.push_back(std::move(name));
  }
  return names;
}

// The least mean squared error of each attribute that any function has: values at equal points differ.
std::vector<double> least_errors(const DmsData& data, const FitPoints& points,
                                 const std::vector<std::size_t>& conflicts) {
  std::map<DmsPoint, std::vector<std::size_t>> places;
  for (const std::size_t i : conflicts)
    if (std::binary_search(points.number.begin(), points.number.end(), i))
      places[data.points[i]].push_back(i);
  std::vector<double> out(data.num_attributes);
  for (const auto& [at, numbers] : places)
    for (std::size_t a = 0; a < data.num_attributes; ++a) {
      Rational mean, sum;
      for (const std::size_t i : numbers) mean += data.value(i, a);
      mean /= Rational(numbers.size());
      for (const std::size_t i : numbers) {
        const Rational d = data.value(i, a) - mean;
        sum += d * d;
      }
      out[a] += nearest_double(sum) / static_cast<double>(points.size());
    }
  return out;
}

class Fitter {
 public:
  Fitter(const DmsModel& start, const DmsData& data, const DmsFitOptions& options)
      : options_(options), budget_(options.max_tetrahedra.value_or(start.tetrahedra.size())) {
    out_.num_points = data.points.size();
    state_.model = start;
    state_.points = find_fit_points(start, data);
    out_.outside = state_.points.outside;
    out_.conflicts = find_conflicts(data);
    least_ = least_errors(data, state_.points, out_.conflicts);
  }
  bool is_empty() const { return state_.points.size() == 0; }

  DmsFit run() {
    refit(state_);
    note();
    double best = state_.square_sum;
    for (int idle = 0;;) {
      if (is_done()) break;
      if (idle >= kIdleRounds) {
        out_.end = DmsFitEnd::kStalled;
        break;
      }
      if (options_.has_free_knots && improve(FitKnots::kVertices, kStepsOnTheWay) && is_done())
        break;
      if (!cut()) {
        out_.end = options_.max_tetrahedra ? DmsFitEnd::kBudget : DmsFitEnd::kNoAim;
        break;
      }
      refit(state_);
      note();
      idle = state_.square_sum < 0.99 * best ? 0 : idle + 1;
      best = std::min(best, state_.square_sum);
    }
    if (options_.has_free_knots && out_.end != DmsFitEnd::kTolerance) free_knots();
    finish();
    return std::move(out_);
  }

 private:
  bool improve(FitKnots knots, int steps) {
    const bool has_improved = improve_knots(state_, knots, options_.features, steps);
    if (has_improved) note();
    return has_improved;
  }
  void free_knots() {
    improve(FitKnots::kVertices, kVertexSteps);
    if (state_.model.degree > 1 && !is_done()) improve(FitKnots::kClouds, kCloudSteps);
    is_done();
  }

  void note() {
    DmsFitRound round;
    round.tetrahedra = state_.model.tetrahedra.size();
    round.control_points = state_.control.count;
    for (const DmsCloud& cloud : state_.model.clouds) round.knots += cloud.size();
    round.attribute_mse = state_.mean_squares();
    round.max_error = state_.largest();
    out_.rounds.push_back(std::move(round));
  }
  // Whether the tolerance is reached, or cannot be and what is left is nearly what must be left.
  bool is_done() {
    if (!options_.tolerance) return false;
    const std::vector<double> errors = state_.mean_squares();
    bool is_reached = true, is_least = true, is_possible = true;
    for (std::size_t a = 0; a < errors.size(); ++a) {
      is_reached = is_reached && errors[a] <= *options_.tolerance;
      is_possible = is_possible && least_[a] <= *options_.tolerance;
      is_least =
          is_least && errors[a] <= std::max(*options_.tolerance, kConflictMargin * least_[a]);
    }
    if (is_reached) out_.end = DmsFitEnd::kTolerance;
    if (!is_possible && is_least) out_.end = DmsFitEnd::kConflict;
    return is_reached || (!is_possible && is_least);
  }

  // Cuts the tetrahedra with the largest errors. False if none was cut.
  bool cut() {
    const DmsModel& model = state_.model;
    const std::size_t before = model.tetrahedra.size();
    std::vector<DmsPoint> vertices;
    for (const DmsCloud& cloud : model.clouds) vertices.push_back(cloud[0]);
    FitMesh mesh(std::move(vertices), model.tetrahedra);
    const std::vector<double> errors = state_.by_tetrahedron();
    std::vector<std::uint32_t> order(before);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return errors[a] > errors[b]; });
    const std::size_t most = std::min(
        budget_, before + 8 + static_cast<std::size_t>(kMostGrowth * static_cast<double>(before)));
    double marked = 0;
    for (const std::uint32_t t : order) {
      if (errors[t] == 0 || marked > kMarkedShare * state_.square_sum) break;
      marked += errors[t];
      if (mesh.tetrahedra()[t] != model.tetrahedra[t]) continue;  // cut with a neighbour
      if (!mesh.refine(t, most) && mesh.tetrahedra().size() >= most) break;
    }
    if (mesh.tetrahedra().size() == before) return false;
    state_.model.tetrahedra = mesh.tetrahedra();
    for (std::size_t v = model.clouds.size(); v < mesh.vertices().size(); ++v)
      state_.model.clouds.push_back({mesh.vertices()[v]});
    move_fit_points(state_.model, state_.points);
    return true;
  }

  void finish() {
    out_.undetermined = undetermined_control(state_);
    out_.errors = measure_fit_errors(state_.model, *state_.points.data);
    out_.model = std::move(state_.model);
    if (out_.end == DmsFitEnd::kTolerance && !out_.is_reached(*options_.tolerance))
      out_.end = DmsFitEnd::kStalled;  // by less than rounding
  }

  const DmsFitOptions& options_;
  std::size_t budget_;
  FitState state_;
  std::vector<double> least_;
  DmsFit out_;
};

Status check_data(const DmsData& data) {
  const auto is_finite = [](const Rational& r) { return std::isfinite(nearest_double(r)); };
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    bool is_good = std::all_of(data.points[i].begin(), data.points[i].end(), is_finite);
    for (std::size_t a = 0; a < data.num_attributes; ++a)
      is_good = is_good && is_finite(data.value(i, a));
    if (!is_good)
      return bad_argument("a number of point " + std::to_string(i) + " is beyond binary64");
  }
  return ok_status();
}

Result<DmsFit> fit_in_units(const DmsModel& domain, const DmsData& data,
                            const DmsFitOptions& options) {
  Result<DmsModel> start = make_dms(domain, {options.degree, {}, DmsControlRule::kGreville});
  if (!start) return start.error();
  if (options.max_tetrahedra && *options.max_tetrahedra < start->tetrahedra.size())
    return Error{Code::kOverLimit,
                 {},
                 "the domain has " + std::to_string(start->tetrahedra.size()) +
                     " tetrahedra, more than --max-tetrahedra " +
                     std::to_string(*options.max_tetrahedra)};
  start->attributes = attribute_names(domain, data.num_attributes);
  Fitter fitter(*start, data, options);
  if (fitter.is_empty()) return bad_argument("no point lies in the closed domain");
  return fitter.run();
}

}  // namespace

const char* fit_end_name(DmsFitEnd end) {
  switch (end) {
    case DmsFitEnd::kTolerance: return "tolerance";
    case DmsFitEnd::kBudget: return "budget";
    case DmsFitEnd::kConflict: return "conflict";
    case DmsFitEnd::kStalled: return "stalled";
    case DmsFitEnd::kNoAim: return "no-aim";
  }
  return "";
}

bool DmsFit::is_reached(double tolerance) const {
  return std::all_of(errors.attribute_mse.begin(), errors.attribute_mse.end(),
                     [&](double e) { return e <= tolerance; });
}

Result<DmsFit> fit_dms(const DmsModel& domain, const DmsData& data, const DmsFitOptions& options) {
  if (const Status status = check_data(data); !status) return status.error();
  const FitUnits units(domain, data);
  if (units.are_those_of_the_data()) return fit_in_units(domain, data, options);
  Result<DmsFit> fit =
      fit_in_units(units.to_unit(domain), units.to_unit(data), units.to_unit(options));
  if (!fit) return fit.error();
  units.restore(*fit);
  return fit;
}

}  // namespace veritope
