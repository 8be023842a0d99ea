// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/itd_polygons.h"

#include <gtest/gtest.h>

#include "io/formats.h"
#include "io/read_model.h"
#include "tests/io/io_test_util.h"

namespace veritope {
namespace {

Result<ModelFile> read(const std::string& text, ModelReadOptions options = {}) {
  return read_model_bytes({reinterpret_cast<const unsigned char*>(text.data()), text.size()},
                          "model.itd", options);
}
MeshFile mesh(const std::string& text, const ModelReadOptions& options = {}) {
  Result<ModelFile> file = read(text, options);
  EXPECT_TRUE(file) << to_string(file.error());
  return std::get<MeshFile>(std::move(*file));
}
std::string refusal(const std::string& text, const ModelReadOptions& options = {}) {
  const Result<ModelFile> file = read(text, options);
  return file ? "read" : to_string(file.error());
}

// A tetrahedron whose polygons turn clockwise as seen from outside, in nested objects, with what IRIT writes.
const std::string kTet = R"(a comment with a " and a ] in it
[OBJECT [COLOR 4] "the [whole]"
  [OBJECT VIEW [MATRIX 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1]]
  [OBJECT TET
    [POLYGON [PLANE 0 0 1 0] 3
      [[RGB "0,[0,255"] 0 0 0] [[INTERNAL] [NORMAL 0 0 1] 1 0 0] [0 1 0]]
    [POLYGON 3 [0 0 0] [0 0 1] [1 0 0.0]]
    [POLYGON 3 [-0.0 0 0] [0 1 0] [0 0 1]]
    [POLYGON 3 [1 0 0] [0 0 1] [0 1 0]]]
])";

TEST(ItdPolygons, AreAMeshThatTurnsTheOtherWay) {
  const MeshFile file = mesh(kTet);
  ASSERT_EQ(file.mesh.faces.size(), 4u);
  EXPECT_EQ(file.mesh.positions.size(), 4u);  // equal corners are one vertex, -0 equals 0
  EXPECT_EQ(file.mesh.faces[0], (std::array<std::uint32_t, 3>{0, 2, 1}));
  EXPECT_EQ(file.mesh.positions[1], (Vec3d{1, 0, 0}));
  EXPECT_EQ(file.report.container, "itd");
  EXPECT_EQ(file.report.variant, "itd");
  EXPECT_EQ(file.report.bytes, kTet.size());
  EXPECT_EQ(model_format(format_of(ModelFile(file))).name, std::string("itd"));
  using Ignored = std::vector<std::pair<std::string, std::uint64_t>>;
  EXPECT_EQ(
      file.report.ignored,
      (Ignored{{"attributes of polygons", 1}, {"attributes of vertices", 3}, {"matrices", 1}}));
}

TEST(ItdPolygons, TheCopyIsAnOffFileWithTheSameMesh) {
  const MeshFile file = mesh(kTet);
  ASSERT_TRUE(file.copy);
  EXPECT_EQ(file.copy->what, "its 4 polygons");
  EXPECT_EQ(file.copy->bytes,
            "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  const auto copy = io_test::read(MeshFormat::kOff, file.copy->bytes);
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->mesh.faces, file.mesh.faces);
  EXPECT_EQ(copy->mesh.positions, file.mesh.positions);
  EXPECT_EQ(copy->sha256, file.copy->sha256);
  EXPECT_NE(file.sha256, file.copy->sha256);
}

TEST(ItdPolygons, LargerOnesAreFansFromTheirFirstCorner) {
  const MeshFile file = mesh(
      "[OBJECT A [POLYGON 3 [9 9 9] [8 9 9] [9 8 9]] [POLYGON 5 [0 0 0] [1 0 0] [2 1 0] [1 2 0] [0 "
      "1 0]]]");
  ASSERT_EQ(file.mesh.faces.size(), 4u);
  const auto x = [&](std::size_t f, std::size_t k) {
    return file.mesh.positions[file.mesh.faces[f][k]];
  };
  EXPECT_EQ(x(1, 0), (Vec3d{0, 0, 0}));
  EXPECT_EQ(x(1, 1), (Vec3d{0, 1, 0}));
  EXPECT_EQ(x(1, 2), (Vec3d{1, 2, 0}));
  EXPECT_EQ(x(3, 0), (Vec3d{0, 0, 0}));
  EXPECT_EQ(x(3, 2), (Vec3d{1, 0, 0}));
  EXPECT_EQ(file.report.polygons_split, 1u);
  EXPECT_EQ(file.polygon_of_face, (std::vector<std::uint32_t>{0, 1, 1, 1}));
}

