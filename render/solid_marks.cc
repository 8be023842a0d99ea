// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/solid_marks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace veritope {
namespace {

// a + s u, in the range of binary64.
Point3d moved(const Point3d& a, double s, const Point3d& u) {
  constexpr double kMost = std::numeric_limits<double>::max();
  Point3d out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = std::clamp(a[k] + s * u[k], -kMost, kMost);
  return out;
}
Point3d cross_of(const Point3d& a, const Point3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point3d unit_vector(const Point3d& a) {
  const double length = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
  return {a[0] / length, a[1] / length, a[2] / length};
}

// From a to b, of length 1. REQUIRES two points.
Point3d direction(const Point3d& a, const Point3d& b) {
  Point3d out;
  const double factor = std::isfinite(extent({a, b})) && std::isfinite(extent({b, a})) ? 1 : 0.5;
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    out[k] = b[k] * factor - a[k] * factor;
    largest = std::max(largest, std::abs(out[k]));
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (double& x : out) x = std::ldexp(x, -exponent);
  return unit_vector(out);
}
// At right angles to a unit vector.
Point3d normal_to(const Point3d& along) {
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(along[k]) < std::abs(along[least])) least = k;
  Point3d axis{};
  axis[least] = 1;
  return unit_vector(cross_of(along, axis));
}

class MarkSolids {
 public:
  MarkSolids(double scene_size, double tube_radius)
      : size_(scene_size), tube_radius_(scene_size * tube_radius) {}

  void add(const SceneLine& line) {
    SceneSurface& surface = surface_of(line.colour);
    if (line.points.size() == 1) add_dot(line.points[0], tube_radius_, surface);
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
      add_tube(line.points[i], line.points[i + 1], surface);
  }
  void add(const SceneMarker& marker) {
    add_dot(marker.at, size_ * kOctahedronRadius, surface_of(marker.colour));
  }

  // By the legend, with the texts of all its entries of a colour; colours that it lacks come last.
  std::vector<SceneSurface> take(const std::vector<LegendEntry>& legend) {
    const auto rank = [&](const SceneSurface& s) {
      return std::find_if(legend.begin(), legend.end(),
                          [&](const LegendEntry& e) { return e.colour == s.paints[0].colour; }) -
             legend.begin();
    };
    std::stable_sort(surfaces_.begin(), surfaces_.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    for (SceneSurface& surface : surfaces_) {
      for (const LegendEntry& entry : legend)
        if (entry.colour == surface.paints[0].colour)
          surface.name += (surface.name.empty() ? "" : ", ") + entry.text;
      if (surface.name.empty()) surface.name = "marks";
    }
    return std::move(surfaces_);
  }

 private:
  SceneSurface& surface_of(Colour colour) {
    for (SceneSurface& s : surfaces_)
      if (s.paints[0].colour == colour) return s;
    return surfaces_.emplace_back(SceneSurface{{}, {}, {{colour}}});
  }

  // Binary32 may not tell the ends apart: the sides of a tube would have no area.
  bool is_short(const Point3d& a, const Point3d& b) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(a[k] - b[k]) > size_ * kShortLine) return false;
    return true;
  }
  // Closed, its faces outward: a prism along the line, and a pyramid of its radius at either end.
  void add_tube(const Point3d& a, const Point3d& b, SceneSurface& out) const {
    constexpr std::uint32_t kSides = 6;
    constexpr double kHalf = 0.5, kRootOf3By2 = 0.8660254037844386;
    constexpr std::array<std::array<double, 2>, kSides> kTurns = {{{1, 0},
                                                                   {kHalf, kRootOf3By2},
                                                                   {-kHalf, kRootOf3By2},
                                                                   {-1, 0},
                                                                   {-kHalf, -kRootOf3By2},
                                                                   {kHalf, -kRootOf3By2}}};
    const double radius = tube_radius_;
    if (is_short(a, b)) return add_dot(a, radius, out);
    const Point3d along = direction(a, b), u = normal_to(along), v = cross_of(along, u);
    const auto first = static_cast<std::uint32_t>(out.points.size()), last = first + 2 * kSides;
    for (const auto& [c, s] : kTurns)
      for (const Point3d* const end : {&a, &b})
        out.points.push_back(moved(moved(*end, radius * c, u), radius * s, v));
    out.points.push_back(moved(a, -radius, along));
    out.points.push_back(moved(b, radius, along));
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const std::uint32_t p = first + 2 * i, q = first + 2 * ((i + 1) % kSides);
      out.triangles.push_back({p, q, q + 1});
      out.triangles.push_back({p, q + 1, p + 1});
      out.triangles.push_back({last, q, p});
      out.triangles.push_back({last + 1, p + 1, q + 1});
    }
  }
  // An octahedron.
  static void add_dot(const Point3d& centre, double radius, SceneSurface& out) {
    const auto first = static_cast<std::uint32_t>(out.points.size());
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const double sign : {-1.0, 1.0}) {
        Point3d unit{};
        unit[axis] = sign;
        out.points.push_back(moved(centre, radius, unit));
      }
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
      const std::uint32_t a = first + (corner & 1), b = first + 2 + (corner >> 1 & 1),
                          c = first + 4 + (corner >> 2);
      const bool is_even = std::popcount(corner) % 2 == 0;
      out.triangles.push_back(is_even ? std::array{a, c, b} : std::array{a, b, c});
    }
  }

  double size_, tube_radius_;
  std::vector<SceneSurface> surfaces_;  // with one paint each
};

}  // namespace

double approx_scene_size(const Scene& scene) {
  const Box3d box = box_of(scene);
  const double size = extent(box);
  if (!std::isfinite(size)) return std::numeric_limits<double>::max();
  return size > 0 ? size : 1;
}

std::vector<SceneSurface> with_solid_marks(Scene scene, double tube_radius) {
  MarkSolids marks(approx_scene_size(scene), tube_radius);
  for (const SceneLine& line : scene.lines) marks.add(line);
  for (const SceneMarker& marker : scene.markers) marks.add(marker);
  std::vector<SceneSurface> out = std::move(scene.surfaces);
  for (SceneSurface& surface : marks.take(scene.legend)) out.push_back(std::move(surface));
  return out;
}

SceneSurface without_unused_points(SceneSurface surface) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(surface.points.size(), kUnused);
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t i : triangle) number[i] = 0;
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] == kUnused) continue;
    surface.points[count] = surface.points[i];
    number[i] = count++;
  }
  surface.points.resize(count);
  for (auto& triangle : surface.triangles)
    for (std::uint32_t& i : triangle) i = number[i];
  return surface;
}

std::vector<ScenePart> parts_of(const SceneSurface& surface,
                                const std::vector<LegendEntry>& legend) {
  std::vector<ScenePart> out;
  const bool is_plain = surface.paints.size() == 1;
  std::size_t last = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Paint& paint = surface.paints[is_plain ? 0 : t];
    if (last >= out.size() || out[last].paint != paint) {
      const auto at = std::find_if(out.begin(), out.end(),
                                   [&](const ScenePart& p) { return p.paint == paint; });
      last = static_cast<std::size_t>(at - out.begin());
      if (at == out.end()) out.push_back({surface.name, paint, {}});
    }
    out[last].triangles.push_back(surface.triangles[t]);
  }
  for (ScenePart& part : out)
    for (const LegendEntry& entry : legend)
      if (entry.faces == part.paint) part.name += ": " + entry.text;
  return out;
}

}  // namespace veritope
