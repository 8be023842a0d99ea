// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope cage.
#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "cli/cage_model.h"
#include "cli/cage_options.h"
#include "cli/cage_to_field.h"
#include "cli/commands.h"
#include "cli/output_plan.h"
#include "io/read_model.h"
#include "io/splines/volumes.h"
#include "io/splines/write_splines.h"
#include "io/trees/build_tree.h"
#include "report/cage_report.h"
#include "report/decimal_text.h"
#include "report/text_style.h"
#include "robust/base/stopwatch.h"
#include "solids/micro/cage/cage_containment.h"
#include "solids/micro/cage/hull_cage.h"
#include "verify/certify/certify.h"
#include "verify/format/sha256.h"

namespace veritope::cli {
namespace {

class CageRun {
 public:
  CageRun(const CageOptions& options, StandardOutput& out) : options_(options), out_(out) {}

  ExitCode run() {
    if (const Status status = check_outputs(); !status) return fail(status.error());
    const Result<Cells> cells = make();
    if (!cells) return refuse(cells.error());
    if (in_hole_) return outside();
    if (const ExitCode exit = check_containment(*cells); exit != kExitValid) return exit;
    return certify_and_write(*cells);
  }

 private:
  using Cells = std::vector<CellVolume>;

  const std::string& path() const { return *options_.output; }
  const std::optional<std::string>& input() const {
    if (options_.field) return options_.field;
    return options_.around ? options_.around : options_.of;
  }

  static bool is_option(const std::string& word) {
    static const std::set<std::string> kNames = {
        "at",     "axis", "degrees", "entity", "from",  "height", "high",   "inner", "low",
        "margin", "max",  "min",     "open",   "outer", "point",  "sector", "spans", "start"};
    return kNames.count(word) != 0;
  }
  // What is wrong with a file has its name; parameters that do not fit are wrong usage, and the sentence begins with
  // the name of one. Other sentences are about what was read.
  ExitCode refuse(Error error) const {
    const bool is_usage = error.code == Code::kBadArgument && error.place.file.empty();
    if (error.place.file.empty()) {
      const std::string word = error.message.substr(0, error.message.find(' '));
      const bool is_radial = *options_.kind == CageKind::kRadial;
      if (is_radial && (word == "low" || word == "degrees"))
        error.message = (word == "low" ? "--height: " : "--sector: ") + error.message;
      else if (is_option(word))
        error.message = "--" + error.message;
      else
        error.place.file = input().value_or("");
    }
    complain(harmless(to_string(error)));
    return is_usage ? kExitUsage : kExitUnreadable;
  }

  Status check_outputs() const {
    std::vector<std::string> inputs;
    for (const auto& name : {options_.around, options_.of, options_.field})
      if (name) inputs.push_back(*name);
    const Result<OutputPlan> plan = plan_outputs(inputs, std::nullopt, options_.json);
    if (!plan) return plan.error();
    if (const Status status = check_output("--output", path(), inputs, *plan, options_.json);
        !status)
      return status;
    return try_outputs(*plan, {options_.json, path()});
  }

  Result<Cells> make() {
    report_.kind = cage_kind_name(*options_.kind);
    report_.path = input();
    if (options_.around) {
      Result<CagedModel> model = read_caged_model(*options_.around, options_.reading);
      if (!model) return model.error();
      report_.sha256 = model->sha256;
      model_.emplace(std::move(*model));
      margin_ = margin_length(box_of(model_->content), options_.margin_part());
    }
    switch (*options_.kind) {
      case CageKind::kBox: return one(box());
      case CageKind::kRadial: return radial();
      case CageKind::kHull: return hull();
      case CageKind::kFit: return fit();
      case CageKind::kSplit: break;
    }
    return split();
  }

  static Result<Cells> one(Result<CellVolume> cell) {
    if (!cell) return cell.error();
    return Cells{std::move(*cell)};
  }

  Result<CellVolume> box() const {
    if (!model_) return box_cage({*options_.min, *options_.max}, options_.grid(1));
    const CageBox box = grown(box_of(model_->content), margin_);
    for (std::size_t k = 0; k < 3; ++k)
      if (box.min[k] == box.max[k])
        return Error{Code::kBadArgument, place_of_model(),
                     std::string("it has no extent in ") + "xyz"[k] + " and no margin"};
    return box_cage(box, options_.grid(1));
  }

  Result<Cells> radial() {
    RadialShape shape = options_.shape();
    if (model_) {
      const CageBox box = box_of(model_->content);
      for (std::size_t k = 0; k < 3 && !options_.point; ++k)
        shape.axis.point[k] = (box.min[k] + box.max[k]) / Rational(2);
      Result<RadialShape> around = radial_shape_around(model_->content, shape, margin_);
      if (!around) return around.error();
      shape = std::move(*around);
    }
    const Result<RadialCage> cage = radial_cage(shape);
    if (!cage) return cage.error();
    if (shape.degrees) report_.angle_error = cage->angle_error;
    if (model_) in_hole_ = first_in_hole(model_->content, shape);
    // A whole disc is convex, and contains what it was made around.
    is_checked_ = model_ && (shape.degrees || shape.inner.sign() != Sign::kZero);
    return Cells{cage->cell};
  }

