// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope project.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "cli/commands.h"
#include "cli/output_plan.h"
#include "io/base/exact_number.h"
#include "io/read_model.h"
#include "report/projection_report.h"
#include "report/text_style.h"

namespace veritope::cli {

using namespace report;

namespace {

struct ProjectOptions {
  std::string point;
  InputOptions input;
  std::optional<std::string> json;
  std::uint64_t max_boxes = 100000;  ///< for each curve and surface
};

// A file where the point should be.
std::string wrong_order(const ProjectOptions& o) {
  std::error_code none;
  if (!std::filesystem::exists(o.point, none)) return "";
  return "POINT comes first, and " + o.point + " is a file: veritope project x,y,z " + o.point;
}

void declare(OptionSet& set, ProjectOptions& o) {
  set.operand("POINT", any_text(o.point),
              "x,y,z: decimals, fractions or hexadecimal numbers, exact");
  declare_file(set, "SURFACE", o.input, "a file of splines; - is standard input (with --format)");
  declare_json(set, o.json, "write the report");
  set.number("--max-boxes", o.max_boxes, {1, kMost64},
             "examine at most N boxes of parameters of each curve\nand surface (100000)");
  declare_format(set, o.input);
  set.rule([&o] { return wrong_order(o); });
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

/// "1,-2.5,1e-3" or with fractions and hexadecimal numbers, exactly.
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
                   "POINT has the coordinate '" + token + "', " + sentence(fault, token) +
                       "; write x,y,z without spaces"};
    out.push_back(std::move(value));
    begin = end + 1;
  }
  return out;
}

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
  static constexpr std::size_t kMostCoordinates = 3;  // of the points that people project

  template <std::size_t N>
  Status add(std::uint64_t entity, std::optional<std::uint64_t> face, const std::string& kind,
             const BSpline<Rational, N>& map) {
    const std::size_t size = report_.point.size(),
                      dimension = static_cast<std::size_t>(map.dimension());
    if (size != dimension)
      return bad_argument("POINT has " + counted(size, "coordinate", "coordinates") +
                          ", and entity " + std::to_string(entity) + " has " +
                          std::to_string(dimension) +
                          (size > kMostCoordinates ? " (decimal commas?)" : ""));
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

/// @error kBadArgument: nothing to project on, or of another dimension than the point
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

ExitCode print(const ProjectionReport& report, const ProjectOptions& options, StandardOutput& out) {
  if (options.json != "-") out.write(fold(projection_text(report), verdict_width()));
  if (!options.json) return report.exit;
  const Status status = write_output(*options.json, projection_json(report), out);
  if (status || *options.json == "-") return report.exit;
  return first_of(report.exit, fail(status.error()));
}

ExitCode run(const ProjectOptions& options, StandardOutput& out) {
  const Result<OutputPlan> plan = plan_outputs(options.input.files, std::nullopt, options.json);
  if (!plan) return fail(plan.error());
  if (const Status status = try_outputs(*plan, {options.json}); !status)
    return fail(status.error());
  Result<std::vector<Rational>> point = point_from_text(options.point);
  if (!point) {
    complain(harmless(point.error().message));
    return kExitUsage;
  }
  const std::string& path = options.input.files[0];
  const Result<SplineFile> file = read_spline_file(path, options.input.reading);
  if (!file) {
    complain(harmless(to_string(file.error())));
    return kExitUnreadable;
  }
  SolverOptions solver;
  solver.max_boxes = options.max_boxes;
  Result<ProjectionReport> report = project_on(*std::move(point), file->model, solver);
  if (!report) {
    complain(harmless(path + ": " + to_string(report.error())));
    return kExitUnreadable;
  }
  report->path = path;
  report->sha256 = file->sha256;
  return print(*report, options, out);
}

}  // namespace

RunCommand declare_project(OptionSet& set) {
  const auto o = std::make_shared<ProjectOptions>();
  declare(set, *o);
  return [o](StandardOutput& out) { return run(*o, out); };
}

}  // namespace veritope::cli
