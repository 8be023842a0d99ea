// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_determinant.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>

namespace veritope {
namespace {

using Shares = std::array<Rational, 4>;
using Coefficients = std::vector<Rational>;

// How often a monomial of barycentric coordinates occurs in a power of their sum.
std::vector<Rational> multiplicities(int degree) {
  std::vector<Rational> out;
  for_each_tetrahedral_index(degree, [&](const TetrahedralIndex& index) {
    Rational value(1);
    int left = degree;
    for (const int i : index)
      for (int k = 1; k <= i; ++k) value *= Rational(left--) / Rational(k);
    out.push_back(std::move(value));
  });
  return out;
}

// The product of two homogeneous polynomials of barycentric coordinates, by their monomials.
Coefficients product(int p, const Coefficients& a, int q, const Coefficients& b) {
  Coefficients out(num_tetrahedral_indices(p + q));
  for_each_tetrahedral_index(p, [&](const TetrahedralIndex& i) {
    const Rational& factor = a[tetrahedral_index(i)];
    if (factor.sign() == Sign::kZero) return;
    for_each_tetrahedral_index(q, [&](const TetrahedralIndex& j) {
      const Rational& other = b[tetrahedral_index(j)];
      if (other.sign() == Sign::kZero) return;
      out[tetrahedral_index({i[0] + j[0], i[1] + j[1], i[2] + j[2], i[3] + j[3]})] +=
          factor * other;
    });
  });
  return out;
}
void add_to(Coefficients& sum, const Coefficients& more, bool is_less) {
  for (std::size_t i = 0; i < sum.size(); ++i)
    if (is_less)
      sum[i] -= more[i];
    else
      sum[i] += more[i];
}

// One step of de Casteljau's algorithm, in any numbers.
template <typename R>
std::vector<R> lowered(int degree, const std::vector<R>& c, const std::array<R, 4>& shares) {
  std::vector<R> out;
  for_each_tetrahedral_index(degree - 1, [&](const TetrahedralIndex& index) {
    R sum = shares[0] * c[tetrahedral_index(raised(index, 0))];
    for (std::size_t m = 1; m < 4; ++m) sum += shares[m] * c[tetrahedral_index(raised(index, m))];
    out.push_back(std::move(sum));
  });
  return out;
}

// A part of the tetrahedron: its corners by their barycentric coordinates.
struct Part {
  std::array<Shares, 4> corners;
  TetrahedralPolynomial polynomial;
  std::size_t least = 0;  // the place of the least coefficient
  int level = 0;

  const Rational& bound() const { return polynomial.coefficients()[least]; }
};
struct HasGreaterBound {
  bool operator()(const Part& a, const Part& b) const { return a.bound() > b.bound(); }
};

Shares mixed(const std::array<Shares, 4>& corners, const Shares& shares) {
  Shares out;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t c = 0; c < 4; ++c) out[c] += shares[i] * corners[i][c];
  return out;
}

// The step of Newton's method from a point in a tetrahedron to where the slope is 0, for the three last coordinates.
std::optional<std::array<double, 3>> newton_step(int degree, std::vector<double> c,
                                                 const std::array<double, 4>& at) {
  for (int d = degree; d > 2; --d) c = lowered(d, c, at);
  const auto second = [&](std::size_t i, std::size_t j) {
    return c[tetrahedral_index(raised(raised({}, i), j))];
  };
  std::array<double, 4> first{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) first[i] += at[j] * second(i, j);
  std::array<std::array<double, 4>, 3> rows{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      rows[i][j] = (degree - 1) *
                   (second(i + 1, j + 1) - second(i + 1, 0) - second(0, j + 1) + second(0, 0));
    rows[i][3] = first[0] - first[i + 1];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    std::size_t pivot = i;
    for (std::size_t k = i + 1; k < 3; ++k)
      if (std::abs(rows[k][i]) > std::abs(rows[pivot][i])) pivot = k;
    std::swap(rows[i], rows[pivot]);
    if (!(std::abs(rows[i][i]) > 1e-14)) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == i) continue;
      const double factor = rows[k][i] / rows[i][i];
      for (std::size_t j = i; j < 4; ++j) rows[k][j] -= factor * rows[i][j];
    }
  }
  return std::array<double, 3>{rows[0][3] / rows[0][0], rows[1][3] / rows[1][1],
                               rows[2][3] / rows[2][2]};
}

