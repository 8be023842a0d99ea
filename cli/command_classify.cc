// SPDX-License-Identifier: LGPL-3.0-or-later
// veritope classify.
#include <memory>
#include <utility>

#include "cli/certification.h"
#include "cli/chain_classification.h"
#include "cli/chain_origin.h"
#include "cli/checker_process.h"
#include "cli/classification.h"
#include "cli/commands.h"
#include "cli/decided_model.h"
#include "cli/did_you_mean.h"
#include "cli/expression_classification.h"
#include "cli/expression_operands.h"
#include "cli/output_plan.h"
#include "cli/plane_classification.h"
#include "cli/point_source.h"
#include "cli/scratch_file.h"
#include "io/base/atomic_file.h"
#include "report/report_text.h"
#include "robust/base/stopwatch.h"
#include "solids/patches/patch_sources.h"
#include "topology/incidence.h"
#include "topology/surface.h"
#include "verify/certify/file_patches.h"
#include "verify/certify/stand_in.h"
#include "verify/format/points_certificate.h"

namespace veritope::cli {
namespace {

struct ClassifyOptions {
  InputOptions input;
  std::vector<std::string> files;  // MODEL, POINTS
  std::optional<std::string> output, certificate, json;
  std::optional<Decimals> decimals;
  bool winding = false, no_check = false, orient_auto = false;
  std::optional<ChainKind> by_chain;
  std::optional<ChainOrigin> origin;
  int jobs = default_jobs();
};

std::string take_decimals(const std::string& text, std::optional<Decimals>& decimals) {
  if (text != "nearest" && text != "exact") return "must be nearest or exact, not " + text;
  decimals = text == "exact" ? Decimals::kExact : Decimals::kNearest;
  return "";
}

std::string take_way(const std::string& text, std::optional<ChainKind>& by_chain) {
  by_chain.reset();
  if (text == "normal")
    by_chain = ChainKind::kNormal;
  else if (text == "literal")
    by_chain = ChainKind::kLiteral;
  else if (text != "service")
    return "must be service, normal or literal, not " + text +
           did_you_mean(text, {"service", "normal", "literal"});
  return "";
}

void declare(OptionSet& set, ClassifyOptions& o) {
  set.operands("MODEL POINTS", o.files, "a model, and points as text or .npy; - is standard input",
               2);
  set.output("-o,--output", o.output, "write the answers (standard output)");
  set.text("--certificate", o.certificate, "keep the certificate of the answers; needs -o");
  declare_json(set, o.json, "write the counts");
  set.flag("--winding", o.winding, "around any closed surface, valid or not");
  set.option(
      "--decimals", "HOW", [&o](const std::string& t) { return take_decimals(t, o.decimals); },
      "nearest: rounded to binary64 (default: meshes); or exact");
  set.option(
      "--by", "HOW", [&o](const std::string& t) { return take_way(t, o.by_chain); },
      "service (default); f by a chain: normal, literal");
  set.option(
      "--origin", "X,Y,Z|auto",
      [&o](const std::string& t) { return take_origin(t, o.origin.emplace()); },
      "the chain's origin (0,0,0)");
  declare_orientation(set, o.orient_auto, "faces, patches");
  declare_jobs(set, o.jobs);
  set.flag("--no-check", o.no_check, "do not run veritope-check");
  declare_format(set, o.input);
  declare_reading(set, o.input.reading);
}

std::string contradiction(const ClassifyOptions& o) {
  if (o.certificate && (!o.output || is_stream(*o.output)))
    return "--certificate needs -o with the name of a file, which the checker can read";
  if (o.certificate == "-") return "--certificate needs a file name, not -";
  if (o.by_chain && o.certificate) return "--certificate is not for --by normal or literal";
  if (o.orient_auto && o.winding)
    return "--winding takes the orientation of the file: not with --orient auto";
  if (o.origin && !o.by_chain) return "--origin requires --by normal or literal";
  if (o.json == "-" && (!o.output || *o.output == "-"))
    return "the answers and --json would both write standard output";
  if (o.files.size() == 2 && o.files[0] == "-" && o.files[1] == "-")
    return "MODEL and POINTS cannot both be standard input";
  return "";
}

// What was decided, and the surface.
struct Model {
  ModelFile file;
  std::optional<MeshShells> shells;     // of a mesh; nothing: --winding
  FilePatches patches;                  // of a file of splines
  std::vector<std::uint64_t> reversed;  // entities of such a file
  std::optional<PlaneRegion> plane;     // of a file of curves in the plane
  std::string no_certificate;           // why checkers do not read the model; empty if they do
};

constexpr const char* kIsReversed =
    "the model is taken with reversed faces, and checkers count winding numbers around the faces "
    "of the file";

class ClassifyRun {
 public:
  ClassifyRun(const ClassifyOptions& options, StandardOutput& out)
      : options_(options), out_(out), progress_(true) {}

