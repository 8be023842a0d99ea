// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/pieces/volume_remainder_internal.h: the polynomial that stands for 1 / w^3 in patch_volume.cc, and the bound
// of what it loses.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "interval/interval.h"
#include "interval/numeric.h"

namespace veritope::internal {

/// Nodes for a polynomial of degree K on [-1, 1], near the zeros of Chebyshev's T_{K+1}. std::cos is not
/// trusted: `product` bounds |(t - c_0) ... (t - c_K)| for |t| <= 1 from the nodes as they are, by the sum of its
/// coefficients' magnitudes in T_0, ..., T_{K+1} (2 t T_k = T_{k+1} + T_{|k-1|}). It is 2^-K at the zeros themselves.
struct InterpolationNodes {
  /// REQUIRES upward rounding.
  explicit InterpolationNodes(int order) {
    std::vector<Interval> sum{Interval(1.0)};
    for (int k = 0; k <= order; ++k) {
      const double c = std::cos((2 * k + 1) * std::numbers::pi / (2 * order + 2));
      nodes.push_back(std::clamp(c, -1.0, 1.0));
      sum = times_difference(sum, Interval(nodes.back()));
    }
    Interval bound;
    for (const Interval& c : sum) bound += Interval(mag(c));
    product = bound.hi();
  }

  // (t - c) times a sum of Chebyshev polynomials.
  static std::vector<Interval> times_difference(const std::vector<Interval>& sum,
                                                const Interval& c) {
    std::vector<Interval> out(sum.size() + 1);
    const Interval half(0.5);
    for (std::size_t k = 0; k < sum.size(); ++k) {
      out[k] -= c * sum[k];
      out[k + 1] += half * sum[k];
      out[k == 0 ? 1 : k - 1] += half * sum[k];
    }
    return out;
  }

  std::vector<double> nodes;
  double product = 0;
};

/// f = (1 + x)^-3 is interpolated at x_j = d c_j, j = 0 .. K. The divided differences of f are
/// (-1)^k h_2(y_0, ..., y_k) y_0 ... y_k, y_j = 1 / (1 + x_j), h_2 the sum of all C(k + 2, 2) products of two (by
/// induction on k, as for 1 / (1 + x), where h_0 = 1 stands for h_2). The error at x is the divided difference of
/// x_0, ..., x_K, x times the product of all x - x_j, which is at most d^(K + 1) times `product`, that of the nodes.
/// Since every y is at most 1 / (1 - d), it is at most  C(K + 3, 2) (1 - d)^-(K + 4) d^(K + 1) product.
/// The result times most / m^3 bounds what the mean of g / w^3 loses, |g| <= most and w = m (1 + x). It is true for
/// every d < 1; from 1/2 on it is of no use. REQUIRES upward rounding.
inline double volume_remainder(int order, double product, double d, double most,
                               const Interval& m) {
  if (!(d < 0.5)) return std::numeric_limits<double>::infinity();
  const Interval distance(d), y = Interval(1.0) / (Interval(1.0) - distance);
  Interval out((order + 3) * (order + 2) / 2.0);
  out = out * Interval(product) * Interval(most);
  out = out * distance * y * y * y * y / (m * m * m);
  for (int k = 0; k < order; ++k) out = out * distance * y;
  return out.hi();
}

}  // namespace veritope::internal
