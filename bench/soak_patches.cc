// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_patches.cc: --count N --unknown M --seed S [--only embedded|opposed|crossing|touching|unknown]. Random
// patch models of known truth (tests/support/random_solids.h), N of each kind (M with opposed faces), and M of unknown
// truth, compared with the mesh certifier's verdicts on tessellations of three densities. One JSON line a figure; wrong
// and undecided models in full on standard error.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "io/splines/patch_model.h"
#include "solids/polyhedron/validity.h"
#include "splines/de_casteljau.h"
#include "tests/support/random_solids.h"
#include "verify/certify/file_patches.h"

namespace {

using namespace veritope;
using random_solids::Model;
using random_solids::Patches;

struct Judged {
  Verdict verdict = Verdict::kUndecided;
  std::string why;
  PatchDecision decision;
  double seconds = 0;
};

Judged judge(const Patches& patches) {
  FilePatches model = file_patches(model_of(patches), PatchOrientation::kKeep).value();
  FileDecisionOptions options;
  options.search.tolerance = 1e-2;
  const auto start = std::chrono::steady_clock::now();
  Judged out;
  out.decision = decide_file_patches(model, options).decision;
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  out.verdict = out.decision.verdict();
  if (out.decision.open) out.why = out.decision.open->message;
  return out;
}

struct Tally {
  std::size_t models = 0, valid = 0, invalid = 0, undecided = 0, wrong = 0;
  double seconds = 0, slowest = 0;

