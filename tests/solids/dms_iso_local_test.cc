// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_iso_local_test.cc: the form of an attribute on a tetrahedron, and bounds from shares at corners, beside
// exact values at random points.
#include "solids/dms/dms_iso_local.h"

#include <gtest/gtest.h>

#include <map>

#include "interval/upward.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_region.h"
#include "tests/support/dms_level_sets.h"

namespace veritope {
namespace {

using Shares = std::array<Rational, 4>;

struct World {
  DmsModel model;
  std::string text;
};

// Clouds, collapsed in part, and random control points.
World draw_world(std::uint64_t seed) {
  Random random(seed);
  World out;
  out.model = kuhn_domain({2, 1, 1});
  out.model.degree = 2 + static_cast<int>(seed % 3);
  internal::draw_clouds(out.model, {Rational(1) / Rational(12), seed});
  for (DmsCloud& cloud : out.model.clouds)
    if (random.between(0, 3) == 0) cloud.resize(1);
  out.model.attributes = {"a"};
  set_control_by_rule(out.model, DmsControlRule::kGreville,
                      std::vector<Rational>(out.model.clouds.size()));
  for (std::size_t c = 0; c < out.model.num_control(); ++c)
    out.model.control.values[4 * c + 3] = Rational(random.between(-2, 9)) / Rational(4);
  out.text = "seed " + std::to_string(seed);
  return out;
}

Shares draw_shares(Random& random) {
  std::array<int, 4> parts{};
  int sum = 0;
  for (int& p : parts) sum += p = random.between(0, 3) == 0 ? 0 : random.between(1, 60);
  if (sum == 0) parts[0] = sum = 1;
  Shares out;
  for (std::size_t m = 0; m < 4; ++m) out[m] = Rational(parts[m]) / Rational(sum);
  return out;
}
DmsPoint point_at(const std::array<DmsPoint, 4>& corners, const Shares& shares) {
  DmsPoint out;
  for (std::size_t m = 0; m < 4; ++m)
    for (std::size_t c = 0; c < 3; ++c) out[c] += shares[m] * corners[m][c];
  return out;
}

// A tetrahedron that has a knot beside each corner, and its mirror image in a face.
DmsModel two_tetrahedra() {
  const auto point = [](int x, int y, int z) {
    return DmsPoint{Rational(x) / Rational(8), Rational(y) / Rational(8),
                    Rational(z) / Rational(8)};
  };
  DmsModel model;
  model.degree = 2;
  model.clouds = {{point(0, 0, 0), point(1, 1, 0)},
                  {point(8, 0, 0), point(7, 1, 0)},
                  {point(0, 8, 0), point(1, 7, 0)},
                  {point(0, 0, 8), point(1, 1, 7)},
                  {point(0, 0, -8), point(1, 1, -7)}};
  model.tetrahedra = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  model.attributes = {"a"};
  return model;
}

// The square of x has no rests. If the control point at the upper corner is moved, only the V_γ of that corner has one in
// the lower tetrahedron, and it is 0 at the corners of the common face, in whose plane the other knots of W_γ are.
// PROVES DMS-4.L1
TEST(DmsIsoLocal, APolynomialHasNoRests) {
  DmsModel model = two_tetrahedra();
  set_polynomial_attribute(model, [](const DmsPoint& p) { return p[0] * p[0]; });
  const auto form_of_lower = [&] {
    const DmsKnotTable knots(model);
    std::vector<DmsSupport> all;
    for (std::uint32_t t = 0; t < 2; ++t)
      for (const TetrahedralIndex& gamma : knots.gammas()) all.push_back({t, gamma});
    return DmsIsoLocal(model, knots, 3, Rational(1)).form(1, all);
  };
  const DmsIsoForm form = form_of_lower();
  EXPECT_TRUE(form.is_polynomial());
  EXPECT_EQ(form.coefficients[0], Interval(-1.0));  // at (0, 0, 0)
  for (std::size_t c = 0; c < model.num_control(); ++c)
    if (model.control.at[2 * c] == 3 && model.control.at[2 * c + 1] == 3)
      model.control.values[4 * c + 3] += Rational(1);
  const DmsIsoForm moved = form_of_lower();
  ASSERT_FALSE(moved.is_polynomial());
  EXPECT_EQ(moved.coefficients, form.coefficients);
  for (std::size_t s = 0; s < moved.supports.size(); ++s) {
    const bool is_moved = moved.supports[s].tetrahedron == 0 && moved.supports[s].gamma[3] == 1;
    for (std::size_t m = 0; m < 4; ++m) {
      const Interval& rest = moved.rests[4 * s + m];
      EXPECT_EQ(rest == Interval(0.0), !is_moved || m < 3) << s << ", " << m;
    }
  }
}

// Without clouds N_γ of degree 1 are barycentric coordinates, whose least values are at corners.
// PROVES DMS-4.L2
TEST(DmsIsoLocal, SharesOfCollapsedCloudsAreBarycentric) {
  DmsModel model = two_tetrahedra();
  for (DmsCloud& cloud : model.clouds) cloud.resize(1);
  set_polynomial_attribute(model, [](const DmsPoint& p) { return p[0]; });
  DmsEvaluator evaluator(model);
  const Rational half = Rational(1) / Rational(2), quarter = half * half;
  const auto place = evaluator.locate({half, quarter, Rational(1) / Rational(8)});
  ASSERT_TRUE(place);
  int count = 0;
  evaluator.for_each_basis(
      *place, 1, [&](std::uint32_t t, const TetrahedralIndex& gamma, const Rational& value) {
        ++count;
        EXPECT_EQ(t, 0u);
        EXPECT_EQ(value, gamma[1] == 1   ? half
                         : gamma[2] == 1 ? quarter
                                         : Rational(1) / Rational(8));
      });
  EXPECT_EQ(count, 4);
}

class LocalWorld : public testing::TestWithParam<std::uint64_t> {
 protected:
  LocalWorld() : world_(draw_world(GetParam())), knots_(world_.model), evaluator_(world_.model) {}

