// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/reduction.h"

#include <limits>

#include "interval/bound_pair.h"
#include "robust/base/check.h"
#include "robust/binary64.h"
#include "robust/rational.h"

namespace veritope {

namespace {

// A sum of products of two numbers, including what infinities and NaN do to it.
class Sum {
 public:
  void add(double x, double y) {
    if (is_finite(x) && is_finite(y)) {
      exact_ += Rational::from_double(x) * Rational::from_double(y);
      return;
    }
    nan_ |= internal::is_nan(x) || internal::is_nan(y) || internal::order_key(x) == 0 ||
            internal::order_key(y) == 0;
    const bool negative = (internal::order_key(x) < 0) != (internal::order_key(y) < 0);
    (negative ? below_ : above_) = true;
  }
  double nearest() const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (nan_ || (above_ && below_)) return std::numeric_limits<double>::quiet_NaN();
    if (above_ || below_) return above_ ? infinity : -infinity;
    return nearest_double(exact_);
  }

 private:
  Rational exact_;
  bool nan_ = false, above_ = false, below_ = false;
};

double magnitude(double v) { return internal::order_key(v) < 0 ? internal::negated(v) : v; }

}  // namespace

double sum_nearest(std::span<const double> x) {
  Sum sum;
  for (double v : x) sum.add(v, 1);
  return sum.nearest();
}
double sum_abs_nearest(std::span<const double> x) {
  Sum sum;
  for (double v : x) sum.add(magnitude(v), 1);
  return sum.nearest();
}
double sum_sqr_nearest(std::span<const double> x) { return dot_nearest(x, x); }

double dot_nearest(std::span<const double> x, std::span<const double> y) {
  VT_CHECK(x.size() == y.size(), "dot_nearest of lists of different lengths");
  Sum sum;
  for (std::size_t i = 0; i < x.size(); ++i) sum.add(x[i], y[i]);
  return sum.nearest();
}

}  // namespace veritope
