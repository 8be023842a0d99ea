// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/defect_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "io/splines/boundary_faces.h"
#include "render/draw_scene.h"
#include "render/rule_colour.h"
#include "splines/de_boor.h"
#include "tests/support/paths.h"
#include "verify/certify/certify_file.h"

namespace veritope {
namespace {

std::size_t count_pixels(Scene scene, Colour colour) {
  scene.legend.clear();
  scene.title.clear();
  const Image image = draw_scene(scene, {}).value();
  return static_cast<std::size_t>(std::count(image.pixels.begin(), image.pixels.end(), colour));
}

constexpr std::size_t kSquareOf12 = 144;

// A sphere of triangles around the origin: its apex is vertex 0.
TriangleMesh sphere() {
  constexpr std::uint32_t kTurns = 40, kRings = 30;
  const double pi = std::acos(-1.0);
  TriangleMesh out;
  out.positions.push_back({0, 0, 1});
  for (std::uint32_t r = 1; r < kRings; ++r)
    for (std::uint32_t t = 0; t < kTurns; ++t) {
      const double polar = pi * r / kRings, turn = 2 * pi * t / kTurns;
      out.positions.push_back(
          {std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)});
    }
  out.positions.push_back({0, 0, -1});
  const auto at = [](std::uint32_t r, std::uint32_t t) {
    return 1 + (r - 1) * kTurns + t % kTurns;
  };
  const auto last = static_cast<std::uint32_t>(out.positions.size() - 1);
  for (std::uint32_t t = 0; t < kTurns; ++t) {
    out.faces.push_back({0, at(1, t), at(1, t + 1)});
    for (std::uint32_t r = 1; r + 1 < kRings; ++r) {
      out.faces.push_back({at(r, t), at(r + 1, t), at(r + 1, t + 1)});
      out.faces.push_back({at(r, t), at(r + 1, t + 1), at(r, t + 1)});
    }
    out.faces.push_back({at(kRings - 1, t), last, at(kRings - 1, t + 1)});
  }
  return out;
}

void expect_visible(const TriangleMesh& mesh, MeshRule rule, const char* name) {
  const ValidityReport report = decide_validity(mesh, {1, 1000});
  ASSERT_GT(report.rule_counts[rule_index(rule)], 0u) << name;
  const std::vector<Finding> defects = list_defects(mesh, report).defects;
  EXPECT_GE(count_pixels(defect_scene(mesh, defects, report.rule_counts), colour_of(rule)),
            kSquareOf12)
      << name;
}

TEST(DefectScene, ShowsACrackOfOneUlp) {
  TriangleMesh mesh = sphere();
  Vec3d moved = mesh.positions[mesh.faces[700][0]];
  moved.x = std::nextafter(moved.x, 2);
  mesh.positions.push_back(moved);
  mesh.faces[700][0] = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  expect_visible(mesh, MeshRule::kM3, "a crack");
}

TEST(DefectScene, ShowsAHole) {
  TriangleMesh mesh = sphere();
  mesh.faces.erase(mesh.faces.begin() + 900);
  expect_visible(mesh, MeshRule::kM3, "a hole");
}

TEST(DefectScene, ShowsCrossingsOfATinyBody) {
  TriangleMesh mesh = sphere();
  const auto& f = mesh.faces[300];
  const auto n = static_cast<std::uint32_t>(mesh.positions.size());
  const auto middle = [&](double Vec3d::*c) {
    return (mesh.positions[f[0]].*c + mesh.positions[f[1]].*c + mesh.positions[f[2]].*c) / 3;
  };
  const Vec3d m{middle(&Vec3d::x), middle(&Vec3d::y), middle(&Vec3d::z)};
  for (const auto& [x, y, z] : {std::array{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}})
    mesh.positions.push_back({m.x + 1e-6 * x, m.y + 1e-6 * y, m.z + 1e-6 * z});
  for (const auto& [a, b, c] : {std::array{0u, 2u, 1u}, {0u, 1u, 3u}, {0u, 3u, 2u}, {1u, 2u, 3u}})
    mesh.faces.push_back({n + a, n + b, n + c});
  expect_visible(mesh, MeshRule::kM7, "a tiny tetrahedron");
}

TEST(DefectScene, ShowsASelfTouchingVertex) {
  TriangleMesh mesh = sphere();
  const auto n = static_cast<std::uint32_t>(mesh.positions.size());
  for (const auto& [x, y] : {std::array{1, 0}, {-1, 1}, {-1, -1}})
    mesh.positions.push_back({x / 1e4, y / 1e4, 1.001});
  for (const auto& [a, b, c] :
       {std::array{0u, n + 1, n}, {0u, n + 2, n + 1}, {0u, n, n + 2}, {n, n + 1, n + 2}})
    mesh.faces.push_back({a, b, c});
  expect_visible(mesh, MeshRule::kM6, "a self-touching vertex");
}

TEST(DefectScene, ShowsTheSmallestModelOfEveryRule) {
  for (std::size_t i = 0; i < kNumMeshRules; ++i) {
    const std::string name = "m" + std::to_string(i + 1) + "_smallest.off";
    const ModelFile file =
        read_model_file(test::source_dir() + "/tests/models/" + name, {}).value();
    expect_visible(std::get<MeshFile>(file).mesh, rule_at(i), name.c_str());
  }
}

TEST(DefectScene, ShowsWhatIsWrongWithPatches) {
  for (const auto& [name, rule] : {std::pair{"side_open_smallest.itd", MeshRule::kM3},
                                   {"side_open_crack.itd", MeshRule::kM3},
                                   {"side_overused_smallest.itd", MeshRule::kM4},
                                   {"side_direction_smallest.itd", MeshRule::kM5},
                                   {"patches_crossing_smallest.itd", MeshRule::kM7},
                                   {"patches_touching_smallest.itd", MeshRule::kM7},
                                   {"shell_turned_smallest.itd", MeshRule::kM9},
                                   {"patch_repeated_smallest.itd", MeshRule::kM2},
                                   {"singular_line_smallest.itd", MeshRule::kM2}}) {
    const ModelFile file =
        read_model_file(test::source_dir() + "/tests/models/patches/" + name, {}).value();
    const Certified found = certify(file).value();
    ASSERT_EQ(found.verdict, Verdict::kInvalid) << name;
    const PatchFacts& facts = std::get<PatchFacts>(found.facts);
    std::vector<EntityPart> sides;
    for (const OpenSideFacts& side : facts.open_sides) sides.push_back(side.part);
    const Scene scene =
        defect_scene(std::get<SplineFile>(file).model, found.findings, sides, facts.open.sides)
            .value();
    EXPECT_GE(scene.lines.size(), facts.open_sides.size()) << name;
    EXPECT_FALSE(scene.legend.empty()) << name;
    EXPECT_GE(count_pixels(scene, colour_of(rule)), kSquareOf12) << name;
  }
}

// Parts of volumes are drawn where the volume has them, on its boundary faces without the wall.
TEST(DefectScene, ShowsPartsOfVolumes) {
  const SplineFile file = std::get<SplineFile>(
      read_model_file(test::source_dir() + "/tests/models/splines/two_cubes.mesh", {}).value());
  const BoundaryFaces faces = boundary_faces(file.model).value();
  const auto& volume = std::get<ExactVolume>(file.model.entities[1].shape);
  EntityPart edge{1, std::nullopt, {}, std::uint8_t{5}};
  std::array<Rational, 3> from, to;
  for (std::size_t k = 0; k < 3; ++k) {
    from[k] = k == 0 ? volume.axis(k).domain_begin() : volume.axis(k).domain_end();
    to[k] = volume.axis(k).domain_end();
    edge.parameters.push_back({nearest_double(from[k]), nearest_double(to[k])});
  }
  Finding finding;
  finding.code = "side-overused";
  finding.place.parts = {edge};
  const Scene scene =
      defect_scene(file.model, std::vector{finding}, std::vector{edge}, 1, &faces).value();
  EXPECT_EQ(scene.surfaces.size(), 10u);
  ASSERT_EQ(scene.lines.size(), 1u);
  for (const auto& [at, p] : {std::pair{from, scene.lines[0].points.front()},
                              std::pair{to, scene.lines[0].points.back()}}) {
    const auto exact = point(volume, at).value();
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(p[c], nearest_double(exact[c]));
  }
  EXPECT_EQ(scene.markers.size(), 1u);
}

TEST(DefectScene, OfASoundModelHasNoMarks) {
  const TriangleMesh mesh = sphere();
  const ValidityReport report = decide_validity(mesh, {1, 20});
  ASSERT_TRUE(report.is_valid);
  const Scene scene = defect_scene(mesh, list_defects(mesh, report).defects, report.rule_counts);
  EXPECT_TRUE(scene.lines.empty() && scene.markers.empty() && scene.legend.empty());
}

}  // namespace
}  // namespace veritope
