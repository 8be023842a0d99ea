// SPDX-License-Identifier: LGPL-3.0-or-later
// Reading rule v1, sections 1 and 2.
#include "tests/io/io_test_util.h"

#include <cmath>
#include <limits>

namespace veritope {
namespace {

using io_test::content;
using io_test::ignored;
using io_test::outcome;
using io_test::packed;

Result<MeshFile> stl(std::string_view text, ModelReadOptions options = {}) {
  return io_test::read(MeshFormat::kStl, text, options);
}

std::string facet(std::array<float, 9> c, std::uint16_t attribute = 0) {
  return packed(0.f, 0.f, 0.f, c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], attribute);
}

std::string binary(const std::string& facets, std::uint32_t count, std::string header = "") {
  header.resize(80, ' ');
  return header + packed(count) + facets;
}

const std::string kFacet = facet({0, 0, 0, 1, 0, 0, 0, 1, 0});
constexpr const char* kTriangle = "0,0,0 1,0,0 0,1,0 | 0,1,2";
const std::string kAsciiFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

TEST(StlBinary, ReadsATriangle) {
  const auto file = stl(binary(kFacet, 1));
  EXPECT_EQ(content(file), kTriangle);
  EXPECT_EQ(file->report.variant, "stl-binary");
  EXPECT_EQ(ignored(*file, "normals"), 1u);
  EXPECT_EQ(ignored(*file, "non-zero attributes"), 0u);
}

TEST(StlBinary, TheContentDecidesNotTheHeaderWord) {
  EXPECT_EQ(content(stl(binary(kFacet, 1, "solid but binary"))), kTriangle);
  // One byte more or less, and the word counts: ASCII, whose line never ends with facets.
  EXPECT_EQ(outcome(stl(binary(kFacet, 1, "solid but binary") + "x")), "truncated@1");
  EXPECT_EQ(outcome(stl(binary(kFacet, 2, "solid but binary"))), "truncated@1");
  EXPECT_EQ(content(stl(binary(kFacet, 1, "\t SoLiD\nx") + "x")).substr(0, 6), "syntax");
}

TEST(StlBinary, BytesBehindTheLastFacetAreIgnoredAndCounted) {
  const auto file = stl(binary(kFacet, 1) + "abc");
  EXPECT_EQ(content(file), kTriangle);
  EXPECT_EQ(ignored(*file, "bytes behind the last facet"), 3u);
}

std::string notices(const Result<MeshFile>& file) { return io_test::notices(*file); }

TEST(StlBinary, AWholeNumberOfFacetsBehindTheLastIsNamed) {
  const std::string three = kFacet + kFacet + kFacet;
  EXPECT_EQ(notices(stl(binary(kFacet + three, 1))),
            "data-after-end: 3 more facets follow the stated 1: the count may be wrong");
  EXPECT_EQ(notices(stl(binary(three + kFacet, 3))),
            "data-after-end: 1 more facet follows the stated 3: the count may be wrong");
  EXPECT_EQ(content(stl(binary(kFacet + three, 1))), kTriangle);
  EXPECT_EQ(ignored(*stl(binary(kFacet + three, 1)), "bytes behind the last facet"), 150u);
  EXPECT_EQ(notices(stl(binary(three, 3))), "");
  EXPECT_EQ(notices(stl(binary(kFacet + three + "x", 1))), "");
  EXPECT_EQ(notices(stl(binary(kFacet + three.substr(1), 1))), "");
}

TEST(StlBinary, AttributesAreIgnoredAndCounted) {
  const auto file = stl(binary(facet({0, 0, 0, 1, 0, 0, 0, 1, 0}, 0x100), 1));
  EXPECT_EQ(ignored(*file, "non-zero attributes"), 1u);
}

TEST(StlBinary, CornersMergeExactlyAndMinusZeroIsZero) {
  const auto file = stl(binary(kFacet + facet({-0.f, 0, -0.f, 0, 1, 0, 0, 0, 1}) +
                                   facet({0, 0, std::nextafter(1.f, 0.f), 1, -0.f, 0, 0, 0, 1}),
                               3));
  EXPECT_EQ(content(file), "0,0,0 1,0,0 0,1,0 0,0,1 0,0,0.99999994039535522 | 0,1,2 0,2,3 4,1,3");
  for (const Vec3d& p : file->mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_FALSE(std::signbit(p[axis]));
  }
  EXPECT_EQ(file->report.file_vertices, 5u);
}

TEST(StlBinary, FloatsAreWidenedExactly) {
  const auto file = stl(binary(facet({0.1f, 1e-45f, 3.4e38f, 1, 0, 0, 0, 1, 0}), 1));
  ASSERT_TRUE(file);
  EXPECT_EQ(file->mesh.positions[0], (Vec3d{0.1f, 1e-45f, 3.4e38f}));
}

TEST(StlBinary, RefusesWhatIsNotFiniteWithByteAndFacet) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  const auto nan = stl(binary(kFacet + facet({0, 0, 0, 1, 0, 0, 0, kNan, 0}), 2));
  EXPECT_EQ(outcome(nan), "not-finite@byte" + std::to_string(84 + 50 + 12 + 7 * 4));
  EXPECT_EQ(nan.error().place.face, 1u);
  EXPECT_EQ(outcome(stl(binary(facet({-kInf, 0, 0, 1, 0, 0, 0, 1, 0}), 1))), "not-finite@byte96");
  // A normal is ignored, whatever it is.
  EXPECT_EQ(content(stl(binary(packed(kNan, kInf, 0.f) + kFacet.substr(12), 1))), kTriangle);
}

