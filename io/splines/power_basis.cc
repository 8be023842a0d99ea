// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/power_basis.cc: from the power basis over [0, 1] to Bernstein's, in integers over a common denominator.
// Theory  b_j = sum over k <= j of C(j, k) c_k with c_k = a_k / C(n, k), along each axis in turn. The binomial
//         transform of c is n rounds of additions: in round r, b_j += b_{j-1} for j = n down to r.
#include <algorithm>

#include "io/splines/spline_builder.h"
#include "splines/binomial.h"

namespace veritope {
namespace {

/// lcm of C(n, k) over k, divided by each C(n, k).
struct Factors {
  Integer common = Integer(1);
  std::vector<Integer> each;
};

Factors factors_of(std::uint64_t degree) {
  Factors out;
  const std::vector<Integer> binomials = binomial_row(static_cast<int>(degree));
  for (const Integer& b : binomials) out.common = lcm(out.common, b);
  for (const Integer& b : binomials) out.each.push_back(divide_exactly(out.common, b));
  return out;
}

/// The coefficients of one component as integers over their common denominator.
struct Numerators {
  Integer denominator = Integer(1);
  std::vector<Integer> values;
};

Numerators numerators_of(const std::vector<Rational>& points, std::size_t first, std::size_t step) {
  Numerators out;
  for (std::size_t i = first; i < points.size(); i += step)
    out.denominator = lcm(out.denominator, points[i].denominator());
  out.values.reserve(points.size() / step);
  for (std::size_t i = first; i < points.size(); i += step)
    out.values.push_back(points[i].numerator() *
                         divide_exactly(out.denominator, points[i].denominator()));
  return out;
}

// Transforms along the axis on which neighbours are `stride` apart.
void transform(std::vector<Integer>& values, std::size_t count, std::size_t stride,
               const Factors& factors) {
  for (std::size_t block = 0; block < values.size(); block += stride * count)
    for (std::size_t first = block; first < block + stride; ++first) {
      const auto at = [&](std::size_t k) -> Integer& { return values[first + k * stride]; };
      for (std::size_t k = 0; k < count; ++k) at(k) *= factors.each[k];
      for (std::size_t round = 1; round < count; ++round)
        for (std::size_t j = count - 1; j >= round; --j) at(j) += at(j - 1);
    }
}

/// A bound of the bits of a component's results, numerator and denominator together.
std::uint64_t most_bits(const std::vector<Rational>& points, std::size_t first, std::size_t step) {
  std::uint64_t numerator = 0;
  Integer common(1);
  for (std::size_t i = first; i < points.size(); i += step) {
    numerator = std::max(numerator, points[i].numerator().bit_length());
    common = lcm(common, points[i].denominator());
  }
  return numerator + 2 * common.bit_length();
}

}  // namespace

template <std::size_t N>
bool power_to_bernstein(RawSpline<N>& raw, NumberBudget& budget) {
  const auto components = static_cast<std::size_t>(raw.num_components);
  std::array<Factors, N> factors;
  std::uint64_t factor_bits = 0;
  for (std::size_t a = 0; a < N; ++a) {
    factors[a] = factors_of(raw.num_control[a] - 1);
    factor_bits += 2 * factors[a].common.bit_length() + raw.num_control[a];
  }
  const std::uint64_t count = raw.points.size() / components;
  for (std::size_t c = 0; c < components; ++c)
    if (!budget.spend(count * ((most_bits(raw.points, c, components) + factor_bits) / 8 + 1)))
      return false;
  for (std::size_t c = 0; c < components; ++c) {
    Numerators component = numerators_of(raw.points, c, components);
    std::size_t stride = 1;
    for (std::size_t a = 0; a < N; stride *= static_cast<std::size_t>(raw.num_control[a++])) {
      transform(component.values, static_cast<std::size_t>(raw.num_control[a]), stride, factors[a]);
      component.denominator *= factors[a].common;
    }
    for (std::size_t i = 0; i < count; ++i)
      raw.points[i * components + c] =
          Rational(std::move(component.values[i]), component.denominator);
  }
  return true;
}

template bool power_to_bernstein(RawSpline<1>&, NumberBudget&);
template bool power_to_bernstein(RawSpline<2>&, NumberBudget&);
template bool power_to_bernstein(RawSpline<3>&, NumberBudget&);

}  // namespace veritope
