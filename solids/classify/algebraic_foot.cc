// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/algebraic_foot_internal.h"

#include <algorithm>
#include <utility>

#include "robust/short_relation.h"
#include "solids/patches/common_roots.h"
#include "splines/binomial.h"

namespace veritope::internal {
namespace {

constexpr int kMostDegree = 6;

// Polynomials of one parameter are coefficients of 1, t, t^2, ...; of two parameters, one of v for each power of u.
using Rows = std::vector<Polynomial>;

// The remainder of division by m, of degree d: d coefficients.
Polynomial remainder(Polynomial a, const std::vector<Integer>& m) {
  const std::size_t d = m.size() - 1;
  while (a.size() > d) {
    const Rational factor = a.back() / Rational(m.back());
    const std::size_t shift = a.size() - 1 - d;
    if (factor.sign() != 0)
      for (std::size_t i = 0; i < d; ++i) a[shift + i] -= factor * Rational(m[i]);
    a.pop_back();
  }
  a.resize(d);
  return a;
}

Polynomial product(const Polynomial& a, const Polynomial& b) {
  if (a.empty() || b.empty()) return {};
  Polynomial out(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) out[i + j] += a[i] * b[j];
  return out;
}

bool is_zero(const Polynomial& a) {
  return std::all_of(a.begin(), a.end(), [](const Rational& x) { return x.sign() == 0; });
}

// The form of a net of Bernstein coefficients in powers of u and v.
Rows powers(const TensorForm& form, const std::vector<Integer>& net) {
  const auto columns = static_cast<std::size_t>(form.degrees[1] + 1);
  Rows rows;
  for (int i = 0; i <= form.degrees[0]; ++i) {
    std::vector<Rational> bernstein;
    for (std::size_t j = 0; j < columns; ++j)
      bernstein.push_back(net[static_cast<std::size_t>(i) * columns + j]);
    rows.push_back(polynomial_of(bernstein));
    rows.back().resize(columns);
  }
  Rows out(rows.size(), Polynomial(columns));
  for (std::size_t j = 0; j < columns; ++j) {
    std::vector<Rational> bernstein;
    for (const Polynomial& row : rows) bernstein.push_back(row[j]);
    const Polynomial column = polynomial_of(bernstein);
    for (std::size_t i = 0; i < column.size(); ++i) out[i][j] = column[i];
  }
  return out;
}

// Whether the polynomial is 0 wherever both m(u) = 0 and n(v) = 0.
bool vanishes(const Rows& f, const std::vector<Integer>& m, const std::vector<Integer>& n) {
  std::vector<Polynomial> columns(n.size() - 1);  // polynomials of u, for each power of v
  for (const Polynomial& row : f) {
    const Polynomial rest = remainder(row, n);
    for (std::size_t j = 0; j < columns.size(); ++j) columns[j].push_back(rest[j]);
  }
  return std::all_of(columns.begin(), columns.end(),
                     [&](const Polynomial& c) { return is_zero(remainder(c, m)); });
}

// Whether it is 0 wherever m(t) = 0 and the other parameter is `other` of t. The rows belong to powers of t.
bool vanishes_along(const Rows& f, const std::vector<Integer>& m, const Polynomial& other) {
  Polynomial sum;
  for (std::size_t j = f.front().size(); j-- > 0;) {  // Horner's scheme for the other parameter
    sum = remainder(product(sum, other), m);
    Polynomial of_t;
    for (const Polynomial& row : f) of_t.push_back(row[j]);
    of_t = remainder(of_t, m);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += of_t[i];
  }
  return is_zero(sum);
}

Rows transposed(const Rows& f) {
  Rows out(f.front().size());
  for (const Polynomial& row : f)
    for (std::size_t j = 0; j < row.size(); ++j) out[j].push_back(row[j]);
  return out;
}

Rational value_at(const std::vector<Integer>& m, const Rational& t) {
  Rational out;
  for (std::size_t i = m.size(); i-- > 0;) out = out * t + Rational(m[i]);
  return out;
}

// A root of m in [0,1] near t; nothing if the signs of m do not show one.
std::optional<AlgebraicNumber> root_near(std::vector<Integer> m, const Rational& t, int bits) {
  AlgebraicNumber out;
  if (m.size() == 2) {
    out.lo = out.hi = Rational(-m[0], m[1]);
    if (out.lo.sign() < 0 || out.lo > Rational(1)) return std::nullopt;
  } else {
    const Rational reach = Rational::power_of_two(-bits);
    out.lo = std::max(t - reach, Rational(0));
    out.hi = std::min(t + reach, Rational(1));
    if (!(out.lo < out.hi) ||
        value_at(m, out.lo).sign() * value_at(m, out.hi).sign() != Sign::kNegative)
      return std::nullopt;
  }
  out.polynomial = std::move(m);
  return out;
}

// t times 2^bits, rounded down.
Integer fixed_point(const Dyadic& t, int bits) {
  Integer m = t.mantissa();
  const std::int64_t shift = t.exponent() + bits;
  if (shift >= 0) return m.shift_left(static_cast<std::uint64_t>(shift));
  return m.shift_right(static_cast<std::uint64_t>(-shift));
}

// y as a polynomial of x, which has the degree d, by their first bits; empty if none is short.
Polynomial expressed(const Integer& y, const Integer& x, std::size_t d, int bits) {
  std::vector<Integer> values{power_of_two(static_cast<std::uint64_t>(bits))};
  while (values.size() < d)
    values.push_back((values.back() * x).shift_right(static_cast<std::uint64_t>(bits)));
  values.push_back(y);
  const std::vector<Integer> c = short_relation(values, bits);
  if (c.back().is_zero()) return {};
  Polynomial out;
  for (std::size_t i = 0; i + 1 < c.size(); ++i) out.push_back(Rational(-c[i], c.back()));
  return out;
}

// Whether the polynomial maps [x.lo, x.hi], 0 <= x.lo, into [y.lo, y.hi], and every root of x's polynomial to one of
// y's.
bool maps_to(const Polynomial& f, const AlgebraicNumber& x, const AlgebraicNumber& y) {
  Rational least, most, a(1), b(1);
  for (const Rational& c : f) {
    least += c * (c.sign() > 0 ? a : b);
    most += c * (c.sign() > 0 ? b : a);
    a *= x.lo;
    b *= x.hi;
  }
  if (least < y.lo || most > y.hi) return false;
  Polynomial value;
  for (std::size_t i = y.polynomial.size(); i-- > 0;) {  // Horner's scheme
    value = remainder(product(value, f), x.polynomial);
    value[0] += Rational(y.polynomial[i]);
  }
  return is_zero(value);
}

}  // namespace

std::optional<AlgebraicPair> algebraic_parameters(const TensorForm& form,
                                                  const std::array<std::vector<Integer>, 3>& net,
                                                  const std::array<Dyadic, 2>& at, int bits) {
  std::array<Integer, 2> x;
  AlgebraicPair out;
  for (std::size_t k = 0; k < 2; ++k) {
    x[k] = fixed_point(at[k], bits);
    if (x[k].sign() < 0 || x[k] > power_of_two(static_cast<std::uint64_t>(bits)))
      return std::nullopt;
    std::vector<Integer> m = plausible_polynomial(x[k], bits, kMostDegree);
    if (m.empty()) return std::nullopt;
    auto root = root_near(std::move(m), at[k].to_rational(), bits / 2);
    if (!root) return std::nullopt;
    out.numbers[k] = std::move(*root);
  }
  std::array<Rows, 3> f;
  for (std::size_t k = 0; k < 3; ++k) f[k] = powers(form, net[k]);
  const auto &m = out[0].polynomial, &n = out[1].polynomial;
  const auto all = [&](auto is_zero_on) { return std::all_of(f.begin(), f.end(), is_zero_on); };
  if (all([&](const Rows& g) { return vanishes(g, m, n); })) return out;
  if (out[0].is_rational() || out[1].is_rational()) return std::nullopt;
  // The two depend on each other: number k is a polynomial of the other, whose root is enclosed more narrowly.
  for (const std::size_t k : {std::size_t{1}, std::size_t{0}}) {
    const std::size_t j = 1 - k;
    auto narrow = root_near(out[j].polynomial, at[j].to_rational(), bits - 8);
    Polynomial relation = expressed(x[k], x[j], out[j].polynomial.size() - 1, bits);
    if (!narrow || relation.empty() || !maps_to(relation, *narrow, out[k])) continue;
    if (!all([&](const Rows& g) {
          return vanishes_along(k == 1 ? g : transposed(g), narrow->polynomial, relation);
        }))
      continue;
    out.numbers[j] = std::move(*narrow);
    out.relation = std::move(relation);
    out.dependent = k;
    return out;
  }
  return std::nullopt;
}

}  // namespace veritope::internal
