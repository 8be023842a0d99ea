// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope dms iso.
#include <memory>
#include <utility>
#include <variant>

#include "cli/dms_verbs.h"
#include "cli/option_groups.h"
#include "cli/progress.h"
#include "io/base/exact_number.h"
#include "io/formats.h"
#include "io/mesh/write_mesh.h"
#include "report/dms_report.h"
#include "report/text_style.h"
#include "robust/base/stopwatch.h"
#include "solids/dms/dms_iso.h"

namespace veritope::cli {
namespace {

struct DmsIsoChoice {
  std::string model;
  std::optional<std::string> attribute, output, json;
  std::optional<Rational> level, within;
  bool in_solid = false;
  std::optional<std::uint64_t> max_cells;
  ModelReadOptions reading;
};

std::string take_number(const std::string& text, std::optional<Rational>& target) {
  Rational number;
  if (read_exact_number(text, {}, number) != DecimalFault::kNone)
    return "must be a number, not " + text;
  target = std::move(number);
  return "";
}

std::optional<MeshFormat> surface_format(const std::string& path) {
  const ModelFormat* const format = format_from_path(path, ModelKind::kMesh);
  const auto* const id = format == nullptr ? nullptr : std::get_if<MeshFormat>(&format->id);
  return id == nullptr || *id == MeshFormat::kStl ? std::nullopt : std::optional(*id);
}

class DmsIsoRun {
 public:
  DmsIsoRun(const DmsIsoChoice& options, StandardOutput& out) : options_(options), out_(out) {}

  ExitCode run() {
    if (const Status status = try_dms_outputs({options_.model}, options_.output, options_.json);
        !status)
      return fail(status.error());
    Stopwatch watch;
    const Result<DmsFile> file = read_dms_file(options_.model, options_.reading);
    if (!file) return fail(file.error());
    const Result<DmsComponent> component = dms_component(file->model, *options_.attribute);
    if (!component) return fail(component.error());
    report_.path = options_.model;
    report_.sha256 = file->sha256;
    report_.bytes = file->bytes;
    report_.attribute = *options_.attribute;
    report_.level = *options_.level;
    report_.within = *options_.within;
    report_.in_solid = options_.in_solid;
    report_.defects = find_dms_defects(file->model, kMaxListed);
    if (report_.defects.count != 0) {
      complain(harmless(dms_refusal(options_.model, report_.defects)));
      report_.seconds = watch.lap();
      return finish(kExitInvalid);
    }
    if (const Status status = find(file->model, *component); !status) return fail(status.error());
    report_.seconds = watch.lap();
    if (const Status status = write_mesh(); !status) return fail(status.error());
    if (options_.json != "-" && options_.output != "-")
      out_.write(fold(summary(), verdict_width()));
    return finish(report_.iso->certified ? kExitValid : kExitUndecided);
  }

 private:
  static constexpr std::size_t kMaxListed = 100;

  Status find(const DmsModel& model, const DmsComponent& component) {
    DmsIsoOptions options;
    options.attribute = component.component - component.spline->num_coordinates;
    options.map = &model;
    options.level = report_.level;
    options.within = report_.within;
    options.in_solid = options_.in_solid;
    if (options_.max_cells) options.max_cells = static_cast<std::size_t>(*options_.max_cells);
    Result<DmsIso> iso = with_progress(options_.model, "finding the surface", [&] {
      return find_dms_iso(*component.spline, options, kMaxListed);
    });
    if (!iso) return in_dms_model(iso.error(), options_.model);
    report_.iso = std::move(*iso);
    return ok_status();
  }

  Status write_mesh() {
    const WriteOptions how = default_write_options(*surface_format(*options_.output));
    const Result<std::string> bytes = mesh_to_bytes(report_.iso->mesh, how);
    if (!bytes) return bytes.error();
    return write_output(*options_.output, *bytes, out_);
  }

  std::string summary() const {
    const DmsIso& iso = *report_.iso;
    std::string text = std::string(iso.certified ? "certified" : "not certified") + "  " +
                       unbroken(harmless(*options_.output)) + "  " +
                       counted(iso.components, "component", "components") + ", euler " +
                       std::to_string(iso.euler) + ", " +
                       counted(iso.mesh.faces.size(), "triangle", "triangles") + "\n";
    if (iso.obstacle) text += "  " + *iso.obstacle + "\n";
    if (iso.num_undecided > 0)
      text += "  " + counted(iso.num_undecided, "cell is", "cells are") + " in doubt\n";
    return text;
  }

  ExitCode finish(ExitCode exit) {
    if (!options_.json) return exit;
    const Status written = write_output(*options_.json, dms_iso_json(report_), out_);
    return written ? exit : first_of(exit, fail(written.error()));
  }

  const DmsIsoChoice& options_;
  StandardOutput& out_;
  DmsIsoReport report_;
};

std::string iso_contradiction(const DmsIsoChoice& o) {
  if (o.model == "-") return "M is a file, not standard input";
  if (!o.attribute) return "--attribute A is required, a name of the model";
  if (!o.level) return "--level C is required, a value of the attribute";
  if (!o.within) return "--within E is required, the width of cells";
  if (o.within->sign() != Sign::kPositive) return "--within: must be a number > 0";
  if (!o.output) return "-o F is required, the file of the surface";
  if (!surface_format(*o.output)) return "-o: must end in .off, .ply or .obj, not " + *o.output;
  return "";
}

std::string take_space(const std::string& text, bool& in_solid) {
  if (text != "domain" && text != "solid") return "must be domain or solid, not " + text;
  in_solid = text == "solid";
  return "";
}

}  // namespace

RunCommand declare_dms_iso(OptionSet& set) {
  const auto o = std::make_shared<DmsIsoChoice>();
  declare_plain_file(set, "M", o->model, "a model .vdms");
  set.text("--attribute", o->attribute, "the attribute, by its name", "A");
  set.option(
      "--level", "C", [o](const std::string& t) { return take_number(t, o->level); },
      "its value on the surface");
  set.option(
      "--within", "E", [o](const std::string& t) { return take_number(t, o->within); },
      "cells that the surface crosses are at most as wide");
  set.output("-o,--output", o->output, "write the surface, .off, .ply or .obj");
  set.option(
      "--space", "S", [o](const std::string& t) { return take_space(t, o->in_solid); },
      "domain (default), or solid: vertices are mapped");
  set.number("--max-cells", o->max_cells, {1, 100'000'000}, "give up beyond this, 20000");
  declare_json(set, o->json, "write the report");
  declare_reading(set, o->reading);
  set.hide("--as-indexed");
  set.rule([o] { return iso_contradiction(*o); });
  return [o](StandardOutput& out) { return DmsIsoRun(*o, out).run(); };
}

}  // namespace veritope::cli
