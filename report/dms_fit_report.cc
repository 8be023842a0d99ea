// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/dms_fit_report.h"

#include <algorithm>
#include <vector>

#include "report/decimal_text.h"
#include "report/dms_defects_json.h"
#include "report/json_text.h"
#include "report/text_style.h"
#include "verify/certify/certify.h"

namespace veritope::report {
namespace {

constexpr std::size_t kMaxListed = 1000;

std::size_t num_knots(const DmsModel& model) {
  std::size_t knots = 0;
  for (const DmsCloud& cloud : model.clouds) knots += cloud.size();
  return knots;
}

template <typename T>
Json first_json(const std::vector<T>& numbers) {
  Json out = Json::array();
  for (std::size_t i = 0; i < std::min(numbers.size(), kMaxListed); ++i) out.push_back(numbers[i]);
  return out;
}

Json numbers_json(const std::vector<double>& numbers) {
  Json out = Json::array();
  for (const double x : numbers) out.push_back(number_json(x));
  return out;
}

Json rounds_json(const std::vector<DmsFitRound>& rounds) {
  Json out = Json::array();
  for (const DmsFitRound& round : rounds)
    out.push_back({{"tetrahedra", round.tetrahedra},
                   {"control_points", round.control_points},
                   {"knots", round.knots},
                   {"attribute_mse", numbers_json(round.attribute_mse)},
                   {"max_error", numbers_json(round.max_error)}});
  return out;
}

std::string list_text(const std::vector<double>& numbers) {
  std::string text;
  for (const double x : numbers) text += (text.empty() ? "" : ", ") + short_decimal(x);
  return text;
}

}  // namespace

std::string dms_fit_json(const DmsFitReport& report) {
  Json out;
  out["schema"] = "veritope-dms-fit-1";
  out["tool"] = tool_name();
  out["domain"] = nullptr;
  if (const auto& d = report.domain)
    out["domain"] = {{"path", d->path}, {"sha256", d->sha256}, {"bytes", d->bytes}};
  out["auto"] = nullptr;
  if (const auto& a = report.automatic)
    out["auto"] = {{"kind", a->kind},
                   {"spacing", number_json(a->spacing)},
                   {"vertices", a->vertices},
                   {"tetrahedra", a->tetrahedra},
                   {"gradient_splits", a->gradient_splits}};
  out["data"] = report.data;
  out["output"] = report.output;
  out["defects"] = dms_defects_json(report.defects);
  for (const char* key : {"degree", "attributes", "points", "outside", "outside_points",
                          "conflicts", "conflict_points", "tetrahedra", "control_points", "knots",
                          "geometry_mse", "attribute_mse", "max_error", "undetermined",
                          "undetermined_control", "tolerance", "reached", "end", "rounds"})
    out[key] = nullptr;
  if (report.fit) {
    const DmsFit& fit = *report.fit;
    out["degree"] = fit.model.degree;
    out["attributes"] = fit.model.attributes;
    out["points"] = fit.num_points;
    out["outside"] = fit.outside.size();
    out["outside_points"] = first_json(fit.outside);
    out["conflicts"] = fit.conflicts.size();
    out["conflict_points"] = first_json(fit.conflicts);
    out["tetrahedra"] = fit.model.tetrahedra.size();
    out["control_points"] = fit.model.num_control();
    out["knots"] = num_knots(fit.model);
    out["geometry_mse"] = number_json(fit.errors.geometry_mse);
    out["attribute_mse"] = numbers_json(fit.errors.attribute_mse);
    out["max_error"] = numbers_json(fit.errors.max_error);
    out["undetermined"] = fit.undetermined.size();
    out["undetermined_control"] = first_json(fit.undetermined);
    out["tolerance"] = optional_json(report.tolerance);
    if (report.tolerance) out["reached"] = fit.is_reached(*report.tolerance);
    out["end"] = fit_end_name(fit.end);
    out["rounds"] = rounds_json(fit.rounds);
  }
  out["seconds"] = seconds_json(report.seconds);
  return dump(out) + "\n";
}

std::string dms_fit_text(const DmsFitReport& report) {
  const DmsFit& fit = *report.fit;
  std::string text = "wrote  " + unbroken(harmless(report.output)) + "  degree " +
                     std::to_string(fit.model.degree) + ", " +
                     counted(fit.model.tetrahedra.size(), "tetrahedron", "tetrahedra") + ", " +
                     counted(num_knots(fit.model), "knot", "knots") + ", " +
                     counted(fit.model.num_control(), "control point", "control points") + "\n";
  if (const auto& a = report.automatic)
    text += "  the domain is " +
            std::string(a->kind == "hull" ? "the convex hull of the data"
                                          : "what the data occupy, by their distances") +
            ": " + counted(a->tetrahedra, "tetrahedron", "tetrahedra") + " at the beginning\n";
  text += "  mean square error: " + list_text(fit.errors.attribute_mse) +
          "; largest error: " + list_text(fit.errors.max_error) + "\n";
  if (report.tolerance)
    text += std::string("  the tolerance is ") +
            (fit.is_reached(*report.tolerance)
                 ? "reached\n"
                 : "not reached: " + std::string(fit_end_name(fit.end)) + "\n");
  if (!fit.outside.empty())
    text += "  " + counted(fit.outside.size(), "point lies", "points lie") +
            " outside of the domain, the first one is point " + std::to_string(fit.outside[0]) +
            "\n";
  if (!fit.conflicts.empty())
    text += "  " + counted(fit.conflicts.size(), "point lies", "points lie") +
            " where another point has other values, the first one is point " +
            std::to_string(fit.conflicts[0]) + ": no function agrees with both\n";
  if (!fit.undetermined.empty())
    text += "  the data do not determine " +
            counted(fit.undetermined.size(), "control point", "control points") +
            ", which are as smooth as they can be\n";
  return text;
}

}  // namespace veritope::report