  void add(const Judged& j) {
    ++models;
    seconds += j.seconds;
    slowest = std::max(slowest, j.seconds);
    ++(j.verdict == Verdict::kValid ? valid : j.verdict == Verdict::kInvalid ? invalid : undecided);
  }
};

void tell(const char* what, const char* kind, std::uint64_t seed, const Model& model,
          const std::string& why) {
  std::fprintf(stderr, "%s: %s %llu: %s: %s\n", what, kind, static_cast<unsigned long long>(seed),
               model.description.c_str(), why.c_str());
}

void print(const char* name, const Tally& t, const char* goal) {
  std::printf(
      "{\"name\":\"%s\",\"value\":%zu,\"goal\":\"%s\",\"models\":%zu,\"valid\":%zu,\"invalid\":%zu,"
      "\"undecided\":%zu,\"seconds\":%.1f,\"slowest\":%.2f}\n",
      name, t.wrong, goal, t.models, t.valid, t.invalid, t.undecided, t.seconds, t.slowest);
  std::fflush(stdout);
}

bool has_known_numbers(const PatchDecision& decision, const Model& model) {
  std::vector<std::int64_t> genus;
  for (const PatchShellFacts& s : decision.shells) genus.push_back(s.genus);
  std::sort(genus.begin(), genus.end());
  return genus == model.genus && decision.bodies == model.bodies;
}

using Make = Model (*)(Random&);

/// Wrong answers are VALID unless `is_embedded`, and if it is, INVALID or another genus or number
/// of bodies.
Tally run(const char* kind, Make make, bool is_embedded, std::size_t count, std::uint64_t seed,
          bool tells_undecided) {
  Tally t;
  for (std::uint64_t i = seed; i < seed + count; ++i) {
    Random random(i);
    const Model model = make(random);
    const Judged j = judge(model.patches);
    t.add(j);
    if (j.verdict == Verdict::kUndecided) {
      if (tells_undecided) tell("undecided", kind, i, model, j.why);
      continue;
    }
    const bool is_right = is_embedded
                              ? j.verdict == Verdict::kValid && has_known_numbers(j.decision, model)
                              : j.verdict == Verdict::kInvalid;
    if (is_right) continue;
    ++t.wrong;
    tell("WRONG", kind, i, model, j.verdict == Verdict::kValid ? "valid" : "invalid");
  }
  return t;
}

// Each patch as a grid of m x m quadrangles, or m x m triangles; vertices whose exact points round to the same doubles
// are one vertex.
TriangleMesh tessellated(const Patches& patches, int m) {
  TriangleMesh mesh;
  std::map<std::array<double, 3>, std::uint32_t> known;
  const auto vertex = [&](const Patch& patch, int i, int j) {
    const Rational u = Rational(i) / Rational(m), v = Rational(j) / Rational(m);
    const auto value = patch.is_triangle()
                           ? evaluate<Rational>(patch.triangle(), {Rational(1) - u - v, u, v})
                           : evaluate<Rational, 2>(patch.tensor(), {u, v});
    std::array<double, 3> p = approx_point(value);
    const auto [found, is_new] =
        known.try_emplace(p, static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) mesh.positions.push_back({p[0] + 0.0, p[1] + 0.0, p[2] + 0.0});
    return found->second;
  };
  const auto columns = static_cast<std::size_t>(m) + 1;
  std::vector<std::uint32_t> grid(columns * columns);
  for (const Patch& patch : patches) {
    const auto at = [&](int i, int j) -> std::uint32_t& {
      return grid[static_cast<std::size_t>(i) * columns + static_cast<std::size_t>(j)];
    };
    for (int i = 0; i <= m; ++i)
      for (int j = 0; j <= (patch.is_triangle() ? m - i : m); ++j) at(i, j) = vertex(patch, i, j);
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < (patch.is_triangle() ? m - i : m); ++j) {
        mesh.faces.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (patch.is_triangle() && i + j + 1 >= m) continue;
        mesh.faces.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  return mesh;
}

/// If a crossing was proved: whether fine tessellations of its two patches cross or touch.
bool crosses_in_fine_tessellation(const Model& model, const PatchDecision& decision) {
  constexpr int kFine = 256;
  if (!decision.refutation) return false;
  const auto* const crossing = std::get_if<CrossingWitness>(&*decision.refutation);
  if (crossing == nullptr) return false;
  Patches two;
  for (const PatchRectangle& sheet : crossing->sheets) two.push_back(model.patches[sheet.patch]);
  if (crossing->sheets[0].patch == crossing->sheets[1].patch) two.pop_back();
  return decide_validity(tessellated(two, kFine), {}).rule_counts[rule_index(MeshRule::kM7)] > 0;
}

/// Wrong answers: the patches are VALID although the finest tessellation does not bound a solid; or they are INVALID
/// although it does, and much finer tessellations show no crossing either. A person must then look at the model,
/// because a tessellation is another surface.
Tally run_unknown(std::size_t count, std::uint64_t seed) {
  static constexpr int kDensities[] = {4, 8, 16};
  Tally t;
  std::array<std::size_t, 3> agree{};
  std::size_t small = 0;
  for (std::uint64_t i = seed; i < seed + count; ++i) {
    Random random(i);
    const Model model = random_solids::unknown(random);
    const Judged j = judge(model.patches);
    t.add(j);
    if (j.verdict == Verdict::kUndecided) {
      tell("undecided", "unknown", i, model, j.why);
      continue;
    }
    bool agrees = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const ValidityReport report = decide_validity(tessellated(model.patches, kDensities[k]), {});
      agrees = report.is_valid == (j.verdict == Verdict::kValid);
      agree[k] += agrees ? 1 : 0;
    }
    if (!agrees && crosses_in_fine_tessellation(model, j.decision)) ++small, agrees = true;
    if (agrees) continue;
    ++t.wrong;
    tell("DISAGREES", "unknown", i, model, j.verdict == Verdict::kValid ? "valid" : "invalid");
  }
  for (std::size_t k = 0; k < 3; ++k)
    std::printf("{\"name\":\"patches_unknown_density_%d\",\"value\":%zu,\"goal\":\"as decided\"}\n",
                kDensities[k], agree[k]);
  std::printf("{\"name\":\"patches_unknown_small_crossings\",\"value\":%zu,\"goal\":\"-\"}\n",
              small);
  return t;
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t count = 1500, unknown = 500;
  std::uint64_t seed = 1;
  std::string only;
  bench::read_arguments(argc, argv, {{"--count", &count},
                                     {"--unknown", &unknown},
                                     {"--seed", &seed},
                                     {"--only", &only}});
  const auto wanted = [&](const char* kind) { return only.empty() || only == kind; };
  std::size_t wrong = 0;
  const auto one = [&](const char* kind, Make make, std::size_t how_many, bool is_embedded,
                       bool tells, const char* goal) {
    if (!wanted(kind)) return;
    const Tally t = run(kind, make, is_embedded, how_many, seed, tells);
    print((std::string("patches_") + kind).c_str(), t, goal);
    wrong += t.wrong;
  };
  one("embedded", random_solids::embedded, count, true, true, "0 wrong, 2 % undecided");
  one("opposed", random_solids::opposed, unknown, true, false,
      "0 wrong; undecided where normals lie in no half-space");
  one("crossing", random_solids::crossing, count, false, true, "0 wrong, 2 % undecided");
  one("touching", random_solids::touching, count, false, false, "0 wrong");
  if (wanted("unknown")) {
    const Tally t = run_unknown(unknown, seed);
    print("patches_unknown", t, "0 disagreements with the finest tessellation");
  }
  return wrong == 0 ? 0 : 1;
}
