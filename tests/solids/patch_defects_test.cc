// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "models/patch_shapes.h"
#include "solids/patches/patch_complex.h"
#include "solids/patches/patch_sources.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

TEST(PatchDefects, AMissingPatchLeavesItsNeighboursOpen) {
  Patches box = unit_box();
  box.pop_back();
  const PatchComplex complex = complex_of(box);
  EXPECT_FALSE(complex.is_closed_oriented_surface());
  EXPECT_EQ(complex.count(PatchDefect::kOpenSide), 4u);
  EXPECT_EQ(complex.findings().size(), 4u);
  EXPECT_FALSE(complex.shells()[0].genus().has_value());
  EXPECT_EQ(describe(complex, complex.findings()[0]),
            "open-side: patch 0, side 1, from (0, 0, 1) to (0, 1, 1): occurs once")
      << all_findings(complex);
}
TEST(PatchDefects, ASideOfThreePatchesIsNamedWithAllOfThem) {
  Patches box = unit_box();
  box.push_back(bilinear({{{0, 0, 1}, {1, 0, 1}, {1, -1, 2}, {0, -1, 2}}}));
  const PatchComplex complex = complex_of(box);
  EXPECT_EQ(complex.count(PatchDefect::kOverusedSide), 1u);
  EXPECT_EQ(complex.count(PatchDefect::kOpenSide), 3u);
  const auto& findings = complex.findings();
  const auto overused = std::find_if(findings.begin(), findings.end(), [](const PatchFinding& f) {
    return f.defect == PatchDefect::kOverusedSide;
  });
  ASSERT_NE(overused, findings.end());
  EXPECT_EQ(overused->sides.size(), 3u);
  EXPECT_NE(describe(complex, *overused).find("occurs 3 times"), std::string::npos);
}
TEST(PatchDefects, AFlippedPatchIsNamedAndFlippedBackOnRequest) {
  Patches box = unit_box();
  box[3] = reversed(box[3]);
  const PatchComplex kept = complex_of(box);
  EXPECT_EQ(kept.count(PatchDefect::kDirection), 4u);
  EXPECT_FALSE(kept.is_closed_oriented_surface());
  const PatchComplex repaired = complex_of(box, PatchOrientation::kAuto);
  EXPECT_TRUE(repaired.is_closed_oriented_surface()) << all_findings(repaired);
  ASSERT_EQ(repaired.reversed().size(), 1u);
  EXPECT_EQ(repaired.reversed()[0], 3u);
  EXPECT_EQ(repaired.patch(3), unit_box()[3]);
}
// A ring of three quadrangles with half a twist, each side of the ring the other's continuation.
TEST(PatchDefects, AMoebiusStripIsOneSided) {
  const PatchPoint a{0, 0, 0}, b{0, 0, 1}, c{2, 0, 0}, d{2, 0, 1}, e{1, 2, 0}, f{1, 2, 1};
  const Patches strip{bilinear({a, c, d, b}), bilinear({c, e, f, d}), bilinear({e, b, a, f})};
  for (const auto orientation : {PatchOrientation::kKeep, PatchOrientation::kAuto}) {
    const PatchComplex complex = complex_of(strip, orientation);
    EXPECT_EQ(complex.count(PatchDefect::kOneSided), 1u) << all_findings(complex);
    EXPECT_EQ(complex.count(PatchDefect::kDirection), 1u);
    EXPECT_EQ(complex.count(PatchDefect::kOpenSide), 6u);
    EXPECT_TRUE(complex.reversed().empty());
  }
}
TEST(PatchDefects, SidesThatDifferByOneUlpAreSaidTo) {
  Patches box = unit_box();
  const double up = std::nextafter(1.0, 2.0);
  for (Patch& patch : box) patch = make_patch(elevate_to(patch.tensor(), {2, 2})).value();
  // Control point (1, 0): the middle of side 0; its ends stay.
  const Rational z = box[5].tensor().component(2)[3];
  ASSERT_EQ(z, Rational(1));
  box[5] = with_coefficient(box[5], 2, 3, Rational::from_double(up));
  const PatchComplex complex = complex_of(box);
  EXPECT_EQ(complex.count(PatchDefect::kOpenSide), 2u);
  ASSERT_EQ(complex.count(PatchDefect::kNearMiss), 1u);
  const PatchFinding& near = complex.findings()[2];
  EXPECT_EQ(near.defect, PatchDefect::kNearMiss);
  EXPECT_TRUE(near.is_one_ulp);
  EXPECT_EQ(near.distance, 0x1p-52);
  EXPECT_NE(describe(complex, near).find("differ by one ulp: 2.220446049250313e-16"),
            std::string::npos);
}
TEST(PatchDefects, SidesWithCommonEndsThatDifferAreSaidByHowMuch) {
  Patches box = unit_box();
  for (Patch& patch : box) patch = make_patch(elevate_to(patch.tensor(), {2, 2})).value();
  box[5] = with_coefficient(box[5], 2, 3, Rational(9) / 8);
  const PatchComplex complex = complex_of(box);
  ASSERT_EQ(complex.count(PatchDefect::kNearMiss), 1u);
  EXPECT_FALSE(complex.findings()[2].is_one_ulp);
  EXPECT_EQ(complex.findings()[2].distance, 0.125);
}
// A corner moved by one ulp: both its sides miss their neighbours.
TEST(PatchDefects, ACornerOffByOneUlpIsSaidToBe) {
  Patches box = unit_box();
  box[5] = with_coefficient(box[5], 2, 0, Rational::from_double(std::nextafter(1.0, 0.0)));
  const PatchComplex complex = complex_of(box);
  EXPECT_EQ(complex.count(PatchDefect::kOpenSide), 4u);
  EXPECT_EQ(complex.count(PatchDefect::kNearMiss), 2u);
  for (const PatchFinding& f : complex.findings())
    EXPECT_TRUE(f.defect == PatchDefect::kOpenSide || f.is_one_ulp) << describe(complex, f);
}
TEST(PatchDefects, APatchTwiceIsNamedWhateverItsCornersAndDegrees) {
  Patches box = unit_box();
  box.push_back(turned(make_patch(elevate_to(box[4].tensor(), {2, 3})).value(), 3));
  const PatchComplex complex = complex_of(box);
  ASSERT_EQ(complex.count(PatchDefect::kRepeatedPatch), 1u);
  const PatchFinding& f = complex.findings().back();
  EXPECT_EQ(f.sides, (std::vector<PatchSide>{{4, 0}, {6, 0}}));
  EXPECT_FALSE(f.has_other_normal);
  EXPECT_EQ(complex.count(PatchDefect::kOverusedSide), 4u);
}
// S0 holds, and chi is 2: only this rule names it.
TEST(PatchDefects, APillowIsAPatchTwice) {
  const Patch top = flat({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const PatchComplex complex = complex_of({top, turned(reversed(top), 1)});
  EXPECT_EQ(complex.euler(), 2);
  ASSERT_EQ(complex.findings().size(), 1u) << all_findings(complex);
  EXPECT_EQ(complex.findings()[0].defect, PatchDefect::kRepeatedPatch);
  EXPECT_TRUE(complex.findings()[0].has_other_normal);
  EXPECT_FALSE(complex.is_closed_oriented_surface());
}
TEST(PatchDefects, AWeightThatIsNotPositiveIsNamed) {
  for (const int weight : {0, -1}) {
    Patches ball = patch_shapes::octant_sphere();
    // Control point (1, 1), in the middle of the patch: no side knows it.
    Patch::Tensor map = ball[2].tensor();
    map.component(3)[4] = weight;
    ball[2] = make_patch(std::move(map), ball[2].origin()).value();
    const PatchComplex complex = complex_of(ball);
    ASSERT_EQ(complex.findings().size(), 1u) << all_findings(complex);
    EXPECT_EQ(describe(complex, complex.findings()[0]),
              "weight: patch 2: the weight of control point 4 is " + std::to_string(weight) +
                  ", not positive");
    EXPECT_FALSE(complex.is_closed_oriented_surface());
  }
}
TEST(PatchDefects, ADegreeOverTheCapIsNamed) {
  const auto box_with = [](int degree) {
    Patches box = unit_box();
    box[1] = make_patch(elevate_to(box[1].tensor(), {degree, 2}), box[1].origin()).value();
    return complex_of(box);
  };
  EXPECT_TRUE(box_with(kMaxPatchDegree).is_closed_oriented_surface());
  const PatchComplex complex = box_with(kMaxPatchDegree + 1);
  ASSERT_EQ(complex.findings().size(), 1u) << all_findings(complex);
  EXPECT_EQ(describe(complex, complex.findings()[0]),
            "degree: patch 1: degree 16; at most 15 can be certified");
}
TEST(PatchDefects, FacetsThatAreNotFiniteAreNamedAndLeftOut) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_TRUE(make_patch_complex(patches_of(mesh).value()).value().is_closed_oriented_surface());
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    mesh.positions[3].z = bad;
    const PatchComplex complex = make_patch_complex(patches_of(mesh).value()).value();
    EXPECT_EQ(complex.count(PatchDefect::kNotFinite), 3u);
    EXPECT_EQ(describe(complex, complex.findings().back()),
              "not-finite: facet 3: a coordinate is not finite");
    EXPECT_FALSE(complex.is_closed_oriented_surface());
  }
}
// Biquadratic patches whose sides 0 and 1 are the origin: legal, but told.
TEST(PatchDefects, AdjacentPolesAreToldAndNoDefectOfTheSurface) {
  const auto leaf = [](const PatchPoint& middle) {
    Patch::Tensor map({2, 2}, 3, false);
    const Rational half = Rational(1) / 2;
    const auto set = [&](std::size_t at, const PatchPoint& p) {
      for (std::size_t c = 0; c < 3; ++c) map.component(static_cast<int>(c))[at] = p[c];
    };
    set(1, {half, half, 0}), set(2, {1, 0, 0}), set(5, {half, -half, 0}), set(4, middle);
    return make_patch(std::move(map)).value();
  };
  const PatchComplex complex = complex_of({leaf({1, 0, 0}), reversed(leaf({1, 0, 1}))});
  EXPECT_EQ(complex.count(PatchDefect::kAdjacentPoles), 2u) << all_findings(complex);
  EXPECT_TRUE(complex.is_closed_oriented_surface()) << all_findings(complex);
  EXPECT_EQ(complex.num_vertices(), 2u);
  EXPECT_EQ(complex.euler(), 2);
}
TEST(PatchDefects, ListsAreCutAndCountsAreNot) {
  Patches many;
  for (int i = 0; i < 20; ++i) many.push_back(flat({i, 0, 0}, {i, 1, 0}, {i, 0, 1}));
  const PatchComplex complex = make_patch_complex(many, PatchOrientation::kKeep, 7).value();
  EXPECT_EQ(complex.count(PatchDefect::kOpenSide), 60u);
  EXPECT_EQ(complex.findings().size(), 7u);
}

