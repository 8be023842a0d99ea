// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope render.
#include <memory>
#include <utility>

#include "cli/box_option.h"
#include "cli/checker_process.h"
#include "cli/commands.h"
#include "cli/dms_render.h"
#include "cli/dms_verbs.h"
#include "cli/expression_operands.h"
#include "cli/model_input.h"
#include "cli/model_view.h"
#include "cli/output_plan.h"
#include "io/base/exact_number.h"
#include "io/base/scan.h"
#include "io/read_model.h"
#include "render/cast_solid.h"
#include "render/png.h"
#include "report/render_report.h"
#include "report/report_text.h"
#include "report/text_style.h"
#include "robust/base/stopwatch.h"

namespace veritope::cli {
namespace {

struct RenderOptions {
  InputOptions input;
  std::optional<std::string> output, json;
  std::optional<std::array<std::size_t, 2>> size;
  std::optional<Point3d> view;
  std::optional<Rational> explode;
  bool nets = false;
  std::optional<double> chord;
  std::uint32_t grid = 0;  // points along each axis; 0: a shaded picture
  std::optional<ExactBox<3>> bounds;
  std::optional<std::string> around;
  DmsRenderOptions dms;
  bool no_check = false;
  int jobs = default_jobs();
};

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    out.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return out;
}

std::string take_size(const std::string& text, std::optional<std::array<std::size_t, 2>>& out) {
  const std::string wrong = "needs two sides W,H from 64 to 8192, not " + text;
  const std::vector<std::string> words = split_at_commas(text);
  if (words.size() != 2) return wrong;
  std::array<std::size_t, 2>& size = out.emplace();
  for (std::size_t i = 0; i < 2; ++i) {
    if (words[i].empty() || words[i].size() > 4 ||
        words[i].find_first_not_of("0123456789") != std::string::npos)
      return wrong;
    size[i] = std::stoul(words[i]);
    if (size[i] < 64 || size[i] > 8192) return wrong;
  }
  return "";
}

std::string take_view(const std::string& text, std::optional<Point3d>& out) {
  const std::vector<std::string> words = split_at_commas(text);
  Point3d& view = out.emplace();
  bool is_zero = true;
  for (std::size_t k = 0; k < 3; ++k) {
    Rational value;
    if (words.size() != 3 || read_exact_number(words[k], {}, value) != DecimalFault::kNone)
      return "needs three numbers X,Y,Z, not " + text;
    view[k] = nearest_double(value);
    if (view[k] - view[k] != 0) return "has '" + words[k] + "', which is beyond binary64";
    if (view[k] != 0) is_zero = false;
  }
  return is_zero ? "is no direction: " + text : "";
}

std::string take_factor(const std::string& text, std::optional<Rational>& factor) {
  constexpr int kMostFactor = 1'000'000;
  Rational value;
  if (read_exact_number(text, {}, value) != DecimalFault::kNone || value < Rational(0) ||
      Rational(kMostFactor) < value)
    return "needs a number from 0 to 1000000, not " + text;
  factor = value;
  return "";
}

void declare(OptionSet& set, RenderOptions& o) {
  declare_file(set, "MODEL", o.input, "mesh, splines, expression, .vmicro or .vdms");
  set.output("-o,--output", o.output, "write the picture: .png; for viewers .vtu, .gltf, .obj");
  set.option(
      "--explode", "K", [&o](const std::string& t) { return take_factor(t, o.explode); },
      "volumes: move cells apart by K; --nets: control nets");
  set.flag("--nets", o.nets, "draw control nets of volumes, the cage of tiles");
  set.hide("--nets");
  declare_dms_render(set, o.dms);
  set.length("--chord", "H", o.chord, "volumes, curves: the distance of chords to aim at");
  set.option(
      "--size", "W,H", [&o](const std::string& t) { return take_size(t, o.size); },
      "pixels (1200,900)");
  set.option(
      "--view", "X,Y,Z", [&o](const std::string& t) { return take_view(t, o.view); },
      "the direction of view (-5,8,-5)");
  set.number("--grid", o.grid, {1, kMostGridSide},
             "count and show the points of an N^3 grid in the solid");
  set.option(
      "--bounds", "BOX", [&o](const std::string& t) { return take_box(t, o.bounds); },
      "X0,Y0,Z0,X1,Y1,Z1: this box only (MODEL's box)");
  set.text("--around", o.around, "microstructures, curves: draw this mesh around them");
  declare_json(set, o.json, "write the counts");
  declare_jobs(set, o.jobs);
  set.flag("--no-check", o.no_check, "do not run veritope-check; --as-indexed: no merging");
  declare_reading(set, o.input.reading);
  set.hide("--as-indexed");
}

// A stream is a picture, too.
std::optional<ViewKind> kind_of_output(const RenderOptions& o) {
  return is_stream(*o.output) ? ViewKind::kPng : view_kind(*o.output);
}

// Which of the options for cells of V-models is given; empty: none.
std::string cell_option(const RenderOptions& o) {
  return o.explode ? "--explode" : o.nets ? "--nets" : o.chord ? "--chord" : "";
}

std::string contradiction_of_kind(const RenderOptions& o) {
  const std::optional<ViewKind> kind = kind_of_output(o);
  if (!kind) return "the name " + *o.output + " does not end in .png, .vtu, .gltf or .obj";
  const std::string of_pixels = o.size        ? "--size"
                                : o.view      ? "--view"
                                : o.grid != 0 ? "--grid"
                                : o.bounds    ? "--bounds"
                                              : "";
  if (*kind != ViewKind::kPng && !of_pixels.empty()) return of_pixels + " is for .png";
  if (*kind == ViewKind::kVtu && o.chord) return "--chord is for .png, .gltf and .obj";
  if ((o.grid != 0 || o.bounds) && !cell_option(o).empty())
    return std::string(o.grid != 0 ? "--grid" : "--bounds") + " shows the solid, and " +
           cell_option(o) + " its cells";
  return "";
}

std::string contradiction(const RenderOptions& o) {
  if (!o.output) return "-o F.png is required, the file of the picture";
  if (const std::string wrong = contradiction_of_kind(o); !wrong.empty()) return wrong;
  if (std::string wrong = dms_render_contradiction(o.dms); !wrong.empty()) return wrong;
  if (o.output == "-" && o.json == "-")
    return "the picture and --json would both write standard output";
  if (needs_copy(o.input.files[0])) return "MODEL is a file, not " + o.input.files[0];
  return "";
}

class RenderRun {
 public:
  RenderRun(const RenderOptions& options, StandardOutput& out)
      : options_(options), out_(out), progress_(true), kind_(*kind_of_output(options)) {}

