// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/enclosure/bernstein_product_internal.h: products and differences of polynomials of two variables in
// Bernstein form with interval coefficients. Scaled coefficients (times their binomials) turn products into sums
// without further factors.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "interval/interval.h"
#include "interval/ring_numbers.h"
#include "splines/bezier.h"
#include "splines/binomial.h"
#include "splines/scaled_polynomial.h"

namespace veritope::internal {

/// All operations REQUIRE a live ScopedUpward. Scaled coefficients have the signs of the coefficients, and they lie in
/// a convex cone iff the coefficients do.
class ScaledBernstein2 {
 public:
  ScaledBernstein2() = default;
  ScaledBernstein2(const Bezier<Interval, 2>& map, int component) : polynomial_{map.grid(), {}} {
    const auto [p, q] = map.degrees();
    std::size_t at = 0;
    for (int i = 0; i <= p; ++i)
      for (int j = 0; j <= q; ++j)
        polynomial_.c.push_back(map.component(component)[at++] *
                                (known_binomial<Interval>(p, i) * known_binomial<Interval>(q, j)));
  }
  std::size_t size() const { return polynomial_.c.size(); }
  const Interval& scaled(std::size_t i) const { return polynomial_.c[i]; }

  friend ScaledBernstein2 operator*(const ScaledBernstein2& a, const ScaledBernstein2& b) {
    ScaledBernstein2 out;
    const auto &x = a.polynomial_, &y = b.polynomial_;
    out.polynomial_.grid = product_grid(x.grid, y.grid);
    out.polynomial_.c.resize(out.polynomial_.grid.count());
    add_product_on_grids(x.c.data(), x.grid, y.c.data(), y.grid, out.polynomial_.c.data(),
                         out.polynomial_.grid);
    return out;
  }
  friend ScaledBernstein2 operator-(ScaledBernstein2 a, const ScaledBernstein2& b) {
    a.raise_to(b.polynomial_.grid);
    ScaledBernstein2 c = b;
    c.raise_to(a.polynomial_.grid);
    for (std::size_t i = 0; i < a.size(); ++i) a.polynomial_.c[i] -= c.polynomial_.c[i];
    return a;
  }

 private:
  // Raises the degrees to at least those of that grid: a product with 1 = (s + t)^k.
  void raise_to(const Grid<2>& grid) {
    std::array<int, 2> more{};
    for (std::size_t a = 0; a < 2; ++a)
      more[a] =
          std::max(0, static_cast<int>(grid.size[a]) - static_cast<int>(polynomial_.grid.size[a]));
    if (more == std::array<int, 2>{}) return;
    const auto count = static_cast<std::size_t>((more[0] + 1) * (more[1] + 1));
    const Bezier<Interval, 2> one(more, 1, false, std::vector<Interval>(count, Interval(1.0)));
    *this = *this * ScaledBernstein2(one, 0);
  }

  ScaledPolynomial<Interval, 2> polynomial_;
};

}  // namespace veritope::internal
