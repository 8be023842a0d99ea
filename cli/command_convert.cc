// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope convert.
#include <array>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>

#include "cli/canonical_convert.h"
#include "cli/commands.h"
#include "cli/convert_options.h"
#include "cli/did_you_mean.h"
#include "cli/model_files.h"
#include "cli/output_plan.h"
#include "cli/spline_convert.h"
#include "cli/volume_weld.h"
#include "io/formats.h"
#include "io/mesh/write_mesh.h"
#include "report/decimal_text.h"
#include "report/text_style.h"

namespace veritope::cli {

using namespace report;
namespace {

// The names of --to, and the names of these variants in io/.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kTargets = {{
    {"stl", "stl-binary"},
    {"stl-ascii", "stl-ascii"},
    {"obj", "obj"},
    {"ply", "ply-binary-little-endian"},
    {"ply-ascii", "ply-ascii"},
    {"ply-be", "ply-binary-big-endian"},
    {"off", "off"},
}};

Result<WriteOptions> target_of(const ConvertOptions& o) {
  std::string name;
  if (o.to) {
    name = *o.to;
  } else if (const ModelFormat* const row = format_from_path(o.output, ModelKind::kMesh)) {
    name = row->name;
  } else {
    return bad_argument(no_target_text(o.output, "a mesh", format_names("or", ModelKind::kMesh)));
  }
  for (const auto& [target, variant] : kTargets) {
    if (target != name) continue;
    WriteOptions options = write_options_from_name(variant).value();
    if (!o.single_precision) return options;
    const bool is_binary_ply =
        options.format == MeshFormat::kPly && options.encoding != MeshEncoding::kAscii;
    if (!is_binary_ply) return bad_argument("--float is for binary PLY (--to ply, --to ply-be)");
    options.single_precision = true;
    return options;
  }
  if (const auto options = write_options_from_name(name); options && !o.single_precision) {
    return *options;  // the names that `info` prints
  }
  std::vector<std::string> names;
  for (const auto& [known, variant] : kTargets) names.emplace_back(known);
  return bad_argument(
      "for a mesh, --to must be stl, stl-ascii, obj, ply, ply-ascii, ply-be or off, not " + name +
      did_you_mean(name, names));
}

std::string displacement_text(const LossReport& loss) {
  if (std::isinf(loss.max_displacement)) {
    return "vertex " + std::to_string(loss.vertex) + " is too large for binary32";
  }
  return counted(loss.moved_vertices, "vertex moves", "vertices move") + " by at most " +
         short_decimal(loss.max_displacement) + " (vertex " + std::to_string(loss.vertex) + ")";
}

// What the new file would not keep; empty if it keeps everything. Vertex ids count only if they were kept when the file
// was read.
std::string loss_text(const LossReport& loss, bool as_indexed) {
  std::string text;
  if (loss.coordinates_change) text = displacement_text(loss);
  if (loss.merged_vertices > 0) {
    text += ", " + counted(loss.merged_vertices, "vertex becomes", "vertices become") +
            " equal to others";
  }
  if (as_indexed && loss.indexing_changes) {
    text += (text.empty() ? "" : ", ") + std::string("the vertex indices are not kept");
  }
  return text;
}

// Data that are not part of the model: they are dropped, and that is no loss.
std::string dropped_text(const ReadReport& reading, const WriteOptions& target) {
  std::string text;
  const auto add = [&text](const std::string& words) {
    text += (text.empty() ? "" : ", ") + words;
  };
  for (const auto& [what, count] : reading.ignored) {
    add(std::to_string(count) + " " + harmless(what));
  }
  if (target.format == MeshFormat::kStl && reading.format != MeshFormat::kStl) {
    if (reading.unreferenced_vertices != 0) {
      add(counted(reading.unreferenced_vertices, "unreferenced vertex", "unreferenced vertices"));
    }
    add("the numbers of the vertices");
  }
  return text;
}

ExitCode refuse(const ConvertOptions& o, const LossReport& loss, const std::string& words,
                const WriteOptions& target) {
  const bool has_too_large = std::isinf(loss.max_displacement);
  std::string advice = has_too_large ? "" : "--lossy writes it all the same; ";
  if (target.format == MeshFormat::kStl && target.encoding != MeshEncoding::kAscii &&
      !o.input.reading.as_indexed) {
    advice += "--to stl-ascii keeps all digits";
  } else {
    advice += "--to ply keeps everything";
  }
  complain(harmless(o.output) + ": not written, it would lose something: " + words + ". " + advice);
  return kExitInvalid;
}

// main reports a failure of standard output.
Status write_model(const std::string& path, const TriangleMesh& mesh, const WriteOptions& target,
                   StandardOutput& out) {
  if (!is_stream(path)) return write_mesh_file(path, mesh, target);
  const Result<std::string> bytes = mesh_to_bytes(mesh, target);
  if (!bytes) return bytes.error();
  return write_output(path, *bytes, out);
}

