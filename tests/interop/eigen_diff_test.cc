// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interop/eigen.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "robust/base/random.h"
#include "robust/rational.h"

namespace veritope {
namespace {

double number(Random& random) {
  return std::ldexp(2 * random.unit() - 1, static_cast<int>(random.between(-30, 30)));
}
template <typename Matrix>
Matrix random_matrix(Random& random, Eigen::Index rows, Eigen::Index cols) {
  Matrix m(rows, cols);
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < cols; ++j) m(i, j) = number(random);
  }
  return m;
}
Rational exact(double v) { return Rational::from_double(v); }

// Every entry of the exact product lies in the entry of the product of intervals.
template <typename Doubles>
void expect_products_enclose(Random& random, Eigen::Index rows, Eigen::Index inner,
                             Eigen::Index cols) {
  const Doubles a = random_matrix<Doubles>(random, rows, inner),
                b = random_matrix<Doubles>(random, inner, cols);
  using Intervals = Eigen::Matrix<Interval, Doubles::RowsAtCompileTime, Doubles::ColsAtCompileTime>;
  Intervals product, sum_of_two;
  {
    const ScopedUpward upward;
    product = to_intervals(a) * to_intervals(b);
    sum_of_two = to_intervals(a) * to_intervals(b) - product;
  }
  double width = 0, size = 0;
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < cols; ++j) {
      Rational sum(0);
      double magnitude = 0;
      for (Eigen::Index k = 0; k < inner; ++k)
        sum += exact(a(i, k)) * exact(b(k, j)), magnitude += std::abs(a(i, k) * b(k, j));
      EXPECT_TRUE(contains(product(i, j), sum)) << to_string(product(i, j));
      EXPECT_TRUE(contains(sum_of_two(i, j), Rational(0)));
      width += product(i, j).hi() - product(i, j).lo(), size += magnitude;
    }
  }
  EXPECT_GT(width, 0);
  EXPECT_LT(width, size * 0x1p-40);
}

TEST(EigenInterval, ProductsEncloseTheExactOnes) {
  Random random(61);
  for (int round = 0; round < 50; ++round)
    expect_products_enclose<Eigen::Matrix3d>(random, 3, 3, 3);
  for (int round = 0; round < 4; ++round)  // Eigen's blocked product
    expect_products_enclose<Eigen::MatrixXd>(random, 30 + round, 17, 25);
}

TEST(EigenInterval, DeterminantsAndInversesByCofactorsEncloseTheExactOnes) {
  Random random(62);
  for (int round = 0; round < 200; ++round) {
    const Eigen::Matrix3d m = random_matrix<Eigen::Matrix3d>(random, 3, 3);
    const auto at = [&](int i, int j) { return exact(m(i, j)); };
    const Rational det = at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) -
                         at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0)) +
                         at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
    const ScopedUpward upward;
    const Interval got = to_intervals(m).determinant();
    EXPECT_TRUE(contains(got, det)) << to_string(got);
    const Eigen::Matrix<Interval, 3, 3> identity = to_intervals(m).inverse() * to_intervals(m);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) EXPECT_TRUE(contains(identity(i, j), Rational(i == j ? 1 : 0)));
    }
    const Interval turned = to_intervals(m).transpose().determinant();
    EXPECT_TRUE(contains(turned, det)) << to_string(turned);
  }
}

TEST(EigenInterval, SumsDifferencesAndScalingEncloseTheExactOnes) {
  Random random(63);
  using Intervals = Eigen::Matrix<Interval, 3, 1>;
  for (int round = 0; round < 100; ++round) {
    const Eigen::Vector3d a = random_matrix<Eigen::Vector3d>(random, 3, 1),
                          b = random_matrix<Eigen::Vector3d>(random, 3, 1);
    const double scale = number(random);
    const ScopedUpward upward;
    const Intervals sum = to_intervals(a) + to_intervals(b),
                    less = to_intervals(a) - to_intervals(b),
                    scaled = to_intervals(a) * Interval(scale), negated = -to_intervals(a);
    const Interval dot = (to_intervals(a).transpose() * to_intervals(b))(0, 0);
    Rational product(0);
    for (int i = 0; i < 3; ++i) {
      EXPECT_TRUE(contains(sum(i), exact(a(i)) + exact(b(i))));
      EXPECT_TRUE(contains(less(i), exact(a(i)) - exact(b(i))));
      EXPECT_TRUE(contains(scaled(i), exact(a(i)) * exact(scale)));
      EXPECT_TRUE(contains(negated(i), -exact(a(i))));
      product += exact(a(i)) * exact(b(i));
    }
    EXPECT_TRUE(contains(dot, product));
  }
}

}  // namespace
}  // namespace veritope
