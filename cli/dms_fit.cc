// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope dms fit.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/dms_verbs.h"
#include "cli/line_reader.h"
#include "cli/progress.h"
#include "io/base/exact_number.h"
#include "io/dms/write_dms.h"
#include "io/points/npy_header.h"
#include "io/points/read_row.h"
#include "report/dms_fit_report.h"
#include "report/text_style.h"
#include "robust/base/stopwatch.h"
#include "solids/dms/dms_similarity.h"
#include "solids/dms/domain/auto_domain.h"
#include "solids/dms/domain/gradient_splits.h"

namespace veritope::cli {
namespace {

constexpr std::size_t kMaxDataPoints = std::size_t{1} << 22;
constexpr std::size_t kDefaultTetrahedra = 5000;  // with a tolerance
constexpr double kSplitThreshold = 0.25;          // of the greatest deviation of gradients

struct DmsFitChoice {
  std::string data;
  std::optional<std::string> output, domain, json;
  std::optional<int> degree;
  std::optional<std::uint64_t> max_tetrahedra;
  bool is_auto = false;
  DmsFitOptions fit;
  ModelReadOptions reading;
};

Result<DmsData> read_data(const std::string& path, const ReadLimits& limits) {
  Result<LineReader> lines = LineReader::open(path);
  if (!lines) return lines.error();
  const std::string name = path == "-" ? "standard input" : path;
  RowLines rows(4, 3 + kMaxDmsAttributes, limits);
  DmsData data;
  const auto error = [&](Code code, std::string message) {
    Error out{code, {}, std::move(message)};
    out.place.file = name + ":" + std::to_string(lines->line());
    return out;
  };
  for (;;) {
    const Result<std::optional<std::string_view>> line = lines->next();
    if (!line) return line.error();
    if (!*line) break;
    if (lines->line() == 1 &&
        looks_like_npy({reinterpret_cast<const unsigned char*>((*line)->data()), (*line)->size()}))
      return error(Code::kForeignFormat, "data are text, not an .npy file");
    std::optional<PointFault> fault;
    std::optional<std::vector<Rational>> row = rows.read(**line, fault);
    if (fault)
      return error(Code::kSyntax,
                   "column " + std::to_string(fault->column) + ": " + fault->message);
    if (!row) continue;
    for (std::size_t k = 0; k < row->size(); ++k)
      if (!std::isfinite(nearest_double((*row)[k])))
        return error(Code::kNotFinite, "number " + std::to_string(k + 1) + " is beyond binary64");
    if (data.points.size() == kMaxDataPoints)
      return error(Code::kOverLimit,
                   "there are more than " + std::to_string(kMaxDataPoints) + " points");
    data.num_attributes = row->size() - 3;
    data.points.push_back({std::move((*row)[0]), std::move((*row)[1]), std::move((*row)[2])});
    for (std::size_t k = 3; k < row->size(); ++k) data.values.push_back(std::move((*row)[k]));
  }
  if (data.points.empty())
    return Error{Code::kEmpty, {name, {}, {}, {}, {}, {}}, "there are no data"};
  return data;
}

// "a,b,c,d": the plane of the points with a x + b y + c z = d.
std::string take_feature(const std::string& text, std::vector<DmsPlane>& features) {
  std::array<Rational, 4> numbers;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t end = text.find(',', begin);
    if ((end == text.npos) != (k == 3) ||
        read_exact_number(text.substr(begin, end - begin), {}, numbers[k]) != DecimalFault::kNone)
      return "must be four numbers a,b,c,d, a plane, not " + text;
    begin = end + 1;
  }
  DmsPlane plane{{numbers[0], numbers[1], numbers[2]}, numbers[3]};
  if (plane.vector == DmsPoint{}) return "must not have three zeros before the last number";
  features.push_back(std::move(plane));
  return "";
}

class DmsFitRun {
 public:
  DmsFitRun(const DmsFitChoice& options, StandardOutput& out) : options_(options), out_(out) {}

  ExitCode run() {
    std::vector<std::string> inputs{options_.data};
    if (options_.domain) inputs.push_back(*options_.domain);
    if (const Status status = try_dms_outputs(inputs, options_.output, options_.json); !status)
      return fail(status.error());
    Stopwatch watch;
    report_.data = options_.data;
    report_.output = *options_.output;
    report_.tolerance = options_.fit.tolerance;
    const Result<ExitCode> fitted = options_.is_auto ? fit_auto() : fit_file();
    if (!fitted) return fail(fitted.error());
    const ExitCode exit = *fitted;
    report_.seconds = watch.lap();
    if (!options_.json) return exit;
    const Status written = write_output(*options_.json, dms_fit_json(report_), out_);
    return written ? exit : first_of(exit, fail(written.error()));
  }

 private:
  static constexpr std::size_t kMaxListed = 100;

  Result<ExitCode> fit_file() {
    const Result<DmsFile> domain = read_dms_file(*options_.domain, options_.reading);
    if (!domain) return domain.error();
    report_.domain = {*options_.domain, domain->sha256, domain->bytes};
    report_.defects = find_dms_defects(domain->model, kMaxListed);
    if (report_.defects.count > 0) {
      complain(harmless(dms_refusal(*options_.domain, report_.defects)));
      return kExitInvalid;
    }
    const Result<DmsData> data = read_data(options_.data, options_.reading.limits);
    if (!data) return data.error();
    return fit(domain->model, *data, *options_.domain);
  }