  ExitCode run() {
    report_.is_winding = options_.winding;
    if (options_.by_chain)
      report_.by = *options_.by_chain == ChainKind::kNormal ? "normal" : "literal";
    if (const Status status = check_outputs(); !status) return fail(status.error());
    if (!options_.no_check) {
      const Result<std::string> checker = find_checker();
      if (!checker) return complain(checker.error().message), kExitUsage;
      checker_ = *checker;
    }
    if (!options_.input.reading.format && !needs_copy(path()) && is_chain_file(path()))
      return run_expression();
    if (const ExitCode exit = take_model(); exit != kExitValid) return exit;
    if (model_.plane) return run_plane();
    const ExitCode exit = options_.by_chain ? classify_by_chain() : classify();
    progress_.clear();
    return exit;
  }

 private:
  const std::string& path() const { return options_.files[0]; }

  ExitCode run_expression() {
    for (const auto& [option, is_given] : {std::pair("--winding", options_.winding),
                                           std::pair("--orient auto", options_.orient_auto),
                                           std::pair("--by", options_.by_chain.has_value())})
      if (is_given)
        return complain(std::string(option) + " is for models, and " + harmless(path()) +
                        " is an expression of solids"),
               kExitUsage;
    Stopwatch watch;
    const CertifySettings settings = certify_settings();
    ExpressionOperands operands(settings, progress_);
    std::optional<ExpressionOperand> expression = operands.load_chain(path());
    progress_.clear();
    if (!expression) return operands.exit();
    for (const auto& output : {options_.output, options_.certificate, options_.json})
      if (output && *output != "-")
        if (const Status status = refuse_same(operands.files(), *output); !status)
          return fail(status.error());
    report_.path = path();
    report_.sha256 = expression->sha256;
    report_.seconds_read = watch.lap();
    progress_.phase(shown_path(path()), "building the look-up");
    std::vector<ExpressionSolid> solids = operands.take_solids();
    std::vector<std::shared_ptr<const Operand>> of_solids;
    for (const ExpressionSolid& solid : solids) of_solids.push_back(solid.operand);
    const ExpressionClassifier classifier(expression->formula, std::move(of_solids));
    std::optional<ExpressionCertificate> certificate;
    if (options_.certificate && operands.no_certificate().empty())
      certificate.emplace(ExpressionCertificate{
          {expression->formula, std::move(solids), expression->size.leaves, jobs()}, {}});
    const LookupSize lookup = classifier.lookup();
    report_.lookup_cells = lookup.cells;
    report_.lookup_bytes = lookup.bytes;
    report_.seconds_build = watch.lap();
    const Decimals decimals =
        options_.decimals.value_or(operands.has_patches() ? Decimals::kExact : Decimals::kNearest);
    const ExitCode exit =
        with_answers(decimals, [&](PointSource& source, const WriteAnswers& write) {
          progress_.phase(shown_path(path()), "classifying");
          const Status status =
              classify_points(classifier, operands.solid_names(), source, jobs(), write, report_,
                              certificate ? &*certificate : nullptr);
          report_.seconds_classify = watch.lap();
          return status;
        });
    progress_.clear();
    if (exit != kExitValid) return exit;
    const ExitCode certified = certificate ? keep_certificate(*expression, *certificate)
                               : options_.certificate
                                   ? without_certificate(operands.no_certificate())
                                   : kExitValid;
    const ExitCode decided = report_.num_undecided == 0 ? kExitValid : say_undecided();
    return first_of(first_of(certified, decided), write_json());
  }

