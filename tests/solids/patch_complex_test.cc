// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/patch_complex.h"

#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "robust/base/random.h"
#include "splines/bezier_domain.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

// Vertices, edges, patches and the genus of the only shell.
void expect_one_shell(const PatchComplex& complex, std::uint64_t v, std::uint64_t e,
                      std::uint64_t f, std::int64_t genus) {
  EXPECT_TRUE(complex.is_closed_oriented_surface()) << all_findings(complex);
  ASSERT_EQ(complex.shells().size(), 1u);
  const PatchShell& shell = complex.shells()[0];
  EXPECT_EQ(shell.vertices, v);
  EXPECT_EQ(shell.edges, e);
  EXPECT_EQ(shell.patches, f);
  EXPECT_EQ(shell.genus(), std::optional(genus));
  EXPECT_EQ(complex.num_vertices(), v);
  EXPECT_EQ(complex.num_edges(), e);
  EXPECT_EQ(complex.euler(), 2 - 2 * genus);
}

TEST(PatchComplex, CountsTheCellsOfABox) { expect_one_shell(complex_of(unit_box()), 8, 12, 6, 0); }
TEST(PatchComplex, CountsTheCellsOfASphereOfSixPatches) {
  expect_one_shell(complex_of(patch_shapes::sphere()), 8, 12, 6, 0);
}
// 8, 0 and -2 are what the wrong rules for collapsed rows give: ends not joined; rows as unpaired edges; corners joined by place.
TEST(PatchComplex, AnOctantSphereIsSixMinusTwelvePlusEight) {
  expect_one_shell(complex_of(patch_shapes::octant_sphere()), 6, 12, 8, 0);
}
TEST(PatchComplex, CountsTheCellsOfATorus) {
  expect_one_shell(complex_of(patch_shapes::torus(3, 1)), 16, 32, 16, 1);
}
TEST(PatchComplex, OnePatchMayCloseOnItself) {
  const PatchComplex complex = complex_of(patch_shapes::one_patch_torus(3, 1));
  expect_one_shell(complex, 1, 2, 1, 1);
  EXPECT_EQ(complex.mate({0, 0}), std::optional(PatchSide{0, 2}));
  EXPECT_EQ(complex.mate({0, 1}), std::optional(PatchSide{0, 3}));
}
// Glued at one place in space only: two vertices, two shells.
TEST(PatchComplex, NeverJoinsVerticesByPlace) {
  const Patches tets{flat({0, 0, 0}, {0, 1, 1}, {1, 0, 1}), flat({0, 0, 0}, {1, 0, 1}, {0, 0, 1}),
                     flat({0, 0, 0}, {0, 0, 1}, {0, 1, 1}), flat({0, 1, 1}, {0, 0, 1}, {1, 0, 1})};
  Patches both = tets;
  const Patches below = patch_shapes::placed(tets, -1, {0, 0, 0});
  both.insert(both.end(), below.begin(), below.end());
  const PatchComplex complex = complex_of(both);
  EXPECT_TRUE(complex.is_closed_oriented_surface()) << all_findings(complex);
  EXPECT_EQ(complex.num_vertices(), 8u);
  ASSERT_EQ(complex.shells().size(), 2u);
  for (const PatchShell& shell : complex.shells()) EXPECT_EQ(shell.euler(), 2);
}
TEST(PatchComplex, MatesAreMutualAndShareTheirVertices) {
  const PatchComplex complex = complex_of(patch_shapes::sphere());
  for (std::uint32_t p = 0; p < 6; ++p)
    for (std::uint32_t s = 0; s < 4; ++s) {
      const auto mate = complex.mate({p, s});
      ASSERT_TRUE(mate.has_value());
      EXPECT_EQ(complex.mate(*mate), std::optional(PatchSide{p, s}));
      EXPECT_EQ(complex.edge(*mate), complex.edge({p, s}));
      EXPECT_EQ(complex.vertex({p, s}), complex.vertex({mate->patch, (mate->side + 1) % 4}));
      EXPECT_NE(complex.travel(*mate), complex.travel({p, s}));
    }
}
TEST(PatchComplex, NeighboursOfOtherDegreeAndFactorMatch) {
  Patches box = unit_box();
  Patch::Tensor map = to_rational(elevate_to(box[2].tensor(), {3, 2}));
  for (Rational& v : map.coefficients()) v *= Rational(5) / 7;
  box[2] = make_patch(std::move(map)).value();
  expect_one_shell(complex_of(box), 8, 12, 6, 0);
}
// Equal as sets, but one runs at another speed: S0 asks for equal maps.
TEST(PatchComplex, EqualCurvesOfAnotherSpeedDoNotMatch) {
  Patches box = unit_box();
  Patch::Tensor map = elevate_to(box[0].tensor(), {2, 2});
  for (std::size_t i = 0; i < 3; ++i) map.component(2)[3 * i + 1] += Rational(1) / 8;
  for (std::size_t i = 3; i < 6; ++i) map.component(1)[i] += Rational(1) / 8;
  box[0] = make_patch(std::move(map)).value();
  const PatchComplex complex = complex_of(box);
  EXPECT_FALSE(complex.is_closed_oriented_surface());
  EXPECT_GE(complex.count(PatchDefect::kOpenSide), 2u);
}

