// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/solvers/exact_bernstein.h"

#include "interval/solvers/mp_restriction_internal.h"

namespace veritope {
namespace {

// C(n, 0) ... C(n, n).
std::vector<Rational> binomials(int n) {
  std::vector<Rational> out{Rational(1)};
  for (int k = 0; k < n; ++k) out.push_back(out.back() * Rational(n - k) / Rational(k + 1));
  return out;
}

// Coefficients times (or divided by) the products of binomials that turn products of Bernstein polynomials into convolutions.
template <std::size_t N>
void scale(ExactPolynomial<N>& p, bool multiply) {
  std::array<std::vector<Rational>, N> factors;
  for (std::size_t a = 0; a < N; ++a) factors[a] = binomials(p.degree(a));
  const Grid<N> grid = p.grid();
  for (std::size_t i = 0; i < grid.count(); ++i) {
    const auto index = grid.index_of(i);
    for (std::size_t a = 0; a < N; ++a) {
      if (multiply) {
        p.coefficients()[i] *= factors[a][index[a]];
      } else {
        p.coefficients()[i] /= factors[a][index[a]];
      }
    }
  }
}

}  // namespace

template <std::size_t N>
ExactPolynomial<N> product(const ExactPolynomial<N>& a, const ExactPolynomial<N>& b) {
  std::array<int, N> degrees;
  for (std::size_t i = 0; i < N; ++i) degrees[i] = a.degree(i) + b.degree(i);
  ExactPolynomial<N> p = a, q = b, out(degrees, 1, false);
  scale(p, true), scale(q, true);
  const Grid<N> from = p.grid(), with = q.grid(), to = out.grid();
  for (std::size_t i = 0; i < from.count(); ++i) {
    if (p.coefficients()[i].sign() == Sign::kZero) continue;
    for (std::size_t j = 0; j < with.count(); ++j) {
      auto index = from.index_of(i);
      const auto other = with.index_of(j);
      for (std::size_t k = 0; k < N; ++k) index[k] += other[k];
      out.coefficients()[to.at(index)] += p.coefficients()[i] * q.coefficients()[j];
    }
  }
  scale(out, false);
  return out;
}

template <std::size_t N>
ExactPolynomial<N> raised(const ExactPolynomial<N>& map, std::size_t axis) {
  auto degrees = map.degrees();
  const auto n = static_cast<std::size_t>(++degrees[axis]);
  ExactPolynomial<N> out(degrees, 1, false);
  const Grid<N> from = map.grid(), to = out.grid();
  const std::size_t stride = to.stride(axis);
  std::vector<std::size_t> starts;
  from.for_each_line(axis, [&](std::size_t first) { starts.push_back(first); });
  std::size_t line = 0;
  to.for_each_line(axis, [&](std::size_t first) {
    const Rational* const p = map.component(0).data() + starts[line++];
    Rational* const q = out.component(0).data() + first;
    for (std::size_t i = 0; i <= n; ++i) {
      const Rational share = Rational(i) / Rational(n);
      Rational value;
      if (i > 0) value += share * p[(i - 1) * stride];
      if (i < n) value += (Rational(1) - share) * p[i * stride];
      q[i * stride] = std::move(value);
    }
  });
  return out;
}

template <std::size_t N>
ExactPolynomial<N> sum(const ExactPolynomial<N>& a, const ExactPolynomial<N>& b,
                       const Rational& k) {
  ExactPolynomial<N> p = a, q = b;
  for (std::size_t i = 0; i < N; ++i) {
    while (p.degree(i) < q.degree(i)) p = raised(p, i);
    while (q.degree(i) < p.degree(i)) q = raised(q, i);
  }
  for (std::size_t i = 0; i < p.coefficients().size(); ++i)
    p.coefficients()[i] += k * q.coefficients()[i];
  return p;
}

template <std::size_t N>
ExactPolynomial<N> derivative(const ExactPolynomial<N>& a, std::size_t axis) {
  auto degrees = a.degrees();
  const int n = degrees[axis];
  if (n == 0) return ExactPolynomial<N>(degrees, 1, false);
  --degrees[axis];
  ExactPolynomial<N> out(degrees, 1, false);
  const Grid<N> from = a.grid(), to = out.grid();
  for (std::size_t i = 0; i < to.count(); ++i) {
    auto index = to.index_of(i);
    const Rational& low = a.coefficients()[from.at(index)];
    ++index[axis];
    out.coefficients()[i] = Rational(n) * (a.coefficients()[from.at(index)] - low);
  }
  return out;
}

template <std::size_t N>
Bezier<Interval, N> enclosed_on(const Bezier<Rational, N>& map, const ExactBox<N>& box,
                                int precision) {
  Bezier<Interval, N> out(map.degrees(), map.num_components(), map.is_rational());
  for (int c = 0; c < map.num_components(); ++c) {
    std::vector<MpInterval> values;
    for (const Rational& v : map.component(c)) values.emplace_back(v, precision);
    internal::restrict_to(values, map.grid(), box, precision);
    for (std::size_t i = 0; i < values.size(); ++i) out.component(c)[i] = values[i].to_interval();
  }
  return out;
}

#define VT_INSTANTIATE(N)                                                                    \
  template ExactPolynomial<N> product(const ExactPolynomial<N>&, const ExactPolynomial<N>&); \
  template ExactPolynomial<N> sum(const ExactPolynomial<N>&, const ExactPolynomial<N>&,      \
                                  const Rational&);                                          \
  template ExactPolynomial<N> derivative(const ExactPolynomial<N>&, std::size_t);            \
  template ExactPolynomial<N> raised(const ExactPolynomial<N>&, std::size_t);                \
  template Bezier<Interval, N> enclosed_on(const Bezier<Rational, N>&, const ExactBox<N>&, int);
VT_INSTANTIATE(1)
VT_INSTANTIATE(2)
VT_INSTANTIATE(3)
VT_INSTANTIATE(4)
#undef VT_INSTANTIATE

}  // namespace veritope
