// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <limits>
#include <memory>

#include "io/formats.h"
#include "robust/base/parallel.h"
#include "solids/interval_boxes/condition_sweep.h"
#include "verify/certify/certify.h"

namespace veritope::cli {
namespace {

constexpr std::uint64_t kMost64 = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t kMost32 = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kMostFaces = (std::uint64_t{1} << 30) - 1;  // decide_validity's
constexpr std::uint64_t kMostJobs = 1024;

// Decimal digits and nothing else.
std::uint64_t parse_number(const std::string& name, const std::string& text, std::uint64_t least,
                           std::uint64_t most) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc() && stop == end && value >= least && value <= most) return value;
  throw CLI::ValidationError(name, "must be a number from " + std::to_string(least) + " to " +
                                       std::to_string(most) + ", not " + text);
}

template <typename T>
void add_number(CLI::App* app, const std::string& name, T& target, std::uint64_t least,
                std::uint64_t most, const std::string& help) {
  const std::string last = name.substr(name.rfind("--"));
  app->add_option_function<std::string>(
         name,
         [&target, last, least, most](const std::string& text) {
           target = static_cast<T>(parse_number(last, text, least, most));
         },
         help)
      ->type_name("N");
}

void add_text(CLI::App* app, const std::string& name, std::optional<std::string>& target,
              const char* type, const std::string& help) {
  app->add_option_function<std::string>(
         name,
         [&target, name](const std::string& text) {
           if (text.empty()) throw CLI::ValidationError(name, "needs a name");
           target = text;
         },
         help)
      ->type_name(type);
}

void add_files(CLI::App* app, std::vector<std::string>& files, const char* what) {
  app->add_option("FILE", files, what)->required()->type_name("");
}

// Exactly one.
void add_file(CLI::App* app, const std::string& name, std::vector<std::string>& files,
              const std::string& help) {
  app->add_option_function<std::string>(
         name, [&files](const std::string& path) { files = {path}; }, help)
      ->required()
      ->type_name("");
}

void add_any_format(CLI::App* app, Options& o) {
  app->add_option_function<std::string>(
         "--format",
         [&o](const std::string& name) {
           const ModelFormat* const row = format_from_name(name);
           if (row == nullptr)
             throw CLI::ValidationError("--format",
                                        "must be " + format_names("or") + ", not " + name);
           o.reading.format = row->id;
         },
         format_names("or"))
      ->type_name("F");
}

void add_reading(CLI::App* app, Options& o) {
  app->add_flag("--as-indexed", o.reading.as_indexed, "keep the file's vertex indices, merge none");
  ReadLimits& limits = o.reading.limits;
  add_number(app, "--max-bytes", limits.max_bytes, 0, kMost64,
             "limit: size of a file (4 GiB); --max-faces N: triangles");
  add_number(app, "--max-faces", limits.max_faces, 0, kMostFaces, "limit: triangles (200000000)");
  app->get_option("--max-faces")->group("");  // in the line above
  add_number(app, "--max-digits", limits.max_digits, 1, kMost32,
             "limit: digits (1000); --max-exponent N: exponent (4096)");
  add_number(app, "--max-exponent", limits.max_exponent, 0, kMost32,
             "limit: exponent of a number (4096)");
  app->get_option("--max-exponent")->group("");  // in the line above
}

void add_jobs(CLI::App* app, Options& o) {
  add_number(app, "-j,--jobs", o.jobs, 1, kMostJobs, "threads (default: all of the machine)");
}

// A decimal number from 1e-300 to 1e300, so that a few roundings of its products stay finite.
template <typename T>
void add_length(CLI::App* app, const std::string& name, T& target, const char* type,
                const std::string& help) {
  app->add_option_function<std::string>(
         name,
         [&target, name](const std::string& text) {
           double value = 0;
           const char* const end = text.data() + text.size();
           const auto [stop, error] = std::from_chars(text.data(), end, value);
           if (error != std::errc() || stop != end || !(value >= 1e-300 && value <= 1e300))
             throw CLI::ValidationError(name, "must be a length from 1e-300 to 1e300, not " + text);
           target = value;
         },
         help)
      ->type_name(type);
}