class NegativeSearch {
 public:
  explicit NegativeSearch(std::size_t max_parts) : max_parts_(max_parts) {}

  NegativePlace run(const TetrahedralPolynomial& polynomial) {
    std::array<Shares, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i][i] = Rational(1);
    add({corners, polynomial, 0, 0});
    for (std::size_t parts = 0; !open_.empty() && !found_ && parts < max_parts_; ++parts) {
      const Part part = open_.top();
      open_.pop();
      if (auto at = follow(part)) {
        found_ = std::move(at);
        break;
      }
      split(part);
    }
    if (found_) return {std::move(found_), false};
    return {std::nullopt, open_.empty()};
  }

 private:
  void add(Part part) {
    const Coefficients& c = part.polynomial.coefficients();
    part.least = static_cast<std::size_t>(std::min_element(c.begin(), c.end()) - c.begin());
    if (part.bound().sign() == Sign::kPositive) return;
    const int m = part.polynomial.degree();
    for (std::size_t i = 0; i < 4 && !found_; ++i) {
      TetrahedralIndex corner{};
      corner[i] = m;
      if (c[tetrahedral_index(corner)].sign() == Sign::kNegative) found_ = inward(part, i);
    }
    if (!found_) open_.push(std::move(part));
  }
  // A point inside, near the corner, at which the polynomial is below 0 as it is there.
  static Shares inward(const Part& part, std::size_t corner) {
    for (std::int64_t step = 2;; ++step) {
      Shares at;
      for (Rational& x : at) x = Rational::power_of_two(-step);
      at[corner] = Rational(1) - Rational(3) * at[corner];
      if (part.polynomial.at(at).sign() == Sign::kNegative) return mixed(part.corners, at);
    }
  }

  // Newton's method from the place of the least coefficient.
  static std::optional<Shares> follow(const Part& part) {
    const int m = part.polynomial.degree();
    if (m < 2) return std::nullopt;
    const Coefficients& c = part.polynomial.coefficients();
    Rational most;
    for (const Rational& x : c) most = std::max(most, abs(x));
    std::vector<double> rounded;
    for (const Rational& x : c) rounded.push_back(nearest_double(x / most));
    std::array<double, 4> at{};
    std::size_t place = 0;
    for_each_tetrahedral_index(m, [&](const TetrahedralIndex& index) {
      if (place++ != part.least) return;
      for (std::size_t i = 0; i < 4; ++i) at[i] = (index[i] + 0.25) / (m + 1);
    });
    for (int round = 0; round < 12; ++round) {
      const auto step = newton_step(m, rounded, at);
      if (!step) break;
      // No farther than nearly to the border.
      double length = 1;
      const std::array<double, 4> move{-(*step)[0] - (*step)[1] - (*step)[2], (*step)[0],
                                       (*step)[1], (*step)[2]};
      for (std::size_t i = 0; i < 4; ++i)
        if (move[i] < 0) length = std::min(length, -0.9 * at[i] / move[i]);
      if (!std::isfinite(length)) break;
      for (std::size_t i = 0; i < 4; ++i) at[i] += length * move[i];
    }
    Shares exact;
    exact[0] = Rational(1);
    for (std::size_t i = 1; i < 4; ++i) {
      if (!std::isfinite(at[i])) return std::nullopt;
      exact[i] = Rational::from_double(std::ldexp(std::round(std::ldexp(at[i], 56)), -56));
      exact[0] -= exact[i];
    }
    for (const Rational& x : exact)
      if (x.sign() != Sign::kPositive) return std::nullopt;
    if (part.polynomial.at(exact).sign() != Sign::kNegative) return std::nullopt;
    return mixed(part.corners, exact);
  }

  // Edges take turns by their lengths in barycentric coordinates.
  void split(const Part& part) {
    std::size_t from = 0, to = 1;
    Rational most;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        Rational length;
        for (std::size_t c = 0; c < 4; ++c) {
          const Rational d = part.corners[i][c] - part.corners[j][c];
          length += d * d;
        }
        if (length > most) most = std::move(length), from = i, to = j;
      }
    auto [first, second] = part.polynomial.halves(from, to);
    Shares middle;
    for (std::size_t c = 0; c < 4; ++c)
      middle[c] = (part.corners[from][c] + part.corners[to][c]) * Rational::power_of_two(-1);
    Part a{part.corners, std::move(first), 0, part.level + 1},
        b{part.corners, std::move(second), 0, part.level + 1};
    a.corners[to] = middle;
    b.corners[from] = std::move(middle);
    add(std::move(a));
    if (!found_) add(std::move(b));
  }

  const std::size_t max_parts_;
  std::priority_queue<Part, std::vector<Part>, HasGreaterBound> open_;
  std::optional<Shares> found_;
};

}  // namespace

