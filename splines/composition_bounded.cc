// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/composition_bounded.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robust/base/fp_guard.h"
#include "splines/composition.h"
#include "splines/polynomial_filter.h"

namespace veritope {
namespace {

using internal::DoubleAlgebra;
using Polynomial = DoubleAlgebra::Polynomial;

constexpr double kUnit = 0x1p-53;         // a rounding's relative error
constexpr double kUnderflow = 0x1p-1074;  // twice what a product loses by underflow
constexpr double kSlack = 1 + 0x1p-10;  // for the roundings of the few operations that make a bound

template <std::size_t N>
Grid<3> as_volume(const Grid<N>& grid) {
  Grid<3> g{{1, 1, 1}};
  for (std::size_t j = 0; j < N; ++j) g.size[3 - N + j] = grid.size[j];
  return g;
}

// Roundings in an entry of binomial_grid<double> of these degrees: none while the largest is below 2^53.
template <std::size_t N>
int binomial_roundings(const std::array<int, N>& degrees) {
  double largest = 1;
  for (const int n : degrees)
    for (int i = 0; i < n / 2; ++i) largest = largest * (n - i) / (i + 1);
  return largest < 0x1p52 ? 0 : 2 * static_cast<int>(N) - 1;
}

struct Inner {
  std::vector<Polynomial> x, q;
  bool is_in_unit_cube = true;  // all coefficients of x and q are at least 0
};

template <std::size_t M, std::size_t N>
Inner prepare(const Bezier<double, N>& map) {
  const auto binomials = internal::binomial_grid<double>(map.grid());
  Inner inner;
  for (std::size_t m = 0; m < M; ++m) {
    Polynomial x{as_volume(map.grid()), {}}, q = x;
    for (std::size_t i = 0; i < binomials.size(); ++i) {
      const double v = map.component(static_cast<int>(m))[i];
      const double rest = (map.is_rational() ? map.component(static_cast<int>(M))[i] : 1.0) - v;
      inner.is_in_unit_cube &= v >= 0 && rest >= 0;
      x.c.push_back(binomials[i] * v);
      q.c.push_back(binomials[i] * rest);
    }
    inner.x.push_back(std::move(x));
    inner.q.push_back(std::move(q));
  }
  return inner;
}

Inner absolute(Inner inner) {
  for (auto* const list : {&inner.x, &inner.q})
    for (Polynomial& p : *list)
      for (double& c : p.c) c = std::abs(c);
  return inner;
}

// What the algorithm needs of an inner map: of the map itself, or of the absolute values of its coefficients.
template <std::size_t M>
struct Prepared {
  internal::InnerMap<DoubleAlgebra, M> map;
  std::vector<Polynomial> basis;

  Prepared(Inner inner, const std::array<int, M>& degrees) {
    std::move(inner.x.begin(), inner.x.end(), map.x.begin());
    std::move(inner.q.begin(), inner.q.end(), map.q.begin());
    basis =
        internal::basis_polynomials(DoubleAlgebra(), degrees[M - 1], map.x[M - 1], map.q[M - 1]);
  }
  std::vector<double> composed(const std::array<int, M>& degrees,
                               std::span<const double> coefficients) const {
    return internal::compose_component<DoubleAlgebra, M>(DoubleAlgebra(), degrees, coefficients,
                                                         map, basis)
        .c;
  }
};

double sum_of_sizes(const Polynomial& p) {
  double sum = 0;
  for (const double c : p.c) sum += std::abs(c);
  return sum;
}

// The error that underflow may have made in a scaled coefficient of a component: docs/bounds/composition.md, section 3.
template <std::size_t M>
double underflow_error(const std::array<int, M>& degrees, const Inner& inner, double largest) {
  const auto blended = [&](double error, std::size_t m) {
    const double terms = 2 * static_cast<double>(inner.q[m].c.size());
    for (int level = 0; level < degrees[m]; ++level)
      error = ((sum_of_sizes(inner.q[m]) + sum_of_sizes(inner.x[m])) * error + terms * kUnderflow) *
              kSlack;
    return error;
  };
  const double basis = static_cast<double>(degrees[M - 1]) + 1;
  double error = basis * (largest * blended(0, M - 1) + kUnderflow) * kSlack;
  for (std::size_t m = M - 1; m-- > 0;) error = blended(error, m);
  return error;
}

bool has_one_sign(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return v >= 0; }) ||
         std::all_of(values.begin(), values.end(), [](double v) { return v <= 0; });
}

