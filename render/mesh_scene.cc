// SPDX-License-Identifier: LGPL-3.0-or-later
// Scenes of meshes with their defects.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "render/defect_picture.h"
#include "render/defect_scene.h"
#include "robust/base/disjoint_sets.h"
#include "solids/polyhedron/box_order.h"

namespace veritope {
namespace {

constexpr double kSmallPart = 1.0 / 10;  // of the model's size

Point3d rounded(const RationalPoint& p) {
  return {nearest_double(p.at[0]), nearest_double(p.at[1]), nearest_double(p.at[2])};
}
bool is_drawable(const Point3d& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}
Point3d point_of(const Vec3d& p) { return {p.x, p.y, p.z}; }

// Fainter than marks of that colour.
Paint tinted(Colour colour) {
  Paint out = model_paint(false);
  const auto mixed = [](std::uint8_t grey, std::uint8_t c) {
    return static_cast<std::uint8_t>((3 * grey + 2 * c) / 5);
  };
  out.colour = {mixed(out.colour.red, colour.red), mixed(out.colour.green, colour.green),
                mixed(out.colour.blue, colour.blue)};
  return out;
}

SceneSurface surface_of(const TriangleMesh& mesh, std::span<const Finding> defects) {
  SceneSurface out;
  for (const Vec3d& p : mesh.positions) out.points.push_back(point_of(p));
  out.triangles = mesh.faces;
  out.paints.assign(mesh.faces.size(), model_paint(defects.empty()));
  for (std::size_t i = defects.size(); i-- > 0;)
    for (const std::uint32_t f : defects[i].place.faces)
      out.paints[f] = tinted(colour_of(rule_of(defects[i])));
  return out;
}

// Lines of one rule, connected through common ends: a marker for each group that is small beside the model.
class LineGroups {
 public:
  void add(const std::array<Point3d, 2>& ends) {
    lines_.push_back({number_of(ends[0]), number_of(ends[1])});
  }
  std::vector<Point3d> middles_of_small_groups(double size) const {
    if (!std::isfinite(size)) return {};
    DisjointSets<> groups(points_.size());
    for (const auto& [a, b] : lines_) groups.join(a, b);
    std::map<std::uint32_t, Box3d> boxes;
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      const auto [at, is_new] = boxes.try_emplace(groups.find(i), empty_box());
      veritope::add(points_[i], &at->second);
    }
    std::vector<Point3d> out;
    for (const auto& [group, box] : boxes)
      if (extent(box) <= kSmallPart * size) out.push_back(approx_centre(box));
    return out;
  }

 private:
  std::uint32_t number_of(const Point3d& p) {
    const auto [at, is_new] = numbers_.try_emplace(p, static_cast<std::uint32_t>(points_.size()));
    if (is_new) points_.push_back(p);
    return at->second;
  }

  std::map<Point3d, std::uint32_t> numbers_;
  std::vector<Point3d> points_;
  std::vector<std::array<std::uint32_t, 2>> lines_;
};

void add_marks(std::span<const Finding> defects, double size, Scene& scene) {
  std::map<MeshRule, LineGroups> groups;
  std::set<Point3d> marked;
  for (const Finding& d : defects) {
    const Colour colour = colour_of(rule_of(d));
    if (!d.witness.ends) {
      const Point3d at = rounded(*d.witness.point);
      // Faces that cover each other break M2 and M7 at one point: the mark is that of the rule that is listed first.
      if (is_drawable(at) && marked.insert(at).second)
        scene.markers.push_back({at, colour, SceneMarker().radius});
      continue;
    }
    const std::array<Point3d, 2> ends = {rounded(d.witness.ends->at(0)),
                                         rounded(d.witness.ends->at(1))};
    if (!is_drawable(ends[0]) || !is_drawable(ends[1])) continue;
    scene.lines.push_back({{ends[0], ends[1]}, colour, SceneLine().width});
    groups[rule_of(d)].add(ends);
  }
  for (const auto& [rule, lines] : groups)
    for (const Point3d& at : lines.middles_of_small_groups(size))
      scene.markers.push_back({at, colour_of(rule), SceneMarker().radius});
}

}  // namespace

Paint model_paint(bool is_sound) {
  return {{190, 190, 190}, static_cast<std::uint8_t>(is_sound ? 255 : 170)};
}

Scene defect_scene(const TriangleMesh& mesh, std::span<const Finding> defects,
                   const std::array<std::uint64_t, kNumMeshRules>& rule_counts) {
  Scene out;
  out.surfaces.push_back(surface_of(mesh, defects));
  add_marks(defects, extent(bounding_box_of_faces(mesh, 1)), out);
  for (std::size_t i = 0; i < kNumMeshRules; ++i)
    if (rule_counts[i] != 0)
      out.legend.push_back({colour_of(rule_at(i)), std::string(rule_text(rule_at(i)).id) + " " +
                                                       std::string(rule_text(rule_at(i)).name) +
                                                       " (" + std::to_string(rule_counts[i]) +
                                                       ")"});
  return out;
}

}  // namespace veritope
