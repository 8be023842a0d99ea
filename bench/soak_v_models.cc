// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_v_models.cc: --models N --non-manifold M --seed S [--family NAME] [--changes K]
// [--python PATH] [--python-every K] [--dump FOLDER] [--only-write 1]. Random V-models of known truth
// (tests/support/random_v_models.h), N of each family (M of the last, non_manifold), judged by certify.
// The C++ checker checks every certificate in this process, the Python one (its path) some. Then K
// other descriptions of each model, of five kinds in turn: the same verdict, genus, counts and
// volume. One JSON line a row: wrong answers. Each wrong or undecided model is written to FOLDER
// (default: that for temporary files), and named on standard error with its seed; with --only-write 1 all are, and
// nothing is judged.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/stopwatch.h"
#include "tests/support/v_model_judge.h"

namespace {

using namespace veritope;
using namespace veritope::random_v_models;

/// A row of the table of what certify may answer.
struct Family {
  const char* name;
  const char* group;
  Model (*make)(Random&);
  int share;  ///< of the group's models
  bool may_be_valid, may_be_invalid;
  /// The first codes that are wanted of an INVALID; any other one is counted. Separated by spaces; "": none is wanted.
  const char* wanted;
  double most_undecided;  ///< of all models; 1: any number
};
constexpr Family kFamilies[] = {
    {"grid", "exclusive", grid, 25, true, false, "", 0.02},
    {"polycube", "exclusive", polycube, 25, true, false, "", 0.02},
    {"ring", "exclusive", ring, 20, true, false, "", 0.02},
    {"primitive", "exclusive", primitive, 15, true, false, "", 0.02},
    {"helix", "exclusive", helix, 15, true, false, "", 0.02},
    {"opposed", "opposed", opposed, 100, true, false, "", 1},
    {"folded", "folded", folded, 100, false, true, "folded", 0.02},
    {"overlapping", "overlapping", overlapping, 100, false, true,
     "overlap curve-nonmanifold point-nonmanifold", 0.02},
    {"touching_at_sides", "touching", touching_at_sides, 50, false, true,
     "curve-nonmanifold point-nonmanifold", 1},
    {"touching_inside", "touching", touching_inside, 50, false, true, "", 1},
    {"non_manifold", "non_manifold", non_manifold, 100, false, true,
     "curve-nonmanifold point-nonmanifold", 1},
};
constexpr const char* kGroups[] = {"exclusive",   "opposed",  "folded",
                                   "overlapping", "touching", "non_manifold"};

bool is_among(const std::string& code, std::string words) {
  words = " " + words + " ";
  return words.find(" " + code + " ") != std::string::npos;
}

struct Settings {
  std::uint64_t seed = 1;
  std::size_t changes = 5, python_every = 50;
  std::uint64_t only_write = 0;
  std::string python, dump = std::filesystem::temp_directory_path().string();
};

struct Row {
  std::size_t models = 0, valid = 0, invalid = 0, undecided = 0, unwanted = 0, wrong = 0,
              changes = 0, lost = 0, gained = 0, python = 0;
  std::map<std::string, std::size_t> codes;
  double seconds = 0, slowest = 0;
};

// One family's run.
class Run {
 public:
  Run(const Family& family, const Settings& settings) : family_(family), settings_(settings) {}

  Row run(std::uint64_t first, std::size_t count) {
    for (std::uint64_t i = first; i < first + count; ++i) judge_model(i);
    return row_;
  }

 private:
  void judge_model(std::uint64_t seed) {
    seed_ = seed;
    Random random(seed * 1000003);
    const Model model = family_.make(random);
    what_ = model.description;
    if (settings_.only_write != 0) return tell("written", model.cells, "not judged");
    const Judged j = timed(model.cells, PatchOrientation::kKeep);
    ++row_.models;
    ++(j.verdict() == Verdict::kValid     ? row_.valid
       : j.verdict() == Verdict::kInvalid ? row_.invalid
                                          : row_.undecided);
    if (j.verdict() != Verdict::kValid)
      ++row_.codes[(j.verdict() == Verdict::kInvalid ? "INVALID " : "UNDECIDED ") + j.code];
    if (j.verdict() == Verdict::kInvalid && !is_among(j.code, family_.wanted)) ++row_.unwanted;
    const bool is_told_undecided = j.verdict() == Verdict::kUndecided && family_.most_undecided < 1;
    if (is_told_undecided) tell("undecided", model.cells, j.certified.findings.front().message);
    expect_allowed(model, j);
    if (model.negative_at &&
        !has_determinant(model.cells[model.folded_cell], *model.negative_at, Sign::kNegative))
      wrong("the planted fold is none", model.cells);
    for (std::size_t k = 0; k < settings_.changes; ++k)
      judge_change(model, j, static_cast<Change>((seed + k) % kChangeNames.size()), random);
  }