  Result<Cells> hull() {
    const Result<HullCage> cage = hull_cage(model_->content, {options_.grid(4), margin_});
    if (!cage) return cage.error();
    report_.pull = {cage->rounds, cage->shortened};
    is_checked_ = true;
    return Cells{cage->cell};
  }

  Result<Cells> fit() {
    Result<FittedCage> fitted = fitted_cage(options_, model_ ? &model_->content : nullptr);
    if (!fitted) return fitted.error();
    report_.fit = fitted->report;
    report_.sha256 = fitted->sha256;
    is_checked_ = model_.has_value();
    return Cells{std::move(fitted->cell)};
  }

  Result<Cells> split() {
    const Result<SplineFile> file = read_spline_file(*options_.of, options_.reading);
    if (!file) return file.error();
    report_.sha256 = file->sha256;
    Result<std::vector<ExactVolume>> cells = volumes_of(*file);
    if (!cells) return in_file(cells.error());
    // Cells that make no V-model are wrong in the file, parameters that do not fit on the command line.
    if (const auto model = make_v_model(*cells, VOrientation::kAuto); !model)
      return in_file(model.error());
    return split_cage(std::move(*cells), options_.split());
  }
  Error in_file(Error error) const {
    error.place.file = *options_.of;
    return error;
  }
  Place place_of_model() const {
    Place place;
    place.file = *options_.around;
    return place;
  }

  ExitCode outside() const {
    const CellPoint& p = model_->content.points[*in_hole_];
    complain(harmless(*options_.around) +
             ": the cage does not contain it, and nothing is written: " +
             point_text({nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])}) +
             " lies in the hole (--inner)");
    return kExitInvalid;
  }

  ExitCode check_containment(const Cells& cells) const {
    if (!is_checked_) return kExitValid;
    const Result<VModel> model = make_v_model(cells, VOrientation::kKeep);
    if (!model) return kExitValid;  // the certifier says why
    const std::optional<CageGap> gap = find_gap(*model, model_->content);
    if (!gap) return kExitValid;
    std::string text = ": not proved to lie inside of the cage, and nothing is written: " +
                       part_name(*model_, gap->part);
    if (gap->face)
      text += " may meet the face " + std::string(1, "uvw"[*gap->face % 6 / 2]) +
              std::to_string(*gap->face % 2) + " of cell " + std::to_string(*gap->face / 6);
    else
      text += " was not found in it";
    complain(harmless(*options_.around) + text);
    return kExitUndecided;
  }

  // The certificate of the bytes, as the file will be read.
  Result<Certified> certified(const std::string& bytes) const {
    ModelReadOptions reading = options_.reading;
    reading.format = SplineFormat::kJson;
    const Result<ModelFile> file = read_model_bytes(
        {reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, path(), reading);
    if (!file) return file.error();
    CertifyOptions certify_options;
    certify_options.jobs = static_cast<unsigned>(options_.reading.jobs);
    return certify(*file, certify_options);
  }

  // A limit on numbers, as a rule.
  static ExitCode not_readable(const Error& error) {
    complain(harmless("not written, it would not be read back: " + to_string(error)));
    return kExitUnreadable;
  }

  ExitCode certify_and_write(const Cells& cells) {
    const std::string bytes = spline_json_bytes(model_of_cells(cells));
    const Result<Certified> answer = certified(bytes);
    if (!answer) return not_readable(answer.error());
    const auto* const facts = std::get_if<PatchFacts>(&answer->facts);
    if (answer->verdict != Verdict::kValid || facts == nullptr || !facts->vmodel) {
      std::string text =
          std::string("nothing is written: the cage is ") + verdict_name(answer->verdict);
      if (!answer->findings.empty()) text += ": " + text_of(answer->findings.front());
      complain(harmless(text));
      return answer->verdict == Verdict::kInvalid ? kExitInvalid : kExitUndecided;
    }
    report_.facts = *facts;
    return write(cells, bytes);
  }

  ExitCode write(const Cells& cells, const std::string& bytes) {
    const Status written = write_output(path(), bytes, out_);
    if (!written && path() != "-") return fail(written.error());
    report_.output_path = path();
    report_.output_sha256 =
        to_hex(sha256({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}));
    report_.output_bytes = bytes.size();
    for (const CellVolume& cell : cells) report_.control_points += cell.grid().count();
    report_.seconds = watch_.lap();
    if (options_.json != "-" && path() != "-")
      out_.write(fold(cage_text(report_), verdict_width()));
    if (!options_.json) return kExitValid;
    const Status status = write_output(*options_.json, cage_json(report_), out_);
    return status || *options_.json == "-" ? kExitValid : fail(status.error());
  }

  const CageOptions& options_;
  StandardOutput& out_;
  std::optional<CagedModel> model_;
  Rational margin_;
  bool is_checked_ = false;  // whether find_gap has to prove that the cage contains the model
  std::optional<std::size_t> in_hole_;
  CageReport report_;
  Stopwatch watch_;
};

}  // namespace

RunCommand declare_cage(OptionSet& set) {
  const auto o = std::make_shared<CageOptions>();
  declare_cage_options(set, *o);
  return [o](StandardOutput& out) { return CageRun(*o, out).run(); };
}

}  // namespace veritope::cli
