// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/dms_boundaries_test.cc: boundaries of two domains as sets: faces cut in different ways, and differences
// of any size.
#include "solids/dms/dms_boundaries.h"

#include <gtest/gtest.h>

#include <utility>

#include "solids/dms/dms_defects.h"
#include "solids/dms/dms_insert.h"
#include "solids/dms/dms_make.h"
#include "tests/predicates/test_scale.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

DmsModel identity_of(DmsModel domain) {
  domain.control = {};
  set_control_by_rule(domain, DmsControlRule::kGreville, {});
  return domain;
}
// An attribute domain of one attribute over the tetrahedra of a domain.
DmsModel as_attributes(const DmsModel& domain) {
  DmsModel own;
  own.num_coordinates = 0;
  own.attributes = {"b"};
  own.clouds = domain.clouds;
  own.tetrahedra = domain.tetrahedra;
  for (std::uint32_t v = 0; v < own.clouds.size(); ++v) {
    own.control.at.push_back(v);
    own.control.values.emplace_back(v);
  }
  return own;
}

// Whether the point is in a face of the boundary: by solving for the shares, not by the code under test.
bool is_on_boundary(const DmsModel& model, const DmsPoint& p) {
  const TetrahedralComplex complex(model.tetrahedra,
                                   static_cast<std::uint32_t>(model.clouds.size()));
  for (const TetrahedronFace f : complex.boundary()) {
    const auto v = complex.vertices(f);
    const auto &a = model.clouds[v[0]][0], &b = model.clouds[v[1]][0], &c = model.clouds[v[2]][0];
    if (simplex_oracle::volume6(a, b, c, p).sign() != Sign::kZero) continue;
    // Off the plane lies e; p is in the face if no side of the pyramid over it has p on its other side.
    const auto normal = [&](std::size_t i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      return (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
    };
    DmsPoint e = a;
    for (std::size_t i = 0; i < 3; ++i) e[i] += normal(i);
    const Sign whole = simplex_oracle::volume6(a, b, c, e).sign();
    const auto is_inner = [&](const DmsPoint& x, const DmsPoint& y, const DmsPoint& z) {
      return simplex_oracle::volume6(x, y, z, e).sign() != -whole;
    };
    if (is_inner(p, b, c) && is_inner(a, p, c) && is_inner(a, b, p)) return true;
  }
  return false;
}

// Another domain of the same set: vertices inside of tetrahedra, on faces and edges.
DmsModel refined(DmsModel model, Random& random, int vertices) {
  for (int i = 0; i < vertices; ++i) {
    const auto& t = model.tetrahedra[random.below(model.tetrahedra.size())];
    DmsPoint at;
    Rational total;
    for (std::size_t m = 0, n = 2 + random.below(3); m < n; ++m) {
      const Rational weight(random.between(1, 4));
      for (std::size_t c = 0; c < 3; ++c) at[c] += weight * model.knot(t[m], 0)[c];
      total += weight;
    }
    for (Rational& c : at) c /= total;
    model = insert_dms_vertex(model, {at}).value().model;
  }
  return model;
}

TEST(DmsBoundaries, AreOneSetHoweverTheyAreCut) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(20)); ++seed) {
    Random random(seed);
    std::string text;
    const DmsModel domain = identity_of(internal::draw_domain(random, text));
    const DmsModel a = refined(domain, random, 4), b = refined(domain, random, 4);
    EXPECT_FALSE(find_boundary_difference(a, b)) << "seed " << seed << " " << text;
    EXPECT_FALSE(find_boundary_difference(b, a)) << "seed " << seed << " " << text;
  }
}

TEST(DmsBoundaries, HaveAPointOfOneAlone) {
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scaled(30)); ++seed) {
    Random random(seed);
    std::string text;
    const DmsModel domain = identity_of(internal::draw_domain(random, text));
    const DmsModel a = refined(domain, random, 3);
    DmsModel b = refined(domain, random, 3);
    // A vertex of the boundary moves a little.
    const TetrahedralComplex complex(b.tetrahedra, static_cast<std::uint32_t>(b.clouds.size()));
    const auto& boundary = complex.boundary();
    const std::uint32_t v = complex.vertices(boundary[random.below(boundary.size())])[0];
    for (Rational& c : b.clouds[v][0])
      c += Rational(random.between(1, 9)) * Rational::power_of_two(-40);
    if (find_dms_defects(b, 1).count > 0) continue;
    for (const bool is_swapped : {false, true}) {
      const DmsModel &first = is_swapped ? b : a, &second = is_swapped ? a : b;
      const auto found = find_boundary_difference(first, second);
      ASSERT_TRUE(found) << "seed " << seed << " " << text;
      EXPECT_EQ(is_on_boundary(first, found->point), !found->is_of_second) << "seed " << seed;
      EXPECT_EQ(is_on_boundary(second, found->point), found->is_of_second) << "seed " << seed;
    }
  }
}

