// SPDX-License-Identifier: LGPL-3.0-or-later
// interop/eigen.h: Eigen::Matrix<Interval, ...>: sums, differences, products, transposes, determinants and
// inverses by cofactors (up to 4 rows). Opt-in: nothing of ours includes it.
// Use: docs/how-to/use-with-cgal-boost-eigen.md.
//
// Operations that compare entries (a pivot, a norm, a tolerance) do not compile: intervals have no order, and a pivot
// chosen by a guess would prove nothing. REQUIRES a live ScopedUpward where an expression is evaluated (where it is
// assigned), in the same thread: Eigen's own threads have other modes.
#pragma once
#if defined(_OPENMP) && !defined(EIGEN_DONT_PARALLELIZE)
#error "veritope: define EIGEN_DONT_PARALLELIZE; Eigen's OpenMP threads do not round upward"
#endif

#include <Eigen/Core>
#include <limits>
#include <type_traits>

#include "interval/interval.h"

namespace Eigen {

/// Precision and range are those of the bounds. Every entry is initialised to [0, 0].
template <>
struct NumTraits<veritope::Interval> : GenericNumTraits<veritope::Interval> {
  using Interval = veritope::Interval;
  using Real = Interval;
  using NonInteger = Interval;
  using Nested = Interval;
  using Literal = double;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 2,
    MulCost = 12
  };
  static Real epsilon() { return Interval(std::numeric_limits<double>::epsilon()); }
  static Real dummy_precision() { return Interval(0.0); }
  static Real highest() { return Interval(std::numeric_limits<double>::max()); }
  static Real lowest() { return Interval(std::numeric_limits<double>::lowest()); }
  static int digits10() { return std::numeric_limits<double>::digits10; }
};

}  // namespace Eigen

namespace veritope {

/// The matrix of point intervals at the entries of m. REQUIRES finite entries.
template <typename Derived>
auto to_intervals(const Eigen::MatrixBase<Derived>& m) {
  using Scalar = typename Derived::Scalar;
  static_assert(std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float> ||
                    (std::is_integral_v<Scalar> && sizeof(Scalar) <= 4),
                "entries of this type may not be doubles: enclose them one by one");
  using Matrix = Eigen::Matrix<Interval, Derived::RowsAtCompileTime, Derived::ColsAtCompileTime>;
  Matrix out(m.rows(), m.cols());
  for (Eigen::Index j = 0; j < m.cols(); ++j) {
    for (Eigen::Index i = 0; i < m.rows(); ++i) out(i, j) = Interval(static_cast<double>(m(i, j)));
  }
  return out;
}

}  // namespace veritope
