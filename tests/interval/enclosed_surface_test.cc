// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/enclosure/enclosed_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "interval/enclosure/patch_tree.h"
#include "interval/upward.h"
#include "robust/base/random.h"
#include "splines/de_casteljau.h"
#include "splines/knot_insertion.h"

namespace veritope {
namespace {

Rational q(std::int64_t p, std::int64_t r = 1) { return Rational(p) / Rational(r); }

/// Bidegree (2, 3), 3 x 2 spans of different lengths, knots that are no binary64 numbers.
BSplineSurface<Rational> random_surface(Random& random, bool is_rational) {
  const KnotAxis<Rational> u{2, {q(0), q(0), q(0), q(1, 3), q(2, 3), q(2), q(2), q(2)}, false};
  const KnotAxis<Rational> v{
      3, {q(-1), q(-1), q(-1), q(-1), q(1, 7), q(1), q(1), q(1), q(1)}, false};
  const std::size_t count = 25;
  std::vector<Rational> c;
  std::vector<Rational> weight;
  for (std::size_t i = 0; i < count; ++i)
    weight.push_back(is_rational ? q(static_cast<std::int64_t>(1 + random.below(9)), 5) : q(1));
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < count; ++i)
      c.push_back(weight[i] * q(static_cast<std::int64_t>(random.below(2001)) - 1000, 300));
  if (is_rational) c.insert(c.end(), weight.begin(), weight.end());
  return BSplineSurface<Rational>({u, v}, is_rational ? 4 : 3, is_rational, std::move(c));
}

/// The exact point at local parameters of a piece.
std::array<Rational, 3> exact_point(const BezierPieces<Rational, 2>& pieces, std::size_t i,
                                    std::size_t j, const Rational& s, const Rational& t) {
  const auto values = evaluate(pieces.at({i, j}), {s, t});
  const Rational w = values.size() == 4 ? values[3] : q(1);
  return {values[0] / w, values[1] / w, values[2] / w};
}

// PROVES ENCLOSE-1.SECANT
TEST(EnclosedSurface, HoldsExactPointsAndSecants) {
  Random random(5);
  const ScopedUpward upward;
  for (const bool is_rational : {false, true}) {
    const auto surface = random_surface(random, is_rational);
    const auto pieces = bezier_pieces(surface);
    const auto enclosed = EnclosedSurface::make(surface);
    ASSERT_TRUE(enclosed.has_value()) << to_string(enclosed.error());
    for (int loop = 0; loop < 300; ++loop) {
      const std::size_t i = random.below(3), j = random.below(2);
      const double s = static_cast<double>(random.below(65)) / 64,
                   t = static_cast<double>(random.below(65)) / 64;
      const auto& bu = enclosed->breaks(0);
      const auto& bv = enclosed->breaks(1);
      // Rounding must not carry a parameter beyond the piece.
      const double u = std::min(bu[i] + s * (bu[i + 1] - bu[i]), bu[i + 1]);
      const double v = std::min(bv[j] + t * (bv[j + 1] - bv[j]), bv[j + 1]);
      // The working parameter means this place in the piece, exactly.
      const auto local = [](double x, double a, double b) {
        return (Rational::from_double(x) - Rational::from_double(a)) /
               (Rational::from_double(b) - Rational::from_double(a));
      };
      const auto exact =
          exact_point(pieces, i, j, local(u, bu[i], bu[i + 1]), local(v, bv[j], bv[j + 1]));
      const Box3 box = enclosed->point(u, v);
      const double du = 0.01 * static_cast<double>(1 + random.below(20));
      const auto range = enclosed->range(Interval::from_bounds(u - du, u + du),
                                         Interval::from_bounds(v - du, v + du));
      const auto precise = enclosed->precise_point(u, v, 120);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_TRUE(contains(box[c], exact[c])) << "loop " << loop;
        EXPECT_LE(wid(box[c]), 1e-13);
        EXPECT_TRUE(contains(range.point[c], exact[c])) << "loop " << loop;
        EXPECT_TRUE(contains(precise[c] / precise[3], exact[c])) << "loop " << loop;
      }
      // The mean value theorem on a secant inside of the rectangle and the domain, across knots.
      const double u2 = std::min(u + du, enclosed->domain_end(0));
      if (!(u2 > u)) continue;
      std::size_t i2 = i;
      while (i2 + 1 < enclosed->num_spans(0) && bu[i2 + 1] < u2) ++i2;
      const auto other =
          exact_point(pieces, i2, j, local(u2, bu[i2], bu[i2 + 1]), local(v, bv[j], bv[j + 1]));
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_TRUE(contains(range.du[c], (other[c] - exact[c]) / (Rational::from_double(u2) -
                                                                   Rational::from_double(u))))
            << "loop " << loop << " u " << u << " " << u2 << " v " << v;
    }
  }
}
// A surface of degree 1 in both directions with a knot at 1/2 on both axes, flat before it and steep after it, or the
// other way round. Its secants across the knot are no mean of derivatives on one side.
// PROVES ENCLOSE-1.SECANT
TEST(EnclosedSurface, DerivativesHoldSecantsAcrossAKnotBesideWhichTheSurfaceIsSteep) {
  const ScopedUpward upward;
  const double before = std::nextafter(0.5, 0.0), after = std::nextafter(0.5, 1.0);
  const KnotAxis<Rational> axis{1, {q(0), q(0), q(1, 2), q(1), q(1)}, false};
  for (const bool is_rational : {false, true})
    for (const bool is_steep_last : {false, true}) {
      // x(u) and y(v) have these values at 0, 1/2 and 1.
      const std::array<Rational, 3> value =
          is_steep_last ? std::array{q(0), q(1), q(101)} : std::array{q(0), q(100), q(101)};
      std::vector<Rational> c(is_rational ? 36 : 27, q(1));
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          c[3 * i + j] = value[i], c[9 + 3 * i + j] = value[j], c[18 + 3 * i + j] = q(0);
      const BSplineSurface<Rational> surface({axis, axis}, is_rational ? 4 : 3, is_rational,
                                             std::move(c));
      const auto enclosed = EnclosedSurface::make(surface);
      ASSERT_TRUE(enclosed.has_value());
      const auto at = [&](double t) {
        const Rational x = Rational::from_double(t), half = q(1, 2);
        return x <= half ? value[0] + q(2) * x * (value[1] - value[0])
                         : value[1] + q(2) * (x - half) * (value[2] - value[1]);
      };
      for (const auto& [from, to] :
           {std::pair{0.25, after}, std::pair{before, 0.75}, std::pair{0.25, 0.75}}) {
        const Interval whole = Interval::from_bounds(from, to), other(0.25);
        const auto along_u = enclosed->range(whole, other), along_v = enclosed->range(other, whole);
        // Secants of the whole interval, and of its parts on both sides of the knot.
        for (const auto& [a, b] : {std::pair{from, to}, std::pair{from, 0.5}, std::pair{0.5, to}}) {
          const Rational secant =
              (at(b) - at(a)) / (Rational::from_double(b) - Rational::from_double(a));
          EXPECT_TRUE(contains(along_u.du[0], secant)) << a << ' ' << b;
          EXPECT_TRUE(contains(along_v.dv[1], secant)) << a << ' ' << b;
        }
      }
    }
}

