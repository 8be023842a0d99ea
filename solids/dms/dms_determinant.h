// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_determinant.h: the determinant of a solid's derivative on a simplex on which the map is one
// polynomial: its Bernstein coefficients, and the search for a place where it is below 0.
#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solids/dms/dms_knots.h"

namespace veritope {

/// A polynomial on a tetrahedron: its Bernstein coefficients, in the order of tetrahedral_index.
class TetrahedralPolynomial {
 public:
  /// REQUIRES num_tetrahedral_indices(degree) coefficients.
  TetrahedralPolynomial(int degree, std::vector<Rational> coefficients)
      : degree_(degree), coefficients_(std::move(coefficients)) {}

  int degree() const { return degree_; }
  const std::vector<Rational>& coefficients() const { return coefficients_; }
  Rational at(const std::array<Rational, 4>& barycentric) const;
  /// On the halves of the tetrahedron beside the middle of the edge of two corners: that in which the middle is in the
  /// place of corner j, and that in which it is in the place of corner i. REQUIRES i != j.
  std::pair<TetrahedralPolynomial, TetrahedralPolynomial> halves(std::size_t i,
                                                                 std::size_t j) const;

  /// The polynomial on another tetrahedron, whose corners have these barycentric coordinates.
  TetrahedralPolynomial on(const std::array<std::array<Rational, 4>, 4>& corners) const;

 private:
  int degree_;
  std::vector<Rational> coefficients_;
};

/// The determinant of a matrix of polynomials of a degree: degree 3 degree. derivatives[k] has coefficient k of each.
TetrahedralPolynomial determinant_of(int degree, std::span<const DmsMatrix> derivatives);

struct NegativePlace {
  /// A place inside of the tetrahedron with a value below 0: its barycentric coordinates.
  std::optional<std::array<Rational, 4>> at;
  bool is_positive = false;  ///< all values are above 0
};
/// Halves the parts with the least coefficients first, and follows Newton's method from these to the least value.
/// If neither a negative value nor a proof that all are positive is found within `max_parts`, nothing follows.
/// @cost  for each part as many sums as a halving takes
NegativePlace find_negative(const TetrahedralPolynomial& polynomial, std::size_t max_parts);

}  // namespace veritope
