// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fast/dms_inverse_internal.h"
#include "splines/dms_spline.h"

namespace veritope::internal {
namespace {

double binomial(int n, int k) {
  double out = 1;
  for (int i = 1; i <= k; ++i) out = out * (n - k + i) / i;
  return out;
}

// The difference of order index[k] along the edges from corner 0 to corner k, k = 1, 2, 3.
double difference_of(const std::vector<double>& b, const TetrahedralIndex& index) {
  double sum = 0;
  for (int i = 0; i <= index[1]; ++i)
    for (int j = 0; j <= index[2]; ++j)
      for (int k = 0; k <= index[3]; ++k) {
        const int lower = index[1] - i + index[2] - j + index[3] - k;
        const double ways = binomial(index[1], i) * binomial(index[2], j) * binomial(index[3], k);
        sum += (lower % 2 == 0 ? ways : -ways) * b[tetrahedral_index({index[0] + lower, i, j, k})];
      }
  return sum;
}

}  // namespace

std::vector<double> monomials_of(int degree, const std::vector<double>& coefficients) {
  std::vector<double> out;
  for_each_tetrahedral_index(degree, [&](const TetrahedralIndex& index) {
    const int x = index[1], y = index[2], z = index[3];
    const double ways = binomial(degree, x) * binomial(degree - x, y) * binomial(degree - x - y, z);
    out.push_back(ways * difference_of(coefficients, index));
  });
  return out;
}

}  // namespace veritope::internal