void add_orientation(CLI::App* app, Options& o, const char* what_is_reversed) {
  app->add_option_function<std::string>(
         "--orient",
         [&o](const std::string& how) {
           if (how != "auto" && how != "keep")
             throw CLI::ValidationError("--orient", "must be auto or keep, not " + how);
           o.orient_auto = how == "auto";
         },
         std::string("auto: reverse ") + what_is_reversed + " that do not fit; keep: none")
      ->type_name("HOW");
}

void add_certify(CLI::App& app, Options& o) {
  CLI::App* const c =
      app.add_subcommand("certify", "decide whether models bound solids, and prove it");
  c->callback([&o] { o.command = Command::kCertify; });
  add_files(c, o.files, "meshes, VJSON, ITD; - is standard input (with --format)");
  add_text(c, "--json", o.json, "F", "write the report as JSON; - is standard output");
  add_text(c, "--certificate", o.certificate, "F",
           "keep the certificate; of several files in folder F");
  add_text(c, "--picture", o.picture, "F", "write a coloured PLY that shows the defects");
  add_number(c, "--max-defects", o.max_defects, 0, kMost32, "list at most N defects (20)");
  add_jobs(c, o);
  add_orientation(c, o, "patches, shells");
  add_length(c, "--tolerance", o.tolerance, "EPS",
             "of the volume of patches, in sizes cubed (1e-5)");
  c->add_flag("--collar", o.collar, "of patches: find a collar, certify it, too");
  c->add_flag("--no-check", o.no_check, "do not run veritope-check, and say so");
  c->add_flag("-q,--quiet", o.quiet, "the verdict lines only");
  add_any_format(c, o);
  add_reading(c, o);
}

void add_info(CLI::App& app, Options& o) {
  CLI::App* const c = app.add_subcommand("info", "what is in mesh and spline files");
  c->callback([&o] { o.command = Command::kInfo; });
  add_files(c, o.files,
            "STL, OBJ, PLY, OFF, ITD, G2, MFEM's MESH, G+Smo's XML\nor VJSON; - is standard input "
            "(with --format)");
  add_text(c, "--json", o.json, "F", "write it as JSON; - is standard output");
  add_jobs(c, o);
  add_any_format(c, o);
  add_reading(c, o);
}

void add_convert(CLI::App& app, Options& o) {
  CLI::App* const c =
      app.add_subcommand("convert", "write a mesh or splines in another format, without loss");
  c->callback([&o] { o.command = Command::kConvert; });
  add_file(c, "IN", o.files, "a mesh or splines; - is standard input (with --format)");
  c->add_option("OUT", o.output, "the new file; - is standard output (with --to)")
      ->required()
      ->type_name("");
  add_text(c, "--to", o.to, "V",
           "a mesh: stl, stl-ascii, obj, ply, ply-ascii, ply-be, off;\nsplines: itd, g2, vjson; to "
           "look at: vtu, obj, gltf");
  add_length(c, "--chord", o.chord, "H", "of splines in obj, gltf: distance of chords aimed at");
  c->add_flag("--float", o.single_precision, "binary PLY with binary32 coordinates");
  c->add_flag("--faces", o.faces, "of spline volumes: their boundary, as surfaces");
  c->add_flag("--lossy", o.lossy, "round or renumber if need be, and say how much");
  add_jobs(c, o);
  add_any_format(c, o);
  add_reading(c, o);
}

void add_intersect(CLI::App& app, Options& o) {
  CLI::App* const c =
      app.add_subcommand("intersect", "where the surfaces of two files meet, certified");
  c->callback([&o] { o.command = Command::kIntersect; });
  c->add_option("A B", o.files, "two files of splines; - is standard input (with --format)")
      ->required()
      ->expected(2)
      ->type_name("");
  add_text(c, "-o,--output", o.curves, "F", "write the curves; F ends in .json or .vtu");
  add_text(c, "--json", o.json, "F", "write the report as JSON; - is standard output");
  add_length(
      c, "--gap", o.gap, "D",
      "wanted between the images of a curve in both surfaces\n(2^-24 of the first one's extent)");
  add_number(c, "--max-pairs", o.max_pairs, 1, kMost64,
             "rectangles to compare at most (200000000)");
  add_any_format(c, o);
}