  ExitCode run() {
    if (const Status status = check_outputs(); !status) return fail(status.error());
    const ModelReadOptions how = reading();
    ModelKind kind;
    {
      ModelInput input(path(), how);
      kind = input.kind();
      if (kind == ModelKind::kDms) return draw_dms_model(input);
      if (const std::string option = dms_render_option(options_.dms); !option.empty())
        return fail(bad_argument(option + " is for simplex-spline solids, and " + harmless(path()) +
                                 " is none"));
      if (kind == ModelKind::kMicro) return draw_micro(input);
    }
    if (options_.around && (kind != ModelKind::kSplines || options_.bounds || options_.grid != 0))
      return refuse_around();
    const bool is_chain = is_chain_file(path());
    if (is_chain && (kind_ != ViewKind::kPng || !cell_option(options_).empty()))
      return fail(
          bad_argument((kind_ != ViewKind::kPng
                            ? "the picture of an expression is a .png: nobody computed its surface"
                            : cell_option(options_) + " is for files of volumes; " +
                                  harmless(path()) + " is an expression")));
    if (!is_chain && !options_.bounds && options_.grid == 0)
      if (const std::optional<ExitCode> exit = draw_if_cells_or_curves()) return *exit;
    if (options_.around) return refuse_around();
    std::string checker;
    if (!options_.no_check) {
      const Result<std::string> found = find_checker();
      if (!found) return complain(found.error().message), kExitUsage;
      checker = *found;
    }
    CertifySettings settings;
    settings.reading = options_.input.reading;
    settings.reading.jobs = options_.jobs;
    settings.certify.jobs = static_cast<unsigned>(options_.jobs);
    settings.checker = checker;
    ExpressionOperands operands(settings, progress_);
    const std::optional<ExpressionOperand> model = operands.load(path(), "");
    progress_.clear();
    if (!model) return operands.exit();
    report_.path = path();
    report_.sha256 = model->sha256;
    report_.seconds_read = watch_.lap();
    if (kind_ != ViewKind::kPng) {
      report_.bounds = operands.box_of(model->formula).value_or(model->box);
      return write_solid();
    }
    progress_.phase(shown_path(path()), "building the look-up");
    report_.bounds =
        options_.bounds ? *options_.bounds : operands.box_of(model->formula).value_or(model->box);
    std::vector<std::shared_ptr<const Operand>> solids;
    for (ExpressionSolid& solid : operands.take_solids())
      solids.push_back(std::move(solid.operand));
    const ExpressionClassifier classifier(model->formula, std::move(solids));
    report_.seconds_build = watch_.lap();
    return draw(ExpressionProbe(classifier));
  }

