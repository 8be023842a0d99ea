// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_curved_booleans.cc: --worlds N --points M --seed S : random expressions of parts of balls, cylinders,
// bores and blocks that cross and abut, each cut into patches in one of several ways and mapped by a random affine map;
// points on their walls: where surfaces meet transversally, abut, and at poles. Truth by construction: a point lies on
// up to three surfaces with independent normals, so that all sides of them occur near it, and a solid is known by them.
// Where normals are dependent (contact) a word may be left open, and is compared with points nearby. --first F starts
// with world F. One JSON line a figure.
#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/random_expressions.h"
#include "bench/stopwatch.h"
#include "models/patch_shapes.h"
#include "models/round_parts.h"
#include "robust/base/random.h"
#include "solids/expression/expression_classifier.h"
#include "solids/patches/patch_transform.h"

namespace veritope::bench {
namespace {

using Signs = std::array<int, 3>;

// ---- surfaces, each the zeros of a polynomial: a point's side is its sign

enum Surface {
  kSphere,
  kCylinder,
  kBore,
  kPlaneX,
  kPlaneY,
  kPlaneZ,
  kBottom,
  kTop,
  kHigh,
  kThird,
  kNumSurfaces
};
using Sides = std::array<int, kNumSurfaces>;

std::array<Rational, kNumSurfaces> values_at(const ExactPoint& p) {
  const Rational round = p[0] * p[0] + p[1] * p[1], one(1);
  return {round + p[2] * p[2] - one,
          round - one,
          round - ratio(9, 25),
          p[0],
          p[1],
          p[2],
          p[2] + one,
          p[2] - one,
          p[2] - Rational(2),
          p[2] - ratio(1, 3)};
}
ExactPoint gradient_at(int surface, const ExactPoint& p) {
  switch (surface) {
    case kSphere: return p;
    case kCylinder:
    case kBore: return {p[0], p[1], 0};
    case kPlaneX: return {1, 0, 0};
    case kPlaneY: return {0, 1, 0};
    default: return {0, 0, 1};
  }
}
ExactPoint cross_product(const ExactPoint& a, const ExactPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// ---- solids

// The level z = 1/3, where the sphere has points at irrational parameters of its octants.
constexpr int kThirdLevel = 5;
Rational height_of(int level) { return level == kThirdLevel ? ratio(1, 3) : Rational(level); }

// Between two levels of z, on one side of a round surface, or of none, with x, y and z of given signs (0: any).
struct Solid {
  std::optional<Surface> round;
  Signs signs{};
  int bottom = -3, top = 3;  // levels; -1, 0, 1, 2 and kThirdLevel are surfaces
  Patches patches;

  bool holds(const Sides& s) const {
    if (round && s[*round] > 0) return false;
    for (std::size_t k = 0; k < 3; ++k)
      if (signs[k] * s[kPlaneX + k] < 0) return false;
    const auto side_of_level = [&](int level) {
      switch (level) {
        case -1: return s[kBottom];
        case 0: return s[kPlaneZ];
        case 1: return s[kTop];
        case 2: return s[kHigh];
        case kThirdLevel: return s[kThird];
        default: return level < 0 ? 1 : -1;
      }
    };
    return side_of_level(bottom) > 0 && side_of_level(top) < 0;
  }
  bool has(int surface) const {
    if (round && surface == *round) return true;
    if (surface >= kPlaneX && surface <= kPlaneZ &&
        signs[static_cast<std::size_t>(surface - kPlaneX)] != 0)
      return true;
    constexpr int kLevelOf[] = {0, -1, 1, 2, kThirdLevel};
    if (surface < kPlaneZ) return false;
    const int level = kLevelOf[surface - kPlaneZ];
    return bottom == level || top == level;
  }
};

Signs random_signs(Random& random, int axes) {
  Signs out{};
  for (int k = 0; k < axes; ++k)
    out[static_cast<std::size_t>(k)] = static_cast<int>(random.below(3)) - 1;
  return out;
}

Solid random_solid(Random& random) {
  constexpr int kLevels[][2] = {{-1, 0}, {0, 1},  {1, 2}, {-1, 1},          {0, 2},
                                {-3, 3}, {-3, 0}, {1, 3}, {0, kThirdLevel}, {kThirdLevel, 1}};
  Solid out;
  const std::uint64_t kind = random.below(4);
  if (kind == 0) {
    out.round = kSphere;
    out.signs = random_signs(random, 3);
    const Patches ball = patch_shapes::octant_sphere();
    out.patches = patch_shapes::coned(patch_shapes::patches_with_signs(ball, out.signs), {0, 0, 0});
    return out;
  }
  const auto& levels = kLevels[random.below(std::size(kLevels))];
  out.bottom = levels[0];
  out.top = levels[1];
  out.signs = random_signs(random, 2);
  if (kind == 1) {
    const auto end = [&](std::size_t k, int level) {
      return out.signs[k] == (level < 0 ? 1 : -1) ? Rational(0) : Rational(level);
    };
    out.patches = patch_shapes::box({end(0, -3), end(1, -3), height_of(out.bottom)},
                                    {end(0, 3), end(1, 3), height_of(out.top)});
    return out;
  }
  out.round = kind == 2 ? kCylinder : kBore;
  const Rational radius = kind == 2 ? Rational(1) : ratio(3, 5),
                 height = height_of(out.top) - height_of(out.bottom);
  const Patches whole = patch_shapes::disc_cylinder(height / radius);
  out.patches =
      patch_shapes::placed(patch_shapes::coned(patch_shapes::patches_with_signs(whole, out.signs),
                                               {0, 0, height / radius / Rational(2)}),
                           radius, {0, 0, height_of(out.bottom)});
  return out;
}

// ---- points

class Places {
 public:
  explicit Places(Random& random) : random_(random) {}

  ExactPoint place() {
    const auto [c, s] = on_circle();
    switch (random_.below(11)) {
      case 0: return {0, 0, level()};
      case 1: {  // on the sphere, at rational parameters of its octants
        const auto [rho, z] = on_circle();
        return {rho * c, rho * s, z};
      }
      case 2: {
        const std::size_t k = random_.below(3);
        ExactPoint out;
        out[(k + 1) % 3] = c;
        out[(k + 2) % 3] = s;
        return out;
      }
      case 3: return {ratio(3, 5) * c, ratio(3, 5) * s, ratio(random_.below(2) != 0 ? 4 : -4, 5)};
      case 4: return {c, s, level()};
      case 5: return {ratio(3, 5) * c, ratio(3, 5) * s, level()};
      case 6: return {part(), part(), level()};
      case 8: {  // on the sphere at z = 1/3
        const Rational d = ratio(2, 3);
        return {d * (c - s), d * (c + s), ratio(1, 3)};
      }
      case 7: {  // on the sphere, mostly at irrational parameters; on levels, too
        const auto any = [&] {
          return ratio(static_cast<std::int64_t>(random_.below(13)) - 6,
                       1 + static_cast<std::int64_t>(random_.below(6)));
        };
        const Rational a = any(), b = any(), one(1), square = a * a + b * b;
        return {(a + a) / (one + square), (b + b) / (one + square),
                (one - square) / (one + square)};
      }
      default: {
        ExactPoint out{part(), part(), level()};
        out[random_.below(3)] = 0;
        return out;
      }
    }
  }

 private:
  Rational part() { return ratio(static_cast<std::int64_t>(random_.below(15)) - 7, 6); }
  Rational level() {
    return random_.below(3) == 0 ? part()
                                 : Rational(static_cast<std::int64_t>(random_.below(4)) - 1);
  }
  std::array<Rational, 2> on_circle() {
    const Rational t = ratio(static_cast<std::int64_t>(random_.below(12)),
                             1 + static_cast<std::int64_t>(random_.below(11))),
                   square = t * t, one(1), sum = one + square;
    const auto sign = [&] { return Rational(random_.below(2) != 0 ? 1 : -1); };
    return {sign() * (one - square) / sum, sign() * (t + t) / sum};
  }

  Random& random_;
};

struct World {
  explicit World(Random& random) : map(random_map(random)) {
    const std::uint64_t num = 3 + random.below(4);
    while (solids.size() < num) {
      const bool is_copy = !solids.empty() && random.below(3) == 0;
      Solid s = is_copy ? solids[random.below(solids.size())] : random_solid(random);
      s.patches = in_another_way(s.patches, random);
      const Patches mapped = affine_image(s.patches, map).value();
      auto complex = make_patch_complex(mapped).value();
      if (!complex.is_closed_oriented_surface()) {
        std::fprintf(stderr, "a solid of the soak is not closed\n");
        std::exit(2);
      }
      operands.push_back(patch_operand(std::make_unique<const PatchComplex>(std::move(complex))));
      solids.push_back(std::move(s));
    }
  }
  AffineMap map;
  std::vector<Solid> solids;
  std::vector<std::shared_ptr<const Operand>> operands;
};

class Truth {
 public:
  // With respect to the surfaces that bound solids of the formula.
  Truth(const World& world, const Formula& formula) : world_(world), formula_(formula) {
    for (const std::uint32_t v : formula.variables())
      for (int s = 0; s < kNumSurfaces; ++s)
        is_used_[static_cast<std::size_t>(s)] |= world.solids[v].has(s);
  }

  // Nothing: a contact, the normals are dependent.
  std::optional<PointWord> word(const ExactPoint& p, std::size_t& num_surfaces) const {
    const auto values = values_at(p);
    Sides sides{};
    std::vector<int> through;
    for (int s = 0; s < kNumSurfaces; ++s) {
      sides[static_cast<std::size_t>(s)] = to_int(values[static_cast<std::size_t>(s)].sign());
      if (sides[static_cast<std::size_t>(s)] == 0 && is_used_[static_cast<std::size_t>(s)])
        through.push_back(s);
    }
    num_surfaces = through.size();
    if (!are_independent(through, p)) return std::nullopt;
    bool has[2] = {};
    for (std::uint32_t bits = 0; bits < 1u << through.size(); ++bits) {
      for (std::size_t k = 0; k < through.size(); ++k)
        sides[static_cast<std::size_t>(through[k])] = (bits >> k & 1) != 0 ? 1 : -1;
      has[value(sides) ? 1 : 0] = true;
    }
    return has[0] && has[1] ? PointWord::kOn : has[1] ? PointWord::kIn : PointWord::kOut;
  }

  // Whether the formula holds off all surfaces; nothing on one.
  std::optional<bool> value_off(const ExactPoint& p) const {
    const auto values = values_at(p);
    Sides sides{};
    for (std::size_t s = 0; s < kNumSurfaces; ++s) {
      sides[s] = to_int(values[s].sign());
      if (sides[s] == 0 && is_used_[s]) return std::nullopt;
    }
    return value(sides);
  }

 private:
  bool value(const Sides& sides) const {
    return formula_.value([&](std::uint32_t v) {
      return to_value(world_.solids[v].holds(sides));
    }) == Value3::kOne;
  }
  static bool are_independent(const std::vector<int>& through, const ExactPoint& p) {
    if (through.size() > 3) return false;
    if (through.size() < 2) return true;
    const ExactPoint a = gradient_at(through[0], p), b = gradient_at(through[1], p),
                     n = cross_product(a, b);
    if (n[0].sign() == 0 && n[1].sign() == 0 && n[2].sign() == 0) return false;
    if (through.size() == 2) return true;
    const ExactPoint c = gradient_at(through[2], p);
    return (n[0] * c[0] + n[1] * c[1] + n[2] * c[2]).sign() != 0;
  }

  const World& world_;
  const Formula& formula_;
  std::array<bool, kNumSurfaces> is_used_{};
};

struct Tally {
  std::uint64_t points = 0, wrong = 0, open = 0, several = 0, contacts = 0, open_contacts = 0,
                words[4] = {};
  double seconds = 0, slowest = 0;
};

void report_wrong(const char* what, const World& world, std::uint64_t number, std::uint64_t seed,
                  const Formula& f, const ExactPoint& p, PointWord word) {
  std::fprintf(stderr, "%s: world %llu of seed %llu, %s at %s %s %s: word %d\n", what,
               static_cast<unsigned long long>(number), static_cast<unsigned long long>(seed),
               f.to_string().c_str(), p[0].to_string().c_str(), p[1].to_string().c_str(),
               p[2].to_string().c_str(), static_cast<int>(word));
  for (const std::uint32_t v : f.variables()) {
    const Solid& s = world.solids[v];
    std::fprintf(stderr, "  x%u: surface %d, signs %d %d %d, levels %d to %d, %zu patches\n", v,
                 s.round ? static_cast<int>(*s.round) : -1, s.signs[0], s.signs[1], s.signs[2],
                 s.bottom, s.top, s.patches.size());
  }
}

// Whether points near a contact tell that the word is wrong.
bool is_refuted(const Truth& truth, const ExactPoint& p, PointWord word, Random& random) {
  bool has[2] = {};
  for (int i = 0; i < 60; ++i) {
    ExactPoint q = p;
    const Rational size = ratio(1, std::int64_t{1} << (10 + random.below(30)));
    for (Rational& x : q)
      x += size * ratio(static_cast<std::int64_t>(random.below(2001)) - 1000, 1000);
    if (const auto v = truth.value_off(q)) has[*v ? 1 : 0] = true;
  }
  return (word == PointWord::kIn && has[0]) || (word == PointWord::kOut && has[1]);
}

}  // namespace
}  // namespace veritope::bench

int main(int argc, char** argv) {
  using namespace veritope;
  using namespace veritope::bench;
  std::uint64_t worlds = 10, points = 400, seed = 1, first = 0;
  read_arguments(
      argc, argv,
      {{"--worlds", &worlds}, {"--points", &points}, {"--seed", &seed}, {"--first", &first}});
  Tally t;
  const Stopwatch all;
  constexpr std::uint64_t kPointsOfFormula = 20;
  for (std::uint64_t w = first; w < first + worlds; ++w) {
    Random random(seed + 1000003 * w);
    const World world(random);
    for (std::uint64_t done = 0; done < points; done += kPointsOfFormula) {
      const Formula formula = random_formula(random, world.solids.size(), 2 + random.below(7));
      const ExpressionClassifier classifier(formula, world.operands);
      const Truth truth(world, formula);
      Places places(random);
      for (std::uint64_t k = 0; k < kPointsOfFormula; ++k) {
        const ExactPoint p = places.place();
        const Stopwatch watch;
        const PointWord word = classifier.classify(image_of(world.map, p));
        const double seconds = watch.ns() * 1e-9;
        t.seconds += seconds;
        t.slowest = std::max(t.slowest, seconds);
        std::size_t num_surfaces = 0;
        const std::optional<PointWord> right = truth.word(p, num_surfaces);
        if (!right) {
          ++t.contacts;
          t.open_contacts += word == PointWord::kUndecided ? 1 : 0;
          if (word == PointWord::kUndecided || !is_refuted(truth, p, word, random)) continue;
          ++t.wrong;
          report_wrong("wrong", world, w, seed, formula, p, word);
          continue;
        }
        ++t.points;
        ++t.words[static_cast<std::size_t>(*right)];
        t.several += num_surfaces > 1 ? 1 : 0;
        if (word == *right) continue;
        ++(word == PointWord::kUndecided ? t.open : t.wrong);
        report_wrong(word == PointWord::kUndecided ? "undecided" : "wrong", world, w, seed, formula,
                     p, word);
      }
    }
    if (w % 20 == 19)
      std::fprintf(stderr, "%llu worlds, %.0f s\n", static_cast<unsigned long long>(w + 1),
                   all.ns() * 1e-9);
  }
  const auto n = [](std::uint64_t x) { return static_cast<unsigned long long>(x); };
  std::printf(
      "{\"name\":\"curved_booleans_wrong\",\"value\":%llu,\"goal\":\"0\",\"points\":%llu,\"on_"
      "several_"
      "surfaces\":%llu,\"in\":%llu,\"on\":%llu,\"out\":%llu}\n",
      n(t.wrong), n(t.points), n(t.several), n(t.words[0]), n(t.words[1]), n(t.words[2]));
  std::printf("{\"name\":\"curved_booleans_undecided\",\"value\":%llu,\"goal\":\"0\"}\n",
              n(t.open));
  std::printf(
      "{\"name\":\"curved_booleans_contacts_undecided\",\"value\":%llu,\"contacts\":%llu}\n",
      n(t.open_contacts), n(t.contacts));
  std::printf(
      "{\"name\":\"curved_booleans_milliseconds_a_point\",\"value\":%.3f,\"slowest\":%.0f,"
      "\"seconds\":%.0f}\n",
      1e3 * t.seconds / static_cast<double>(std::max<std::uint64_t>(1, t.points + t.contacts)),
      1e3 * t.slowest, all.ns() * 1e-9);
  return t.wrong + t.open == 0 && t.points > 0 ? 0 : 1;
}
