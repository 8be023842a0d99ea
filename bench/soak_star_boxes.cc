// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_star_boxes.cc: --rounds N --seed S. Models of known truth, and other descriptions of them, against the search for star boxes: sound ones must be
// valid with their genus and bodies, broken ones never. One JSON line a figure; what is wrong or undecided in full on standard error.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "robust/base/random.h"
#include "solids/patch_shapes.h"
#include "solids/patch_transform.h"
#include "verify/certify/patch_decision.h"

namespace {

using namespace veritope;
using patch_shapes::Shape;
using patch_shapes::Truth;
using Patches = std::vector<Patch>;

struct Tally {
  std::size_t models = 0, valid = 0, undecided = 0, wrong = 0, boxes = 0;
  double seconds = 0;
};

// Entries with few bits, a determinant of either sign that is not 0.
AffineMap random_map(Random& random) {
  for (;;) {
    AffineMap map{3, 3, {}, {}};
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        map.linear.push_back(Rational(random.between(-4, 4) + (row == column ? 5 : 0)) /
                             Rational(4));
      map.translation.push_back(Rational(random.between(-1000, 1000)) / Rational(7));
    }
    const auto& m = map.linear;
    Rational determinant(0);
    for (std::size_t k = 0; k < 3; ++k)
      determinant = determinant + m[k] * (m[3 + (k + 1) % 3] * m[6 + (k + 2) % 3] -
                                          m[3 + (k + 2) % 3] * m[6 + (k + 1) % 3]);
    if (abs(determinant) > Rational(1) / Rational(4)) return map;
  }
}

struct Description {
  const char* name;
  std::function<Patches(const Patches&, Random&)> of;
};
const std::vector<Description>& descriptions() {
  static const std::vector<Description> all = {
      {"as built", [](const Patches& p, Random&) { return p; }},
      {"affine image",
       [](const Patches& p, Random& r) { return affine_image(p, random_map(r)).value(); }},
      {"relabelled", [](const Patches& p, Random& r) { return relabelled(p, r); }},
      {"subdivided", [](const Patches& p, Random&) { return subdivided(p); }},
      {"cut along belts", [](const Patches& p, Random& r) { return cut_along_belts(p, r); }},
      {"elevated", [](const Patches& p, Random&) { return elevated(p, 1); }},
  };
  return all;
}

bool has_known_numbers(const PatchDecision& decision, const Shape& shape) {
  if (decision.bodies != static_cast<std::uint64_t>(shape.bodies)) return false;
  std::vector<std::int64_t> found;
  for (const PatchShellFacts& s : decision.shells) found.push_back(s.genus);
  std::vector<std::int64_t> expected(shape.genus.begin(), shape.genus.end());
  std::sort(found.begin(), found.end());  // relabelling renumbers shells
  std::sort(expected.begin(), expected.end());
  return found == expected;
}

void judge(const Shape& shape, const char* description, const Patches& patches, int max_level,
           Tally* tally) {
  PatchInput input;
  input.patches = patches;
  const PatchComplex complex = make_patch_complex(std::move(input)).value();
  PatchDecisionOptions options;
  options.cover.max_level = max_level;
  options.tolerance = 1e-2;
  std::optional<PieceForest> forest;
  const auto start = std::chrono::steady_clock::now();
  const PatchDecision decision = decide_patches(complex, options, &forest);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  tally->seconds += seconds;
  if (seconds > 10)
    std::fprintf(stderr, "%s, %s: %.0f s\n", shape.name.c_str(), description, seconds);
  ++tally->models;
  const bool is_sound = shape.truth == Truth::kEmbedded;
  if (!decision.is_valid) {
    ++tally->undecided;
    if (is_sound)
      std::fprintf(stderr, "%s, %s: %s\n", shape.name.c_str(), description,
                   decision.open->message.c_str());
    return;
  }
  ++tally->valid;
  tally->boxes += decision.cover.boxes.size();
  if (is_sound && has_known_numbers(decision, shape)) return;
  ++tally->wrong;
  std::fprintf(stderr, "WRONG: %s, %s\n", shape.name.c_str(), description);
}

void print(const char* name, const Tally& t, const char* goal) {
  std::printf(
      "{\"name\":\"%s\",\"value\":%zu,\"goal\":\"%s\",\"models\":%zu,\"valid\":%zu,\"undecided\":%"
      "zu,\"boxes\":%zu,\"seconds\":%.1f}\n",
      name, t.wrong, goal, t.models, t.valid, t.undecided, t.boxes, t.seconds);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  int rounds = 2;
  std::uint64_t seed = 1;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--rounds") == 0) rounds = std::atoi(argv[i + 1]);
    if (std::strcmp(argv[i], "--seed") == 0) seed = std::strtoull(argv[i + 1], nullptr, 10);
  }
  Tally sound, broken;
  for (int round = 0; round < rounds; ++round)
    for (const Description& d : descriptions()) {
      if (round > 0 && &d == &descriptions().front()) continue;
      Random random(seed + static_cast<std::uint64_t>(round));
      for (const Shape& shape : patch_shapes::sound_shapes())
        judge(shape, d.name, d.of(shape.patches, random), 14, &sound);
      // Tangential contacts are approached for ever: to pieces of 2^-6 here.
      for (const Shape& shape : patch_shapes::broken_shapes())
        judge(shape, d.name, d.of(shape.patches, random), 6, &broken);
    }
  print("star_boxes_sound", sound, "0 wrong, 0 undecided");
  print("star_boxes_broken", broken, "0 valid");
  return sound.wrong + broken.wrong + sound.undecided == 0 ? 0 : 1;
}