  ExitCode run_plane() {
    Stopwatch watch;
    const ExitCode exit = with_answers(
        options_.decimals.value_or(Decimals::kExact),
        [&](PointSource& source, const WriteAnswers& write) {
          progress_.phase(shown_path(path()), "classifying");
          const Status status =
              classify_points(*model_.plane, source, static_cast<unsigned>(options_.jobs),
                              options_.winding, write, report_);
          report_.seconds_classify = watch.lap();
          return status;
        },
        2);
    return exit == kExitValid ? write_json() : exit;
  }
  ExitCode keep_certificate(const ExpressionOperand& expression, ExpressionCertificate& parts) {
    certificate::Subject subject;
    subject.sha256 = expression.sha256;
    subject.bytes = expression.bytes;
    subject.format = kChainFormat;
    subject.as_indexed = options_.input.reading.as_indexed;
    subject.tool = tool_name();
    parts.answers.are_decimals_exact = report_.are_decimals_exact;
    const Result<certificate::Bytes> made =
        parts.certifier.finish(std::move(subject), parts.answers);
    if (!made) return without_certificate(path() + ": " + made.error().message);
    num_uncovered_ = parts.certifier.num_uncovered();
    return keep_certificate(*made);
  }
  unsigned jobs() const { return static_cast<unsigned>(options_.jobs); }

  // Opens the points and the answers for `work`, and keeps the answers if it succeeds.
  template <typename Work>
  ExitCode with_answers(Decimals decimals, Work work, std::size_t dimension = 3) {
    report_.are_decimals_exact = decimals == Decimals::kExact;
    auto source =
        open_points(options_.files[1], decimals, options_.input.reading.limits, dimension);
    if (!source) return refuse(source.error());
    std::optional<AtomicFile> answers;
    if (options_.output && !is_stream(*options_.output)) {
      Result<AtomicFile> made = AtomicFile::create(*options_.output);
      if (!made) return refuse(made.error());
      answers.emplace(std::move(*made));
    }
    const WriteAnswers write = [&](std::string_view lines) -> Status {
      if (answers) return answers->write(lines);
      if (options_.output && *options_.output != "-")
        return write_output(*options_.output, lines, out_);
      out_.write(lines);
      return out_.status();
    };
    const Status status = work(**source, write);
    progress_.clear();
    if (!status) {
      if (status.error().code == Code::kBadArgument) {
        complain(harmless(path() + ": " + status.error().message));
        return kExitInvalid;
      }
      return refuse(status.error());
    }
    if (answers)
      if (const Status committed = answers->commit(); !committed) return refuse(committed.error());
    return kExitValid;
  }

  Status check_outputs() const {
    const Result<OutputPlan> plan = plan_outputs({path()}, options_.certificate, options_.json);
    if (!plan) return plan.error();
    if (plan->has_folder)
      return bad_argument("--certificate names the folder " + *options_.certificate +
                          "; classify needs the name of a file");
    if (options_.output && *options_.output != "-")
      if (const Status status =
              check_output("--output", *options_.output, options_.files, *plan, options_.json);
          !status)
        return status;
    for (const auto& output : {options_.certificate, options_.json})
      if (output && *output != "-")
        if (const Status status = refuse_same(options_.files, *output); !status) return status;
    return try_outputs(*plan, {options_.json, options_.output});
  }

  // Reads the model and, without --winding, decides it.
  ExitCode take_model() {
    Stopwatch watch;
    const ExitCode exit = options_.winding ? read() : certify();
    progress_.clear();
    report_.seconds_read = watch.lap();
    if (exit != kExitValid) return exit;
    report_.path = path();
    report_.sha256 = sha256_of(model_.file);
    if (const Status status = require_surface(model_.file, path()); !status)
      return refuse(status.error());
    if (std::holds_alternative<MeshFile>(model_.file)) return kExitValid;
    if (is_plane_model(model_.file)) return take_plane();
    return take_patches(std::get<SplineFile>(model_.file));
  }