TEST(PatchErrors, ThereMustBeAPatch) {
  EXPECT_EQ(make_patch_complex(Patches{}).error().code, Code::kEmpty);
}
TEST(PatchErrors, AMapThatIsNoPatchIsRefused) {
  EXPECT_EQ(make_patch(Patch::Tensor({1, 1}, 2, false)).error().code, Code::kBadArgument);
  EXPECT_EQ(make_patch(Patch::Tensor({1, 1}, 3, true)).error().code, Code::kBadArgument);
  EXPECT_EQ(make_patch(Patch::Tensor({0, 1}, 3, false)).error().code, Code::kBadArgument);
  EXPECT_EQ(make_patch(Patch::Triangle(0, 3, false)).error().code, Code::kBadArgument);
  EXPECT_EQ(make_patch(Patch::Tensor({1, 64}, 3, false)).error().code, Code::kOverLimit);
  EXPECT_EQ(make_patch(Patch::Triangle(64, 3, false)).error().code, Code::kOverLimit);
}
// Nothing but zeros, weights too: no crash, and nothing is certified.
TEST(PatchErrors, NoughtsAreNoSurface) {
  const PatchComplex complex = complex_of({make_patch(Patch::Tensor({2, 2}, 4, true)).value(),
                                           make_patch(Patch::Triangle(3, 4, true)).value()});
  EXPECT_EQ(complex.count(PatchDefect::kWeight), 2u);
  EXPECT_FALSE(complex.is_closed_oriented_surface());
  for (const PatchFinding& f : complex.findings()) EXPECT_FALSE(describe(complex, f).empty());
}

}  // namespace
}  // namespace veritope
