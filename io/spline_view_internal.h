// SPDX-License-Identifier: LGPL-3.0-or-later
// io/spline_view_internal.h: what the writers of pictures share.
#pragma once
#include <cmath>

#include "io/spline_view.h"
#include "splines/de_casteljau.h"
#include "splines/knot_insertion.h"

namespace veritope::internal {

inline constexpr std::uint64_t kMostViewPoints = std::uint64_t{1} << 25;

inline Error view_error(Code code, std::uint64_t entity, std::string message) {
  Error error{code, {}, std::move(message)};
  error.place.entity = entity;
  return error;
}

/// The Bezier pieces, cut exactly, then rounded.
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

/// How many control points the pieces have; saturated.
template <std::size_t N>
std::uint64_t num_piece_points(const BSpline<Rational, N>& spline) {
  double total = 1;
  for (const auto& axis : spline.axes())
    total *= static_cast<double>(axis.num_control() - static_cast<std::size_t>(axis.degree)) *
             (axis.degree + 1);
  return total > 1e15 ? std::uint64_t{1} << 50 : static_cast<std::uint64_t>(total);
}

template <std::size_t N>
Result<RoundedPieces<N>> rounded_pieces(const BSpline<Rational, N>& spline, std::uint64_t entity) {
  if (num_piece_points(spline) > kMostViewPoints)
    return view_error(Code::kOverLimit, entity,
                      "its Bezier pieces have more than 33554432 control points");
  const BezierPieces<Rational, N> exact = bezier_pieces(spline);
  RoundedPieces<N> out;
  for (std::size_t a = 0; a < N; ++a)
    for (const Rational& k : exact.breaks[a]) out.breaks[a].push_back(nearest_double(k));
  for (const auto& piece : exact.pieces) {
    std::vector<double> coefficients;
    coefficients.reserve(piece.coefficients().size());
    for (const Rational& c : piece.coefficients()) {
      coefficients.push_back(nearest_double(c));
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

/// The first three coordinates of homogeneous values, 0 where there are fewer.
inline std::array<double, 3> to_point(const std::vector<double>& values, bool is_rational) {
  std::array<double, 3> point{};
  const std::size_t dimension = values.size() - (is_rational ? 1 : 0);
  const double w = is_rational ? values.back() : 1;
  for (std::size_t c = 0; c < 3 && c < dimension; ++c) point[c] = values[c] / w + 0.0;
  return point;
}
template <std::size_t N>
std::array<double, 3> control_point(const Bezier<double, N>& piece, std::size_t i) {
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
