// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/separator_search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace veritope {
namespace {

// Coefficients are rounded to 2^-kBits where the values on both sides are 1 and -1.
constexpr int kBits = 8;
// What of 1 has to be left at every point.
constexpr double kClear = 0.25;

// Calls use(monomial) in the order of a separator's coefficients.
template <typename Use>
void for_each_monomial(const SheetSeparator& q, const Point3d& x, Use use) {
  Point3d y;
  for (std::size_t k = 0; k < 3; ++k) y[k] = (x[k] - q.origin[k]) / q.unit;
  double pa = 1;
  for (int a = 0; a <= q.degree; ++a, pa *= y[0]) {
    double pb = pa;
    for (int b = 0; a + b <= q.degree; ++b, pb *= y[1]) {
      double pc = pb;
      for (int c = 0; a + b + c <= q.degree; ++c, pc *= y[2]) use(pc);
    }
  }
}

double value(const SheetSeparator& q, const Point3d& x) {
  double sum = 0;
  std::size_t i = 0;
  for_each_monomial(q, x, [&](double m) { sum += m * static_cast<double>(q.coefficients[i++]); });
  return std::ldexp(sum, -kBits);
}

// The least of sign * value over the points.
double least_value(const SheetSeparator& q, const std::vector<Point3d>& points, double sign) {
  double out = std::numeric_limits<double>::infinity();
  for (const Point3d& x : points) out = std::min(out, sign * value(q, x));
  return out;
}

bool fit(const std::vector<Point3d>& above, const std::vector<Point3d>& below, SheetSeparator* q) {
  const auto columns = static_cast<Eigen::Index>(SheetSeparator::num_coefficients(q->degree));
  const auto rows = static_cast<Eigen::Index>(above.size() + below.size());
  Eigen::MatrixXd matrix(rows, columns);
  Eigen::VectorXd wanted(rows);
  Eigen::Index row = 0;
  for (const auto* const set : {&above, &below})
    for (const Point3d& x : *set) {
      Eigen::Index column = 0;
      for_each_monomial(*q, x, [&](double m) { matrix(row, column++) = m; });
      wanted(row++) = set == &above ? 1 : -1;
    }
  const Eigen::VectorXd solution = matrix.completeOrthogonalDecomposition().solve(wanted);
  q->coefficients.clear();
  for (Eigen::Index i = 0; i < columns; ++i) {
    const double c = std::nearbyint(std::ldexp(solution(i), kBits));
    if (!(std::abs(c) < static_cast<double>(SheetSeparator::kCoefficientLimit))) return false;
    q->coefficients.push_back(static_cast<std::int64_t>(c));
  }
  return true;
}

}  // namespace

std::optional<SheetSeparator> find_separator(const std::vector<Point3d>& above,
                                             const std::vector<Point3d>& below,
                                             const Point3d& origin, double unit) {
  SheetSeparator q;
  q.origin = origin, q.unit = unit;
  for (q.degree = 1; q.degree <= SheetSeparator::kMostDegree; ++q.degree)
    if (fit(above, below, &q) && least_value(q, above, 1) > kClear &&
        least_value(q, below, -1) > kClear)
      return q;
  return std::nullopt;
}

Sign common_sign(const SheetSeparator& separator, const std::vector<Point3d>& points) {
  if (least_value(separator, points, 1) > kClear / 2) return Sign::kPositive;
  if (least_value(separator, points, -1) > kClear / 2) return Sign::kNegative;
  return Sign::kZero;
}

}  // namespace veritope
