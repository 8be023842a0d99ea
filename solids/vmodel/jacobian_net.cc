// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/vmodel/jacobian_net.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "robust/base/fp_guard.h"
#include "robust/base/fp_strict.h"
#include "solids/vmodel/jacobian_formulas_internal.h"
#include "splines/polynomial_filter.h"
#include "splines/scaled_polynomial.h"

namespace veritope {
namespace {

using internal::JacobianFactor;
using internal::JacobianRow;

// Binomials of a grid, one vector for each thread and shape that was asked for last.
template <typename S>
std::vector<S> binomials_of(const Grid<3>& grid) {
  if constexpr (std::same_as<S, Integer>) {
    return internal::binomial_grid<Integer>(grid);
  } else {
    return internal::binomial_grid<double>(grid);
  }
}
template <typename S>
const std::vector<S>& known_binomials(const Grid<3>& grid) {
  struct Entry {
    Grid<3> grid;
    std::vector<S> values;
  };
  static thread_local std::vector<Entry> known;
  for (const Entry& e : known)
    if (e.grid == grid) return e.values;
  if (known.size() >= 16) known.clear();
  known.reserve(16);
  return known.emplace_back(Entry{grid, binomials_of<S>(grid)}).values;
}

// The greatest absolute values of the coefficients that are not scaled yet.
using Sizes = std::array<double, 4>;

template <typename S>
JacobianRow<S> scaled_row(JacobianRow<S> v) {
  const std::vector<S>& binomials = known_binomials<S>(v[0].grid);
  for (auto& component : v)
    for (std::size_t i = 0; i < binomials.size(); ++i)
      component.c[i] = component.c[i] * binomials[i];
  return v;
}

template <typename S>
JacobianRow<S> value_of(const BezierVolume<S>& map) {
  JacobianRow<S> out;
  for (int c = 0; c < map.num_components(); ++c) {
    const auto from = map.component(c);
    out.push_back({map.grid(), {from.begin(), from.end()}});
  }
  return out;
}

// Differences of neighbours along an axis.
template <typename S>
JacobianRow<S> derivative_of(const BezierVolume<S>& map, std::size_t axis) {
  const Grid<3> from_grid = map.grid();
  Grid<3> grid = from_grid;
  --grid.size[axis];
  const std::size_t step = from_grid.stride(axis);
  JacobianRow<S> out;
  for (int c = 0; c < map.num_components(); ++c) {
    const auto from = map.component(c);
    JacobianFactor<S> p{grid, {}};
    p.c.reserve(grid.count());
    for (std::size_t i = 0; i < grid.size[0]; ++i)
      for (std::size_t j = 0; j < grid.size[1]; ++j) {
        const S* row = from.data() + from_grid.at({i, j, 0});
        for (std::size_t k = 0; k < grid.size[2]; ++k) p.c.push_back(row[k + step] - row[k]);
      }
    out.push_back(std::move(p));
  }
  return out;
}

Sizes sizes_of(const JacobianRow<double>& v) {
  Sizes out{};
  for (std::size_t c = 0; c < v.size(); ++c)
    for (const double x : v[c].c) out[c] = std::max(out[c], std::abs(x));
  return out;
}

template <typename Algebra, typename S = typename Algebra::Scalar>
JacobianFactor<S> jacobian(const Algebra& algebra, const BezierVolume<S>& map,
                           std::array<Sizes, 4>* sizes) {
  std::array<JacobianRow<S>, 4> rows;  // F, F_u, F_v, F_w
  for (std::size_t r = map.is_rational() ? 0 : 1; r < 4; ++r) {
    rows[r] = r == 0 ? value_of(map) : derivative_of(map, r - 1);
    if constexpr (std::same_as<S, double>)
      if (sizes != nullptr) (*sizes)[r] = sizes_of(rows[r]);
    rows[r] = scaled_row(std::move(rows[r]));
  }
  return map.is_rational() ? internal::determinant4(algebra, rows[0], rows[1], rows[2], rows[3])
                           : internal::determinant3(algebra, rows[1], rows[2], rows[3]);
}

// The sum over all permutations of the products of absolute values, and what it can grow by if each may be greater by
// its error. docs/bounds/jacobian_net.md, section 3.
struct Majorant {
  double size = 0, growth = 0;
};
Majorant majorant(const std::array<Sizes, 4>& sizes, const std::array<Sizes, 4>& errors,
                  std::size_t first) {
  const std::size_t n = 4 - first;
  std::array<std::size_t, 4> columns{0, 1, 2, 3};
  Majorant out;
  do {
    double product = 1;
    for (std::size_t r = 0; r < n; ++r)
      product *= sizes[first + r][columns[r]] + errors[first + r][columns[r]];
    out.size += product;
    for (std::size_t which = 0; which < n; ++which) {
      double one = 1;
      for (std::size_t r = 0; r < n; ++r)
        one *= (r == which ? 0 : sizes[first + r][columns[r]]) + errors[first + r][columns[r]];
      out.growth += one;
    }
  } while (
      std::next_permutation(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(n)));
  return out;
}

}  // namespace

namespace internal {

int jacobian_roundings(const Grid<3>& grid, bool is_rational) {
  const auto less = [](Grid<3> g, std::size_t a) {
    --g.size[a];
    return g;
  };
  constexpr int kInputs = 2;  // a difference, and its product with an exact binomial
  if (!is_rational)
    return 3 * kInputs + filter_roundings(less(grid, 1), 2) + filter_roundings(less(grid, 2), 2) +
           1;
  return 4 * kInputs + filter_roundings(less(grid, 2), 2) + filter_roundings(less(grid, 0), 2) + 1 +
         filter_roundings(grid, 2) + 1;
}

std::vector<double> plain_jacobian(const BezierVolume<double>& piece) {
  return jacobian(PlainAlgebra<double, 3>{1.0}, piece, nullptr).c;
}

}  // namespace internal

bool RoundedJacobian::is_positive(int sign) const {
  const double s = sign < 0 ? -1 : 1;
  return std::all_of(values.begin(), values.end(), [&](double x) { return s * x > error; });
}

ExactJacobian exact_jacobian(const BezierVolume<Integer>& piece) {
  auto n = jacobian(internal::PlainAlgebra<Integer, 3>{Integer(1)}, piece, nullptr);
  // Times L / C for every binomial C, with L their least common multiple: Bernstein coefficients up to a factor.
  std::array<std::vector<Integer>, 3> factors;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto row = binomial_row(static_cast<int>(n.grid.size[a]) - 1);
    Integer least(1);
    for (const Integer& b : row) least = lcm(least, b);
    for (const Integer& b : row) factors[a].push_back(divide_exactly(least, b));
  }
  internal::for_each_index(n.grid, [&](const std::array<std::size_t, 3>& at, std::size_t i) {
    n.c[i] *= factors[0][at[0]] * factors[1][at[1]] * factors[2][at[2]];
  });
  return {n.grid, std::move(n.c)};
}

