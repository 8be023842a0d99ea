// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/mp_interval.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "interval/mpfr_internal.h"
#include "robust/base/check.h"

namespace veritope {

// Both are NaN if the interval is empty.
class MpInterval::Bounds {
 public:
  explicit Bounds(int precision) : lo(mpfr_prec_t{precision}), hi(mpfr_prec_t{precision}) {
    mpfr_set_zero(lo.get(), 1);
    mpfr_set_zero(hi.get(), 1);
  }
  int precision() const { return static_cast<int>(mpfr_get_prec(lo.get())); }
  bool is_empty() const { return mpfr_nan_p(lo.get()) != 0; }
  void make_empty() {
    mpfr_set_nan(lo.get());
    mpfr_set_nan(hi.get());
  }
  void make_entire() {
    mpfr_set_inf(lo.get(), -1);
    mpfr_set_inf(hi.get(), 1);
  }
  int sign_lo() const { return mpfr_sgn(lo.get()); }
  int sign_hi() const { return mpfr_sgn(hi.get()); }

  internal::Real lo, hi;
};

namespace {

using Bounds = MpInterval::Bounds;
using internal::Real;

int checked(int precision) {
  VT_CHECK(precision >= MpInterval::kMinPrecision && precision <= MpInterval::kMaxPrecision,
           "precision of a multi-precision interval");
  return precision;
}
std::unique_ptr<Bounds> result(const Bounds& a, const Bounds& b) {
  return std::make_unique<Bounds>(std::max(a.precision(), b.precision()));
}

// Replaces out by the min or max of itself and v; `first` says that out has no value yet. 0 * infinity is 0.
void take(Real& out, const Real& v, bool first, bool least) {
  const bool nan = mpfr_nan_p(v.get()) != 0;
  const int order = first ? 0 : (nan ? -mpfr_sgn(out.get()) : mpfr_cmp(v.get(), out.get()));
  if (!first && (least ? order >= 0 : order <= 0)) return;
  if (nan) {
    mpfr_set_zero(out.get(), 1);
  } else {
    mpfr_set(out.get(), v.get(), MPFR_RNDN);  // same precision: exact
  }
}

Rational rational_of(const Real& v) {
  VT_CHECK(mpfr_number_p(v.get()) != 0, "the bound is infinite or the interval is empty");
  if (mpfr_zero_p(v.get())) return Rational();
  mpz_t z;
  mpz_init(z);
  const mpfr_exp_t exponent = mpfr_get_z_2exp(z, v.get());
  Integer mantissa = Integer::from_limbs(mpz_limbs_read(z), mpz_size(z), mpz_sgn(z) < 0);
  mpz_clear(z);
  return Rational(std::move(mantissa)) * Rational::power_of_two(exponent);
}

// sign of v - x.
int order(const Real& v, const Rational& x) {
  if (mpfr_inf_p(v.get())) return mpfr_sgn(v.get());
  const Rational exact = rational_of(v);
  return exact < x ? -1 : (x < exact ? 1 : 0);
}

// An integer as MPFR takes it.
class MpzOf {
 public:
  explicit MpzOf(const Integer& a) : limbs_(a.limbs()) {
    const auto size = static_cast<mp_size_t>(limbs_.size());
    mpz_roinit_n(z_, limbs_.data(), a.sign() == Sign::kNegative ? -size : size);
  }
  MpzOf(const MpzOf&) = delete;
  mpz_srcptr get() const { return z_; }

