// SPDX-License-Identifier: LGPL-3.0-or-later
// Built by tests/hostile_flags_test.py under flags that break ordinary floating point. The
// inline operations must give the same bounds as rationals; those are compiled as usual. Prints the
// number of checks and of violations.
#include <cstdio>
#include <cstring>

#include "interval/interval.h"
#include "interval/relations.h"
#include "robust/base/random.h"

using namespace veritope;

namespace {

// Bits, not doubles: this file's own flags must not touch the check.
double draw(Random& random) {
  std::uint64_t bits = random.next();
  if (random.below(4) == 0) bits = bits & 0x8000000000000007u;  // zero and subnormals
  if (random.below(4) == 0) bits = (bits & 0x800fffffffffffffu) | 0x3ff0000000000000u;
  if ((bits & 0x7ff0000000000000u) == 0x7ff0000000000000u) bits ^= 0x4000000000000000u;
  double v;
  std::memcpy(&v, &bits, sizeof v);
  return v;
}
Interval draw_interval(Random& random) {
  const double a = draw(random), b = draw(random);
  return internal::less(b, a) ? Interval::from_bounds(b, a) : Interval::from_bounds(a, b);
}
Rational exact(double v) { return Rational::from_double(v); }

struct Range {
  Rational lo, hi;
  void take(const Rational& v) {
    if (v < lo) lo = v;
    if (hi < v) hi = v;
  }
};
// The library's Interval lies in other registers if this file is built for a processor without SSE2.
#if defined(__SSE2__)
Interval narrowest(const Rational& x) { return enclose(x); }
#else
Interval narrowest(const Rational& x) { return Interval::from_bounds(round_down(x), round_up(x)); }
#endif
bool is_tightest(const Interval& got, const Range& r) {
  return got == hull(narrowest(r.lo), narrowest(r.hi));
}

}  // namespace

int main() {
  Random random(7);
  long checks = 0, violations = 0;
  const auto check = [&](bool good) { ++checks, violations += good ? 0 : 1; };
  for (int i = 0; i < 3000; ++i) {
    const Interval a = draw_interval(random), b = draw_interval(random);
    Interval sum, difference, product, quotient, square, root;
    {
      const ScopedUpward upward;
      sum = a + b, difference = a - b, product = a * b, quotient = a / b, square = sqr(a),
      root = sqrt(a);
    }
    const Rational al = exact(a.lo()), ah = exact(a.hi()), bl = exact(b.lo()), bh = exact(b.hi());
    check(is_tightest(sum, {al + bl, ah + bh}));
    check(is_tightest(difference, {al - bh, ah - bl}));
    Range p{al * bl, al * bl}, q{al * al, al * al};
    p.take(al * bh), p.take(ah * bl), p.take(ah * bh), q.take(ah * ah);
    check(is_tightest(product, p));
    if (al.sign() != ah.sign()) q.take(Rational(0));
    check(is_tightest(square, q));
    if (!is_member(0, b)) {
      Range d{al / bl, al / bl};
      d.take(al / bh), d.take(ah / bl), d.take(ah / bh);
      check(is_tightest(quotient, d));
    } else {
      check(a.sign() == Sign3::kZero || b.sign() == Sign3::kZero || !is_common(quotient) ||
            quotient == Interval());
    }
    if (al.sign() == Sign::kPositive)
      check(exact(root.lo()) * exact(root.lo()) <= al && ah <= exact(root.hi()) * exact(root.hi()));
  }
  // What flags that deny NaN and infinity would break first.
  const ScopedUpward upward;
  const Interval none = Interval::empty(), all = Interval::entire(), zero;
  check((none * all).is_empty() && (none + all).is_empty() && none.is_empty() && !all.is_empty());
  check(zero * all == zero && all * zero == zero && (all * all).is_entire() &&
        sqr(none).is_empty());
  check(none.sign() == Sign3::kUncertain && (Interval(1.0) / zero).is_empty() && all.is_entire());
  std::printf("%ld %ld\n", checks, violations);
  return violations == 0 ? 0 : 1;
}
