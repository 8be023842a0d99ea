// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_make_test.cc: models made over domains: clouds that are admissible, control points by a rule.
#include "solids/dms/dms_make.h"

#include <gtest/gtest.h>

#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_evaluator.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

DmsModel identity(DmsModel domain, std::vector<Rational> attribute = {}) {
  if (!attribute.empty()) domain.attributes = {"a"};
  set_control_by_rule(domain, DmsControlRule::kGreville, attribute);
  return domain;
}

Rational tenth() { return Rational(1) / Rational(10); }

TEST(MakeDms, ReproducesTheDomainByTheGrevilleRule) {
  Random random(1);
  const DmsModel domain =
      identity(kuhn_domain({2, 2, 2}, [](int x, int y, int z) { return x + y + z < 3; }));
  for (int degree = 1; degree <= 4; ++degree)
    for (const bool has_clouds : {false, true}) {
      DmsMakeOptions options{degree, std::nullopt, DmsControlRule::kGreville};
      if (has_clouds) options.clouds = DmsCloudDraw{tenth(), 7};
      const Result<DmsModel> made = make_dms(domain, options);
      ASSERT_TRUE(made.has_value());
      EXPECT_TRUE(validate(*made).has_value());
      EXPECT_EQ(find_dms_defects(*made).count, 0u);
      const bool is_collapsed = std::all_of(made->clouds.begin(), made->clouds.end(),
                                            [](const DmsCloud& c) { return c.size() == 1; });
      EXPECT_EQ(is_collapsed, !has_clouds || degree == 1);
      DmsEvaluator evaluator(*made);
      for (int i = 0; i < 10; ++i) {
        const DmsPoint u = draw_dms_point(random, *made);
        const auto place = evaluator.locate(u);
        ASSERT_TRUE(place.has_value());
        const DmsValue value = evaluator.evaluate(*place);
        EXPECT_TRUE(std::equal(u.begin(), u.end(), value.value.begin())) << text_of(u);
        // The basis functions add up to 1 also at saddle vertices: the clouds satisfy (c).
        Rational sum;
        evaluator.for_each_basis(
            *place, degree - 1,
            [&](std::uint32_t, const TetrahedralIndex&, const Rational& n) { sum += n; });
        EXPECT_EQ(sum, Rational(1)) << text_of(u);
      }
    }
}

TEST(MakeDms, TheRuleOfThePaperDeviatesUnlessCloudsAreCollapsed) {
  const DmsModel domain = identity(kuhn_domain({2, 2, 2}));
  const DmsPoint u{Rational(1), Rational(6) / Rational(5), Rational(4) / Rational(5)};
  const auto value_of = [&](std::optional<DmsCloudDraw> clouds) {
    const Result<DmsModel> made = make_dms(domain, {3, std::move(clouds), DmsControlRule::kEdges});
    DmsEvaluator evaluator(*made);
    return evaluator.evaluate(*evaluator.locate(u)).value;
  };
  EXPECT_EQ(value_of(std::nullopt), (std::vector<Rational>{u[0], u[1], u[2]}));
  EXPECT_NE(value_of(DmsCloudDraw{tenth(), 1}), (std::vector<Rational>{u[0], u[1], u[2]}));
}

TEST(MakeDms, KeepsAttributesWhereCloudsAreCollapsed) {
  DmsModel shape = kuhn_domain({1, 1, 1});
  std::vector<Rational> attribute;
  for (std::size_t v = 0; v < shape.clouds.size(); ++v) attribute.emplace_back(v * v);
  const DmsModel domain = identity(shape, attribute);
  const Result<DmsModel> made = make_dms(domain, {4, std::nullopt, DmsControlRule::kGreville});
  ASSERT_TRUE(made.has_value());
  DmsEvaluator before(domain), after(*made);
  Random random(5);
  for (int i = 0; i < 30; ++i) {
    const DmsPoint u = draw_dms_point(random, domain);
    EXPECT_EQ(before.evaluate(*before.locate(u)).value, after.evaluate(*after.locate(u)).value);
  }
}

// Rounds of clouds that are far too large end with admissible ones.
TEST(MakeDms, ShrinksCloudsUntilTheyAreAdmissible) {
  const DmsModel domain = identity(kuhn_domain({2, 2, 1}));
  for (const long radius : {1L, 10L, 1'000'000L}) {
    const Result<DmsModel> made =
        make_dms(domain, {3, DmsCloudDraw{Rational(radius), 3}, DmsControlRule::kGreville});
    ASSERT_TRUE(made.has_value());
    EXPECT_EQ(find_dms_defects(*made).count, 0u);
  }
}

TEST(MakeDms, DrawsTheSameCloudsForASeed) {
  const DmsModel domain = identity(kuhn_domain({1, 1, 1}));
  const auto make = [&](std::uint64_t seed) {
    return *make_dms(domain, {3, DmsCloudDraw{tenth(), seed}, DmsControlRule::kGreville});
  };
  EXPECT_EQ(make(4), make(4));
  EXPECT_FALSE(make(4) == make(5));
}

TEST(MakeDms, RefusesWhatIsNoDomain) {
  const DmsModel domain = identity(kuhn_domain({1, 1, 1}));
  const auto refusal = [](const DmsModel& model, const DmsMakeOptions& options) {
    const Result<DmsModel> made = make_dms(model, options);
    return made ? "" : made.error().message;
  };
  EXPECT_EQ(refusal(domain, {0, std::nullopt, DmsControlRule::kGreville}),
            "the degree must be from 1 to 9, not 0");
  EXPECT_EQ(refusal(domain, {-1, std::nullopt, DmsControlRule::kGreville}),
            "the degree must be from 1 to 9, not 0");
  EXPECT_EQ(refusal(domain, {10, std::nullopt, DmsControlRule::kGreville}),
            "the degree must be from 1 to 9, not 10");
  EXPECT_EQ(refusal(domain, {2, DmsCloudDraw{Rational(-1), 0}, DmsControlRule::kGreville}),
            "the radius of clouds must not be negative");
  EXPECT_EQ(refusal(*make_dms(domain, {}), {}), "a domain must have degree 1, not 2");
  DmsModel moved = domain;
  moved.control.values[4] += Rational(1);
  EXPECT_EQ(refusal(moved, {}),
            "the map of a domain must be the identity, and the control point of vertex 1 is not at "
            "the vertex");
  DmsModel reversed = domain;
  std::swap(reversed.tetrahedra[3][0], reversed.tetrahedra[3][1]);
  EXPECT_EQ(refusal(reversed, {}), "the domain has defects: tet-reversed: tetrahedron 3: d < 0");
  DmsModel separate = domain;
  separate.control.is_separate = true;
  EXPECT_EQ(refusal(separate, {}), "a domain must have shared control points");
}

TEST(MakeDms, PlacesControlPointsByTheirRule) {
  DmsModel model = kuhn_domain({1, 1, 1});
  model.degree = 3;
  model.clouds[0].push_back({Rational(-3), 0, 0});
  model.clouds[0].push_back({0, Rational(-3), 0});
  const std::vector<std::uint32_t> vertices{0, 0, 7};
  EXPECT_EQ(
      control_place(model, vertices, DmsControlRule::kGreville),
      (DmsPoint{Rational(-2) / Rational(3), Rational(1) / Rational(3), Rational(1) / Rational(3)}));
  EXPECT_EQ(
      control_place(model, vertices, DmsControlRule::kEdges),
      (DmsPoint{Rational(1) / Rational(3), Rational(1) / Rational(3), Rational(1) / Rational(3)}));
}

}  // namespace
}  // namespace veritope