// Curves that agree in the low 64 bits of all numbers, so that hashes do not tell them apart.
TEST(PatchComplex, EqualHashesDoNotMakeEqualSides) {
  const Rational big = Rational::power_of_two(200);
  Patches both = unit_box();
  const auto far = [&](const Rational& x) {
    return patch_shapes::placed(unit_box(), 1, {big + x, big, big});
  };
  for (const int x : {0, 1})
    for (const Patch& p : far(Rational::power_of_two(100) * Rational(x))) both.push_back(p);
  const PatchComplex complex = complex_of(both);
  EXPECT_TRUE(complex.is_closed_oriented_surface()) << all_findings(complex);
  EXPECT_EQ(complex.shells().size(), 3u);
}

// Two curves of S0, by its words: equal after elevation up to one positive factor.
bool is_same_curve(const Patch::Curve& a, const Patch::Curve& b) {
  const auto [x, y] = to_common_degrees(to_rational(a), to_rational(b));
  const auto p = x.coefficients(), q = y.coefficients();
  std::size_t first = 0;
  while (first < p.size() && p[first].sign() == Sign::kZero) ++first;
  if (first == p.size() || q[first].sign() != p[first].sign()) return x == y;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (!(p[i] * q[first] == q[i] * p[first])) return false;
  return true;
}
// Patches on four points, weights -1 to 2: many coincidences, collapsed sides, sides that are their own reverse.
Patch random_patch(Random& random) {
  const bool is_rational = random.below(3) == 0, is_triangle = random.below(2) == 0;
  const int width = is_rational ? 4 : 3, p = 1 + static_cast<int>(random.below(2)),
            q = 1 + static_cast<int>(random.below(2));
  const std::size_t count =
      is_triangle ? num_triangle_coefficients(p) : static_cast<std::size_t>((p + 1) * (q + 1));
  std::vector<Rational> values(count * static_cast<std::size_t>(width));
  for (std::size_t i = 0; i < count; ++i) {
    const Rational w = is_rational ? random.between(random.below(9) == 0 ? -1 : 1, 2) : 1;
    const std::uint64_t corner = random.below(4);
    for (std::size_t c = 0; c < 3; ++c) values[c * count + i] = corner == c ? w : Rational(0);
    if (is_rational) values[3 * count + i] = w;
  }
  if (is_triangle)
    return make_patch(Patch::Triangle(p, width, is_rational, std::move(values))).value();
  return make_patch(Patch::Tensor({p, q}, width, is_rational, std::move(values))).value();
}
TEST(PatchComplex, FindsTheEdgesThatComparingAllSidesFinds) {
  Random random(6300);
  std::size_t shared = 0;
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE("round " + std::to_string(round) + " of seed 6300");
    Patches soup;
    for (std::uint64_t n = 1 + random.below(8); n > 0; --n) soup.push_back(random_patch(random));
    const PatchComplex complex = complex_of(soup);
    std::vector<PatchSide> all;
    for (std::uint32_t p = 0; p < soup.size(); ++p)
      for (std::uint32_t s = 0; s < soup[p].num_sides(); ++s) all.push_back({p, s});
    for (const PatchSide a : all)
      for (const PatchSide b : all) {
        const Patch::Curve x = soup[a.patch].side(a.side), y = soup[b.patch].side(b.side);
        if (complex.is_collapsed(a) || complex.is_collapsed(b)) continue;
        const bool alike = is_same_curve(x, y), opposite = is_same_curve(x, reversed(y, 0));
        ASSERT_EQ(complex.edge(a) == complex.edge(b), alike || opposite);
        shared += a < b && (alike || opposite) ? 1 : 0;
        if (!alike && !opposite) continue;
        const Travel s = complex.travel(a), t = complex.travel(b);
        EXPECT_EQ(s == t, alike);
        EXPECT_EQ(s == Travel::kBoth, alike && opposite);
      }
    for (const PatchFinding& f : complex.findings()) EXPECT_FALSE(describe(complex, f).empty());
  }
  EXPECT_GT(shared, 200u);
}

// 100,000 patches against 25,000: near-linear, by a ratio within one run.
TEST(PatchComplex, GluesManyPatches) {
  constexpr int kRows = 250, kColumns = 100;
  const PatchComplex complex = complex_of(patch_shapes::grid_torus(kRows, kColumns));
  EXPECT_TRUE(complex.is_closed_oriented_surface());
  EXPECT_EQ(complex.shells()[0].genus(), std::optional<std::int64_t>(1));
  EXPECT_EQ(complex.num_vertices(), std::size_t{kRows * kColumns});
}

}  // namespace
}  // namespace veritope
