// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/spline_convert.h"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include "cli/output_plan.h"
#include "cli/volume_weld.h"
#include "io/formats.h"
#include "io/pn_model.h"
#include "io/splines/patch_model.h"
#include "io/splines/rejoin.h"
#include "io/splines/volume_faces.h"
#include "io/splines/write_splines.h"
#include "render/spline_view.h"
#include "report/text_style.h"
#include "report/weld_report.h"
#include "verify/format/sha256.h"

namespace veritope::cli {

using namespace report;
namespace {

using Target = std::variant<SplineFormat, ViewFormat>;

Result<Target> target_of(const ConvertOptions& o) {
  const std::size_t dot = o.output.rfind('.');
  const std::string name = o.to ? *o.to : dot == o.output.npos ? "" : o.output.substr(dot + 1);
  if (const auto view = view_format_from_name(name)) return Target(*view);
  const ModelFormat* const row = format_from_name(name, ModelKind::kSplines);
  if (row != nullptr && row->write != nullptr) return Target(std::get<SplineFormat>(row->id));
  std::string names;
  for (const ModelFormat& known : model_formats())
    if (known.kind() == ModelKind::kSplines && known.write != nullptr)
      names += std::string(known.name) + ", ";
  names += "vtu, obj or gltf";
  if (o.to) return bad_argument("for splines, --to must be " + names + ", not " + name);
  return bad_argument(no_target_text(o.output, "splines", names));
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& p : parts) text += (text.empty() ? "" : ", ") + p;
  return text;
}

// What the file has and the model lacks: shapes, and the rest.
std::array<std::vector<std::string>, 2> left_out(const SplineFile& file) {
  std::array<std::vector<std::string>, 2> out;
  for (const LeftOut& l : file.left_out)
    if (l.reason != "kept as text")
      out[l.is_geometry ? 0 : 1].push_back(std::to_string(l.count) + " " + harmless(l.what));
  return out;
}

int dimension_of(const SplineEntity& entity) {
  if (const auto* triangle = std::get_if<ExactTriangle>(&entity.shape))
    return triangle->dimension();
  int most = 0;
  for_each_spline(entity, [&](const auto& spline) { most = std::max(most, spline.dimension()); });
  return most;
}

// What a picture shows as something else: trimmed surfaces whole, with their trimming curves as lines; points of more
// than three coordinates without those.
std::vector<std::string> shown_otherwise(const SplineModel& model) {
  std::uint64_t trimmed = 0, beyond_space = 0;
  for (const SplineEntity& e : model.entities) {
    if (std::holds_alternative<TrimmedSurface>(e.shape)) ++trimmed;
    if (const auto* brep = std::get_if<SplineBrep>(&e.shape)) trimmed += brep->faces.size();
    if (dimension_of(e) > 3) ++beyond_space;
  }
  std::vector<std::string> out;
  if (trimmed != 0)
    out.push_back("the trimming of " + counted(trimmed, "surface", "surfaces") + ", shown whole");
  if (beyond_space != 0)
    out.push_back("the coordinates beyond the third of " +
                  counted(beyond_space, "entity", "entities"));
  return out;
}

// A picture that lacks a shape, or shows one that is not there, is refused like any other file.
ExitCode refuse_loss(const ConvertOptions& o, const std::vector<std::string>& lost,
                     const std::string& hint) {
  complain(harmless(o.output) + ": not written, it would lose something: " + joined(lost) +
           ". --lossy writes it all the same" + hint);
  return kExitInvalid;
}

// Replaces the volumes by their faces. Everything else is lost; what was done to the volumes is listed with what is
// dropped.
Status take_faces(SplineFile& file, const std::string& path, std::vector<std::string>& lost,
                  std::vector<std::string>& dropped) {
  Result<VolumeFaces> faces = volume_faces(file.model);
  if (!faces) {
    Error error = faces.error();
    error.place.file = path;
    return error;
  }
  if (faces->num_others != 0)
    lost.push_back(counted(faces->num_others, "entity", "entities") + " besides the volumes");
  if (!faces->with_attributes.empty())
    lost.push_back("the coordinates beyond the third of " +
                   counted(faces->with_attributes.size(), "volume", "volumes") +
                   (faces->with_attributes.size() == 1 ? ", entity " : ", the first entity ") +
                   std::to_string(faces->with_attributes.front()));
  dropped.push_back("the inside of " + counted(faces->num_volumes, "volume", "volumes"));
  if (faces->num_flat != 0)
    dropped.push_back(counted(faces->num_flat, "face", "faces") + " without area");
  if (!file.model.groups.empty()) dropped.push_back("names and attributes");
  if (!faces->mirrored.empty())
    dropped.push_back("the left-handed parametrisation of " +
                      counted(faces->mirrored.size(), "volume", "volumes"));
  file.model = model_of(faces->patches);
  return ok_status();
}

std::string joint_text(const Joint& joint) {
  std::string at;
  for (const Rational& p : joint.at) at += (at.empty() ? "" : ", ") + p.to_string();
  return "  joined: entity " + std::to_string(joint.entity) + " at " +
         (joint.at.size() == 3 ? "(b0, b1, b2)" : "(u, v)") + " = (" + at +
         "), a corner of entity " + std::to_string(joint.neighbour) + "\n";
}

// Cuts the model's sides at T-junctions and says where; what the target cannot hold exactly is left alone.
Status rejoin(SplineFile& file, const ConvertOptions& o, const Target& target, std::string& text) {
  const auto* const format = std::get_if<SplineFormat>(&target);
  const ReadLimits& limits = o.input.reading.limits;
  const auto can_hold = [&](const SplineEntity& entity) {
    if (format == nullptr) return true;
    SplineModel alone;
    alone.entities.push_back(entity);
    alone.entities[0].group.reset();
    const SplineLoss loss =
        spline_loss(alone, *format, spline_bytes(alone, *format, limits), limits);
    return !loss.unreadable && loss.shapes.empty();
  };
  Result<Rejoined> done = rejoined(file.model, can_hold);
  if (!done) {
    Error error = done.error();
    error.place.file = o.input.files[0];
    return error;
  }
  for (const Joint& joint : done->joined) text += joint_text(joint);
  for (const std::string& left : done->left) text += "  left: " + left + "\n";
  if (done->joined.empty() && done->left.empty()) text += "  nothing to join\n";
  file.model = std::move(done->model);
  return ok_status();
}

// What was done to the splines before they are written.
struct Changes {
  std::string text;                // lines for people
  std::optional<WeldReport> weld;  // without its outputs
};

Status write_weld_report(const ConvertOptions& o, WeldReport weld, const std::string& bytes,
                         StandardOutput& out) {
  weld.output_path = o.output;
  weld.output_bytes = bytes.size();
  weld.output_sha256 =
      to_hex(sha256({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}));
  const Status status = write_output(*o.json, weld_json(weld), out);
  return *o.json == "-" ? ok_status() : status;  // main looks at standard output
}

ExitCode finish(const ConvertOptions& o, const SplineFile& file, const std::string& bytes,
                const std::string& lost, const std::string& dropped, bool is_view, Changes changes,
                StandardOutput& out) {
  const Status written = write_output(o.output, bytes, out);
  if (!written && o.output != "-") return fail(written.error());
  const std::string what = is_view ? ", a picture" : lost.empty() ? ", nothing lost" : "";
  const std::string text =
      "wrote  " + unbroken(harmless(o.output)) + "  " +
      counted(file.model.entities.size(), "entity", "entities") + what +
      (lost.empty() ? "" : ", lossy: " + lost) + "\n" +
      (dropped.empty() ? "" : "  not part of the geometry, dropped: " + dropped + "\n") +
      changes.text;
  if (o.output != "-") {
    if (o.json != "-") out.write(fold(text, verdict_width()));
  } else {
    if (!lost.empty()) complain("lossy: " + lost);
    if (!dropped.empty()) complain("not part of the geometry, dropped: " + dropped);
    if (!changes.text.empty()) complain(changes.text.substr(2, changes.text.size() - 3));
  }
  if (!o.json) return kExitValid;
  const Status status = write_weld_report(o, std::move(*changes.weld), bytes, out);
  return status ? kExitValid : fail(status.error());
}

// After what is wrong with the options and the output was looked for.
Result<Target> ready_target(const ConvertOptions& options) {
  const Result<Target> target = target_of(options);
  if (!target) return target.error();
  const auto* const view = std::get_if<ViewFormat>(&*target);
  if (options.chord && (view == nullptr || *view == ViewFormat::kVtu))
    return bad_argument("--chord is for obj and gltf");
  if (options.single_precision) return bad_argument("--float is for binary PLY");
  const std::vector<std::string>& inputs = options.input.files;
  const Result<OutputPlan> plan = plan_outputs(inputs, std::nullopt, options.json);
  if (!plan) return plan.error();
  if (const Status status = check_output("OUT", options.output, inputs, *plan, options.json);
      !status)
    return status.error();
  if (const Status status = try_outputs(*plan, {options.json, options.output}); !status)
    return status.error();
  return target;
}

// Writes the model, unless that would lose something. `lost`, `dropped`: what is lost or left out already.
ExitCode write_splines(const SplineFile& file, const ConvertOptions& options, const Target& target,
                       std::vector<std::string> lost, std::vector<std::string> dropped,
                       Changes changes, StandardOutput& out) {
  const auto* const view = std::get_if<ViewFormat>(&target);
  if (view != nullptr) {
    const std::vector<std::string> otherwise = shown_otherwise(file.model);
    lost.insert(lost.end(), otherwise.begin(), otherwise.end());
    const Result<std::string> bytes = view_bytes(file.model, *view, {options.chord});
    if (!bytes) return fail(bytes.error());
    if (bytes->empty() || file.model.entities.empty()) {
      Error error{Code::kEmpty, {}, "not written, there is nothing to show"};
      error.place.file = options.output;
      if (!lost.empty()) error.message += " but what is not read: " + joined(lost);
      return fail(error);
    }
    if (!lost.empty() && !options.lossy) return refuse_loss(options, lost, "");
    return finish(options, file, *bytes, joined(lost), joined(dropped), true, std::move(changes),
                  out);
  }
  const SplineFormat format = std::get<SplineFormat>(target);
  const ReadLimits& limits = options.input.reading.limits;
  const std::string bytes = spline_bytes(file.model, format, limits);
  const SplineLoss loss = spline_loss(file.model, format, bytes, limits);
  if (loss.unreadable) {
    Error error = *loss.unreadable;
    error.place.file = options.output;
    error.code = Code::kLossy;
    error.message = "not written, it would not be read back: " + error.message;
    return fail(error);
  }
  lost.insert(lost.end(), loss.shapes.begin(), loss.shapes.end());
  dropped.insert(dropped.end(), loss.dropped.begin(), loss.dropped.end());
  if (!lost.empty() && !options.lossy)
    return refuse_loss(options, lost, loss.shapes.empty() ? "" : "; --to vjson keeps every spline");
  return finish(options, file, bytes, joined(lost), joined(dropped), false, std::move(changes),
                out);
}

}  // namespace