TEST(DmsBoundaries, ASecondBodyIsADifference) {
  const DmsModel one = kuhn_domain({1, 1, 1});
  const DmsModel two = kuhn_domain({3, 1, 1}, [](int x, int, int) { return x != 1; });
  const auto found = find_boundary_difference(one, two);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_of_second);
  EXPECT_GE(found->point[0], Rational(2));
  EXPECT_FALSE(find_boundary_difference(two, two));
}

TEST(DmsBoundaries, AFaceInsideOfTheOtherDomainIsADifference) {
  const DmsModel whole = kuhn_domain({2, 2, 2});
  const DmsModel notched =
      kuhn_domain({2, 2, 2}, [](int x, int y, int z) { return x + y + z < 3; });
  for (const bool is_swapped : {false, true}) {
    const auto found = is_swapped ? find_boundary_difference(notched, whole)
                                  : find_boundary_difference(whole, notched);
    ASSERT_TRUE(found);
    EXPECT_NE(is_on_boundary(whole, found->point), is_on_boundary(notched, found->point));
  }
}

TEST(DmsAttributeDomain, HasDefectsOfItsOwnAndIsComparedLast) {
  DmsModel model = identity_of(kuhn_domain({1, 1, 1}));
  model.attribute_domain = {as_attributes(kuhn_domain({1, 1, 1}))};
  ASSERT_TRUE(validate(model));
  EXPECT_EQ(find_dms_defects(model).count, 0u);

  DmsModel reversed = model;
  std::swap(reversed.attribute_domain[0].tetrahedra[2][0],
            reversed.attribute_domain[0].tetrahedra[2][1]);
  DmsDefects defects = find_dms_defects(reversed);
  ASSERT_GT(defects.count, 0u);
  EXPECT_TRUE(defects.first[0].is_of_attributes);
  EXPECT_EQ(to_string(defects.first[0]), "attribute domain: tetrahedron 2: d < 0");
  EXPECT_EQ(find_geometry_defects(reversed).count, 0u);

  DmsModel other = model;
  other.attribute_domain = {as_attributes(kuhn_domain({1, 1, 2}))};
  defects = find_dms_defects(other);
  ASSERT_EQ(defects.count, 1u);
  EXPECT_EQ(defects.first[0].fault, DmsFault::kDomainsDiffer);
  EXPECT_STREQ(fault_name(defects.first[0].fault), "domains-differ");
  EXPECT_FALSE(defects.first[0].has_beta());
  EXPECT_EQ(is_on_boundary(model, *defects.first[0].point), !defects.first[0].is_of_attributes);
}

TEST(DmsAttributeDomain, ValidateDemandsWhatTheFormatDoes) {
  DmsModel model = identity_of(kuhn_domain({1, 1, 1}));
  const DmsModel own = as_attributes(kuhn_domain({1, 1, 1}));
  EXPECT_TRUE(validate(own));
  model.attribute_domain = {own, own};
  EXPECT_FALSE(validate(model));
  model.attribute_domain = {own};
  model.attribute_domain[0].num_coordinates = 3;
  EXPECT_FALSE(validate(model));
  model.attribute_domain = {own};
  model.attribute_domain[0].attribute_domain = {own};
  EXPECT_FALSE(validate(model));
  model.attribute_domain = {own};
  model.attributes = {"b"};
  for (std::size_t c = 0; c < 8; ++c)
    model.control.values.insert(
        model.control.values.begin() + static_cast<std::ptrdiff_t>(4 * c + 3), Rational(1));
  ASSERT_FALSE(validate(model));
  EXPECT_EQ(validate(model).error().message,
            "attribute 0 of the attribute domain has the name of attribute 0 of the model");
  model.attributes = {"a"};
  EXPECT_TRUE(validate(model));
  EXPECT_EQ(all_attributes(model), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(find_attribute(model, "a")->component, 3u);
  EXPECT_EQ(find_attribute(model, "b")->component, 0u);
  EXPECT_EQ(find_attribute(model, "b")->spline, &model.attribute_domain[0]);
  EXPECT_FALSE(find_attribute(model, "c"));
  model.attribute_domain[0].control.values.pop_back();
  EXPECT_FALSE(validate(model));
}

}  // namespace
}  // namespace veritope