  Judged timed(const std::vector<VVolume>& cells, PatchOrientation orientation) {
    const bench::Stopwatch watch;
    Judged out = judged(cells, orientation);
    const double seconds = watch.ns() * 1e-9;
    row_.seconds += seconds;
    row_.slowest = std::max(row_.slowest, seconds);
    if (!out.problem.empty()) wrong(out.problem, cells);
    if (!settings_.python.empty() && !out.certified.certificate.empty() &&
        ++certificates_ % settings_.python_every == 0)
      check_in_python(out, cells);
    return out;
  }

  void expect_allowed(const Model& model, const Judged& j) {
    if (j.verdict() == Verdict::kValid && !family_.may_be_valid) return wrong("VALID", model.cells);
    if (j.verdict() == Verdict::kInvalid && !family_.may_be_invalid)
      return wrong("INVALID " + j.code, model.cells);
    if (j.verdict() == Verdict::kValid)
      if (const auto why = wrong_numbers(j, *model.solid, model.cells.size(), true); !why.empty())
        wrong(why, model.cells);
    const bool is_polynomial = std::none_of(model.cells.begin(), model.cells.end(),
                                            [](const VVolume& cell) { return cell.is_rational(); });
    if (j.verdict() == Verdict::kValid && is_polynomial &&
        j.facts().vmodel->volume != volume_of(model.cells))
      wrong("wrong volume", model.cells);
    if (family_.make == non_manifold && j.verdict() == Verdict::kInvalid &&
        !names_bad_place(model, j.certified.findings.front()))
      wrong("another place than the constructed ones", model.cells);
  }

  // Whether all parts of the finding lie on such edges or corners: on edges if a curve is named, on corners if a point.
  static bool names_bad_place(const Model& model, const Finding& finding) {
    if (finding.place.parts.empty()) return false;
    const bool is_curve = finding.code == "curve-nonmanifold" || finding.code == "side-overused",
               is_point = finding.code == "point-nonmanifold";
    for (const EntityPart& part : finding.place.parts) {
      if (part.parameters.size() != 3) return false;
      const auto is_on = [&](const auto& places, bool are_edges) {
        return std::any_of(places.begin(), places.end(), [&](const auto& at) {
          return at.first == part.entity &&
                 lies_on(model.cells[at.first], part, at.second, are_edges);
        });
      };
      if (!(!is_point && is_on(model.bad_edges, true)) &&
          !(!is_curve && is_on(model.bad_corners, false)))
        return false;
    }
    return true;
  }
  // Whether the part lies on the edge or corner.
  static bool lies_on(const VVolume& cell, const EntityPart& part, std::size_t number,
                      bool is_edge) {
    const auto others = v_face_axes(number / 4);
    for (std::size_t a = 0; a < 3; ++a) {
      if (is_edge && a == number / 4) continue;
      const bool is_end =
          is_edge ? (number >> (a == others[0] ? 0 : 1) & 1) != 0 : (number >> a & 1) != 0;
      const double end =
          nearest_double(is_end ? cell.axis(a).domain_end() : cell.axis(a).domain_begin());
      if (part.parameters[a][0] != end || part.parameters[a][1] != end) return false;
    }
    return true;
  }

  void judge_change(const Model& model, const Judged& before, Change change, Random& random) {
    const Changed other = changed(model.cells, change, random);
    const std::string name = kChangeNames[static_cast<std::size_t>(change)];
    const Judged j = timed(
        other.cells, other.has_left_handed ? PatchOrientation::kAuto : PatchOrientation::kKeep);
    ++row_.changes;
    const Verdict a = before.verdict(), b = j.verdict();
    if ((b == Verdict::kValid && !family_.may_be_valid) ||
        (b == Verdict::kInvalid && !family_.may_be_invalid))
      return wrong(name + ": " + (b == Verdict::kValid ? "VALID" : "INVALID " + j.code),
                   other.cells);
    if (a != Verdict::kUndecided && b == Verdict::kUndecided) {
      ++row_.lost;
      tell(name + ": was decided, is undecided", other.cells, j.certified.findings.front().message);
    }
    if (a == Verdict::kUndecided && b != Verdict::kUndecided) ++row_.gained;
    if (b != Verdict::kValid) return;
    if (const auto why =
            wrong_numbers(j, *model.solid, model.cells.size(), change != Change::kSplit);
        !why.empty())
      return wrong(name + ": " + why, other.cells);
    if (a == Verdict::kValid && before.facts().vmodel->volume &&
        j.facts().vmodel->volume != *before.facts().vmodel->volume * other.factor)
      wrong(name + ": another volume", other.cells);
  }

