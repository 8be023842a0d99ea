// SPDX-License-Identifier: LGPL-3.0-or-later
// Reading rule v1, sections 1 and 3.
#include <chrono>

#include "tests/io/io_test_util.h"

namespace veritope {
namespace {

using io_test::content;
using io_test::ignored;
using io_test::outcome;

Result<MeshFile> obj(std::string_view text, ModelReadOptions options = {}) {
  return io_test::read(MeshFormat::kObj, text, options);
}

constexpr const char* kTriangle = "0,0,0 1,0,0 0,1,0 | 0,1,2";

TEST(ObjReader, ReadsATriangle) {
  const auto file = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(content(file), kTriangle);
  EXPECT_EQ(file->report.variant, "obj");
  EXPECT_EQ(file->report.file_vertices, 3u);
  EXPECT_TRUE(file->polygon_of_face.empty());
}

TEST(ObjReader, LineEndsAndBlanksOfEveryKindAreTheSame) {
  for (const char* eol : {"\n", "\r", "\r\n", "\n\n", " \t\v\f\n"}) {
    std::string text;
    for (const char* line : {"v 0 0 0", "\tv\v1\f0 \t0", " v 0 1 0", "f 1 2 3"}) {
      text += std::string(line) + eol;
    }
    EXPECT_EQ(content(obj(text)), kTriangle);
    text.erase(text.size() - std::strlen(eol));
    EXPECT_EQ(content(obj(text)), kTriangle) << "without the last line end";
  }
}

TEST(ObjReader, SkipsAByteOrderMarkOnce) {
  EXPECT_EQ(content(obj("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3")), kTriangle);
  EXPECT_EQ(outcome(obj("\xEF\xBB\xBF\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nf 1 2 2")),
            "index-out-of-range@3");
}

TEST(ObjReader, CornersMayCarryTextureAndNormals) {
  EXPECT_EQ(content(obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/5 2//7 3/x/y/z\n")), kTriangle);
  EXPECT_EQ(content(obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nfo +1/ 2/ 03/\n")), kTriangle);
}

// "x,y,z ... | a,b,c ...", - for none.
std::string normals(const Result<MeshFile>& file) {
  if (!file) return outcome(file) + ": " + file.error().message;
  if (!file->normals) return "none";
  MeshFile shown;
  shown.mesh = {file->normals->values, file->normals->of_face};
  std::string text = content(Result<MeshFile>(std::move(shown)));
  for (std::size_t at; (at = text.find("4294967295")) != text.npos;) text.replace(at, 10, "-");
  return text;
}
ModelReadOptions with_normals() {
  ModelReadOptions options;
  options.with_normals = true;
  return options;
}

TEST(ObjReader, KeepsNormalsOnRequest) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  const auto read = [&](const std::string& rest) {
    return normals(obj(square + rest, with_normals()));
  };
  EXPECT_EQ(read("vn 0 0 .1\nvn 1 0 -0\nf 1//1 2//2 3/9/-1 4//1\n"),
            "0,0,0.10000000000000001 1,0,0 | 0,1,1 0,1,0");
  EXPECT_EQ(read("f 1/7/1 2//2 3\nvn 0 0 1\nvn 1 0 2\n"), "0,0,1 1,0,2 | 0,1,-");
  EXPECT_EQ(read("vn 0 0 1\nf 1//1 2//1 \\\n3//1\n"), "0,0,1 | 0,0,0");
  EXPECT_EQ(read("vn 0 \\\n0 1\nf 1//1 2//1 3/\\\n/1\n"), "0,0,1 | 0,0,0");
  EXPECT_EQ(read("vn 0 0 1\nf 1 2/3 3//\n"), "none");
  EXPECT_EQ(read("vn 0 0 1\nf 1//1 2//2 3//1\n"),
            "index-out-of-range@6: the normal of 2 (1 normals)");
  EXPECT_EQ(read("vn 0 0 1\nf 1//-2 2//1 3//1\n"),
            "index-out-of-range@6: the normal of '1//-2' (1 normals)");
  EXPECT_EQ(read("vn 0 0 1\nf 1//1x 2//1 3//1\n"), "syntax@6: the number of a normal in '1//1x'");
  EXPECT_EQ(read("vn 0 0 1\nf 1//0 2//1 3//1\n"),
            "index-out-of-range@6: the normal of '1//0' (1 normals)");
  EXPECT_EQ(outcome(obj(square + "vn 0 0 inf\nf 1 2 3\n", with_normals())), "not-finite@5");
  EXPECT_EQ(outcome(obj(square + "vn 0 0\nf 1 2 3\n", with_normals())), "syntax@5");
}

TEST(ObjReader, IgnoresWhateverNormalsSayWithoutARequest) {
  const auto file = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn nan\nf 1//x 2//9 3\n");
  EXPECT_EQ(content(file), kTriangle);
  EXPECT_EQ(ignored(*file, "vn lines"), 1u);
  EXPECT_FALSE(file->normals);
}

// Merged vertices keep the normals of their corners.
TEST(ObjReader, NormalsBelongToCornersNotToVertices) {
  const auto file =
      obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nvn 0 0 1\nvn 0 0 2\nf 1//1 2//1 3//1\nf 4//2 3//1 "
          "2//1\n",
          with_normals());
  EXPECT_EQ(content(file), "0,0,0 1,0,0 0,1,0 | 0,1,2 0,2,1");
  EXPECT_EQ(normals(file), "0,0,1 0,0,2 | 0,0,0 1,0,0");
}

TEST(ObjReader, NegativeIndicesCountBackFromTheLine) {
  EXPECT_EQ(content(obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\n")),
            "0,0,0 1,0,0 0,1,0 5,5,5 | 0,1,2");
  const auto refused = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 -2 -1\n");
  EXPECT_EQ(outcome(refused), "index-out-of-range@4");
  EXPECT_EQ(refused.error().message, "vertex index '-4' (3 vertices up to here)");
}

TEST(ObjReader, PositiveIndicesMayNameLaterVertices) {
  EXPECT_EQ(content(obj("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n")), kTriangle);
  EXPECT_EQ(outcome(obj("v 0 0 0\nf 1 2 4\nf 1 2 3\nv 1 0 0\nv 0 1 0\n")), "index-out-of-range@2");
}

TEST(ObjReader, RefusesIndicesThatNameNothing) {
  for (const char* index : {"0", "-0", "+0", "99", "4294967297", "18446744073709551617",
                            "-18446744073709551617", "99999999999999999999999999"}) {
    const std::string text = std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 ") + index + "\n";
    EXPECT_EQ(outcome(obj(text)), "index-out-of-range@4") << index;
  }
  for (const char* index : {"1.0", "x", "1e0", "/1", "0x1", "1,", "--1", "-"}) {
    const std::string text = std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 ") + index + "\n";
    EXPECT_EQ(outcome(obj(text)), "syntax@4") << index;
  }
}

TEST(ObjReader, PolygonsAreFansFromTheirFirstVertex) {
  const auto file =
      obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\nf 1 2 3\nf 1 2 3 4 5\nf 1 2 4\n");
  EXPECT_EQ(content(file), "0,0,0 1,0,0 1,1,0 0,1,0 0,2,0 | 0,1,2 0,1,2 0,2,3 0,3,4 0,1,3");
  EXPECT_EQ(file->report.polygons_split, 1u);
  EXPECT_EQ(file->polygon_of_face, (std::vector<std::uint32_t>{0, 1, 1, 1, 2}));
}

TEST(ObjReader, RefusesFacesWithFewerThanThreeCorners) {
  for (const char* face : {"f 1 2", "f 1", "f", "f ", "f 1 2 # 3", "fo 1 2"}) {
    EXPECT_EQ(outcome(obj(std::string("v 0 0 0\nv 1 0 0\n") + face)), "syntax@3") << face;
  }
}

TEST(ObjReader, RefusesVerticesWithoutThreeDecimals) {
  for (const char* vertex :
       {"v 1 2", "v", "v ", "v 1 2 x", "v 1,0 2 3", "v 1 2 0x3", "v 1 #2 3", "v 1 2 3\xC2\xA0"}) {
    EXPECT_EQ(outcome(obj(std::string("v 0 0 0\n") + vertex + "\nf 1 1 1\n")), "syntax@2")
        << vertex;
  }
  for (const char* vertex : {"v 1 2 nan", "v inf 0 0", "v 1 -Infinity 0", "v 1e999 0 0"}) {
    EXPECT_EQ(outcome(obj(std::string("v 0 0 0\n") + vertex + "\nf 1 1 1\n")), "not-finite@2")
        << vertex;
  }
}

TEST(ObjReader, IgnoresWhatItDoesNotNeedAndCountsIt) {
  const auto file =
      obj("# a comment\nmtllib x.mtl\nv 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0# glued\nvn 0 0 1\nvn "
          "x\nvt\n"
          "usemtl steel\ns off\ng a b\nl 1 2\n#\nf 1 2 3 # the face\ncurv2 1\n");
  EXPECT_EQ(content(file), kTriangle);
  EXPECT_EQ(ignored(*file, "comment lines"), 2u);
  EXPECT_EQ(ignored(*file, "vn lines"), 2u);
  EXPECT_EQ(ignored(*file, "vt lines"), 1u);
  EXPECT_EQ(ignored(*file, "l lines"), 1u);
  EXPECT_EQ(ignored(*file, "usemtl lines"), 1u);
  EXPECT_EQ(ignored(*file, "curv2 lines"), 1u);
  EXPECT_EQ(ignored(*file, "v lines with more values"), 2u);
}

TEST(ObjReader, NamesManyIgnoredKeywordsOnlyUpToALimit) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n\x01" + std::string(100, 'k') + "\n";
  for (int i = 0; i < 1000; ++i) text += "word" + std::to_string(i % 100) + " x\n";
  const auto file = obj(text);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->report.ignored.size(), 65u);
  EXPECT_EQ(file->report.ignored[0].first, "\\x01" + std::string(36, 'k') + "... lines");
  EXPECT_EQ(ignored(*file, "word7 lines"), 10u);
  EXPECT_EQ(ignored(*file, "other lines"), 370u);
}

TEST(ObjReader, KeywordsAreRecognisedAsWrittenOnly) {
  const auto file = obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nF 1 2 9\nV 1\nvv 1\nf1 2 3\nf 1 2 3\n");
  EXPECT_EQ(content(file), kTriangle);
  EXPECT_EQ(ignored(*file, "F lines"), 1u);
  EXPECT_EQ(ignored(*file, "f1 lines"), 1u);
}

TEST(ObjReader, ABackslashBeforeTheLineEndJoinsTheNextLine) {
  for (const std::string eol : {"\n", "\r\n", "\r"}) {
    const std::string joint = "\\" + eol;
    for (const std::string& text : std::initializer_list<std::string>{
             "v 0 0 " + joint + "0" + eol + "v 1 0 0" + eol + "v 0 1 0" + eol + "f 1 2 3",
             "v 0 0 0" + eol + "v 1 0 0" + eol + "v 0 1 0" + eol + "f 1 " + joint + "2 " + joint +
                 " 3",
             joint + "v 0 0 0" + eol + "v 1 0 0" + eol + "v 0 1 0" + eol + "f 1 2 3",
             "v" + joint + " 0 0 0" + eol + "v 1 0 0" + eol + "v 0 1 0" + eol + "f 1 2 3",
             "v 0 0 0 7 " + joint + "v 9 9 9" + eol + "v 1 0 0" + eol + "v 0 1 0" + eol + "f 1 2 3",
             "# a " + joint + "v 9 9 9" + eol + "v 0 0 0" + eol + "v 1 0 0" + eol + "v 0 1 0" +
                 eol + "f 1 2 3",
             "g a " + joint + joint + "v 9 9 9" + eol + "v 0 0 0" + eol + "v 1 0 0" + eol +
                 "v 0 1 0" + eol + "f 1 2 3",
             "v 0 0 0" + eol + "v 1 0 0" + eol + "v 0 1 0" + eol + "f 1 2 3 #" + joint + "4"}) {
      EXPECT_EQ(content(obj(text)), kTriangle) << text;
    }
  }
}

TEST(ObjReader, AJointLeavesNothingBetweenTheTwoLines) {
  EXPECT_EQ(content(obj("v 0 0 0\nv \\\n1 0 0\nv 0 1 0\nv 3 1\\\n2 0\nf 1 2 3\n")),
            "0,0,0 1,0,0 0,1,0 3,12,0 | 0,1,2");
}

TEST(ObjReader, ABackslashElsewhereIsAnOrdinaryCharacter) {
  EXPECT_EQ(outcome(obj("v 0 0 0\\ \nf 1 1 1\n")), "syntax@1");
  EXPECT_EQ(outcome(obj("v 0 0 0\nf 1 1 1\\")), "syntax@2") << "the end of the file is no line end";
  EXPECT_EQ(outcome(obj("v 0 0 0\nf 1 1 \\")), "syntax@2");
}

TEST(ObjReader, AnErrorInAJoinedLineNamesTheLineWhereItBegins) {
  EXPECT_EQ(outcome(obj("v 0 0 0\nv 1 \\\n2 \\\nx\nf 1 1 1\n")), "syntax@2");
  EXPECT_EQ(outcome(obj("v 0 0 0\nf 1 \\\n2 \\\n9\n")), "index-out-of-range@2");
  const auto file = obj("v 0 0 0\nf 1 1 \\\n1x\n");
  EXPECT_NE(file.error().message.find("'1x'"), std::string::npos) << file.error().message;
}

TEST(ObjReader, SeveralJointsInAnIgnoredRestAreOneLine) {
  EXPECT_EQ(content(obj("v 0 0 0 a\\\nv 7 7 7 \\\nv 8 8 8\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")),
            kTriangle);
}

TEST(ObjReader, AnErrorBehindAJoinedLineNamesItsOwnLine) {
  EXPECT_EQ(outcome(obj("v 0 0 \\\n0\nv 1 0 0\nv x\n")), "syntax@4");
}

TEST(ObjReader, ManyJoinedLinesTakeLinearTime) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 200000; ++i) text += "f 1 2\\\n 3\n";
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(outcome(obj(text)), "ok");
  EXPECT_LT(std::chrono::steady_clock::now() - start,
            std::chrono::seconds(2));  // quadratic: minutes
}

TEST(ObjReader, RefusesAFileWithoutAFace) {
  EXPECT_EQ(outcome(obj("v 0 0 0\nv 1 0 0\n")), "empty@3");
  EXPECT_EQ(outcome(obj("# nothing\n")), "empty@2");
  EXPECT_EQ(outcome(obj(" ")), "empty@1");
}

TEST(ObjReader, LinesAreCountedAcrossAllKindsOfLineEnds) {
  EXPECT_EQ(outcome(obj("v 0 0 0\r\nv 0 0 0\rv 0 0 0\n\r\nx\n\nf 1 2 z\n")), "syntax@7");
}

}  // namespace
}  // namespace veritope
