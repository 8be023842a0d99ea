// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/algebraic_number.h"

#include <algorithm>
#include <utility>

namespace veritope {
namespace {

using Row = std::vector<Rational>;

Rational value_of(const Row& polynomial, const Rational& t) {
  Rational out;
  for (std::size_t i = polynomial.size(); i-- > 0;) out = out * t + polynomial[i];
  return out;
}

Row as_row(const std::vector<Integer>& polynomial) {
  return {polynomial.begin(), polynomial.end()};
}

// Polynomials in u and v modulo m(u) and n(v): coefficients of u^i v^j at i deg n + j.
class PairAlgebra {
 public:
  PairAlgebra(Row m, Row n) : m_(std::move(m)), n_(std::move(n)) {}

  std::size_t size() const { return (m_.size() - 1) * columns(); }
  Row one() const {
    Row out(size());
    out[0] = Rational(1);
    return out;
  }
  Row times_u(const Row& a) const { return times(a, m_, columns(), m_.size() - 1, 1); }
  Row times_v(const Row& a) const { return times(a, n_, 1, columns(), columns()); }

 private:
  std::size_t columns() const { return n_.size() - 1; }
  // Multiplies by the variable whose powers are `stride` apart and run to degree - 1; `step` separates its lines.
  Row times(const Row& a, const Row& modulus, std::size_t stride, std::size_t degree,
            std::size_t step) const {
    Row out(a.size());
    const std::size_t lines = a.size() / degree;
    for (std::size_t line = 0; line < lines; ++line) {
      const std::size_t first = line * step;
      const Rational top = a[first + (degree - 1) * stride] / modulus.back();
      for (std::size_t i = 0; i < degree; ++i) {
        Rational x = i == 0 ? Rational(0) : a[first + (i - 1) * stride];
        x -= top * modulus[i];
        out[first + i * stride] = std::move(x);
      }
    }
    return out;
  }

  Row m_, n_;
};

// Solves sum x_i rows[i] = b for a square system; nothing if it is singular.
class Elimination {
 public:
  // Keeps the inverse's action: rows are reduced beside the identity.
  static std::optional<Elimination> of(std::vector<Row> rows) {
    const std::size_t n = rows.size();
    Elimination out;
    out.combination_.assign(n, Row(n));
    for (std::size_t i = 0; i < n; ++i) out.combination_[i][i] = Rational(1);
    for (std::size_t column = 0; column < n; ++column) {
      std::size_t pivot = column;
      while (pivot < n && rows[pivot][column].sign() == 0) ++pivot;
      if (pivot == n) return std::nullopt;
      std::swap(rows[pivot], rows[column]);
      std::swap(out.combination_[pivot], out.combination_[column]);
      for (std::size_t i = 0; i < n; ++i) {
        if (i == column || rows[i][column].sign() == 0) continue;
        const Rational factor = rows[i][column] / rows[column][column];
        for (std::size_t k = 0; k < n; ++k) {
          rows[i][k] -= factor * rows[column][k];
          out.combination_[i][k] -= factor * out.combination_[column][k];
        }
      }
    }
    for (std::size_t i = 0; i < n; ++i) out.pivots_.push_back(rows[i][i]);
    return out;
  }
  Row solve(const Row& b) const {
    Row out(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) {
      if (b[i].sign() == 0) continue;
      const Rational factor = b[i] / pivots_[i];
      for (std::size_t k = 0; k < b.size(); ++k) out[k] += factor * combination_[i][k];
    }
    return out;
  }

 private:
  std::vector<Row> combination_;
  Row pivots_;
};

bool has_root_between(const Row& modulus, const Rational& lo, const Rational& hi) {
  return value_of(modulus, lo).sign() * value_of(modulus, hi).sign() == Sign::kNegative;
}

// One number generates the other, or the other is rational.
PrimitivePair generated_by(const AlgebraicPair& pair, std::size_t k) {
  const AlgebraicNumber& t = pair[k];
  PrimitivePair out{as_row(t.polynomial), t.lo, t.hi, {}};
  out.numbers[k] = {Rational(0), Rational(1)};
  out.numbers[1 - k] = pair.relation.empty() ? Row{pair[1 - k].lo} : pair.relation;
  return out;
}

}  // namespace

std::vector<Rational> product_modulo(const std::vector<Rational>& a, const std::vector<Rational>& b,
                                     const std::vector<Rational>& modulus) {
  const std::size_t d = modulus.size() - 1;
  Row out(std::max(a.size() + b.size(), d + 1));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) out[i + j] += a[i] * b[j];
  while (out.size() > d) {
    const Rational factor = out.back() / modulus.back();
    const std::size_t shift = out.size() - 1 - d;
    for (std::size_t i = 0; i < d; ++i) out[shift + i] -= factor * modulus[i];
    out.pop_back();
  }
  return out;
}

std::optional<PrimitivePair> primitive_pair(const AlgebraicPair& pair) {
  if (pair.is_rational() || !pair[0].is_known() || !pair[1].is_known()) return std::nullopt;
  if (!pair.relation.empty()) return generated_by(pair, 1 - pair.dependent);
  for (std::size_t k = 0; k < 2; ++k)
    if (pair[1 - k].is_rational()) return generated_by(pair, k);
  const PairAlgebra algebra(as_row(pair[0].polynomial), as_row(pair[1].polynomial));
  const std::size_t n = algebra.size();
  for (std::int64_t j = 1; j <= 8; ++j) {
    const Rational weight(j);
    // Powers of u + j v: with n of them independent, all is a polynomial of it.
    std::vector<Row> powers{algebra.one()};
    while (powers.size() <= n) {
      Row next = algebra.times_u(powers.back());
      const Row by_v = algebra.times_v(powers.back());
      for (std::size_t i = 0; i < n; ++i) next[i] += weight * by_v[i];
      powers.push_back(std::move(next));
    }
    const Row last = std::move(powers.back());
    powers.pop_back();
    const auto system = Elimination::of(std::move(powers));
    if (!system) continue;
    PrimitivePair out;
    for (const Rational& x : system->solve(last)) out.modulus.push_back(-x);
    out.modulus.push_back(Rational(1));
    out.lo = pair[0].lo + weight * pair[1].lo;
    out.hi = pair[0].hi + weight * pair[1].hi;
    if (!has_root_between(out.modulus, out.lo, out.hi)) continue;
    out.numbers = {system->solve(algebra.times_u(algebra.one())),
                   system->solve(algebra.times_v(algebra.one()))};
    return out;
  }
  return std::nullopt;
}

}  // namespace veritope
