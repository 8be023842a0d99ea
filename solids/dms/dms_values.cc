// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_values.h"

#include <algorithm>
#include <utility>

#include "splines/bezier_triangle.h"

namespace veritope {
namespace {

using Row = std::vector<Rational>;

std::vector<std::vector<int>> indices_of(int degree, std::size_t corners) {
  std::vector<std::vector<int>> out;
  if (corners == 3)
    for_each_triangle_index(degree, [&](int i, int j, int k) { out.push_back({i, j, k}); });
  else
    for_each_tetrahedral_index(degree, [&](const TetrahedralIndex& index) {
      out.emplace_back(index.begin(), index.end());
    });
  return out;
}

Rational bernstein_value(const std::vector<int>& index, const Row& shares, int degree) {
  Rational value(1);
  int left = degree;
  for (std::size_t m = 0; m < index.size(); ++m)
    for (int k = 1; k <= index[m]; ++k) value *= shares[m] * Rational(left--) / Rational(k);
  return value;
}

// REQUIRES a regular matrix.
std::vector<Row> inverse_matrix(std::vector<Row> rows) {
  const std::size_t n = rows.size();
  for (std::size_t i = 0; i < n; ++i) {
    rows[i].resize(2 * n);
    rows[i][n + i] = Rational(1);
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    while (rows[pivot][i].sign() == Sign::kZero) ++pivot;
    std::swap(rows[i], rows[pivot]);
    const Rational by = rows[i][i];
    for (Rational& x : rows[i]) x /= by;
    for (std::size_t k = 0; k < n; ++k) {
      if (k == i || rows[k][i].sign() == Sign::kZero) continue;
      const Rational factor = rows[k][i];
      for (std::size_t j = i; j < 2 * n; ++j) rows[k][j] -= factor * rows[i][j];
    }
  }
  for (Row& row : rows) row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(n));
  return rows;
}

}  // namespace

SimplexInterpolation::SimplexInterpolation(int degree, std::size_t corners) {
  const auto indices = indices_of(degree, corners);
  const Rational whole(degree + static_cast<int>(corners));
  for (const auto& index : indices) {
    Row shares;
    for (const int i : index) shares.push_back(Rational(i + 1) / whole);
    shares_.push_back(std::move(shares));
  }
  std::vector<Row> rows;
  for (const Row& shares : shares_) {
    Row row;
    for (const auto& index : indices) row.push_back(bernstein_value(index, shares, degree));
    rows.push_back(std::move(row));
  }
  inverse_ = inverse_matrix(std::move(rows));
}

std::vector<DmsPoint> SimplexInterpolation::points(std::span<const DmsPoint> corners) const {
  std::vector<DmsPoint> out(shares_.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    for (std::size_t m = 0; m < corners.size(); ++m)
      for (std::size_t c = 0; c < 3; ++c) out[i][c] += shares_[i][m] * corners[m][c];
  return out;
}

std::vector<DmsPoint> SimplexInterpolation::coefficients(std::span<const DmsPoint> values) const {
  std::vector<DmsPoint> out(inverse_.size());
  for (std::size_t i = 0; i < out.size(); ++i)
    for (std::size_t k = 0; k < values.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c) out[i][c] += inverse_[i][k] * values[k][c];
  return out;
}

std::optional<std::vector<DmsPoint>> values_at(DmsEvaluator& evaluator,
                                               std::span<const DmsPoint> points) {
  std::vector<DmsPoint> out;
  for (const DmsPoint& p : points) {
    const auto place = evaluator.locate(p);
    if (!place) return std::nullopt;
    const DmsValue value = evaluator.evaluate(*place);
    std::copy_n(value.value.begin(), 3, out.emplace_back().begin());
  }
  return out;
}

}  // namespace veritope