  ExitCode take_plane() {
    for (const auto& [option, is_given] :
         {std::pair("--certificate", options_.certificate.has_value()),
          std::pair("--orient auto", options_.orient_auto),
          std::pair("--by", options_.by_chain.has_value())})
      if (is_given)
        return complain(std::string(option) + " is for models in space, and " + harmless(path()) +
                        " has curves of the plane"),
               kExitUsage;
    Stopwatch watch;
    Result<PlaneRegion> region = plane_region_of(model_.file);
    report_.seconds_build = watch.lap();
    if (region) return model_.plane.emplace(std::move(*region)), kExitValid;
    Error error = region.error();
    error.place.file = path();
    return complain(harmless("no points are classified: " + to_string(error))), kExitInvalid;
  }

  ExitCode take_patches(const SplineFile& file) {
    const Result<std::optional<StandIn>> stand_in = stand_in_of(file);
    if (!stand_in) return refuse(stand_in.error());
    is_by_faces_ = *stand_in && (*stand_in)->is_by_own_faces();
    if (*stand_in ? (*stand_in)->is_copy() : !is_read_by_checkers(file))
      model_.no_certificate =
          "the checkers do not read this file, but a copy; veritope convert writes it as .vjson";
    else if (file.beyond_default_limits)
      model_.no_certificate = "the file has longer numbers than certificates may be about";
    Result<FilePatches> patches = patches_of(file, *stand_in);
    if (!patches) return refuse(patches.error());
    model_.patches = std::move(*patches);
    if (!model_.reversed.empty()) {
      reverse_entities(model_.patches, model_.reversed);
      model_.no_certificate = kIsReversed;
    }
    const PatchComplex* const complex = model_.patches.complex.get();
    if (complex != nullptr) return check_closed(*complex);
    complain(harmless(path() + ": " + text_of(*model_.patches.not_covered)));
    return kExitUndecided;
  }

  ExitCode read() {
    progress_.phase(shown_path(path()), "reading");
    const Result<ModelBytes> bytes = load_model(path(), options_.input.reading);
    if (!bytes) return refuse(bytes.error());
    Result<ModelFile> file = read_model(*bytes, options_.input.reading);
    if (!file) return refuse(file.error());
    model_.file = std::move(*file);
    if (needs_copy(path()))
      model_bytes_.assign(reinterpret_cast<const char*>(bytes->bytes.data()), bytes->bytes.size());
    return kExitValid;
  }

  CertifySettings certify_settings() const {
    CertifySettings out;
    out.reading = options_.input.reading;
    out.reading.jobs = options_.jobs;
    out.certify.jobs = static_cast<unsigned>(options_.jobs);
    out.checker = checker_;
    return out;
  }

  ExitCode certify() {
    CertifySettings settings = certify_settings();
    settings.model = &model_.file;
    settings.model_bytes = &model_bytes_;
    if (options_.orient_auto) settings.certify.orientation = PatchOrientation::kAuto;
    const CertifiedFile done = certify_file(path(), settings, {}, progress_);
    progress_.clear();
    if (is_plane_model(model_.file)) return kExitValid;  // nothing certifies loops
    report_.verdict = done.report.verdict;
    if (done.report.verdict != Verdict::kValid) {
      std::string line = verdict_line(done.report, TextOptions());
      while (line.ends_with('\n')) line.pop_back();
      complain("no points are classified: " + line);
      return done.report.exit;
    }
    if (const auto* facts = std::get_if<MeshFacts>(&done.report.facts)) {
      if (facts->reversal) reverse_faces(facts->reversal->is_reversed);
      set_shells(*facts);
    }
    if (const auto* facts = std::get_if<PatchFacts>(&done.report.facts)) {
      model_.reversed = facts->reversed;
      for (const std::uint64_t entity : model_.reversed) add_reversed("entities", entity);
      // The boundary faces of cells turn with them.
      if (facts->vmodel)
        for (const std::uint64_t cell : facts->vmodel->reversed) add_reversed("cells", cell);
    }
    return kExitValid;
  }

