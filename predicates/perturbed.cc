// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/perturbed.h"

#include <algorithm>
#include <numeric>

#include "predicates/implicit_exact.h"
#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

// Rows 1, coordinates and, if it is lifted, the sum of their squares: N points, N columns. The determinant of
// the moved points is a polynomial in the amounts e; it is linear in each row, so that the coefficient of a
// product of amounts of distinct rows and columns is the determinant with those rows replaced by unit vectors,
// and all other products do not occur.
template <int N, bool IsLifted>
class Perturbation {
 public:
  static constexpr int kDim = IsLifted ? N - 2 : N - 1;

  /// coordinates: those of the points, in the order of their ids.
  explicit Perturbation(const std::array<double, N * kDim>& coordinates)
      : coordinates_(coordinates) {
    column_of_.fill(kNone);
  }

  /// The sign of the first coefficient that is not zero, in descending order of the products of amounts.
  Sign sign() { return first_below(kNumAmounts); }

 private:
  static constexpr int kNone = -1, kNumAmounts = N * (N - 1);

  // The row and the column of the amount number r; the larger ones have the lower numbers.
  static constexpr int row_of(int r) {
    if (IsLifted && r < N) return r;
    return (IsLifted ? r - N : r) / kDim;
  }
  static constexpr int column_of(int r) {
    if (IsLifted && r < N) return N - 1;
    return 1 + (IsLifted ? r - N : r) % kDim;
  }

  // Runs through the products of the amounts chosen and of some with numbers below r. The larger products come first:
  // those without the amount r - 1, which is less than any product of larger ones.
  Sign first_below(int r) {
    if (r == 0) return num_chosen_ == 0 ? Sign::kZero : coefficient();  // 0: known to be zero
    if (const Sign s = first_below(r - 1); s != Sign::kZero) return s;
    const int row = row_of(r - 1), column = column_of(r - 1);
    if (column_of_[row] != kNone || is_column_used_[column]) return Sign::kZero;
    column_of_[row] = column, is_column_used_[column] = true, ++num_chosen_;
    const Sign s = first_below(r - 1);
    column_of_[row] = kNone, is_column_used_[column] = false, --num_chosen_;
    return s;
  }

  Sign coefficient() const {
    return internal::exact_sign<IsLifted>([&]<typename T>(std::type_identity<T>) {
      std::array<T, N * kDim> v;
      internal::to_numbers(coordinates_, v);
      std::array<std::array<T, N>, N> m;
      for (int row = 0; row < N; ++row) {
        m[row][0] = T(1);
        for (int j = 0; j < kDim; ++j) m[row][1 + j] = v[row * kDim + j];
        if constexpr (IsLifted) {
          T sum = v[row * kDim] * v[row * kDim];
          for (int j = 1; j < kDim; ++j) sum = sum + v[row * kDim + j] * v[row * kDim + j];
          m[row][N - 1] = sum;
        }
      }
      return determinant(m, 0, (1u << N) - 1);
    });
  }

  // The minor of the rows from `row` on and of equally many columns, those of the mask.
  template <typename T>
  T determinant(const std::array<std::array<T, N>, N>& m, int row, unsigned columns) const {
    if (row == N) return T(1);
    T sum(0);
    bool is_minus = false;
    for (int j = 0; j < N; ++j) {
      if ((columns >> j & 1) == 0) continue;
      if (column_of_[row] == kNone || column_of_[row] == j) {
        const T minor = determinant(m, row + 1, columns & ~(1u << j));
        const T term = column_of_[row] == j ? minor : m[row][j] * minor;
        sum = is_minus ? sum - term : sum + term;
      }
      is_minus = !is_minus;
    }
    return sum;
  }

  const std::array<double, N * kDim>& coordinates_;
  std::array<int, N> column_of_;  // of the unit vector in the place of a row, or kNone
  std::array<bool, N> is_column_used_{};
  int num_chosen_ = 0;
};

std::array<double, 2> row(const Vec2d& p) { return {p.x, p.y}; }
std::array<double, 3> row(const Vec3d& p) { return {p.x, p.y, p.z}; }

// The sign of the determinant of the rows (1, coordinates[, squares]) after an exact zero.
template <bool IsLifted, typename Point, std::size_t N>
Sign perturbed(const std::array<Point, N>& points, const std::array<PointId, N>& ids) {
  std::array<std::size_t, N> order;
  std::iota(order.begin(), order.end(), std::size_t{0});
  Sign parity = Sign::kPositive;
  for (std::size_t i = 1; i < N; ++i) {  // insertion: each swap of neighbours negates the sign
    for (std::size_t k = i; k > 0 && ids[order[k]] < ids[order[k - 1]]; --k) {
      std::swap(order[k], order[k - 1]);
      parity = -parity;
    }
  }
  constexpr std::size_t kDim = IsLifted ? N - 2 : N - 1;
  std::array<double, N * kDim> coordinates;
  for (std::size_t i = 0; i < N; ++i) {
    VT_CHECK(i == 0 || ids[order[i]] != ids[order[i - 1]], "two points with the same id");
    std::ranges::copy(row(points[order[i]]),
                      coordinates.begin() + static_cast<std::ptrdiff_t>(i * kDim));
  }
  return parity * Perturbation<static_cast<int>(N), IsLifted>(coordinates).sign();
}

}  // namespace

Sign orient2d_perturbed(const std::array<Vec2d, 3>& p, const std::array<PointId, 3>& ids,
                        TierCounts* tally) {
  const Sign s = orient2d(p[0], p[1], p[2], tally);
  return s != Sign::kZero ? s : perturbed<false>(p, ids);
}
Sign orient3d_perturbed(const std::array<Vec3d, 4>& p, const std::array<PointId, 4>& ids,
                        TierCounts* tally) {
  const Sign s = orient3d(p[0], p[1], p[2], p[3], tally);
  return s != Sign::kZero ? s : perturbed<false>(p, ids);
}
// Compared with the determinant of the rows (1, coordinates, squares), the lifted determinants are negated.
Sign in_circle_perturbed(const std::array<Vec2d, 4>& p, const std::array<PointId, 4>& ids,
                         TierCounts* tally) {
  const Sign s = in_circle(p[0], p[1], p[2], p[3], tally);
  return s != Sign::kZero ? s : -perturbed<true>(p, ids);
}
Sign in_sphere_perturbed(const std::array<Vec3d, 5>& p, const std::array<PointId, 5>& ids,
                         TierCounts* tally) {
  const Sign s = in_sphere(p[0], p[1], p[2], p[3], p[4], tally);
  return s != Sign::kZero ? s : -perturbed<true>(p, ids);
}

}  // namespace veritope
