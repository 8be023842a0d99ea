// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/mesh/rounded_cage_internal.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solids/micro/mesh/mesh_lanes_internal.h"
#include "splines/blossom_weights.h"

namespace veritope::internal {
namespace {

// Bound: docs/bounds/micro_mesh.md, sections 1 and 2.
constexpr double kUnit = 0x1p-53, kTiny = 0x1p-1000, kSlack = 1 + 0x1p-40;

// A sum of differences of coefficients, first or second ones, and its greatest length.
struct Differences {
  const RoundedCell& cell;
  std::array<std::size_t, 3> order;  // along the axes

  // The number of differences along an axis; none if the degree is too low.
  std::size_t count(std::size_t axis) const {
    return cell.size[axis] > order[axis] ? cell.size[axis] - order[axis] : 0;
  }
  double square_at(std::size_t at, const std::array<std::size_t, 2>& steps, bool is_second) const {
    double square = 0;
    for (const std::vector<double>& x : cell.values) {
      const double first = x[at + steps[0]] - x[at];
      const double d = is_second ? (x[at + steps[0] + steps[1]] - x[at + steps[1]]) - first : first;
      square += d * d;
    }
    return square;
  }
  // The greatest length, and the greatest one of those at the corners.
  std::array<double, 2> longest() const {
    const std::array<std::size_t, 3> stride = {cell.size[1] * cell.size[2], cell.size[2], 1};
    std::array<std::size_t, 2> steps{};
    std::size_t total = 0;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t n = 0; n < order[a]; ++n) steps[total++] = stride[a];
    const std::array<std::size_t, 3> n = {count(0), count(1), count(2)};
    std::array<double, 2> out{};
    for (std::size_t i = 0; i < n[0]; ++i)
      for (std::size_t j = 0; j < n[1]; ++j)
        for (std::size_t k = 0; k < n[2]; ++k) {
          const double square = square_at(i * stride[0] + j * stride[1] + k, steps, total == 2);
          // A comparison that is false for NaN would lose it.
          out[0] = square <= out[0] ? out[0] : square;
          const bool is_corner =
              (i == 0 || i + 1 == n[0]) && (j == 0 || j + 1 == n[1]) && (k == 0 || k + 1 == n[2]);
          if (is_corner) out[1] = std::max(out[1], square);
        }
    const double most = std::sqrt(out[0]);
    return {most, out[1] == out[0] ? most : std::sqrt(out[1])};
  }
};

double infinite_if_nan(double x) {
  return x <= std::numeric_limits<double>::max() ? x : std::numeric_limits<double>::infinity();
}

}  // namespace

RoundedCage::RoundedCage(const VVolume& volume, const MicroGrid& grid) {
  const Grid<3> net = volume.grid();
  net_size_ = net.size;
  net_.resize(net.count() * 3);
  double most = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto values = volume.component(static_cast<int>(c));
    for (std::size_t n = 0; n < net.count(); ++n) {
      net_[n * 3 + c] = nearest_double(values[n]);
      most = std::max(most, std::abs(net_[n * 3 + c]));
    }
  }
  int of_coefficients = 1, of_values = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const KnotAxis<Rational>& axis = volume.axis(a);
    const auto p = static_cast<std::size_t>(axis.degree);
    size_[a] = p + 1;
    of_coefficients += axis.degree + 2;
    of_values += map_roundings(axis.degree);
    for (std::size_t i = 0; i + 1 < grid.breaks[a].size(); ++i) {
      const Rational &low = grid.breaks[a][i], &high = grid.breaks[a][i + 1];
      const std::size_t span = find_span(axis, low);
      Cut cut{span - p, {}};
      std::vector<Rational> arguments(p, low);
      for (std::size_t k = 0; k <= p; ++k) {
        for (const Rational& w : blossom_weights<Rational>(axis, span, arguments))
          cut.matrix.push_back(nearest_double(w));
        if (k < p) arguments[k] = high;
      }
      cuts_[a].push_back(std::move(cut));
    }
  }
  const auto error = [&](int roundings) {
    return infinite_if_nan(((roundings + 2) * kUnit * most + kTiny * (1 + most)) * kSlack);
  };
  coefficient_error_ = error(of_coefficients);
  value_error_ = error(of_coefficients + of_values);
}

void RoundedCage::enter_row(std::size_t i, std::size_t j, std::vector<double>& row) const {
  const Cut &first = cuts_[0][i], &second = cuts_[1][j];
  const std::size_t p = size_[0], q = size_[1], line = net_size_[2] * 3;
  row.assign(p * q * line, 0);
  std::vector<double> sheet(q * line);
  for (std::size_t k = 0; k < p; ++k) {
    std::fill(sheet.begin(), sheet.end(), 0.0);
    for (std::size_t l = 0; l < p; ++l) {
      const double weight = first.matrix[k * p + l];
      const double* const from =
          net_.data() + ((first.first + l) * net_size_[1] + second.first) * line;
      for (std::size_t n = 0; n < q * line; ++n) sheet[n] += weight * from[n];
    }
    for (std::size_t m = 0; m < q; ++m)
      for (std::size_t l = 0; l < q; ++l) {
        const double weight = second.matrix[m * q + l];
        double* const to = row.data() + (k * q + m) * line;
        for (std::size_t n = 0; n < line; ++n) to[n] += weight * sheet[l * line + n];
      }
  }
}

void RoundedCage::cell(const std::vector<double>& row, std::size_t k, RoundedCell& out) const {
  const Cut& cut = cuts_[2][k];
  const std::size_t r = size_[2], line = net_size_[2] * 3, lines = size_[0] * size_[1];
  out.size = size_;
  for (std::vector<double>& v : out.values) v.resize(lines * r);
  for (std::size_t n = 0; n < lines; ++n) {
    const double* const from = row.data() + n * line + cut.first * 3;
    for (std::size_t m = 0; m < r; ++m) {
      std::array<double, 3> sum{};
      for (std::size_t l = 0; l < r; ++l)
        for (std::size_t c = 0; c < 3; ++c) sum[c] += cut.matrix[m * r + l] * from[l * 3 + c];
      for (std::size_t c = 0; c < 3; ++c) out.values[c][n * r + m] = sum[c];
    }
  }
}

CellMapBounds RoundedCage::bounds(const RoundedCell& cell, bool& is_loose) const {
  constexpr double kLoose = 1.25;
  constexpr std::array<std::array<std::size_t, 2>, 6> kPairs = {
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};
  CellMapBounds out;
  double sum = 0, at_corners = 0;
  const auto keep = [&](const Differences& d, double factor, double errors, double& bound) {
    if (factor == 0 && coefficient_error_ <= std::numeric_limits<double>::max()) return;
    const auto longest = d.longest();
    sum += factor * longest[0], at_corners += factor * longest[1];
    bound =
        infinite_if_nan(factor * (longest[0] + errors * coefficient_error_) * kSlack + 0x1p-500);
  };
  std::array<double, 3> degree;
  for (std::size_t a = 0; a < 3; ++a) {
    degree[a] = static_cast<double>(cell.size[a] - 1);
    std::array<std::size_t, 3> order{};
    order[a] = 1;
    keep({cell, order}, degree[a], 4, out.first[a]);
  }
  for (std::size_t n = 0; n < kPairs.size(); ++n) {
    const auto [a, b] = kPairs[n];
    std::array<std::size_t, 3> order{};
    ++order[a], ++order[b];
    keep({cell, order}, degree[a] * (a == b ? degree[b] - 1 : degree[b]), 9, out.second[n]);
  }
  is_loose = sum > kLoose * at_corners;
  return out;
}

}  // namespace veritope::internal