 private:
  const std::string& path() const { return options_.input.files[0]; }

  ModelReadOptions reading() const {
    ModelReadOptions out = options_.input.reading;
    out.jobs = options_.jobs;
    return out;
  }

  Status check_outputs() const {
    std::vector<std::string> inputs = {path()};
    if (options_.around) inputs.push_back(*options_.around);
    const Result<OutputPlan> plan = plan_outputs(inputs, std::nullopt, options_.json);
    if (!plan) return plan.error();
    if (*options_.output != "-")
      if (const Status status =
              check_output("--output", *options_.output, inputs, *plan, options_.json);
          !status)
        return status;
    return try_outputs(*plan, {options_.json, options_.output});
  }

  std::array<std::size_t, 2> picture_size() const {
    return options_.size.value_or(dms_picture_size(options_.dms));
  }

  PictureOptions picture_options() const {
    PictureOptions look;
    const auto size = picture_size();
    look.width = size[0], look.height = size[1];
    if (options_.view) look.view = *options_.view;
    look.jobs = static_cast<unsigned>(options_.jobs);
    return look;
  }

  ExitCode refuse_around() {
    progress_.clear();
    return fail(bad_argument("--around is for microstructures and curves, and " + harmless(path()) +
                             " has none"));
  }

  // Nothing: MODEL is no file of volumes or curves in space, or it cannot be read, and no option is for such files
  // only.
  std::optional<ExitCode> draw_if_cells_or_curves() {
    progress_.phase(shown_path(path()), "reading");
    const ModelReadOptions how = reading();
    ModelInput input(path(), how);
    const bool is_splines = input.kind() == ModelKind::kSplines;
    const std::string option = cell_option(options_);
    if (!is_splines && option.empty()) return std::nullopt;
    const Result<ModelFile> model = input.take();
    if (!model && option.empty()) return std::nullopt;
    if (!model) return refuse_as_unreadable(model.error());
    const auto* const file = std::get_if<SplineFile>(&*model);
    const Status is_cells =
        file == nullptr ? Status(bad_argument(std::string("it is ") + title_of(kind_of(*model))))
                        : check_is_cells(*file);
    if (is_cells && options_.around) return refuse_around();
    if (is_cells) return draw_cells(*file);
    const bool may_be_curves = file != nullptr && (option.empty() || option == "--chord");
    if (may_be_curves && check_is_read(*file) && counts_of_curves(file->model))
      return draw_curves(*file);
    if (option.empty()) return std::nullopt;
    progress_.clear();
    complain(harmless(option + " is for files of volumes in space; " + shown_path(path()) + ": " +
                      text_of(finding_of(is_cells.error()))));
    return kExitUsage;
  }

