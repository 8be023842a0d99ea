// SPDX-License-Identifier: LGPL-3.0-or-later
// Acceptance of pictures: each planted defect covers at least 12 x 12 pixels in exactly its colour.
#include "tests/support/planted_defects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "io/read_model.h"
#include "io/splines/write_splines.h"
#include "render/defect_scene.h"
#include "render/draw_scene.h"
#include "render/png.h"
#include "render/rule_colour.h"
#include "verify/certify/certify.h"

namespace veritope {
namespace {

constexpr std::size_t kSquareOf12 = 144;

// Without title and legend, which have these colours, too.
Image picture_of(Scene scene, unsigned jobs = 1) {
  scene.legend.clear();
  PictureOptions options;
  options.jobs = jobs;
  return draw_scene(scene, options).value();
}
std::size_t count_pixels(const Image& image, Colour colour) {
  return static_cast<std::size_t>(std::count(image.pixels.begin(), image.pixels.end(), colour));
}

// VERITOPE_PICTURES=FOLDER keeps the pictures, to be looked at.
void keep(const std::string& name, const Scene& scene) {
  const char* const folder = std::getenv("VERITOPE_PICTURES");
  if (folder == nullptr) return;
  Scene named = scene;
  named.title = {name};
  std::ofstream(std::string(folder) + "/" + name + ".png", std::ios::binary)
      << png_bytes(draw_scene(named, {}).value());
}

TEST(PlantedDefects, OfMeshesAreSeenAtAGlance) {
  for (const planted::MeshModel& m : planted::meshes()) {
    const ValidityReport report = decide_validity(m.mesh, {1, 20000});
    std::vector<MeshRule> broken;
    for (std::size_t i = 0; i < kNumMeshRules; ++i)
      if (report.rule_counts[i] != 0) broken.push_back(rule_at(i));
    EXPECT_EQ(broken == m.rules, true) << m.name;
    const Scene scene =
        defect_scene(m.mesh, list_defects(m.mesh, report).defects, report.rule_counts);
    const Image image = picture_of(scene);
    keep(m.name, scene);
    for (const MeshRule rule : broken)
      EXPECT_GE(count_pixels(image, colour_of(rule)), kSquareOf12)
          << m.name << ", M" << rule_index(rule) + 1;
    EXPECT_EQ(picture_of(scene, 3).pixels == image.pixels, true) << m.name;
  }
}

TEST(PlantedDefects, OfSplinesAreSeenAtAGlance) {
  for (const planted::SplineExample& s : planted::splines()) {
    const std::string bytes = spline_bytes(s.model, SplineFormat::kJson, {});
    const ModelFile file =
        read_model_bytes({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()},
                         "planted.vjson", {})
            .value();
    const Certified found = certify(file).value();
    ASSERT_EQ(found.verdict, Verdict::kInvalid) << s.name;
    const PatchFacts& facts = std::get<PatchFacts>(found.facts);
    std::vector<EntityPart> sides;
    for (const OpenSideFacts& side : facts.open_sides) sides.push_back(side.part);
    const Scene scene =
        defect_scene(std::get<SplineFile>(file).model, found.findings, sides, facts.open.sides)
            .value();
    keep(s.name, scene);
    EXPECT_GE(count_pixels(picture_of(scene), colour_of(s.rule)), kSquareOf12)
        << s.name << ": " << found.findings[0].code;
  }
}

// Two spheres of radius 1 at distance d = sqrt(10) / 3 cross in a circle: all drawn arcs lie near it, within the tessellation's deviation.
TEST(PlantedDefects, CurvesOfCrossingSplinesLieOnBothSurfaces) {
  const planted::SplineExample spheres = planted::splines()[1];
  ASSERT_EQ(spheres.name, "spheres that cross");
  Finding f;
  f.code = "patches-crossing";
  f.place.near = Point3d{0.5, 0, 0};
  f.place.parts = {{0, {}, {}}, {1, {}, {}}};  // neighbours, which do not cross
  const Scene scene = defect_scene(spheres.model, {&f, 1}, {}, 0).value();
  for (const SceneLine& line : scene.lines)
    for (const Point3d& p : line.points) {
      EXPECT_NEAR(std::hypot(p[0], p[1], p[2]), 1, 0.01);
      EXPECT_NEAR(std::hypot(p[0] - 1, p[1] - 1.0 / 3, p[2]), 1, 0.01);
    }
  EXPECT_GT(scene.lines.size(), 100u);
  ASSERT_EQ(scene.legend.size(), 1u);
  EXPECT_TRUE(scene.legend[0].text.starts_with("patches-crossing (approximate curves of "))
      << scene.legend[0].text;
}

}  // namespace
}  // namespace veritope