void add_project(CLI::App& app, Options& o) {
  CLI::App* const c = app.add_subcommand(
      "project",
      "all critical points of the distance from a point\nto curves and surfaces, certified");
  c->callback([&o] { o.command = Command::kProject; });
  c->add_option("POINT", o.point, "x,y,z: decimals, fractions or hexadecimal numbers, exact")
      ->required()
      ->type_name("");
  add_file(c, "SURFACE", o.files, "a file of splines; - is standard input (with --format)");
  add_text(c, "--json", o.json, "F", "write the report as JSON; - is standard output");
  add_number(c, "--max-boxes", o.max_boxes, 1, kMost64,
             "of each curve and surface: parameter boxes to look at\n(100000)");
  add_any_format(c, o);
}

void add_cover(CLI::App& app, Options& o) {
  CLI::App* const c = app.add_subcommand("cover", "the boxes and cells of a proof, to look at");
  c->callback([&o] { o.command = Command::kCover; });
  add_file(c, "MODEL", o.files, "a file of patches (itd, g2, mfem, gismo, vjson)");
  c->add_option("-o,--output", o.output, "the new file: .vtu, .obj, .ply, .off or .stl")
      ->type_name("F");
  CLI::Option* const what = c->add_option_function<std::string>(
      "--what",
      [&o](const std::string& name) {
        const auto part = cover_part_from_name(name);
        if (!part)
          throw CLI::ValidationError("--what",
                                     "must be boxes, collar, outer or inner, not " + name);
        o.cover_part = *part;
      },
      "star boxes: boxes; octree cells around the surface:\ncollar (default); solids: outer, "
      "inner");
  what->type_name("W");
  c->add_option_function<std::string>(
       "--sweep",
       [&o](const std::string& text) {
         o.sweep = static_cast<int>(parse_number("--sweep", text, 0, kMaxSweep));
       },
       "table which of A, B1, B2, C1, C2, C3, C3*, K1-K3 hold\nof boxes of size EPS, halved N "
       "times; -o: the last")
      ->type_name("N")
      ->excludes(what);
  add_length(c, "--eps", o.eps, "EPS", "the first size (a quarter of the model or less)");
  c->get_option("--eps")->needs("--sweep");
  add_text(c, "--json", o.json, "F", "the table as JSON; - is standard output");
  c->get_option("--json")->needs("--sweep");
  add_orientation(c, o, "patches");
  c->add_flag("-q,--quiet", o.quiet, "nothing on standard output, no progress");
  add_any_format(c, o);
}

void add_explain(CLI::App& app, Options& o) {
  CLI::App* const c =
      app.add_subcommand("explain", "what a rule or an answer means; without RULE: the list");
  c->callback([&o] { o.command = Command::kExplain; });
  c->add_option_function<std::string>(
       "RULE", [&o](const std::string& id) { o.rule = id; }, "M1 to M9, side-open, ...")
      ->type_name("");
  CLI::App* const e = app.add_subcommand("explain-certificate", "a certificate as text");
  e->callback([&o] { o.command = Command::kExplainCertificate; });
  add_file(e, "F", o.files, "a certificate file");
  add_number(e, "--max-items", o.max_items, 0, kMost32, "items of each list that are shown (20)");
}

void add_predicate(CLI::App& app, Options& o) {
  CLI::App* const c = app.add_subcommand("predicate", "exact signs of geometric predicates");
  c->callback([&o] { o.command = Command::kPredicate; });
  c->add_option_function<std::string>(
       "NAME",
       [&o](const std::string& name) {
         o.predicate = predicate_from_name(name);
         if (o.predicate != nullptr || name == "any") return;
         throw CLI::ValidationError("NAME",
                                    "must be one of any, " + predicate_names() + ", not " + name);
       },
       "orient2d, orient3d, in_circle, in_sphere,\nside_of_plane, compare_along, on implicit "
       "points:\norient3d_lpi, ...; any: each line names its own")
      ->required()
      ->type_name("");
  add_file(c, "FILE", o.files,
           "one case a line: the coordinates as decimals or\nas 0x1.8p-3; # comments; - is "
           "standard input");
  c->add_flag("--expect", o.expect,
              "behind the coordinates stands the sign expected:\nreport disagreements");
  c->add_flag("--tiers", o.tiers, "say on standard error which tiers decided");
}

