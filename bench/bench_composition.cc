// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_composition.cc: T(t) for a trivariate of 3 components in another: seconds, one thread, least of the
// repetitions. Rows composition_<outer degrees>_of_<inner degree>_<way>: bounded: binary64 with error bounds, compared
// with the generic ring over double (no bounds); exact: by remainders, compared with the nested products over integers;
// to_rational: the exact map in lowest terms; rational: exact and to_rational, compared with the generic ring over
// Rational, for degrees at which the latter ends. A tile is seven tricubic trivariates in one cage.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/stopwatch.h"
#include "robust/base/random.h"
#include "splines/composition.h"
#include "splines/composition_bounded.h"
#include "splines/composition_exact.h"

namespace veritope::bench {
namespace {

using Volume = Bezier<double, 3>;

template <typename Run>
double seconds(int repetitions, Run run) {
  double least = 1e300;
  for (int i = 0; i < repetitions; ++i) {
    const Stopwatch watch;
    run();
    least = std::min(least, watch.ns() * 1e-9);
  }
  return least;
}

void row(const std::string& name, double ours, double peer, std::size_t coefficients,
         const std::string& more = "") {
  char other[32] = "null";
  if (peer > 0) std::snprintf(other, sizeof other, "%.5g", peer);
  std::printf(
      "{\"row\":\"composition_%s\",\"ours\":%.5g,\"peer\":%s,\"unit\":\"s\",\"control_points\":%zu%"
      "s}\n",
      name.c_str(), ours, other, coefficients, more.c_str());
  std::fflush(stdout);
}

// Coefficients in [low, 1). Those of a cage have both signs: bounds of coefficients of one sign
// cost half as much.
Volume draw(Random& random, std::array<int, 3> degrees, double low) {
  Volume map(degrees, 3, false);
  for (double& v : map.coefficients()) v = low + (1 - low) * random.unit();
  return map;
}

Bezier<Rational, 3> rational(const Volume& map) {
  std::vector<Rational> c;
  for (const double v : map.coefficients()) c.push_back(Rational::from_double(v));
  return Bezier<Rational, 3>(map.degrees(), 3, false, std::move(c));
}

void rows(std::array<int, 3> cage, int degree, bool with_rational) {
  Random random(1);
  const Volume outer = draw(random, cage, -1), inner = draw(random, {degree, degree, degree}, 0);
  const std::string name = std::to_string(cage[0]) + std::to_string(cage[1]) +
                           std::to_string(cage[2]) + "_of_" + std::to_string(degree);
  constexpr int kRuns = 7;
  const auto bounded = compose_bounded(outer, inner);
  const std::size_t count = bounded->map.grid().count();
  char more[64];
  std::snprintf(more, sizeof more, ",\"largest_bound\":%.2g",
                *std::max_element(bounded->error.begin(), bounded->error.end()));
  row(name + "_bounded", seconds(kRuns, [&] { (void)compose_bounded(outer, inner); }),
      seconds(kRuns, [&] { (void)compose(outer, inner); }), count, more);

  const auto exact = compose_exact(outer, inner);
  const auto by_integers = [&] {
    return internal::compose_exact_by(internal::ExactWay::kIntegers, outer, inner);
  };
  VT_CHECK(by_integers()->scaled == exact->scaled, "remainders and integers agree");
  std::uint64_t bits = 0;
  for (const Integer& n : exact->scaled) bits = std::max(bits, n.bit_length());
  const double by_remainders = seconds(kRuns, [&] { (void)compose_exact(outer, inner); });
  row(name + "_exact", by_remainders, seconds(2, [&] { (void)by_integers(); }), count,
      ",\"bits\":" + std::to_string(bits));
  const double to_rational = seconds(3, [&] { (void)exact->to_rational(); });
  row(name + "_to_rational", to_rational, 0, count);
  if (!with_rational) return;
  const auto a = rational(outer), b = rational(inner);
  VT_CHECK(*compose(a, b) == exact->to_rational(), "remainders and rationals agree");
  row(name + "_rational", by_remainders + to_rational, seconds(1, [&] { (void)compose(a, b); }),
      count);
}

void tile_rows() {
  Random random(2);
  const Volume cage = draw(random, {3, 3, 3}, -1);
  std::vector<Volume> tile;
  for (int i = 0; i < 7; ++i) tile.push_back(draw(random, {3, 3, 3}, 0));
  const auto all = [&](auto compose_one) {
    for (const Volume& inner : tile) (void)compose_one(inner);
  };
  const std::size_t count = 7 * 28 * 28 * 28;
  row("tile_of_7_bounded",
      seconds(5, [&] { all([&](const Volume& t) { return compose_bounded(cage, t); }); }),
      seconds(3, [&] { all([&](const Volume& t) { return compose(cage, t); }); }), count);
  row("tile_of_7_exact",
      seconds(3, [&] { all([&](const Volume& t) { return compose_exact(cage, t); }); }), 0, count);
}

}  // namespace
}  // namespace veritope::bench

int main() {
  using veritope::bench::rows;
  rows({1, 1, 1}, 3, true);
  rows({1, 1, 3}, 3, true);
  rows({2, 2, 2}, 3, false);
  rows({3, 3, 3}, 1, true);
  rows({3, 3, 3}, 2, false);
  rows({3, 3, 3}, 3, false);
  veritope::bench::tile_rows();
  return 0;
}
