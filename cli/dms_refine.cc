// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope dms refine.
#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "cli/dms_verbs.h"
#include "cli/output_plan.h"
#include "io/dms/write_dms.h"
#include "report/text_style.h"
#include "solids/dms/dms_insert.h"

namespace veritope::cli {
namespace {

struct DmsRefineChoice {
  std::string model;
  std::optional<std::string> output;
  std::optional<DmsPoint> at;
  DmsCloud others;  // t_1, t_2, ...
  ModelReadOptions reading;
};

std::string take_at(const std::string& text, std::optional<DmsPoint>& at) {
  return take_dms_point(text, at.emplace());
}

// "x,y,z;x,y,z;..."
std::string take_cloud(std::string_view text, DmsCloud& cloud) {
  cloud.clear();
  for (bool is_more = true; is_more;) {
    const std::size_t end = std::min(text.find(';'), text.size());
    if (std::string wrong = take_dms_point(text.substr(0, end), cloud.emplace_back());
        !wrong.empty())
      return wrong;
    is_more = end < text.size();
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return "";
}

ExitCode refuse_dms(const std::string& why) {
  complain(harmless(why));
  return kExitInvalid;
}

ExitCode run_refine(const DmsRefineChoice& o, StandardOutput& out) {
  if (o.model != "-")
    if (const Status status = refuse_same({o.model}, *o.output); !status)
      return fail(status.error());
  if (const Status status = try_output(*o.output); !status) return fail(status.error());
  const Result<DmsFile> file = read_dms_file(o.model, o.reading);
  if (!file) return fail(file.error());
  if (const DmsDefects defects = find_dms_defects(file->model); defects.count > 0)
    return refuse_dms(dms_refusal(o.model, defects));
  if (file->model.control.is_separate)
    return refuse_dms(o.model + ": refine needs shared control points, and these are separate");
  DmsCloud cloud{*o.at};
  cloud.insert(cloud.end(), o.others.begin(), o.others.end());
  const Result<DmsInsertion> inserted = insert_dms_vertex(file->model, cloud);
  if (!inserted) return fail(inserted.error());
  if (inserted->defects.count > 0)
    return refuse_dms(dms_refusal("with the new vertex", inserted->defects));
  const DmsModel& model = inserted->model;
  const Status written = write_output(*o.output, write_dms(model), out);
  if (!written) return fail(written.error());
  if (*o.output == "-") return kExitValid;
  const std::string text = "wrote  " + unbroken(harmless(*o.output)) + "  vertex " +
                           std::to_string(model.clouds.size() - 1) + " in tetrahedron " +
                           std::to_string(inserted->tetrahedron) + ", " +
                           counted(model.tetrahedra.size(), "tetrahedron", "tetrahedra") + ", " +
                           counted(model.num_control(), "control point", "control points") + "\n";
  out.write(fold(text, verdict_width()));
  return kExitValid;
}

}  // namespace

RunCommand declare_dms_refine(OptionSet& set) {
  const auto o = std::make_shared<DmsRefineChoice>();
  declare_plain_file(set, "M", o->model, "a model .vdms with shared control points");
  set.output("-o,--output", o->output, "write the model, .vdms; - is standard output");
  set.option(
      "--at", "X,Y,Z", [o](const std::string& t) { return take_at(t, o->at); },
      "the vertex: a point inside of a tetrahedron, exact");
  set.option(
      "--cloud", "C", [o](const std::string& t) { return take_cloud(t, o->others); },
      "its further knots, x,y,z;x,y,z;...: one less than the\ndegree, or as many; without, it is "
      "collapsed");
  declare_reading(set, o->reading);
  set.hide("--as-indexed");
  set.rule([o]() -> std::string {
    if (!o->output) return "-o OUT.vdms is required, the file of the model";
    return o->at ? "" : "--at x,y,z is required, the new vertex";
  });
  return [o](StandardOutput& out) { return run_refine(*o, out); };
}

}  // namespace veritope::cli
