// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/interval/sturm.h: how many different roots a polynomial has in an interval, by Sturm's sequence over fractions: an
// oracle that shares nothing with the solver but Rational.
#pragma once
#include <vector>

#include "robust/rational.h"

namespace veritope::sturm {

using Polynomial = std::vector<Rational>;  // coefficients of 1, x, x^2, ...

inline void trim(Polynomial& p) {
  while (!p.empty() && p.back() == Rational(0)) p.pop_back();
}
inline Rational value(const Polynomial& p, const Rational& x) {
  Rational out;
  for (std::size_t i = p.size(); i-- > 0;) out = out * x + p[i];
  return out;
}
/// -(a mod b). REQUIRES b != 0.
inline Polynomial minus_remainder(Polynomial a, const Polynomial& b) {
  while (a.size() >= b.size()) {
    const Rational f = a.back() / b.back();
    for (std::size_t i = 0; i < b.size(); ++i) a[a.size() - b.size() + i] -= f * b[i];
    a.pop_back();
    trim(a);
  }
  for (Rational& c : a) c = -c;
  return a;
}
/// The Sturm sequence of a polynomial that is not zero.
class Sequence {
 public:
  explicit Sequence(Polynomial p) {
    trim(p);
    Polynomial derivative;
    for (std::size_t i = 1; i < p.size(); ++i) derivative.push_back(Rational(i) * p[i]);
    for (chain_ = {std::move(p)}; !derivative.empty();) {
      Polynomial next = minus_remainder(chain_.back(), derivative);
      chain_.push_back(std::move(derivative));
      derivative = std::move(next);
    }
    // Divided by the last member, the greatest common divisor: the same roots, simple.
    const Polynomial divisor = chain_.back();
    for (Polynomial& q : chain_) q = quotient(std::move(q), divisor);
  }
  /// Different roots x with lo <= x <= hi.
  int count(const Rational& lo, const Rational& hi) const {
    return changes(lo) - changes(hi) + (value(chain_[0], lo) == Rational(0) ? 1 : 0);
  }

 private:
  static Polynomial quotient(Polynomial a, const Polynomial& b) {
    Polynomial out(a.size() - b.size() + 1);
    for (std::size_t k = out.size(); k-- > 0;) {
      out[k] = a[k + b.size() - 1] / b.back();
      for (std::size_t i = 0; i < b.size(); ++i) a[k + i] -= out[k] * b[i];
    }
    return out;
  }
  int changes(const Rational& x) const {
    int out = 0;
    Sign last = Sign::kZero;
    for (const Polynomial& p : chain_) {
      const Sign s = sign_of(value(p, x));
      if (s == Sign::kZero) continue;
      out += last != Sign::kZero && s != last;
      last = s;
    }
    return out;
  }
  std::vector<Polynomial> chain_;
};

}  // namespace veritope::sturm