Rational TetrahedralPolynomial::at(const std::array<Rational, 4>& barycentric) const {
  Coefficients c = coefficients_;
  for (int d = degree_; d > 0; --d) c = lowered(d, c, barycentric);
  return std::move(c[0]);
}

// The polar form at the corners, each as often as the index says.
TetrahedralPolynomial TetrahedralPolynomial::on(
    const std::array<std::array<Rational, 4>, 4>& corners) const {
  Coefficients out;
  for_each_tetrahedral_index(degree_, [&](const TetrahedralIndex& index) {
    Coefficients c = coefficients_;
    int d = degree_;
    for (std::size_t m = 0; m < 4; ++m)
      for (int k = 0; k < index[m]; ++k) c = lowered(d--, c, corners[m]);
    out.push_back(std::move(c[0]));
  });
  return TetrahedralPolynomial(degree_, std::move(out));
}

// Along the edge the coefficients with equal other numbers are those of polynomials of one variable.
std::pair<TetrahedralPolynomial, TetrahedralPolynomial> TetrahedralPolynomial::halves(
    std::size_t i, std::size_t j) const {
  Coefficients first = coefficients_, second = coefficients_;
  const Rational half = Rational::power_of_two(-1);
  for_each_tetrahedral_index(degree_, [&](const TetrahedralIndex& start) {
    if (start[j] != 0) return;  // the first one of a row
    const auto place = [&](int k) {
      TetrahedralIndex index = start;
      index[i] -= k;
      index[j] += k;
      return tetrahedral_index(index);
    };
    Coefficients row;
    for (int k = 0; k <= start[i]; ++k) row.push_back(coefficients_[place(k)]);
    for (int length = start[i]; length >= 0; --length) {
      const int done = start[i] - length;
      first[place(done)] = row.front();
      second[place(length)] = row.back();
      for (std::size_t k = 0; k + 1 < row.size(); ++k) row[k] = (row[k] + row[k + 1]) * half;
      row.pop_back();
    }
  });
  return {TetrahedralPolynomial(degree_, std::move(first)),
          TetrahedralPolynomial(degree_, std::move(second))};
}

TetrahedralPolynomial determinant_of(int degree, std::span<const DmsMatrix> derivatives) {
  const std::vector<Rational> times = multiplicities(degree);
  std::array<Coefficients, 9> entries;
  for (std::size_t e = 0; e < 9; ++e)
    for (std::size_t k = 0; k < derivatives.size(); ++k)
      entries[e].push_back(derivatives[k][e] * times[k]);
  Coefficients sum(num_tetrahedral_indices(3 * degree));
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
    Coefficients minor = product(degree, entries[3 + d], degree, entries[6 + e]);
    add_to(minor, product(degree, entries[3 + e], degree, entries[6 + d]), true);
    add_to(sum, product(degree, entries[c], 2 * degree, minor), false);
  }
  const std::vector<Rational> shares = multiplicities(3 * degree);
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] /= shares[k];
  return TetrahedralPolynomial(3 * degree, std::move(sum));
}

NegativePlace find_negative(const TetrahedralPolynomial& polynomial, std::size_t max_parts) {
  return NegativeSearch(max_parts).run(polynomial);
}

}  // namespace veritope
