// SPDX-License-Identifier: LGPL-3.0-or-later
// Projections as JSON and as text. The schema: docs/report.schema.json, projection.
#include "report/decimal_text.h"
#include "report/json_text.h"
#include "report/projection_report.h"
#include "verify/certify/certify.h"

namespace veritope::report {
namespace {

const char* place_name(RootPlace place) {
  switch (place) {
    case RootPlace::kInside: return "inside";
    case RootPlace::kOnBoundary: return "on-boundary";
    case RootPlace::kAtBoundary: return "at-boundary";
  }
  return "at-boundary";
}

template <std::size_t N>
Json exact_box_json(const ExactBox<N>& box) {
  Json out = Json::array();
  for (const ExactInterval& s : box.side)
    out.push_back(Json::array({fraction_text(s.lo), fraction_text(s.hi)}));
  return out;
}

template <std::size_t N>
Json point_json(const CriticalPoint<N>& p) {
  Json out, position = Json::array();
  for (const Interval& x : p.point) position.push_back(interval_json(x));
  out["parameters"] = exact_box_json(p.parameters);
  out["held"] = p.is_held;
  out["place"] = place_name(p.place);
  out["kind"] = critical_kind_name(p.kind);
  out["position"] = position;
  out["distance"] = interval_json(p.distance);
  return out;
}

template <std::size_t N>
void describe(Json& out, const Projection<N>& p) {
  Json points = Json::array(), open = Json::array();
  for (const auto& c : p.points) points.push_back(point_json(c));
  for (const auto& r : p.open)
    open.push_back({{"parameters", exact_box_json(r.parameters)},
                    {"reason", open_reason_name(r.reason)},
                    {"distance", interval_json(r.distance)}});
  out["points"] = points;
  out["open"] = open;
  out["distance"] = interval_json(p.least_distance);
  out["nearest"] = optional_json(p.certified_nearest);
  out["effort"] = {
      {"boxes", p.effort.boxes}, {"frames", p.effort.frames}, {"bits", p.effort.precision}};
}

}  // namespace

std::string projection_json(const ProjectionReport& report) {
  Json out, point = Json::array(), targets = Json::array();
  for (const Rational& x : report.point) point.push_back(fraction_text(x));
  for (const ProjectionTarget& t : report.targets) {
    Json target;
    target["entity"] = t.entity;
    target["face"] = optional_json(t.face);
    target["kind"] = t.kind;
    std::visit([&](const auto& p) { describe(target, p); }, t.projection);
    targets.push_back(target);
  }
  const auto nearest = report.nearest();
  out["schema"] = "veritope-project-1";
  out["tool"] = tool_name();
  out["path"] = report.path;
  out["sha256"] = report.sha256;
  out["point"] = point;
  out["targets"] = targets;
  out["skipped_volumes"] = report.skipped_volumes;
  out["skipped_triangles"] = report.skipped_triangles;
  out["distance"] = interval_json(report.distance());
  out["nearest"] =
      nearest ? Json({{"target", nearest->first}, {"point", nearest->second}}) : Json(nullptr);
  out["complete"] = report.is_complete();
  return dump(out) + "\n";
}

}  // namespace veritope::report
