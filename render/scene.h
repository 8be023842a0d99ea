// SPDX-License-Identifier: LGPL-3.0-or-later
// render/scene.h: what a picture shows: surfaces, and marks on them that are never hidden.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/image.h"
#include "robust/base/box3d.h"

namespace veritope {

/// How a triangle looks. Its colour is shaded by the angle at which the triangle is seen.
struct Paint {
  Colour colour;
  std::uint8_t opacity = 255;  ///< 0: invisible; 255: hides what lies behind
  friend bool operator==(const Paint&, const Paint&) = default;
};

/// Triangles, seen from both sides. Where triangles coincide, the one that is listed first is in front.
struct SceneSurface {
  std::vector<Point3d> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Paint> paints;  ///< one for each triangle, or a single one for all
  std::string name = {};      ///< of its part in files for viewers
  /// The normals of a smooth surface: for each point a direction of any length and either sign. In pictures the light
  /// is then linear between points instead of constant on triangles.
  std::vector<Point3d> normals = {};
  /// For each point a colour instead of those of paints, linear between points in pictures; viewers' files have none.
  std::vector<Colour> colours = {};
};

/// A mark: a polyline in space, of constant width in the picture. One point is a line, too, and shows as a dot.
struct SceneLine {
  std::vector<Point3d> points;
  Colour colour;
  double width = 4;  ///< in pixels; from 3 on, the pixels in exactly its colour are connected
  unsigned layer = 0;
};

/// A mark: a disc around a point.
struct SceneMarker {
  Point3d at{};
  Colour colour;
  double radius = 9;  ///< in pixels; 9 covers a square of 12 x 12 pixels in exactly its colour
  unsigned layer = 0;
};

struct LegendEntry {
  Colour colour;
  std::string text;
  std::optional<Paint> faces = {};  ///< of the triangles that belong to it
};

/// Marks show in front of all surfaces, with a thin rim that sets them off from any background. In one layer they hide
/// each other as they would in space; marks of higher layers are in front. Those of layer 0 are drawn as they are. In
/// higher layers a mark that others would hide becomes so wide that it shows around them, and every colour covers at
/// least 144 pixels. All coordinates are finite.
struct Scene {
  std::vector<SceneSurface> surfaces;
  std::vector<SceneLine> lines;
  std::vector<SceneMarker> markers;
  std::vector<std::string> title;  ///< lines above the picture
  std::vector<LegendEntry> legend;
};

/// The box of all points that triangles use and of all marks. REQUIRES ids in range and finite coordinates.
Box3d box_of(const Scene& scene);

}  // namespace veritope