// values /= scales; error = the bound.
void finish(std::span<double> values, std::vector<double> majorants,
            const std::vector<double>& scales, double relative, double underflow, double* error) {
  for (std::size_t i = 0; i < scales.size(); ++i) {
    values[i] /= scales[i];
    const double e = (relative * std::abs(majorants[i] / scales[i]) + underflow) * kSlack;
    error[i] =
        e < std::numeric_limits<double>::infinity() ? e : std::numeric_limits<double>::infinity();
  }
}

}  // namespace

template <std::size_t M, std::size_t N>
int internal::composition_roundings(const std::array<int, M>& outer,
                                    const std::array<int, N>& inner) {
  const Grid<3> small = as_volume(Bezier<double, N>(inner, 0, false).grid());
  const int factor = 2 + binomial_roundings(inner);  // 1 - x, times a binomial coefficient
  const int last = outer[M - 1];
  int sum = 0;
  for (const int a : outer) sum += a;
  // The last variable's triangle begins with a product, not a blend; later blends begin with x, not q = 1 - x.
  const int first_product =
      last == 0 ? 0 : filter_roundings(small, 2) - filter_roundings(small, 1) + (last == 1 ? 0 : 1);
  return sum * (filter_roundings(small, 2) + factor) - first_product + (1 + last) +
         (binomial_roundings(composed_degrees(outer, inner)) + 1);
}

template <std::size_t M, std::size_t N>
Result<BoundedBezier<N>> compose_bounded(const Bezier<double, M>& outer_map,
                                         const Bezier<double, N>& inner) {
  if (Status status = internal::check_finite(outer_map.coefficients(), "outer"); !status)
    return status.error();
  if (Status status = internal::check_finite(inner.coefficients(), "inner"); !status)
    return status.error();
  const auto outer = internal::with_weight_if(inner.is_rational(), outer_map, 1.0);
  const auto& degrees = outer.degrees();
  if (Status status = internal::check_composition(degrees, inner.degrees(), inner.dimension(),
                                                  outer.num_components());
      !status)
    return status.error();
  const ScopedDefaultFp to_nearest;
  if (Status status = check_fp(); !status) return status.error();

  Bezier<double, N> out(composed_degrees(degrees, inner.degrees()), outer.num_components(),
                        outer.is_rational());
  const auto scales = internal::binomial_grid<double>(out.grid());
  std::vector<double> error(out.coefficients().size());
  const double k = internal::composition_roundings(degrees, inner.degrees());
  const double relative = k * kUnit / (1 - 2 * k * kUnit);
  const Inner scaled = prepare<M>(inner), sizes = absolute(scaled);
  const Prepared<M> plain(scaled, degrees), majorant(sizes, degrees);
  for (int c = 0; c < outer.num_components(); ++c) {
    const std::span<const double> coefficients = outer.component(c);
    std::vector<double> absolutes(coefficients.begin(), coefficients.end());
    for (double& v : absolutes) v = std::abs(v);
    const double largest = *std::max_element(absolutes.begin(), absolutes.end());
    const std::vector<double> values = plain.composed(degrees, coefficients);
    const bool is_own_majorant = scaled.is_in_unit_cube && has_one_sign(coefficients);
    std::copy(values.begin(), values.end(), out.component(c).begin());
    finish(out.component(c), is_own_majorant ? values : majorant.composed(degrees, absolutes),
           scales, relative, 2 * (underflow_error(degrees, scaled, largest) + kUnderflow),
           error.data() + static_cast<std::size_t>(c) * scales.size());
  }
  return BoundedBezier<N>{std::move(out), std::move(error)};
}

#define VT_COMPOSE_BOUNDED(M, N)                                               \
  template Result<BoundedBezier<N>> compose_bounded(const Bezier<double, M>&,  \
                                                    const Bezier<double, N>&); \
  template int internal::composition_roundings(const std::array<int, M>&,      \
                                               const std::array<int, N>&);
VT_COMPOSE_BOUNDED(1, 1)
VT_COMPOSE_BOUNDED(1, 2)
VT_COMPOSE_BOUNDED(1, 3)
VT_COMPOSE_BOUNDED(2, 1)
VT_COMPOSE_BOUNDED(2, 2)
VT_COMPOSE_BOUNDED(2, 3)
VT_COMPOSE_BOUNDED(3, 1)
VT_COMPOSE_BOUNDED(3, 2)
VT_COMPOSE_BOUNDED(3, 3)
#undef VT_COMPOSE_BOUNDED

}  // namespace veritope
