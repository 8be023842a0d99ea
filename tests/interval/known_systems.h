// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/interval/known_systems.h: polynomial systems with all their real roots known, exactly, and the check of a
// solver's answer against them. Equation i is a product of factors l_i(x) - r over numbers r, with l_i linear forms or, bent, l_i(x + a x_last^2 e_0);
// equations are then mixed by a matrix. So the roots are those of linear systems, transformed.
#pragma once
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "interval/solvers/polynomial_roots.h"
#include "robust/base/random.h"

namespace veritope::known {

template <std::size_t N>
using Point = std::array<Rational, N>;

/// A polynomial in powers: values[i] belongs to x^index(i), index < size in every axis.
template <std::size_t N>
struct Powers {
  Grid<N> grid;
  std::vector<Rational> values;

  explicit Powers(const std::array<int, N>& degrees) {
    for (std::size_t a = 0; a < N; ++a) grid.size[a] = static_cast<std::size_t>(degrees[a]) + 1;
    values.resize(grid.count());
  }
  static Powers constant(const Rational& c) {
    Powers out(std::array<int, N>{});
    out.values[0] = c;
    return out;
  }
  static Powers variable(std::size_t axis) {
    std::array<int, N> degrees{};
    degrees[axis] = 1;
    Powers out(degrees);
    out.values[1] = Rational(1);
    return out;
  }
  std::array<std::size_t, N> index(std::size_t i) const {
    std::array<std::size_t, N> out;
    for (std::size_t a = N; a-- > 0; i /= grid.size[a]) out[a] = i % grid.size[a];
    return out;
  }
  friend Powers operator*(const Powers& p, const Powers& q) {
    std::array<int, N> degrees;
    for (std::size_t a = 0; a < N; ++a)
      degrees[a] = static_cast<int>(p.grid.size[a] + q.grid.size[a]) - 2;
    Powers out(degrees);
    for (std::size_t i = 0; i < p.values.size(); ++i)
      for (std::size_t j = 0; j < q.values.size(); ++j) {
        auto at = p.index(i);
        for (std::size_t a = 0; a < N; ++a) at[a] += q.index(j)[a];
        out.values[out.grid.at(at)] += p.values[i] * q.values[j];
      }
    return out;
  }
  friend Powers operator+(const Powers& p, const Powers& q) {
    std::array<int, N> degrees;
    for (std::size_t a = 0; a < N; ++a)
      degrees[a] = static_cast<int>(std::max(p.grid.size[a], q.grid.size[a])) - 1;
    Powers out(degrees);
    for (const Powers* s : {&p, &q})
      for (std::size_t i = 0; i < s->values.size(); ++i)
        out.values[out.grid.at(s->index(i))] += s->values[i];
    return out;
  }
  friend Powers operator*(const Rational& k, Powers p) {
    for (Rational& v : p.values) v *= k;
    return p;
  }
  std::array<int, N> degrees() const {
    std::array<int, N> out;
    for (std::size_t a = 0; a < N; ++a) out[a] = static_cast<int>(grid.size[a]) - 1;
    return out;
  }
  /// x^k = sum over i >= k of C(i, k) / C(d, k) B_i, axis by axis.
  Bezier<Rational, N> bernstein() const {
    std::vector<Rational> work = values;
    for (std::size_t a = 0; a < N; ++a) {
      const std::size_t stride = grid.stride(a), d = grid.size[a] - 1;
      grid.for_each_line(a, [&](std::size_t first) {
        std::vector<Rational> line(d + 1);
        for (std::size_t i = 0; i <= d; ++i) {
          Rational ratio(1);  // C(i, k) / C(d, k)
          for (std::size_t k = 0; k <= i; ++k) {
            line[i] += ratio * work[first + k * stride];
            if (k < i) ratio *= Rational(i - k) / Rational(d - k);
          }
        }
        for (std::size_t i = 0; i <= d; ++i) work[first + i * stride] = line[i];
      });
    }
    return Bezier<Rational, N>(degrees(), 1, false, std::move(work));
  }
};

template <std::size_t N>
struct KnownRoot {
  Point<N> at;
  bool is_simple;
};

template <std::size_t N>
struct KnownSystem {
  std::vector<Bezier<Rational, N>> equations;
  std::vector<KnownRoot<N>> roots;  // all real ones, also outside of [0,1]^N
};

/// How to draw a system.
struct Recipe {
  std::size_t max_factors = 2;      // of an equation
  std::optional<Rational> close{};  // equation 0 has two factors this far apart; 0: a double one
  bool on_boundary = false;         // a root is moved to x_0 = 0 or 1, or to a corner
  bool bent = false;                // not linear forms only
};

inline Rational fraction(Random& random, std::int64_t low, std::int64_t high, std::int64_t q) {
  return Rational(random.between(low, high)) / Rational(q);
}

/// The solution of a regular system, by Cramer's elimination in fractions; empty if singular.
template <std::size_t N>
std::optional<Point<N>> solve(std::array<std::array<Rational, N>, N> m, Point<N> b) {
  for (std::size_t k = 0; k < N; ++k) {
    std::size_t row = k;
    while (row < N && m[row][k] == Rational(0)) ++row;
    if (row == N) return std::nullopt;
    std::swap(m[k], m[row]), std::swap(b[k], b[row]);
    for (std::size_t i = 0; i < N; ++i) {
      if (i == k) continue;
      const Rational f = m[i][k] / m[k][k];
      for (std::size_t j = k; j < N; ++j) m[i][j] -= f * m[k][j];
      b[i] -= f * b[k];
    }
  }
  for (std::size_t k = 0; k < N; ++k) b[k] /= m[k][k];
  return b;
}

template <std::size_t N>
std::array<std::array<Rational, N>, N> regular_matrix(Random& random) {
  for (;;) {
    std::array<std::array<Rational, N>, N> m;
    for (auto& row : m)
      for (Rational& v : row) v = Rational(random.between(-3, 3));
    if (solve<N>(m, {})) return m;
  }
}

template <std::size_t N>
KnownSystem<N> draw(Random& random, const Recipe& recipe) {
  const auto forms = regular_matrix<N>(random);
  const Rational bend = recipe.bent && N > 1 ? fraction(random, -8, 8, 4) : Rational(0);
  // y = x + bend x_last^2 e_0; forms(y) = numbers.
  const auto straight = [&](Point<N> x) {
    if (N > 1) x[0] += bend * x[N - 1] * x[N - 1];
    return x;
  };
  std::array<std::vector<Rational>, N> numbers;
  const std::size_t count = 1 + static_cast<std::size_t>(random.below(recipe.max_factors));
  for (std::size_t k = 0; k < count;
       ++k) {  // through points of the domain, so that there are roots in it
    Point<N> x;
    for (Rational& v : x) v = fraction(random, 1, 96, 97);
    if (k == 0 && recipe.on_boundary) {
      x[0] = Rational(random.between(0, 1));
      if (random.below(2) == 0)
        for (Rational& v : x) v = Rational(random.between(0, 1));
    }
    x = straight(x);
    for (std::size_t i = 0; i < N; ++i) {
      Rational r;
      for (std::size_t j = 0; j < N; ++j) r += forms[i][j] * x[j];
      numbers[i].push_back(r);
    }
  }
  if (recipe.close) numbers[0].push_back(numbers[0][0] + *recipe.close);
  std::vector<Powers<N>> products;
  for (std::size_t i = 0; i < N; ++i) {
    Powers<N> form = Powers<N>::constant(Rational(0));
    for (std::size_t j = 0; j < N; ++j) form = form + forms[i][j] * Powers<N>::variable(j);
    if (bend != Rational(0))
      form = form + forms[i][0] * bend * (Powers<N>::variable(N - 1) * Powers<N>::variable(N - 1));
    Powers<N> product = Powers<N>::constant(Rational(1));
    for (const Rational& r : numbers[i])
      product = product * (form + Powers<N>::constant(Rational(0) - r));
    products.push_back(std::move(product));
  }
  KnownSystem<N> out;
  const auto mix = regular_matrix<N>(random);
  for (std::size_t i = 0; i < N; ++i) {
    Powers<N> sum = Powers<N>::constant(Rational(0));
    for (std::size_t j = 0; j < N; ++j) sum = sum + mix[i][j] * products[j];
    out.equations.push_back(sum.bernstein());
  }
  std::array<std::size_t, N> pick{};
  const auto times = [&](std::size_t i) {
    return std::count(numbers[i].begin(), numbers[i].end(), numbers[i][pick[i]]);
  };
  for (bool more = true; more;) {
    Point<N> r;
    bool is_simple = true;
    for (std::size_t i = 0; i < N; ++i) {
      r[i] = numbers[i][pick[i]];
      is_simple = is_simple && times(i) == 1;
    }
    Point<N> x = *solve<N>(forms, r);
    if (N > 1) x[0] -= bend * x[N - 1] * x[N - 1];
    const bool is_new = std::none_of(out.roots.begin(), out.roots.end(),
                                     [&](const KnownRoot<N>& k) { return k.at == x; });
    if (is_new) out.roots.push_back({x, is_simple});
    std::size_t a = 0;
    while (a < N && ++pick[a] == numbers[a].size()) pick[a++] = 0;
    more = a < N;
  }
  return out;
}

/// equation * factor, through powers of x.
template <std::size_t N>
Bezier<Rational, N> multiplied(const Bezier<Rational, N>& equation, const Powers<N>& factor) {
  Powers<N> sum = Powers<N>::constant(Rational(0));
  const Grid<N> grid = equation.grid();
  for (std::size_t i = 0; i < grid.count(); ++i) {
    Powers<N> term = Powers<N>::constant(equation.coefficients()[i]);
    std::size_t rest = i;
    for (std::size_t a = N; a-- > 0; rest /= grid.size[a]) {
      const std::size_t k = rest % grid.size[a], d = grid.size[a] - 1;
      const Powers<N> x = Powers<N>::variable(a);
      const Powers<N> y = Powers<N>::constant(Rational(1)) + Rational(-1) * x;
      for (std::size_t j = 0; j < d; ++j)  // C(d, k) x^k (1 - x)^(d - k)
        term = (j < k ? Rational(d - j) / Rational(j + 1) : Rational(1)) * (term * (j < k ? x : y));
    }
    sum = sum + term;
  }
  return (sum * factor).bernstein();
}
/// The equation after (x, y) -> (1 - y, x).
inline Bezier<Rational, 2> turned(const Bezier<Rational, 2>& e) {
  Bezier<Rational, 2> out({e.degree(1), e.degree(0)}, 1, false);
  const Grid<2> from = e.grid(), to = out.grid();
  for (std::size_t i = 0; i < from.size[0]; ++i)
    for (std::size_t j = 0; j < from.size[1]; ++j)
      out.coefficients()[to.at({j, from.size[0] - 1 - i})] = e.coefficients()[from.at({i, j})];
  return out;
}

/// What is wrong with an answer, and what was isolated.
struct Tally {
  int missed = 0, false_uniqueness = 0;
  int simple = 0, simple_isolated = 0, multiple = 0, multiple_in_clusters = 0;
};

template <std::size_t N>
Tally judge(const KnownSystem<N>& system, const RootReport<N>& report) {
  Tally t;
  const ExactBox<N> domain = ExactBox<N>::unit();
  for (const IsolatedRoot<N>& root : report.roots) {
    int in_box = 0, in_unique = 0;
    for (const KnownRoot<N>& k : system.roots) {
      in_box += root.box.contains(k.at) && k.is_simple;
      in_unique += root.unique_in.contains(k.at) ? (k.is_simple ? 1 : 2) : 0;
    }
    t.false_uniqueness += in_box != 1 || in_unique != 1 || !is_subset(root.box, root.unique_in);
  }
  for (const KnownRoot<N>& k : system.roots) {
    if (!domain.contains(k.at)) continue;
    const auto holds = [&](const auto& part) { return part.box.contains(k.at); };
    const auto isolated = std::count_if(report.roots.begin(), report.roots.end(), holds);
    const bool in_cluster = std::any_of(report.clusters.begin(), report.clusters.end(), holds);
    t.missed += isolated + (in_cluster ? 1 : 0) == 0;
    t.false_uniqueness += isolated > 1;
    (k.is_simple ? t.simple : t.multiple) += 1;
    if (k.is_simple) t.simple_isolated += isolated == 1;
    if (!k.is_simple) t.multiple_in_clusters += in_cluster;
  }
  return t;
}

}  // namespace veritope::known
