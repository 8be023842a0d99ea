// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/enclosed_place_internal.h"

#include <algorithm>

#include "solids/expression/patch_jet_internal.h"

namespace veritope::internal {
namespace {

constexpr int kPlaceBits = 128;

Sign sign_at(const std::vector<Integer>& polynomial, const Rational& t) {
  Rational value;
  for (std::size_t i = polynomial.size(); i-- > 0;) value = value * t + Rational(polynomial[i]);
  return value.sign();
}

ExactInterval around(const Rational& x, const Rational& radius) { return {x - radius, x + radius}; }

// The greatest absolute value of a coefficient of a component.
Rational greatest(std::span<const Rational> coefficients) {
  Rational out;
  for (const Rational& c : coefficients) out = std::max(out, c.sign() < 0 ? -c : c);
  return out;
}

}  // namespace

ExactInterval enclosed(const AlgebraicNumber& a) {
  ExactInterval out{std::max(a.lo, Rational(0)), std::min(a.hi, Rational(1))};
  if (a.is_rational() || !a.is_known()) return out;
  const Sign low = sign_at(a.polynomial, a.lo);
  ExactInterval root{a.lo, a.hi};
  const Rational goal = Rational::power_of_two(-kPlaceBits), half = Rational::power_of_two(-1);
  while (root.width() > goal) {
    const Rational middle = half * (root.lo + root.hi);
    const Sign s = sign_at(a.polynomial, middle);
    if (s == 0) return {middle, middle};
    (s == low ? root.lo : root.hi) = middle;
  }
  return {std::max(root.lo, Rational(0)), std::min(root.hi, Rational(1))};
}

ExactInterval sum(const ExactInterval& a, const ExactInterval& b) {
  return {a.lo + b.lo, a.hi + b.hi};
}
ExactInterval difference(const ExactInterval& a, const ExactInterval& b) {
  return {a.lo - b.hi, a.hi - b.lo};
}
ExactInterval product(const ExactInterval& a, const ExactInterval& b) {
  const Rational ends[] = {a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi};
  const auto [least, most] = std::minmax_element(std::begin(ends), std::end(ends));
  return {*least, *most};
}

std::array<ExactInterval, 2> domain_enclosure(const Patch& patch, const AlgebraicPair& at) {
  const ExactInterval u = enclosed(at[0]), v = enclosed(at[1]);
  if (!patch.is_triangle()) return {u, v};
  return {product(u, difference({1, 1}, v)), product(u, v)};
}

// A component of degree n (along each axis of a square) with coefficients of at most c has derivatives of at most 2 n c
// and second ones of at most 4 n^2 c. So within r of the middle along both axes a value changes by at most 4 n c r, a
// derivative by 8 n^2 c r. r is twice what it need be: a box may stick out of a triangle by its width, where the bounds
// grow by much less than a factor of 2.
JetEnclosure jet_enclosure(const Patch& patch, const std::array<ExactInterval, 2>& at) {
  const Rational half = Rational::power_of_two(-1), r = std::max(at[0].width(), at[1].width()),
                 n(patch.max_degree());
  const DomainPlace middle{half * (at[0].lo + at[0].hi), half * (at[1].lo + at[1].hi)};
  const std::vector<Rational> f = homogeneous_at(patch, middle),
                              d[2] = {homogeneous_derivative_at(patch, 0, middle),
                                      homogeneous_derivative_at(patch, 1, middle)};
  std::array<ExactInterval, 4> values;
  std::array<std::array<ExactInterval, 4>, 2> slopes;
  for (std::size_t k = 0; k < f.size(); ++k) {
    const Rational c = greatest(patch.component(static_cast<int>(k)));
    values[k] = around(f[k], Rational(4) * n * c * r);
    for (std::size_t axis = 0; axis < 2; ++axis)
      slopes[axis][k] = around(d[axis][k], Rational(8) * n * n * c * r);
  }
  JetEnclosure out;
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t k = 0; k < 3; ++k)
      out.tangents[axis][k] = f.size() == 3 ? slopes[axis][k]
                                            : difference(product(slopes[axis][k], values[3]),
                                                         product(values[k], slopes[axis][3]));
  out.normal = crossed(out.tangents[0], out.tangents[1]);
  return out;
}

std::array<ExactInterval, 2> side_enclosure(const Patch& patch, std::uint32_t side,
                                            const ExactInterval& along) {
  const DomainPlace a = on_side(patch, side, along.lo), b = on_side(patch, side, along.hi);
  std::array<ExactInterval, 2> out;
  for (std::size_t k = 0; k < 2; ++k) out[k] = {std::min(a[k], b[k]), std::max(a[k], b[k])};
  return out;
}

EnclosedVector along_side(const Patch& patch, std::uint32_t side, const JetEnclosure& at) {
  const auto& [u, v] = at.tangents;
  EnclosedVector out;
  for (std::size_t k = 0; k < 3; ++k) {
    const ExactInterval zero{0, 0}, back_u = difference(zero, u[k]),
                                    back_v = difference(zero, v[k]);
    if (patch.is_triangle())
      out[k] = side == 0 ? u[k] : side == 1 ? difference(v[k], u[k]) : back_v;
    else
      out[k] = side == 0 ? u[k] : side == 1 ? v[k] : side == 2 ? back_u : back_v;
  }
  return out;
}

EnclosedVector crossed(const EnclosedVector& a, const EnclosedVector& b) {
  EnclosedVector out;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t p = (k + 1) % 3, q = (k + 2) % 3;
    out[k] = difference(product(a[p], b[q]), product(a[q], b[p]));
  }
  return out;
}

ExactInterval dotted(const EnclosedVector& a, const EnclosedVector& b) {
  return sum(sum(product(a[0], b[0]), product(a[1], b[1])), product(a[2], b[2]));
}

Sign sign_of(const ExactInterval& a) {
  return a.lo.sign() > 0 ? Sign::kPositive : a.hi.sign() < 0 ? Sign::kNegative : Sign::kZero;
}

}  // namespace veritope::internal
