// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_classify_plane.cc: --rounds N --points M --seed S : regions of the plane whose loops are ellipses, which
// overlap, cross and turn either way, and points with respect to them: anywhere, on the curves at rational and at
// irrational parameters, 2^-60 to 2^-1000 beside them, at the height of ends of curves, and on chords. The truth is the
// sign of the quadratic forms. The normal chain from a random origin is compared, too. One JSON line a figure.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "bench/arguments.h"
#include "bench/stopwatch.h"
#include "robust/base/random.h"
#include "solids/chain/associated_function.h"
#include "solids/chain/plane_cell.h"
#include "solids/chain/plane_region.h"

namespace veritope::bench {
namespace {

using Powers = std::vector<Rational>;  // coefficients of 1, t, t^2, ...

Rational fraction(std::int64_t p, std::int64_t q) { return Rational(p) / Rational(q); }

Powers times(const Powers& a, const Powers& b) {
  Powers out(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) out[i + j] += a[i] * b[j];
  return out;
}

std::vector<Rational> bernstein_of(const Powers& a) {
  const std::size_t n = a.size() - 1;
  const auto binomial = [](std::size_t m, std::size_t k) {
    Rational out(1);
    for (std::size_t i = 1; i <= k; ++i) out = out * Rational(m + 1 - i) / Rational(i);
    return out;
  };
  std::vector<Rational> out(n + 1);
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= j; ++i) out[j] += binomial(j, i) / binomial(n, i) * a[i];
  return out;
}

// The image of the unit circle under x -> A x + b, counter-clockwise or clockwise, times a change of parameters.
struct Ellipse {
  Rational a, b, c, d;  // A, by rows
  PointIn<2> centre;
  bool is_reversed = false;

  PointIn<2> image(const Rational& x, const Rational& y) const {
    return {a * x + b * y + centre[0], c * x + d * y + centre[1]};
  }
  // Positive outside.
  Sign side(const PointIn<2>& q) const {
    const Rational x = q[0] - centre[0], y = q[1] - centre[1], det = a * d - b * c;
    const Rational u = d * x - b * y, v = a * y - c * x;
    return (u * u + v * v - det * det).sign();
  }
  int winding() const {
    const int turn = to_int((a * d - b * c).sign());
    return is_reversed ? -turn : turn;
  }
  // The point of a quarter at the parameter s of its plain form.
  PointIn<2> point(int quarter, const Rational& s) const {
    const Rational w = Rational(1) + s * s;
    Rational x = (Rational(1) - s * s) / w, y = Rational(2) * s / w;
    for (int i = 0; i < quarter; ++i) x = std::exchange(y, x), x.negate();
    return image(x, y);
  }
  // A quarter with the parameter s, a polynomial that maps [0,1] onto itself.
  PlaneArc quarter(int number, const Powers& s) const {
    const Powers one{Rational(1)}, square = times(s, s);
    const auto combined = [&](const Rational& constant, const Rational& linear,
                              const Rational& quadratic) {
      Powers out(square.size());
      out[0] = constant;
      for (std::size_t i = 0; i < s.size(); ++i) out[i] += linear * s[i];
      for (std::size_t i = 0; i < square.size(); ++i) out[i] += quadratic * square[i];
      return out;
    };
    Powers x = combined(1, 0, -1), y = combined(0, 2, 0);
    const Powers w = combined(1, 0, 1);
    for (int i = 0; i < number; ++i) {
      std::swap(x, y);
      for (Rational& v : x) v.negate();
    }
    const auto row = [&](const Rational& p, const Rational& q, const Rational& r) {
      Powers out(w.size());
      for (std::size_t i = 0; i < w.size(); ++i) out[i] = p * x[i] + q * y[i] + r * w[i];
      return out;
    };
    PlaneArc::Curve map({static_cast<int>(w.size()) - 1}, 3, true);
    const std::array<Powers, 3> rows{row(a, b, centre[0]), row(c, d, centre[1]), w};
    for (int k = 0; k < 3; ++k) {
      std::vector<Rational> values = bernstein_of(rows[static_cast<std::size_t>(k)]);
      if (is_reversed) std::reverse(values.begin(), values.end());
      std::copy(values.begin(), values.end(), map.component(k).begin());
    }
    return PlaneArc::make(std::move(map)).value();
  }
};

enum Kind { kAnywhere, kRational, kIrrational, kBeside, kLevel, kChords, kNumKinds };
constexpr const char* kNames[kNumKinds] = {"anywhere", "rational", "irrational",
                                           "beside",   "level",    "chords"};
struct Tally {
  std::uint64_t points = 0, on = 0, wrong = 0, wrong_chains = 0;
  double seconds = 0;
};

class Round {
 public:
  explicit Round(Random& random) : random_(random) {
    const Powers plain{Rational(0), Rational(1)};
    const Powers bent{Rational(0), fraction(1, 2), fraction(3, 2), Rational(-1)};
    const std::uint64_t n = 1 + random.below(3);
    std::vector<PlaneArc> arcs;
    while (ellipses_.size() < n) {
      Ellipse e{number(), number(), number(), number(), {number(), number()}, random.below(2) == 0};
      if ((e.a * e.d - e.b * e.c).sign() == 0) continue;
      const bool is_bent = random.below(2) == 0;
      for (int i = 0; i < 4; ++i) arcs.push_back(e.quarter(i, is_bent ? bent : plain));
      are_bent_.push_back(is_bent);
      ellipses_.push_back(std::move(e));
    }
    region_.emplace(PlaneRegion::make(std::move(arcs)).value());
    chain_.emplace(plane_chain(region_->arcs(), {number(), number()}));
  }