  void check_in_python(const Judged& j, const std::vector<VVolume>& cells) {
    ++row_.python;
    const std::filesystem::path folder = settings_.dump;
    const std::string name = "soak_v_models_" + std::to_string(::getpid());
    const std::string model = (folder / (name + ".vjson")).string(),
                      certificate = (folder / (name + ".cert")).string();
    const Certified& c = j.certified;
    std::ofstream(model, std::ios::binary) << (c.copy ? c.copy->bytes : j.file);
    std::ofstream(certificate, std::ios::binary)
        << std::string(c.certificate.begin(), c.certificate.end());
    const std::string command =
        "python3 -B '" + settings_.python + "' '" + model + "' '" + certificate + "' > /dev/null";
    if (std::system(command.c_str()) != 0) wrong("the Python checker rejects", cells);
    std::filesystem::remove(model);
    std::filesystem::remove(certificate);
  }

  std::string dumped(const std::vector<VVolume>& cells) {
    const std::string path = (std::filesystem::path(settings_.dump) /
                              (std::string(family_.name) + "_" + std::to_string(seed_) + "_" +
                               std::to_string(++dumps_) + ".vjson"))
                                 .string();
    std::ofstream(path, std::ios::binary) << file_of(cells);
    return path;
  }
  void tell(const std::string& what, const std::vector<VVolume>& cells, const std::string& why) {
    std::fprintf(stderr, "%s: %s, seed %llu: %s: %s (%s)\n", what.c_str(), family_.name,
                 static_cast<unsigned long long>(seed_), what_.c_str(), why.c_str(),
                 dumped(cells).c_str());
  }
  void wrong(const std::string& what, const std::vector<VVolume>& cells) {
    ++row_.wrong;
    tell("WRONG", cells, what);
  }

  const Family& family_;
  const Settings& settings_;
  Row row_;
  std::uint64_t seed_ = 0;
  std::string what_;
  std::size_t certificates_ = 0, dumps_ = 0;
};

// Returns whether the row keeps its goal.
bool print(const Family& family, const Row& r) {
  const bool has_few_undecided =
      static_cast<double>(r.undecided) <= family.most_undecided * static_cast<double>(r.models);
  const bool wants_code = *family.wanted != '\0';
  std::string codes;
  for (const auto& [code, count] : r.codes)
    codes += (codes.empty() ? "\"" : ",\"") + code + "\":" + std::to_string(count);
  std::printf(
      "{\"name\":\"v_models_%s\",\"value\":%zu,\"goal\":\"0 wrong%s\",\"models\":%zu,\"valid\":%zu,"
      "\"invalid\":%zu,\"undecided\":%zu,\"to_become_invalid\":%zu,\"other_code\":%zu,"
      "\"changes\":%zu,\"lost_by_changes\":%zu,\"gained_by_changes\":%zu,\"python\":%zu,"
      "\"codes\":{%s},\"seconds\":%.1f,\"slowest\":%.2f}\n",
      family.name, r.wrong, family.most_undecided < 1 ? ", 2 % undecided" : "", r.models, r.valid,
      r.invalid, r.undecided, wants_code ? r.undecided : 0, wants_code ? r.unwanted : 0, r.changes,
      r.lost, r.gained, r.python, codes.c_str(), r.seconds, r.slowest);
  std::fflush(stdout);
  return r.wrong == 0 && has_few_undecided;
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t models = 1500, non_manifolds = 1000, changes = 5, every = 50;
  std::string only;
  Settings settings;
  bench::read_arguments(argc, argv,
                        {{"--models", &models},
                         {"--non-manifold", &non_manifolds},
                         {"--seed", &settings.seed},
                         {"--family", &only},
                         {"--changes", &changes},
                         {"--python", &settings.python},
                         {"--python-every", &every},
                         {"--dump", &settings.dump},
                         {"--only-write", &settings.only_write}});
  settings.changes = changes;
  settings.python_every = std::max<std::uint64_t>(every, 1);
  bool is_known = only.empty(), is_good = true;
  for (const Family& family : kFamilies) {
    if (!only.empty() && only != family.name && only != family.group) continue;
    is_known = true;
    const std::uint64_t of_group = family.make == non_manifold ? non_manifolds : models;
    const std::uint64_t count =
        only == family.name ? of_group : of_group * static_cast<std::uint64_t>(family.share) / 100;
    is_good = print(family, Run(family, settings).run(settings.seed, count)) && is_good;
  }
  if (!is_known) {
    std::fprintf(stderr, "no such family: %s; the groups are", only.c_str());
    for (const char* group : kGroups) std::fprintf(stderr, " %s", group);
    std::fprintf(stderr, "\n");
    return 2;
  }
  return is_good ? 0 : 1;
}