  // Microstructures are drawn as they are in the file, without a verdict, like cells.
  ExitCode draw_micro(ModelInput& input) {
    if (options_.explode || options_.chord || options_.grid != 0 || options_.bounds) {
      const std::string option = options_.explode     ? "--explode"
                                 : options_.chord     ? "--chord"
                                 : options_.grid != 0 ? "--grid"
                                                      : "--bounds";
      return fail(bad_argument(option + " is not for microstructures"));
    }
    progress_.phase(shown_path(path()), "reading");
    const Result<ModelFile> model = input.take();
    if (!model) return refuse_as_unreadable(model.error());
    const MicroFile& file = std::get<MicroFile>(*model);
    MicroViewOptions how;
    how.has_cage = options_.nets;
    const Result<std::optional<MeshFile>> around = read_around();
    if (!around) return refuse_as_unreadable(around.error());
    if (*around) how.model = &(*around)->mesh;
    report_.path = path();
    report_.sha256 = file.sha256;
    report_.seconds_read = watch_.lap();
    progress_.phase(shown_path(path()), "drawing");
    const Result<ModelView> view = view_of_micro(file.micro, how, kind_, picture_options());
    progress_.clear();
    if (!view) return refuse(view.error());
    MicroPicture& picture = report_.micro.emplace();
    picture.has_cage = options_.nets;
    picture.around = options_.around;
    picture.bridges = file.micro.num_bridges();
    for (const MicroGrid& grid : file.micro.grids)
      for (const std::uint8_t t : grid.tiles) picture.tiles += t != 0;
    set_bounds(*view);
    return write(*view);
  }

  // The first option that is for models of other kinds; empty: none.
  std::string option_of_others() const {
    if (options_.grid != 0) return "--grid";
    if (options_.bounds) return "--bounds";
    if (options_.around) return "--around";
    return cell_option(options_);
  }

  // A domain or clouds with defects are refused as by veritope dms.
  ExitCode draw_dms_model(ModelInput& input) {
    if (const std::string option = option_of_others(); !option.empty())
      return fail(bad_argument(option + " is not for simplex-spline solids"));
    const auto mode = options_.dms.mode;
    const bool is_surface = !mode || *mode == DmsMode::kIso;
    if (!is_surface && kind_ != ViewKind::kPng)
      return fail(bad_argument("a picture by --mode " + mode_name(*mode) +
                               " is a .png, because no surface is made"));
    progress_.phase(shown_path(path()), "reading");
    const Result<ModelFile> model = input.take();
    if (!model) return refuse_as_unreadable(model.error());
    const DmsFile& file = std::get<DmsFile>(*model);
    report_.path = path();
    report_.sha256 = file.sha256;
    report_.seconds_read = watch_.lap();
    if (const DmsDefects defects = find_dms_defects(file.model); defects.count != 0) {
      progress_.clear();
      complain(harmless(dms_refusal(path(), defects)));
      return kExitInvalid;
    }
    if (is_in_solid(options_.dms))
      if (const ExitCode exit = require_certified(*model); exit != kExitValid) return exit;
    report_.seconds_build = watch_.lap();
    progress_.phase(shown_path(path()), "drawing");
    Result<DmsDrawing> drawn =
        is_surface ? draw_dms_surface(file.model, options_.dms, kind_, picture_options())
                   : draw_dms(file.model, options_.dms, picture_options());
    progress_.clear();
    if (!drawn && drawn.error().code == Code::kBadArgument) return fail(drawn.error());
    if (!drawn) return refuse(in_dms_model(drawn.error(), path()));
    if (!drawn->doubt.empty()) complain(harmless(path() + ": " + drawn->doubt));
    if (drawn->view.bytes.empty()) return kExitUndecided;
    report_.dms = std::move(drawn->facts);
    set_bounds(drawn->view);
    const ExitCode exit = write(drawn->view);
    return drawn->doubt.empty() ? exit : first_of(kExitUndecided, exit);
  }