TEST(EnclosedSurface, SecondDerivativesHoldTheirSecants) {
  Random random(6);
  const ScopedUpward upward;
  for (const bool is_rational : {false, true}) {
    const auto enclosed = EnclosedSurface::make(random_surface(random, is_rational));
    ASSERT_TRUE(enclosed.has_value());
    for (int loop = 0; loop < 100; ++loop) {
      const double u = 0.7 + 0.01 * static_cast<double>(random.below(100)),
                   v = 0.2 + 0.005 * static_cast<double>(random.below(100));
      const double h = 0x1p-6;
      const Interval over_u = Interval::from_bounds(u, u + h),
                     over_v = Interval::from_bounds(v, v + h);
      const auto second = enclosed->second_range(over_u, over_v);
      const auto at = [&](double a, double b) { return enclosed->range(Interval(a), Interval(b)); };
      const auto corner = at(u, v), along_u = at(u + h, v), along_v = at(u, v + h);
      for (std::size_t c = 0; c < 3; ++c) {
        const auto holds = [&](const Interval& all, const Interval& secant) {
          return !is_disjoint(all, secant);
        };
        const Interval step(h);
        EXPECT_TRUE(holds(second.duu[c], (along_u.du[c] - corner.du[c]) / step)) << loop;
        EXPECT_TRUE(holds(second.duv[c], (along_v.du[c] - corner.du[c]) / step)) << loop;
        EXPECT_TRUE(holds(second.duv[c], (along_u.dv[c] - corner.dv[c]) / step)) << loop;
        EXPECT_TRUE(holds(second.dvv[c], (along_v.dv[c] - corner.dv[c]) / step)) << loop;
      }
    }
  }
}

