// SPDX-License-Identifier: LGPL-3.0-or-later
// Files .vdms: what is read is written, canonical files come back byte for byte, and each refusal has its line.
#include "io/dms/write_dms.h"
#include "io/formats.h"
#include "solids/dms/dms_validity.h"
#include "tests/io/io_test_util.h"
#include "tests/support/dms_laws.h"
#include "tests/support/paths.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

using namespace std::string_literals;

Result<DmsFile> parse_dms(const std::string& text, const ReadLimits& limits = {}) {
  const std::string name = "model.vdms";
  const ByteBuffer buffer = copy_to_buffer(io_test::bytes(text));
  return read_dms(DmsFormat::kDms, source_of(buffer, name), limits);
}

const std::string& one_dms() {
  static const std::string text =
      io_test::slurp(test::source_dir() + "/tests/models/dms/tetrahedron.vdms");
  return text;
}

/// The text with the first `from` replaced.
std::string with_change(const std::string& from, const std::string& to,
                        std::string text = one_dms()) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

/// "ok", or "code@line: message".
std::string outcome_of(const Result<DmsFile>& file) {
  if (file) return "ok";
  const Error& e = file.error();
  return code_name(e.code) + "@"s + (e.place.line ? std::to_string(*e.place.line) : "none") + ": " +
         e.message;
}
std::string outcome_of(const std::string& from, const std::string& to) {
  return outcome_of(parse_dms(with_change(from, to)));
}

TEST(Dms, ReadsWhatTheFileHolds) {
  const auto file = parse_dms(one_dms());
  ASSERT_TRUE(file) << outcome_of(file);
  const DmsModel& m = file->model;
  EXPECT_EQ(file->bytes, one_dms().size());
  EXPECT_EQ(m.degree, 2);
  EXPECT_EQ(m.attributes, (std::vector<std::string>{"density"}));
  ASSERT_EQ(m.clouds.size(), 4u);
  EXPECT_EQ(m.clouds[0].size(), 1u);
  EXPECT_EQ(m.clouds[1], (DmsCloud{{1, 0, 0}, {Rational(9) / Rational(8), 0, 0}}));
  EXPECT_EQ(m.clouds[2].size(), 3u);
  EXPECT_EQ(m.tetrahedra, (std::vector<TetrahedronCorners>{{0, 1, 2, 3}}));
  EXPECT_FALSE(m.control.is_separate);
  EXPECT_EQ(m.num_control(), 10u);
  EXPECT_EQ(m.value(1)[3], Rational(1) / Rational(2));
  EXPECT_EQ(write_dms(m), one_dms());
}

// The canonical form of docs/formats/dms-files.md reads back as the same model and the same bytes.
TEST(Dms, CanonicalFilesComeBackByteForByte) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    DmsModel model = draw_dms(seed, 4).model;
    for (const bool is_separate : {false, true}) {
      if (is_separate) model = internal::separated(model);
      ASSERT_TRUE(validate(model)) << validate(model).error().message;
      const std::string bytes = write_dms(model);
      const auto file = parse_dms(bytes);
      ASSERT_TRUE(file) << "seed " << seed << ": " << outcome_of(file);
      EXPECT_EQ(file->model, model) << "seed " << seed;
      EXPECT_EQ(write_dms(file->model), bytes) << "seed " << seed;
    }
  }
}

TEST(Dms, TakesAnyOrderSpellingAndSpace) {
  const auto file = parse_dms(one_dms());
  // The last two control points exchanged, keys in another order, numbers in other spellings.
  std::string text = with_change(R"({"at": [2,3], "value": ["0", "1/2", "1/2", "0"]},
{"at": [3,3], "value": ["0", "0", "1", "0"]}]})",
                                 R"({"value": [ "0.0","-0" , "+1","0e5"],"at":[3, 3]}  ,
{"at": [2,3], "value": ["0", "0x1p-1", "5e-1", "0"]}] } )");
  const auto same = parse_dms(text);
  ASSERT_TRUE(same) << outcome_of(same);
  EXPECT_EQ(same->model, file->model);
}

