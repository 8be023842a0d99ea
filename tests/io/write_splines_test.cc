// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/write_splines.h"

#include "io/base/exact_number.h"
#include "tests/io/spline_test_util.h"

namespace veritope {
namespace {

using io_test::model_of;
using io_test::read_splines;
using io_test::sample;

const char* const kSamples[] = {"groups.itd",     "trimmed.itd",  "objects.g2",
                                "two_cubes.mesh", "patches.mesh", "surface.xml"};

TEST(WriteSplines, JsonHoldsEverySampleBitForBit) {
  std::vector<std::string> names(std::begin(kSamples), std::end(kSamples));
  names.push_back("triangles.vjson");
  for (const std::string& name : names) {
    const SplineModel model = sample(name).model;
    const std::string json = spline_json_bytes(model);
    const SplineModel back = model_of(SplineFormat::kJson, json);
    EXPECT_TRUE(back == model) << name;
    EXPECT_EQ(spline_json_bytes(back), json) << name;
  }
}

TEST(WriteSplines, ItdHoldsEverySampleWithNamesAndAttributes) {
  for (const char* name : kSamples) {
    const SplineModel model = sample(name).model;
    const std::string itd = itd_bytes(model);
    EXPECT_TRUE(model_of(SplineFormat::kItd, itd) == model) << name << "\n" << itd;
    EXPECT_TRUE(spline_loss(model, SplineFormat::kItd, itd).shapes.empty());
  }
}

TEST(WriteSplines, G2HoldsSplinesAndTrimmedSurfaces) {
  for (const char* name : {"objects.g2", "surface.xml", "two_cubes.mesh"}) {
    const SplineModel model = sample(name).model;
    const SplineModel back = model_of(SplineFormat::kG2, g2_bytes(model));
    ASSERT_EQ(back.entities.size(), model.entities.size()) << name;
    for (std::size_t i = 0; i < back.entities.size(); ++i)
      EXPECT_TRUE(back.entities[i].shape == model.entities[i].shape) << name << " " << i;
  }
}

TEST(WriteSplines, WhatAFormatCannotHoldIsALoss) {
  const auto loss = [](const SplineModel& model, SplineFormat format) {
    return spline_loss(model, format, spline_bytes(model, format));
  };
  // Models and periodic axes are unknown to g2.
  EXPECT_FALSE(loss(sample("trimmed.itd").model, SplineFormat::kG2).shapes.empty());
  EXPECT_FALSE(loss(sample("groups.itd").model, SplineFormat::kG2).shapes.empty());
  EXPECT_FALSE(loss(sample("surface.xml").model, SplineFormat::kG2).dropped.empty());
  EXPECT_TRUE(loss(sample("surface.xml").model, SplineFormat::kG2).shapes.empty());
  // Bezier triangles are unknown to both; what is around them is written.
  SplineModel mixed = sample("triangles.vjson").model;
  for (const SplineFormat format : {SplineFormat::kItd, SplineFormat::kG2}) {
    EXPECT_TRUE(loss(mixed, format).unreadable);  // nothing is left
    EXPECT_TRUE(loss(mixed, SplineFormat::kJson).shapes.empty());
  }
  const SplineModel objects = sample("objects.g2").model;
  mixed.entities.insert(mixed.entities.begin() + 1, objects.entities.begin(),
                        objects.entities.end());
  for (const SplineFormat format : {SplineFormat::kItd, SplineFormat::kG2}) {
    const SplineModel back = model_of(format, spline_bytes(mixed, format));
    ASSERT_EQ(back.entities.size(), objects.entities.size());
    for (std::size_t i = 0; i < back.entities.size(); ++i)
      EXPECT_TRUE(back.entities[i].shape == objects.entities[i].shape) << i;
    const auto found = loss(mixed, format);
    EXPECT_FALSE(found.unreadable);
    ASSERT_EQ(found.shapes.size(), 1u);
    EXPECT_EQ(found.shapes[0], "4 of " + std::to_string(mixed.entities.size()) +
                                   " entities are rounded or left out");
  }
  // A third is not a decimal: it is rounded to the nearest binary64 number.
  SplineModel third = model_of(SplineFormat::kItd, "[CURVE BEZIER 2 E1 [0] [3]]");
  std::get<ExactCurve>(third.entities[0].shape).component(0)[1] = Rational(Integer(1), Integer(3));
  EXPECT_TRUE(loss(third, SplineFormat::kJson).shapes.empty());
  EXPECT_FALSE(loss(third, SplineFormat::kItd).shapes.empty());
  const SplineModel rounded = model_of(SplineFormat::kItd, itd_bytes(third));
  EXPECT_EQ(nearest_double(std::get<ExactCurve>(rounded.entities[0].shape).component(0)[1]),
            1.0 / 3);
}

TEST(WriteSplines, RoundingThatLeavesNoSplineIsReported) {
  // Two knots a hair apart become one knot too many.
  const Rational third(Integer(1), Integer(3)), close = third + Rational::power_of_two(-200);
  const SplineModel model{
      {},
      {{ExactCurve({KnotAxis<Rational>{1,
                                       {Rational(0), Rational(0), third, third, close, close,
                                        Rational(1), Rational(1)}}},
                   1, false, std::vector<Rational>(6)),
        {},
        {},
        {}}}};
  EXPECT_TRUE(model_of(SplineFormat::kJson, spline_json_bytes(model)) == model);
  const SplineLoss loss = spline_loss(model, SplineFormat::kItd, itd_bytes(model));
  ASSERT_TRUE(loss.unreadable);
  EXPECT_EQ(loss.unreadable->code, Code::kBadSpline);
}

TEST(WriteSplines, NumbersBeyondBinary64AreCutToSeventeenDigits) {
  Rational huge = Rational::power_of_two(5000) / Rational(3),
           tiny = Rational(1) / (Rational::power_of_two(5000) * Rational(3));
  for (const Rational& value : {huge, tiny, -huge}) {
    Rational back;
    ReadLimits limits;
    ASSERT_EQ(read_exact_decimal(decimal_or_nearest(value), limits, back), DecimalFault::kNone)
        << decimal_or_nearest(value);
    EXPECT_LT(abs(back - value), abs(value) * Rational::power_of_two(-55));
  }
}

TEST(WriteSplines, TextThatItdCannotHoldIsDropped) {
  EXPECT_TRUE(is_itd_name("A_1"));
  for (const char* bad : {"", "a b", "a[", "\"a\""}) EXPECT_FALSE(is_itd_name(bad)) << bad;
  EXPECT_TRUE(is_itd_attribute("rgb \"1,2,3\""));
  EXPECT_TRUE(is_itd_attribute("a [b [c] \"]\"]"));
  for (const char* bad :
       {"", " a", "a ", "a ]", "a [", "a \"", "CURVE", "NUMBER 4", "KV 0 1", "[a]", "]a["})
    EXPECT_FALSE(is_itd_attribute(bad)) << bad;
  const SplineModel model{
      {{"two words", {"]"}, {}}},
      {{ExactCurve({KnotAxis<Rational>{1, {Rational(0), Rational(0), Rational(1), Rational(1)}}}, 1,
                   false, std::vector<Rational>(2)),
        {"CURVE"},
        0,
        {}}}};
  const SplineLoss loss = spline_loss(model, SplineFormat::kItd, itd_bytes(model));
  EXPECT_TRUE(loss.shapes.empty());
  EXPECT_FALSE(loss.dropped.empty());
}

TEST(WriteSplines, JsonReadsOtherSpellingsOfTheSameNumbers) {
  const char* const text =
      "{\"format\": \"veritope-spline-1\", \"groups\": [], \"entities\": [{\"attributes\": "
      "[\"\\u00e9\\t\"], \"group\": null, \"kind\": "
      "\"curve\", \"shape\": {\"points\": [[\"0.5\"], [\"0x1p-1\"]], \"components\": 1, "
      "\"rational\": false, \"knots\": [[\"0\", \"0/7\", "
      "\"1\", \"10e-1\"]], \"periodic\": [false], \"degrees\": [1]}}]}";
  const SplineModel model = model_of(SplineFormat::kJson, text);
  const auto& s = std::get<ExactCurve>(model.entities[0].shape);
  EXPECT_EQ(s.component(0)[0], s.component(0)[1]);
  EXPECT_EQ(model.entities[0].attributes[0], "\xc3\xa9\t");
  EXPECT_NE(spline_json_bytes(model).find("[\"1/2\"]"), std::string::npos);
}

TEST(WriteSplines, JsonOfExtremeDecimalsIsWithinTheUsualLimits) {
  const SplineModel model =
      model_of(SplineFormat::kItd, "[CURVE BEZIER 2 E2 [1e-4000 1e4000] [1.5e-4000 -7e4000]]");
  EXPECT_TRUE(model_of(SplineFormat::kJson, spline_json_bytes(model)) == model);
  EXPECT_TRUE(model_of(SplineFormat::kItd, itd_bytes(model)) == model);
}

TEST(WriteSplines, NoWriterMovesAnExponentOverTheLimit) {
  const SplineModel model =
      model_of(SplineFormat::kItd, "[CURVE BEZIER 2 E2 [1.5e-4096 123e4096] [1 0.1e-4095]]");
  for (const SplineFormat format : {SplineFormat::kItd, SplineFormat::kG2, SplineFormat::kJson}) {
    const std::string bytes = spline_bytes(model, format);
    EXPECT_TRUE(model_of(format, bytes) == model) << bytes;
    EXPECT_TRUE(spline_loss(model, format, bytes).shapes.empty());
  }
}

TEST(WriteSplines, NumbersOfMoreDigitsThanTheReaderTakesAreALoss) {
  SplineModel model = model_of(SplineFormat::kItd, "[CURVE BEZIER 2 E1 [0] [3]]");
  auto& x = std::get<ExactCurve>(model.entities[0].shape).component(0)[1];
  x = Rational::power_of_two(-4000);  // 2796 decimal digits
  const std::string rounded = itd_bytes(model);
  EXPECT_TRUE(read_splines(SplineFormat::kItd, rounded)) << rounded;
  EXPECT_FALSE(spline_loss(model, SplineFormat::kItd, rounded).shapes.empty());
  ReadLimits wide;
  wide.max_digits = 3000;
  const std::string exact = itd_bytes(model, wide);
  EXPECT_TRUE(spline_loss(model, SplineFormat::kItd, exact, wide).shapes.empty());
  // Over the limits of our own format: not to be written.
  x = Rational::power_of_two(-20000);
  EXPECT_TRUE(spline_loss(model, SplineFormat::kJson, spline_json_bytes(model)).unreadable);
  EXPECT_FALSE(
      spline_loss(model, SplineFormat::kJson, spline_json_bytes(model), {.max_digits = 9000})
          .unreadable);
}

TEST(WriteSplines, FormatsThatAreOnlyReadAreNotWritten) {
  EXPECT_FALSE(can_write(SplineFormat::kMfem));
  EXPECT_FALSE(can_write(SplineFormat::kGismo));
  EXPECT_THROW(spline_bytes({}, SplineFormat::kMfem), InternalError);
}

}  // namespace
}  // namespace veritope