RoundedJacobian rounded_jacobian(const RoundedPiece& piece) {
  const ScopedDefaultFp nearest;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<Sizes, 4> sizes{}, errors{};
  auto n = jacobian(internal::DoubleAlgebra{}, piece.map, &sizes);
  RoundedJacobian out{n.grid, std::move(n.c), kInfinity};
  const std::vector<double>& binomials = known_binomials<double>(out.grid);
  double greatest = 0;
  for (std::size_t i = 0; i < binomials.size(); ++i) {
    out.values[i] /= binomials[i];
    greatest = std::max(greatest, std::abs(out.values[i]));
  }
  static const bool is_ieee =
      check_fp().has_value();  // of this build: `nearest` takes care of the thread
  if (kFiltersAreCompiled && is_ieee) {
    const bool is_rational = piece.map.is_rational();
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t c = 0; c < 4; ++c) errors[r][c] = (r == 0 ? 1 : 2) * piece.error[c];
    const Majorant all = majorant(sizes, errors, is_rational ? 0 : 1);
    const int k = internal::jacobian_roundings(piece.map.grid(), is_rational);
    const double bound =
        (all.size * (k * 0x1p-53) + all.growth + greatest * 0x1p-48) * (1 + 0x1p-10) + 0x1p-600;
    bool is_moderate = true;
    for (const Sizes& row : sizes)
      for (const double x : row) is_moderate = is_moderate && x < 0x1p150;
    if (is_moderate && std::isfinite(greatest)) out.error = bound;
  }
  return out;
}

}  // namespace veritope