TEST(EnclosedSurface, TrueParametersComeBack) {
  Random random(7);
  const ScopedUpward upward;
  const auto enclosed = EnclosedSurface::make(random_surface(random, false));
  for (std::size_t i = 0; i < enclosed->breaks(0).size(); ++i)
    EXPECT_TRUE(contains(enclosed->true_parameter(0, Interval(enclosed->breaks(0)[i])),
                         enclosed->knots(0)[i]));
}

TEST(EnclosedSurface, RefusesWhatItCannotEnclose) {
  Random random(8);
  const ScopedUpward upward;
  auto negative = random_surface(random, true);
  negative.component(3)[0] = q(-1, 4);
  const auto refused = EnclosedSurface::make(negative);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message.find("weight"), std::string::npos);

  auto huge = random_surface(random, false);
  huge.component(0)[0] = Rational::power_of_two(400);
  EXPECT_EQ(EnclosedSurface::make(huge).error().code, Code::kOverLimit);

  // A cut: an inner knot as often as the degree + 1, with different ends.
  const KnotAxis<Rational> cut{1, {q(0), q(0), q(1), q(1), q(2), q(2)}, false};
  const KnotAxis<Rational> plain{1, {q(0), q(0), q(1), q(1)}, false};
  std::vector<Rational> c;
  for (int i = 0; i < 24; ++i) c.push_back(q(i));
  const auto torn = EnclosedSurface::make(BSplineSurface<Rational>({cut, plain}, 3, false, c));
  ASSERT_FALSE(torn.has_value());
  EXPECT_NE(torn.error().message.find("piece (1, 0)"), std::string::npos) << torn.error().message;

  const KnotAxis<Rational> close{
      1, {q(0), q(0), q(1), q(1) + Rational::power_of_two(-80), q(2), q(2)}, false};
  std::vector<Rational> d(24, q(1));
  EXPECT_FALSE(
      EnclosedSurface::make(BSplineSurface<Rational>({close, plain}, 3, false, d)).has_value());
}

TEST(PatchTree, ChildrenTileTheirParentAndHoldTheirPoints) {
  Random random(9);
  const ScopedUpward upward;
  const auto enclosed = EnclosedSurface::make(random_surface(random, true));
  PatchTree tree(*enclosed);
  PatchTree::Id id = PatchTree::kRoot;
  for (int level = 0; level < 14; ++level) {
    const auto first = tree.children(id);
    const auto n = tree.num_children(id);
    const auto parent = tree.node(id);
    double area = 0;
    for (PatchTree::Id c = first; c < first + n; ++c) {
      const auto& child = tree.node(c);
      area += (child.u1 - child.u0) * (child.v1 - child.v0);
      EXPECT_FALSE(is_disjoint(enclosed->point(child.u0, child.v1), child.hull));
      EXPECT_TRUE(child.u0 >= parent.u0 && child.u1 <= parent.u1);
    }
    EXPECT_NEAR(area, (parent.u1 - parent.u0) * (parent.v1 - parent.v0), 1e-12 * area);
    id = first + static_cast<PatchTree::Id>(random.below(n));
  }
  EXPECT_TRUE(tree.node(id).is_single());
}

}  // namespace
}  // namespace veritope
