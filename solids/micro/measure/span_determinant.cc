// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/measure/span_determinant_internal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "interval/numeric.h"
#include "solids/micro/measure/cell_expansion_internal.h"
#include "splines/bezier_calculus.h"
#include "splines/bezier_product.h"
#include "splines/composition_span.h"

namespace veritope::internal {
namespace {

using Volume = BezierVolume<Interval>;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
// Degrees of the interpolation along an axis on which the weight depends. Beyond them Bernstein coefficients of
// oscillating polynomials are too large.
constexpr int kDegrees[] = {8, 12, 18, 24};

// The map in homogeneous coordinates; the weight, if there is one, with degree 0 along the axes on which it does not
// depend.
struct EnclosedPiece {
  Volume points{{0, 0, 0}, 3, false};
  Volume weight{{0, 0, 0}, 1, false};
  std::array<bool, 3> depends{};  // the weight, on an axis
};
// The differences from the first control point are exact before they are rounded: the determinant does not depend on
// where the model lies.
EnclosedPiece enclosed_piece(const VVolume& volume, const CellSpan& span) {
  const BezierVolume<Rational> piece = bezier_piece(volume, span.knots);
  const Grid<3> grid = piece.grid();
  EnclosedPiece out;
  std::vector<Rational> weights(grid.count(), Rational(1));
  if (piece.is_rational()) std::copy_n(piece.component(3).begin(), weights.size(), weights.begin());
  out.points = Volume(piece.degrees(), 3, false);
  for (int c = 0; c < 3; ++c) {
    const Rational origin = piece.component(c)[0] / weights[0];
    for (std::size_t n = 0; n < weights.size(); ++n)
      out.points.component(c)[n] = enclose(piece.component(c)[n] - origin * weights[n]);
  }
  std::array<int, 3> degrees{};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t step = grid.stride(a);
    for (std::size_t n = 0; n < weights.size(); ++n)
      if (grid.index_of(n)[a] > 0 && weights[n] != weights[n - step]) out.depends[a] = true;
    if (out.depends[a]) degrees[a] = piece.degree(a);
  }
  out.weight = Volume(degrees, 1, false);
  const Grid<3> few = out.weight.grid();
  for (std::size_t n = 0; n < few.count(); ++n)
    out.weight.component(0)[n] = enclose(weights[grid.at(few.index_of(n))]);
  return out;
}
Volume determinant(const Volume& a, const Volume& b, const Volume& c) {
  return dot(a, cross(b, c));
}
// w^4 det(X_u, X_v, X_w) for X = F / w: the determinant of the rows (w, F), (w_u, F_u), (w_v, F_v), (w_w, F_w).
Volume homogeneous_determinant(const EnclosedPiece& piece) {
  const std::array<Volume, 4> f = {piece.points, derivative(piece.points, 0),
                                   derivative(piece.points, 1), derivative(piece.points, 2)};
  Volume out = multiplied(piece.weight, determinant(f[1], f[2], f[3]));
  for (std::size_t k = 1; k < 4; ++k) {
    if (!piece.depends[k - 1]) continue;
    const std::size_t a = k == 1 ? 2 : 1, b = k == 3 ? 2 : 3;
    const Volume term = multiplied(derivative(piece.weight, k - 1), determinant(f[0], f[a], f[b]));
    out = k % 2 == 1 ? difference(out, term) : sum(out, term);
  }
  return out;
}

// From here on: a polynomial near N / w^4. Nothing is proved of its coefficients; the error is.

// Values of Bernstein polynomials at Chebyshev's nodes, inverted: from values to coefficients.
struct Interpolation {
  std::vector<long double> nodes;
  std::vector<long double> inverse;  // row by row
};
Interpolation interpolation_of(int degree) {
  const auto n = static_cast<std::size_t>(degree) + 1;
  Interpolation out;
  std::vector<long double> a(n * 2 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const long double x =
        0.5L - 0.5L * std::cos(std::numbers::pi_v<long double> *
                               (static_cast<long double>(i) + 0.5L) / static_cast<long double>(n));
    out.nodes.push_back(x);
    long double value = std::pow(1 - x, static_cast<long double>(degree));
    for (std::size_t j = 0; j < n; ++j) {
      a[i * 2 * n + j] = value;
      value *= static_cast<long double>(n - 1 - j) / static_cast<long double>(j + 1) * x / (1 - x);
    }
    a[i * 2 * n + n + i] = 1;
  }
  for (std::size_t k = 0; k < n; ++k) {  // the matrix is totally positive: no pivots are needed
    const long double pivot = a[k * 2 * n + k];
    for (std::size_t j = 0; j < 2 * n; ++j) a[k * 2 * n + j] /= pivot;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const long double factor = a[i * 2 * n + k];
      for (std::size_t j = 0; j < 2 * n; ++j) a[i * 2 * n + j] -= factor * a[k * 2 * n + j];
    }
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) out.inverse.push_back(a[i * 2 * n + n + j]);
  return out;
}
// A matrix of rows x size[axis] along an axis.
std::vector<long double> along_axis(const std::vector<long double>& matrix, std::size_t axis,
                                    Grid<3>& grid, const std::vector<long double>& values) {
  Grid<3> to = grid;
  to.size[axis] = matrix.size() / grid.size[axis];
  std::vector<long double> out(to.count());
  for (std::size_t n = 0; n < out.size(); ++n) {
    auto at = to.index_of(n);
    const std::size_t row = std::exchange(at[axis], 0), step = grid.stride(axis);
    const long double* from = values.data() + grid.at(at);
    for (std::size_t i = 0; i < grid.size[axis]; ++i)
      out[n] += matrix[row * grid.size[axis] + i] * from[i * step];
  }
  grid = to;
  return out;
}
std::vector<long double> bernstein_matrix(int degree, const std::vector<long double>& nodes) {
  std::vector<long double> out;
  for (const long double x : nodes) {
    long double value = std::pow(1 - x, static_cast<long double>(degree));
    for (int j = 0; j <= degree; ++j) {
      out.push_back(value);
      value *= static_cast<long double>(degree - j) / static_cast<long double>(j + 1) * x / (1 - x);
    }
  }
  return out;
}
std::vector<long double> values_at(const Volume& f, const std::array<Interpolation, 3>& by_axis) {
  std::vector<long double> values;
  for (const Interval& x : f.component(0)) values.push_back(mid(x));
  Grid<3> grid = f.grid();
  for (std::size_t a = 0; a < 3; ++a)
    values = along_axis(bernstein_matrix(f.degree(a), by_axis[a].nodes), a, grid, values);
  return values;
}
Volume interpolated(const Volume& above, const Volume& weight, const std::array<int, 3>& degrees) {
  std::array<Interpolation, 3> by_axis;
  for (std::size_t a = 0; a < 3; ++a) by_axis[a] = interpolation_of(degrees[a]);
  std::vector<long double> values = values_at(above, by_axis);
  const std::vector<long double> weights = values_at(weight, by_axis);
  for (std::size_t n = 0; n < values.size(); ++n) {
    const long double square = weights[n] * weights[n];
    values[n] /= square * square;
  }
  Volume out(degrees, 1, false);
  Grid<3> grid = out.grid();
  for (std::size_t a = 0; a < 3; ++a) values = along_axis(by_axis[a].inverse, a, grid, values);
  for (std::size_t n = 0; n < values.size(); ++n)
    out.component(0)[n] = Interval(
        std::isfinite(static_cast<double>(values[n])) ? static_cast<double>(values[n]) : 0.0);
  return out;
}

