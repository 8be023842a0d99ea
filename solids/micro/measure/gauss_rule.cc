// SPDX-License-Identifier: LGPL-3.0-or-later
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>

#include "interval/mp_interval.h"
#include "robust/base/check.h"
#include "solids/micro/measure/gauss_rule_internal.h"

namespace veritope::internal {
namespace {

// P_(n-1) and P_n.
struct LastLegendre {
  MpInterval before, last;
};
LastLegendre last_legendre(std::size_t n, const MpInterval& x) {
  const auto whole = [&](std::size_t k) {
    return MpInterval(Rational(static_cast<std::int64_t>(k)), x.precision());
  };
  MpInterval before = whole(1), last = x;
  for (std::size_t k = 1; k < n; ++k) {
    MpInterval next = (whole(2 * k + 1) * x * last - whole(k) * before) / whole(k + 1);
    before = std::move(last);
    last = std::move(next);
  }
  return {std::move(before), std::move(last)};
}

// Root number i of P_n, from the greatest on, to nearly the precision of binary64; nothing depends on its quality.
double approximate_root(std::size_t n, std::size_t i) {
  const auto d = static_cast<double>(n);
  double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (d + 0.5));
  for (int step = 0; step < 8; ++step) {
    double before = 1, last = x;
    for (std::size_t k = 1; k < n; ++k) {
      const auto m = static_cast<double>(k);
      const double next = ((2 * m + 1) * x * last - m * before) / (m + 1);
      before = last;
      last = next;
    }
    const double slope = d * (before - x * last) / (1 - x * x);
    x -= last / slope;
  }
  return x;
}

// P_n changes its sign in each of n disjoint intervals, and has no other roots.
GaussRule make_rule(std::size_t n) {
  // Widths grow by 1.3 bits with each step of the recurrence.
  const int precision = static_cast<int>(128 + 3 * n);
  const Rational radius = Rational::power_of_two(-static_cast<std::int64_t>(64 + 3 * n / 2));
  const auto at = [&](const Rational& x) { return MpInterval(x, precision); };
  const MpInterval one = at(Rational(1)), size = at(Rational(static_cast<std::int64_t>(n)));
  GaussRule out;
  out.nodes.resize(n);
  out.weights.resize(n);
  Rational above(2);
  for (std::size_t i = 0; i < n; ++i) {
    Rational x = n == 1 ? Rational() : Rational::from_double(approximate_root(n, i));
    for (int step = 0; n > 1 && step < 5; ++step) {
      const MpInterval here = at(x);
      const LastLegendre p = last_legendre(n, here);
      x = (here - p.last * (one - sqr(here)) / (size * (p.before - here * p.last))).lo();
    }
    const Rational low = x - radius, high = x + radius;
    const Sign3 signs[] = {last_legendre(n, at(low)).last.sign(),
                           last_legendre(n, at(high)).last.sign()};
    VT_CHECK(high < above && signs[0] != Sign3::kUncertain && signs[1] != Sign3::kUncertain &&
                 signs[0] != Sign3::kZero && signs[1] != Sign3::kZero && signs[0] != signs[1],
             "each root of a Legendre polynomial has an interval of its own");
    above = low;
    const MpInterval node = hull(at(low), at(high));
    const MpInterval before = last_legendre(n, node).before;
    out.nodes[n - 1 - i] = node.to_interval();
    out.weights[n - 1 - i] =
        (at(Rational(2)) * (one - sqr(node)) / sqr(size * before)).to_interval();
  }
  return out;
}

// The recurrence widens intervals by a factor of 2.5 with each step.
constexpr std::size_t kMostByRecurrence = 8;
constexpr std::size_t kMostLegendre = 255;

// C(2j, j) / 4^j.
std::vector<Interval> cosine_weights(std::size_t size) {
  std::vector<Interval> out = {Interval(1.0)};
  for (std::size_t j = 1; j < size; ++j)
    out.push_back(out.back() * Interval(static_cast<double>(2 * j - 1)) /
                  Interval(static_cast<double>(2 * j)));
  return out;
}
// P_k(cos t) is the sum of a_j a_(k - j) cos((k - 2j) t) over j from 0 to k, where a_j = C(2j, j) / 4^j > 0. Cosines
// T_m = 2 T_a T_b - T_(a - b), a + b = m, widen intervals by m^2 only, if a and b are halves.
void values_by_cosines(const Interval& x, std::span<Interval> out) {
  const Interval two(2.0);
  std::vector<Interval> t = {Interval(1.0), x};
  for (std::size_t m = 2; m < out.size(); ++m)
    t.push_back(m % 2 == 0 ? two * sqr(t[m / 2]) - t[0] : two * t[m / 2] * t[m / 2 + 1] - x);
  static const std::vector<Interval> a = cosine_weights(kMostLegendre + 1);
  VT_CHECK(out.size() <= a.size(), "the degree of a Legendre polynomial");
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k] = k % 2 == 0 ? sqr(a[k / 2]) : Interval();
    for (std::size_t j = 0; 2 * j < k; ++j) out[k] += two * a[j] * a[k - j] * t[k - 2 * j];
  }
}

}  // namespace

const GaussRule& gauss_rule(std::size_t n) {
  VT_CHECK(n >= 1 && n <= 512, "a Gauss rule has 1 to 512 nodes");
  static std::mutex mutex;
  static std::map<std::size_t, GaussRule> rules;
  const std::lock_guard lock(mutex);
  const auto [at, is_new] = rules.try_emplace(n);
  if (is_new) at->second = make_rule(n);
  return at->second;
}

void legendre_values(const Interval& x, std::span<Interval> out) {
  if (out.size() > kMostByRecurrence + 1) return values_by_cosines(x, out);
  for (std::size_t k = 0; k < out.size(); ++k) {
    if (k < 2) {
      out[k] = k == 0 ? Interval(1.0) : x;
      continue;
    }
    const auto d = static_cast<double>(k);
    out[k] = (Interval(2 * d - 1) * x * out[k - 1] - Interval(d - 1) * out[k - 2]) / Interval(d);
  }
}

}  // namespace veritope::internal
