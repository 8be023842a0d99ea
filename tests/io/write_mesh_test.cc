// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/mesh/write_mesh.h"

#include <fcntl.h>

#include <cmath>
#include <limits>

#include "render/coloured_ply.h"
#include "robust/base/check.h"
#include "tests/io/io_test_util.h"

namespace veritope {
namespace {

using io_test::content;
using io_test::TempFolder;

TriangleMesh triangle() { return {{{0, 0, 0}, {1, 0, 0}, {0, 0.1, 0}}, {{{0, 1, 2}}}}; }

WriteOptions options(const char* variant) { return write_options_from_name(variant).value(); }

std::string text_of(const TriangleMesh& mesh, const char* variant) {
  return mesh_to_bytes(mesh, options(variant)).value();
}

TEST(WriteMesh, WritesTheShortestDecimals) {
  EXPECT_EQ(text_of(triangle(), "obj"), "v 0 0 0\nv 1 0 0\nv 0 0.1 0\nf 1 2 3\n");
  EXPECT_EQ(text_of(triangle(), "off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 0.1 0\n3 0 1 2\n");
  EXPECT_EQ(text_of(triangle(), "ply-ascii"),
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double "
            "y\nproperty double z\n"
            "element face 1\nproperty list uchar uint vertex_indices\nend_header\n0 0 0\n1 0 0\n0 "
            "0.1 0\n3 0 1 2\n");
  EXPECT_EQ(text_of(triangle(), "stl-ascii"),
            "solid veritope\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 "
            "0.1 0\nendloop\n"
            "endfacet\nendsolid veritope\n");
}

TEST(WriteMesh, EveryVariantReadsBackAsItsFormat) {
  for (const std::string& name : write_variant_names()) {
    const WriteOptions how = options(name.c_str());
    const std::string bytes = mesh_to_bytes(triangle(), how).value();
    const auto file = read_mesh_bytes(io_test::bytes(bytes), "unnamed", {});
    ASSERT_TRUE(file) << name << content(file);
    EXPECT_EQ(file->report.format, how.format);
    EXPECT_TRUE(name.starts_with(file->report.variant)) << name;
    EXPECT_EQ(file->mesh.faces, triangle().faces);
    EXPECT_EQ(file->mesh.positions[2].y, loss_of(triangle(), how).coordinates_change ? 0.1f : 0.1)
        << name;
  }
  EXPECT_EQ(write_variant_names().size(), 9u);
  EXPECT_FALSE(write_options_from_name("ply").has_value());
}

TEST(WriteMesh, DefaultsKeepTheCoordinates) {
  for (const MeshFormat format :
       {MeshFormat::kStl, MeshFormat::kObj, MeshFormat::kPly, MeshFormat::kOff}) {
    EXPECT_FALSE(loss_of(triangle(), default_write_options(format)).coordinates_change);
    EXPECT_TRUE(mesh_to_bytes(triangle(), default_write_options(format)));
  }
}

TEST(WriteMesh, RefusesCombinationsThatDoNotExist) {
  for (const WriteOptions& wrong :
       {WriteOptions{MeshFormat::kObj, MeshEncoding::kLittleEndian, false},
        WriteOptions{MeshFormat::kOff, MeshEncoding::kBigEndian, false},
        WriteOptions{MeshFormat::kStl, MeshEncoding::kBigEndian, false},
        WriteOptions{MeshFormat::kPly, MeshEncoding::kAscii, true},
        WriteOptions{MeshFormat::kStl, MeshEncoding::kAscii, true}}) {
    const auto bytes = mesh_to_bytes(triangle(), wrong);
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().code, Code::kBadArgument);
  }
  EXPECT_TRUE(mesh_to_bytes(triangle(), {MeshFormat::kStl, MeshEncoding::kLittleEndian, true}));
}

TEST(WriteMesh, RefusesACoordinateTooLargeForFloatWithItsVertex) {
  TriangleMesh mesh = triangle();
  mesh.positions[1].x = 0x1.ffffffp127;  // half an ulp above the largest: a tie that rounds up
  for (const char* variant :
       {"stl-binary", "ply-binary-little-endian-float", "ply-binary-big-endian-float"}) {
    const auto bytes = mesh_to_bytes(mesh, options(variant));
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().code, Code::kNotFinite);
    EXPECT_EQ(bytes.error().place.vertex, 1u);
    EXPECT_EQ(loss_of(mesh, options(variant)).max_displacement, HUGE_VAL);
    EXPECT_EQ(loss_of(mesh, options(variant)).vertex, 1u);
  }
  EXPECT_TRUE(mesh_to_bytes(mesh, options("ply-binary-little-endian")));
  mesh.positions[1].x = std::nextafter(0x1.ffffffp127, 0);
  EXPECT_TRUE(mesh_to_bytes(mesh, options("stl-binary")));
}

TEST(WriteMesh, NormalsOfExtremeFacetsAreZeroOrOfUnitLength) {
  TriangleMesh mesh{{{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}, {1e-300, 0, 0}},
                    {{{0, 1, 2}}, {{0, 3, 3}}, {{1, 2, 3}}}};
  const std::string text = text_of(mesh, "stl-ascii");
  EXPECT_EQ(text.find("nan"), text.npos);
  EXPECT_EQ(text.find("inf"), text.npos);
}

TEST(WriteMeshFile, WritesTheFileAndNothingElse) {
  const TempFolder folder;
  EXPECT_TRUE(write_mesh_file(folder / "a.off", triangle(), options("off")));
  EXPECT_EQ(io_test::slurp(folder / "a.off"), text_of(triangle(), "off"));
  EXPECT_EQ(folder.list(), "a.off ");
  const auto refused = write_mesh_file(folder / "none/a.off", triangle(), options("off"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::kCannotWrite);
  EXPECT_EQ(refused.error().place.file, folder / "none/a.off");
}

TEST(WriteMeshFile, LeavesTheOldFileWhenTheMeshCannotBeWritten) {
  const TempFolder folder;
  folder.write("a.stl", "old");
  TriangleMesh mesh = triangle();
  mesh.positions[0].z = 1e200;
  EXPECT_FALSE(write_mesh_file(folder / "a.stl", mesh, options("stl-binary")));
  EXPECT_EQ(io_test::slurp(folder / "a.stl"), "old");
}

TEST(WriteMeshFile, WritesStandardOutput) {
  const TempFolder folder;
  const int saved = ::dup(STDOUT_FILENO);
  const int target = ::open((folder / "out").c_str(), O_WRONLY | O_CREAT, 0600);
  ::dup2(target, STDOUT_FILENO);
  const bool is_written = write_mesh_file("-", triangle(), options("obj")).has_value();
  ::close(STDOUT_FILENO);
  const Status refused = write_mesh_file("-", triangle(), options("obj"));
  ::dup2(saved, STDOUT_FILENO);
  ::close(saved);
  ::close(target);
  EXPECT_TRUE(is_written);
  EXPECT_EQ(io_test::slurp(folder / "out"), text_of(triangle(), "obj"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::kCannotWrite);
}

TEST(LossOf, ALosslessFileLosesNothing) {
  for (const char* variant :
       {"obj", "off", "ply-ascii", "ply-binary-little-endian", "ply-binary-big-endian"}) {
    const LossReport loss = loss_of(triangle(), options(variant));
    EXPECT_TRUE(loss.is_lossless()) << variant;
    EXPECT_EQ(loss.max_displacement, 0);
  }
  EXPECT_TRUE(loss_of(triangle(), options("stl-ascii")).is_lossless());
}

TEST(LossOf, StlLosesTheOrderOfVerticesAndUnreferencedOnes) {
  TriangleMesh turned = triangle();
  turned.faces = {{1, 2, 0}};
  EXPECT_TRUE(loss_of(turned, options("stl-ascii")).indexing_changes);
  EXPECT_FALSE(loss_of(turned, options("stl-ascii")).coordinates_change);
  EXPECT_FALSE(loss_of(turned, options("obj")).indexing_changes);
  TriangleMesh more = triangle();
  more.positions.push_back({7, 7, 7});
  EXPECT_TRUE(loss_of(more, options("stl-ascii")).indexing_changes);
  TriangleMesh twice = triangle();
  twice.positions[1] = {0, 0, 0};
  EXPECT_TRUE(loss_of(twice, options("stl-ascii")).indexing_changes);
}

TEST(LossOf, RoundingIsMeasuredExactlyAndRoundedUp) {
  TriangleMesh mesh = triangle();
  const LossReport loss = loss_of(mesh, options("stl-binary"));
  EXPECT_TRUE(loss.coordinates_change);
  EXPECT_EQ(loss.moved_vertices, 1u);
  EXPECT_EQ(loss.max_displacement, 0.1f - 0.1);
  EXPECT_EQ(loss.vertex, 2u);
  // 3-4-5: the displacement is exactly 5 * 2^-30.
  mesh.positions[0] = {1 + 3 * 0x1p-30, 1 + 4 * 0x1p-30, 0};
  mesh.positions[2].y = 0.5;
  EXPECT_EQ(loss_of(mesh, options("stl-binary")).max_displacement, 5 * 0x1p-30);
  // sqrt(2) 2^-30 is irrational: the next number above it.
  mesh.positions[0] = {1 + 0x1p-30, 1 + 0x1p-30, 0};
  const double up = loss_of(mesh, options("stl-binary")).max_displacement;
  EXPECT_EQ(up, 0x1.6a09e667f3bcdp0 * 0x1p-30);
  EXPECT_EQ(loss_of(mesh, options("ply-binary-big-endian-float")).max_displacement, up);
}

TEST(LossOf, OfEqualDisplacementsTheLowestVertexIsNamed) {
  TriangleMesh mesh = triangle();
  mesh.positions = {{0, 0, 0}, {1 + 0x1p-30, 0, 0}, {0, 1 + 0x1p-30, 0}, {1 + 0x1p-31, 0, 5}};
  const LossReport loss = loss_of(mesh, options("stl-binary"));
  EXPECT_EQ(loss.vertex, 1u);
  EXPECT_EQ(loss.moved_vertices, 3u);
}

TEST(ColouredPly, IsTheMeshWithAColourAFace) {
  TriangleMesh mesh = triangle();
  mesh.faces.push_back({0, 2, 1});
  const std::string bytes = coloured_ply(mesh, std::vector<Colour>{{1, 2, 3}, {255, 254, 253}});
  const auto file = io_test::read(MeshFormat::kPly, bytes);
  EXPECT_EQ(
      content(file),
      content(io_test::read(MeshFormat::kPly, mesh_to_bytes(mesh, options("ply-ascii")).value())));
  EXPECT_EQ(io_test::ignored(*file, "property face.green"), 2u);
  EXPECT_EQ(bytes.substr(bytes.size() - 3), "\xff\xfe\xfd");
  EXPECT_THROW(coloured_ply(mesh, std::vector<Colour>(1)), InternalError);
}

TEST(LossOf, SubnormalDisplacementsAreExact) {
  TriangleMesh mesh = triangle();
  mesh.positions[0] = {5e-324, 0, 0};
  mesh.positions[2].y = 0.5;
  EXPECT_EQ(loss_of(mesh, options("stl-binary")).max_displacement, 5e-324);
  mesh.positions[0] = {5e-324, 5e-324, 0};
  EXPECT_EQ(loss_of(mesh, options("stl-binary")).max_displacement, 1e-323);
}

TEST(LossOf, CountsPositionsThatBecomeEqual) {
  TriangleMesh mesh = triangle();
  mesh.positions = {{1, 0, 0}, {1 + 0x1p-40, 0, 0}, {0, 1, 0}};
  const LossReport loss = loss_of(mesh, options("ply-binary-little-endian-float"));
  EXPECT_EQ(loss.merged_vertices, 1u);
  EXPECT_TRUE(loss.indexing_changes);
  EXPECT_TRUE(loss_of(mesh, options("stl-binary")).indexing_changes);
}

}  // namespace
}  // namespace veritope
