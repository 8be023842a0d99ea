// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/field_system_internal.h: the linear least squares of one step of a fit.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "solids/micro/cage/field_net_internal.h"

namespace veritope::internal {

/// The mean square of all second derivatives along lengths of the box, times its mean side squared twice: 0 for affine
/// maps, and independent of the unit of length. Axes of degree 1 have jumps of the derivative instead.
class Smoothness {
 public:
  /// @param lengths  of the domain's image along the axes, approximately; > 0
  Smoothness(const FieldNet& net, const Point3d& lengths);

  /// out += factor S x.
  void apply(const std::vector<Point3d>& x, double factor, std::vector<Point3d>& out) const;
  double energy(const std::vector<Point3d>& x) const;
  /// The entries on the diagonal of S.
  const std::vector<double>& diagonal() const { return diagonal_; }

 private:
  struct Term {
    std::array<std::size_t, 3> orders;
    double factor;
  };
  using Band = std::vector<double>;  // n rows of 2 degree + 1

  void along(std::size_t axis, std::size_t order, const std::vector<Point3d>& x,
             std::vector<Point3d>& out) const;

  Grid<3> grid_;
  std::array<std::size_t, 3> degrees_;
  std::array<std::array<Band, 3>, 3> bands_;  // of axes and orders
  std::vector<Term> terms_;
  std::vector<double> diagonal_;
};

/// A vector at its parameters: how the direction of the w line turns with the net, and where it should turn.
struct FieldRow {
  std::array<AxisWeights, 3> weights;
  std::array<Point3d, 3>
      slide;  ///< rows of the matrix that takes moves of the point to the change of T_w
  std::array<Point3d, 2> across;  ///< across the w line, divided by the length of T_w
  std::array<double, 2> goal{};   ///< the turn to the direction: 2 sin(angle / 2)
  double weight = 1;
};

/// The row of a net at a place. @param direction  of unit length; its sign does not matter
FieldRow field_row(const FieldNet& net, const Parameters3& at, const Point3d& direction);

/// The square of 2 sin(angle / 2) for the angle between two axes, from 0 to pi / 2; no function of the machine's
/// library but the square root is used.
double squared_chord(const Point3d& a, const Point3d& b);

/// A linear function of the moves of all control points, and the value that it should have.
struct WideRow {
  std::vector<Point3d> factors;
  double goal = 0;
};

/// What a change of parameters may do without turning a w line: affine maps of (u, v), and of w with (u, v) added. The
/// moments of the parameters of vectors that such a map changes are kept, for the second derivatives would get smaller
/// if the map shrank around the vectors.
class ParameterMoments {
 public:
  ParameterMoments(const FieldNet& net, std::vector<Parameters3> at);

  /// The sum of the squared changes of moments.
  double energy(const std::vector<Parameters3>& at) const;
  std::vector<WideRow> rows(const FieldNet& net, const std::vector<Parameters3>& at) const;

 private:
  struct Moment {
    std::size_t axis;
    std::vector<double> factors;  // of the parameters along the axis
  };
  double change(const Moment& moment, const std::vector<Parameters3>& at) const;

  std::vector<Parameters3> first_;
  std::vector<Moment> moments_;
};

/// Minimises sum weight |row x - goal|^2 + smooth (P + x) S (P + x) + sum damping |x|^2 over moves x of the net P by
/// conjugate gradients, preconditioned by 3 x 3 blocks; at most `steps` of them, down to `tolerance` times the first
/// residual.
struct FieldSolve {
  double smooth = 0;
  std::vector<double> damping;  ///< of each control point
  double tolerance = 1e-2;
  int steps = 150;
};
std::vector<Point3d> solve_field(const FieldNet& net, std::span<const FieldRow> rows,
                                 std::span<const WideRow> wide, const Smoothness& smoothness,
                                 const FieldSolve& options);

/// Minimises sum |f(at) - value|^2 + smooth f S f over functions f on the net; the first coordinates are its control
/// values.
std::vector<Point3d> solve_scalar(const FieldNet& net, std::span<const Parameters3> at,
                                  std::span<const double> values, const Smoothness& smoothness,
                                  double smooth);

}  // namespace veritope::internal
