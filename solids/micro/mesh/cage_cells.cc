// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "interval/numeric.h"
#include "solids/micro/mesh/cage_cells_internal.h"
#include "splines/binomial.h"
#include "splines/blossom_weights.h"
#include "splines/de_casteljau_line.h"

namespace veritope::internal {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// The Bernstein polynomials of a degree at x, in [0, 1].
void bernstein_at(const Interval& x, const std::vector<Interval>& binomials,
                  std::array<Interval, kMaxVDegree + 1>& out) {
  const std::size_t n = binomials.size() - 1;
  const Interval y = Interval(1.0) - x;
  Interval power(1.0);
  for (std::size_t i = 0; i <= n; ++i) {
    out[i] = binomials[i] * power;
    if (i < n) power = Interval::nonnegative_multiple(power, x);
  }
  power = Interval(1.0);
  for (std::size_t i = n + 1; i-- > 0;) {
    out[i] = Interval::nonnegative_multiple(out[i], power);
    if (i > 0) power = Interval::nonnegative_multiple(power, y);
  }
}

double length_of(const Interval& square) {
  const Interval root = sqrt(square);
  return root.is_empty() || !(root.hi() < kInfinite) ? kInfinite : root.hi();
}

// Coefficients of a map, point after point, each with room for four components.
struct WideNet {
  std::array<std::size_t, 3> size;
  std::vector<Interval> values;
};
// The greatest length of a coefficient; of those at the corners, which are values of the map.
struct Lengths {
  double most = 0, at_corners = 0;
};
Lengths longest(const WideNet& net, std::size_t components) {
  Lengths out;
  std::size_t at = 0;
  for (std::size_t i = 0; i < net.size[0]; ++i)
    for (std::size_t j = 0; j < net.size[1]; ++j)
      for (std::size_t k = 0; k < net.size[2]; ++k, at += 4) {
        Interval square = sqr(net.values[at]);
        for (std::size_t c = 1; c < components; ++c) square += sqr(net.values[at + c]);
        if (square.is_empty() || !(square.hi() < kInfinite)) return {kInfinite, 0};
        out.most = std::max(out.most, square.hi());
        if ((i == 0 || i + 1 == net.size[0]) && (j == 0 || j + 1 == net.size[1]) &&
            (k == 0 || k + 1 == net.size[2]))
          out.at_corners = std::max(out.at_corners, square.hi());
      }
  return {length_of(Interval(out.most)), length_of(Interval(out.at_corners))};
}
WideNet derivative_of(const WideNet& net, std::size_t components, std::size_t axis) {
  WideNet out{net.size, {}};
  if (net.size[axis] < 2) return out;
  --out.size[axis];
  out.values.resize(4 * out.size[0] * out.size[1] * out.size[2]);
  std::size_t step = 4;
  for (std::size_t a = axis + 1; a < 3; ++a) step *= net.size[a];
  const Interval degree(static_cast<double>(net.size[axis] - 1));
  std::size_t to = 0;
  for (std::size_t i = 0; i < out.size[0]; ++i)
    for (std::size_t j = 0; j < out.size[1]; ++j)
      for (std::size_t k = 0; k < out.size[2]; ++k, to += 4) {
        const std::size_t from = 4 * ((i * net.size[1] + j) * net.size[2] + k);
        for (std::size_t c = 0; c < components; ++c)
          out.values[to + c] = degree * (net.values[from + step + c] - net.values[from + c]);
      }
  return out;
}
// Pairs of axes, in the order of CellMapBounds.
constexpr std::array<std::array<std::size_t, 2>, 6> kAxisPairs = {
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
struct DerivativeLengths {
  CellMapBounds most;
  double sum = 0, at_corners = 0;  // over all derivatives
};
DerivativeLengths derivative_lengths(const WideNet& net, std::size_t components) {
  DerivativeLengths out;
  std::array<WideNet, 3> first;
  const auto keep = [&](const Lengths& l, double& most) {
    most = l.most;
    out.sum += l.most, out.at_corners += l.at_corners;
  };
  for (std::size_t a = 0; a < 3; ++a) {
    first[a] = derivative_of(net, components, a);
    keep(longest(first[a], components), out.most.first[a]);
  }
  for (std::size_t k = 0; k < kAxisPairs.size(); ++k)
    if (const auto [a, b] = kAxisPairs[k]; first[a].size[b] > 1)
      keep(longest(derivative_of(first[a], components, b), components), out.most.second[k]);
  return out;
}
CellMapBounds no_bounds() {
  CellMapBounds out;
  out.first.fill(kInfinite);
  out.second.fill(kInfinite);
  return out;
}

}  // namespace

CellMap::CellMap(const std::array<int, 3>& degrees, bool is_rational)
    : num_components_(is_rational ? 4 : 3) {
  for (std::size_t a = 0; a < 3; ++a) {
    size_[a] = static_cast<std::size_t>(degrees[a]) + 1;
    for (int k = 0; k <= degrees[a]; ++k)
      binomials_[a].push_back(enclose(Rational(binomial(degrees[a], k))));
  }
  coefficients_.resize(num_points() * num_components_);
}

Box3 CellMap::value(const Box3& at) const {
  std::array<std::array<Interval, kMaxVDegree + 1>, 3> basis;
  for (std::size_t a = 0; a < 3; ++a) bernstein_at(at[a], binomials_[a], basis[a]);
  std::array<Interval, 4> sum{};
  const Interval* p = coefficients_.data();
  for (std::size_t i = 0; i < size_[0]; ++i) {
    std::array<Interval, 4> plane{};
    for (std::size_t j = 0; j < size_[1]; ++j) {
      std::array<Interval, 4> line{};
      for (std::size_t k = 0; k < size_[2]; ++k, p += num_components_)
        for (std::size_t c = 0; c < num_components_; ++c)
          line[c] += Interval::nonnegative_multiple(p[c], basis[2][k]);
      for (std::size_t c = 0; c < num_components_; ++c)
        plane[c] += Interval::nonnegative_multiple(line[c], basis[1][j]);
    }
    for (std::size_t c = 0; c < num_components_; ++c)
      sum[c] += Interval::nonnegative_multiple(plane[c], basis[0][i]);
  }
  Box3 out(sum[0], sum[1], sum[2]);
  if (num_components_ == 4)
    for (std::size_t c = 0; c < 3; ++c) out[c] = sum[c] / sum[3];
  return out;
}

CellMapBounds CellMap::whole_bounds(bool& is_loose) const {
  constexpr double kLoose = 1.25, kUneven = 1.125;
  WideNet points{size_, std::vector<Interval>(4 * num_points())}, weights = points;
  for (std::size_t n = 0; n < num_points(); ++n)
    for (std::size_t c = 0; c < 3; ++c)
      points.values[4 * n + c] = coefficients_[n * num_components_ + c];
  if (num_components_ == 3) {
    const DerivativeLengths lengths = derivative_lengths(points, 3);
    is_loose = lengths.sum > kLoose * lengths.at_corners;
    return lengths.most;
  }
  Interval weight = coefficients_[3];
  for (std::size_t n = 0; n < num_points(); ++n) weight = hull(weight, coefficients_[4 * n + 3]);
  if (weight.sign() != Sign3::kPositive) return is_loose = true, no_bounds();
  // T = middle + G / w, T_a = (G_a - G / w w_a) / w, T_ab = (G_ab - T_a w_b - T_b w_a - G / w w_ab) / w.
  const Box3 image = value(Box3::filled(Interval(0.5)));
  for (std::size_t n = 0; n < num_points(); ++n) {
    const Interval w = coefficients_[4 * n + 3];
    weights.values[4 * n] = w;
    for (std::size_t c = 0; c < 3; ++c) points.values[4 * n + c] -= Interval(mid(image[c])) * w;
  }
  const auto bound = [](double x) { return Interval::from_bounds(0, x); };
  const auto quotient = [least = Interval(weight.lo())](const Interval& x) {
    const Interval q = x / least;
    return q.is_empty() || !(q.hi() < kInfinite) ? kInfinite : q.hi();
  };
  const DerivativeLengths lengths = derivative_lengths(points, 3);
  const CellMapBounds &above = lengths.most, below = derivative_lengths(weights, 1).most;
  is_loose = lengths.sum > kLoose * lengths.at_corners || weight.hi() > kUneven * weight.lo();
  for (const double x : above.first)
    if (x == kInfinite) return no_bounds();
  CellMapBounds out;
  const double radius = quotient(bound(longest(points, 3).most));
  for (std::size_t a = 0; a < 3; ++a)
    out.first[a] = quotient(bound(above.first[a]) + bound(radius) * bound(below.first[a]));
  for (std::size_t k = 0; k < kAxisPairs.size(); ++k) {
    const auto [a, b] = kAxisPairs[k];
    out.second[k] = quotient(bound(above.second[k]) + bound(out.first[a]) * bound(below.first[b]) +
                             bound(out.first[b]) * bound(below.first[a]) +
                             bound(radius) * bound(below.second[k]));
  }
  return out;
}

void CellMap::halve(std::size_t axis, bool keeps_upper) {
  std::size_t step = num_components_;
  for (std::size_t a = axis + 1; a < 3; ++a) step *= size_[a];
  const HalfBlend<Interval> blend{Interval(0.5)};
  const auto degree = static_cast<int>(size_[axis] - 1);
  for (std::size_t block = 0; block < coefficients_.size(); block += step * size_[axis])
    for (std::size_t i = 0; i < step; ++i) {
      Interval* const first = coefficients_.data() + block + i;
      if (keeps_upper)
        keep_right(first, step, degree, blend);
      else
        keep_left(first, step, degree, blend);
    }
}

CellMapBounds CellMap::bounds(int depth) const {
  bool is_loose = false;
  const CellMapBounds whole = whole_bounds(is_loose);
  if (depth == 0 || !is_loose) return whole;
  CellMapBounds out;
  for (unsigned part = 0; part < 8; ++part) {
    CellMap half = *this;
    for (std::size_t a = 0; a < 3; ++a) half.halve(a, (part >> a & 1) != 0);
    const CellMapBounds b = half.bounds(depth - 1);
    // In the parameters of the whole cell; twice and four times a number are exact, or infinite.
    for (std::size_t a = 0; a < 3; ++a) out.first[a] = std::max(out.first[a], 2 * b.first[a]);
    for (std::size_t k = 0; k < 6; ++k) out.second[k] = std::max(out.second[k], 4 * b.second[k]);
  }
  for (std::size_t a = 0; a < 3; ++a) out.first[a] = std::min(out.first[a], whole.first[a]);
  for (std::size_t k = 0; k < 6; ++k) out.second[k] = std::min(out.second[k], whole.second[k]);
  return out;
}

CageCells::CageCells(const VVolume& volume, const MicroGrid& grid)
    : num_components_(volume.is_rational() ? 4 : 3) {
  const Grid<3> net = volume.grid();
  net_size_ = net.size;
  net_.resize(net.count() * num_components_);
  for (std::size_t c = 0; c < num_components_; ++c) {
    const auto values = volume.component(static_cast<int>(c));
    for (std::size_t n = 0; n < net.count(); ++n)
      net_[n * num_components_ + c] = enclose(values[n]);
  }
  for (std::size_t a = 0; a < 3; ++a) {
    const KnotAxis<Rational>& axis = volume.axis(a);
    degrees_[a] = axis.degree;
    const auto p = static_cast<std::size_t>(axis.degree);
    for (std::size_t i = 0; i + 1 < grid.breaks[a].size(); ++i) {
      const Rational &low = grid.breaks[a][i], &high = grid.breaks[a][i + 1];
      const std::size_t span = find_span(axis, low);
      Cut cut{span - p, {}};
      std::vector<Rational> arguments(p, low);
      for (std::size_t k = 0; k <= p; ++k) {
        for (const Rational& w : blossom_weights<Rational>(axis, span, arguments))
          cut.matrix.push_back(enclose(w));
        if (k < p) arguments[k] = high;
      }
      cuts_[a].push_back(std::move(cut));
    }
  }
}

void CageCells::enter_row(std::size_t i, std::size_t j, CageRow& row) const {
  const Cut &first = cuts_[0][i], &second = cuts_[1][j];
  const auto p = static_cast<std::size_t>(degrees_[0]) + 1,
             q = static_cast<std::size_t>(degrees_[1]) + 1;
  const std::size_t line = net_size_[2] * num_components_;
  row.net_.assign(p * q * line, Interval());
  std::vector<Interval> sheet(q * line);
  for (std::size_t k = 0; k < p; ++k) {
    std::fill(sheet.begin(), sheet.end(), Interval());
    for (std::size_t l = 0; l < p; ++l) {
      const Interval& weight = first.matrix[k * p + l];
      const Interval* const from =
          net_.data() + ((first.first + l) * net_size_[1] + second.first) * line;
      for (std::size_t n = 0; n < q * line; ++n) sheet[n] += weight * from[n];
    }
    for (std::size_t m = 0; m < q; ++m)
      for (std::size_t l = 0; l < q; ++l) {
        const Interval& weight = second.matrix[m * q + l];
        Interval* const to = row.net_.data() + (k * q + m) * line;
        for (std::size_t n = 0; n < line; ++n) to[n] += weight * sheet[l * line + n];
      }
  }
}

void CageCells::cell(const CageRow& row, std::size_t k, CellMap& map) const {
  const Cut& cut = cuts_[2][k];
  const auto r = static_cast<std::size_t>(degrees_[2]) + 1;
  const std::size_t line = net_size_[2] * num_components_, lines = row.net_.size() / line;
  Interval* to = map.coefficients_.data();
  for (std::size_t n = 0; n < lines; ++n) {
    const Interval* const from = row.net_.data() + n * line + cut.first * num_components_;
    for (std::size_t m = 0; m < r; ++m, to += num_components_)
      for (std::size_t c = 0; c < num_components_; ++c) {
        Interval sum;
        for (std::size_t l = 0; l < r; ++l)
          sum += cut.matrix[m * r + l] * from[l * num_components_ + c];
        to[c] = sum;
      }
  }
}

}  // namespace veritope::internal