  // Points of the solid have one preimage each if the map is one to one, as the certificate of VALID says.
  ExitCode require_certified(const ModelFile& model) {
    progress_.phase(shown_path(path()), "proving");
    CertifyOptions options;
    options.jobs = static_cast<unsigned>(options_.jobs);
    const Result<Certified> done = certify(model, options);
    progress_.clear();
    if (!done) return refuse(done.error());
    if (done->verdict == Verdict::kValid) return kExitValid;
    const bool is_invalid = done->verdict == Verdict::kInvalid;
    complain(harmless(path() + ": --space solid needs a map that is proved to be one to one, and " +
                      (is_invalid ? "this model is INVALID" : "this model is UNDECIDED") +
                      "; `veritope certify` says where and why"));
    return is_invalid ? kExitInvalid : kExitUndecided;
  }

  void set_bounds(const ModelView& view) {
    for (std::size_t k = 0; k < 3; ++k)
      report_.bounds[k] = {Rational::from_double(view.box.lo[k]),
                           Rational::from_double(view.box.hi[k])};
  }

  // The mesh to be drawn around the model, if there is one.
  Result<std::optional<MeshFile>> read_around() const {
    if (!options_.around) return std::optional<MeshFile>();
    Result<MeshFile> read = read_mesh_file(*options_.around, reading());
    if (!read) return read.error();
    return std::optional(std::move(*read));
  }

  static Status check_is_read(const SplineFile& file) {
    for (const LeftOut& l : file.left_out)
      if (l.is_geometry)
        return bad_argument("shapes of the file are not read: " + l.what + " (" +
                            std::to_string(l.count) + ")");
    return ok_status();
  }
  static Status check_is_cells(const SplineFile& file) {
    const Status is_read = check_is_read(file);
    return is_read ? check_is_volumes(file.model) : is_read;
  }

  ExitCode refuse_as_unreadable(const Error& error) {
    progress_.clear();
    complain(harmless(to_string(error)));
    return kExitUnreadable;
  }

  ExitCode draw_cells(const SplineFile& file) {
    report_.path = path();
    report_.sha256 = file.sha256;
    report_.seconds_read = watch_.lap();
    progress_.phase(shown_path(path()), "drawing");
    VolumeViewOptions how;
    const Rational factor = options_.explode.value_or(Rational(0));
    how.explode = nearest_double(factor);
    how.has_nets = options_.nets;
    how.chord = options_.chord;
    const Result<ModelView> view = view_of_cells(file.model, how, kind_, picture_options());
    progress_.clear();
    if (!view) return refuse(view.error());
    report_.cells = CellPicture{file.model.entities.size(), factor.to_string(), options_.nets};
    set_bounds(*view);
    return write(*view);
  }

  // Curves, with sheets beside them, are drawn as they are in the file, without a verdict.
  ExitCode draw_curves(const SplineFile& file) {
    CurveViewOptions how;
    how.chord = options_.chord;
    const Result<std::optional<MeshFile>> around = read_around();
    if (!around) return refuse_as_unreadable(around.error());
    if (*around) how.model = &(*around)->mesh;
    report_.path = path();
    report_.sha256 = file.sha256;
    report_.seconds_read = watch_.lap();
    progress_.phase(shown_path(path()), "drawing");
    const Result<ModelView> view = view_of_curves(file.model, how, kind_, picture_options());
    progress_.clear();
    if (!view) return refuse(view.error());
    const CurveCounts counts = counts_of_curves(file.model).value();
    report_.curves = CurvePicture{counts.curves, counts.sheets, counts.bridges, options_.around};
    set_bounds(*view);
    return write(*view);
  }

  ExitCode write_solid() {
    progress_.phase(shown_path(path()), "drawing");
    const Result<ModelFile> model = read_model_file(path(), options_.input.reading);
    if (!model) return refuse_as_unreadable(model.error());
    if (sha256_of(*model) != report_.sha256)
      return refuse(Error{Code::kCannotOpen, {}, "it has changed since it was decided"});
    const Result<ModelView> view = view_of_solid(*model, kind_);
    progress_.clear();
    return view ? write(*view) : refuse(view.error());
  }