  std::vector<DmsSupport> supports(std::uint32_t t) {
    const auto corners = knots_.corners(t);
    DmsRegion region(knots_, {corners.begin(), corners.end()}, face_planes(corners));
    return region.supports();
  }
  // All N_γ with limits from inside of the tetrahedron.
  std::map<std::pair<std::uint32_t, std::size_t>, Rational> basis(std::uint32_t t,
                                                                  const DmsPoint& u) {
    const Shares even{Rational(1) / Rational(4), Rational(1) / Rational(4),
                      Rational(1) / Rational(4), Rational(1) / Rational(4)};
    const DmsPlace place{
        t, EntryPath::inward(ExactPoint3(u), ExactPoint3(point_at(knots_.corners(t), even)))};
    std::map<std::pair<std::uint32_t, std::size_t>, Rational> out;
    evaluator_.for_each_basis(
        place, world_.model.degree - 1,
        [&](std::uint32_t other, const TetrahedralIndex& gamma, const Rational& n) {
          out[{other, tetrahedral_index(gamma)}] = n;
        });
    return out;
  }

  World world_;
  DmsKnotTable knots_;
  DmsEvaluator evaluator_;
};

// PROVES DMS-4.L1
TEST_P(LocalWorld, PolynomialAndRestsAddUpToTheAttribute) {
  const Rational level = Rational(1) / Rational(3);
  DmsIsoLocal local(world_.model, knots_, 3, level);
  Random random(GetParam());
  const int n = world_.model.degree;
  for (std::uint32_t t = 0; t < world_.model.tetrahedra.size(); t += 5) {
    const auto all = supports(t);
    const DmsIsoForm form = local.form(t, all);
    for (int round = 0; round < 6; ++round) {
      const Shares shares = draw_shares(random);
      const DmsPoint u = point_at(knots_.corners(t), shares);
      auto values = basis(t, u);
      const auto place = evaluator_.locate(u);
      ASSERT_TRUE(place);
      const Rational exact = evaluator_.component(*place, 3) - level;
      EXPECT_EQ(exact, evaluator_.evaluate(*place).value[3] - level);
      const ScopedUpward upward;
      Interval sum(0.0);
      std::size_t b = 0;
      for_each_tetrahedral_index(n, [&](const TetrahedralIndex& beta) {
        Rational weight(1);
        int left = n;
        for (std::size_t m = 0; m < 4; ++m)
          for (int k = 0; k < beta[m]; ++k, --left)
            weight *= shares[m] * Rational(left) / Rational(k + 1);
        sum = sum + form.coefficients[b++] * enclose(weight);
      });
      for (std::size_t s = 0; s < form.supports.size(); ++s) {
        const Rational& share =
            values[{form.supports[s].tetrahedron, tetrahedral_index(form.supports[s].gamma)}];
        Interval rest(0.0);
        for (std::size_t m = 0; m < 4; ++m)
          rest = rest + form.rests[4 * s + m] * enclose(shares[m]);
        sum = sum + rest * enclose(share);
      }
      EXPECT_TRUE(sum.lo() <= nearest_double(exact) + 1e-12 &&
                  nearest_double(exact) - 1e-12 <= sum.hi())
          << world_.text << ", tetrahedron " << t << ": " << nearest_double(exact);
      EXPECT_LT(sum.hi() - sum.lo(), 1e-12) << world_.text;
    }
  }
}

// PROVES DMS-4.L2
TEST_P(LocalWorld, SharesAreAtLeastTheLeastAtCorners) {
  Random random(GetParam() + 1000);
  for (std::uint32_t t = 0; t < world_.model.tetrahedra.size(); t += 5) {
    std::array<DmsPoint, 4> corners;
    for (DmsPoint& p : corners) p = point_at(knots_.corners(t), draw_shares(random));
    std::vector<std::map<std::pair<std::uint32_t, std::size_t>, Rational>> at;
    for (const DmsPoint& p : corners) at.push_back(basis(t, p));
    for (int round = 0; round < 6; ++round) {
      auto inside = basis(t, point_at(corners, draw_shares(random)));
      Rational sum;
      for (const auto& [key, value] : inside) sum += value;
      EXPECT_EQ(sum, Rational(1)) << world_.text;
      for (const auto& [key, value] : at[0]) {
        Rational least = value;
        for (const auto& values : at)
          least = std::min(least, values.contains(key) ? values.at(key) : Rational(0));
        EXPECT_GE(inside[key], least) << world_.text << ", tetrahedron " << t;
      }
    }
  }
}

// What the rule says with shares at corners, beside exact values in the cell.
// PROVES DMS-4.R1
TEST_P(LocalWorld, SignsAndGrowthWithSharesAreRight) {
  const DmsIsoRule rule(world_.model.degree);
  DmsIsoLocal local(world_.model, knots_, 3, Rational());
  Random random(GetParam() + 2000);
  int signs = 0, growths = 0;
  for (std::uint32_t t = 0; t < world_.model.tetrahedra.size(); t += 3) {
    DmsIsoForm form = local.form(t, supports(t));
    std::array<DmsPoint, 4> corners = knots_.corners(t);
    for (int step = 0; step < 9; ++step) {
      const auto edge = static_cast<std::size_t>(random.between(0, 5));
      const auto [i, j] = kDmsEdges[edge];
      const Rational place = Rational(random.between(1, 7)) / Rational(8);
      auto [first, second] = rule.cut(form, edge, place);
      DmsPoint middle;
      for (std::size_t c = 0; c < 3; ++c)
        middle[c] = corners[i][c] + place * (corners[j][c] - corners[i][c]);
      const bool is_first = random.between(0, 1) == 0;
      form = is_first ? first : second;
      corners[is_first ? j : i] = middle;
    }
    for (std::size_t m = 0; m < 4; ++m) {
      auto values = basis(t, corners[m]);
      for (std::size_t s = 0; s < form.supports.size(); ++s)
        form.shares[4 * s + m] = std::max(
            0.0,
            round_down(
                values[{form.supports[s].tetrahedron, tetrahedral_index(form.supports[s].gamma)}]));
    }
    const auto value_at = [&](const Shares& shares) {
      return evaluator_.component(*evaluator_.locate(point_at(corners, shares)), 3);
    };
    const int sign = rule.sign_on(form, kAllCorners);
    for (int round = 0; round < 4 && sign != 0; ++round)
      EXPECT_EQ(static_cast<int>(value_at(draw_shares(random)).sign()), sign) << world_.text;
    for (std::size_t e = 0; e < kDmsEdges.size(); ++e) {
      const auto [i, j] = kDmsEdges[e];
      const DmsCorners ends = 1u << i | 1u << j;
      const int sign_on_edge = rule.sign_on(form, ends);
      const bool is_monotone = rule.is_monotone_on(form, ends);
      signs += sign_on_edge != 0 ? 1 : 0;
      growths += is_monotone ? 1 : 0;
      std::vector<Rational> along;
      for (int k = 0; k <= 4; ++k) {
        Shares shares;
        shares[i] = Rational(4 - k) / Rational(4), shares[j] = Rational(k) / Rational(4);
        along.push_back(value_at(shares));
      }
      for (const Rational& value : along) {
        if (sign_on_edge != 0) {
          EXPECT_EQ(static_cast<int>(value.sign()), sign_on_edge) << world_.text;
        }
      }
      EXPECT_TRUE(!is_monotone || std::is_sorted(along.begin(), along.end()) ||
                  std::is_sorted(along.rbegin(), along.rend()))
          << world_.text << ", tetrahedron " << t;
    }
  }
  EXPECT_GT(signs, 0) << world_.text;
  EXPECT_GT(growths, 0) << world_.text;
}

INSTANTIATE_TEST_SUITE_P(Seeds, LocalWorld, testing::Range<std::uint64_t>(1, 7));

}  // namespace
}  // namespace veritope
