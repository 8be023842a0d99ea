// SPDX-License-Identifier: LGPL-3.0-or-later
// Reading rule v1, sections 1 and 5.
#include "tests/io/io_test_util.h"

namespace veritope {
namespace {

using io_test::content;
using io_test::ignored;
using io_test::outcome;

Result<MeshFile> off(std::string_view text, ModelReadOptions options = {}) {
  return io_test::read(MeshFormat::kOff, text, options);
}

constexpr const char* kTriangle = "0,0,0 1,0,0 0,1,0 | 0,1,2";

TEST(OffReader, ReadsATriangle) {
  const auto file = off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(content(file), kTriangle);
  EXPECT_EQ(file->report.variant, "off");
  EXPECT_TRUE(file->report.ignored.empty());
}

TEST(OffReader, CommentsBlankLinesAndLineEndsMayBeAnywhere) {
  for (const std::string eol : {"\n", "\r", "\r\n", "\n \t\n", " # x\n", "#\r#\n"}) {
    const std::string text = "# first" + eol + "OFF" + eol + "3" + eol + "1 0" + eol + "0 0 0" +
                             eol + "1 0 0" + eol + eol + "0 1 0" + eol + "3 0 1 2";
    EXPECT_EQ(content(off(text)), kTriangle) << text;
    EXPECT_EQ(content(off(text + eol)), kTriangle) << text;
  }
  EXPECT_EQ(content(off("\xEF\xBB\xBFOFF 3 1 0\n0 0 0#\n1 0 0\n0 1 0\n3 0 1 2#")), kTriangle);
  EXPECT_EQ(content(off("OFF 3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2")), kTriangle) << "no edge count";
}

TEST(OffReader, PrefixesOfOffAreIgnoredInTheirOrder) {
  for (const char* word :
       {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"}) {
    const std::string text =
        std::string(word) + "\n3 1 0\n0 0 0 1 2\n1 0 0 x\n0 1 0\n3 0 1 2 0.5\n";
    const auto file = off(text);
    EXPECT_EQ(content(file), kTriangle) << word;
    if (!file) continue;
    EXPECT_EQ(ignored(*file, "vertex lines with more values"), 2u);
    EXPECT_EQ(ignored(*file, "face lines with more values"), 1u);
  }
  for (const char* word : {"off", "NCOFF", "CSTOFF", "4OFF", "nOFF", "ST4OFF", "4nOFF", "OFFx",
                           "OFF3", "STST", "Off", "CCOFF"}) {
    const std::string text = std::string(word) + "\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    EXPECT_EQ(outcome(off(text)), "syntax@1") << word;
  }
}

TEST(OffReader, RefusesBinaryOff) {
  EXPECT_EQ(outcome(off("OFF BINARY\n\0\0\0\1")), "foreign-format@1");
  EXPECT_EQ(outcome(off("OFF\nBINARY\n")), "foreign-format@2");
}

TEST(OffReader, WhatFollowsTheCountsOnTheirLineAndTheLastFaceIsIgnored) {
  const auto file = off("OFF\n3 1 many edges\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\ntrailing\n");
  EXPECT_EQ(content(file), kTriangle);
  EXPECT_EQ(ignored(*file, "bytes behind the last face"), 9u);
}

TEST(OffReader, WhatFollowsTheStatedFacesIsNamedUnlessItIsAComment) {
  const std::string file = "OFF 4 1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n";
  EXPECT_EQ(io_test::notices(*off(file + "3 0 1 3\n")),
            "data-after-end: 8 more bytes follow the stated 1 face: the count may be wrong");
  EXPECT_EQ(io_test::notices(*off(file + "# faces\n\n 3 0 1 3\n3 1 2 3")),
            "data-after-end: 15 more bytes follow the stated 1 face: the count may be wrong");
  for (const char* const rest : {"", " \n\n", "# a comment", "\n# a comment\n"})
    EXPECT_EQ(io_test::notices(*off(file + rest)), "") << rest;
}

TEST(OffReader, PolygonsAreFans) {
  const auto file = off("OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n5 0 1 2 3 4\n3 1 2 3\n");
  EXPECT_EQ(content(file), "0,0,0 1,0,0 1,1,0 0,1,0 0,2,0 | 0,1,2 0,2,3 0,3,4 1,2,3");
  EXPECT_EQ(file->report.polygons_split, 1u);
  EXPECT_EQ(file->polygon_of_face, (std::vector<std::uint32_t>{0, 0, 0, 1}));
}

TEST(OffReader, RefusesAWrongCountWithItsLine) {
  EXPECT_EQ(outcome(off("OFF\n-3 1 0\n0 0 0\n")), "syntax@2");
  EXPECT_EQ(outcome(off("OFF\n3.0 1 0\n0 0 0\n")), "syntax@2");
  EXPECT_EQ(outcome(off("OFF\n3")), "truncated@2");
  EXPECT_EQ(outcome(off("OFF")), "truncated@1");
  EXPECT_EQ(outcome(off("# only\n")), "empty@2");
  EXPECT_EQ(outcome(off("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n")), "empty@2");
  EXPECT_EQ(outcome(off("OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")), "truncated@2");
  EXPECT_EQ(outcome(off("OFF\n18446744073709551617 1 0\n0 0 0\n")), "truncated@2");
  EXPECT_EQ(outcome(off("OFF\n2305843009213693952 2305843009213693952 0\n0 0 0\n")), "truncated@2");
}

TEST(OffReader, TheCountsMayFillTheFileToTheLastByte) {
  EXPECT_EQ(content(off("OFF 3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2")), kTriangle);
  EXPECT_EQ(outcome(off("OFF 3 2\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2")), "truncated@1");
  EXPECT_EQ(outcome(off("OFF 4 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2")), "truncated@1");
}

TEST(OffReader, RefusesVerticesAndFacesWithTheirLine) {
  const auto with = [](const char* vertex, const char* face) {
    return outcome(off(std::string("OFF\n3 1 0\n0 0 0\n1 0 0\n") + vertex + "\n" + face + "\n"));
  };
  EXPECT_EQ(with("0 1 0", "3 0 1 2"), "ok");
  EXPECT_EQ(with("0   1", "3 0 1 2"), "syntax@5");
  EXPECT_EQ(with("0 1 # 0", "3 0 1 2 # longer"), "syntax@5");
  EXPECT_EQ(with("0 1,5 0", "3 0 1 2"), "syntax@5");
  EXPECT_EQ(with("0 nan 0", "3 0 1 2"), "not-finite@5");
  EXPECT_EQ(with("0 -1e309 0", "3 0 1 2"), "not-finite@5");
  EXPECT_EQ(with("0 1 0", "2 0 1 2"), "syntax@6");
  EXPECT_EQ(with("0 1 0", "-3 0 1 2"), "syntax@6");
  EXPECT_EQ(with("0 1 0", "3 0 1 3"), "index-out-of-range@6");
  EXPECT_EQ(with("0 1 0", "3 0 1 -1"), "index-out-of-range@6");
  EXPECT_EQ(with("0 1 0", "3 0 1 x"), "syntax@6");
  EXPECT_EQ(with("0 1 0", "3 0 1 2.0"), "syntax@6");
  EXPECT_EQ(with("0 1 0", "4 0 1 2  "), "syntax@6") << "a face ends with its line";
  EXPECT_EQ(with("0 1 0", "4000000000 0 1 2"), "syntax@6");
  EXPECT_EQ(with("0 1 0", "# no face....."), "truncated@7");
}

}  // namespace
}  // namespace veritope