  void reverse_faces(const std::vector<bool>& is_reversed) {
    TriangleMesh& mesh = std::get<MeshFile>(model_.file).mesh;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      if (!is_reversed[f]) continue;
      std::swap(mesh.faces[f][1], mesh.faces[f][2]);
      add_reversed("faces", f);
    }
    model_.no_certificate = kIsReversed;
  }

  void add_reversed(const char* parts, std::uint64_t number) {
    if (!report_.reversed) report_.reversed = {parts, 0, {}};
    report_.reversed->add(number);
  }

  void set_shells(const MeshFacts& facts) {
    const TriangleMesh& mesh = std::get<MeshFile>(model_.file).mesh;
    const auto jobs = static_cast<unsigned>(options_.jobs);
    const SurfaceTopology topology = analyse_surface(
        mesh.faces,
        Incidence::build(mesh.faces, static_cast<std::uint32_t>(mesh.positions.size()), jobs), 0,
        jobs);
    model_.shells.emplace();
    model_.shells->shell_of_face.assign(topology.shell_of_face.data(),
                                        topology.shell_of_face.data() + mesh.faces.size());
    model_.shells->depth = facts.decision.nesting.depth;
  }

  ExitCode classify_by_chain() {
    std::optional<PatchComplex> of_mesh;
    const auto* const mesh = std::get_if<MeshFile>(&model_.file);
    if (mesh != nullptr) {
      Result<PatchInput> patches = patches_of(mesh->mesh);
      if (!patches) return refuse(patches.error());
      Result<PatchComplex> made = make_patch_complex(std::move(*patches));
      if (!made) return refuse(made.error());
      of_mesh.emplace(std::move(*made));
      if (const ExitCode exit = check_closed(*of_mesh); exit != kExitValid) return exit;
    }
    const PatchComplex& complex = of_mesh ? *of_mesh : *model_.patches.complex;
    const Decimals decimals =
        options_.decimals.value_or(mesh != nullptr ? Decimals::kNearest : Decimals::kExact);
    progress_.phase(shown_path(path()), "classifying");
    const ExitCode exit =
        with_answers(decimals, [&](PointSource& source, const WriteAnswers& write) {
          const ExactPoint origin = origin_for(complex, options_.origin.value_or(ChainOrigin()));
          report_.origin = origin;
          return cli::classify_by_chain(complex, *options_.by_chain, origin, source,
                                        static_cast<unsigned>(options_.jobs), write, report_);
        });
    return exit == kExitValid ? write_json() : exit;
  }

  ExitCode check_closed(const PatchComplex& complex) {
    if (complex.is_closed_oriented_surface()) return kExitValid;
    std::string why = "the surface is not closed";
    if (!complex.findings().empty()) why = describe(complex, complex.findings().front());
    complain(harmless(path() + ": " + why));
    return kExitInvalid;
  }

  ExitCode classify() {
    const auto* const mesh = std::get_if<MeshFile>(&model_.file);
    if (mesh != nullptr && mesh->copy)
      model_.no_certificate =
          "the checkers read meshes, not these polygons; veritope convert writes them as a mesh";
    ClassifySettings settings;
    settings.is_winding = options_.winding;
    settings.makes_certificate = options_.certificate && model_.no_certificate.empty();
    settings.decimals =
        options_.decimals.value_or(mesh != nullptr ? Decimals::kNearest : Decimals::kExact);
    settings.jobs = static_cast<unsigned>(options_.jobs);
    std::optional<ClassifiedPoints> made;
    const ExitCode answered = with_answers(
        settings.decimals, [&](PointSource& source, const WriteAnswers& write) -> Status {
          Result<ClassifiedPoints> points = answer(mesh, source, settings, write);
          if (!points) return points.error();
          made = std::move(*points);
          return ok_status();
        });
    if (answered != kExitValid) return answered;
    ExitCode exit = kExitValid;
    if (options_.certificate && !settings.makes_certificate)
      exit = without_certificate(path() + ": " + model_.no_certificate);
    else if (made->refusal)
      exit = without_certificate(path() + ": " + made->refusal->message);
    else
      exit = keep_certificate(made->certificate);
    if (report_.num_undecided != 0) exit = first_of(exit, say_undecided());
    return first_of(exit, write_json());
  }

