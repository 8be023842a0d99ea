// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/pieces/surface_form.h"

#include <gtest/gtest.h>

#include "robust/base/random.h"
#include "robust/rational.h"
#include "solids/pieces/piece_net_internal.h"
#include "splines/bezier_triangle.h"
#include "splines/de_casteljau.h"

namespace veritope {
namespace {

using Numbers = std::vector<Rational>;

Rational draw(Random& random) {
  return Rational(random.between(-20, 20)) / Rational(random.between(1, 6));
}

Rational determinant(std::vector<Numbers> m) {  // by the first row
  if (m.size() == 1) return m[0][0];
  Rational sum(0);
  for (std::size_t c = 0; c < m.size(); ++c) {
    std::vector<Numbers> minor;
    for (std::size_t r = 1; r < m.size(); ++r) {
      minor.push_back(m[r]);
      minor.back().erase(minor.back().begin() + static_cast<std::ptrdiff_t>(c));
    }
    const Rational term = m[0][c] * determinant(minor);
    sum = c % 2 == 0 ? sum + term : sum - term;
  }
  return sum;
}

// F, F_u, F_v at a point by evaluating the map and exact difference quotients of its polynomials: f'(0) from values at degree + 1 points would do,
// but the derivative of de Casteljau's form is exact, too: degree * (right - left) of the last step but one.
struct Jet {
  Numbers f, u, v;
};

Jet jet_of(const FormShape& s, const Numbers& control, std::size_t components, const Rational& a,
           const Rational& b) {
  Jet jet;
  const std::size_t n = s.count();
  for (std::size_t c = 0; c < components; ++c) {
    const Numbers own(control.begin() + static_cast<std::ptrdiff_t>(c * n),
                      control.begin() + static_cast<std::ptrdiff_t>((c + 1) * n));
    const auto value = [&](const Rational& x, const Rational& y) {
      if (s.is_triangle)
        return evaluate(BezierTriangle<Rational>(s.p, 1, false, own),
                        {Rational(1) - x - y, x, y})[0];
      return evaluate(Bezier<Rational, 2>({s.p, s.q}, 1, false, own), {x, y})[0];
    };
    // The derivative of a polynomial of degree <= 4 by five values, exactly.
    const auto slope = [&](bool along_u) {
      const auto at = [&](int k) {
        return along_u ? value(a + Rational(k), b) : value(a, b + Rational(k));
      };
      return (at(-2) - Rational(8) * at(-1) + Rational(8) * at(1) - at(2)) / Rational(12);
    };
    jet.f.push_back(value(a, b));
    jet.u.push_back(slope(true));
    jet.v.push_back(slope(false));
  }
  return jet;
}

void expect_determinant(const FormShape& shape, bool is_rational, std::uint64_t seed) {
  Random random(seed);
  const std::size_t components = is_rational ? 4 : 3;
  Numbers control;
  for (std::size_t i = 0; i < components * shape.count(); ++i) control.push_back(draw(random));
  const auto g = determinant_form<Rational>(shape, is_rational, control.data());
  const FormShape d = determinant_shape(shape);
  const Rational x = draw(random), y = draw(random);
  const Jet jet = jet_of(shape, control, components, x, y);
  const Numbers c{draw(random), draw(random), draw(random), Rational(1)};
  std::vector<Numbers> rows{jet.f, jet.u, jet.v};
  if (!is_rational) {
    rows[0].push_back(Rational(1));
    rows[1].push_back(Rational(0));
    rows[2].push_back(Rational(0));
  }
  rows.push_back(c);
  Rational sum(0);
  for (std::size_t k = 0; k < 4; ++k) {
    const Rational value =
        d.is_triangle ? evaluate(BezierTriangle<Rational>(d.p, 1, false, g[k]),
                                 {Rational(1) - x - y, x, y})[0]
                      : evaluate(Bezier<Rational, 2>({d.p, d.q}, 1, false, g[k]), {x, y})[0];
    sum = sum + (k == 0 ? value : value * c[k - 1]);
  }
  EXPECT_EQ(sum, determinant(rows)) << "seed " << seed << ", degrees " << shape.p << " " << shape.q
                                    << (shape.is_triangle ? ", triangle" : "");
}

TEST(SurfaceForm, IsTheDeterminantAtEveryPoint) {
  std::uint64_t seed = 0;
  for (int round = 0; round < 3; ++round)
    for (const bool is_rational : {false, true}) {
      for (int p = 1; p <= 4; ++p) {
        expect_determinant({true, p, 0}, is_rational, seed++);
        for (int q = 1; q <= 4; ++q) expect_determinant({false, p, q}, is_rational, seed++);
      }
    }
}

// ---- nets of doubles

void expect_quarters(const FormShape& shape, std::uint64_t seed) {
  Random random(seed);
  const std::size_t n = shape.count();
  std::vector<double> net;
  Numbers exact;
  double size = 0;
  for (std::size_t i = 0; i < n; ++i) {
    net.push_back(2 * random.unit() - 1);
    exact.push_back(Rational::from_double(net.back()));
    size = std::max(size, std::abs(net.back()));
  }
  std::vector<std::vector<double>> children(4, std::vector<double>(n));
  double* to[4] = {children[0].data(), children[1].data(), children[2].data(), children[3].data()};
  std::array<Numbers, 4> expected;
  if (shape.is_triangle) {
    internal::quarter_triangle(shape.p, net.data(), to);
    const auto parts = split_in_four(BezierTriangle<Rational>(shape.p, 1, false, exact));
    for (std::size_t k = 0; k < 4; ++k)
      expected[k].assign(parts[k].component(0).begin(), parts[k].component(0).end());
  } else {
    internal::quarter_tensor(shape, net.data(), to);
    const Rational half = Rational(1) / Rational(2);
    const auto u = split(Bezier<Rational, 2>({shape.p, shape.q}, 1, false, exact), 0, half);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto v = split(k < 2 ? u.first : u.second, 1, half);
      const auto& part = k % 2 == 0 ? v.first : v.second;
      expected[k].assign(part.component(0).begin(), part.component(0).end());
    }
  }
  const Rational bound =
      Rational::from_double(internal::error_after_halving(0, size, internal::quarter_depth(shape)));
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_TRUE(abs(Rational::from_double(children[k][i]) - expected[k][i]) <= bound)
          << "seed " << seed << ", child " << k << ", coefficient " << i << " is "
          << children[k][i];
}

TEST(PieceNet, QuartersAreThoseOfRationalsUpToTheBound) {
  std::uint64_t seed = 0;
  for (int p = 1; p <= 11; ++p) {
    expect_quarters({true, p, 0}, seed++);
    for (const int q : {1, 2, p}) expect_quarters({false, p, q}, seed++);
  }
}

}  // namespace
}  // namespace veritope
