// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/info_report.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "io/formats.h"
#include "report/json_text.h"
#include "report/mesh_report_internal.h"
#include "report/report_text.h"
#include "solids/polyhedron/box_order.h"

namespace veritope::report {
namespace {

struct MicroCounts {
  std::uint64_t cells = 0;
  std::uint64_t tiles = 0;                           // cells that hold one
  std::optional<std::array<std::int32_t, 2>> range;  // of all tiles together
};

MicroCounts counts_of(const Microstructure& micro) {
  MicroCounts out;
  for (const MicroGrid& grid : micro.grids) {
    out.cells += grid.tiles.size();
    const auto empty = std::count(grid.tiles.begin(), grid.tiles.end(), std::uint8_t{0});
    out.tiles += grid.tiles.size() - static_cast<std::uint64_t>(empty);
  }
  for (const MicroTile& tile : micro.tiles) {
    if (!tile.range) continue;
    if (!out.range) out.range = tile.range;
    (*out.range)[0] = std::min((*out.range)[0], (*tile.range)[0]);
    (*out.range)[1] = std::max((*out.range)[1], (*tile.range)[1]);
  }
  return out;
}

void put_micro(const Microstructure& micro, Json& out) {
  const MicroCounts counts = counts_of(micro);
  out["counts"] = {{"volumes", micro.cage.size()},
                   {"grids", micro.grids.size()},
                   {"cells", counts.cells},
                   {"tiles", counts.tiles},
                   {"different_tiles", micro.tiles.size()},
                   {"bridges", micro.num_bridges()}};
  out["range"] = counts.range ? Json(*counts.range) : Json(nullptr);
}

std::string micro_lines(const Microstructure& micro) {
  const MicroCounts counts = counts_of(micro);
  std::string out = detail_line("cage", counted(micro.cage.size(), "volume", "volumes") + ", " +
                                            counted(micro.grids.size(), "grid", "grids") + ", " +
                                            counted(counts.cells, "cell", "cells"));
  out += detail_line("tiles", counted(counts.tiles, "tile", "tiles") + ", " +
                                  std::to_string(micro.tiles.size()) + " different");
  if (micro.num_bridges() != 0)
    out += detail_line("bridges", counted(micro.num_bridges(), "bridge", "bridges") +
                                      (micro.sweeps.empty() ? "" : " in space"));
  if (counts.range)
    out += detail_line("range", "numbers of walls from " + std::to_string((*counts.range)[0]) +
                                    "/2^20 to " + std::to_string((*counts.range)[1]) + "/2^20");
  return out;
}

struct DmsCounts {
  std::uint64_t knots = 0;
  std::uint64_t collapsed = 0;  // clouds
};

DmsCounts counts_of(const DmsModel& model) {
  DmsCounts out;
  for (const DmsCloud& cloud : model.clouds) {
    out.knots += cloud.size();
    out.collapsed += cloud.size() == 1 ? 1 : 0;
  }
  return out;
}

void put_dms(const DmsModel& model, Json& out) {
  const DmsCounts counts = counts_of(model);
  out["degree"] = model.degree;
  out["attributes"] = model.attributes;
  out["control"] = model.control.is_separate ? "separate" : "shared";
  out["counts"] = {{"vertices", model.clouds.size()},
                   {"knots", counts.knots},
                   {"collapsed", counts.collapsed},
                   {"tetrahedra", model.tetrahedra.size()},
                   {"control_points", model.num_control()}};
}
void put_dms_domains(const DmsModel& model, Json& out) {
  put_dms(model, out);
  Json& own = out["attribute_domain"] = nullptr;
  for (const DmsModel& domain : model.attribute_domain) put_dms(domain, own);
}

std::string dms_lines(const DmsModel& model, bool is_own = false) {
  const DmsCounts counts = counts_of(model);
  std::string names;
  for (const std::string& name : model.attributes)
    names += (names.empty() ? "" : ", ") + harmless(name);
  std::string out = detail_line(is_own ? "attribute domain" : "domain",
                                counted(model.tetrahedra.size(), "tetrahedron", "tetrahedra") +
                                    ", " + counted(model.clouds.size(), "vertex", "vertices") +
                                    ", " + counted(counts.knots, "knot", "knots") + ", " +
                                    counted(counts.collapsed, "cloud", "clouds") + " collapsed");
  out += detail_line(is_own ? "functions" : "map",
                     "degree " + std::to_string(model.degree) + ", " +
                         counted(model.num_control(), "control point", "control points") +
                         (model.control.is_separate ? ", separate" : ", shared"));
  if (!names.empty()) out += detail_line("attributes", names);
  for (const DmsModel& own : model.attribute_domain) out += dms_lines(own, true);
  return out;
}

// The facts that a file of every kind has.
std::string plain_json(const InfoReport& report, const ModelFile& file) {
  Json out;
  out["path"] = report.path;
  out["sha256"] = sha256_of(file);
  out["bytes"] = num_bytes(file);
  out["format"] = model_format(format_of(file)).name;
  out["exit"] = static_cast<int>(report.exit);
  out["error"] = fault_json(report.fault);
  if (const auto* const micro = std::get_if<MicroFile>(&file)) put_micro(micro->micro, out);
  if (const auto* const dms = std::get_if<DmsFile>(&file)) put_dms_domains(dms->model, out);
  return dump(out);
}

std::string plain_text(const InfoReport& report, const ModelFile& file, const Style& style) {
  const std::string format = model_format(format_of(file)).name;
  const auto* const micro = std::get_if<MicroFile>(&file);
  const auto* const dms = std::get_if<DmsFile>(&file);
  return style.bold(unbroken(shown_path(report.path))) + "\n" +
         detail_line("file", format + ", " + counted(num_bytes(file), "byte", "bytes")) +
         detail_line("sha256", sha256_of(file)) + detail_line("model", title_of(kind_of(file))) +
         (micro != nullptr ? micro_lines(micro->micro) : "") +
         (dms != nullptr ? dms_lines(dms->model) : "") +
         style.dim("  Whether it bounds a solid: veritope certify FILE") + "\n";
}

}  // namespace

std::string info_json(const InfoReport& report) {
  if (report.other) return plain_json(report, *report.other);
  const MeshFile* const file = report.file ? &*report.file : nullptr;
  const ReadReport* const r = file != nullptr ? &file->report : nullptr;
  const auto count = [r](std::uint64_t ReadReport::*member) {
    return r != nullptr ? Json(r->*member) : Json(nullptr);
  };
  Json out;
  out["path"] = report.path;
  out["sha256"] = file != nullptr ? Json(file->sha256) : Json(nullptr);
  out["bytes"] = count(&ReadReport::bytes);
  out["format"] = r == nullptr           ? Json(nullptr)
                  : r->container.empty() ? Json(mesh_format_name(r->format))
                                         : Json(r->container);
  out["variant"] = r != nullptr ? Json(r->variant) : Json(nullptr);
  out["as_indexed"] = report.as_indexed;
  out["exit"] = static_cast<int>(report.exit);
  out["error"] = fault_json(report.fault);
  out["counts"] = {
      {"vertices", count(&ReadReport::file_vertices)},
      {"faces", file != nullptr ? Json(file->mesh.faces.size()) : Json(nullptr)},
      {"distinct_vertices", count(&ReadReport::distinct_vertices)},
      {"referenced_vertices", count(&ReadReport::referenced_vertices)},
      {"unreferenced_vertices", count(&ReadReport::unreferenced_vertices)},
      {"polygons_split", count(&ReadReport::polygons_split)},
      {"strip_joints", count(&ReadReport::strip_joints)},
  };
  out["bbox"] = file != nullptr ? box_json(bounding_box_of_faces(file->mesh, 1)) : Json(nullptr);
  out["ignored"] = internal::ignored_json(r);
  out["notices"] = internal::notices_json(r);
  out["lossless"] = report.lossless;
  out["seconds"] = {{"read", file != nullptr ? seconds_json(file->seconds_read) : Json(nullptr)},
                    {"parse", file != nullptr ? seconds_json(file->seconds_parse) : Json(nullptr)}};
  return dump(out);
}

std::string info_text(const InfoReport& report, const Style& style) {
  if (report.other) return plain_text(report, *report.other, style);
  const std::string path = style.bold(unbroken(shown_path(report.path)));
  if (!report.file) {
    return style.yellow(verdict_word(std::nullopt)) + "  " + path + "  " +
           (report.fault ? harmless(text_of(*report.fault)) : "") + "\n";
  }
  const ReadReport& r = report.file->report;
  std::string out = path + "\n" + internal::file_text(r);
  out += detail_line("sha256", report.file->sha256);
  out += detail_line("mesh", counted(report.file->mesh.faces.size(), "face", "faces") + ", " +
                                 internal::vertices_text(r));
  if (r.polygons_split != 0) {
    out += detail_line("polygons", std::to_string(r.polygons_split) + " cut into triangles");
  }
  if (r.strip_joints != 0)
    out += detail_line("strips", std::to_string(r.strip_joints) + " joints dropped");
  out += internal::ignored_text(r);
  out += internal::notices_text(r);
  out += internal::box_text(bounding_box_of_faces(report.file->mesh, 1));
  std::string names;
  for (const std::string& name : report.lossless) names += (names.empty() ? "" : ", ") + name;
  out += detail_line("lossless as", report.holds_everywhere ? "every format" : names);
  return out + style.dim("  Whether it bounds a solid: veritope certify FILE") + "\n";
}

}  // namespace veritope::report
