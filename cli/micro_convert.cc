// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/micro_convert.h"

#include "cli/output_plan.h"
#include "io/dms/write_dms.h"
#include "io/formats.h"
#include "io/micro/write_micro.h"
#include "report/text_style.h"

namespace veritope::cli {
namespace {

// For a kind with one format, `name`; `title` is the kind in sentences.
Status check_canonical_options(const ConvertOptions& o, ModelKind kind, const std::string& title,
                               const std::string& name) {
  if (o.chord) return bad_argument("--chord is for splines");
  if (o.faces) return bad_argument("--faces is for splines");
  if (o.rejoin) return bad_argument("--rejoin is for splines");
  if (o.weld) return bad_argument("--weld is for spline volumes");
  if (o.single_precision) return bad_argument("--float is for binary PLY");
  if (o.to && *o.to != name)
    return bad_argument("for " + title + ", --to must be " + name + ", not " + *o.to);
  if (!o.to && format_from_path(o.output, kind) == nullptr)
    return bad_argument(no_target_text(o.output, title, format_names("or", kind)));
  if (Status status = refuse_same(o.input.files, o.output); !status) return status;
  return try_output(o.output);
}

}  // namespace

ExitCode convert_micro(ModelInput& input, const ConvertOptions& options, StandardOutput& out) {
  if (const Status status =
          check_canonical_options(options, ModelKind::kMicro, "a microstructure", "vmicro");
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
          check_canonical_options(options, ModelKind::kDms, "a simplex-spline solid", "vdms");
      !status)
    return fail(status.error());
  const Result<ModelFile> model = input.take();
  if (!model) return fail(model.error());
  const DmsModel& dms = std::get<DmsFile>(*model).model;
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
