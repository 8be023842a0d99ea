// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_thin.cc: --count N --models N --maps N --seed S [--only embedded|crossing|touching|assemblies|maps]
// [--seconds S] [--program VERITOPE]. Tests the search for boxes in frames and with several sheets on thin walls of
// known truth, each under a random affine map: two to five sheets, flat, quadric, of different curvature near one
// point, and free-form, at gaps down to 2^-40 of the size for planes and spheres (2^-13 for free-form ones). Those that
// are apart must be valid with their genus and bodies, those that cross invalid, those that touch never valid.
// Assemblies are two to four of those that are apart, in a row; half of the rows are not mapped. Then N models under N
// maps each, rotations and shears up to 2^10: their verdicts must agree. A model is undecided after S (60) seconds of
// processor time. One JSON line a figure; wrong and undecided models on standard error, each with the seed that makes
// it alone (--count 1). With a program, that program must certify each sound model that is found valid, too: then the
// checker has accepted it.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "io/splines/patch_model.h"
#include "io/splines/write_splines.h"
#include "models/patch_shapes.h"
#include "models/thin_shapes.h"
#include "robust/base/random.h"
#include "solids/patches/patch_transform.h"
#include "verify/certify/patch_decision.h"

namespace {

using namespace veritope;
using patch_shapes::Patches;
using thin_shapes::Family;
using thin_shapes::Walls;

double most_seconds = 60;  // for one model

// Processor time, so that another process makes no model undecided.
double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// A rotation by a random quaternion of small integers: its entries are rational.
AffineMap rotation(Random& random) {
  for (;;) {
    std::int64_t q[4], norm = 0;
    for (std::int64_t& v : q) v = random.between(-5, 5), norm += v * v;
    if (norm == 0) continue;
    const auto [w, x, y, z] = q;
    const std::int64_t m[9] = {w * w + x * x - y * y - z * z, 2 * (x * y - w * z),
                               2 * (x * z + w * y),           2 * (x * y + w * z),
                               w * w - x * x + y * y - z * z, 2 * (y * z - w * x),
                               2 * (x * z - w * y),           2 * (y * z + w * x),
                               w * w - x * x - y * y + z * z};
    AffineMap out{3, 3, {}, {}};
    for (const std::int64_t v : m) out.linear.push_back(Rational(v) / Rational(norm));
    for (int k = 0; k < 3; ++k)
      out.translation.push_back(Rational(random.between(-99, 99)) / Rational(8));
    return out;
  }
}
// Adds up to 2^most_bits times a coordinate to another one.
AffineMap shear(Random& random, int most_bits) {
  AffineMap out{3, 3, std::vector<Rational>(9), std::vector<Rational>(3)};
  for (std::size_t k = 0; k < 3; ++k) out.linear[4 * k] = Rational(1);
  const std::size_t to = random.below(3), from = (to + 1 + random.below(2)) % 3;
  const auto size = std::int64_t{1} << random.below(static_cast<std::uint64_t>(most_bits) + 1);
  out.linear[3 * to + from] = Rational(random.below(2) == 0 ? size : -size);
  return out;
}
Patches moved(const Patches& patches, Random& random, int shear_bits) {
  Patches out = affine_image(patches, rotation(random)).value();
  if (random.below(2) == 0) out = affine_image(out, shear(random, shear_bits)).value();
  return out;
}

struct Answer {
  Verdict verdict;
  std::vector<std::int64_t> genus;
  std::uint64_t bodies = 0;
  std::string why;
  double seconds = 0;
};
Answer answer(const Patches& patches) {
  PatchInput input;
  input.patches = patches;
  const PatchComplex complex = make_patch_complex(std::move(input)).value();
  PatchDecisionOptions options;
  options.with_frames = true;
  options.tolerance = 1e-2;
  const double start = seconds();
  options.cover.stops_at = [&](PieceForest::Id, std::size_t) {
    return seconds() - start > most_seconds;
  };
  std::optional<PieceForest> forest;
  const PatchDecision d = decide_patches(complex, options, &forest);
  Answer out{d.verdict(), {}, d.bodies, d.open ? d.open->message : "", seconds() - start};
  for (const PatchShellFacts& s : d.shells) out.genus.push_back(s.genus);
  return out;
}

struct Tally {
  std::size_t models = 0, valid = 0, invalid = 0, undecided = 0, wrong = 0;
  double seconds = 0, slowest = 0;
};
void print(const char* name, const Tally& t, const char* goal) {
  std::printf(
      "{\"name\":\"thin_%s\",\"value\":%zu,\"goal\":\"%s\",\"models\":%zu,\"valid\":%zu,"
      "\"invalid\":%zu,"
      "\"undecided\":%zu,\"seconds\":%.1f,\"slowest\":%.1f}\n",
      name, t.wrong, goal, t.models, t.valid, t.invalid, t.undecided, t.seconds, t.slowest);
  std::fflush(stdout);
}

// Free-form walls need pieces as long as a root of the gap; those of planes and quadrics do not.
int most_bits_of(const std::string& family) {
  if (family == "tori" || family == "curved-plate" || family == "tube" || family == "cone")
    return 13;
  return family == "nested" || family == "eccentric" ? 20 : 40;
}

// A model, and its genus and bodies if it is sound.
struct Subject {
  std::string name;
  Patches patches;
  std::vector<int> genus;
  int bodies = 0;
};
bool has_known_numbers(const Answer& a, const Subject& subject) {
  return a.verdict == Verdict::kValid && a.bodies == static_cast<std::uint64_t>(subject.bodies) &&
         std::equal(a.genus.begin(), a.genus.end(), subject.genus.begin(), subject.genus.end());
}

Subject random_walls(const Family& family, Walls walls, int most_bits, Random& random) {
  const int bits = 3 + static_cast<int>(random.below(static_cast<std::uint64_t>(most_bits - 2)));
  const Rational gap = Rational(random.between(5, 8)) / Rational(8) * Rational::power_of_two(-bits);
  return {family.name + ", gap near 2^-" + std::to_string(bits), family.make(gap, walls),
          family.genus, family.bodies};
}
// Two to four solids in a row: each lies in a ball of radius 5 around the origin before it is moved there.
constexpr int kMostBitsInRow = 10, kDistanceInRow = 11;
Subject random_assembly(const std::vector<Family>& families, Random& random) {
  Subject out;
  std::array<Rational, 3> direction{};
  direction[random.below(3)] = Rational(kDistanceInRow);
  direction[random.below(3)] = Rational(kDistanceInRow);
  const auto num_parts = 2 + static_cast<int>(random.below(3));
  for (int part = 0; part < num_parts; ++part) {
    const Family& family = families[random.below(families.size())];
    const Subject next = random_walls(family, Walls::kApart, kMostBitsInRow, random);
    AffineMap map = rotation(random);
    if (random.below(2) == 0) map.linear = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    for (std::size_t k = 0; k < 3; ++k) map.translation[k] = Rational(part) * direction[k];
    const Patches placed = affine_image(next.patches, map).value();
    out.patches = part == 0 ? placed : patch_shapes::joined({out.patches, placed});
    out.name += (part == 0 ? "" : "; ") + next.name;
    out.genus.insert(out.genus.end(), next.genus.begin(), next.genus.end());
    out.bodies += next.bodies;
  }
  return out;
}

enum class Kind { kEmbedded, kCrossing, kTouching, kAssembly };
Subject random_subject(Kind kind, std::uint64_t index, Random& random) {
  static const std::vector<Family> families = thin_shapes::families();
  Subject out;
  if (kind == Kind::kAssembly) {
    out = random_assembly(families, random);
    if (random.below(2) == 0) return out;
  } else {
    const Family& family = families[index % families.size()];
    const Walls walls = kind == Kind::kEmbedded   ? Walls::kApart
                        : kind == Kind::kCrossing ? Walls::kCrossing
                                                  : Walls::kTouching;
    out = random_walls(family, walls, most_bits_of(family.name), random);
  }
  out.patches = moved(out.patches, random, 2);
  return out;
}

// Whether `veritope certify` says VALID, which it does after the checker has accepted.
bool is_certified(const std::string& program, const Patches& patches, std::uint64_t seed) {
  namespace fs = std::filesystem;
  const fs::path file =
      fs::temp_directory_path() / ("soak_thin_" + std::to_string(seed) + ".vjson");
  std::ofstream(file) << spline_json_bytes(model_of(patches));
  const int exit =
      std::system((program + " certify " + file.string() + " > " + file.string() + ".txt").c_str());
  if (exit == 0) {
    fs::remove(file);
    fs::remove(file.string() + ".txt");
  }
  return exit == 0;
}

Tally run(Kind kind, std::size_t count, std::uint64_t seed, const std::string& program) {
  Tally tally;
  for (std::size_t i = 0; i < count; ++i) {
    Random random(seed + i);
    const Subject subject = random_subject(kind, seed + i, random);
    const Answer a = answer(subject.patches);
    ++tally.models;
    tally.seconds += a.seconds, tally.slowest = std::max(tally.slowest, a.seconds);
    ++(a.verdict == Verdict::kValid     ? tally.valid
       : a.verdict == Verdict::kInvalid ? tally.invalid
                                        : tally.undecided);
    const bool is_sound = kind == Kind::kEmbedded || kind == Kind::kAssembly;
    const bool is_right =
        a.verdict == Verdict::kUndecided ||
        (!is_sound ? a.verdict == Verdict::kInvalid
                   : has_known_numbers(a, subject) &&
                         (program.empty() || is_certified(program, subject.patches, seed + i)));
    if (!is_right) ++tally.wrong;
    if (!is_right || a.verdict == Verdict::kUndecided)
      std::fprintf(stderr, "%s %s, seed %llu: %s, %.1f s: %s\n", is_right ? "undecided" : "WRONG",
                   subject.name.c_str(), static_cast<unsigned long long>(seed + i),
                   verdict_name(a.verdict), a.seconds, a.why.c_str());
  }
  return tally;
}

// Returns, and prints as the value, the number of images that are VALID where their model is INVALID, or the reverse.
std::size_t run_maps(std::size_t num_models, std::size_t num_maps, std::uint64_t seed) {
  std::vector<patch_shapes::Shape> shapes = patch_shapes::sound_shapes();
  for (patch_shapes::Shape& s : patch_shapes::broken_shapes())
    if (s.truth == patch_shapes::Truth::kCrossing) shapes.push_back(std::move(s));
  const std::vector<Family> families = thin_shapes::families();
  std::size_t contradictions = 0, same = 0, images = 0;
  const double start = seconds();
  for (std::size_t i = 0; i < num_models; ++i) {
    Random random(seed + i);
    std::string name;
    Patches base;
    if (i % 2 == 0) {
      const patch_shapes::Shape& shape = shapes[i / 2 % shapes.size()];
      name = shape.name, base = shape.patches;
    } else {
      const Family& family = families[i / 2 % families.size()];
      name = family.name;
      base = family.make(Rational(random.between(3, 31)) / Rational(128),  // five shells have room
                         random.below(2) == 0 ? Walls::kApart : Walls::kCrossing);
    }
    const Verdict expected = answer(base).verdict;
    for (std::size_t k = 0; k < num_maps; ++k, ++images) {
      const Answer a = answer(moved(base, random, 10));
      same += a.verdict == expected ? 1 : 0;
      if (a.verdict == expected) continue;
      if (a.verdict != Verdict::kUndecided && expected != Verdict::kUndecided) ++contradictions;
      std::fprintf(stderr, "%s, seed %llu, map %zu: %s, not %s, %.1f s: %s\n", name.c_str(),
                   static_cast<unsigned long long>(seed + i), k, verdict_name(a.verdict),
                   verdict_name(expected), a.seconds, a.why.c_str());
    }
    if ((i + 1) % 10 == 0)
      std::fprintf(stderr, "%zu of %zu models: %zu of %zu images have the same verdict, %.0f s\n",
                   i + 1, num_models, same, images, seconds() - start);
  }
  std::printf(
      "{\"name\":\"thin_maps\",\"value\":%zu,\"goal\":\"0 of them VALID against INVALID, 99 %% the "
      "same\","
      "\"models\":%zu,\"images\":%zu,\"same\":%zu,\"seconds\":%.1f}\n",
      contradictions, num_models, images, same, seconds() - start);
  return contradictions;
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t count = 2000, models = 500, maps = 20;
  std::uint64_t seed = 1;
  std::string only, program;
  bench::read_arguments(argc, argv,
                        {{"--count", &count},
                         {"--models", &models},
                         {"--maps", &maps},
                         {"--seed", &seed},
                         {"--seconds", &most_seconds},
                         {"--only", &only},
                         {"--program", &program}});
  const auto is_wanted = [&](const char* kind) { return only.empty() || only == kind; };
  std::size_t wrong = 0;
  const auto one = [&](const char* name, Kind kind, const char* goal) {
    if (!is_wanted(name)) return;
    const Tally t = run(kind, count, seed, program);
    print(name, t, goal);
    wrong += t.wrong;
  };
  one("embedded", Kind::kEmbedded, "0 wrong, 1 % undecided");
  one("crossing", Kind::kCrossing, "0 wrong, 1 % undecided");
  one("touching", Kind::kTouching, "0 wrong");
  one("assemblies", Kind::kAssembly, "0 wrong, 1 % undecided");
  if (is_wanted("maps")) wrong += run_maps(models, maps, seed);
  return wrong == 0 ? 0 : 1;
}
