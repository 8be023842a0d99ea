// SPDX-License-Identifier: LGPL-3.0-or-later
#include "report/render_report.h"

#include "report/json_text.h"
#include "verify/certify/certify.h"

namespace veritope::report {
namespace {

Json grid_json(const GridCounts& grid) {
  return {{"n", grid.n},
          {"in", grid.in},
          {"on", grid.on},
          {"out", grid.out},
          {"undecided", grid.undecided}};
}

Json picture_json(const RenderReport& report) {
  Json out;
  out["path"] = report.picture;
  out["width"] = report.size ? Json((*report.size)[0]) : Json(nullptr);
  out["height"] = report.size ? Json((*report.size)[1]) : Json(nullptr);
  return out;
}

Json cells_json(const CellPicture& cells) {
  return {{"count", cells.count}, {"explode", cells.explode}, {"nets", cells.has_nets}};
}

Json curves_json(const CurvePicture& curves) {
  return {{"curves", curves.curves},
          {"sheets", curves.sheets},
          {"bridges", curves.bridges},
          {"around", curves.around ? Json(*curves.around) : Json(nullptr)}};
}

Json micro_json(const MicroPicture& micro) {
  return {{"tiles", micro.tiles},
          {"bridges", micro.bridges},
          {"cage", micro.has_cage},
          {"around", micro.around ? Json(*micro.around) : Json(nullptr)}};
}

Json rays_json(const DmsRays& rays) {
  return {{"origin", point_json(rays.origin)},
          {"right", point_json(rays.right)},
          {"down", point_json(rays.down)},
          {"along", point_json(rays.along)}};
}

Json dms_json(const DmsPicture& dms) {
  Json out;
  out["mode"] = dms.mode;
  out["attribute"] = text_json(dms.attribute);
  out["space"] = dms.in_solid ? "solid" : "domain";
  out["rays"] = dms.rays ? rays_json(*dms.rays) : Json(nullptr);
  out["range"] = dms.range ? Json::array({(*dms.range)[0], (*dms.range)[1]}) : Json(nullptr);
  out["absorption"] = optional_json(dms.absorption);
  out["error"] = optional_json(dms.error);
  out["step"] = optional_json(dms.step);
  out["certified"] = optional_json(dms.certified);
  return out;
}

}  // namespace

std::string render_json(const RenderReport& report) {
  Json out, bounds = Json::array();
  for (std::size_t i = 0; i < 6; ++i)
    bounds.push_back((i < 3 ? report.bounds[i].lo : report.bounds[i - 3].hi).to_string());
  out["schema"] = "veritope-render-1";
  out["tool"] = tool_name();
  out["model"] = {{"path", report.path}, {"sha256", report.sha256}};
  out["picture"] = picture_json(report);
  out["bounds"] = bounds;
  out["grid"] = report.grid ? grid_json(*report.grid) : Json(nullptr);
  out["cells"] = report.cells ? cells_json(*report.cells) : Json(nullptr);
  out["micro"] = report.micro ? micro_json(*report.micro) : Json(nullptr);
  out["curves"] = report.curves ? curves_json(*report.curves) : Json(nullptr);
  out["dms"] = report.dms ? dms_json(*report.dms) : Json(nullptr);
  out["seconds"] = {{"read", seconds_json(report.seconds_read)},
                    {"build", seconds_json(report.seconds_build)},
                    {"draw", seconds_json(report.seconds_draw)}};
  return dump(out) + "\n";
}

}  // namespace veritope::report