// Standard output may be the model itself.
void report(const ConvertOptions& o, const MeshFile& file, const std::string& loss,
            const WriteOptions& target, StandardOutput& out) {
  std::string text = "wrote  " + unbroken(harmless(o.output)) + "  " +
                     counted(file.mesh.faces.size(), "face", "faces") +
                     (loss.empty() ? ", nothing lost" : ", lossy: " + loss) + "\n";
  const std::string dropped = dropped_text(file.report, target);
  if (!dropped.empty()) text += "  not part of the model, dropped: " + dropped + "\n";
  if (file.report.polygons_split != 0) {
    text +=
        "  " + counted(file.report.polygons_split, "polygon", "polygons") + " cut into triangles\n";
  }
  if (o.output != "-") out.write(fold(text, verdict_width()));
  if (o.output == "-" && !loss.empty()) complain("lossy: " + loss);
  if (o.output == "-" && !dropped.empty()) complain("not part of the model, dropped: " + dropped);
}

ExitCode run(const ConvertOptions& options, StandardOutput& out) {
  if (is_folder_of_models(options.output))
    return fail(bad_argument("OUT names the new file, and " + options.output + " is a folder"));
  ModelReadOptions reading = options.input.reading;
  reading.with_normals = options.pn;
  ModelInput input(options.input.files[0], reading);
  const ModelKind kind = input.kind();
  if (options.pn && kind != ModelKind::kMesh) return fail(bad_argument("--pn is for meshes"));
  if (options.pn) return convert_to_pn(input, options, out);
  if (kind == ModelKind::kSplines) return convert_splines(input, options, out);
  if (kind == ModelKind::kMicro) return convert_micro(input, options, out);
  if (kind == ModelKind::kDms) return convert_dms(input, options, out);
  if (kind != ModelKind::kMesh)
    return fail(
        Error{Code::kBadArgument,
              {},
              "convert writes meshes, splines, microstructures and simplex-spline solids; " +
                  options.input.files[0] + " is " + title_of(kind)});
  if (options.chord) return fail(bad_argument("--chord is for splines"));
  if (options.faces) return fail(bad_argument("--faces is for splines"));
  if (options.rejoin) return fail(bad_argument("--rejoin is for splines"));
  if (options.weld) return fail(bad_argument("--weld is for spline volumes"));
  const Result<WriteOptions> target = target_of(options);
  if (!target) return fail(target.error());
  if (const Status status = refuse_same(options.input.files, options.output); !status) {
    return fail(status.error());
  }
  if (const Status status = try_output(options.output); !status) return fail(status.error());
  const Result<ModelFile> model = input.take();
  if (!model) return fail(model.error());
  const MeshFile* const file = &std::get<MeshFile>(*model);
  const bool as_indexed =
      options.input.reading.as_indexed && file->report.format != MeshFormat::kStl;
  const LossReport loss = loss_of(file->mesh, *target);
  const std::string words = loss_text(loss, as_indexed);
  if (!words.empty() && !options.lossy) return refuse(options, loss, words, *target);
  const Status written = write_model(options.output, file->mesh, *target, out);
  if (!written && options.output != "-") return fail(written.error());
  report(options, *file, words, *target, out);
  return kExitValid;
}

void declare(OptionSet& set, ConvertOptions& o) {
  declare_file(set, "IN", o.input, "mesh, splines, vmicro or vdms; - is standard input");
  const auto take_output = [&o](const std::string& path) -> std::string {
    o.output = output_name(path);
    return "";
  };
  set.operand("OUT", take_output, "the new file; - is standard output (with --to)");
  set.text("--to", o.to,
           "a mesh: stl, stl-ascii, obj, ply, ply-ascii, ply-be, off;\nsplines: itd, g2, vjson; "
           "vmicro; vdms; vtu, obj, gltf",
           "V");
  set.length("--chord", "H", o.chord, "splines in obj, gltf: the distance of chords to aim at");
  set.flag("--float", o.single_precision, "binary PLY with binary32 coordinates");
  set.flag("--faces", o.faces, "write the boundary of spline volumes as surfaces");
  set.flag("--pn", o.pn, "write a mesh as smooth Bezier triangles: PN-triangles");
  set.flag("--rejoin", o.rejoin, "cut sides of splines at T-junctions, exactly");
  set.option(
      "--weld", "EPS", [&o](const std::string& text) { return take_weld_distance(text, o.weld); },
      "weld faces of volumes within EPS; its report: --json F");
  declare_json(set, o.json, "write what --weld did");
  set.hide("--json");  // the help line above names it
  set.flag("--lossy", o.lossy, "round or renumber where necessary, and say how much");
  declare_jobs(set, o.input.reading.jobs);
  declare_format(set, o.input);
  declare_reading(set, o.input.reading);
}

std::string contradiction(const ConvertOptions& o) {
  if (o.json && !o.weld) return "--json requires --weld";
  if (o.output == "-" && o.json == "-") return "OUT and --json would both write standard output";
  return o.output == "-" && !o.to ? "- is standard output and needs --to" : "";
}

}  // namespace

RunCommand declare_convert(OptionSet& set) {
  const auto o = std::make_shared<ConvertOptions>();
  declare(set, *o);
  set.rule([o] { return contradiction(*o); });
  return [o](StandardOutput& out) { return run(*o, out); };
}

}  // namespace veritope::cli
