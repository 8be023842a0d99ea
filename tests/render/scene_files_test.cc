// SPDX-License-Identifier: LGPL-3.0-or-later
// Scenes as PLY, VTU and glTF. What viewers read is tested by tests/cli/picture_test.py, with parsers of their own.
#include "render/scene_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "io/read_model.h"
#include "render/solid_marks.h"
#include "solids/polyhedron/validity.h"
#include "tests/render/picture_test_util.h"

namespace veritope {
namespace {

using namespace picture_test;

Scene scene_of_a_box() {
  Scene out;
  out.surfaces = {box_surface({0, 0, 0}, {400, 200, 100}, {kGrey, 170})};
  out.surfaces[0].name = "model";
  out.lines = {{{{0, 0, 0}, {400, 0, 0}, {400, 200, 100}}, kRed}, {{{1, 2, 3}}, kBlue}};
  out.markers = {{{10, 20, 30}, kRed}, {{400, 200, 100}, {1, 2, 3}}};
  out.legend = {{kBlue, "points"}, {kRed, "lines"}};
  return out;
}
TriangleMesh mesh_of(const SceneSurface& surface) {
  TriangleMesh out;
  for (const Point3d& p : surface.points) out.positions.push_back({p[0], p[1], p[2]});
  out.faces = surface.triangles;
  return out;
}

TEST(SolidMarks, AreClosedSolidsByTheLegendWithItsNames) {
  const auto surfaces = with_solid_marks(scene_of_a_box());
  ASSERT_EQ(surfaces.size(), 4u);
  EXPECT_EQ(surfaces[0].name, "model");
  EXPECT_EQ(surfaces[1].name, "points");
  EXPECT_EQ(surfaces[2].name, "lines");
  EXPECT_EQ(surfaces[3].name, "marks");
  EXPECT_EQ(surfaces[2].paints, (std::vector<Paint>{{kRed, 255}}));
  EXPECT_EQ(surfaces[1].triangles.size(), 8u);            // a line of one point
  EXPECT_EQ(surfaces[2].triangles.size(), 2 * 24u + 8u);  // two tubes and an octahedron
  EXPECT_EQ(surfaces[3].triangles.size(), 8u);
  Scene tube;
  tube.lines = {{{{0, 0, 0}, {1, 2, 5}}, kRed}};
  for (const SceneSurface& surface : {surfaces[1], surfaces[3], with_solid_marks(tube)[0]}) {
    const ValidityReport r = decide_validity(mesh_of(surface), {1, 20});
    EXPECT_TRUE(r.is_valid) << surface.name;
    EXPECT_EQ(r.counts.bodies, 1u);
  }
}

TEST(SolidMarks, HaveRadiiRelativeToTheModel) {
  const auto surfaces = with_solid_marks(scene_of_a_box());
  for (const Point3d& p : surfaces[2].points) {
    // From the lines, or from the marker at (10, 20, 30).
    const double from_line = std::hypot(p[1], p[2]),
                 from_marker = std::hypot(p[0] - 10, p[1] - 20, p[2] - 30);
    const double t = std::clamp((p[1] * 200 + p[2] * 100) / 50000, 0.0, 1.0);
    const double from_other = std::hypot(p[0] - 400, p[1] - 200 * t, p[2] - 100 * t);
    EXPECT_LE(std::min({from_line, from_other, from_marker - 1.5}),
              400 * kTubeRadius * (1 + 1e-12));
  }
  EXPECT_DOUBLE_EQ(kTubeRadius * 400, 1);
  EXPECT_DOUBLE_EQ(kOctahedronRadius * 400, 2.5);
}

// The sides of a tube whose ends have the same coordinates in binary32 would have no area in a glTF.
TEST(SolidMarks, OfLinesThatAreTooShortForBinary32AreOctahedra) {
  Scene scene = scene_of_a_box();
  scene.markers.clear();
  for (const auto& [length, num_triangles] : {std::pair{1e-9, 8u}, {3e-4, 8u}, {5e-4, 24u}}) {
    scene.lines = {{{{100, 100, 100}, {100, 100 + length, 100}}, kRed}};
    const auto surfaces = with_solid_marks(scene);
    ASSERT_EQ(surfaces.size(), 2u);
    EXPECT_EQ(surfaces[1].triangles.size(), num_triangles) << length;
    for (const auto& triangle : surfaces[1].triangles) {
      std::set<std::array<float, 3>> corners;
      for (const std::uint32_t i : triangle) {
        const Point3d& p = surfaces[1].points[i];
        corners.insert(
            {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])});
      }
      EXPECT_EQ(corners.size(), 3u) << length;
    }
  }
}