TEST(Dms, RefusalsHaveTheirLine) {
  EXPECT_EQ(outcome_of("veritope-dms-1", "veritope-dms-2"),
            "unknown-format@1: the format must be 'veritope-dms-1', not 'veritope-dms-2'");
  EXPECT_EQ(outcome_of("\"degree\": 2", "\"degree\": 0"),
            "syntax@2: the degree must be from 1 to 9, not 0");
  EXPECT_EQ(outcome_of("\"degree\": 2", "\"degree\": 10"),
            "over-limit@2: the degree must be an integer from 1 to 9, not '10'");
  EXPECT_EQ(outcome_of("\"degree\": 2", "\"degree\": 2.0"),
            "syntax@2: the degree must be an integer from 1 to 9, not '2.0'");
  EXPECT_EQ(outcome_of("\"degree\": 2", "\"degree\": \"2\""),
            "syntax@2: the degree must be an integer from 1 to 9, not '\"'");
  EXPECT_EQ(outcome_of("\"degree\": 2,\n", ""),
            "syntax@2: the key 'degree' must come before the key 'attributes'");
  EXPECT_EQ(outcome_of("\"attributes\"", "\"colour\""), "syntax@3: unknown key 'colour'");
  EXPECT_EQ(outcome_of("\"attributes\": [\"density\"]", "\"degree\": 2"),
            "syntax@3: the key 'degree' occurs twice");
  EXPECT_EQ(outcome_of("[\"density\"]", "[\"a\", \"a\"]"),
            "syntax@3: attributes 0 and 1 have the same name");
  EXPECT_EQ(outcome_of("[\"density\"]", "[\"\"]"),
            "syntax@3: the name of attribute 0 is empty");
  EXPECT_EQ(outcome_of("[[\"0\", \"0\", \"0\"]]", "[[\"0\", \"0\"]]"),
            "syntax@5: a knot must have 3 items, not 2");
  EXPECT_EQ(outcome_of("[[\"0\", \"0\", \"0\"]]", "[[\"0\", \"0\", \"0\", \"0\"]]"),
            "syntax@5: a knot must have 3 items, not more");
  EXPECT_EQ(outcome_of("[[\"0\", \"0\", \"0\"]]", "[[\"0\", \"0\", 0]]"),
            "syntax@5: a string expected, but there is '0'");
  EXPECT_EQ(outcome_of("[[\"0\", \"0\", \"0\"]]", "[]"),
            "syntax@5: vertex 0 must have 1, 2 or 3 knots, not 0");
  EXPECT_EQ(outcome_of("[[\"0\", \"0\", \"0\"]]",
                       "[[\"0\",\"0\",\"0\"],[\"0\",\"0\",\"0\"],[\"0\","
                       "\"0\",\"0\"],[\"0\",\"0\",\"0\"]]"),
            "over-limit@5: more than 3 knots of a vertex");
  EXPECT_EQ(outcome_of("[0,1,2,3]", "[0,1,2,4]"),
            "index-out-of-range@10: tetrahedron 0 has vertex 4 of 4");
  EXPECT_EQ(outcome_of("[0,1,2,3]", "[0,1,2,2]"),
            "syntax@10: tetrahedron 0 has vertex 2 twice");
  EXPECT_EQ(outcome_of("[0,1,2,3]", "[0,1,2]"),
            "syntax@10: a tetrahedron must have 4 items, not 3");
  EXPECT_EQ(outcome_of("[0,1,2,3]", "[0,1,2,-3]"),
            "syntax@10: a number of a tetrahedron must be an integer from 0 to 16777215, not '-3'");
  EXPECT_EQ(outcome_of("[0,1,2,3]", "[0,1,2,16777216]"),
            "over-limit@10: a number of a tetrahedron must be an integer from 0 to 16777215, not "
            "'16777216'");
  EXPECT_EQ(outcome_of("[\n[0,1,2,3]]", "[]"), "syntax@9: there are 0 tetrahedra");
}