  ExitCode write(const ModelView& view) {
    report_.picture = *options_.output;
    if (kind_ == ViewKind::kPng) report_.size = picture_size();
    if (const Status status = write_output(*options_.output, view.bytes, out_); !status)
      return fail(status.error());
    report_.seconds_draw = watch_.lap();
    return say(view.content);
  }

  ExitCode draw(const SolidProbe& solid) {
    const PictureOptions look = picture_options();
    const Result<Image> image = options_.grid != 0 ? draw_grid(solid, look) : cast(solid, look);
    progress_.clear();
    if (!image && image.error().code == Code::kOverLimit && options_.bounds && options_.grid == 0)
      return complain("--bounds: " + image.error().message), kExitUsage;
    if (!image) return refuse(image.error());
    report_.picture = *options_.output;
    report_.size = {image->width, image->height};
    if (const Status status = write_output(*options_.output, png_bytes(*image), out_); !status)
      return fail(status.error());
    report_.seconds_draw = watch_.lap();
    return say("");
  }

  Result<Image> cast(const SolidProbe& solid, const PictureOptions& look) {
    progress_.phase(shown_path(path()), "casting rays");
    Box3d bounds;
    for (std::size_t k = 0; k < 3; ++k) {
      bounds.lo[k] = round_down(report_.bounds[k].lo);
      bounds.hi[k] = round_up(report_.bounds[k].hi);
    }
    return cast_solid(solid, bounds, look, &progress_.work());
  }

  Result<Image> draw_grid(const SolidProbe& solid, const PictureOptions& look) {
    progress_.phase(shown_path(path()), "classifying");
    const PointGrid grid =
        classify_grid(solid, report_.bounds, options_.grid, look.jobs, &progress_.work());
    GridCounts& counts = report_.grid.emplace();
    counts.n = grid.n();
    counts.in = grid.count(GridMark::kIn);
    counts.on = grid.count(GridMark::kOn);
    counts.out = grid.count(GridMark::kNone);
    counts.undecided = grid.count(GridMark::kUndecided);
    progress_.phase(shown_path(path()), "drawing");
    return draw_point_grid(grid, look, &progress_.work());
  }

  ExitCode say(const std::string& content) {
    const auto& grid = report_.grid;
    std::string text = "wrote  " + unbroken(harmless(*options_.output)) + "  ";
    if (report_.size)
      text += std::to_string((*report_.size)[0]) + " x " + std::to_string((*report_.size)[1]);
    if (report_.size && !content.empty()) text += ", ";
    text += content;
    if (grid)
      text += ", " + counted(std::uint64_t{grid->n} * grid->n * grid->n, "point", "points") + ": " +
              std::to_string(grid->in) + " in, " + std::to_string(grid->on) + " on, " +
              std::to_string(grid->out) + " out";
    if (grid && grid->undecided != 0) text += ", " + std::to_string(grid->undecided) + " undecided";
    if (options_.json != "-" && options_.output != "-")
      out_.write(fold(text + "\n", verdict_width()));
    const ExitCode exit = grid && grid->undecided != 0 ? kExitUndecided : kExitValid;
    if (!options_.json) return exit;
    const Status status = write_output(*options_.json, render_json(report_), out_);
    return status || *options_.json == "-" ? exit : fail(status.error());
  }

  ExitCode refuse(const Error& error) const {
    Error placed = error;
    placed.place.file = path();
    return fail(placed);
  }

  const RenderOptions& options_;
  StandardOutput& out_;
  Progress progress_;
  Stopwatch watch_;
  RenderReport report_;
  const ViewKind kind_;
};

}  // namespace

RunCommand declare_render(OptionSet& set) {
  const auto o = std::make_shared<RenderOptions>();
  declare(set, *o);
  set.rule([o] { return contradiction(*o); });
  return [o](StandardOutput& out) { return RenderRun(*o, out).run(); };
}

}  // namespace veritope::cli
