// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/principal_axes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace veritope {
namespace {

constexpr int kMostSweeps = 32;
using Matrix3 = std::array<std::array<double, 3>, 3>;

// Makes a[p][q] zero; the columns of v turn along.
void rotate(Matrix3& a, Matrix3& v, std::size_t p, std::size_t q) {
  if (a[p][q] == 0) return;
  const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = a[k][p], y = a[k][q];
    a[k][p] = c * x - s * y;
    a[k][q] = s * x + c * y;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = a[p][k], y = a[q][k];
    a[p][k] = c * x - s * y;
    a[q][k] = s * x + c * y;
  }
  a[p][q] = a[q][p] = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = v[k][p], y = v[k][q];
    v[k][p] = c * x - s * y;
    v[k][q] = s * x + c * y;
  }
}

}  // namespace

bool PrincipalAxes::has_first() const {
  const double most = std::max(std::abs(values[0]), std::abs(values[2]));
  return values[0] - values[1] > 0x1p-30 * most;
}

PrincipalAxes approx_principal_axes(const SymmetricTensor& tensor) {
  const double most = std::abs(*std::max_element(
      tensor.begin(), tensor.end(), [](double x, double y) { return std::abs(x) < std::abs(y); }));
  int exponent = 0;
  std::frexp(most, &exponent);
  std::array<double, 6> t = tensor;
  for (double& x : t) x = std::ldexp(x, -exponent);
  Matrix3 a = {{{t[0], t[3], t[5]}, {t[3], t[1], t[4]}, {t[5], t[4], t[2]}}};
  Matrix3 v = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    const double off = std::abs(a[0][1]) + std::abs(a[1][2]) + std::abs(a[0][2]);
    if (off < 0x1p-70) break;
    rotate(a, v, 0, 1);
    rotate(a, v, 0, 2);
    rotate(a, v, 1, 2);
  }
  std::array<std::size_t, 3> order;
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return a[i][i] > a[j][j]; });
  PrincipalAxes out;
  for (std::size_t k = 0; k < 3; ++k) {
    out.values[k] = std::ldexp(a[order[k]][order[k]], exponent);
    for (std::size_t i = 0; i < 3; ++i) out.directions[k][i] = v[i][order[k]];
  }
  return out;
}

}  // namespace veritope
