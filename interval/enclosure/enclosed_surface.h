// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/enclosure/enclosed_surface.h: a continuous B-spline surface in space, prepared for enclosures of its points
// and derivatives over rectangles of parameters. Convex hull property after restriction, [SSP01]; docs/THEORY.md,
// ENCLOSE-1.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "interval/box.h"
#include "interval/mp_interval.h"
#include "robust/base/result.h"
#include "splines/bspline.h"

namespace veritope {

/// Bezier pieces with interval coefficients over *working parameters*: each knot is replaced by the next binary64
/// number, and every span is mapped to its new place affinely. Exact wherever the knots are binary64 numbers.
/// All functions REQUIRE a live ScopedUpward in this thread.
class EnclosedSurface {
 public:
  /// Boxes that contain all points of a part of the surface, and all its derivatives by u and by v there.
  struct Range {
    Box3 point, du, dv;
  };
  /// What the caller wants: the derivatives alone cost two thirds.
  enum class Want { kAll, kDerivatives };

  /// Boxes around the second derivatives.
  struct SecondRange {
    Box3 duu, duv, dvv;
  };

  /// @error kBadArgument: not in space; a weight that is not positive; pieces that do not meet along a knot; knots that
  ///   are the same binary64 number; kOverLimit: coordinates beyond 2^300 (their products could overflow)
  static Result<EnclosedSurface> make(const BSpline<Rational, 2>& surface);

  /// The ends of the spans, increasing: breaks() in working parameters, knots() exact.
  const std::vector<double>& breaks(std::size_t axis) const { return breaks_[axis]; }
  const std::vector<Rational>& knots(std::size_t axis) const { return knots_[axis]; }
  /// Whether working parameters are the surface's own.
  bool has_exact_knots() const;
  std::size_t num_spans(std::size_t axis) const { return breaks_[axis].size() - 1; }
  double domain_begin(std::size_t axis) const { return breaks_[axis].front(); }
  double domain_end(std::size_t axis) const { return breaks_[axis].back(); }
  bool is_rational() const { return num_components_ == 4; }

  /// The point at working parameters. Beyond the domain the last piece is continued.
  Box3 point(double u, double v) const;
  /// Like point(), but in MPFR intervals of `precision` bits from the exact coefficients. The result is homogeneous,
  /// with weight 1 if the surface is polynomial.
  std::array<MpInterval, 4> precise_point(double u, double v, int precision) const;
  /// The point of one piece, continued beyond its borders, at a narrow box of parameters.
  Box3 point_of_piece(std::size_t i, std::size_t j, const Interval& u, const Interval& v) const;
  /// The weights of one piece, continued, over a rectangle; 1 for polynomial pieces.
  Interval weight_of_piece(std::size_t i, std::size_t j, const Interval& u,
                           const Interval& v) const;
  /// Like range(), but for one piece, which is continued.
  Range range_of_piece(std::size_t i, std::size_t j, const Interval& u, const Interval& v,
                       Want want = Want::kAll) const;
  /// Boxes over a rectangle of working parameters, which may cross knots and the domain's border; there the derivatives
  /// are hulls over both sides. The excess width is of first order in the rectangle's size. The result is the whole of
  /// space where a continued piece's weight is not positive.
  Range range(const Interval& u, const Interval& v, Want want = Want::kAll) const;

  /// The second derivatives over a rectangle, enclosed as range() does.
  SecondRange second_range(const Interval& u, const Interval& v) const;

  /// Encloses the true parameter that belongs to a working one.
  Interval true_parameter(std::size_t axis, const Interval& working) const;

  /// Coefficients of a piece, component by component, v fastest. Homogeneous if rational.
  const Interval* piece(std::size_t i, std::size_t j) const {
    return nets_.data() + (i * num_spans(1) + j) * net_size();
  }
  std::size_t net_size() const { return static_cast<std::size_t>(num_components_) * net_count(); }
  std::size_t net_count() const { return (degrees_[0] + 1) * (degrees_[1] + 1); }
  const std::array<std::size_t, 2>& degrees() const { return degrees_; }
  int num_components() const { return num_components_; }
  /// The box around a net's control points, divided by their weights.
  Box3 hull_of_net(const Interval* net) const;

 private:
  EnclosedSurface() = default;
  std::size_t span_of(std::size_t axis, double parameter) const;
  template <typename OnPiece>
  void on_pieces(const Interval& u, const Interval& v, OnPiece on_piece) const;
  Interval local(std::size_t axis, std::size_t span, double parameter) const;
  Box3 point_at(std::size_t i, std::size_t j, const Interval& tu, const Interval& tv) const;

  std::array<std::size_t, 2> degrees_{};
  int num_components_ = 3;
  std::array<std::vector<double>, 2> breaks_;
  std::array<std::vector<Rational>, 2> knots_;
  std::vector<Rational> exact_;    // coefficients of all pieces
  std::vector<Interval> nets_;     // enclosures of exact_
  std::vector<Interval> du_, dv_;  // derivatives by the local parameters, degrees one lower
};

}  // namespace veritope