TEST(Dms, RefusalsOfControlPointsHaveTheirLine) {
  EXPECT_EQ(outcome_of("{\"at\": [0,0]", "{\"at\": [1,0]"),
            "syntax@12: the vertices of a control point must not decrease, as 1, 0 do");
  EXPECT_EQ(outcome_of("{\"at\": [0,0]", "{\"at\": [0]"),
            "syntax@12: the place of a control point must have 2 items, not 1");
  EXPECT_EQ(outcome_of("{\"at\": [0,0]", "{\"at\": [0,4]"),
            "index-out-of-range@12: a control point is at vertex 4 of 4");
  EXPECT_EQ(outcome_of("{\"at\": [0,0]", "{\"at\": [0,1]"),
            "syntax@13: there are two control points of the vertices [0,1]");
  EXPECT_EQ(outcome_of("{\"at\": [0,0], \"value\": [\"0\", \"0\", \"0\", \"1\"]},\n", ""),
            "syntax@11: there is no control point of the vertices [0,0]");
  EXPECT_EQ(outcome_of("{\"at\": [0,0], \"value\"", "{\"at\": [0,0], \"values\""),
            "syntax@12: unknown key 'values'");
  EXPECT_EQ(outcome_of("{\"at\": [0,0], ", "{"), "syntax@12: the key 'at' is missing");
  EXPECT_EQ(outcome_of("{\"at\": [0,0], ", "{\"tetrahedron\": 0, "),
            "syntax@12: the key 'beta' is missing");
  EXPECT_EQ(outcome_of("{\"at\": [0,0], ", "{\"beta\": [2,0,0,0], "),
            "syntax@12: the key 'tetrahedron' is missing");
  EXPECT_EQ(
      outcome_of("{\"at\": [0,0], ", "{\"at\": [0,0], \"tetrahedron\": 0, "),
      "syntax@12: a control point has the key 'at', or the keys 'tetrahedron' and 'beta', not "
      "both");
  EXPECT_EQ(outcome_of("{\"at\": [0,1], ", "{\"tetrahedron\": 0, \"beta\": [1,1,0,0], "),
            "syntax@13: control points must all be shared or all be separate, as the first one is");
  EXPECT_EQ(outcome_of("[\"0\", \"0\", \"0\", \"1\"]", "[\"0\", \"0\", \"0\"]"),
            "syntax@12: a value must have 4 items, not 3");
  EXPECT_EQ(
      outcome_of("[\"0\", \"0\", \"0\", \"1\"]", "[\"0\", \"0\", \"0\", \"nan\"]").substr(0, 13),
      "not-finite@12");
  EXPECT_EQ(
      outcome_of("[\"0\", \"0\", \"0\", \"1\"]", "[\"0\", \"0\", \"0\", \"1/0\"]").substr(0, 13),
      "not-finite@12");
  EXPECT_EQ(outcome_of("[\"0\", \"0\", \"0\", \"1\"]", "[\"0\", \"0\", \"0\", \"0x1p2048\"]"),
            "over-limit@12: numerators and denominators must be below 2^2048");
  EXPECT_EQ(outcome_of("}]}", "}],\n\"attribute_domain\": {}}"),
            "syntax@22: the key 'degree' is missing");
  EXPECT_EQ(outcome_of("}]}", "}]} x"),
            "syntax@21: the end of the file expected, but there is 'x'");
  EXPECT_EQ(outcome_of("}]}", "}],\n\"model\": 1}"), "syntax@22: unknown key 'model'");
}

TEST(Dms, SeparateControlPointsNeedWholeClouds) {
  DmsModel model = internal::separated(parse_dms(one_dms())->model);
  model.clouds[1].push_back({2, 0, 0});
  const std::string good = write_dms(model);
  ASSERT_TRUE(parse_dms(good));
  const auto outcome = [&](const std::string& from, const std::string& to) {
    return outcome_of(parse_dms(with_change(from, to, good)));
  };
  EXPECT_EQ(outcome(", [\"2\", \"0\", \"0\"]]", "]"),
            "syntax@6: with separate control points vertex 1 must have 1 or 3 knots, not 2");
  EXPECT_EQ(outcome("\"beta\": [2,0,0,0]", "\"beta\": [1,0,0,0]"),
            "syntax@12: the numbers of beta must add up to 2, and add up to 1");
  EXPECT_EQ(outcome("\"beta\": [2,0,0,0]", "\"beta\": [1,1,0,0]"),
            "syntax@13: there are two control points of tetrahedron 0, beta [1,1,0,0]");
  EXPECT_EQ(outcome("\"tetrahedron\": 0", "\"tetrahedron\": 1"),
            "index-out-of-range@12: a control point is of tetrahedron 1 of 1");
  EXPECT_EQ(outcome("\"beta\": [2,0,0,0]", "\"beta\": [2,0,0]"),
            "syntax@12: beta must have 4 items, not 3");
}

const std::string& own_dms() {
  static const std::string text =
      io_test::slurp(test::source_dir() + "/tests/models/dms/attribute_domain.vdms");
  return text;
}

