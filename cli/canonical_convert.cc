// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/canonical_convert.h"

#include <algorithm>

#include "cli/did_you_mean.h"
#include "cli/dms_verbs.h"
#include "cli/output_plan.h"
#include "io/dms/write_dms.h"
#include "io/formats.h"
#include "io/micro/write_micro.h"
#include "render/dms_cells.h"
#include "report/text_style.h"

namespace veritope::cli {
namespace {

// Options that are for other kinds, and the output file. `names` are the formats for `title`, the kind in sentences.
Status check_options(const ConvertOptions& o, ModelKind kind, const std::string& title,
                     const std::vector<std::string>& names) {
  if (o.chord) return bad_argument("--chord is for splines");
  if (o.faces) return bad_argument("--faces is for splines");
  if (o.rejoin) return bad_argument("--rejoin is for splines");
  if (o.weld) return bad_argument("--weld is for spline volumes");
  if (o.single_precision) return bad_argument("--float is for binary PLY");
  std::string either;
  for (const std::string& name : names) either += (either.empty() ? "" : " or ") + name;
  if (o.to && std::find(names.begin(), names.end(), *o.to) == names.end())
    return bad_argument("for " + title + ", --to must be " + either + ", not " + *o.to +
                        did_you_mean(*o.to, names));
  const bool is_picture = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return name == "vtu" && o.output.ends_with(".vtu");
  });
  if (!o.to && !is_picture && format_from_path(o.output, kind) == nullptr) {
    std::string endings = format_names("or", kind);
    if (names.size() > 1) endings += " or vtu";
    return bad_argument(no_target_text(o.output, title, endings));
  }
  if (Status status = refuse_same(o.input.files, o.output); !status) return status;
  return try_output(o.output);
}

ExitCode write_dms_picture(const DmsModel& model, const ConvertOptions& options,
                           StandardOutput& out) {
  if (const DmsDefects defects = find_dms_defects(model); defects.count > 0) {
    complain(harmless(dms_refusal(options.input.files[0], defects)));
    return kExitInvalid;
  }
  std::string lost;
  if (!model.attribute_domain.empty())
    lost = counted(model.attribute_domain[0].attributes.size(), "attribute", "attributes") +
           " over a domain of its own";
  if (!lost.empty() && !options.lossy) {
    complain(harmless(options.output) + ": not written, it would lose something: " + lost +
             ". --lossy writes it all the same; --to vdms keeps everything");
    return kExitInvalid;
  }
  const Result<DmsCells> cells =
      dms_cells(model, {static_cast<unsigned>(options.input.reading.jobs)});
  if (!cells) return fail(in_dms_model(cells.error(), options.input.files[0]));
  const Status written = write_output(options.output, cells->vtu, out);
  if (!written && options.output != "-") return fail(written.error());
  if (options.output == "-") {
    if (!lost.empty()) complain("lossy: " + lost);
    return kExitValid;
  }
  const std::string text = "wrote  " + unbroken(harmless(options.output)) + "  " +
                           counted(cells->num_cells, "Bezier cell", "Bezier cells") + " of " +
                           counted(model.tetrahedra.size(), "tetrahedron", "tetrahedra") +
                           ", a picture" + (lost.empty() ? "" : ", lossy: " + lost) + "\n";
  out.write(fold(text, verdict_width()));
  return kExitValid;
}

}  // namespace

ExitCode convert_micro(ModelInput& input, const ConvertOptions& options, StandardOutput& out) {
  if (const Status status =
          check_options(options, ModelKind::kMicro, "a microstructure", {"vmicro"});
      !status)
    return fail(status.error());
  const Result<ModelFile> model = input.take();
  if (!model) return fail(model.error());
  const MicroFile& file = std::get<MicroFile>(*model);
  const Status written = write_output(options.output, write_micro(file.micro), out);
  if (!written && options.output != "-") return fail(written.error());
  const std::string dropped = file.has_names_in_cage ? "groups and attributes of the cage" : "";
  if (options.output == "-") {
    if (!dropped.empty()) complain("not part of the model, dropped: " + dropped);
    return kExitValid;
  }
  const std::string text =
      "wrote  " + unbroken(harmless(options.output)) + "  " +
      counted(file.micro.grids.size(), "grid", "grids") + ", nothing lost\n" +
      (dropped.empty() ? "" : "  not part of the model, dropped: " + dropped + "\n");
  out.write(fold(text, verdict_width()));
  return kExitValid;
}

ExitCode convert_dms(ModelInput& input, const ConvertOptions& options, StandardOutput& out) {
  if (const Status status =
          check_options(options, ModelKind::kDms, "a simplex-spline solid", {"vdms", "vtu"});
      !status)
    return fail(status.error());
  const Result<ModelFile> model = input.take();
  if (!model) return fail(model.error());
  const DmsModel& dms = std::get<DmsFile>(*model).model;
  const bool is_picture = options.to ? *options.to == "vtu" : options.output.ends_with(".vtu");
  if (is_picture) return write_dms_picture(dms, options, out);
  const Status written = write_output(options.output, write_dms(dms), out);
  if (!written && options.output != "-") return fail(written.error());
  if (options.output == "-") return kExitValid;
  const std::string text = "wrote  " + unbroken(harmless(options.output)) + "  " +
                           counted(dms.tetrahedra.size(), "tetrahedron", "tetrahedra") +
                           ", nothing lost\n";
  out.write(fold(text, verdict_width()));
  return kExitValid;
}

}  // namespace veritope::cli
