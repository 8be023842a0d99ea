// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "solids/micro/inside/part_net_internal.h"
#include "splines/de_casteljau.h"
#include "splines/lines.h"

namespace veritope::internal {

namespace {

constexpr std::size_t kMaxOrder = 16;  // degrees to 15

Interval in_unit(const Interval& t) { return intersection(t, Interval::from_bounds(0, 1)); }

// Row i: the factors of the old coefficients in coefficient i on [a, b], which are the coefficients of the polynomial
// (1 - a + a z)^(n - i) (1 - b + b z)^i in z.
class PartMatrix {
 public:
  PartMatrix(int degree, const Interval& a, const Interval& b)
      : order_(static_cast<std::size_t>(degree) + 1) {
    const std::array<Interval, 2> t{in_unit(a), in_unit(b)};
    std::array<Interval, 2> s;
    for (std::size_t k = 0; k < 2; ++k) s[k] = in_unit(Interval(1.0) - t[k]);
    for (std::size_t i = 0; i < order_; ++i) {
      Interval* const row = &rows_[i * order_];
      row[0] = Interval(1.0);
      for (std::size_t factor = 0; factor + 1 < order_; ++factor) {
        const std::size_t k = factor < order_ - 1 - i ? 0 : 1;
        row[factor + 1] = Interval::nonnegative_multiple(row[factor], t[k]);
        for (std::size_t j = factor; j > 0; --j)
          row[j] = Interval::nonnegative_multiple(row[j], s[k]) +
                   Interval::nonnegative_multiple(row[j - 1], t[k]);
        row[0] = Interval::nonnegative_multiple(row[0], s[k]);
      }
    }
  }
  void apply(Interval* first, std::size_t stride) const {
    std::array<Interval, kMaxOrder> line;
    for (std::size_t j = 0; j < order_; ++j) line[j] = first[j * stride];
    for (std::size_t i = 0; i < order_; ++i) {
      const Interval* const row = &rows_[i * order_];
      Interval sum = Interval::nonnegative_multiple(line[0], row[0]);
      for (std::size_t j = 1; j < order_; ++j)
        sum += Interval::nonnegative_multiple(line[j], row[j]);
      first[i * stride] = sum;
    }
  }

 private:
  std::size_t order_;
  std::array<Interval, kMaxOrder * kMaxOrder> rows_;
};

// What the page allows a checker: 2^-42 of the greatest coordinate for each coefficient along each axis; for a rational
// map times the spread of its weights.
double checkers_error_of(const BezierVolume<Interval>& net) {
  double size = 0, least_weight = HUGE_VAL, most_weight = 0, orders = 0;
  for (const int degree : net.degrees()) orders += degree + 1;
  for (int c = 0; c < 3; ++c)
    for (const Interval& x : net.component(c)) size = std::max(size, mag(x));
  if (!net.is_rational()) return 0x1p-42 * orders * size;
  for (const Interval& w : net.component(3)) {
    least_weight = std::min(least_weight, w.lo());
    most_weight = std::max(most_weight, w.hi());
  }
  least_weight = std::max(least_weight, 0x1p-10 * most_weight);  // parts of the map may have greater ones
  return 0x1p-41 * orders * size / least_weight * (most_weight / least_weight);
}

bool is_whole(const Interval& a, const Interval& b) { return a.hi() <= 0 && b.lo() >= 1; }

}  // namespace

PartNet::PartNet(const BezierVolume<Rational>& map)
    : net_(map.degrees(), map.num_components(), map.is_rational()) {
  VT_CHECK(map.dimension() == 3, "the map of a volume has three coordinates");
  for (const int degree : map.degrees())
    VT_CHECK(static_cast<std::size_t>(degree) < kMaxOrder, "a degree of a cage is at most 15");
  for (std::size_t i = 0; i < net_.coefficients().size(); ++i)
    net_.coefficients()[i] = enclose(map.coefficients()[i]);
  checkers_error_ = checkers_error_of(net_);
}

PartNet PartNet::part(const Box3& begin, const Box3& end) const {
  BezierVolume<Interval> out = net_;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (is_whole(begin[axis], end[axis])) continue;
    const PartMatrix matrix(out.degree(axis), begin[axis], end[axis]);
    on_lines(out, axis, [&](Interval* first, std::size_t stride) { matrix.apply(first, stride); });
  }
  return PartNet(std::move(out), checkers_error_);
}

bool PartNet::points(std::vector<Box3>* out) const {
  const std::size_t n = net_.grid().count();
  out->resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    Box3& p = (*out)[i];
    for (std::size_t c = 0; c < 3; ++c) p[c] = net_.component(static_cast<int>(c))[i];
    if (!net_.is_rational()) continue;
    const Interval& w = net_.component(3)[i];
    if (w.sign() != Sign3::kPositive) return false;
    for (std::size_t c = 0; c < 3; ++c) p[c] = p[c] / w;
  }
  return true;
}

Box3 PartNet::value(const Box3& at) const {
  std::vector<Box3> all;
  part(at, at).points(&all);
  return all.front();
}

}  // namespace veritope::internal
