// SPDX-License-Identifier: LGPL-3.0-or-later
// Reading rule v1, sections 1 and 4.
#include <bit>
#include <cmath>
#include <limits>

#include "tests/io/io_test_util.h"

namespace veritope {
namespace {

using io_test::content;
using io_test::ignored;
using io_test::outcome;
using io_test::packed;

Result<MeshFile> ply(std::string_view text, ModelReadOptions options = {}) {
  return io_test::read(MeshFormat::kPly, text, options);
}

constexpr const char* kTriangle = "0,0,0 1,0,0 0,1,0 | 0,1,2";
const std::string kVertices =
    "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kStrips = "element tristrips 1\nproperty list int int vertex_indices\n";

std::string ascii(const std::string& elements, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
}
std::string little(const std::string& elements, const std::string& body) {
  return "ply\nformat binary_little_endian 1.0\n" + elements + "end_header\n" + body;
}

template <typename T>
T swapped(T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  std::reverse(bytes, bytes + sizeof(T));
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

template <typename T>
std::string all(std::initializer_list<T> values) {
  std::string text;
  for (const T value : values) text += packed(value);
  return text;
}

const std::string kDoubles = packed(0., 0., 0., 1., 0., 0., 0., 1., 0.);
const std::string kList = packed(std::uint8_t{3}, 0, 1, 2);

TEST(PlyAscii, ReadsATriangle) {
  const auto file = ply(ascii(kVertices + kFaces, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  EXPECT_EQ(content(file), kTriangle);
  EXPECT_EQ(file->report.variant, "ply-ascii");
  EXPECT_TRUE(file->report.ignored.empty());
}

TEST(PlyAscii, LineEndsOfTheBodyAreBlanks) {
  EXPECT_EQ(content(ply(ascii(kVertices + kFaces, "0 0 0 1 0\r0\t0 1\v0 3\f0 1\n\n2"))), kTriangle);
}

TEST(PlyAscii, CoordinatesAreDecimalsWhateverTheirType) {
  const std::string vertices =
      "element vertex 3\nproperty uchar x\nproperty float y\nproperty int z\n";
  EXPECT_EQ(content(ply(ascii(vertices + kFaces, "0.1 0.1 0.1 1 0 0 0 1 0 3 0 1 2"))),
            "0.10000000000000001,0.10000000000000001,0.10000000000000001 1,0,0 0,1,0 | 0,1,2");
  EXPECT_EQ(outcome(ply(ascii(vertices + kFaces, "nan 0 0 1 0 0 0 1 0 3 0 1 2"))), "not-finite@10");
  EXPECT_EQ(outcome(ply(ascii(vertices + kFaces, "0 0 0 1 0,5 0 0 1 0 3 0 1 2"))), "syntax@10");
}

TEST(PlyAscii, RefusesWrongIndicesAndCounts) {
  const auto with = [](const std::string& face) {
    return outcome(ply(ascii(kVertices + kFaces, "0 0 0 1 0 0 0 1 0\n" + face)));
  };
  EXPECT_EQ(with("3 0 1 2"), "ok");
  EXPECT_EQ(with("+3 +0 01 2 rest"), "ok");
  EXPECT_EQ(with("3 0 1 3"), "index-out-of-range@11");
  EXPECT_EQ(with("3 0 1 -1"), "index-out-of-range@11");
  EXPECT_EQ(with("3 0 1 99999999999999999999999"), "index-out-of-range@11");
  EXPECT_EQ(with("3 0 1 2.0"), "syntax@11");
  EXPECT_EQ(with("2 0 1 2"), "syntax@11");
  EXPECT_EQ(with("-1 0 1 2"), "syntax@11");
  EXPECT_EQ(with("x 0 1 2"), "syntax@11");
  EXPECT_EQ(with("4 0 1 2"), "truncated@11");
  EXPECT_EQ(with("4000000000 0 1 2"), "truncated@11");
  EXPECT_EQ(with("3 0 1"), "truncated@11");
  EXPECT_EQ(with(""), "truncated@7");
}

TEST(PlyAscii, ReadsOverOtherElementsAndProperties) {
  const std::string elements =
      "comment hello\nobj_info there\n"
      "element material 2\nproperty list uchar float weights\nproperty int kind\n"
      "element vertex 3\nproperty uchar red\nproperty float z\nproperty list int int "
      "ring\nproperty float x\nproperty float y\n"
      "element nothing 4000000000\n"
      "element face 1\nproperty float area\nproperty list uchar float texcoord\n"
      "property list uchar int vertex_index\nproperty int flags\n";
  const auto file = ply(ascii(elements,
                              "2 a b c 0 d\n 255 0 0 0 0\n 1 0 2 x y 1 0\n z 0 1 nan 0 1\n"
                              "1e999 2 u v 3 0 1 2 !\n"));
  EXPECT_EQ(content(file), kTriangle);
  EXPECT_EQ(ignored(*file, "header comments"), 2u);
  EXPECT_EQ(ignored(*file, "element material"), 2u);
  EXPECT_EQ(ignored(*file, "property vertex.red"), 3u);
  EXPECT_EQ(ignored(*file, "property face.texcoord"), 1u);
  EXPECT_EQ(outcome(ply(ascii(elements, "-2 a b c 0 d\n"))), "truncated@8");
  EXPECT_EQ(
      outcome(ply(ascii(elements, "-2 a b c 0 d\n 255 0 0 0 0\n 1 0 2 x y 1 0\n z 0 1 nan 0 1\n"))),
      "syntax@21");
  EXPECT_EQ(outcome(ply(
                ascii(elements, "1.5 a b c 0 d\n 255 0 0 0 0\n 1 0 2 x y 1 0\n z 0 1 nan 0 1\n"))),
            "syntax@21");
}

TEST(PlyBinary, ReadsBothByteOrders) {
  const auto file = ply(little(kVertices + kFaces, kDoubles + kList));
  EXPECT_EQ(content(file), kTriangle);
  EXPECT_EQ(file->report.variant, "ply-binary-little-endian");
  const std::string big = "ply\nformat binary_big_endian 1.0\n" + kVertices + kFaces +
                          "end_header\n" +
                          packed(0., 0., 0., swapped(1.), 0., 0., 0., swapped(1.), 0.) +
                          packed(std::uint8_t{3}, 0, swapped(1), swapped(2));
  const auto file2 = ply(big);
  EXPECT_EQ(content(file2), kTriangle);
  EXPECT_EQ(file2->report.variant, "ply-binary-big-endian");
}

TEST(PlyBinary, WidensEveryTypeExactly) {
  const auto one = [](const char* type, const std::string& value) {
    const std::string vertices = std::string("element vertex 3\nproperty ") + type +
                                 " x\nproperty uchar y\nproperty uchar z\n";
    const auto file =
        ply(little(vertices + kFaces, value + std::string(2, 0) + value + std::string("\1\0", 2) +
                                          value + std::string("\2\0", 2) + kList));
    return file ? file->mesh.positions[0].x : NAN;
  };
  EXPECT_EQ(one("char", packed(std::int8_t{-128})), -128);
  EXPECT_EQ(one("int8", packed(std::int8_t{-1})), -1);
  EXPECT_EQ(one("uchar", packed(std::uint8_t{255})), 255);
  EXPECT_EQ(one("uint8", packed(std::uint8_t{200})), 200);
  EXPECT_EQ(one("short", packed(std::int16_t{-32768})), -32768);
  EXPECT_EQ(one("int16", packed(std::int16_t{-2})), -2);
  EXPECT_EQ(one("ushort", packed(std::uint16_t{65535})), 65535);
  EXPECT_EQ(one("uint16", packed(std::uint16_t{65535})), 65535);
  EXPECT_EQ(one("int", packed(std::int32_t{-2147483647})), -2147483647);
  EXPECT_EQ(one("int32", packed(std::int32_t{7})), 7);
  EXPECT_EQ(one("uint", packed(std::uint32_t{4294967295})), 4294967295);
  EXPECT_EQ(one("uint32", packed(std::uint32_t{4294967295})), 4294967295);
  EXPECT_EQ(one("float", packed(0.1f)), 0.1f);
  EXPECT_EQ(one("float32", packed(1e-45f)), 1e-45f);
  EXPECT_EQ(one("double", packed(5e-324)), 5e-324);
  EXPECT_EQ(one("float64", packed(0.1)), 0.1);
  EXPECT_FALSE(std::signbit(one("float", packed(-0.f))));
  EXPECT_TRUE(std::isnan(one("long", packed(0))));
}

TEST(PlyBinary, EveryIntegerTypeMayCountAndIndex) {
  const auto with = [](const char* types, const std::string& list) {
    return content(
        ply(little(kVertices + "element face 1\nproperty list " + types + " vertex_index\n",
                   kDoubles + list)));
  };
  EXPECT_EQ(with("char char", all<std::int8_t>({3, 0, 1, 2})), kTriangle);
  EXPECT_EQ(with("ushort uint16", all<std::uint16_t>({3, 0, 1, 2})), kTriangle);
  EXPECT_EQ(with("int short", packed(3) + all<std::int16_t>({0, 1, 2})), kTriangle);
  EXPECT_EQ(with("uint uint", packed(3u, 0u, 1u, 2u)), kTriangle);
  EXPECT_EQ(with("uchar float", packed(std::uint8_t{3}, 0.f, 1.f, 2.f)).substr(0, 8), "syntax@7");
  EXPECT_EQ(with("float int", packed(3.f, 0, 1, 2)).substr(0, 8), "syntax@8");
}

TEST(PlyBinary, ReadsOverOtherElementsAndProperties) {
  const std::string elements =
      "element edge 2\nproperty int a\nproperty int b\n"
      "element vertex 3\nproperty float z\nproperty list uchar short ring\nproperty float "
      "x\nproperty float y\n"
      "element hair 1\nproperty list int double d\n"
      "element face 2\nproperty char c\nproperty list uchar int vertex_indices\nproperty list "
      "uchar float uv\n";
  const std::string ring = packed(std::uint8_t{1}, std::int16_t{7});
  const std::string body = packed(1, 2, 3, 4) + packed(0.f) + ring + packed(0.f, 0.f) +
                           packed(0.f, std::uint8_t{0}) + packed(1.f, 0.f) + packed(0.f) + ring +
                           packed(0.f, 1.f) + packed(2, 1., 2.) + packed(std::int8_t{0}) + kList +
                           packed(std::uint8_t{1}, 1.f) + packed(std::int8_t{0}) + kList +
                           packed(std::uint8_t{0}) + "tail";
  const auto file = ply(little(elements, body));
  EXPECT_EQ(content(file), "0,0,0 1,0,0 0,1,0 | 0,1,2 0,1,2");
  EXPECT_EQ(ignored(*file, "element edge"), 2u);
  EXPECT_EQ(ignored(*file, "bytes behind the last element"), 4u);
  for (std::size_t cut = 5; cut < body.size(); cut += 7) {
    EXPECT_EQ(outcome(ply(little(elements, body.substr(0, body.size() - cut)))).substr(0, 9),
              "truncated")
        << cut;
  }
}

TEST(PlyBinary, VerticesBehindListsAreComparedWithTheBytesThatAreLeft) {
  // As announced all would fit; but the list before the vertices takes their place.
  const std::string hair = "element hair 1\nproperty list uchar double d\n";
  const std::string body = packed(std::uint8_t{7}) + std::string(56, 0) + packed(0., 0., 0.);
  EXPECT_EQ(outcome(ply(little(hair + kVertices + kFaces, body))).substr(0, 9), "truncated");
}

TEST(PlyBinary, RefusesWithTheByteOfTheValue) {
  const std::string header = little(kVertices + kFaces, "");
  const auto at = [&](std::size_t offset) {
    return "@byte" + std::to_string(header.size() + offset);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(outcome(ply(header + packed(0., 0., 0., 1., nan, 0., 0., 1., 0.) + kList)),
            "not-finite" + at(32));
  EXPECT_EQ(outcome(ply(header + packed(0., 0., 0., 1., 0., -HUGE_VAL, 0., 1., 0.) + kList)),
            "not-finite" + at(40));
  EXPECT_EQ(outcome(ply(header + kDoubles + packed(std::uint8_t{3}, 0, 1, 3))),
            "index-out-of-range" + at(73));
  EXPECT_EQ(outcome(ply(header + kDoubles + packed(std::uint8_t{3}, 0, -1, 2))),
            "index-out-of-range" + at(73));
  EXPECT_EQ(outcome(ply(header + kDoubles + packed(std::uint8_t{2}, 0, 1) + "xxxx")),
            "syntax" + at(73));
  EXPECT_EQ(outcome(ply(header + kDoubles + packed(std::uint8_t{4}, 0, 1, 2))),
            "truncated" + at(73));
  const std::string lists =
      little(kVertices + "element face 1\nproperty list int int vertex_index\n", "");
  EXPECT_EQ(outcome(ply(lists + kDoubles + packed(-1, 0, 1, 2))),
            "syntax@byte" + std::to_string(lists.size() + 72));
  EXPECT_EQ(outcome(ply(lists + kDoubles + packed(2147483647, 0, 1, 2))),
            "truncated@byte" + std::to_string(lists.size() + 76));
}

TEST(PlyBinary, AnUnsignedIndexOfAllOnesEndsNoStripAndIsOutOfRange) {
  const std::string header =
      kVertices + "element tristrips 1\nproperty list int uint vertex_indices\n";
  EXPECT_EQ(outcome(ply(little(header, kDoubles + packed(4, 0, 1, 2, -1)))).substr(0, 12),
            "index-out-of");
}

TEST(PlyStrips, YieldTrianglesOfAlternatingSense) {
  const std::string vertices =
      "element vertex 5\nproperty double x\nproperty double y\nproperty double z\n";
  const std::string body = "0 0 0 1 0 0 0 1 0 1 1 0 0 2 0\n";
  const std::string points = "0,0,0 1,0,0 0,1,0 1,1,0 0,2,0 |";
  const auto with = [&](const std::string& strips) {
    return ply(ascii(vertices + kStrips, body + strips));
  };
  EXPECT_EQ(content(with("5 0 1 2 3 4")), points + " 0,1,2 2,1,3 2,3,4");
  EXPECT_EQ(content(with("8 0 1 2 -1 1 2 3 4")), points + " 0,1,2 1,2,3 3,2,4");
  EXPECT_EQ(content(with("9 -1 0 1 -1 -1 1 2 3 -1")), points + " 1,2,3");
  const auto joint = with("7 0 1 2 2 3 3 4");
  EXPECT_EQ(content(joint), points + " 0,1,2");
  EXPECT_EQ(joint->report.strip_joints, 4u);
  EXPECT_EQ(content(with("7 0 1 2 2 3 4 1")), points + " 0,1,2 3,2,4 3,4,1");
  EXPECT_EQ(content(with("4 0 1 0 2")), points + " 0,1,2") << "0 1 0 is a joint, 1 0 2 turns";
  EXPECT_EQ(outcome(with("2 0 1")), "empty@11");
  EXPECT_EQ(outcome(with("3 0 1 5")), "index-out-of-range@11");
  EXPECT_EQ(outcome(with("3 0 1 -2")), "index-out-of-range@11");
  EXPECT_EQ(outcome(with("2 0 77")), "index-out-of-range@11");
}

TEST(PlyStrips, AndFacesMayStandTogether) {
  const auto file =
      ply(ascii(kVertices + kStrips + kFaces, "0 0 0 1 0 0 0 1 0  3 0 1 2  4 2 1 0 0"));
  EXPECT_EQ(content(file), "0,0,0 1,0,0 0,1,0 | 0,1,2 2,1,0 2,0,0");
  EXPECT_EQ(file->polygon_of_face, (std::vector<std::uint32_t>{0, 1, 1}));
}

TEST(PlyFaces, MayStandBeforeTheVertices) {
  EXPECT_EQ(content(ply(ascii(kFaces + kVertices, "3 0 1 2 0 0 0 1 0 0 0 1 0"))), kTriangle);
  EXPECT_EQ(outcome(ply(ascii(kFaces + kVertices, "3 0 1 3 0 0 0 1 0 0 0 1 0"))),
            "index-out-of-range@10");
}

TEST(PlyHeader, EveryLineEndHoldsForTheWholeHeader) {
  const std::string header =
      "ply\nformat binary_little_endian 1.0\n" + kVertices + kFaces + "end_header\n";
  for (const std::string eol : {"\n", "\r\n", "\r"}) {
    std::string text;
    for (const char c : header) text += c == '\n' ? eol : std::string(1, c);
    EXPECT_EQ(content(ply(text + kDoubles + kList)), kTriangle);
    EXPECT_EQ(content(ply("\xEF\xBB\xBF" + text + kDoubles + kList)), kTriangle);
  }
  // With CR alone, a line feed behind end_header belongs to the body.
  std::string cr =
      "ply\nformat binary_little_endian 1.0\nelement vertex 10\nproperty char x\nproperty char y\n"
      "property char z\n" +
      kFaces + "end_header\n";
  for (char& c : cr) c = c == '\n' ? '\r' : c;
  const auto file = ply(cr + std::string(30, '\n') + kList);
  ASSERT_TRUE(file) << content(file);
  EXPECT_EQ(file->mesh.positions.size(), 1u);
  EXPECT_EQ(file->mesh.positions[0], (Vec3d{10, 10, 10}));
  // A line end of another kind is not one.
  EXPECT_EQ(outcome(ply("ply\nformat ascii 1.0\r\n" + kVertices + kFaces + "end_header\n0")),
            "syntax@2");
}

TEST(PlyHeader, EmptyLinesAreSkipped) {
  EXPECT_EQ(content(ply("ply\n\nformat ascii 1.0\n \t\n" + kVertices + kFaces +
                        "\nend_header\n0 0 0 1 0 0 0 1 0 3 0 1 2")),
            kTriangle);
}

TEST(PlyHeader, ScalarsAndListsOfOneNameAreDifferentProperties) {
  EXPECT_EQ(content(ply(ascii(kVertices + "property list uchar float x\n" + kFaces +
                                  "property int vertex_index\n",
                              "0 0 0 0  1 0 0 1 7  0 1 0 0  3 0 1 2 9"))),
            kTriangle);
}

TEST(PlyHeader, RefusesWhatIsNoHeader) {
  const auto with = [](const std::string& text) { return outcome(ply(text)); };
  EXPECT_EQ(with("plx\n"), "syntax@1");
  EXPECT_EQ(with("ply"), "syntax@1");
  EXPECT_EQ(with("ply \n"), "syntax@1");
  EXPECT_EQ(with("ply\n"), "truncated@2");
  EXPECT_EQ(with("ply\nend_header\n"), "syntax@2");
  EXPECT_EQ(with("ply\ncomment first\nformat ascii 1.0\n"), "syntax@2");
  EXPECT_EQ(with("ply\nformat ascii 1.1\n"), "syntax@2");
  EXPECT_EQ(with("ply\nformat text 1.0\n"), "syntax@2");
  EXPECT_EQ(with("ply\nformat ascii 1.0 x\n"), "syntax@2");
  EXPECT_EQ(with("ply\nformat ascii 1.0\nend_header"), "truncated@3");
  EXPECT_EQ(with("ply\nformat ascii 1.0\nend_header\n"), "syntax@3");
  const auto line = [&](const std::string& text) {
    return with("ply\nformat ascii 1.0\n" + text + "\nend_header\n");
  };
  EXPECT_EQ(line("nonsense"), "syntax@3");
  EXPECT_EQ(line("element vertex"), "syntax@3");
  EXPECT_EQ(line("element vertex x"), "syntax@3");
  EXPECT_EQ(line("element vertex -1"), "syntax@3");
  EXPECT_EQ(line("element vertex 3 3"), "syntax@3");
  EXPECT_EQ(line("property float x"), "syntax@3");
  EXPECT_EQ(line("element vertex 3\nproperty float"), "syntax@4");
  EXPECT_EQ(line("element vertex 3\nproperty half x"), "syntax@4");
  EXPECT_EQ(line("element vertex 3\nproperty list uchar x"), "syntax@4");
  EXPECT_EQ(line("element vertex 3\nproperty list uchar half x"), "syntax@4");
  EXPECT_EQ(line("element vertex 3\nproperty list float int x"), "syntax@4");
  EXPECT_EQ(line("format ascii 1.0"), "syntax@3");
}

TEST(PlyHeader, RefusesElementsThatAreNoMesh) {
  const auto with = [](const std::string& elements) {
    return outcome(ply(ascii(elements, "0 0 0 1 0 0 0 1 0 3 0 1 2 0 0 0 0 0 0 0")));
  };
  EXPECT_EQ(with(kVertices + kFaces), "ok");
  EXPECT_EQ(with("element e -1\nproperty int a\n" + kVertices + kFaces), "syntax@3");
  EXPECT_EQ(with(kVertices), "empty@7");
  EXPECT_EQ(with(kFaces), "syntax@5");
  EXPECT_EQ(with(kVertices + kVertices + kFaces), "syntax@7");
  EXPECT_EQ(with(kVertices + kFaces + kFaces), "syntax@9");
  EXPECT_EQ(with("element vertex 3\nproperty float x\nproperty float y\n" + kFaces), "syntax@3");
  EXPECT_EQ(
      with("element vertex 3\nproperty list uchar float x\nproperty float y\nproperty float z\n" +
           kFaces),
      "syntax@3");
  EXPECT_EQ(with("element vertex 3\nproperty float x\nproperty float x\nproperty float y\nproperty "
                 "float z\n" +
                 kFaces),
            "syntax@3");
  EXPECT_EQ(with(kVertices + "element face 1\nproperty int vertex_indices\n"), "syntax@7");
  EXPECT_EQ(with(kVertices + "element face 1\nproperty list uchar float vertex_indices\n"),
            "syntax@7");
  EXPECT_EQ(with(kVertices + "element face 1\nproperty int area\n"), "syntax@7");
  EXPECT_EQ(with(kVertices + "element face 1\nproperty list uchar int vertex_index\nproperty list "
                             "uchar int vertex_indices\n"),
            "syntax@7");
  EXPECT_EQ(with(kVertices + "element face 0\nproperty list uchar int vertex_index\n"), "empty@10");
}

TEST(PlyHeader, CountsAreComparedWithTheBytesLeft) {
  const auto with = [](const std::string& vertices, const std::string& faces, bool is_text) {
    const std::string elements =
        "element vertex " + vertices +
        "\nproperty double x\nproperty double y\nproperty double z\nelement face " + faces +
        "\nproperty list uchar int vertex_indices\n";
    return outcome(ply(is_text ? ascii(elements, "0 0 0 1 0 0 0 1 0 3 0 1 2")
                               : little(elements, kDoubles + kList)));
  };
  EXPECT_EQ(with("3", "1", true), "ok");
  EXPECT_EQ(with("3", "1", false), "ok");
  EXPECT_EQ(with("4000000000", "1", true), "truncated@3");
  EXPECT_EQ(with("4000000000", "1", false), "truncated@3");
  EXPECT_EQ(with("3", "4000000000", true), "truncated@7");
  EXPECT_EQ(with("3", "4000000000", false), "truncated@7");
  EXPECT_EQ(with("18446744073709551615", "1", true), "truncated@3");
  EXPECT_EQ(with("3", "18446744073709551614", false), "truncated@7");
  EXPECT_EQ(with("1000000000000000000000000000", "1", false), "truncated@3");
}

TEST(PlyReader, WhatFollowsTheLastElementIsNamed) {
  const std::string text = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string body = packed(0., 0., 0., 1., 0., 0., 0., 1., 0.) + "\3" + packed(0, 1, 2);
  const std::string more = "\3" + packed(2, 1, 0);
  EXPECT_EQ(io_test::notices(*ply(ascii(kVertices + kFaces, text + "3 2 1 0\n"))),
            "data-after-end: 8 more bytes follow the stated 1 of element face: the count may be "
            "wrong");
  EXPECT_EQ(io_test::notices(*ply(little(kVertices + kFaces, body + more))),
            "data-after-end: 13 more bytes follow the stated 1 of element face: the count may be "
            "wrong");
  EXPECT_EQ(io_test::notices(*ply(little(kVertices + kFaces, body + "x"))),
            "data-after-end: 1 more byte follows the stated 1 of element face: the count may be "
            "wrong");
  EXPECT_EQ(io_test::notices(*ply(ascii(kVertices + kFaces, text + " \n\n"))), "");
  EXPECT_EQ(io_test::notices(*ply(little(kVertices + kFaces, body))), "");
}

std::string normals_of(const Result<MeshFile>& file) {
  if (!file) return outcome(file);
  if (!file->normals) return "none";
  MeshFile shown;
  shown.mesh = {file->normals->values, file->normals->of_face};
  return content(Result<MeshFile>(std::move(shown)));
}

TEST(PlyReader, KeepsNormalsOnRequest) {
  ModelReadOptions with;
  with.with_normals = true;
  const std::string vertices =
      "element vertex 3\nproperty float nx\nproperty double x\nproperty double y\n"
      "property float ny\nproperty uchar red\nproperty double z\nproperty short nz\n";
  const std::string rows = "0.25 0 0 -1 7 0 3\n1 1 0 0 7 0 0\n0 0 1 1e3 7 0 -2\n3 2 0 1\n";
  const std::string want = "0.25,-1,3 1,0,0 0,1000,-2 | 2,0,1";
  EXPECT_EQ(normals_of(ply(ascii(vertices + kFaces, rows), with)), want);
  EXPECT_EQ(normals_of(ply(ascii(vertices + kFaces, rows))), "none");
  std::string body;
  const double xyz[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const float nxy[3][2] = {{0.25F, -1}, {1, 0}, {0, 1000}};
  const std::int16_t nz[3] = {3, 0, -2};
  for (int i = 0; i < 3; ++i)
    body += packed(nxy[i][0]) + packed(xyz[i][0]) + packed(xyz[i][1]) + packed(nxy[i][1]) +
            packed(std::uint8_t{7}) + packed(xyz[i][2]) + packed(nz[i]);
  body += packed(std::uint8_t{3}) + packed(std::int32_t{2}) + packed(std::int32_t{0}) +
          packed(std::int32_t{1});
  EXPECT_EQ(normals_of(ply(little(vertices + kFaces, body), with)), want);
  EXPECT_EQ(content(ply(little(vertices + kFaces, body), with)), "0,0,0 1,0,0 0,1,0 | 2,0,1");
}

TEST(PlyReader, HasNoNormalsWithoutAllThreeOfThem) {
  ModelReadOptions with;
  with.with_normals = true;
  const std::string two = kVertices + "property float nx\nproperty float ny\n";
  EXPECT_EQ(
      normals_of(ply(ascii(two + kFaces, "0 0 0 1 1\n1 0 0 1 1\n0 1 0 1 1\n3 0 1 2\n"), with)),
      "none");
  const std::string three = two + "property float nz\n";
  EXPECT_EQ(outcome(ply(ascii(three + kFaces, "0 0 0 1 1 1\n1 0 0 1 nan 1\n0 1 0 1 1 1\n3 0 1 2\n"),
                        with)),
            "not-finite@14");
  EXPECT_EQ(
      outcome(ply(ascii(three + kFaces, "0 0 0 1 1 1\n1 0 0 1 nan 1\n0 1 0 1 1 1\n3 0 1 2\n"))),
      "ok");
}

}  // namespace
}  // namespace veritope