  // A domain of the data, with more vertices where their gradients differ if tetrahedra may be cut.
  Result<ExitCode> fit_auto() {
    const Result<DmsData> data = read_data(options_.data, options_.reading.limits);
    if (!data) return data.error();
    const DmsSimilarity units = similarity_of(data->points);
    std::vector<ExactPoint3> points;
    for (const DmsPoint& p : data->points) points.emplace_back(units.to_unit(p));
    Result<AutoDomain> made =
        with_progress(options_.data, "making the domain", [&] { return auto_domain(points, {}); });
    if (!made) {
      complain(harmless(options_.data + ": " + made.error().message));
      return made.error().code == Code::kBadArgument ? kExitInvalid : kExitUnreadable;
    }
    DmsFitAuto& out = report_.automatic.emplace();
    out.kind = auto_domain_name(made->kind);
    out.spacing = scaled_up(made->spacing, units.exponent);
    out.vertices = made->model.clouds.size();
    out.tetrahedra = made->model.tetrahedra.size();
    if (options_.max_tetrahedra || options_.fit.tolerance) {
      Result<GradientSplits> split = with_progress(options_.data, "splitting tetrahedra", [&] {
        return split_domain(*data, points, *made);
      });
      if (!split) return split.error();
      out.gradient_splits = split->inserted;
      made->model = std::move(split->model);
    }
    return fit(units.from_unit(std::move(made->model)), *data, options_.data);
  }
  Result<GradientSplits> split_domain(const DmsData& data, const std::vector<ExactPoint3>& points,
                                      const AutoDomain& domain) const {
    std::vector<std::array<double, 3>> all(points.size() * data.num_attributes);
    for (std::size_t a = 0; a < data.num_attributes; ++a) {
      std::vector<double> values;
      for (std::size_t i = 0; i < points.size(); ++i)
        values.push_back(nearest_double(data.value(i, a)));
      const auto gradients = approx_gradients(points, domain.data_tetrahedra, values);
      for (std::size_t i = 0; i < points.size(); ++i)
        all[i * data.num_attributes + a] = gradients[i];
    }
    return split_by_gradients(domain.model, points, all, kSplitThreshold,
                              domain.model.clouds.size(),
                              options_.max_tetrahedra.value_or(kDefaultTetrahedra) / 2);
  }

  Result<ExitCode> fit(const DmsModel& domain, const DmsData& data, const std::string& name) {
    DmsFitOptions options = options_.fit;
    options.degree = *options_.degree;
    if (options_.max_tetrahedra)
      options.max_tetrahedra = *options_.max_tetrahedra;
    else if (options.tolerance)
      options.max_tetrahedra = std::max(kDefaultTetrahedra, domain.tetrahedra.size());
    Result<DmsFit> result =
        with_progress(options_.data, "fitting", [&] { return fit_dms(domain, data, options); });
    if (!result) {
      complain(harmless(name + ": " + result.error().message));
      return result.error().code == Code::kBadArgument ? kExitInvalid : kExitUnreadable;
    }
    report_.fit = std::move(*result);
    const Status written = write_output(*options_.output, write_dms(report_.fit->model), out_);
    if (!written) return written.error();
    if (options_.output != "-" && options_.json != "-")
      out_.write(fold(dms_fit_text(report_), verdict_width()));
    const bool is_short = options.tolerance && !report_.fit->is_reached(*options.tolerance);
    return is_short ? kExitUndecided : kExitValid;
  }

  const DmsFitChoice& options_;
  StandardOutput& out_;
  DmsFitReport report_;
};

std::string fit_contradiction(const DmsFitChoice& o) {
  if (!o.output) return "-o OUT.vdms is required, the file of the model";
  if (!o.domain && !o.is_auto)
    return "--domain D.vdms is required, the identity on a domain, or --auto";
  if (o.domain && o.is_auto) return "--auto makes the domain, so it excludes --domain";
  if (!o.degree) return "--degree N is required, from 1 to 9";
  if (o.domain == "-" && o.data == "-") return "only one of DATA and D can be standard input";
  return "";
}

}  // namespace

RunCommand declare_dms_fit(OptionSet& set) {
  const auto o = std::make_shared<DmsFitChoice>();
  declare_plain_file(set, "DATA", o->data, "x y z and attributes a line; - is standard input");
  set.output("-o,--output", o->output, "write the model, .vdms; - is standard output");
  set.text("--domain", o->domain, "a model .vdms of degree 1: the identity on its domain", "D");
  set.flag("--auto", o->is_auto, "make the domain from DATA");
  set.number("--degree", o->degree, {1, kMaxDmsDegree}, "the degree, 1 to 9");
  set.length("--tolerance", "E", o->fit.tolerance,
             "cut tetrahedra until the mean square error of each\nattribute is at most E",
             "a mean square error");
  set.number("--max-tetrahedra", o->max_tetrahedra, {1, kMost32 >> 3},
             "cut until there are N (5000 with a tolerance, else none)");
  set.option(
      "--knots", "K",
      [o](const std::string& t) -> std::string {
        if (t != "free" && t != "fixed") return "must be free or fixed, not " + t;
        o->fit.has_free_knots = t == "free";
        return "";
      },
      "fixed (default), or free: knots move, too");
  set.repeatable(
      "--feature", "a,b,c,d",
      [o](const std::string& t) { return take_feature(t, o->fit.features); },
      "free knots on the plane ax + by + cz = d stay on it");
  declare_json(set, o->json, "write sizes, errors and rounds");
  declare_reading(set, o->reading);
  set.hide("--as-indexed");
  set.rule([o] { return fit_contradiction(*o); });
  return [o](StandardOutput& out) { return DmsFitRun(*o, out).run(); };
}

}  // namespace veritope::cli