TEST(SolidMarks, StayFiniteEverywhere) {
  constexpr double kMost = 1.7976931348623157e308;
  for (const double size : {5e-324, 1e-300, 1e300, kMost}) {
    Scene scene;
    scene.surfaces = {box_surface({-size, -size, -size}, {size, size, size}, {kGrey, 255})};
    scene.lines = {{{{-size, size, -size}, {size, size, size}}, kRed},
                   {{{size, 0, 0}, {size, 0, 0}}, kRed}};
    scene.markers = {{{size, size, size}, kBlue}};
    for (const SceneSurface& surface : with_solid_marks(scene))
      for (const Point3d& p : surface.points)
        for (const double x : p) EXPECT_TRUE(std::isfinite(x)) << size;
  }
  Scene dot;
  dot.markers = {{{3, 4, 5}, kRed}};
  EXPECT_EQ(approx_scene_size(dot), 1);
}

TEST(SceneFiles, PartsAreThoseOfEqualPaints) {
  SceneSurface surface = box_surface({0, 0, 0}, {1, 1, 1}, {});
  surface.name = "model";
  surface.paints.assign(12, {kGrey, 170});
  surface.paints[3] = surface.paints[7] = {kBlue, 170};
  const auto parts = parts_of(surface, {{kRed, "M7", Paint{kBlue, 170}}});
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].triangles.size(), 10u);
  EXPECT_EQ(parts[1].triangles, (std::vector{surface.triangles[3], surface.triangles[7]}));
  EXPECT_EQ(parts[0].name, "model");
  EXPECT_EQ(parts[1].name, "model: M7");
}

TEST(SceneFiles, APlyReadsBackAsTheSurfacesAndMarks) {
  const Scene scene = scene_of_a_box();
  const std::string bytes = scene_ply(scene).value();
  EXPECT_NE(bytes.find("comment colour 213 94 0: lines\n"), bytes.npos);
  const ModelFile file =
      read_model_bytes({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()},
                       "p.ply", {})
          .value();
  const TriangleMesh& mesh = std::get<MeshFile>(file).mesh;
  EXPECT_EQ(mesh.faces.size(), 12u + 2 * 24 + 3 * 8);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(to_point(mesh.positions[i]), scene.surfaces[0].points[i]);
}

TEST(SceneFiles, OfNothingAreRefused) {
  Scene scene;
  scene.surfaces.push_back({{{1, 2, 3}}, {}, {{}}});
  EXPECT_EQ(scene_ply(scene).error().code, Code::kEmpty);
  EXPECT_EQ(scene_vtu(scene).error().code, Code::kEmpty);
  EXPECT_EQ(scene_gltf(scene).error().code, Code::kEmpty);
}

TEST(SceneFiles, GltfsAreRefusedWhereBinary32WouldFalsifyThem) {
  for (const double size : {1e-40, 1e40}) {
    Scene scene;
    scene.surfaces = {box_surface({0, 0, 0}, {size, size, size}, {kGrey, 255})};
    EXPECT_EQ(scene_gltf(scene).error().code, Code::kNotFinite) << size;
    EXPECT_TRUE(scene_ply(scene) && scene_vtu(scene)) << size;
  }
  Scene
      far;  // 1/1000 at 10^9: binary32 has no such steps there, but the coordinates are relative to the middle
  far.surfaces = {box_surface({1e9, 0, 0}, {1e9 + 0.001, 0.001, 0.001}, {kGrey, 255})};
  EXPECT_NE(scene_gltf(far).value().find("\"translation\":[1000000000.0005"), std::string::npos);
}

// Points that no triangle uses may be anywhere.
TEST(SceneFiles, UnusedPointsDoNotSpoilBoxes) {
  SceneSurface surface = box_surface({0, 0, 0}, {1, 1, 1}, {kGrey, 255});
  surface.points.insert(surface.points.begin() + 3, {1e300, 0, 0});
  for (auto& t : surface.triangles)
    for (std::uint32_t& i : t) i += i >= 3 ? 1 : 0;
  const SceneSurface lean = without_unused_points(surface);
  EXPECT_EQ(lean.points, box_surface({0, 0, 0}, {1, 1, 1}, {}).points);
  EXPECT_EQ(lean.triangles, box_surface({0, 0, 0}, {1, 1, 1}, {}).triangles);
  Scene scene;
  scene.surfaces = {surface};
  EXPECT_EQ(scene_gltf(scene).value().find("e+300"), std::string::npos);
  EXPECT_EQ(scene_vtu(scene).value().find("e+300"), std::string::npos);
}

}  // namespace
}  // namespace veritope
