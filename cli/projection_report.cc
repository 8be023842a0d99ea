// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/projection_report.h"

#include <algorithm>
#include <utility>

#include "interval/relations.h"
#include "io/base/exact_number.h"

namespace veritope::cli {
namespace {

// Projects on the curves and surfaces of an entity, in its order.
class Targets {
 public:
  Targets(ProjectionReport& report, const SolverOptions& options)
      : report_(report), options_(options) {}

  Status add(std::uint64_t number, const SplineEntity& entity) {
    const std::string kind = spline_kind_name(entity);
    if (const auto* curve = std::get_if<ExactCurve>(&entity.shape))
      return add(number, {}, kind, *curve);
    if (const auto* surface = std::get_if<ExactSurface>(&entity.shape))
      return add(number, {}, kind, *surface);
    if (const auto* trimmed = std::get_if<TrimmedSurface>(&entity.shape))
      return add(number, {}, kind, trimmed->surface);
    if (const auto* model = std::get_if<SplineBrep>(&entity.shape)) {
      for (std::uint64_t f = 0; f < model->faces.size(); ++f)
        if (const Status status = add(number, f, kind, model->faces[f].surface); !status)
          return status;
      return ok_status();
    }
    ++(std::holds_alternative<ExactTriangle>(entity.shape) ? report_.skipped_triangles
                                                           : report_.skipped_volumes);
    return ok_status();
  }

 private:
  template <std::size_t N>
  Status add(std::uint64_t entity, std::optional<std::uint64_t> face, const std::string& kind,
             const BSpline<Rational, N>& map) {
    auto projection = project_point<N>(report_.point, map, options_);
    if (!projection) {
      Error error = projection.error();
      error.message = "entity " + std::to_string(entity) + ": " + error.message;
      return error;
    }
    report_.targets.push_back({entity, face, kind, *std::move(projection)});
    return ok_status();
  }

  ProjectionReport& report_;
  const SolverOptions& options_;
};

Interval distance_of(const ProjectionTarget& target) {
  return std::visit([](const auto& p) { return p.least_distance; }, target.projection);
}
// Why a coordinate is refused.
std::string sentence(DecimalFault fault, std::string_view token) {
  const ReadLimits limits;
  if (fault == DecimalFault::kNotFinite) return "which is not finite";
  if (fault == DecimalFault::kExponent)
    return "whose exponent is over the limit " + std::to_string(limits.max_exponent);
  if (fault == DecimalFault::kDigits) {
    const bool is_decimal = token.find_first_of(".eExX") != token.npos;
    return "whose digits are more than the limit " +
           std::to_string(limits.max_digits + (is_decimal ? 0 : limits.max_exponent));
  }
  return "not a decimal, fraction or hexadecimal number";
}

// Whether what is not the certified nearest point of its own target may be nearer than this.
bool may_be_nearer(const ProjectionTarget& target, double than) {
  return !(distance_of(target).lo() > than);
}

}  // namespace

Interval ProjectionReport::distance() const {
  Interval out = distance_of(targets.front());
  for (const ProjectionTarget& t : targets) out = min(out, distance_of(t));
  return out;
}

std::optional<std::pair<std::size_t, std::size_t>> ProjectionReport::nearest() const {
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const auto point =
        std::visit([](const auto& p) { return p.certified_nearest; }, targets[t].projection);
    if (!point) continue;
    bool is_alone = true;
    for (std::size_t s = 0; s < targets.size(); ++s)
      is_alone = is_alone && (s == t || !may_be_nearer(targets[s], distance_of(targets[t]).hi()));
    if (is_alone) return std::pair(t, *point);
  }
  return std::nullopt;
}

bool ProjectionReport::is_complete() const {
  return std::all_of(targets.begin(), targets.end(), [](const ProjectionTarget& t) {
    return std::visit([](const auto& p) { return p.is_complete(); }, t.projection);
  });
}

Result<std::vector<Rational>> point_from_text(const std::string& text) {
  std::vector<Rational> out;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    Rational value;
    const std::string token = text.substr(begin, end - begin);
    if (const DecimalFault fault = read_exact_number(token, {}, value);
        fault != DecimalFault::kNone)
      return Error{Code::kBadArgument,
                   {},
                   "POINT has the coordinate '" + token + "', " + sentence(fault, token)};
    out.push_back(std::move(value));
    begin = end + 1;
  }
  return out;
}

Result<ProjectionReport> project_on(std::vector<Rational> point, const SplineModel& model,
                                    const SolverOptions& options) {
  ProjectionReport out;
  out.point = std::move(point);
  Targets targets(out, options);
  for (std::uint64_t i = 0; i < model.entities.size(); ++i)
    if (const Status status = targets.add(i, model.entities[i]); !status) return status.error();
  if (out.targets.empty())
    return Error{Code::kBadArgument, {}, "there is no curve or surface to project on"};
  if (!out.is_complete()) out.exit = kExitUndecided;
  return out;
}

}  // namespace veritope::cli
