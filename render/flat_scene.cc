// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/flat_scene_internal.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robust/base/check.h"

namespace veritope::internal {
namespace {

// Calls visit(i) for each point of a surface that a triangle uses, once.
template <typename Visit>
void for_each_used_point(const SceneSurface& surface, Visit visit) {
  std::vector<bool> is_seen(surface.points.size(), false);
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t i : triangle) {
      VT_CHECK(i < surface.points.size(), "a triangle's corners are points of its surface");
      if (!is_seen[i]) visit(i);
      is_seen[i] = true;
    }
}

double widest_mark(const Scene& scene) {
  double radius = 0;
  for (const SceneLine& line : scene.lines) radius = std::max(radius, line.width / 2);
  for (const SceneMarker& marker : scene.markers) radius = std::max(radius, marker.radius);
  return radius > 0 ? radius + kRim : 0;
}

// By the margin, but by at most nine tenths.
PictureBox shrunk(const PictureBox& box, double margin) {
  const double x = std::min(margin, 0.45 * box.width()), y = std::min(margin, 0.45 * box.height());
  return {box.left + x, box.top + y, box.right - x, box.bottom - y};
}

Colour scaled(Colour colour, double factor) {
  const auto channel = [factor](std::uint8_t c) {
    return static_cast<std::uint8_t>(c * factor + 0.5);
  };
  return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

// The light on a point of a smooth surface, whose normal is turned to the side of the facet that is seen.
double smooth_light(Point3d normal, const FacetView& facet) {
  double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  if (!(length > 0) || !std::isfinite(length)) return facet.light;
  const auto& n = facet.normal;
  if (normal[0] * n[0] + normal[1] * n[1] + normal[2] * n[2] < 0) length = -length;
  for (double& x : normal) x /= length;
  return light_of(normal);
}

class Flattener {
 public:
  Flattener(const Scene& scene, const Point3d& view)
      : scene_(scene), camera_(box_of(scene), view) {}

  FlatScene in_room(const PictureBox& room) {
    for (const SceneSurface& surface : scene_.surfaces) add(surface);
    for (const SceneLine& line : scene_.lines) add(line);
    for (const SceneMarker& marker : scene_.markers) add(marker);
    fit(fit_into(shrunk(room, widest_mark(scene_)), bounds_));
    std::stable_sort(out_.marks.begin(), out_.marks.end(),
                     [](const FlatMark& a, const FlatMark& b) { return a.layer < b.layer; });
    return std::move(out_);
  }

 private:
  void add(const SceneSurface& surface) {
    const bool is_plain = surface.paints.size() == 1;
    VT_CHECK(is_plain || surface.paints.size() == surface.triangles.size(),
             "one paint for each triangle, or one for all");
    VT_CHECK((surface.normals.empty() || surface.normals.size() == surface.points.size()) &&
                 (surface.colours.empty() || surface.colours.size() == surface.points.size()),
             "normals and colours are those of points");
    const auto first = static_cast<std::uint32_t>(out_.corners.size());
    out_.corners.resize(first + surface.points.size());
    std::vector<Point3d> in_frame(surface.points.size());
    for_each_used_point(surface, [&](std::uint32_t i) {
      in_frame[i] = camera_.in_frame(surface.points[i]);
      out_.corners[first + i] = projected(in_frame[i]);
    });
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const auto [a, b, c] = surface.triangles[t];
      const FacetView view =
          facet_view({in_frame[a], in_frame[b], in_frame[c]}, camera_.distance());
      const Paint& paint = surface.paints[is_plain ? 0 : t];
      FlatTriangle& flat = out_.triangles.emplace_back(
          FlatTriangle{{first + a, first + b, first + c},
                       {scaled(paint.colour, view.light), paint.opacity},
                       view.normal});
      if (!surface.normals.empty() || !surface.colours.empty())
        flat.smooth = add_smooth(surface, surface.triangles[t], paint.colour, view);
    }
  }
  std::uint32_t add_smooth(const SceneSurface& surface, const std::array<std::uint32_t, 3>& corners,
                           Colour colour, const FacetView& facet) {
    std::array<Colour, 3>& shaded = out_.smooth.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t i = corners[k];
      const double light = surface.normals.empty()
                               ? facet.light
                               : smooth_light(camera_.turned(surface.normals[i]), facet);
      shaded[k] = scaled(surface.colours.empty() ? colour : surface.colours[i], light);
    }
    return static_cast<std::uint32_t>(out_.smooth.size() - 1);
  }
  void add(const SceneLine& line) {
    std::vector<PicturePoint> points;
    for (const Point3d& p : line.points) points.push_back(projected(camera_.in_frame(p)));
    const double radius = line.width / 2;
    if (points.size() == 1) add_mark({points[0], points[0], radius, line.colour, line.layer});
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      add_mark({points[i], points[i + 1], radius, line.colour, line.layer});
  }
  void add(const SceneMarker& marker) {
    const PicturePoint p = projected(camera_.in_frame(marker.at));
    ++num_markers_;
    add_mark({p, p, marker.radius, marker.colour, marker.layer});
  }
  void add_mark(const FlatMark& mark) {
    VT_CHECK(0.5 <= mark.radius && mark.radius <= 64, "a mark is 1 to 128 pixels wide");
    out_.marks.push_back(mark);
  }
  PicturePoint projected(const Point3d& in_frame) {
    const PicturePoint p = camera_.projected(in_frame);
    bounds_ = {std::min(bounds_.left, p.x), std::min(bounds_.top, p.y),
               std::max(bounds_.right, p.x), std::max(bounds_.bottom, p.y)};
    return p;
  }
  // Markers lie at corners of pixels, so that all markers of one radius cover equally many.
  void fit(const PictureFit& fit) {
    for (PicturePoint& p : out_.corners) p = fit(p);
    for (FlatMark& mark : out_.marks) mark.a = fit(mark.a), mark.b = fit(mark.b);
    for (std::size_t i = out_.marks.size() - num_markers_; i < out_.marks.size(); ++i) {
      PicturePoint& p = out_.marks[i].a;
      p.x = std::floor(p.x + 0.5), p.y = std::floor(p.y + 0.5);
      out_.marks[i].b = p;
    }
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Scene& scene_;
  SceneCamera camera_;
  FlatScene out_;
  std::size_t num_markers_ = 0;  // the last ones of out_.marks
  PictureBox bounds_{kInfinity, kInfinity, -kInfinity, -kInfinity};
};

}  // namespace

FlatScene flatten(const Scene& scene, const Point3d& view, const PictureBox& room) {
  return Flattener(scene, view).in_room(room);
}

}  // namespace veritope::internal
