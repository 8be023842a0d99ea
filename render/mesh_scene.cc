// SPDX-License-Identifier: LGPL-3.0-or-later
// Scenes of meshes with their defects.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "render/defect_scene.h"
#include "render/rule_colour.h"
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

// The faces of the shells with these faces. REQUIRES that each vertex lies in one shell only.
std::vector<std::uint32_t> faces_of_shells(const TriangleMesh& mesh,
                                           const std::vector<std::uint32_t>& seeds) {
  DisjointSets<> shells(mesh.positions.size());
  for (const auto& [a, b, c] : mesh.faces) shells.join(a, b), shells.join(b, c);
  std::set<std::uint32_t> chosen;
  for (const std::uint32_t f : seeds) chosen.insert(shells.find(mesh.faces[f][0]));
  std::vector<std::uint32_t> out;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    if (chosen.contains(shells.find(mesh.faces[f][0]))) out.push_back(f);
  return out;
}

// M8 and M9 are about whole shells, which no other rule breaks then.
bool is_of_shells(MeshRule rule) { return rule == MeshRule::kM8 || rule == MeshRule::kM9; }

SceneSurface surface_of(const TriangleMesh& mesh, std::span<const Finding> defects) {
  SceneSurface out;
  out.name = "model";
  for (const Vec3d& p : mesh.positions) out.points.push_back(to_point(p));
  out.triangles = mesh.faces;
  out.paints.assign(mesh.faces.size(), model_paint(defects.empty()));
  std::map<MeshRule, std::vector<std::uint32_t>> seeds;
  for (std::size_t i = defects.size(); i-- > 0;) {
    const MeshRule rule = rule_of(defects[i]);
    for (const std::uint32_t f : defects[i].place.faces) {
      out.paints[f] = tinted_paint(colour_of(rule));
      if (is_of_shells(rule)) seeds[rule].push_back(f);
    }
  }
  for (const auto& [rule, faces] : seeds)
    for (const std::uint32_t f : faces_of_shells(mesh, faces))
      out.paints[f] = tinted_paint(colour_of(rule));
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

// The rarest rule is in front, and points are in front of lines: what is small and rare stays visible among what is
// large and frequent.
class Layers {
 public:
  explicit Layers(const std::array<std::uint64_t, kNumMeshRules>& rule_counts) {
    for (std::size_t i = 0; i < kNumMeshRules; ++i)
      for (std::size_t k = 0; k < kNumMeshRules; ++k)
        if (std::pair(rule_counts[k], k) > std::pair(rule_counts[i], i)) ++rank_[i];
  }
  unsigned of_lines(MeshRule rule) const { return 1 + rank_[rule_index(rule)]; }
  unsigned of_markers(MeshRule rule) const { return kNumMeshRules + of_lines(rule); }

 private:
  std::array<unsigned, kNumMeshRules> rank_{};
};

void add_marks(std::span<const Finding> defects, double size, const Layers& layers, Scene& scene) {
  std::map<MeshRule, LineGroups> groups;
  std::set<std::pair<MeshRule, Point3d>> marked;
  const auto add_marker = [&](MeshRule rule, const Point3d& at) {
    if (marked.insert({rule, at}).second)
      scene.markers.push_back({at, colour_of(rule), SceneMarker().radius, layers.of_markers(rule)});
  };
  for (const Finding& d : defects) {
    const MeshRule rule = rule_of(d);
    if (!d.witness.ends) {
      const Point3d at = rounded(*d.witness.point);
      if (is_drawable(at)) add_marker(rule, at);
      continue;
    }
    const std::array<Point3d, 2> ends = {rounded(d.witness.ends->at(0)),
                                         rounded(d.witness.ends->at(1))};
    if (!is_drawable(ends[0]) || !is_drawable(ends[1])) continue;
    scene.lines.push_back(
        {{ends[0], ends[1]}, colour_of(rule), SceneLine().width, layers.of_lines(rule)});
    groups[rule].add(ends);
  }
  for (const auto& [rule, lines] : groups)
    for (const Point3d& at : lines.middles_of_small_groups(size)) add_marker(rule, at);
}

}  // namespace

Paint model_paint(bool is_sound) {
  return {{190, 190, 190}, static_cast<std::uint8_t>(is_sound ? 255 : 170)};
}

Paint tinted_paint(Colour colour) {
  Paint out = model_paint(false);
  const auto mixed = [](std::uint8_t grey, std::uint8_t c) {
    return static_cast<std::uint8_t>((3 * grey + 2 * c) / 5);
  };
  out.colour = {mixed(out.colour.red, colour.red), mixed(out.colour.green, colour.green),
                mixed(out.colour.blue, colour.blue)};
  return out;
}

Scene defect_scene(const TriangleMesh& mesh, std::span<const Finding> defects,
                   const std::array<std::uint64_t, kNumMeshRules>& rule_counts) {
  Scene out;
  out.surfaces.push_back(surface_of(mesh, defects));
  add_marks(defects, extent(bounding_box_of_faces(mesh, 1)), Layers(rule_counts), out);
  for (std::size_t i = 0; i < kNumMeshRules; ++i)
    if (rule_counts[i] != 0)
      out.legend.push_back({colour_of(rule_at(i)),
                            std::string(rule_text(rule_at(i)).id) + " " +
                                std::string(rule_text(rule_at(i)).name) + " (" +
                                std::to_string(rule_counts[i]) + ")",
                            tinted_paint(colour_of(rule_at(i)))});
  return out;
}

}  // namespace veritope