ExitCode convert_splines(ModelInput& input, const ConvertOptions& options, StandardOutput& out) {
  const Result<Target> target = ready_target(options);
  if (!target) return fail(target.error());
  Result<ModelFile> model = input.take();
  if (!model) return fail(model.error());
  SplineFile* const file = &std::get<SplineFile>(*model);
  auto [lost, dropped] = left_out(*file);
  Changes changes;
  if (options.weld) {
    Result<WeldReport> weld = weld_volumes(*file, options.input.files[0], *options.weld);
    if (!weld) {  // what is wrong with the volumes is wrong with the file
      complain(harmless(to_string(weld.error())));
      return kExitUnreadable;
    }
    changes.text = weld_text(*weld);
    changes.weld = std::move(*weld);
  }
  if (options.faces)
    if (const Status status = take_faces(*file, options.input.files[0], lost, dropped); !status)
      return fail(status.error());
  if (options.rejoin)
    if (const Status status = rejoin(*file, options, *target, changes.text); !status)
      return fail(status.error());
  return write_splines(*file, options, *target, std::move(lost), std::move(dropped),
                       std::move(changes), out);
}

ExitCode convert_to_pn(ModelInput& input, const ConvertOptions& options, StandardOutput& out) {
  if (options.faces || options.rejoin || options.weld)
    return fail(bad_argument("--pn is for meshes"));
  const Result<Target> target = ready_target(options);
  if (!target) return fail(target.error());
  const Result<ModelFile> read = input.take();
  if (!read) return fail(read.error());
  const MeshFile* const mesh = &std::get<MeshFile>(*read);
  Result<SplineModel> model = pn_model(*mesh);
  if (!model) {
    Error error = model.error();
    error.place.file = options.input.files[0];
    complain(harmless(to_string(error)));
    return kExitInvalid;
  }
  SplineFile file;
  file.model = std::move(*model);
  return write_splines(file, options, *target, {}, {},
                       {mesh->normals ? "  normals: those of the file\n"
                                      : "  normals: sums over triangles, weighted by area\n",
                        std::nullopt},
                       out);
}

}  // namespace veritope::cli
