// SPDX-License-Identifier: LGPL-3.0-or-later
// render/grid_painter_internal.h: balls in the place of the points of a grid.
#pragma once
#include <array>
#include <vector>

#include "render/draw_scene.h"
#include "render/parallel_view_internal.h"
#include "render/point_grid.h"
#include "render/sample_layer_internal.h"

namespace veritope::internal {

class GridPainter {
 public:
  /// As large as the marks fit into the room. Keeps a reference to the grid.
  GridPainter(const PointGrid& grid, const PictureBox& room, const PictureOptions& options);

  /// Draws rows [first, last) of pixels.
  void draw(std::size_t first, std::size_t last, Image* image) const;

 private:
  SamplePoint place(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;
  void draw_line(std::uint32_t i, std::uint32_t j, SampleLayer& layer) const;
  void draw_ball(const SamplePoint& at, Colour colour, SampleLayer& layer) const;
  template <typename Visit>
  void for_each_end(Visit&& visit) const;
  Haze haze() const;

  const PointGrid& grid_;
  ParallelView view_;
  std::size_t width_;  ///< in samples
  /// From the low side of the grid's box, in units of its longest side: nothing overflows.
  std::array<std::vector<double>, 3> coordinates_;
  double radius_ = 1;
  SampleLayer::Look look_;
};

}  // namespace veritope::internal
