// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fit/fit_solver.h"

#define EIGEN_MPL2_ONLY
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "robust/base/check.h"

namespace veritope {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Vectors = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr double kSmoothness = 1e-9;  // of the weight of the data
constexpr double kRidge = 1e-14;      // what neither data nor smoothness determine becomes small
constexpr int kSmoothings = 4, kRefinements = 6;
constexpr double kFlatPivot = 0x1p-34, kLift = 0x1p-44, kPartShare = 0x1p-12;

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

Rows matrix_of(const SparseRows& a, std::size_t columns) {
  return Eigen::Map<const Rows>(index(a.num_rows()), index(columns), index(a.value.size()),
                                a.first.data(), a.column.data(), a.value.data());
}

Matrix normal_matrix(const Rows& a) { return Matrix(a.transpose() * a); }

double trace(const Matrix& m) { return m.diagonal().sum(); }

// The rows' smoothness, scaled beside the data.
Matrix smoothness_matrix(const Matrix& normal, const SparseRows& s) {
  Matrix smooth(normal.rows(), normal.cols());
  if (s.num_rows() == 0) return smooth;
  smooth = normal_matrix(matrix_of(s, static_cast<std::size_t>(normal.cols())));
  const double most = trace(smooth);
  return most > 0 ? Matrix((kSmoothness * trace(normal) / most) * smooth) : smooth;
}

// What makes the other matrices regular.
Matrix ridge(const Matrix& normal) {
  Matrix identity(normal.rows(), normal.cols());
  identity.setIdentity();
  return std::max(kRidge * trace(normal) / static_cast<double>(normal.cols()), 1e-300) * identity;
}

}  // namespace

std::vector<double> solve_least_squares(const SparseRows& a, const SparseRows& s,
                                        std::size_t num_unknowns, std::span<const double> b,
                                        std::size_t num_rhs) {
  const Rows rows = matrix_of(a, num_unknowns);
  const Matrix normal = normal_matrix(rows), smooth = smoothness_matrix(normal, s);
  const Eigen::SimplicialLDLT<Matrix> factors(Matrix(normal + smooth + ridge(normal)));
  VT_CHECK(factors.info() == Eigen::Success, "a positive definite matrix has a factorisation");
  using RowVectors = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Vectors wanted =
      Eigen::Map<const RowVectors>(b.data(), index(a.num_rows()), index(num_rhs));
  Vectors x = factors.solve(Vectors(rows.transpose() * wanted));
  // First what the ridge did is undone. Then what the data determine converges to their least squares;
  // the rest stays as smooth as it is.
  for (int i = 0; i < kSmoothings; ++i)
    x += factors.solve(Vectors(rows.transpose() * (wanted - rows * x) - smooth * x));
  for (int i = 0; i < kRefinements; ++i)
    x += factors.solve(Vectors(rows.transpose() * (wanted - rows * x)));
  std::vector<double> out(num_unknowns * num_rhs);
  Eigen::Map<RowVectors>(out.data(), index(num_unknowns), index(num_rhs)) = x;
  return out;
}

std::vector<double> solve_damped(const SparseRows& a, const SparseRows& s,
                                 std::span<const double> damping, std::span<const double> b) {
  const Rows rows = matrix_of(a, damping.size());
  const Matrix normal = normal_matrix(rows);
  Matrix matrix = normal + smoothness_matrix(normal, s) + ridge(normal);
  for (std::size_t i = 0; i < damping.size(); ++i)
    matrix.coeffRef(index(i), index(i)) += damping[i] * normal.coeff(index(i), index(i));
  const Eigen::SimplicialLDLT<Matrix> factors(matrix);
  VT_CHECK(factors.info() == Eigen::Success, "a positive definite matrix has a factorisation");
  const Vector wanted = Eigen::Map<const Vector>(b.data(), index(b.size()));
  const Vector x = factors.solve(Vector(rows.transpose() * wanted));
  return {x.data(), x.data() + x.size()};
}

std::vector<std::uint32_t> find_undetermined(const SparseRows& a, std::size_t num_unknowns) {
  Matrix normal = normal_matrix(matrix_of(a, num_unknowns));
  Vector scale = normal.diagonal();
  for (Eigen::Index i = 0; i < scale.size(); ++i)
    scale[i] = scale[i] > 0 ? 1 / std::sqrt(scale[i]) : 0;
  normal = scale.asDiagonal() * normal * scale.asDiagonal();
  Matrix identity(normal.rows(), normal.cols());
  identity.setIdentity();
  normal += kLift * identity;
  const Eigen::SimplicialLDLT<Matrix> factors(normal);
  VT_CHECK(factors.info() == Eigen::Success, "a positive definite matrix has a factorisation");
  std::vector<bool> is_part(num_unknowns);
  const Vector pivots = factors.vectorD();
  for (Eigen::Index i = 0; i < pivots.size(); ++i) {
    if (pivots[i] > kFlatPivot) continue;
    Vector change = Vector::Zero(pivots.size());
    change[i] = 1;
    factors.matrixU().solveInPlace(change);
    change = factors.permutationPinv() * change;
    const double share = kPartShare * change.cwiseAbs().maxCoeff();
    for (Eigen::Index k = 0; k < change.size(); ++k)
      if (std::abs(change[k]) > share) is_part[static_cast<std::size_t>(k)] = true;
  }
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < num_unknowns; ++i)
    if (is_part[i]) out.push_back(i);
  return out;
}

}  // namespace veritope
