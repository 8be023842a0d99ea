// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/composition_remainders.h: the coefficients of a composition modulo one prime after the other, by evaluation
// and interpolation.
//
// In the variables z = x / (1 - x) the scaled coefficients are those of ordinary polynomials. Modulo a prime p the
// inner map is evaluated at z in {0, ..., D}^N, the outer map is evaluated at its values, and the result, of degree D
// in each variable, is interpolated. This is exact, as nothing is ill-conditioned modulo p. In floating point it would
// not do: its condition grows like 2^D per axis.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "splines/prime_field.h"
#include "splines/scaled_polynomial.h"

namespace veritope::internal {

/// A composition in integers: the outer map's coefficients and, component by component, the inner map's scaled x and q
/// = w - x.
template <std::size_t M, std::size_t N>
struct IntegerProblem {
  std::array<int, M> degrees;
  int num_components;
  Grid<N> inner_grid;
  std::vector<Integer> coefficients;
  std::vector<Integer> x, q;

  std::array<int, N> inner_degrees() const {
    std::array<int, N> n;
    for (std::size_t j = 0; j < N; ++j) n[j] = static_cast<int>(inner_grid.size[j]) - 1;
    return n;
  }
};

/// A matrix, row by row, by which each line of a grid along an axis is multiplied.
struct AxisMatrix {
  std::size_t rows, columns;
  std::vector<PrimeField::Number> entries;

  /// Row z: 1, z, ..., z^(columns - 1), for z = 0, ..., rows - 1.
  static AxisMatrix powers(const PrimeField& field, std::size_t rows, std::size_t columns);
  /// The inverse of powers(size, size): values at 0, ..., size - 1 to coefficients. REQUIRES size <= p.
  static AxisMatrix interpolation(const PrimeField& field, std::size_t size);
};

template <std::size_t N>
void multiply_axis(const PrimeField& field, const AxisMatrix& matrix, std::size_t axis,
                   Grid<N>& grid, std::vector<PrimeField::Number>& values) {
  Grid<N> to_grid = grid;
  to_grid.size[axis] = matrix.rows;
  std::vector<PrimeField::Number> to(to_grid.count()), line(matrix.columns);
  const std::size_t stride = grid.stride(axis);
  std::size_t block = 0;
  grid.for_each_line(axis, [&](std::size_t first) {
    for (std::size_t i = 0; i < matrix.columns; ++i) line[i] = values[first + i * stride];
    const std::size_t out = block / stride * stride * matrix.rows + block % stride;
    for (std::size_t r = 0; r < matrix.rows; ++r)
      to[out + r * stride] =
          field.dot(matrix.entries.data() + r * matrix.columns, line.data(), matrix.columns);
    ++block;
  });
  grid = to_grid;
  values = std::move(to);
}

/// Sets C(a, i) x^i q^(a - i) of numbers for i = 0..a. binomials: those of a.
inline void basis_numbers(const PrimeField& field, std::span<const PrimeField::Number> binomials,
                          PrimeField::Number x, PrimeField::Number q,
                          std::span<PrimeField::Number> basis) {
  PrimeField::Number power = 1;
  for (std::size_t i = 0; i < basis.size(); ++i, power = field.multiply(power, x))
    basis[i] = field.multiply(power, binomials[i]);
  power = q;
  for (std::size_t i = basis.size() - 1; i-- > 0; power = field.multiply(power, q))
    basis[i] = field.multiply(basis[i], power);
}

/// The whole work for one prime: writes the remainders of all scaled coefficients to `out`, component by component.
template <std::size_t M, std::size_t N>
void compose_modulo(const PrimeField& field, const IntegerProblem<M, N>& problem,
                    const Grid<N>& out_grid, PrimeField::Number* out) {
  using Number = PrimeField::Number;
  const std::size_t inner_count = problem.inner_grid.count(), points = out_grid.count();
  std::array<std::vector<Number>, M> x, q, binomials, basis;
  for (std::size_t m = 0; m < M; ++m) {
    for (std::size_t i = m * inner_count; i < (m + 1) * inner_count; ++i) {
      x[m].push_back(field.of(problem.x[i]));
      q[m].push_back(field.of(problem.q[i]));
    }
    for (auto* const values : {&x[m], &q[m]}) {
      Grid<N> grid = problem.inner_grid;
      for (std::size_t j = 0; j < N; ++j)
        multiply_axis(field, AxisMatrix::powers(field, out_grid.size[j], grid.size[j]), j, grid,
                      *values);
    }
    for (const Integer& b : binomial_row(problem.degrees[m])) binomials[m].push_back(field.of(b));
    basis[m].resize(binomials[m].size());
  }
  std::vector<Number> net;
  for (const Integer& p : problem.coefficients) net.push_back(field.of(p));
  const auto num_components = static_cast<std::size_t>(problem.num_components);
  std::vector<Number> work(net.size());
  for (std::size_t g = 0; g < points; ++g) {
    for (std::size_t m = 0; m < M; ++m)
      basis_numbers(field, binomials[m], x[m][g], q[m][g], basis[m]);
    const Number* from = net.data();
    std::size_t count = net.size();
    for (std::size_t m = M; m-- > 0; from = work.data()) {
      const std::size_t length = basis[m].size();
      count /= length;
      for (std::size_t i = 0; i < count; ++i)
        work[i] = field.dot(from + i * length, basis[m].data(), length);
    }
    for (std::size_t c = 0; c < num_components; ++c) out[c * points + g] = work[c];
  }
  for (std::size_t c = 0; c < num_components; ++c) {
    std::vector<Number> values(out + c * points, out + (c + 1) * points);
    Grid<N> grid = out_grid;
    for (std::size_t j = 0; j < N; ++j)
      multiply_axis(field, AxisMatrix::interpolation(field, grid.size[j]), j, grid, values);
    std::copy(values.begin(), values.end(), out + c * points);
  }
}

/// The scaled coefficients, component by component. REQUIRES all of them below 2^bits in magnitude.
template <std::size_t M, std::size_t N>
std::vector<Integer> composed_by_remainders(const IntegerProblem<M, N>& problem,
                                            const std::array<int, N>& degrees, std::uint64_t bits) {
  Grid<N> grid;
  for (std::size_t j = 0; j < N; ++j) grid.size[j] = static_cast<std::size_t>(degrees[j]) + 1;
  const std::size_t count = grid.count() * static_cast<std::size_t>(problem.num_components);
  RemainderBasis basis(bits);
  std::vector<PrimeField::Number> remainders(count * basis.fields().size());
  for (std::size_t k = 0; k < basis.fields().size(); ++k)
    compose_modulo(basis.fields()[k], problem, grid, remainders.data() + k * count);
  std::vector<Integer> out;
  out.reserve(count);
  for (std::size_t i = 0; i < count; ++i) out.push_back(basis.combined(&remainders[i], count));
  return out;
}

}  // namespace veritope::internal
