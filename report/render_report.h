// SPDX-License-Identifier: LGPL-3.0-or-later
// report/render_report.h: what veritope render says of a picture.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "interval/exact_box.h"

namespace veritope::report {

/// How many of n^3 points are where.
struct GridCounts {
  std::uint32_t n = 0;
  std::uint64_t in = 0, on = 0, out = 0, undecided = 0;
};

struct RenderReport {
  std::string path, sha256;  ///< of the model
  std::string picture;       ///< the path of the file
  std::size_t width = 0, height = 0;
  ExactBox<3> bounds;
  std::optional<GridCounts> grid;
  double seconds_read = 0, seconds_build = 0, seconds_draw = 0;
};

/// The schema: docs/report.schema.json, render. One line.
std::string render_json(const RenderReport& report);

}  // namespace veritope::report
