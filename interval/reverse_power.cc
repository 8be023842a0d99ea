// SPDX-License-Identifier: LGPL-3.0-or-later
// Solves x^y = z for x or for y. Where x and z are positive, y log x = log z: a reverse product of logarithms.
// Besides, 0^y = 0 for y > 0.
#include <vector>

#include "interval/infinity_internal.h"
#include "interval/mpfr_internal.h"
#include "interval/relations.h"
#include "interval/reverse.h"

namespace veritope {

namespace {

using internal::kInfinity;
using internal::Real;

// An end of an interval of numbers or of logarithms: the sign of the number (or of its logarithm), whether the number
// (or its logarithm) is infinite, and the number itself.
struct End {
  int sign;
  bool infinite;
  double number;
};
End plain(double v) { return {(v > 0) - (v < 0), internal::is_infinite(v), v}; }
End logarithm(double v) { return {(v > 1) - (v < 1), v == 0 || internal::is_infinite(v), v}; }

struct Ends {
  End lo, hi;
};

// A piece of the answer. Whether an end is only approached matters if no other point is left.
struct Piece {
  double lo, hi;
  bool lo_open, hi_open;
};
Interval kept(const Piece& p, const Interval& in) {
  const Interval out = intersection(Interval::from_bounds(p.lo, p.hi), in);
  if (!is_singleton(out)) return out;
  const bool approached = (p.lo_open && out.lo() == p.lo) || (p.hi_open && out.hi() == p.hi);
  return approached ? Interval::empty() : out;
}

// What a quotient of ends stands for. minus, zero and plus are the results for the quotients minus infinity, 0 and
// plus infinity.
class Target {
 public:
  virtual ~Target() = default;
  double minus = -kInfinity, zero = 0, plus = kInfinity;
  // REQUIRES c and b finite and not 0.
  virtual double quotient(const End& c, const End& b, mpfr_rnd_t direction) const = 0;
};

// f(p) encloses the exact value with p bits; `hits(d)` says whether the value is the binary64 number d.
template <typename Enclose, typename Hits>
double round_exactly(Enclose f, Hits hits, mpfr_rnd_t direction) {
  for (mpfr_prec_t precision = 120;; precision *= 2) {
    Real low(precision), high(precision);
    f(low, high);
    const double a = low.round(direction), b = high.round(direction);
    if (a == b) return a;
    // A number between the two bounds is the value, or more bits will decide.
    const double near = low.round(MPFR_RNDN);
    if (hits(near) || precision > 4000) return hits(near) ? near : (direction == MPFR_RNDD ? a : b);
  }
}

// Is z = d^y exactly?
bool is_power(double d, double y, double z) {
  if (!(d > 0) || internal::is_infinite(d) || internal::is_infinite(y)) return false;
  const Real base(d), exponent(y), value(z);
  Real out(mpfr_prec_t{53});
  return mpfr_pow(out.get(), base.get(), exponent.get(), MPFR_RNDN) == 0 &&
         mpfr_equal_p(out.get(), value.get()) != 0;
}

// Bases: exp(log z / y).
class Bases : public Target {
 public:
  Bases() { minus = 0, zero = 1, plus = kInfinity; }
  double quotient(const End& c, const End& b, mpfr_rnd_t direction) const override {
    const double z = c.number, y = b.number;
    const auto enclose = [&](Real& low, Real& high) {
      const Real value(z), exponent(y);
      // log z / y, then exp: increasing; log z and y decide which ends to round where.
      mpfr_log(low.get(), value.get(), MPFR_RNDD);
      mpfr_log(high.get(), value.get(), MPFR_RNDU);
      if (y < 0) mpfr_swap(low.get(), high.get());
      mpfr_div(low.get(), low.get(), exponent.get(), MPFR_RNDD);
      mpfr_div(high.get(), high.get(), exponent.get(), MPFR_RNDU);
      mpfr_exp(low.get(), low.get(), MPFR_RNDD);
      mpfr_exp(high.get(), high.get(), MPFR_RNDU);
    };
    return round_exactly(
        enclose, [&](double d) { return is_power(d, y, z); }, direction);
  }
};

// Exponents: log z / log x.
class Exponents : public Target {
 public:
  double quotient(const End& c, const End& b, mpfr_rnd_t direction) const override {
    const double z = c.number, x = b.number;
    const auto enclose = [&](Real& low, Real& high) {
      const Real value(z), base(x);
      Real near(mpfr_get_prec(low.get())), far(mpfr_get_prec(low.get()));
      // |log z| / |log x|, then the sign.
      mpfr_log(low.get(), value.get(), MPFR_RNDZ);
      mpfr_log(high.get(), value.get(), MPFR_RNDA);
      mpfr_log(near.get(), base.get(), MPFR_RNDZ);
      mpfr_log(far.get(), base.get(), MPFR_RNDA);
      mpfr_div(low.get(), low.get(), far.get(), MPFR_RNDZ);
      mpfr_div(high.get(), high.get(), near.get(), MPFR_RNDA);
      if (mpfr_sgn(low.get()) < 0) mpfr_swap(low.get(), high.get());
    };
    return round_exactly(
        enclose, [&](double d) { return is_power(x, d, z); }, direction);
  }
};

// An end of c / b for b of one sign, where |b| goes from `near` >= 0 to `far`; `up` asks for the upper end of the
// result. The end of c that counts, and the b that divides it, are chosen as in Interval's division.
double end_of_quotient(const Ends& c, const End& near, const End& far, bool negative, bool up,
                       const Target& target, bool& open) {
  const End& top = up != negative ? c.hi : c.lo;
  const bool outward = up != negative ? top.sign > 0 : top.sign < 0;
  const End& b = outward ? near : far;
  open = false;
  if (top.sign == 0) return target.zero;
  if (top.infinite || b.sign == 0) {
    open = true;
    return (top.sign > 0) != negative ? target.plus : target.minus;
  }
  if (b.infinite) {
    open = true;
    return target.zero;
  }
  return target.quotient(top, b, up ? MPFR_RNDU : MPFR_RNDD);
}

// { q : b q in c }.
std::vector<Piece> reverse_product(const Ends& b, const Ends& c, const Target& target) {
  const bool b_zero = b.lo.sign <= 0 && b.hi.sign >= 0, c_zero = c.lo.sign <= 0 && c.hi.sign >= 0;
  if (b_zero && c_zero) return {{target.minus, target.plus, true, true}};
  const End zero{0, false, 0};
  std::vector<Piece> out;
  const auto add = [&](const End& near, const End& far, bool negative) {
    Piece p{};
    p.lo = end_of_quotient(c, near, far, negative, false, target, p.lo_open);
    p.hi = end_of_quotient(c, near, far, negative, true, target, p.hi_open);
    out.push_back(p);
  };
  if (b.hi.sign > 0) add(b_zero ? zero : b.lo, b.hi, false);
  if (b.lo.sign < 0) add(b_zero ? zero : b.hi, b.lo, true);
  return out;
}

Interval hull_of(const std::vector<Piece>& pieces, const Interval& in) {
  Interval out = Interval::empty();
  for (const Piece& p : pieces) out = hull(out, kept(p, in));
  return out;
}

// The positive members; possibly empty.
Interval positive(const Interval& a) {
  const Interval out = intersection(a, Interval::from_bounds(0, kInfinity));
  return out.sign() == Sign3::kZero ? Interval::empty() : out;
}
Ends logarithms(const Interval& a) { return {logarithm(a.lo()), logarithm(a.hi())}; }

}  // namespace

Interval pow_rev1(const Interval& b, const Interval& c, const Interval& in) {
  if (b.is_empty() || c.is_empty() || in.is_empty()) return Interval::empty();
  const internal::MpfrScope environment;
  Interval out = Interval::empty();
  if (const Interval values = positive(c); !values.is_empty())
    out = hull_of(reverse_product({plain(b.lo()), plain(b.hi())}, logarithms(values), Bases()), in);
  const bool zero = is_member(0, c) && is_member(0, in) && b.hi() > 0;
  return zero ? hull(out, Interval()) : out;
}

Interval pow_rev2(const Interval& b, const Interval& c, const Interval& in) {
  if (b.is_empty() || c.is_empty() || in.is_empty()) return Interval::empty();
  const internal::MpfrScope environment;
  Interval out = Interval::empty();
  const Interval values = positive(c), bases = positive(b);
  if (!values.is_empty() && !bases.is_empty())
    out = hull_of(reverse_product(logarithms(bases), logarithms(values), Exponents()), in);
  if (is_member(0, b) && is_member(0, c)) out = hull(out, kept({0, kInfinity, true, true}, in));
  return out;
}

}  // namespace veritope
