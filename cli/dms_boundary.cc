// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope dms boundary.
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "cli/dms_verbs.h"
#include "cli/output_plan.h"
#include "cli/progress.h"
#include "io/splines/write_splines.h"
#include "report/text_style.h"
#include "solids/dms/dms_surface.h"

namespace veritope::cli {
namespace {

struct DmsBoundaryChoice {
  std::string model;
  std::optional<std::string> output;
  ModelReadOptions reading;
};

std::string open_face_text(const TetrahedralComplex& complex, const DmsOpenFace& open) {
  const auto v = complex.vertices(open.face);
  return "the face (" + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " +
         std::to_string(v[2]) +
         ") of the boundary is not cut into parts that no triangle of knots meets";
}

ExitCode run_boundary(const DmsBoundaryChoice& o, StandardOutput& out) {
  if (o.model != "-")
    if (const Status status = refuse_same({o.model}, *o.output); !status)
      return fail(status.error());
  if (const Status status = try_output(*o.output); !status) return fail(status.error());
  const Result<DmsFile> file = read_dms_file(o.model, o.reading);
  if (!file) return fail(file.error());
  const DmsModel& model = file->model;
  if (const DmsDefects defects = find_dms_defects(model); defects.count > 0) {
    complain(harmless(dms_refusal(o.model, defects)));
    return kExitInvalid;
  }
  const TetrahedralComplex complex(model.tetrahedra,
                                   static_cast<std::uint32_t>(model.clouds.size()));
  auto patches = with_progress(o.model, "cutting the boundary", [&] {
    return boundary_patches(model, complex, {static_cast<unsigned>(default_jobs())});
  });
  if (const auto* const open = std::get_if<DmsOpenFace>(&patches)) {
    complain(harmless(o.model + ": " + open_face_text(complex, *open)));
    return kExitUndecided;
  }
  SplineModel surface;
  for (ExactTriangle& patch : std::get<0>(patches))
    surface.entities.push_back({std::move(patch), {}, std::nullopt, {}});
  const Status written = write_output(*o.output, spline_json_bytes(surface), out);
  if (!written) return fail(written.error());
  if (*o.output == "-") return kExitValid;
  const std::string text = "wrote  " + unbroken(harmless(*o.output)) + "  " +
                           counted(complex.boundary().size(), "face", "faces") + ", " +
                           counted(surface.entities.size(), "Bezier triangle", "Bezier triangles") +
                           "\n";
  out.write(fold(text, verdict_width()));
  return kExitValid;
}

}  // namespace

RunCommand declare_dms_boundary(OptionSet& set) {
  const auto o = std::make_shared<DmsBoundaryChoice>();
  declare_plain_file(set, "M", o->model, "a model .vdms");
  set.output("-o,--output", o->output, "write the surface, .vjson; - is standard output");
  declare_reading(set, o->reading);
  set.hide("--as-indexed");
  set.rule([o]() -> std::string {
    return o->output ? "" : "-o B.vjson is required, the file of the surface";
  });
  return [o](StandardOutput& out) { return run_boundary(*o, out); };
}

}  // namespace veritope::cli
