// SPDX-License-Identifier: LGPL-3.0-or-later
// Spline reports as JSON. The schema: docs/report.schema.json, info_spline_file.
#include "report/decimal_text.h"
#include "report/json_text.h"
#include "report/spline_report.h"

namespace veritope::report {
namespace {

std::string name_of(const SplineModel& model, const SplineEntity& entity) {
  for (auto g = entity.group; g; g = model.groups[*g].parent)
    if (!model.groups[*g].name.empty()) return model.groups[*g].name;
  return "";
}

Json spline_box_json(const std::vector<ExactInterval>& box) {
  if (box.empty()) return nullptr;
  Json lo = Json::array(), hi = Json::array();
  for (const ExactInterval& s : box) {
    lo.push_back(number_json(round_down(s.lo)));
    hi.push_back(number_json(round_up(s.hi)));
  }
  return {{"min", lo}, {"max", hi}};
}

std::size_t num_spans(const KnotAxis<Rational>& axis) {
  std::size_t spans = 0;
  for (auto i = static_cast<std::size_t>(axis.degree); i < axis.num_control(); ++i)
    spans += axis.knots[i] < axis.knots[i + 1] ? 1u : 0u;
  return spans;
}

template <std::size_t N>
void describe(Json& out, const BSpline<Rational, N>& s) {
  out["dimension"] = s.dimension();
  out["rational"] = s.is_rational();
  Json axes = Json::array();
  for (const auto& axis : s.axes())
    axes.push_back({{"degree", axis.degree},
                    {"control_points", axis.num_control()},
                    {"spans", num_spans(axis)},
                    {"periodic", axis.is_periodic},
                    {"domain", Json::array({fraction_text(axis.domain_begin()),
                                            fraction_text(axis.domain_end())})}});
  out["axes"] = axes;
}

void describe(Json& out, const ExactTriangle& t) {
  out["dimension"] = t.dimension();
  out["rational"] = t.is_rational();
  out["axes"] = nullptr;
}

Json entity_json(const SplineModel& model, const SplineEntity& entity) {
  Json out;
  out["kind"] = spline_kind_name(entity);
  out["name"] = name_of(model, entity);
  out["line"] = optional_json(entity.place.line);
  std::size_t loops = 0, surfaces = 0;
  Json degree = nullptr;
  if (const auto* t = std::get_if<TrimmedSurface>(&entity.shape)) {
    describe(out, t->surface);
    loops = t->loops.size();
  } else if (const auto* b = std::get_if<SplineBrep>(&entity.shape)) {
    int dimension = 0;
    bool is_rational = false;
    for (const BrepFace& face : b->faces) {
      dimension = std::max(dimension, face.surface.dimension());
      is_rational = is_rational || face.surface.is_rational();
      loops += face.loops.size();
    }
    out["dimension"] = dimension;
    out["rational"] = is_rational;
    out["axes"] = nullptr;
    surfaces = b->faces.size();
  } else if (const auto* triangle = std::get_if<ExactTriangle>(&entity.shape)) {
    describe(out, *triangle);
    degree = triangle->degree();
  } else {
    for_each_spline(entity, [&](const auto& s) { describe(out, s); });
  }
  out["degree"] = degree;
  out["loops"] = loops;
  out["surfaces"] = surfaces;
  out["bbox"] = spline_box_json(control_box(entity));
  out["attributes"] = entity.attributes;
  return out;
}

Json counts_json(const SplineModel* model) {
  Json out;
  const auto put = [&](const char* key, std::uint64_t n) {
    out[key] = model != nullptr ? Json(n) : Json(nullptr);
  };
  const auto splines = model != nullptr ? count_splines(*model) : std::array<std::uint64_t, 3>{};
  std::uint64_t trimmed = 0, models = 0;
  if (model != nullptr)
    for (const SplineEntity& e : model->entities) {
      trimmed += std::holds_alternative<TrimmedSurface>(e.shape) ? 1u : 0u;
      models += std::holds_alternative<SplineBrep>(e.shape) ? 1u : 0u;
    }
  put("entities", model != nullptr ? model->entities.size() : 0);
  put("curves", splines[0]);
  put("surfaces", splines[1]);
  put("volumes", splines[2]);
  put("trimmed", trimmed);
  put("models", models);
  put("triangles", model != nullptr ? count_triangles(*model) : 0);
  return out;
}

}  // namespace

std::string spline_json(const SplineReport& report) {
  const SplineFile* const file = report.file ? &*report.file : nullptr;
  Json left_out = Json::array(), entities = Json::array();
  std::vector<ExactInterval> all;
  if (file != nullptr) {
    for (const LeftOut& l : file->left_out)
      left_out.push_back({{"what", l.what},
                          {"reason", l.reason},
                          {"geometry", l.is_geometry},
                          {"count", l.count}});
    for (const SplineEntity& e : file->model.entities) {
      entities.push_back(entity_json(file->model, e));
      unite(all, control_box(e));
    }
  }
  Json out;
  out["path"] = report.path;
  out["sha256"] = file != nullptr ? Json(file->sha256) : Json(nullptr);
  out["bytes"] = file != nullptr ? Json(file->bytes) : Json(nullptr);
  out["spline_format"] = file != nullptr ? Json(spline_format_name(file->format)) : Json(nullptr);
  out["exit"] = static_cast<int>(report.exit);
  out["error"] = fault_json(report.fault);
  out["counts"] = counts_json(file != nullptr ? &file->model : nullptr);
  out["bbox"] = spline_box_json(all);
  out["left_out"] = std::move(left_out);
  out["entities"] = std::move(entities);
  out["lossless"] = report.lossless;
  return dump(out);
}

}  // namespace veritope::report
