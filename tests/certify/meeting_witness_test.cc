// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/meeting_witness.h"

#include <gtest/gtest.h>

#include "io/read_model.h"
#include "io/splines/patch_model.h"
#include "io/splines/write_splines.h"
#include "models/patch_shapes.h"
#include "solids/patches/patch_transform.h"
#include "tests/solids/patch_support.h"
#include "tests/support/checker_call.h"
#include "verify/certify/certify.h"

namespace veritope {
namespace {

using Cause = MeetingWitness::Cause;

Rational ratio(int n, int d) { return Rational(n) / Rational(d); }

std::optional<MeetingWitness> found_in(Patches patches) {
  return find_meeting(complex_of(std::move(patches)));
}

// A saddle whose four corners differ, and a curved triangle without symmetry.
Patch saddle() { return bilinear({{{0, 0, 0}, {1, 0, 1}, {2, 3, 0}, {0, 1, 5}}}); }
Patch bump() {
  Patch::Triangle map(2, 3, false);
  const int net[3][6] = {{0, 2, 5, 1, 3, 0}, {0, 0, 1, 2, 3, 5}, {0, 1, 0, 1, 2, 0}};
  for (int c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < 6; ++i) map.component(c)[i] = Rational(net[c][i]);
  return make_patch(std::move(map)).value();
}
// The line u = 1/3 is one point, since the image consists of segments from p to -2 p.
Patch hourglass_side() { return bilinear({{{1, 0, 1}, {-2, 0, -2}, {0, -2, -2}, {0, 1, 1}}}); }
// The line on which barycentric coordinate `axis` is 1/2 is one point.
Patch pinched_triangle(std::size_t axis) {
  return turned(veritope::pinched_triangle(), static_cast<std::uint32_t>((3 - axis) % 3));
}

// The unit box, and a skew box that stands on it at `at`, with a corner.
Patches on_its_corner(const PatchPoint& at) {
  const AffineMap map{3, 3, {1, 1, -2, 1, -2, 1, 1, 1, 1}, {at[0], at[1], at[2]}};
  return patch_shapes::joined({unit_box(), affine_image(unit_box(), map).value()});
}

std::string bytes_of(const Patches& patches) { return spline_json_bytes(model_of(patches)); }
Certified certified(const std::string& file, PatchOrientation orientation) {
  CertifyOptions options;
  options.orientation = orientation;
  const auto model = read_model_bytes(
      {reinterpret_cast<const unsigned char*>(file.data()), file.size()}, "model.vjson", {});
  return certify(model.value(), options).value();
}

TEST(MeetingWitness, OfAPatchThatOccursTwiceNamesTheMiddlesWhateverTheOrder) {
  for (const Patch& once : {saddle(), bump()})
    for (std::uint32_t by = 0; by < once.num_sides(); ++by)
      for (const bool is_back : {false, true}) {
        const Patch again = is_back ? turned(reversed(once), by) : turned(once, by);
        const auto w = found_in({once, again});
        ASSERT_TRUE(w) << by << is_back;
        EXPECT_EQ(w->cause, Cause::kRepeatedPatch);
        EXPECT_EQ(w->places[0].patch, 0u);
        EXPECT_EQ(w->places[1].patch, 1u);
        const std::array middle{once.is_triangle() ? ratio(2, 3) : ratio(1, 2), ratio(1, 2)};
        EXPECT_EQ(w->places[0].at, middle);
        EXPECT_EQ(w->places[1].at, middle);
        EXPECT_EQ(broken_condition(complex_of({once, again}), *w), std::nullopt);
      }
}

TEST(MeetingWitness, OfPointsAndCurvesNamesTwoPointsOfALine) {
  const PatchPoint p{1, 2, 3}, q{4, 4, 4};
  for (const Patch& patch :
       {bilinear({p, p, p, p}), bilinear({p, q, q, p}), bilinear({p, p, q, q}), flat(p, p, p)}) {
    const auto w = found_in({patch});
    ASSERT_TRUE(w);
    EXPECT_EQ(w->cause, Cause::kDegeneratePatch);
    EXPECT_EQ(broken_condition(complex_of({patch}), *w), std::nullopt);
  }
  for (std::uint32_t by = 0; by < 3; ++by) {  // constant along the lines of one corner's coordinate
    const auto w = found_in({turned(flat(p, q, q), by)});
    ASSERT_TRUE(w) << by;
    EXPECT_EQ(w->cause, Cause::kDegeneratePatch);
  }
}

TEST(MeetingWitness, OfALineThatIsOnePointNamesTwoOfItsPoints) {
  for (const bool is_back : {false, true}) {
    const Patch patch = is_back ? reversed(hourglass_side()) : hourglass_side();
    const auto w = found_in({patch});
    ASSERT_TRUE(w);
    EXPECT_EQ(w->cause, Cause::kSingularLine);
    EXPECT_EQ(w->places[0].at[is_back ? 1 : 0], ratio(1, 3));
    EXPECT_EQ(point_of(complex_of({patch}), *w), (PatchPoint{0, 0, 0}));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto w = found_in({pinched_triangle(axis)});
    ASSERT_TRUE(w) << axis;
    EXPECT_EQ(w->cause, Cause::kSingularLine);
    EXPECT_EQ(broken_condition(complex_of({pinched_triangle(axis)}), *w), std::nullopt);
  }
}

TEST(MeetingWitness, IsNotFoundWhereNoSimpleParametersHaveOneImage) {
  // The image of u + 2 v is a segment; lines of parameters are mapped one to one.
  EXPECT_FALSE(found_in({bilinear({{{0, 0, 0}, {1, 1, 0}, {3, 3, 0}, {2, 2, 0}}})}));
  // All of a line is one point where 2 u^2 = 1.
  Patch::Tensor map({2, 1}, 3, false);
  for (std::size_t j = 0; j < 2; ++j) {
    const Rational x(static_cast<int>(j) + 1), y(static_cast<int>(j));
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational f(i == 2 ? 1 : -1);  // 2 u^2 - 1
      map.component(0)[2 * i + j] = f * x;
      map.component(1)[2 * i + j] = f * y;
    }
  }
  EXPECT_FALSE(found_in({make_patch(std::move(map)).value()}));
}

TEST(MeetingWitness, IsNotFoundInSoundModelsAndOfWeightsThatAreNotPositive) {
  for (const patch_shapes::Shape& shape : patch_shapes::sound_shapes())
    EXPECT_FALSE(found_in(shape.patches)) << shape.name;
  const PatchPoint p{1, 2, 3};
  Patch::Tensor map({1, 1}, 4, true);
  for (std::size_t i = 0; i < 4; ++i) {
    for (int c = 0; c < 3; ++c) map.component(c)[i] = p[static_cast<std::size_t>(c)];
    map.component(3)[i] = Rational(i == 0 ? -1 : 1);
  }
  EXPECT_FALSE(found_in({bilinear({p, p, p, p}), make_patch(std::move(map)).value()}));
}

// PROVES INVALID-3
// PROVES INVALID-3.M1
// PROVES INVALID-3.M2
TEST(MeetingWitness, EachConditionIsNeeded) {
  const PatchComplex complex = complex_of({saddle(), saddle(), bump(), bump()});
  const auto broken = [&](std::uint32_t a, Rational u, Rational v, std::uint32_t b, Rational s,
                          Rational t) {
    return broken_condition(
        complex, {Cause::kRepeatedPatch,
                  {{{a, {std::move(u), std::move(v)}}, {b, {std::move(s), std::move(t)}}}}});
  };
  const Rational half = ratio(1, 2), third = ratio(1, 3), zero(0), one(1);
  EXPECT_EQ(broken(0, half, third, 1, half, third), std::nullopt);
  EXPECT_EQ(broken(0, half, third, 0, half, third), MeetingCondition::kM1) << "one point";
  for (const Rational& border : {zero, one}) {
    EXPECT_EQ(broken(0, border, third, 1, border, third), MeetingCondition::kM1) << "A on a side";
    EXPECT_EQ(broken(0, third, border, 1, third, border), MeetingCondition::kM1) << "A on a side";
  }
  EXPECT_EQ(broken(0, half, half, 1, ratio(3, 2), half), MeetingCondition::kM1) << "B is outside";
  EXPECT_EQ(broken(0, half, half, 1, half, ratio(-1, 2)), MeetingCondition::kM1) << "B is outside";
  EXPECT_EQ(broken(2, half, third, 3, half, third), std::nullopt);
  EXPECT_EQ(broken(2, half, third, 3, zero, third), MeetingCondition::kM1) << "s is 0";
  EXPECT_EQ(broken(0, half, third, 1, half, half), MeetingCondition::kM2) << "other images";
  EXPECT_EQ(broken(0, half, third, 0, third, half), MeetingCondition::kM2) << "other images";
}

// Reason (b): places on sides and corners, where the surface is closed.
TEST(MeetingWitness, OnBordersNeedsAClosedSurfaceAndTwoOfItsPoints) {
  const Patches boxes = patch_shapes::joined({unit_box(), patch_shapes::box({1, 1, 1}, {2, 2, 2})});
  const PatchComplex complex = complex_of(boxes);
  std::vector<PatchPlace> at_corner;
  for (std::uint32_t p = 0; p < 12; ++p)
    for (const Rational& s : {Rational(0), Rational(1)})
      for (const Rational& t : {Rational(0), Rational(1)})
        if (point_of(complex, PatchPlace{p, {s, t}}) == PatchPoint{1, 1, 1})
          at_corner.push_back({p, {s, t}});
  ASSERT_EQ(at_corner.size(), 6u);
  for (const PatchPlace& a : at_corner)
    for (const PatchPlace& b : at_corner) {
      const bool are_apart = (a.patch < 6) != (b.patch < 6);
      EXPECT_EQ(broken_condition(complex, {Cause::kContact, {a, b}}),
                are_apart ? std::nullopt : std::optional(MeetingCondition::kM1));
    }
  const Patches open(boxes.begin() + 1, boxes.end());
  for (PatchPlace& place : at_corner) --place.patch;
  EXPECT_EQ(broken_condition(complex_of(open), {Cause::kContact, {at_corner[2], at_corner[5]}}),
            MeetingCondition::kM1);
}

TEST(MeetingWitness, HoldsInTheParametersOfReversedPatches) {
  for (const Patch& patch : {hourglass_side(), pinched_triangle(1)}) {
    const PatchComplex complex = complex_of({patch}), back = complex_of({reversed(patch)});
    const MeetingWitness w = find_meeting(complex).value();
    const MeetingWitness r = with_reversed(complex, {true}, w);
    EXPECT_NE(w, r);
    EXPECT_EQ(broken_condition(back, r), std::nullopt);
    EXPECT_EQ(point_of(back, r), point_of(complex, w));
    EXPECT_EQ(with_reversed(back, {true}, r), w);
    EXPECT_EQ(with_reversed(complex, {false}, w), w);
  }
}

TEST(MeetingWitness, MakesACertificateThatTheCheckerAccepts) {
  const Patches box = unit_box();
  const PatchPoint corner{1, 1, 1};
  struct Case {
    const char* code;
    Patches patches;
  };
  const Case cases[] = {
      {"patches-touching", on_its_corner({1, 1, 1})},
      {"patches-touching", on_its_corner({ratio(1, 2), ratio(1, 3), 1})},
      {"patch-repeated", {saddle(), reversed(saddle())}},
      {"patch-repeated", {bump(), turned(reversed(bump()), 1)}},
      {"patch-degenerate",
       patch_shapes::joined({box, {bilinear({corner, corner, corner, corner})}})},
      {"patch-degenerate", patch_shapes::joined({box, {flat(corner, corner, corner)}})}};
  for (const Case& c : cases)
    for (const auto orientation : {PatchOrientation::kKeep, PatchOrientation::kAuto}) {
      const std::string file = bytes_of(c.patches);
      const Certified made = certified(file, orientation);
      EXPECT_EQ(made.verdict, Verdict::kInvalid);
      EXPECT_EQ(made.claim, "patch-invalid-2");
      ASSERT_EQ(made.findings.size(), 1u);
      EXPECT_EQ(made.findings[0].code, c.code);
      EXPECT_EQ(made.findings[0].place.parts.size(), 2u);
      EXPECT_TRUE(made.findings[0].witness.point.has_value());
      const std::string answer =
          check_in_process(file, std::string(made.certificate.begin(), made.certificate.end()));
      EXPECT_EQ(answer.rfind("ACCEPT patch-invalid-2", 0), 0u) << answer;
    }
}

}  // namespace
}  // namespace veritope
