// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_bent_booleans.cc: --worlds N --points M --seed S : random expressions of boxes at integers, each cut into
// patches in one of several ways, all mapped by one random composition of quadratic shears and an affine map, so that
// every wall and edge is curved; images of points of the lattice and between them. The eight octants around a point of
// the lattice tell the truth: nothing may be undecided. --first F starts with world F. One JSON line a figure.
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <vector>

#include "bench/arguments.h"
#include "bench/random_expressions.h"
#include "bench/stopwatch.h"
#include "solids/expression/expression_classifier.h"

namespace veritope::bench {
namespace {

constexpr int kSide = 2;  // of the cube of least corners

struct LatticeBox {
  std::array<int, 3> lo, hi;
};

LatticeBox random_box(Random& random) {
  LatticeBox out;
  for (std::size_t k = 0; k < 3; ++k) {
    out.lo[k] = static_cast<int>(random.below(kSide));
    out.hi[k] = out.lo[k] + 1 + static_cast<int>(random.below(2));
  }
  return out;
}

// One patch a face, or one a square of the lattice.
Patches faces_of(const LatticeBox& box, Random& random) {
  if (random.below(2) != 0)
    return patch_shapes::box({box.lo[0], box.lo[1], box.lo[2]}, {box.hi[0], box.hi[1], box.hi[2]});
  std::vector<std::array<int, 3>> cubes;
  for (int x = box.lo[0]; x < box.hi[0]; ++x)
    for (int y = box.lo[1]; y < box.hi[1]; ++y)
      for (int z = box.lo[2]; z < box.hi[2]; ++z) cubes.push_back({x, y, z});
  return patch_shapes::blocks(cubes);
}

struct Bend {
  std::vector<QuadraticShear> shears;
  AffineMap map;

  explicit Bend(Random& random) : map(random_map(random)) {
    const std::uint64_t num = 1 + random.below(2);
    while (shears.size() < num) {
      const std::size_t target = random.below(3);
      const std::size_t i = (target + 1 + random.below(2)) % 3,
                        j = (target + 1 + random.below(2)) % 3;
      shears.push_back({target, i, j, ratio(static_cast<std::int64_t>(random.below(7)) - 3, 5)});
    }
  }
  Patches operator()(Patches patches) const {
    for (const QuadraticShear& s : shears) patches = sheared(patches, s);
    return affine_image(patches, map).value();
  }
  ExactPoint operator()(ExactPoint p) const {
    for (const QuadraticShear& s : shears) p[s.target] += s.factor * p[s.i] * p[s.j];
    return image_of(map, p);
  }
};

struct BentWorld {
  explicit BentWorld(Random& random) : bend(random) {
    const std::uint64_t num = 2 + random.below(5);
    while (boxes.size() < num) {
      const bool is_copy = !boxes.empty() && random.below(4) == 0;
      boxes.push_back(is_copy ? boxes[random.below(boxes.size())] : random_box(random));
      auto complex =
          make_patch_complex(in_another_way(bend(faces_of(boxes.back(), random)), random)).value();
      if (!complex.is_closed_oriented_surface()) {
        std::fprintf(stderr, "a solid of the soak is not closed\n");
        std::exit(2);
      }
      operands.push_back(patch_operand(std::make_unique<const PatchComplex>(std::move(complex))));
    }
  }
  Bend bend;
  std::vector<LatticeBox> boxes;
  std::vector<std::shared_ptr<const Operand>> operands;
};

// Whether the box holds the points beside p in one octant, whose number has a bit for each axis.
bool holds(const LatticeBox& box, const ExactPoint& p, int octant) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational lo(box.lo[k]), hi(box.hi[k]);
    const bool is_up = (octant >> k & 1) != 0;
    if (is_up ? p[k] < lo || p[k] >= hi : p[k] <= lo || p[k] > hi) return false;
  }
  return true;
}

PointWord truth_at(const BentWorld& world, const Formula& formula, const ExactPoint& p) {
  bool has[2] = {};
  for (int octant = 0; octant < 8; ++octant)
    has[formula.value([&](std::uint32_t v) {
      return to_value(holds(world.boxes[v], p, octant));
    }) == Value3::kOne
            ? 1
            : 0] = true;
  return has[0] && has[1] ? PointWord::kOn : has[1] ? PointWord::kIn : PointWord::kOut;
}

// On the lattice in two coordinates of three, mostly.
ExactPoint random_place(Random& random) {
  ExactPoint out;
  for (Rational& x : out)
    x = random.below(3) != 0 ? Rational(static_cast<std::int64_t>(random.below(kSide + 2)))
                             : ratio(static_cast<std::int64_t>(random.below(6 * (kSide + 1))), 6);
  return out;
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
  std::uint64_t num = 0, walls = 0, wrong = 0, open = 0, words[4] = {};
  double seconds = 0, slowest = 0;
  const Stopwatch all;
  constexpr std::uint64_t kPointsOfFormula = 20;
  const auto n = [](std::uint64_t x) { return static_cast<unsigned long long>(x); };
  for (std::uint64_t w = first; w < first + worlds; ++w) {
    Random random(seed + 1000003 * w);
    const BentWorld world(random);
    for (std::uint64_t done = 0; done < points; done += kPointsOfFormula) {
      const Formula formula = random_formula(random, world.boxes.size(), 2 + random.below(7));
      const ExpressionClassifier classifier(formula, world.operands);
      for (std::uint64_t k = 0; k < kPointsOfFormula; ++k) {
        const ExactPoint p = random_place(random);
        const Stopwatch watch;
        const PointWord word = classifier.classify(world.bend(p));
        seconds += watch.ns() * 1e-9;
        slowest = std::max(slowest, watch.ns() * 1e-9);
        int num_on = 0;
        for (const std::uint32_t v : formula.variables())
          num_on += world.operands[v]->value(world.bend(p)) == Value3::kMixed ? 1 : 0;
        ++num;
        walls += num_on > 1 ? 1 : 0;
        const PointWord right = truth_at(world, formula, p);
        ++words[static_cast<std::size_t>(right)];
        if (word == right) continue;
        ++(word == PointWord::kUndecided ? open : wrong);
        std::fprintf(stderr, "world %llu of seed %llu, %s at the image of %s %s %s: %d, not %d\n",
                     n(w), n(seed), formula.to_string().c_str(), p[0].to_string().c_str(),
                     p[1].to_string().c_str(), p[2].to_string().c_str(), static_cast<int>(word),
                     static_cast<int>(right));
      }
    }
  }
  std::printf(
      "{\"name\":\"bent_booleans_wrong\",\"value\":%llu,\"goal\":\"0\",\"points\":%llu,"
      "\"on_several_walls\":%llu,\"in\":%llu,\"on\":%llu,\"out\":%llu}\n",
      n(wrong), n(num), n(walls), n(words[0]), n(words[1]), n(words[2]));
  std::printf("{\"name\":\"bent_booleans_undecided\",\"value\":%llu,\"goal\":\"0\"}\n", n(open));
  std::printf(
      "{\"name\":\"bent_booleans_milliseconds_a_point\",\"value\":%.3f,\"slowest\":%.0f,"
      "\"seconds\":%.0f}\n",
      1e3 * seconds / static_cast<double>(std::max<std::uint64_t>(1, num)), 1e3 * slowest,
      all.ns() * 1e-9);
  return wrong + open == 0 && num > 0 ? 0 : 1;
}