TEST(Dms, RefusalsWithinAnAttributeDomainHaveTheirLine) {
  ASSERT_EQ(outcome_of(parse_dms(own_dms())), "ok");
  const std::size_t begin = own_dms().find("\"attribute_domain\"");
  const auto outcome = [&](const std::string& from, const std::string& to) {
    return outcome_of(
        parse_dms(own_dms().substr(0, begin) + with_change(from, to, own_dms().substr(begin))));
  };
  EXPECT_EQ(outcome("{\"degree\": 1,\n", "{"),
            "syntax@22: the key 'degree' must come before the key 'attributes'");
  EXPECT_EQ(outcome("\"degree\": 1", "\"degree\": 0"),
            "syntax@22: the degree must be from 1 to 9, not 0");
  EXPECT_EQ(outcome("{\"degree\": 1", "{\"format\": \"veritope-dms-1\", \"degree\": 1"),
            "syntax@22: unknown key 'format'");
  EXPECT_EQ(outcome("{\"degree\": 1", "null, \"degree\": 1").substr(0, 9), "syntax@22");
  EXPECT_EQ(outcome("[\"heat\"]", "[]"), "syntax@23: the attribute domain has no attributes");
  EXPECT_EQ(outcome("[\"heat\"]", "[\"density\"]"),
            "syntax@23: attribute 0 of the attribute domain has the name of attribute 0 of "
            "the model");
  EXPECT_EQ(outcome("[\"heat\"]", "[\"heat\", \"heat\"]"),
            "syntax@23: attributes 0 and 1 have the same name");
  EXPECT_EQ(outcome("[\"heat\"]", "[\"heat\", \"load\"]"),
            "syntax@34: a value must have 2 items, not 1");
  EXPECT_EQ(outcome("[0,4,2,3]", "[0,5,2,3]"),
            "index-out-of-range@31: tetrahedron 0 has vertex 5 of 5");
  EXPECT_EQ(outcome("[[\"1\", \"0\", \"0\"]]", "[]"),
            "syntax@26: vertex 1 must have 1 or 2 knots, not 0");
  EXPECT_EQ(outcome("{\"at\": [0], \"value\": [\"0\"]},\n", ""),
            "syntax@33: there is no control point of the vertices [0]");
  EXPECT_EQ(outcome("{\"at\": [4]", "{\"at\": [3]"),
            "syntax@38: there are two control points of the vertices [3]");
  EXPECT_EQ(outcome("{\"at\": [4], ", "{"), "syntax@38: the key 'at' is missing");
  EXPECT_EQ(outcome("[\"1\"]}]}", "[\"nan\"]}]}").substr(0, 13), "not-finite@38");
  EXPECT_EQ(outcome("[\"1\"]}]}", "[\"1\"]}],\n\"attribute_domain\": {}}"),
            "syntax@39: unknown key 'attribute_domain'");
  EXPECT_EQ(outcome("}]}}", "}]},\n\"attribute_domain\": {}}"),
            "syntax@39: the key 'attribute_domain' occurs twice");
  EXPECT_EQ(outcome("}]}}", "}]},\n\"control\": []}"), "syntax@39: the key 'control' occurs twice");
  EXPECT_EQ(outcome_of("\"control\"", "\"attribute_domain\": {}, \"control\""),
            "syntax@11: the key 'control' must come before the key 'attribute_domain'");
}

TEST(Dms, AttributeDomainsComeBackByteForByte) {
  EXPECT_EQ(write_dms(parse_dms(own_dms())->model), own_dms());
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    DmsModel model = draw_dms(seed, 3).model, own = draw_dms(seed + 100, 3, 0).model;
    if (seed % 2 == 0) own = internal::separated(own);
    // The coordinates become the attributes.
    own.num_coordinates = 0;
    own.attributes = {"p", "q", "r"};
    model.attribute_domain = {own};
    ASSERT_TRUE(validate(model)) << validate(model).error().message;
    const std::string bytes = write_dms(model);
    const auto file = parse_dms(bytes);
    ASSERT_TRUE(file) << "seed " << seed << ": " << outcome_of(file);
    EXPECT_EQ(file->model, model) << "seed " << seed;
    EXPECT_EQ(write_dms(file->model), bytes) << "seed " << seed;
  }
}

// Each prefix is refused with a line, and nothing of it is believed.
TEST(Dms, PrefixesAreRefused) {
  for (const std::string& whole : {one_dms(), own_dms()})
    for (std::size_t size = 0; size + 1 < whole.size(); ++size) {
      const auto file = parse_dms(whole.substr(0, size));
      ASSERT_FALSE(file) << size;
      ASSERT_TRUE(file.error().place.line.has_value()) << size;
    }
}

TEST(Dms, IsRecognisedByItsNameAndItsFirstMember) {
  const std::string name = "model";
  const ByteBuffer buffer = copy_to_buffer(io_test::bytes(one_dms()));
  EXPECT_TRUE(looks_like_dms(source_of(buffer, name)));
  EXPECT_FALSE(looks_like_micro(source_of(buffer, name)));
  const Result<ModelFile> file = read_model_bytes(io_test::bytes(one_dms()), name, {});
  ASSERT_TRUE(file);
  ASSERT_TRUE(std::holds_alternative<DmsFile>(*file));
  EXPECT_EQ(std::get<DmsFile>(*file).sha256.size(), 64u);
  EXPECT_STREQ(model_format(format_of(*file)).name, "vdms");
  EXPECT_EQ(*model_format(format_of(*file)).write(*file, {}), one_dms());
  EXPECT_STREQ(title_of(kind_of(*file)), "a simplex-spline solid");
}

}  // namespace
}  // namespace veritope