 private:
  std::vector<std::uint64_t> limbs_;
  mpz_t z_;
};

void divide_rational(Real& out, const Rational& x, mpfr_rnd_t direction) {
  const MpzOf n(x.numerator()), d(x.denominator());
  // An exact numerator, so that the division rounds once.
  Real numerator(std::max<mpfr_prec_t>(2, static_cast<mpfr_prec_t>(x.numerator().bit_length())));
  mpfr_set_z(numerator.get(), n.get(), MPFR_RNDN);
  mpfr_div_z(out.get(), numerator.get(), d.get(), direction);
}

// q = floor(x / (pi / 2)), exactly. Only 0 is a multiple of pi / 2, so that enough bits of pi decide.
void quarter_of(mpfr_ptr q, const Real& x) {
  const mpfr_exp_t exponent = mpfr_zero_p(x.get()) != 0 ? 0 : mpfr_get_exp(x.get());
  const mpfr_prec_t integer_bits = std::max<mpfr_exp_t>(2, exponent + 2);
  mpfr_set_prec(q, integer_bits);
  if (mpfr_zero_p(x.get()) != 0) return static_cast<void>(mpfr_set_zero(q, 1));
  Real other(integer_bits);
  for (mpfr_prec_t precision = integer_bits + 64;; precision *= 2) {
    Real half_pi(precision), low(precision), high(precision);
    // A larger divisor makes a positive quotient smaller and a negative one larger.
    const bool is_negative = mpfr_sgn(x.get()) < 0;
    mpfr_const_pi(half_pi.get(), is_negative ? MPFR_RNDD : MPFR_RNDU);
    mpfr_div_2ui(half_pi.get(), half_pi.get(), 1, MPFR_RNDN);
    mpfr_div(low.get(), x.get(), half_pi.get(), MPFR_RNDD);
    mpfr_const_pi(half_pi.get(), is_negative ? MPFR_RNDU : MPFR_RNDD);
    mpfr_div_2ui(half_pi.get(), half_pi.get(), 1, MPFR_RNDN);
    mpfr_div(high.get(), x.get(), half_pi.get(), MPFR_RNDU);
    mpfr_rint_floor(q, low.get(), MPFR_RNDN);
    mpfr_rint_floor(other.get(), high.get(), MPFR_RNDN);
    if (mpfr_equal_p(q, other.get()) != 0) return;
  }
}

// The range of a function that oscillates between -1 and 1, and reaches these at the starts of the quarters `bottom`
// and `top` (mod 4) of a turn.
std::unique_ptr<Bounds> wave(internal::RealFunction f, const Bounds& x, unsigned top,
                             unsigned bottom) {
  auto out = std::make_unique<Bounds>(x.precision());
  if (x.is_empty()) return out->make_empty(), std::move(out);
  const internal::MpfrScope environment;
  bool reaches_top = true, reaches_bottom = true;
  if (mpfr_number_p(x.lo.get()) != 0 && mpfr_number_p(x.hi.get()) != 0) {
    Real from, to;
    quarter_of(from.get(), x.lo);
    quarter_of(to.get(), x.hi);
    Real turn(mpfr_prec_t{64}), passed(mpfr_prec_t{64});
    mpfr_sub(passed.get(), to.get(), from.get(), MPFR_RNDU);
    const bool turns = mpfr_cmp_ui(passed.get(), 4) >= 0;
    const auto num_passed = turns ? 4 : mpfr_get_ui(passed.get(), MPFR_RNDN);
    mpfr_set_ui(turn.get(), 4, MPFR_RNDN);
    mpfr_fmod(turn.get(), from.get(), turn.get(), MPFR_RNDN);
    const auto start = static_cast<unsigned>(mpfr_get_si(turn.get(), MPFR_RNDN) + 4);
    // Which quarters start after the lower bound, and not after the upper one?
    reaches_top = (top + 8 - start % 4 - 1) % 4 < num_passed;
    reaches_bottom = (bottom + 8 - start % 4 - 1) % 4 < num_passed;
  }
  Real other(mpfr_prec_t{x.precision()});
  mpfr_set_si(out->lo.get(), -1, MPFR_RNDN);
  mpfr_set_si(out->hi.get(), 1, MPFR_RNDN);
  if (!reaches_bottom) {
    f(out->lo.get(), x.lo.get(), MPFR_RNDD);
    f(other.get(), x.hi.get(), MPFR_RNDD);
    take(out->lo, other, false, true);
  }
  if (!reaches_top) {
    f(out->hi.get(), x.lo.get(), MPFR_RNDU);
    f(other.get(), x.hi.get(), MPFR_RNDU);
    take(out->hi, other, false, false);
  }
  return out;
}

}  // namespace

MpInterval::MpInterval(std::unique_ptr<Bounds> bounds) : bounds_(std::move(bounds)) {}
MpInterval::MpInterval(int precision) : bounds_(std::make_unique<Bounds>(checked(precision))) {}
MpInterval::MpInterval(const Interval& x, int precision) : MpInterval(precision) {
  if (x.is_empty()) {
    bounds_->make_empty();
    return;
  }
  const internal::MpfrScope environment;
  mpfr_set_d(bounds_->lo.get(), x.lo(), MPFR_RNDD);
  mpfr_set_d(bounds_->hi.get(), x.hi(), MPFR_RNDU);
}
MpInterval::MpInterval(const Rational& x, int precision) : MpInterval(precision) {
  divide_rational(bounds_->lo, x, MPFR_RNDD);
  divide_rational(bounds_->hi, x, MPFR_RNDU);
}
MpInterval::MpInterval(const MpInterval& other) : MpInterval(other.precision()) {
  mpfr_set(bounds_->lo.get(), other.bounds_->lo.get(), MPFR_RNDN);
  mpfr_set(bounds_->hi.get(), other.bounds_->hi.get(), MPFR_RNDN);
}
MpInterval::MpInterval(MpInterval&& other) noexcept = default;
MpInterval& MpInterval::operator=(const MpInterval& other) { return *this = MpInterval(other); }
MpInterval& MpInterval::operator=(MpInterval&& other) noexcept = default;
MpInterval::~MpInterval() = default;
MpInterval MpInterval::empty(int precision) {
  MpInterval out(precision);
  out.bounds_->make_empty();
  return out;
}

int MpInterval::precision() const { return bounds_->precision(); }
bool MpInterval::is_empty() const { return bounds_->is_empty(); }
Rational MpInterval::lo() const { return rational_of(bounds_->lo); }
Rational MpInterval::hi() const { return rational_of(bounds_->hi); }
bool MpInterval::has_lo() const { return mpfr_number_p(bounds_->lo.get()) != 0; }
bool MpInterval::has_hi() const { return mpfr_number_p(bounds_->hi.get()) != 0; }

MpInterval operator-(const MpInterval& a) {
  MpInterval out(a.precision());
  mpfr_neg(out.bounds_->lo.get(), a.bounds_->hi.get(), MPFR_RNDN);
  mpfr_neg(out.bounds_->hi.get(), a.bounds_->lo.get(), MPFR_RNDN);
  return out;
}
MpInterval operator+(const MpInterval& a, const MpInterval& b) {
  auto out = result(*a.bounds_, *b.bounds_);
  mpfr_add(out->lo.get(), a.bounds_->lo.get(), b.bounds_->lo.get(), MPFR_RNDD);
  mpfr_add(out->hi.get(), a.bounds_->hi.get(), b.bounds_->hi.get(), MPFR_RNDU);
  return MpInterval(std::move(out));
}
MpInterval operator-(const MpInterval& a, const MpInterval& b) { return a + -b; }

MpInterval operator*(const MpInterval& a, const MpInterval& b) {
  auto out = result(*a.bounds_, *b.bounds_);
  if (a.is_empty() || b.is_empty()) return MpInterval::empty(out->precision());
  Real product(mpfr_prec_t{out->precision()});
  bool first = true;
  for (const Real* x : {&a.bounds_->lo, &a.bounds_->hi})
    for (const Real* y : {&b.bounds_->lo, &b.bounds_->hi}) {
      mpfr_mul(product.get(), x->get(), y->get(), MPFR_RNDD);
      take(out->lo, product, first, true);
      mpfr_mul(product.get(), x->get(), y->get(), MPFR_RNDU);
      take(out->hi, product, first, false);
      first = false;
    }
  return MpInterval(std::move(out));
}

MpInterval operator/(const MpInterval& a, const MpInterval& b) {
  const Bounds &n = *a.bounds_, &d = *b.bounds_;
  auto out = result(n, d);
  if (a.is_empty() || b.is_empty() || b.sign() == Sign3::kZero)
    return MpInterval::empty(out->precision());
  if (d.sign_hi() <= 0) return -a / -b;
  if (d.sign_lo() < 0) {
    if (a.sign() != Sign3::kZero) out->make_entire();
    return MpInterval(std::move(out));
  }
  // 0 <= d.lo, 0 < d.hi. Positive / 0 is an infinite bound; the sign of MPFR's zero must be plus.
  Real near(mpfr_prec_t{d.precision()});
  mpfr_abs(near.get(), d.lo.get(), MPFR_RNDN);
  mpfr_div(out->lo.get(), n.lo.get(), (n.sign_lo() < 0 ? near : d.hi).get(), MPFR_RNDD);
  mpfr_div(out->hi.get(), n.hi.get(), (n.sign_hi() > 0 ? near : d.hi).get(), MPFR_RNDU);
  return MpInterval(std::move(out));
}

MpInterval sqr(const MpInterval& a) { return pown(a, 2); }

MpInterval sqrt(const MpInterval& a) {
  if (a.is_empty() || a.bounds_->sign_hi() < 0) return MpInterval::empty(a.precision());
  MpInterval out(a.precision());
  if (a.bounds_->sign_lo() > 0) mpfr_sqrt(out.bounds_->lo.get(), a.bounds_->lo.get(), MPFR_RNDD);
  mpfr_sqrt(out.bounds_->hi.get(), a.bounds_->hi.get(), MPFR_RNDU);
  return out;
}

MpInterval pown(const MpInterval& a, std::int64_t n) {
  if (a.is_empty()) return a;
  if (n < 0) {
    VT_CHECK(n != INT64_MIN, "exponent of pown");
    return MpInterval(Rational(1), a.precision()) / pown(a, -n);
  }
  if (n == 0) return MpInterval(Rational(1), a.precision());
  MpInterval out(a.precision());
  const Real *low = &a.bounds_->lo, *high = &a.bounds_->hi;
  const bool even = n % 2 == 0;
  // For even n the power is that of |x|.
  if (even && a.bounds_->sign_hi() <= 0) std::swap(low, high);
  const bool both = even && a.bounds_->sign_lo() < 0 && a.bounds_->sign_hi() > 0;
  if (both && mpfr_cmpabs(low->get(), high->get()) > 0) high = low;
  if (!both) mpfr_pow_si(out.bounds_->lo.get(), low->get(), n, MPFR_RNDD);
  mpfr_pow_si(out.bounds_->hi.get(), high->get(), n, MPFR_RNDU);
  return out;
}

MpInterval pow(const MpInterval& a, const MpInterval& b) {
  auto out = result(*a.bounds_, *b.bounds_);
  const Bounds &base = *a.bounds_, &exponent = *b.bounds_;
  if (a.is_empty() || b.is_empty() || base.sign_hi() < 0)
    return MpInterval::empty(out->precision());
  if (base.sign_hi() == 0) {  // only 0 is left of the base
    if (exponent.sign_hi() <= 0) out->make_empty();
    return MpInterval(std::move(out));
  }
  // The logarithm of x^y is bilinear in (log x, y): its extremes lie at corners. MPFR's powers of 0 and
  // infinity are the limits.
  Real least(mpfr_prec_t{base.precision()}), power(mpfr_prec_t{out->precision()});
  if (base.sign_lo() > 0) mpfr_set(least.get(), base.lo.get(), MPFR_RNDN);
  if (base.sign_lo() <= 0) mpfr_set_zero(least.get(), 1);
  bool first = true;
  const Real* const bases[] = {&least, &base.hi};
  for (const Real* x : bases)
    for (const Real* y : {&exponent.lo, &exponent.hi}) {
      mpfr_pow(power.get(), x->get(), y->get(), MPFR_RNDD);
      take(out->lo, power, first, true);
      mpfr_pow(power.get(), x->get(), y->get(), MPFR_RNDU);
      take(out->hi, power, first, false);
      first = false;
    }
  return MpInterval(std::move(out));
}

MpInterval exp(const MpInterval& a) {
  MpInterval out(a.precision());
  const internal::MpfrScope environment;
  mpfr_exp(out.bounds_->lo.get(), a.bounds_->lo.get(), MPFR_RNDD);
  mpfr_exp(out.bounds_->hi.get(), a.bounds_->hi.get(), MPFR_RNDU);
  return out;
}

MpInterval sin(const MpInterval& a) { return MpInterval(wave(mpfr_sin, *a.bounds_, 1, 3)); }
MpInterval cos(const MpInterval& a) { return MpInterval(wave(mpfr_cos, *a.bounds_, 0, 2)); }

MpInterval abs(const MpInterval& a) {
  if (a.is_empty() || a.bounds_->sign_lo() >= 0) return a;
  if (a.bounds_->sign_hi() <= 0) return -a;
  MpInterval out(a.precision());
  const Bounds& x = *a.bounds_;
  mpfr_abs(out.bounds_->hi.get(), (mpfr_cmpabs(x.lo.get(), x.hi.get()) > 0 ? x.lo : x.hi).get(),
           MPFR_RNDN);
  return out;
}
MpInterval min(const MpInterval& a, const MpInterval& b) {
  auto out = result(*a.bounds_, *b.bounds_);
  if (a.is_empty() || b.is_empty()) return MpInterval::empty(out->precision());
  mpfr_min(out->lo.get(), a.bounds_->lo.get(), b.bounds_->lo.get(), MPFR_RNDN);
  mpfr_min(out->hi.get(), a.bounds_->hi.get(), b.bounds_->hi.get(), MPFR_RNDN);
  return MpInterval(std::move(out));
}
MpInterval max(const MpInterval& a, const MpInterval& b) { return -min(-a, -b); }

MpInterval MpInterval::pi(int precision) {
  MpInterval out(precision);
  const internal::MpfrScope environment;
  mpfr_const_pi(out.bounds_->lo.get(), MPFR_RNDD);
  mpfr_const_pi(out.bounds_->hi.get(), MPFR_RNDU);
  return out;
}

bool operator==(const MpInterval& a, const MpInterval& b) {
  if (a.is_empty() || b.is_empty()) return a.is_empty() && b.is_empty();
  return mpfr_equal_p(a.bounds_->lo.get(), b.bounds_->lo.get()) != 0 &&
         mpfr_equal_p(a.bounds_->hi.get(), b.bounds_->hi.get()) != 0;
}
bool is_subset(const MpInterval& a, const MpInterval& b) {
  if (a.is_empty() || b.is_empty()) return a.is_empty();
  return mpfr_lessequal_p(b.bounds_->lo.get(), a.bounds_->lo.get()) != 0 &&
         mpfr_lessequal_p(a.bounds_->hi.get(), b.bounds_->hi.get()) != 0;
}
MpInterval intersection(const MpInterval& a, const MpInterval& b) {
  auto out = result(*a.bounds_, *b.bounds_);
  if (a.is_empty() || b.is_empty()) return MpInterval::empty(out->precision());
  mpfr_max(out->lo.get(), a.bounds_->lo.get(), b.bounds_->lo.get(), MPFR_RNDN);
  mpfr_min(out->hi.get(), a.bounds_->hi.get(), b.bounds_->hi.get(), MPFR_RNDN);
  if (mpfr_less_p(out->hi.get(), out->lo.get()) != 0) out->make_empty();
  return MpInterval(std::move(out));
}
MpInterval hull(const MpInterval& a, const MpInterval& b) {
  auto out = result(*a.bounds_, *b.bounds_);  // MPFR's min and max ignore one NaN operand
  mpfr_min(out->lo.get(), a.bounds_->lo.get(), b.bounds_->lo.get(), MPFR_RNDN);
  mpfr_max(out->hi.get(), a.bounds_->hi.get(), b.bounds_->hi.get(), MPFR_RNDN);
  return MpInterval(std::move(out));
}
Sign3 compare(const MpInterval& a, const MpInterval& b) {
  if (a.is_empty() || b.is_empty()) return Sign3::kUncertain;
  if (mpfr_less_p(a.bounds_->hi.get(), b.bounds_->lo.get()) != 0) return Sign3::kNegative;
  if (mpfr_less_p(b.bounds_->hi.get(), a.bounds_->lo.get()) != 0) return Sign3::kPositive;
  const bool point = mpfr_equal_p(a.bounds_->lo.get(), a.bounds_->hi.get()) != 0;
  return point && a == b ? Sign3::kZero : Sign3::kUncertain;
}
bool contains(const MpInterval& a, const Rational& x) {
  return !a.is_empty() && order(a.bounds_->lo, x) <= 0 && order(a.bounds_->hi, x) >= 0;
}

std::optional<std::int64_t> nearest_multiple(const MpInterval& a, int exponent) {
  if (!a.has_lo() || !a.has_hi()) return std::nullopt;
  const mpfr_prec_t bits = std::max(a.precision(), 64);  // a longer number is an integer already
  Real lo(bits), hi(bits);
  mpfr_mul_2si(lo.get(), a.bounds_->lo.get(), -exponent, MPFR_RNDN);
  mpfr_mul_2si(hi.get(), a.bounds_->hi.get(), -exponent, MPFR_RNDN);
  mpfr_roundeven(lo.get(), lo.get());
  mpfr_roundeven(hi.get(), hi.get());
  if (mpfr_equal_p(lo.get(), hi.get()) == 0 || mpfr_fits_slong_p(lo.get(), MPFR_RNDN) == 0)
    return std::nullopt;
  return mpfr_get_si(lo.get(), MPFR_RNDN);
}

Sign3 MpInterval::sign() const {
  if (is_empty()) return Sign3::kUncertain;
  if (bounds_->sign_lo() > 0) return Sign3::kPositive;
  if (bounds_->sign_hi() < 0) return Sign3::kNegative;
  return bounds_->sign_lo() == 0 && bounds_->sign_hi() == 0 ? Sign3::kZero : Sign3::kUncertain;
}

Interval MpInterval::to_interval() const {
  if (is_empty()) return Interval::empty();
  const internal::MpfrScope environment;
  return Interval::from_bounds(bounds_->lo.round(MPFR_RNDD), bounds_->hi.round(MPFR_RNDU));
}

}  // namespace veritope
