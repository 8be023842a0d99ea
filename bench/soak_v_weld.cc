// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_v_weld.cc: --rounds N --seed S. Random grids of cells whose truth is known by construction, in any
// descriptions (symmetry, degrees, knots, domain, constant and projective weights), every control point off by a random
// part of eps. Near: by less than eps / 4: every pair is welded, nothing moves by more than eps / 2, and welding again
// changes nothing. Far: by up to 4 eps, so that chains are too long and faces are near to several: whatever is welded,
// no point moves by more than eps, welded pairs are glued, what was glued still is, nothing collapses. Thin: as far,
// with cells as thin as eps. One JSON line a kind: wrong results; the cells of one go to standard error.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "solids/vmodel/v_weld.h"
#include "splines/bspline_common.h"
#include "tests/support/v_cells.h"

namespace {

using namespace veritope;
using v_cells::Point;

constexpr std::array<const char*, 3> kNames = {"near", "far", "thin"};
const Rational kEps = Rational(1) / Rational(1000);

struct Totals {
  std::uint64_t rounds = 0, wrong = 0, welded = 0, apart = 0;
};

std::vector<VVolume> random_grid(Random& random, bool is_thin) {
  const auto degree = [&] { return static_cast<int>(1 + random.below(2)); };
  std::array<Rational, 3> bend;
  for (Rational& b : bend) b = Rational(random.between(-2, 2)) / Rational(16);
  const Rational scale =
      is_thin ? kEps * Rational(random.between(1, 8)) / Rational(4) : Rational(1);
  std::vector<VVolume> out = v_cells::grid(2, {degree(), degree(), degree()}, [&](const Point& p) {
    return Point{p[0] + bend[0] * p[1] * p[1], p[1] + bend[1] * p[0] * p[0],
                 scale * p[2] + bend[2] * p[0] * p[1]};
  });
  const bool is_projective = random.below(3) == 0;
  for (VVolume& cell : out) {
    if (is_projective) {
      cell = v_cells::with_factor(cell, Rational(1));
      for (std::size_t n = 0; n < cell.grid().count(); ++n)
        cell.component(3)[n] += cell.component(0)[n] / Rational(16);
    }
    cell = v_cells::redescribed(v_cells::turned(cell, static_cast<unsigned>(random.below(48))),
                                random);
  }
  while (random.below(3) == 0)
    out.erase(out.begin() + static_cast<std::ptrdiff_t>(random.below(out.size())));
  return out;
}

VVolume perturbed(const VVolume& cell, const Rational& most, Random& random) {
  return v_cells::mapped(cell, [&](Point p) {
    for (Rational& x : p) x += most * Rational(random.between(-1000, 1000)) / Rational(1001);
    return p;
  });
}

// The largest coordinate of a way of a control point, in the common function space; weights must not change.
bool moves_at_most(const VVolume& before, const VVolume& after, const Rational& most) {
  const auto common = to_common_axes(before, after).value();
  const VVolume &a = common.first, &b = common.second;
  for (std::size_t n = 0; n < a.grid().count(); ++n) {
    const Rational w = a.is_rational() ? a.component(3)[n] : Rational(1);
    if (a.is_rational() && b.component(3)[n] != w) return false;
    for (int c = 0; c < 3; ++c)
      if (abs(a.component(c)[n] - b.component(c)[n]) > most * w) return false;
  }
  return true;
}

// What is wrong with a weld, or nothing.
std::string fault_of(const std::vector<VVolume>& cells, const VWeld& weld, const Rational& most) {
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (!moves_at_most(cells[c], weld.cells[c], most)) return "a cell moves too far";
  const VModel before = make_v_model(cells, VOrientation::kAuto).value(),
               after = make_v_model(weld.cells, VOrientation::kAuto).value();
  for (VFaceNumber f = 0; f < before.num_faces(); ++f) {
    if (before.face(f).is_glued() && after.face(f).mate != before.face(f).mate)
      return "a pair is not glued any more";
    if (before.face(f).collapse != after.face(f).collapse) return "a face collapses";
  }
  for (const VWeldedPair& pair : weld.welded)
    if (after.face(pair.winner).mate != pair.loser) return "a welded pair is not glued";
  if (weld.welded.empty() && !weld.changed.empty()) return "something moves without a near pair";
  return "";
}

std::string fault_of_near(const std::vector<VVolume>& exact, const VWeld& weld) {
  if (weld.glued_after != make_v_model(exact, VOrientation::kAuto).value().counts().internal)
    return "not all pairs are welded";
  if (!weld.apart.empty()) return "a pair is listed as apart";
  return veritope::weld(weld.cells, kEps).value().changed.empty() ? "" : "a second weld changes it";
}

}  // namespace

int main(int argc, char** argv) {
  int rounds = 3000;
  std::uint64_t seed = 1;
  bench::read_arguments(argc, argv, {{"--rounds", &rounds}, {"--seed", &seed}});
  std::array<Totals, 3> totals;
  for (int n = 0; n < rounds; ++n) {
    Random random(seed * 1000003 + static_cast<std::uint64_t>(n));
    const std::size_t kind = static_cast<std::size_t>(n) % kNames.size();
    const std::vector<VVolume> exact = random_grid(random, kind == 2);
    const Rational most =
        kind == 0 ? kEps / Rational(4) : kEps * Rational(random.between(1, 16)) / Rational(4);
    std::vector<VVolume> cells;
    for (const VVolume& cell : exact)
      cells.push_back(random.below(8) == 0 ? cell : perturbed(cell, most, random));
    const VWeld welded = weld(cells, kEps).value();
    std::string fault = fault_of(cells, welded, kind == 0 ? kEps / Rational(2) : kEps);
    if (fault.empty() && kind == 0) fault = fault_of_near(exact, welded);
    Totals& t = totals[kind];
    ++t.rounds;
    t.welded += welded.welded.size();
    t.apart += welded.apart.size();
    if (fault.empty()) continue;
    ++t.wrong;
    std::fprintf(stderr, "wrong: %s: %s, seed %llu, round %d\n", kNames[kind], fault.c_str(),
                 static_cast<unsigned long long>(seed), n);
    for (const VVolume& cell : cells) std::fprintf(stderr, "%s", v_cells::text_of(cell).c_str());
  }
  std::uint64_t wrong = 0;
  for (std::size_t k = 0; k < kNames.size(); ++k) {
    wrong += totals[k].wrong;
    std::printf(
        "{\"name\":\"v_weld_%s\",\"value\":%llu,\"goal\":\"0\",\"rounds\":%llu,\"welded\":%llu,"
        "\"apart\":%llu}\n",
        kNames[k], static_cast<unsigned long long>(totals[k].wrong),
        static_cast<unsigned long long>(totals[k].rounds),
        static_cast<unsigned long long>(totals[k].welded),
        static_cast<unsigned long long>(totals[k].apart));
  }
  return wrong == 0 ? 0 : 1;
}
