// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/de_casteljau_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "robust/integer.h"
#include "splines/binomial.h"
#include "tests/splines/draw.h"

namespace veritope {
namespace {

using internal::AffineBlend;
using internal::HalfBlend;

// A line among other numbers, which have to stay as they are.
template <typename R>
struct StridedLine {
  StridedLine(std::vector<R> line, std::size_t stride, R between)
      : stride(stride), between(between), all(line.size() * stride, between) {
    for (std::size_t i = 0; i < line.size(); ++i) all[i * stride] = line[i];
  }
  int degree() const { return static_cast<int>(all.size() / stride) - 1; }
  std::vector<R> values() const {
    std::vector<R> out;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i % stride == 0) {
        out.push_back(all[i]);
      } else {
        EXPECT_EQ(all[i], between) << "entry " << i << " is of no line";
      }
    }
    return out;
  }
  std::size_t stride;
  R between;
  std::vector<R> all;
};

// By the definition of Bernstein polynomials.
Rational value_of(const std::vector<Rational>& line, const Rational& t) {
  const int n = static_cast<int>(line.size()) - 1;
  Rational sum;
  for (int i = 0; i <= n; ++i) {
    Rational term = Rational(binomial(n, i)) * line[static_cast<std::size_t>(i)];
    for (int k = 0; k < n; ++k) term *= k < i ? t : Rational(1) - t;
    sum += term;
  }
  return sum;
}

struct Drawn {
  explicit Drawn(Random& random)
      : line(draw_coefficients(random, static_cast<std::size_t>(draw_int(random, 1, 8)), 1, false)),
        stride(static_cast<std::size_t>(draw_int(random, 1, 3))) {}
  template <typename R>
  StridedLine<R> strided(const R& between) const {
    std::vector<R> numbers;
    for (const Rational& v : line) {
      if constexpr (std::is_same_v<R, Rational>) {
        numbers.push_back(v);
      } else if constexpr (std::is_same_v<R, double>) {
        numbers.push_back(nearest_double(v));
      } else {
        numbers.push_back(v.numerator());
      }
    }
    return {numbers, stride, between};
  }
  std::vector<Rational> line;
  std::size_t stride;
};

template <typename R, typename Blend>
std::pair<std::vector<R>, std::vector<R>> parts_of(const StridedLine<R>& line, const Blend& blend) {
  StridedLine<R> left = line, right = line;
  internal::keep_left(left.all.data(), line.stride, line.degree(), blend);
  internal::keep_right(right.all.data(), line.stride, line.degree(), blend);
  // Both at once are the same numbers, whichever stays.
  for (const bool left_stays : {false, true}) {
    StridedLine<R> stays = line, goes = line;
    const auto split = left_stays ? internal::split_keeping_left<R, Blend>
                                  : internal::split_keeping_right<R, Blend>;
    split(stays.all.data(), line.stride, line.degree(), goes.all.data(), line.stride, blend);
    EXPECT_EQ(stays.values(), left_stays ? left.values() : right.values());
    EXPECT_EQ(goes.values(), left_stays ? right.values() : left.values());
  }
  return {left.values(), right.values()};
}

TEST(DeCasteljauLine, PartsAreTheMapOnPartsOfTheLine) {
  for_loops(900, 60, [](Random& random) {
    const Drawn drawn(random);
    const Rational t = draw_rational(random) / Rational(20);
    const auto [left, right] =
        parts_of(drawn.strided(Rational(77)), AffineBlend<Rational>{Rational(1) - t, t});
    EXPECT_EQ(left.back(), right.front());
    for (int k = -1; k <= 3; ++k) {
      const Rational x = fraction(k, 2);
      EXPECT_EQ(value_of(left, x), value_of(drawn.line, x * t));
      EXPECT_EQ(value_of(right, x), value_of(drawn.line, t + x * (Rational(1) - t)));
    }
  });
}

TEST(DeCasteljauLine, HalvesAreThePartsAtOneHalf) {
  for_loops(901, 60, [](Random& random) {
    const Drawn drawn(random);
    const Rational half = fraction(1, 2);
    const auto line = drawn.strided(Rational(77));
    EXPECT_EQ(parts_of(line, HalfBlend<Rational>{half}),
              parts_of(line, AffineBlend<Rational>{half, half}));
  });
}