TEST(ItdPolygons, CoordinatesAreTheNearestBinary64AndSurviveTheCopy) {
  const MeshFile file = mesh(
      "[OBJECT A [POLYGON 3 [0.1 1e-320 -1.7976931348623157e308] [3.3333333333333333333333 0 0] [0 "
      "1e22 0]]]");
  EXPECT_EQ(file.mesh.positions[0], (Vec3d{0.1, 1e-320, -1.7976931348623157e308}));
  EXPECT_EQ(file.mesh.positions[1].x, 3.3333333333333333333333);
  EXPECT_EQ(file.mesh.positions[2].y, 1e22);
}

TEST(ItdPolygons, PolylinesAndPointsAreIgnoredAndOtherShapesAreNot) {
  const std::string polygon = "[POLYGON 3 [0 0 0] [1 0 0] [0 1 0]]";
  const MeshFile file =
      mesh("[OBJECT A " + polygon + " [POLYLINE 2 [0 0 0] [1 1 1]] [POINTLIST 1 [5 5 5]]]");
  EXPECT_EQ(file.mesh.faces.size(), 1u);
  EXPECT_EQ(file.mesh.positions.size(), 3u);
  EXPECT_EQ(file.report.ignored[0], (std::pair<std::string, std::uint64_t>{"polylines", 1}));
  EXPECT_EQ(file.report.ignored[1], (std::pair<std::string, std::uint64_t>{"point lists", 1}));
  const std::string curve = "[CURVE BEZIER 2 E3 [0 0 0] [1 0 0]]";
  for (const std::string& other :
       {curve, std::string("[INSTANCE B]"), std::string("[POLYSTRIP 3 [0 0 0] [1 0 0] [0 1 0]]")}) {
    const auto both = read("[OBJECT A " + polygon + other + "]");
    ASSERT_TRUE(both) << to_string(both.error());
    EXPECT_TRUE(std::holds_alternative<SplineFile>(*both)) << other;
  }
  EXPECT_TRUE(std::holds_alternative<SplineFile>(*read("[OBJECT A [POLYLINE 2 [0 0 0] [1 1 1]]]")));
}

TEST(ItdPolygons, AreLeftOutWhereSplinesAreRequired) {
  const auto file = read_spline_bytes(
      {reinterpret_cast<const unsigned char*>(kTet.data()), kTet.size()}, "model.itd", {});
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->model.entities.empty());
}

TEST(ItdPolygons, ErrorsNameTheLineAndTheValue) {
  const auto of = [](const std::string& polygon) {
    return refusal("[OBJECT A\n" + polygon + "\n]");
  };
  EXPECT_EQ(of("[POLYGON 2 [0 0 0] [1 0 0]]"), "model.itd: line 2: a polygon with 2 corners");
  EXPECT_NE(of("[POLYGON 3 [0 0 0] [1 0 0] [0 x 0]]")
                .find("line 2: a decimal number expected, but there is 'x'"),
            std::string::npos)
      << of("[POLYGON 3 [0 0 0] [1 0 0] [0 x 0]]");
  EXPECT_NE(of("[POLYGON 3 [0 0 0] [1 0 0] [0 1e999 0]]").find("'1e999' is not finite"),
            std::string::npos);
  EXPECT_NE(
      of("[POLYGON 3 [0 0 0] [1 0 0] [0 1]]").find("a decimal number expected, but there is ']'"),
      std::string::npos);
  EXPECT_NE(of("[POLYGON 3 [0 0 0] [1 0 0] [0 1 0 1]]").find("']' expected"), std::string::npos);
  EXPECT_NE(of("[POLYGON 4 [0 0 0] [1 0 0] [0 1 0]]").find("'[' expected, but there is ']'"),
            std::string::npos);
  EXPECT_NE(of("[POLYGON x [0 0 0] [1 0 0] [0 1 0]]").find("a number of corners"),
            std::string::npos);
  EXPECT_NE(of("[POLYGON 99999999999 [0 0 0]]").find("a number of corners must be from 0 to"),
            std::string::npos);
  ModelReadOptions few;
  few.limits.max_faces = 3;
  EXPECT_NE(refusal(kTet, few).find("--max-faces 3"), std::string::npos);
  few.limits.max_faces = 4;
  EXPECT_EQ(refusal(kTet, few), "read");
  few.limits.max_digits = 2;
  EXPECT_NE(
      refusal("[OBJECT A [POLYGON 3 [0 0 0] [1 0 0] [0 0.123 0]]]", few).find("--max-digits 2"),
      std::string::npos);
}

}  // namespace
}  // namespace veritope
