// SPDX-License-Identifier: LGPL-3.0-or-later
// Prints, for a fixed list of generated models, one line: name, SHA-256 of the report's exact text, SHA-256 of the certificate; and for
// models with planted defects: "picture:" and the name, SHA-256 of the picture as PNG, SHA-256 of it as PLY, VTU and glTF. All must be the
// same for 1, 2 and 5 threads. Exit 1 if they are not. tests/golden/golden_test.py builds and runs it.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "render/defect_scene.h"
#include "render/draw_scene.h"
#include "render/png.h"
#include "render/scene_files.h"
#include "tests/support/planted_defects.h"
#include "tests/support/report_text.h"
#include "tests/support/shapes.h"
#include "verify/certify/mesh_certifier.h"
#include "verify/format/sha256.h"

namespace {

using namespace veritope;

struct Model {
  std::string name;
  TriangleMesh mesh;
};

std::vector<Model> models() {
  using shapes::Cap;
  std::vector<Model> out{{"box", shapes::box({0, 0, 0}, {1, 2, 3}, 3)},
                         {"prism", shapes::prism(17, 3, 2)},
                         {"torus", shapes::torus(24, 16, 3, 1)},
                         {"bipyramid", shapes::bipyramid(60)},
                         {"cone", shapes::cone(60)},
                         {"cylinder_centre", shapes::tilted_cylinder(100, Cap::kCentreFan)},
                         {"cylinder_rim", shapes::tilted_cylinder(100, Cap::kRimFan)},
                         {"cylinder_zigzag", shapes::tilted_cylinder(100, Cap::kZigzag)},
                         {"hyperboloid", shapes::hyperboloid(90, 30)},
                         {"saddle", shapes::saddle()},
                         {"wave", shapes::wave(14, 30)},
                         {"nest", shapes::nested_boxes(6)},
                         {"grid", shapes::box_grid(4, 0.25)},
                         {"inside_out", shapes::reversed(shapes::torus(9, 7, 3, 1))},
                         {"huge", shapes::scaled(shapes::torus(9, 7, 3, 1), 1000)},
                         {"tiny", shapes::scaled(shapes::torus(9, 7, 3, 1), -1060)}};
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    const std::string n = std::to_string(seed);
    out.push_back({"star_" + n, shapes::star_polyhedron(random, 2)});
    out.push_back({"scene_" + n, shapes::nested_scene(random, 12)});
    out.push_back({"needles_" + n, shapes::needles(random, 12)});
    out.push_back({"polycube_" + n, shapes::random_polycube(random, 3, 12)});
    out.push_back({"mapped_wave_" + n, shapes::mapped(shapes::wave(10, 12), shapes::random_matrix(random, 5), {1, 2, 3})});
    out.push_back({"needle_soup_" + n, shapes::needle_soup(random, 70)});
    out.push_back({"grid_soup_" + n, shapes::grid_soup(random, 40, 4)});
    out.push_back({"indexed_soup_" + n, shapes::random_indexed(random, 40, 12, 3)});
  }
  return out;
}

std::string hash_of(const std::string& text) {
  return to_hex(sha256({reinterpret_cast<const unsigned char*>(text.data()), text.size()}));
}

struct Hashes {
  std::string first, second;
  friend bool operator==(const Hashes&, const Hashes&) = default;
};

Hashes hashes(const TriangleMesh& mesh, unsigned jobs) {
  ValidityOptions options;
  options.jobs = jobs;
  const ListedReport report = decide_and_list(mesh, options);
  const certificate::Subject subject{std::string(64, '0'), 0, "ply", true, "rule", "golden"};
  const std::string text = full_text(report);
  const auto bytes = make_mesh_certificate(mesh, report, report.defects, subject, jobs);
  return {hash_of(text), to_hex(sha256(bytes))};
}

Hashes picture_hashes(const TriangleMesh& mesh, unsigned jobs) {
  ValidityOptions options;
  options.jobs = jobs;
  const ListedReport report = decide_and_list(mesh, options);
  Scene scene = defect_scene(mesh, report.defects, report.rule_counts);
  scene.title = {"defects"};
  PictureOptions how;
  how.jobs = jobs;
  return {hash_of(png_bytes(draw_scene(scene, how).value())),
          hash_of(scene_ply(scene).value() + scene_vtu(scene).value() + scene_gltf(scene).value())};
}

// Prints the line of a model. Returns whether all numbers of threads give the same bytes.
template <typename HashesOf>
bool print_line(const std::string& name, const TriangleMesh& mesh, HashesOf hashes_of) {
  const Hashes one = hashes_of(mesh, 1);
  std::printf("%s %s %s\n", name.c_str(), one.first.c_str(), one.second.c_str());
  bool is_good = true;
  for (unsigned jobs : {2u, 5u}) {
    if (hashes_of(mesh, jobs) == one) continue;
    std::fprintf(stderr, "%s: %u threads give other bytes\n", name.c_str(), jobs);
    is_good = false;
  }
  return is_good;
}

}  // namespace

int main() {
  bool is_good = true;
  for (const Model& m : models()) is_good = print_line(m.name, m.mesh, hashes) && is_good;
  for (const planted::MeshModel& m : planted::meshes()) {
    std::string name = "picture:" + m.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    is_good = print_line(name, m.mesh, picture_hashes) && is_good;
  }
  return is_good ? 0 : 1;
}
