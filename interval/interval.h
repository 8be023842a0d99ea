// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/interval.h: sets of reals between two binary64 bounds. Held as (-lo, hi), so that
// rounding upward widens both ends.
#pragma once
#include <string>

#include "interval/upward.h"
#include "robust/base/sign.h"
#include "robust/rational.h"

namespace veritope {

/// [lo, hi] = { x real : lo <= x <= hi }; never empty, never NaN; lo may be -infinity and hi
/// +infinity. Operations enclose: x in a, y in b implies x op y in a op b, overflow and underflow
/// included; each bound of +, -, * and sqr is the nearest binary64 number outside.
/// REQUIRES for every arithmetic operation a live ScopedUpward in this thread.
class Interval {
 public:
  constexpr Interval() = default;
  /// The one point v. REQUIRES finite.
  constexpr explicit Interval(double v) : neg_lo_(-v), hi_(v) {}
  /// REQUIRES lo <= hi, lo < +infinity, hi > -infinity.
  static constexpr Interval from_bounds(double lo, double hi) { return Interval(-lo, hi); }

  constexpr double lo() const { return -neg_lo_; }
  constexpr double hi() const { return hi_; }

  friend Interval operator-(const Interval& a) { return Interval(a.hi_, a.neg_lo_); }
  friend Interval operator+(const Interval& a, const Interval& b) {
    return Interval(fenced(fenced(a.neg_lo_) + b.neg_lo_), fenced(fenced(a.hi_) + b.hi_));
  }
  friend Interval operator-(const Interval& a, const Interval& b) {
    return Interval(fenced(fenced(a.neg_lo_) + b.hi_), fenced(fenced(a.hi_) + b.neg_lo_));
  }
  friend Interval operator*(const Interval& a, const Interval& b) {
    // All fenced, the negations too: compilers rewrite (-p) * q into -(p * q), which rounds the
    // other way.
    const double an = fenced(a.neg_lo_), ah = fenced(a.hi_), al = fenced(-an), am = fenced(-ah);
    const double bn = fenced(b.neg_lo_), bh = fenced(b.hi_);
    return Interval(fenced(largest(an * bh, ah * bn, al * bn, am * bh)),
                    fenced(largest(an * bn, ah * bh, al * bh, am * bn)));
  }
  /// { x^2 : x in a }, tighter than a * a when a contains numbers of both signs.
  friend Interval sqr(const Interval& a) {
    const double an = fenced(a.neg_lo_), ah = fenced(a.hi_);
    const double far = an > ah ? an : ah;                           // max |x|
    const double near = fenced(an < 0 ? -an : (ah < 0 ? -ah : 0));  // min |x|
    return Interval(fenced(fenced(-near) * near), fenced(far * far));
  }

  /// The sign that all members have, or uncertain.
  constexpr Sign3 sign() const {
    if (neg_lo_ < 0) return Sign3::kPositive;
    if (hi_ < 0) return Sign3::kNegative;
    return neg_lo_ == 0 && hi_ == 0 ? Sign3::kZero : Sign3::kUncertain;
  }

 private:
  constexpr Interval(double neg_lo, double hi) : neg_lo_(neg_lo), hi_(hi) {}
  // 0 * infinity is NaN; the set it stands for is {0}, and one of the other products, or 0, covers
  // it: each comparison with NaN is false and drops it.
  static double largest(double p, double q, double r, double s) {
    double m = p == p ? p : 0;
    m = q > m ? q : m;
    m = r > m ? r : m;
    return s > m ? s : m;
  }

  double neg_lo_ = 0;
  double hi_ = 0;
};

inline Sign3 sign_of(const Interval& a) { return a.sign(); }

/// Is x a member?
bool contains(const Interval& a, const Rational& x);
/// The narrowest interval around x.
Interval enclose(const Rational& x);
/// "[lo, hi]" with 17 digits each: enough to read the same bounds back.
std::string to_string(const Interval& a);

}  // namespace veritope