SpanDeterminant quotient_of(const Volume& above, const EnclosedPiece& piece, double enough) {
  double least = kInfinite;
  for (const Interval& w : piece.weight.component(0)) least = std::min(least, w.lo());
  SpanDeterminant best{Volume({0, 0, 0}, 1, false), kInfinite};
  if (!(least > 0)) return best;
  const Volume square = multiplied(piece.weight, piece.weight), below = multiplied(square, square);
  for (const int d : kDegrees) {
    std::array<int, 3> degrees;
    for (std::size_t a = 0; a < 3; ++a) degrees[a] = piece.depends[a] ? d : above.degree(a);
    SpanDeterminant next{interpolated(above, piece.weight, degrees), 0};
    const double gap = greatest_value(difference(above, multiplied(below, next.polynomial)));
    next.error = (Interval(gap) / sqr(sqr(Interval(least)))).hi();
    if (next.error < best.error) best = std::move(next);
    if (best.error <= enough * greatest_coefficient(best.polynomial)) break;
  }
  return best;
}

}  // namespace

std::vector<CellSpan> spans_of(const VVolume& volume, const MicroGrid& grid) {
  std::array<std::vector<CellSpan>, 3> by_axis;  // each with one axis filled in
  for (std::size_t a = 0; a < 3; ++a) {
    const KnotAxis<Rational>& axis = volume.axis(a);
    std::size_t cell = 0;
    for (std::size_t k = static_cast<std::size_t>(axis.degree); k < axis.num_control(); ++k) {
      const std::size_t first = cell;
      while (cell + 1 < grid.breaks[a].size() && grid.breaks[a][cell] < axis.knots[k + 1]) ++cell;
      if (first == cell) continue;
      CellSpan& span = by_axis[a].emplace_back();
      span.knots[a] = k;
      span.cells[a] = {first, cell};
    }
  }
  std::vector<CellSpan> out;
  for (const CellSpan& u : by_axis[0])
    for (const CellSpan& v : by_axis[1])
      for (const CellSpan& w : by_axis[2])
        out.push_back({{u.knots[0], v.knots[1], w.knots[2]}, {u.cells[0], v.cells[1], w.cells[2]}});
  return out;
}

std::vector<Rational> breaks_in_span(const VVolume& volume, const MicroGrid& grid,
                                     const CellSpan& span, std::size_t axis) {
  const auto& knots = volume.axis(axis).knots;
  const Rational &begin = knots[span.knots[axis]], width = knots[span.knots[axis] + 1] - begin;
  std::vector<Rational> out;
  for (std::size_t i = span.cells[axis][0]; i <= span.cells[axis][1]; ++i)
    out.push_back((grid.breaks[axis][i] - begin) / width);
  return out;
}

double greatest_coefficient(const BezierVolume<Interval>& f) {
  double most = 0;
  for (const Interval& x : f.component(0)) {
    const double m = mag(x);
    if (!(m <= most)) most = std::isfinite(m) ? m : kInfinite;
  }
  return most;
}

SpanDeterminant span_determinant(const VVolume& volume, const CellSpan& span, double enough) {
  const EnclosedPiece piece = enclosed_piece(volume, span);
  if (std::count(piece.depends.begin(), piece.depends.end(), true) > 0)
    return quotient_of(homogeneous_determinant(piece), piece, enough);
  // One weight for all control points: the map is polynomial.
  const Volume& f = piece.points;
  SpanDeterminant out{determinant(derivative(f, 0), derivative(f, 1), derivative(f, 2)), 0};
  const Interval w = piece.weight.component(0)[0];
  if (volume.is_rational())
    for (Interval& x : out.polynomial.component(0)) x /= w * sqr(w);
  out.error = keep_midpoints(out.polynomial);
  return out;
}

}  // namespace veritope::internal