// Small dyadic coefficients: doubles make no error, whatever the blend.
TEST(DeCasteljauLine, HalvesInDoubleAreExactWhereTheirBitsSuffice) {
  for_loops(902, 60, [](Random& random) {
    Drawn drawn(random);
    for (Rational& v : drawn.line) v = fraction(random.between(-1000, 1000), 64);
    const auto exact = parts_of(drawn.strided(Rational(77)), HalfBlend<Rational>{fraction(1, 2)});
    const auto of_double = parts_of(drawn.strided(77.0), HalfBlend<double>{0.5});
    EXPECT_EQ(parts_of(drawn.strided(77.0), AffineBlend<double>{0.5, 0.5}), of_double);
    for (std::size_t i = 0; i < drawn.line.size(); ++i) {
      EXPECT_EQ(Rational::from_double(of_double.first[i]), exact.first[i]);
      EXPECT_EQ(Rational::from_double(of_double.second[i]), exact.second[i]);
    }
  });
}

// A blend by integers s and t cuts at t / (s + t) and scales coefficient number i by (s + t)^(blends that made it).
TEST(DeCasteljauLine, IntegersAreScaledByAPowerForEachBlend) {
  for_loops(903, 60, [](Random& random) {
    Drawn drawn(random);
    for (Rational& v : drawn.line) v = Rational(v.numerator());
    const long s = static_cast<long>(random.between(0, 9)),
               t = static_cast<long>(random.between(1, 9));
    const auto exact = parts_of(drawn.strided(Rational(77)),
                                AffineBlend<Rational>{fraction(s, s + t), fraction(t, s + t)});
    const auto [left, right] =
        parts_of(drawn.strided(Integer(77)), AffineBlend<Integer>{Integer(s), Integer(t)});
    const std::size_t n = drawn.line.size() - 1;
    Rational power(1);
    for (std::size_t i = 0; i <= n; ++i, power *= Rational(s + t)) {
      EXPECT_EQ(Rational(left[i]), power * exact.first[i]);
      EXPECT_EQ(Rational(right[n - i]), power * exact.second[n - i]);
    }
  });
}

TEST(DeCasteljauLine, HalvingIntegersNTimesScalesTheValueByTwoToTheN) {
  std::vector<Integer> line;
  for (int degree = 0; degree <= 20; ++degree) {
    line.push_back(Integer(degree * degree - 7 * degree + 3));
    std::vector<Integer> work = line;
    std::vector<Rational> exact;
    for (const Integer& v : line) exact.emplace_back(v);
    internal::keep_right(work.data(), 1, degree, AffineBlend<Integer>{Integer(1), Integer(1)});
    EXPECT_EQ(Rational(work.front()),
              Rational::power_of_two(degree) * value_of(exact, fraction(1, 2)));
  }
}

// With another blend in each step the first entry is the blossom: symmetric.
TEST(DeCasteljauLine, StepsInAnyOrderOfTheirCutsGiveOneBlossom) {
  for_loops(904, 40, [](Random& random) {
    const Drawn drawn(random);
    const int n = static_cast<int>(drawn.line.size()) - 1;
    std::vector<Rational> cuts;
    for (int i = 0; i < n; ++i) cuts.push_back(draw_rational(random));
    const auto blossom = [&] {
      auto line = drawn.strided(Rational(77));
      for (int left = n; left > 0; --left) {
        const Rational& t = cuts[static_cast<std::size_t>(left) - 1];
        internal::blend_forward(line.all.data(), line.stride, left,
                                AffineBlend<Rational>{Rational(1) - t, t});
      }
      return line.values().front();
    };
    const Rational first = blossom();
    std::reverse(cuts.begin(), cuts.end());
    EXPECT_EQ(blossom(), first);
    std::rotate(cuts.begin(), cuts.begin() + (n > 0 ? 1 : 0), cuts.end());
    EXPECT_EQ(blossom(), first);
  });
}

}  // namespace
}  // namespace veritope
