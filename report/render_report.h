// SPDX-License-Identifier: LGPL-3.0-or-later
// report/render_report.h: what veritope render says of a picture.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "interval/exact_box.h"
#include "robust/base/box3d.h"

namespace veritope::report {

/// How many of n^3 points are where.
struct GridCounts {
  std::uint32_t n = 0;
  std::uint64_t in = 0, on = 0, out = 0, undecided = 0;
};

/// The cells of a V-model in a picture.
struct CellPicture {
  std::uint64_t count = 0;
  std::string explode;  ///< the factor, exactly
  bool has_nets = false;
};

/// A microstructure in a picture.
struct MicroPicture {
  std::uint64_t tiles = 0, bridges = 0;
  bool has_cage = false;
  std::optional<std::string> around;  ///< the path of the solid around it
};

/// Curves and sheets in a picture.
struct CurvePicture {
  std::uint64_t curves = 0, sheets = 0, bridges = 0;
  std::optional<std::string> around;  ///< the path of the solid around them
};

/// Pixel (i, j) shows the ray origin + i right + j down + t along, 0 <= t <= 1, or the point for t = 0.
struct DmsRays {
  Point3d origin{}, right{}, down{}, along{};
};

/// A simplex-spline solid in a picture.
struct DmsPicture {
  std::string mode;
  std::string attribute;                       ///< empty: none
  bool in_solid = false;                       ///< where the picture is; else in the domain
  std::optional<DmsRays> rays;                 ///< of X-rays, volumes and slices
  std::optional<std::array<double, 2>> range;  ///< of the colours
  std::optional<double> absorption, error;     ///< of X-rays
  std::optional<double> step;                  ///< of volumes
  std::optional<bool> certified;               ///< of surfaces where an attribute has a value
};

struct RenderReport {
  std::string path, sha256;  ///< of the model
  std::string picture;       ///< the path of the file
  std::optional<std::array<std::size_t, 2>>
      size;  ///< width and height in pixels; none: a file for viewers
  ExactBox<3> bounds;
  std::optional<GridCounts> grid;
  std::optional<CellPicture> cells;
  std::optional<MicroPicture> micro;
  std::optional<CurvePicture> curves;
  std::optional<DmsPicture> dms;
  double seconds_read = 0, seconds_build = 0, seconds_draw = 0;
};

/// The schema: docs/report.schema.json, render. One line.
std::string render_json(const RenderReport& report);

}  // namespace veritope::report