void add_selftest(CLI::App& app, Options& o) {
  CLI::App* const c = app.add_subcommand("selftest", "hard signs, decided in two ways, compared");
  c->callback([&o] { o.command = Command::kSelftest; });
  add_number(c, "--cases", o.num_cases, 1, kMost64, "cases in all (100000)");
  add_number(c, "--seed", o.seed, 0, kMost64, "of the random numbers (1)");
}

void add_corpus(CLI::App& app, Options& o) {
  CLI::App* const c = app.add_subcommand("corpus", "hard cases with their exact signs, as text");
  c->callback([&o] { o.command = Command::kCorpus; });
  add_number(c, "--cases", o.num_cases, 1, kMost64, "cases in all (100000)");
  add_number(c, "--seed", o.seed, 0, kMost64, "of the random numbers (1)");
}

// What must hold between options.
std::string contradiction(const Options& o) {
  const auto inputs = std::count(o.files.begin(), o.files.end(), "-");
  const bool reads = o.command == Command::kCertify || o.command == Command::kInfo ||
                     o.command == Command::kConvert || o.command == Command::kIntersect ||
                     o.command == Command::kProject || o.command == Command::kCover;
  if (reads && inputs > 0 && !o.reading.format) return "- is standard input and needs --format";
  if (inputs > 1) return "standard input can be read once only";
  if (std::find(o.files.begin(), o.files.end(), "") != o.files.end()) {
    return "a file name must not be empty";
  }
  if (o.command == Command::kConvert && o.output == "-" && !o.to) {
    return "- is standard output and needs --to";
  }
  if (o.command == Command::kCover && o.output.empty() && !o.sweep)
    return "-o,--output is required";
  if (o.command == Command::kCover && o.output == "-") return "--output needs a file name, not -";
  if (o.picture == "-") return "--picture needs a file name, not -";
  if (o.picture && o.files.size() > 1) return "--picture shows one file, not several";
  if (o.certificate == "-") return "--certificate needs a file name, not -";
  return "";
}

const char kFooter[] =
    "Exit: 0 valid or done, 1 invalid, 2 wrong usage, 3 undecided, 4 unreadable, over\n"
    "a limit or cannot write, 5 our bug; of several files the first of 5, 1, 4, 3, 0";

}  // namespace

ParsedArguments parse_arguments(int argc, const char* const* argv) {
  Options o;
  o.jobs = std::clamp(hardware_jobs(), 1u, static_cast<unsigned>(kMostJobs));
  CLI::App app("veritope: solid models that come with proofs", "veritope");
  app.set_version_flag("--version", tool_name());
  app.require_subcommand(1);
  app.footer(kFooter);
  app.get_formatter()->column_width(23);
  add_certify(app, o);
  add_info(app, o);
  add_convert(app, o);
  add_intersect(app, o);
  add_project(app, o);
  add_cover(app, o);
  add_explain(app, o);
  add_predicate(app, o);
  add_selftest(app, o);
  add_corpus(app, o);
  ParsedArguments out;
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  const auto is_named = [argv](const CLI::App* c) { return c->get_name() == argv[1]; };
  if (argc > 1 && argv[1][0] != '-' && std::none_of(commands.begin(), commands.end(), is_named)) {
    out.error = std::string("unknown command: ") + argv[1];
    return out;
  }
  try {
    app.parse(argc, argv);
    o.reading.jobs = static_cast<int>(o.jobs);
    out.error = contradiction(o);
    if (out.error.empty()) out.options = std::move(o);
  } catch (const CLI::CallForHelp&) {
    const auto chosen = app.get_subcommands();
    out.text = chosen.empty() ? app.help() : chosen[0]->help("veritope");
    // Options without a group leave an empty one.
    if (const auto at = out.text.find("\n\n\n"); at != out.text.npos) out.text.erase(at, 1);
  } catch (const CLI::CallForVersion&) {
    out.text = tool_name() + "\n";
  } catch (const CLI::ParseError& error) {
    out.error = error.what();
  }
  return out;
}

}  // namespace veritope::cli
