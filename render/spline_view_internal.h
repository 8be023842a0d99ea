// SPDX-License-Identifier: LGPL-3.0-or-later
// render/spline_view_internal.h: what the writers of pictures share.
#pragma once
#include <cmath>

#include "render/spline_view.h"
#include "render/wide_float.h"
#include "splines/de_casteljau.h"
#include "splines/knot_insertion.h"

namespace veritope::internal {

inline constexpr std::uint64_t kMostViewPoints = std::uint64_t{1} << 25;

inline Error view_error(Code code, std::uint64_t entity, std::string message) {
  Error error{code, {}, std::move(message)};
  error.place.entity = entity;
  return error;
}

/// The Bezier pieces, cut exactly if is_cut_exactly, else with 256 bits, and then rounded.
template <std::size_t N>
struct RoundedPieces {
  std::array<std::vector<double>, N> breaks;
  std::vector<Bezier<double, N>> pieces;
  Grid<N> grid() const {
    Grid<N> g;
    for (std::size_t i = 0; i < N; ++i) g.size[i] = breaks[i].size() - 1;
    return g;
  }
};

/// The number of control points of the pieces; saturated.
template <std::size_t N>
std::uint64_t num_piece_points(const BSpline<Rational, N>& spline) {
  double total = 1;
  for (const auto& axis : spline.axes())
    total *= static_cast<double>(axis.num_control() - static_cast<std::size_t>(axis.degree)) *
             (axis.degree + 1);
  return total > 1e15 ? std::uint64_t{1} << 50 : static_cast<std::uint64_t>(total);
}

/// Whether the pieces' numbers stay so short that cutting them exactly takes at most milliseconds each: along each
/// axis, a piece's coefficient has the bits of a coefficient plus up to those of `degree` knots.
template <std::size_t N>
bool is_cut_exactly(const BSpline<Rational, N>& spline) {
  constexpr std::uint64_t kMostKnotBits = 768, kMostCoefficientBits = 1200;
  const auto bits = [](const Rational& x) {
    return x.numerator().bit_length() + x.denominator().bit_length();
  };
  std::uint64_t of_knots = 0;
  for (const auto& axis : spline.axes()) {
    std::uint64_t longest = 0;
    for (const Rational& u : axis.knots) longest = std::max(longest, bits(u));
    of_knots += longest * static_cast<std::uint64_t>(axis.degree);
  }
  if (of_knots > kMostKnotBits) return false;
  for (int c = 0; c < spline.num_components(); ++c)
    for (const Rational& x : spline.component(c))
      if (bits(x) > kMostCoefficientBits) return false;
  return true;
}

inline double rounded(const Rational& x) { return nearest_double(x); }
inline double rounded(const WideFloat& x) { return nearest_double(x.exact()); }

template <typename R, std::size_t N>
Result<RoundedPieces<N>> rounded(const BezierPieces<R, N>& cut, std::uint64_t entity) {
  RoundedPieces<N> out;
  for (std::size_t a = 0; a < N; ++a)
    for (const Rational& k : cut.breaks[a]) out.breaks[a].push_back(nearest_double(k));
  for (const auto& piece : cut.pieces) {
    std::vector<double> coefficients;
    coefficients.reserve(piece.coefficients().size());
    for (const R& c : piece.coefficients()) {
      coefficients.push_back(rounded(c));
      if (!std::isfinite(coefficients.back()))
        return view_error(Code::kNotFinite, entity, "a coordinate is too large for binary64");
    }
    const bool has_zero_weight = piece.is_rational() && [&] {
      const std::size_t count = piece.grid().count(),
                        first = count * static_cast<std::size_t>(piece.dimension());
      for (std::size_t i = first; i < first + count; ++i)
        if (coefficients[i] == 0) return true;
      return false;
    }();
    if (has_zero_weight)
      return view_error(Code::kNotFinite, entity, "a weight is too small for binary64");
    out.pieces.emplace_back(piece.degrees(), piece.num_components(), piece.is_rational(),
                            std::move(coefficients));
  }
  return out;
}

template <std::size_t N>
BSpline<WideFloat, N> with_wide_floats(const BSpline<Rational, N>& spline) {
  std::vector<WideFloat> coefficients;
  for (int c = 0; c < spline.num_components(); ++c)
    for (const Rational& x : spline.component(c)) coefficients.emplace_back(x);
  return {spline.axes(), spline.num_components(), spline.is_rational(), std::move(coefficients)};
}

template <std::size_t N>
Result<RoundedPieces<N>> rounded_pieces(const BSpline<Rational, N>& spline, std::uint64_t entity) {
  if (num_piece_points(spline) > kMostViewPoints)
    return view_error(Code::kOverLimit, entity,
                      "its Bezier pieces have more than 33554432 control points");
  if (is_cut_exactly(spline)) return rounded(bezier_pieces(spline), entity);
  return rounded(bezier_pieces(with_wide_floats(spline)), entity);
}

/// The triangle with each coefficient rounded to nearest. @error kNotFinite as for pieces
Result<BezierTriangle<double>> rounded_triangle(const ExactTriangle& triangle,
                                                std::uint64_t entity);

/// The number of pieces into which each side of a triangle is cut, so that its small flat triangles deviate by at most
/// `chord`; at most 256.
/// Bound    f, a map of degree p, differs from its linear interpolant at the corners c_i of a triangle at most by
///          1/2 sum l_i |second derivative along c_i - x| at x of barycentric coordinates l. Cut in n, c_i - x is 1/n
///          times a combination of two edges with coefficients of sum 1 - l_i, and second derivatives along edges are
///          averages of p (p - 1) second differences of control points, at most D: the sum is at most
///          (4/9) p (p - 1) D / n^2, since l (1 - l)^2 <= 4/27. This holds up to rounding; for rational triangles it
///          is an estimate.
std::size_t triangle_divisions(const BezierTriangle<double>& triangle, double chord);

/// The points at (i, j, k) / divisions in the order of triangle_index. Sides with the same control points give the same
/// points, bit for bit, in either direction. REQUIRES divisions > 0.
std::vector<Point3d> triangle_grid(const BezierTriangle<double>& triangle, std::size_t divisions);
/// The small triangles of such a grid, counterclockwise, numbered from `first` on.
void append_triangle_grid(std::size_t divisions, std::uint32_t first,
                          std::vector<std::array<std::uint32_t, 3>>& triangles);

/// The first three coordinates of homogeneous values, 0 where there are fewer.
inline Point3d to_point(const std::vector<double>& values, bool is_rational) {
  Point3d point{};
  const std::size_t dimension = values.size() - (is_rational ? 1 : 0);
  const double w = is_rational ? values.back() : 1;
  for (std::size_t c = 0; c < 3 && c < dimension; ++c) point[c] = values[c] / w + 0.0;
  return point;
}
/// The control points of a Bezier map or triangle.
template <typename Map>
Point3d control_point(const Map& piece, std::size_t i) {
  std::vector<double> values;
  for (int c = 0; c < piece.num_components(); ++c) values.push_back(piece.component(c)[i]);
  return to_point(values, piece.is_rational());
}

template <std::size_t N>
std::array<std::size_t, N> unflatten(std::size_t i, const Grid<N>& grid) {
  std::array<std::size_t, N> index;
  for (std::size_t a = N; a-- > 0; i /= grid.size[a]) index[a] = i % grid.size[a];
  return index;
}

/// The shortest decimal that reads back as the same number.
void append_number(std::string& out, double value);

Result<std::string> vtu_bytes(const SplineModel& model);
std::string obj_bytes(const std::vector<Tessellation>& parts);
std::string gltf_bytes(const std::vector<Tessellation>& parts);

}  // namespace veritope::internal
