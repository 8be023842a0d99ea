// SPDX-License-Identifier: LGPL-3.0-or-later
// Star covers of models that a plain search does not cover: vertices without half-space, flat and far-away models; and the places of contacts.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "models/patch_shapes.h"
#include "solids/patches/patch_transform.h"
#include "solids/star_box/mesh_box.h"
#include "tests/certify/patch_checkers.h"
#include "verify/certify/cover_question.h"

namespace veritope {
namespace {

using patch_shapes::Patches;
using Corner = std::array<int, 3>;

PatchComplex complex_of(Patches patches) { return make_patch_complex(std::move(patches)).value(); }

void add_triangle(Patches& to, const std::array<Corner, 3>& corners) {
  Patch::Triangle map(1, 3, false);
  for (std::size_t i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) map.component(k)[i] = corners[i][static_cast<std::size_t>(k)];
  to.push_back(make_patch(std::move(map), {PatchOrigin::Kind::kTriangle, to.size(), {}}).value());
}

// The terrain over a hexagon around the origin, at height 0 in the middle and `height` and -height in turn at the rim, closed by walls and a bottom: for
// great heights the normals at the origin lie in no open half-space (a monkey saddle of six triangles).
Patches monkey_saddle(int height) {
  const Corner rim[6] = {{4, 0, 0}, {2, 4, 0}, {-2, 4, 0}, {-4, 0, 0}, {-2, -4, 0}, {2, -4, 0}};
  Patches out;
  for (std::size_t i = 0; i < 6; ++i) {
    Corner a = rim[i], b = rim[(i + 1) % 6], low_a = a, low_b = b;
    a[2] = i % 2 == 0 ? height : -height, b[2] = -a[2];
    low_a[2] = low_b[2] = -2 * height;
    add_triangle(out, {Corner{0, 0, 0}, a, b});
    add_triangle(out, {a, low_a, low_b});
    add_triangle(out, {a, low_b, b});
    add_triangle(out, {Corner{0, 0, -2 * height}, low_b, low_a});
  }
  return out;
}

std::size_t num_mesh_boxes(const PatchDecision& d) {
  return static_cast<std::size_t>(std::count_if(d.cover.boxes.begin(), d.cover.boxes.end(),
                                                [](const CoverBox& b) { return b.is_mesh; }));
}

// PROVES STAR-1
TEST(MeshBoxes, CoverVerticesWhoseNormalsLieInNoHalfSpace) {
  const CertifiedPatches gentle = certified_patches(monkey_saddle(1));
  ASSERT_TRUE(gentle.decision.is_valid);
  expect_accepted(gentle, "gentle saddle");
  const CertifiedPatches steep = certified_patches(monkey_saddle(64));
  ASSERT_TRUE(steep.decision.is_valid) << steep.decision.open->message;
  EXPECT_GE(num_mesh_boxes(steep.decision), 1u);
  expect_accepted(steep, "steep saddle");
  EXPECT_EQ(steep.decision.shells.at(0).genus, 0);
}

TEST(MeshBoxes, AreRefusedAtTheFlatZFold) {
  const PatchComplex complex = complex_of(patch_shapes::wrinkled_cube());
  PieceForest forest = PieceForest::make(complex).value();
  const double size = std::ldexp(1.0, forest.frame().scale[0]);
  FlatPatches triangles(complex, FlatPatches::Kind::kTriangles);
  const auto around = [&](double x, double y, double z, double half) {
    half *= size;
    return Box3d{{x * size - half, y * size - half, z * size - half},
                 {x * size + half, y * size + half, z * size + half}};
  };
  EXPECT_FALSE(mesh_box_patches(forest, triangles, around(0, 0, 4, 0.25), 48));
  EXPECT_FALSE(mesh_box_patches(forest, triangles, around(-2, 0, 4, 0.25), 48));
  // At a corner of the cube, away from the fold, they meet properly; not if fewer triangles are allowed than meet.
  const auto corner = mesh_box_patches(forest, triangles, around(4, 4, -4, 0.25), 48);
  ASSERT_TRUE(corner);
  EXPECT_GE(corner->size(), 3u);
  EXPECT_FALSE(mesh_box_patches(forest, triangles, around(4, 4, -4, 0.25), corner->size() - 1));
  const CertifiedPatches fold = certified_patches(patch_shapes::wrinkled_cube());
  EXPECT_FALSE(fold.decision.is_valid);
}

TEST(MeshBoxes, AreNoneWherePatchesAreCurved) {
  const PatchComplex complex = complex_of(patch_shapes::pn_torus(12, 8));
  PieceForest forest = PieceForest::make(complex).value();
  FlatPatches triangles(complex, FlatPatches::Kind::kTriangles);
  EXPECT_FALSE(mesh_box_patches(forest, triangles, forest.node(0).hull, 1000));
  EXPECT_TRUE(mesh_box_patches(forest, triangles, {{5, 5, 5}, {6, 6, 6}}, 1000));  // nothing is met
}

AffineMap diagonal(const Rational& a, const Rational& b, const Rational& c, const Rational& shift) {
  const Rational o;
  return {3, 3, {a, o, o, o, b, o, o, o, c}, {shift, o, Rational(1) / Rational(3)}};
}

TEST(Frames, FarAndFlatModelsAreCertifiedWithAsManyBoxes) {
  const auto p2 = [](int n) { return Rational::power_of_two(n); };
  const std::size_t plain = certified_patches(patch_shapes::sphere()).decision.cover.boxes.size();
  const std::vector<std::pair<const char*, AffineMap>> maps = {
      {"2^30 away", diagonal(1, 1, 1, p2(30))},
      {"2^45 away", diagonal(1, 1, 1, p2(45))},
      {"1 : 10^-6 : 10^6", diagonal(1, Rational(1) / Rational(1000000), 1000000, 0)},
      {"2^-300 and far",  // the volume, 2^-900, is a normal number
       {3, 3, {p2(-300), 0, 0, 0, p2(-300), 0, 0, 0, p2(-300)}, {p2(-260), 0, 0}}},
      {"mirrored in x, flat, far", diagonal(-1, p2(-20), 1, p2(20))}};
  for (const auto& [name, map] : maps) {
    const CertifiedPatches c = certified_patches(affine_image(patch_shapes::sphere(), map).value());
    ASSERT_TRUE(c.decision.is_valid) << name << ": " << c.decision.open->message;
    EXPECT_LE(c.decision.cover.boxes.size(), 2 * plain) << name;
    expect_accepted(c, name);
    const Rational det = abs(map.linear[0] * map.linear[4] * map.linear[8]);
    const double volume = nearest_double(det) * 4.1887902047863905;
    EXPECT_TRUE(c.decision.volume->lo() <= volume * (1 + 1e-12) &&
                volume * (1 - 1e-12) <= c.decision.volume->hi())
        << name;
    EXPECT_LE(c.decision.volume->hi(), c.decision.volume->lo() * 1.01) << name;
  }
  const PatchDecision beyond =
      certified_patches(affine_image(patch_shapes::sphere(), diagonal(1, 1, 1, p2(70))).value())
          .decision;
  ASSERT_TRUE(beyond.open);
  EXPECT_EQ(beyond.open->code, open_code::kOutOfRange);
  EXPECT_EQ(beyond.open->message.find(kOutOfRangeText), 0u) << beyond.open->message;
}

TEST(Frames, TinyPartsBesideLargeOnes) {
  const Patches box = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  const Rational third = Rational(1) / Rational(3);
  const CertifiedPatches c = certified_patches(patch_shapes::joined(
      {box, patch_shapes::placed(patch_shapes::sphere(), Rational::power_of_two(-40),
                                 {third, third, 2})}));
  ASSERT_TRUE(c.decision.is_valid) << c.decision.open->message;
  EXPECT_EQ(c.decision.bodies, 2u);
  expect_accepted(c, "a ball of 2^-40");
}

// A shell of one triangle, all of whose corners are one point, has no length, and no multiple of a power of two in it.
TEST(Frames, ShellsThatArePointsAreRefutedByTwoOfTheirPoints) {
  Patch::Triangle point(1, 3, false);
  for (int k = 0; k < 3; ++k)
    for (Rational& x : point.component(k)) x = Rational(1) / Rational(3);
  Patches patches = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  patches.push_back(make_patch(point).value());
  const PatchDecision d = certified_patches(patches).decision;
  ASSERT_TRUE(d.refutation);
  EXPECT_EQ(std::get<MeetingWitness>(*d.refutation).places[0].patch, 6u);
}

// Law: a contact is found at once, and proved where a common point has simple parameters; otherwise its place, its
// distance and its angle are reported.
TEST(Contacts, AreFoundAtTheirPlace) {
  for (const patch_shapes::Shape& shape : patch_shapes::broken_shapes()) {
    if (shape.truth != patch_shapes::Truth::kTouching) continue;
    SCOPED_TRACE(shape.name);
    const PatchComplex complex = complex_of(shape.patches);
    std::optional<PieceForest> forest;
    const PatchDecision d = decide_patches(complex, {}, &forest);
    EXPECT_FALSE(d.is_valid);
    EXPECT_LT(d.boxes_tried, 2000u);
    EXPECT_TRUE(!d.open || d.open->place.box);
    if (shape.name == "lid-touching-in-an-irrational-line") {
      ASSERT_TRUE(d.open);
      const std::array<double, 3> m = approx_centre(*d.open->place.box);
      EXPECT_NEAR(m[0], std::sqrt(0.5), 1e-3);
      EXPECT_NEAR(m[2], 1, 1e-3);
      EXPECT_NE(d.open->message.find("two sheets run approximately"), std::string::npos);
      EXPECT_NE(d.open->message.find("180 degrees"), std::string::npos);
      continue;
    }
    if (d.open) continue;
    ASSERT_TRUE(d.refutation && std::holds_alternative<MeetingWitness>(*d.refutation));
    const PatchPoint p = point_of(complex, std::get<MeetingWitness>(*d.refutation));
    const std::map<std::string, PatchPoint> known = {
        {"spheres-touching", {1, 0, 0}},
        {"thin-shell-touching", {1, 0, 0}},
        {"octant-spheres-touching-at-poles", {0, 0, 1}},
        {"torus-touching-itself", {0, 0, 0}},
        {"boxes-touching-in-a-vertex", {1, 1, 1}}};
    const auto at = known.find(shape.name);
    EXPECT_TRUE(at == known.end() || p == at->second);
  }
}

// A gap is no contact: 2^-10 between spheres, 2^-6 at a pole, 2^-18 between corners.
TEST(Contacts, SmallGapsAreCertified) {
  const Patches ball = patch_shapes::sphere(), box = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  const Rational g = Rational::power_of_two(-10), f = Rational::power_of_two(-6),
                 h = Rational(1) + Rational::power_of_two(-18);
  for (const Patches& patches :
       {patch_shapes::joined({ball, patch_shapes::placed(ball, 1, {Rational(2) + g, 0, 0})}),
        // Poles: 2^level slivers meet there, so that pieces are taken as large as S1 allows.
        patch_shapes::torus(1, Rational(1) - f),
        patch_shapes::joined({box, patch_shapes::placed(box, 1, {h, h, h})})}) {
    const PatchComplex complex = complex_of(patches);
    std::optional<PieceForest> forest;
    EXPECT_TRUE(decide_patches(complex, {}, &forest).is_valid);
  }
}

// Boxes along flat sheets are cut back to the gap, not made as small as it: two boxes face to face, side by side, one inside of the other.
TEST(CutBoxes, AreAsThinAsAGapAndAsLongAsItsSheets) {
  const Patches box = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  const Rational quarter = Rational(1) / Rational(4);
  for (const int k : {7, 20, 40}) {
    const Rational gap = Rational::power_of_two(-k), far = Rational(1) + gap,
                   in = Rational(1) - gap;
    const Patches models[] = {
        patch_shapes::joined(
            {box, patch_shapes::box({quarter, quarter, far}, {quarter * 3, quarter * 3, 2})}),
        patch_shapes::joined({box, patch_shapes::box({1, far, 0}, {2, 2, 1})}),
        patch_shapes::joined(
            {box, patch_shapes::reversed(patch_shapes::box({gap, gap, gap}, {in, in, in}))})};
    for (const Patches& model : models) {
      SCOPED_TRACE("2^-" + std::to_string(k) + ", model " + std::to_string(&model - models));
      const CertifiedPatches c = certified_patches(model);
      ASSERT_TRUE(c.decision.is_valid) << c.decision.open->message;
      EXPECT_LE(c.decision.cover.boxes.size(), 96u);
      expect_accepted(c, "a thin gap");
    }
  }
}

// Where boxes are thin along one axis their grid is coarse along the thin walls of others: the nearest point may lie on a sheet.
TEST(CutBoxes, HaveCentresBetweenWallsOfOtherThicknesses) {
  const auto ratio = [](int p, int q) { return Rational(p) / Rational(q); };
  const Rational w = Rational::power_of_two(-8);
  for (const int k : {10, 22, 34}) {
    const Rational g = Rational::power_of_two(-k);
    const CertifiedPatches c = certified_patches(patch_shapes::joined(
        {patch_shapes::box({0, -2, 0}, {1, -1, 3}),
         patch_shapes::box({1, 0, ratio(1, 3)}, {ratio(11, 3), w, ratio(7, 4)}),
         patch_shapes::reversed(
             patch_shapes::box({ratio(65, 64), w * ratio(3, 4), ratio(1, 2)},
                               {ratio(161, 48), w * ratio(99, 100), ratio(7, 4) - g}))}));
    ASSERT_TRUE(c.decision.is_valid) << "2^-" << k << ": " << c.decision.open->message;
    EXPECT_LE(c.decision.boxes_tried, 4000u);
    expect_accepted(c, "walls of different thickness");
  }
}

// Far away, units as short as a gap would take more bits than certificates have.
TEST(CutBoxes, StayWithinTheBitsOfCertificates) {
  const auto pair = [](int gap) {
    const Rational one = 1, far = one + Rational::power_of_two(-gap);
    return patch_shapes::placed(
        patch_shapes::joined({patch_shapes::box({0, 0, 0}, {1, 1, 1}),
                              patch_shapes::box({0, 0, far}, {1, 1, far + one})}),
        1, {Rational::power_of_two(40), 0, 0});
  };
  const CertifiedPatches wide = certified_patches(pair(8));
  ASSERT_TRUE(wide.decision.is_valid) << wide.decision.open->message;
  expect_accepted(wide, "2^-8 apart, 2^40 away");
  const PatchDecision narrow = certified_patches(pair(30)).decision;
  ASSERT_TRUE(narrow.open);
  EXPECT_EQ(narrow.open->code, open_code::kOutOfRange);
  EXPECT_EQ(narrow.open->message.find("no point pair sees all patches near this piece"), 0u)
      << narrow.open->message;
  EXPECT_NE(narrow.open->message.find("would have over 60 bits"), std::string::npos);
  EXPECT_TRUE(narrow.open->place.box);
  EXPECT_LT(narrow.boxes_tried, 1000u);
}

TEST(ShellsToTurn, MakeEveryNestingASolid) {
  const auto ball = [](int radius) {
    return patch_shapes::placed(patch_shapes::sphere(), radius, {0, 0, 0});
  };
  const auto in = [](const Patches& p) { return patch_shapes::reversed(p); };
  const std::vector<std::pair<Patches, std::vector<std::uint32_t>>> cases = {
      {ball(1), {}},
      {in(ball(1)), {0}},
      {patch_shapes::joined({ball(3), ball(2)}), {1}},
      {patch_shapes::joined({ball(1), ball(3), ball(2)}), {2}},
      {patch_shapes::joined({in(ball(3)), ball(2), in(ball(1))}), {0, 1, 2}},
      {patch_shapes::joined({in(ball(3)), in(ball(2))}), {0}}};
  for (const auto& [patches, expected] : cases) {
    const PatchComplex complex = complex_of(patches);
    PieceForest forest = PieceForest::make(complex).value();
    const ShellWalks walks = find_shell_walks(forest, find_star_cover(forest, {}));
    EXPECT_EQ(shells_to_reverse(walks), expected);
    Patches changed(complex.patches().begin(), complex.patches().end());
    for (std::uint32_t p = 0; p < changed.size(); ++p)
      if (std::binary_search(expected.begin(), expected.end(), complex.shell(p)))
        changed[p] = reversed(changed[p]);
    EXPECT_TRUE(certified_patches(changed).decision.is_valid);
  }
}

}  // namespace
}  // namespace veritope
