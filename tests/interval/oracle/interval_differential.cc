// SPDX-License-Identifier: LGPL-3.0-or-later
// Other authors' intervals on random operands of all exponents: MPFI with 53 bits gives the same
// bounds after its result is rounded outward to binary64, Boost.Interval on bounded operands.
#include <gtest/gtest.h>
#include <mpfi.h>

#include <boost/numeric/interval.hpp>
#include <limits>

#include "interval/functions.h"
#include "interval/relations.h"
#include "tests/interval/draw.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

// 53 bits and a larger range of exponents: rounding once more, to binary64, is harmless in the same
// direction.
class Mpfi {
 public:
  Mpfi() { mpfi_init2(v_, 53); }
  explicit Mpfi(const Interval& a) : Mpfi() { mpfi_interv_d(v_, a.lo(), a.hi()); }
  Mpfi(const Mpfi&) = delete;
  Mpfi& operator=(const Mpfi&) = delete;
  ~Mpfi() { mpfi_clear(v_); }
  mpfi_ptr get() { return v_; }
  // NaN where MPFI says that nothing, or not everything, is defined.
  bool is_nan() const { return mpfi_nan_p(v_) != 0; }
  Interval interval() const {
    return Interval::from_bounds(mpfr_get_d(&v_->left, MPFR_RNDD),
                                 mpfr_get_d(&v_->right, MPFR_RNDU));
  }

 private:
  mpfi_t v_;
};

template <typename F>
Interval upward(F f) {
  const ScopedUpward scope;
  return f();
}

TEST(IntervalOracle, MpfiGivesTheSameBoundsOfArithmetic) {
  Random random(91);
  for (long i = 0; i < scaled(200000); ++i) {
    const Interval a = draw_interval(random), b = draw_interval(random);
    Mpfi x(a), y(b), r;
    const auto expect = [&](const char* name, const Interval& got) {
      ASSERT_FALSE(r.is_nan()) << name << to_string(a) << to_string(b);
      ASSERT_EQ(got, r.interval()) << name << to_string(a) << to_string(b) << to_string(got);
    };
    mpfi_add(r.get(), x.get(), y.get());
    expect("+", upward([&] { return a + b; }));
    mpfi_sub(r.get(), x.get(), y.get());
    expect("-", upward([&] { return a - b; }));
    mpfi_mul(r.get(), x.get(), y.get());
    expect("*", upward([&] { return a * b; }));
    mpfi_sqr(r.get(), x.get());
    expect("sqr", upward([&] { return sqr(a); }));
    if (!is_member(0, b)) {
      mpfi_div(r.get(), x.get(), y.get());
      expect("/", upward([&] { return a / b; }));
      mpfi_inv(r.get(), y.get());
      expect("recip", upward([&] { return recip(b); }));
    }
    if (!internal::less(a.lo(), 0)) {
      mpfi_sqrt(r.get(), x.get());
      expect("sqrt", upward([&] { return sqrt(a); }));
    }
    if (HasFatalFailure()) FAIL() << i;
  }
}

TEST(IntervalOracle, MpfiGivesTheSameBoundsOfElementaryFunctions) {
  using Theirs = int (*)(mpfi_ptr, mpfi_srcptr);
  using Ours = Interval (*)(const Interval&);
  const struct {
    const char* name;
    Theirs theirs;
    Ours ours;
  } functions[] = {
      {"exp", mpfi_exp, exp},       {"exp2", mpfi_exp2, exp2},    {"expm1", mpfi_expm1, expm1},
      {"sin", mpfi_sin, sin},       {"cos", mpfi_cos, cos},       {"tan", mpfi_tan, tan},
      {"atan", mpfi_atan, atan},    {"sinh", mpfi_sinh, sinh},    {"cosh", mpfi_cosh, cosh},
      {"tanh", mpfi_tanh, tanh},    {"asinh", mpfi_asinh, asinh}, {"cbrt", mpfi_cbrt, cbrt},
      {"log", mpfi_log, log},       {"log2", mpfi_log2, log2},    {"log10", mpfi_log10, log10},
      {"logp1", mpfi_log1p, logp1}, {"asin", mpfi_asin, asin},    {"acos", mpfi_acos, acos},
      {"acosh", mpfi_acosh, acosh}, {"atanh", mpfi_atanh, atanh}, {"sech", mpfi_sech, sech},
  };
  Random random(92);
  int compared = 0;
  for (long i = 0; i < scaled(3000); ++i) {
    const Interval a = draw_interval(random);
    for (const auto& f : functions) {
      Mpfi x(a), r;
      f.theirs(r.get(), x.get());
      if (r.is_nan()) continue;
      const Interval got = f.ours(a);
      // Ours may be narrower on arguments that leave the domain; never on others.
      ASSERT_TRUE(is_subset(got, r.interval()))
          << f.name << to_string(a) << to_string(got) << to_string(r.interval());
      if (is_common(got)) {
        ASSERT_EQ(got, r.interval()) << f.name << to_string(a);
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, 30000);
}

TEST(IntervalOracle, AnotherUserOfMpfrInTheThreadDoesNotDisturb) {
  EXPECT_NE(mpfr_buildopt_tls_p(), 0) << "MPFR without thread-local state";
  const mpfr_exp_t least = mpfr_get_emin(), most = mpfr_get_emax();
  const Interval expected = exp(Interval(200.0)), quarter = cos(Interval(0x1p500));
  mpfr_set_emin(-20);
  mpfr_set_emax(20);
  const Interval got = exp(Interval(200.0)), far = cos(Interval(0x1p500));
  EXPECT_EQ(mpfr_get_emin(), -20);
  EXPECT_EQ(mpfr_get_emax(), 20);
  mpfr_set_emin(least);
  mpfr_set_emax(most);
  EXPECT_EQ(got, expected);
  EXPECT_EQ(far, quarter);
}

namespace bi = boost::numeric;
namespace il = boost::numeric::interval_lib;
// Its default rounding, which sets the mode for each operation; no exceptions.
using Boost = bi::interval<
    double, il::policies<il::save_state<il::rounded_arith_std<double>>, il::checking_base<double>>>;

TEST(IntervalOracle, BoostAgreesOnBoundedOperands) {
  Random random(93);
  int agreed = 0;
  for (long i = 0; i < scaled(200000); ++i) {
    const Interval a = draw_interval(random), b = draw_interval(random);
    if (!is_common(a) || !is_common(b)) continue;
    const Boost x(a.lo(), a.hi()), y(b.lo(), b.hi());
    const Interval sum = upward([&] { return a + b; }), difference = upward([&] { return a - b; }),
                   product = upward([&] { return a * b; }), square = upward([&] { return sqr(a); });
    const Boost s = x + y, d = x - y, p = x * y, q = bi::square(x);
    const auto same = [&](const Interval& got, const Boost& want) {
      ASSERT_EQ(got, Interval::from_bounds(want.lower(), want.upper()))
          << i << to_string(a) << to_string(b);
    };
    same(sum, s), same(difference, d), same(product, p), same(square, q);
    if (HasFatalFailure()) FAIL() << i;
    ++agreed;
  }
  EXPECT_GT(agreed, 100000);
}

}  // namespace
}  // namespace veritope