TEST(StlBinary, RefusesTruncatedAndEmptyFiles) {
  EXPECT_EQ(outcome(stl(binary(kFacet, 2))), "truncated@byte134");
  EXPECT_EQ(outcome(stl(binary(kFacet, 4000000000))), "truncated@byte134");
  EXPECT_EQ(outcome(stl(binary(kFacet.substr(0, 49), 1))), "truncated@byte133");
  EXPECT_EQ(outcome(stl(binary("", 0))), "empty@byte80");
  EXPECT_EQ(outcome(stl(binary("", 0) + "xx")), "empty@byte80");
  EXPECT_EQ(outcome(stl(std::string(83, 'x'))), "truncated@byte83");
  EXPECT_EQ(outcome(stl("x")), "truncated@byte1");
  EXPECT_EQ(outcome(stl("   \n")), "truncated@byte4");
}

TEST(StlAscii, ReadsATriangle) {
  const auto file = stl("solid name\n" + kAsciiFacet + "endsolid name\n");
  EXPECT_EQ(content(file), kTriangle);
  EXPECT_EQ(file->report.variant, "stl-ascii");
  EXPECT_EQ(ignored(*file, "normals"), 1u);
}

TEST(StlAscii, KeywordsMayHaveAnyCaseAndBlanksAnyKind) {
  EXPECT_EQ(content(stl("\r\n SOLID\rFacet outer LOOP vertex 0 0 0\fVertex\t1 0\n0 verteX 0 1 0 "
                        "ENDLOOP endFacet EndSolid")),
            kTriangle);
  EXPECT_EQ(content(stl("\xEF\xBB\xBFsolid\n" + kAsciiFacet + "endsolid")), kTriangle);
}

TEST(StlAscii, AnythingMayStandWhereTheNormalStands) {
  EXPECT_EQ(content(stl("solid\nfacet solid vertex nan \xFF outer loop\nvertex 0 0 0 vertex 1 0 0 "
                        "vertex 0 1 0 endloop endfacet endsolid x")),
            kTriangle);
}

TEST(StlAscii, AllSolidBlocksAreOneModel) {
  const std::string second =
      "facet normal 0 0 1 outer loop vertex 0 0 0 vertex 0 1 0 vertex 0 0 1 endloop endfacet\n";
  EXPECT_EQ(content(stl("solid a\n" + kAsciiFacet + "endsolid a facet\nsolid b\n" + second +
                        "endsolid b\n\nsolid\nendsolid")),
            "0,0,0 1,0,0 0,1,0 0,0,1 | 0,1,2 0,2,3");
}

TEST(StlAscii, RefusesEverythingElse) {
  const auto with = [](const std::string& body) { return outcome(stl("solid x\n" + body)); };
  EXPECT_EQ(with(kAsciiFacet), "truncated@9");
  EXPECT_EQ(with(kAsciiFacet + "endsolid\nfacet"), "syntax@10");
  EXPECT_EQ(with(kAsciiFacet + "solid y\nendsolid"), "syntax@9");
  EXPECT_EQ(with("endsolid x\n"), "empty@3");
  EXPECT_EQ(with(""), "truncated@2");
  EXPECT_EQ(with("facet normal 0 0 1"), "truncated@2");
  EXPECT_EQ(with("facet outer\nvertex"), "syntax@3");
  EXPECT_EQ(with("facet outer loop\nvertex 0 0 0\nvertex 1 0 0\nendloop"), "syntax@5");
  EXPECT_EQ(with("facet outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 0 0\nvertex 1 1 0"),
            "syntax@6");
  EXPECT_EQ(with("facet outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 0 0 0\nendloop"),
            "syntax@5");
  EXPECT_EQ(with("facet outer loop\nvertex 0 0\nvertex 1 0 0"), "syntax@4");
  EXPECT_EQ(with("facet outer loop\nvertex 0 0 inf\n"), "not-finite@3");
  EXPECT_EQ(with("facet outer loop\nvertex 0 0"), "truncated@3");
  EXPECT_EQ(with("facet outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endsolid"),
            "syntax@2");
  EXPECT_EQ(with("facet outer loop vertex 0 0 0# vertex"), "syntax@2");
}

TEST(StlAscii, MergesManyCornersInTheOrderOfTheirFirstOccurrence) {
  std::string text = "solid\n";
  for (int i = 0; i < 500; ++i) {
    const std::string a = std::to_string(i), b = std::to_string(i + 1);
    text += "facet outer loop vertex " + a + " 0 0 vertex " + b + " 0 0 vertex " + a +
            " 1 0 endloop endfacet\n";
  }
  const auto file = stl(text + "endsolid");
  ASSERT_TRUE(file);
  ASSERT_EQ(file->mesh.positions.size(), 1001u);
  EXPECT_EQ(file->mesh.faces[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(file->mesh.faces[1], (std::array<std::uint32_t, 3>{1, 3, 4}));
  EXPECT_EQ(file->mesh.faces[499], (std::array<std::uint32_t, 3>{997, 999, 1000}));
}

TEST(StlReader, IsAlwaysMerged) {
  ModelReadOptions options;
  options.as_indexed = true;
  EXPECT_EQ(content(stl(binary(kFacet + kFacet, 2), options)), "0,0,0 1,0,0 0,1,0 | 0,1,2 0,1,2");
}

}  // namespace
}  // namespace veritope
