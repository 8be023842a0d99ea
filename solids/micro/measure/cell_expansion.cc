// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/measure/cell_expansion_internal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

#include "interval/numeric.h"
#include "solids/micro/measure/tile_moments_internal.h"
#include "splines/binomial.h"

namespace veritope::internal {
namespace {

Rational binomial_of(std::size_t n, std::size_t k) {
  return Rational(binomial(static_cast<int>(n), static_cast<int>(k)));
}

// From Bernstein coefficients of a degree on [0, 1] to those of P_0(2x - 1), P_1(2x - 1), ...: (2k + 1) times the
// integral of B_i P_k, where P_k has the Bernstein coefficients (-1)^(k - j) C(k, j).
std::vector<Interval> new_conversion(std::size_t degree, std::size_t order) {
  std::vector<Interval> out;
  for (std::size_t k = 0; k <= order; ++k)
    for (std::size_t i = 0; i <= degree; ++i) {
      Rational sum;
      for (std::size_t j = 0; j <= k; ++j) {
        const Rational term =
            binomial_of(k, j) * binomial_of(k, j) / binomial_of(degree + k, i + j);
        sum = (k - j) % 2 == 0 ? sum + term : sum - term;
      }
      out.push_back(
          enclose(sum * binomial_of(degree, i) * Rational(static_cast<std::int64_t>(2 * k + 1)) /
                  Rational(static_cast<std::int64_t>(degree + k + 1))));
    }
  return out;
}

// Each matrix is made once.
const std::vector<Interval>& bernstein_to_legendre(std::size_t degree, std::size_t order) {
  static std::mutex mutex;
  static std::map<std::pair<std::size_t, std::size_t>, std::vector<Interval>> known;
  const std::lock_guard lock(mutex);
  const auto [at, is_new] = known.try_emplace({degree, order});
  if (is_new) at->second = new_conversion(degree, order);
  return at->second;
}

// Multiplies a polynomial in z by (1 - x) + x z.
void multiply(std::vector<Interval>& p, const Interval& y, const Interval& x) {
  p.push_back(Interval());
  for (std::size_t i = p.size(); i-- > 0;) p[i] = y * p[i] + (i > 0 ? x * p[i - 1] : Interval());
}

}  // namespace

std::vector<std::vector<Interval>> legendre_matrices(int degree, std::size_t order,
                                                     const std::vector<Rational>& breaks) {
  const auto n = static_cast<std::size_t>(degree);
  const std::vector<Interval>& conversion = bernstein_to_legendre(n, order);
  std::vector<std::vector<Interval>> out;
  for (std::size_t cell = 0; cell + 1 < breaks.size(); ++cell) {
    const std::array<Interval, 2> x = {enclose(breaks[cell]), enclose(breaks[cell + 1])},
                                  y = {enclose(Rational(1) - breaks[cell]),
                                       enclose(Rational(1) - breaks[cell + 1])};
    auto& matrix = out.emplace_back((order + 1) * (n + 1));
    for (std::size_t r = 0; r <= n; ++r) {
      // Coefficient r on the interval is the blossom at n - r times its begin and r times its end. The weights of the
      // blossom are the coefficients of powers of z in a product of n factors.
      std::vector<Interval> weights = {Interval(1.0)};
      for (std::size_t k = 0; k < n; ++k) multiply(weights, y[k < r ? 1 : 0], x[k < r ? 1 : 0]);
      for (std::size_t k = 0; k <= order; ++k)
        for (std::size_t i = 0; i <= n; ++i)
          matrix[k * (n + 1) + i] += conversion[k * (n + 1) + r] * weights[i];
    }
  }
  return out;
}

namespace {

// The expansion of f on the whole unit cube, in all orders.
std::vector<Interval> whole_expansion(const BezierVolume<Interval>& f) {
  const std::vector<Rational> whole = {Rational(), Rational(1)};
  const Grid<3> grid = f.grid();
  const CellExpansion expansion(f, {whole, whole, whole},
                                grid.size[0] + grid.size[1] + grid.size[2] - 3);
  CellExpansion::Sheet sheet;
  CellExpansion::Row row;
  std::vector<Interval> out;
  expansion.enter_sheet(0, sheet);
  expansion.enter_row(sheet, 0, row);
  expansion.cell(row, 0, out);
  return out;
}
// Bounds of the coefficients of P_0, ..., P_n on an interval of half-width h in [-1, 1], for the polynomial P_n there:
// h^k max |P_n^(k)| / (1 3 5 ... (2k - 1)) by the formula of Rodrigues. The greatest value of |P_n^(k)| is that at 1,
// (n + k)! / (2^k k! (n - k)!).
std::vector<Interval> coefficient_bounds(std::size_t n, const Interval& h) {
  std::vector<Interval> out = {Interval(1.0)};
  for (std::size_t k = 1; k <= n; ++k)
    out.push_back(out.back() * h * Interval(static_cast<double>((n + k) * (n - k + 1))) /
                  Interval(static_cast<double>(2 * k * (2 * k - 1))));
  return out;
}

}  // namespace

std::vector<double> expansion_errors(const BezierVolume<Interval>& f,
                                     const std::array<double, 3>& half_widths,
                                     std::size_t most_order) {
  const Grid<3> grid = f.grid();
  const std::vector<Interval> expansion = whole_expansion(f);
  std::vector<Interval> bounds(grid.count());
  for (std::size_t n = 0; n < bounds.size(); ++n) {
    const auto at = grid.index_of(n);
    bounds[n] = Interval::from_bounds(0, mag(expansion[moment_number(at[0], at[1], at[2])]));
  }
  for (std::size_t a = 0; a < 3; ++a) {
    std::vector<std::vector<Interval>> factors;
    for (std::size_t n = 0; n < grid.size[a]; ++n)
      factors.push_back(coefficient_bounds(n, Interval(2 * half_widths[a])));
    const std::size_t step = grid.stride(a);
    grid.for_each_line(a, [&](std::size_t first) {
      for (std::size_t k = 0; k < grid.size[a]; ++k) {
        Interval sum;
        for (std::size_t n = k; n < grid.size[a]; ++n)
          sum += factors[n][k] * bounds[first + n * step];
        bounds[first + k * step] = sum;
      }
    });
  }
  std::vector<Interval> of_order(grid.size[0] + grid.size[1] + grid.size[2] - 2);
  for (std::size_t n = 0; n < bounds.size(); ++n) {
    const auto at = grid.index_of(n);
    of_order[at[0] + at[1] + at[2]] += bounds[n];
  }
  std::vector<double> out(of_order.size());
  Interval rest;
  for (std::size_t s = out.size(); s-- > 0;) {
    out[s] = rest.hi();
    rest += of_order[s];
  }
  out.resize(std::min(out.size(), most_order + 1));
  return out;
}

std::vector<double> exact_expansion_errors(const BezierVolume<Interval>& f,
                                           const std::array<std::vector<Rational>, 3>& breaks,
                                           std::size_t most_order) {
  const Grid<3> grid = f.grid();
  const std::size_t last = grid.size[0] + grid.size[1] + grid.size[2] - 3;
  std::vector<double> out(std::min(last, most_order) + 1);
  const CellExpansion expansion(f, breaks, last);
  CellExpansion::Sheet sheet;
  CellExpansion::Row row;
  std::vector<Interval> coefficients;
  for (std::size_t i = 0; i + 1 < breaks[0].size(); ++i) {
    expansion.enter_sheet(i, sheet);
    for (std::size_t j = 0; j + 1 < breaks[1].size(); ++j) {
      expansion.enter_row(sheet, j, row);
      for (std::size_t k = 0; k + 1 < breaks[2].size(); ++k) {
        expansion.cell(row, k, coefficients);
        Interval rest;
        std::size_t end = coefficients.size();
        for (std::size_t s = last + 1; s-- > 0;) {
          if (s < out.size()) out[s] = std::max(out[s], rest.hi());
          for (; end > (s == 0 ? 0 : num_moments(s - 1)); --end)
            rest += Interval::from_bounds(0, mag(coefficients[end - 1]));
        }
      }
    }
  }
  return out;
}

double keep_midpoints(BezierVolume<Interval>& f) {
  double most = 0;
  for (Interval& x : f.component(0)) {
    const MidRad m = mid_rad(x);
    if (!(m.rad < std::numeric_limits<double>::infinity()))
      return std::numeric_limits<double>::infinity();
    most = std::max(most, m.rad);
    x = Interval(m.mid);
  }
  return most;
}

double greatest_value(BezierVolume<Interval> f) {
  Interval sum = Interval::from_bounds(0, keep_midpoints(f));
  for (const Interval& c : whole_expansion(f)) sum += Interval::from_bounds(0, mag(c));
  return sum.hi();
}

CellExpansion::CellExpansion(const BezierVolume<Interval>& f,
                             const std::array<std::vector<Rational>, 3>& breaks, std::size_t order)
    : num_moments_(internal::num_moments(order)),
      size_(f.grid().size),
      values_(f.component(0).begin(), f.component(0).end()) {
  for (std::size_t a = 0; a < 3; ++a) {
    rows_[a] = std::min(order, size_[a] - 1) + 1;
    matrices_[a] = legendre_matrices(f.degree(a), rows_[a] - 1, breaks[a]);
  }
  for (std::size_t a = 0; a < rows_[0]; ++a)
    for (std::size_t b = 0; b < rows_[1] && a + b <= order; ++b) {
      Line line{a, b, {}};
      for (std::size_t c = 0; c < rows_[2] && a + b + c <= order; ++c)
        line.to.push_back(moment_number(a, b, c));
      lines_.push_back(std::move(line));
    }
}

void CellExpansion::enter_sheet(std::size_t i, Sheet& sheet) const {
  const std::size_t layer = size_[1] * size_[2];
  const std::vector<Interval>& matrix = matrices_[0][i];
  sheet.values.assign(rows_[0] * layer, Interval());
  for (std::size_t a = 0; a < rows_[0]; ++a)
    for (std::size_t l = 0; l < size_[0]; ++l)
      for (std::size_t n = 0; n < layer; ++n)
        sheet.values[a * layer + n] += matrix[a * size_[0] + l] * values_[l * layer + n];
}

void CellExpansion::enter_row(const Sheet& sheet, std::size_t j, Row& row) const {
  const std::vector<Interval>& matrix = matrices_[1][j];
  row.values.assign(lines_.size() * size_[2], Interval());
  for (std::size_t n = 0; n < lines_.size(); ++n) {
    const Interval* from = sheet.values.data() + lines_[n].a * size_[1] * size_[2];
    Interval* to = row.values.data() + n * size_[2];
    for (std::size_t l = 0; l < size_[1]; ++l)
      for (std::size_t k = 0; k < size_[2]; ++k)
        to[k] += matrix[lines_[n].b * size_[1] + l] * from[l * size_[2] + k];
  }
}

void CellExpansion::cell(const Row& row, std::size_t k, std::vector<Interval>& out) const {
  const std::vector<Interval>& matrix = matrices_[2][k];
  out.assign(num_moments_, Interval());
  for (std::size_t n = 0; n < lines_.size(); ++n) {
    const Interval* from = row.values.data() + n * size_[2];
    for (std::size_t c = 0; c < lines_[n].to.size(); ++c) {
      Interval sum;
      for (std::size_t l = 0; l < size_[2]; ++l) sum += matrix[c * size_[2] + l] * from[l];
      out[lines_[n].to[c]] = sum;
    }
  }
}

}  // namespace veritope::internal
