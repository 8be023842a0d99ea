// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_dms_preimages.cc: --rounds N --seed S [--points P]. Preimages of P points, 64 unless given, of N random
// valid simplex-spline solids (tests/support/dms_truth.h), and of as many points of the box around each: points of the
// solid that are missed, and answers whose exact image is elsewhere. One JSON line.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "bench/arguments.h"
#include "robust/base/random.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/fast/dms_inverse.h"
#include "tests/support/dms_truth.h"

namespace veritope {
namespace {

struct Counts {
  std::uint64_t models = 0, refused = 0, inside = 0, missed = 0, answers = 0, elsewhere = 0,
                beside = 0;
};

Point3d rounded(const std::vector<Rational>& value) {
  return {nearest_double(value[0]), nearest_double(value[1]), nearest_double(value[2])};
}

// A third of the points are on a face, an edge or a vertex of a tetrahedron.
DmsPoint drawn_point(Random& random, const DmsModel& model) {
  const TetrahedronCorners& t = model.tetrahedra[random.below(model.tetrahedra.size())];
  const bool is_special = random.below(3) == 0;
  DmsPoint out;
  Rational total;
  while (total.sign() == Sign::kZero) {
    out = {};
    for (const std::uint32_t v : t) {
      const Rational weight(is_special && random.below(2) == 0 ? 0 : random.between(1, 64));
      for (std::size_t c = 0; c < 3; ++c) out[c] += weight * model.knot(v, 0)[c];
      total += weight;
    }
  }
  for (Rational& x : out) x /= total;
  return out;
}

void check(const DmsModel& model, std::uint64_t seed, int points, const std::string& text,
           Counts& counts) {
  const Result<DmsInverse> inverse = DmsInverse::make(model, {});
  if (!inverse) {
    ++counts.refused;
    return;
  }
  ++counts.models;
  DmsEvaluator evaluator(model);
  Random random(seed);
  const Box3d& box = inverse->box();
  const double size = extent(box);
  // The image of an answer is near the point; answers on the boundary may have to be moved into the domain. Where
  // derivatives are great, an ulp of an answer, or of the move, is much in space.
  const auto judge = [&](const Point3d& x, const DmsInverse::Place& answer) {
    ++counts.answers;
    double off = -1, allowed = 1e-6 * size;
    for (const double inward : {0.0, 0x1p-30, 0x1p-20}) {
      const Point3d u = inverse->domain_point(answer, inward);
      const auto place = evaluator.locate(
          {Rational::from_double(u[0]), Rational::from_double(u[1]), Rational::from_double(u[2])});
      if (!place) continue;
      const DmsValue value = evaluator.evaluate(*place);
      const Point3d y = rounded(value.value);
      off = std::hypot(y[0] - x[0], y[1] - x[1], y[2] - x[2]);
      double slope = 0, reach = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        for (const Rational& d : value.gradient[c])
          slope = std::max(slope, std::abs(nearest_double(d)));
        reach = std::max(reach, std::abs(u[c]));
      }
      allowed += slope * reach * (8 * inward + 0x1p-46);
      break;
    }
    if (off < 0)
      ++counts.beside;  // a part so thin that rounded points of it are outside of the domain
    if (off <= allowed) return;
    ++counts.elsewhere;
    std::fprintf(stderr, "%s: an answer for (%a, %a, %a) is off by %g, allowed %g\n", text.c_str(),
                 x[0], x[1], x[2], off, allowed);
  };
  for (int i = 0; i < points; ++i) {
    const auto place = evaluator.locate(drawn_point(random, model));
    const Point3d x = rounded(evaluator.evaluate(*place).value);
    ++counts.inside;
    const auto found = inverse->find(x);
    if (found) {
      judge(x, *found);
    } else {
      ++counts.missed;
      std::fprintf(stderr, "%s: (%a, %a, %a) is missed\n", text.c_str(), x[0], x[1], x[2]);
    }
    Point3d drawn;
    for (std::size_t c = 0; c < 3; ++c)
      drawn[c] = box.lo[c] + (box.hi[c] - box.lo[c]) *
                                 (static_cast<double>(random.between(0, 1'000'000)) / 1e6);
    if (const auto answer = inverse->find(drawn)) judge(drawn, *answer);
  }
}

}  // namespace
}  // namespace veritope

int main(int argc, char** argv) {
  using namespace veritope;
  std::uint64_t rounds = 30, seed = 1;
  int points = 64;
  bench::read_arguments(argc, argv,
                        {{"--rounds", &rounds}, {"--seed", &seed}, {"--points", &points}});
  Counts counts;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const std::uint64_t number = seed * 1'000'000 + round;
    const dms_truth::Case drawn = round % 4 == 0   ? dms_truth::displaced(number)
                                  : round % 4 == 1 ? dms_truth::bent(number, true)
                                  : round % 4 == 2 ? dms_truth::wound(number, true)
                                                   : dms_truth::clouded(number, true);
    check(drawn.model, number, points, drawn.text, counts);
  }
  const auto count = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
  std::printf(
      "{\"name\":\"dms_preimages\",\"value\":%llu,\"goal\":\"0 missed, 0 elsewhere\","
      "\"elsewhere\":%llu,\"models\":%llu,\"refused\":%llu,\"points_of_solids\":%llu,"
      "\"answers\":%llu,\"beside_the_domain\":%llu}\n",
      count(counts.missed), count(counts.elsewhere), count(counts.models), count(counts.refused),
      count(counts.inside), count(counts.answers), count(counts.beside));
  return counts.missed + counts.elsewhere == 0 ? 0 : 1;
}