  void check(Kind kind, Tally& tally, std::uint64_t seed) const {
    const PointIn<2> q = place(kind);
    bool is_on = false;
    int winding = 0;
    for (const Ellipse& e : ellipses_) {
      const Sign side = e.side(q);
      is_on = is_on || side == 0;
      winding += side < 0 ? e.winding() : 0;
    }
    const Stopwatch watch;
    const PlaneAnswer answer = region_->classify(q);
    tally.seconds += watch.ns() * 1e-9;
    ++tally.points;
    tally.on += is_on ? 1 : 0;
    const bool is_right = answer.is_on() == is_on && answer.winding == (is_on ? 0 : winding);
    const bool is_chain_right = is_on || chain_->value_beside(q) == Integer(winding);
    tally.wrong += is_right ? 0 : 1;
    tally.wrong_chains += is_chain_right ? 0 : 1;
    if (!is_right || !is_chain_right)
      std::fprintf(stderr, "%s: seed %llu at %s %s: on %d winding %d, truth %d %d\n", kNames[kind],
                   static_cast<unsigned long long>(seed), q[0].to_string().c_str(),
                   q[1].to_string().c_str(), int{answer.is_on()}, answer.winding, int{is_on},
                   winding);
  }

 private:
  Rational number() const {
    return fraction(static_cast<std::int64_t>(random_.below(33)) - 16,
                    1 + static_cast<std::int64_t>(random_.below(6)));
  }
  Rational parameter() const { return fraction(static_cast<std::int64_t>(random_.below(98)), 97); }

  PointIn<2> place(Kind kind) const {
    const std::size_t e = random_.below(ellipses_.size());
    const int quarter = static_cast<int>(random_.below(4));
    // On a bent curve the parameter of a plain one's rational point is irrational, as a rule.
    const bool wants_bent = kind == kIrrational;
    std::size_t chosen = e;
    for (std::size_t i = 0; i < ellipses_.size(); ++i)
      if (are_bent_[i] == wants_bent) chosen = i;
    const Ellipse& ellipse = ellipses_[chosen];
    PointIn<2> out = ellipse.point(quarter, parameter());
    if (kind == kAnywhere)
      return {Rational::from_double(32 * random_.unit() - 16),
              Rational::from_double(32 * random_.unit() - 16)};
    if (kind == kBeside) {
      static constexpr std::int64_t kBits[] = {60, 300, 1000};
      const Rational by = Rational::power_of_two(-kBits[random_.below(3)]);
      out[random_.below(2)] += random_.below(2) == 0 ? by : -by;
    } else if (kind == kLevel) {
      out = ellipse.point(quarter, Rational(0));
      out[random_.below(2)] = number();
    } else if (kind == kChords) {
      const PointIn<2> a = ellipse.point(quarter, 0), b = ellipse.point(quarter, 1);
      const Rational t = parameter();
      for (std::size_t k = 0; k < 2; ++k) out[k] = a[k] + t * (b[k] - a[k]);
    }
    return out;
  }

  Random& random_;
  std::vector<Ellipse> ellipses_;
  std::vector<bool> are_bent_;
  std::optional<PlaneRegion> region_;
  std::optional<AssociatedFunction<2>> chain_;
};

}  // namespace
}  // namespace veritope::bench

int main(int argc, char** argv) {
  using namespace veritope;
  using namespace veritope::bench;
  std::uint64_t rounds = 20, points = 60, seed = 1;
  read_arguments(argc, argv, {{"--rounds", &rounds}, {"--points", &points}, {"--seed", &seed}});
  Tally tallies[kNumKinds];
  for (std::uint64_t r = 0; r < rounds; ++r) {
    Random random(seed + 1000003 * r);
    const Round round(random);
    for (std::uint64_t i = 0; i < points; ++i)
      round.check(static_cast<Kind>(i % kNumKinds), tallies[i % kNumKinds], seed + 1000003 * r);
  }
  std::uint64_t wrong = 0;
  for (int k = 0; k < kNumKinds; ++k) {
    const Tally& t = tallies[k];
    const auto print = [&](const char* what, std::uint64_t value) {
      std::printf(
          "{\"name\":\"classify_plane_%s_%s\",\"value\":%llu,\"goal\":\"0\",\"points\":%llu,"
          "\"on\":%llu,\"us_a_point\":%.1f,\"seed\":%llu}\n",
          kNames[k], what, static_cast<unsigned long long>(value),
          static_cast<unsigned long long>(t.points), static_cast<unsigned long long>(t.on),
          t.seconds * 1e6 / static_cast<double>(t.points > 0 ? t.points : 1),
          static_cast<unsigned long long>(seed));
    };
    print("wrong", t.wrong);
    print("chains_wrong", t.wrong_chains);
    wrong += t.wrong + t.wrong_chains;
  }
  return wrong == 0 ? 0 : 1;
}