  Result<ClassifiedPoints> answer(const MeshFile* mesh, PointSource& source,
                                  const ClassifySettings& settings, const WriteAnswers& write) {
    if (mesh != nullptr)
      return classify_points(*mesh, model_.shells ? &*model_.shells : nullptr, source, settings,
                             write, progress_, shown_path(path()), report_);
    const auto subject = subject_of(std::get<SplineFile>(model_.file), tool_name(), is_by_faces_);
    return classify_points(model_.patches, subject, source, settings, write, progress_,
                           shown_path(path()), report_);
  }

  ExitCode say_undecided() const {
    const auto& first = report_.undecided.front();
    complain(std::to_string(report_.num_undecided) + " of " + std::to_string(report_.points) +
             " points are undecided; line " + std::to_string(first.line) + ": " + first.reason);
    return kExitUndecided;
  }

  // The answers stay.
  static ExitCode without_certificate(const std::string& why) {
    complain(harmless("the answers are written, but have no certificate: " + why));
    return kExitUndecided;
  }

  // Has the checker confirm the certificate, then keeps it.
  ExitCode keep_certificate(const certificate::Bytes& bytes) {
    if (!options_.certificate) return kExitValid;
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    report_.certificate = {*options_.certificate, bytes.size(),
                           report_.num_undecided + num_uncovered_, false};
    if (!checker_.empty())
      if (const ExitCode exit = check(text); exit != kExitValid) return exit;
    const Status status = write_output(*options_.certificate, text, out_);
    return status ? kExitValid : refuse(status.error());
  }

  ExitCode check(std::string_view certificate) {
    progress_.phase(shown_path(path()), "checking");
    const Result<ScratchFile> scratch = ScratchFile::with(certificate);
    if (!scratch) return refuse(scratch.error());
    std::vector<int> inherited = {scratch->descriptor()};
    std::string model = path();
    std::optional<ScratchFile> copy;
    if (!model_bytes_.empty()) {  // the input cannot be read again
      Result<ScratchFile> made = ScratchFile::with(model_bytes_);
      if (!made) return refuse(made.error());
      copy.emplace(std::move(*made));
      inherited.push_back(copy->descriptor());
      model = copy->path();
    }
    const CheckerOutcome outcome =
        run_checker(checker_, model, scratch->path(), std::string(certificate::kPointsClaim),
                    inherited, *options_.output);
    progress_.clear();
    report_.certificate->is_checked = outcome.is_accepted;
    if (outcome.is_accepted) return kExitValid;
    report_.certificate.reset();
    const std::string words = outcome.is_started ? "veritope-check says " + outcome.words
                                                 : checker_ + " " + outcome.words;
    if (!outcome.is_started || outcome.lacks_resources || outcome.exceeds_work)
      return without_certificate(words);
    complain(harmless("the certificate is not kept: " + words +
                      "; this is a bug of veritope: please report it with both files"));
    return kExitBug;
  }

  ExitCode write_json() {
    if (!options_.json) return kExitValid;
    const Status status = write_output(*options_.json, classify_json(report_), out_);
    return status || *options_.json == "-" ? kExitValid : refuse(status.error());
  }

  ExitCode refuse(const Error& error) {
    progress_.clear();
    complain(harmless(to_string(error)));
    return kExitUnreadable;
  }

  const ClassifyOptions& options_;
  StandardOutput& out_;
  Progress progress_;
  std::string checker_;  // empty: --no-check
  Model model_;
  std::uint64_t num_uncovered_ = 0;  // decided points of which the certificate says nothing
  bool is_by_faces_ = false;         // certificates number the boundary faces of the file's volumes
  std::string model_bytes_;          // if needs_copy(path())
  ClassifyReport report_;
};

}  // namespace

RunCommand declare_classify(OptionSet& set) {
  const auto o = std::make_shared<ClassifyOptions>();
  declare(set, *o);
  set.rule([o] { return contradiction(*o); });
  return [o](StandardOutput& out) { return ClassifyRun(*o, out).run(); };
}

}  // namespace veritope::cli
