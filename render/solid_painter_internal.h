// SPDX-License-Identifier: LGPL-3.0-or-later
// render/solid_painter_internal.h: the rays of a picture: one a pixel, and nine where that one does not tell.
#pragma once
#include <cstdint>
#include <vector>

#include "render/draw_scene.h"
#include "render/parallel_view_internal.h"
#include "render/ray_caster_internal.h"
#include "render/sample_layer_internal.h"
#include "robust/base/work_share.h"

namespace veritope::internal {

/// Samples are cast except
/// - where a pixel's ray and those of its eight neighbours meet no cell that is not 0: there is nothing;
/// - where these nine rays hit what looks smooth: the heights of the other samples are interpolated.
class SolidPainter {
 public:
  /// Casts a ray through the middle of each pixel. Keeps references.
  SolidPainter(const SolidProbe& solid, const ValueCells& cells, const ParallelView& view,
               const PictureOptions& options, WorkShare* work);

  /// Whether some ray hit.
  bool is_hit() const;
  /// Draws rows [first, last) of pixels.
  void draw(std::size_t first, std::size_t last, Image* image) const;

 private:
  static constexpr std::uint8_t kCut = 1, kThin = 2, kMet = 4;
  /// The ray of a pixel; LayerSample::kNothing: it misses.
  struct PixelRay {
    double height = LayerSample::kNothing;
    std::uint8_t flags = 0;
    bool is_hit() const { return height != LayerSample::kNothing; }
  };
  using Neighbours = std::array<std::array<PixelRay, 5>, 5>;  // row after row

  PixelRay cast(std::size_t column, std::size_t row, std::optional<double> guess,
                bool with_thin) const;
  void cast_middles(std::size_t y);
  Neighbours neighbours_of(std::size_t x, std::size_t y) const;
  static bool are_smooth(const Neighbours& near);
  void fill_pixel(std::size_t x, std::size_t y, SampleLayer& layer) const;
  static void interpolate_pixel(const Neighbours& near, std::size_t x, std::size_t y,
                                SampleLayer& layer);
  void cast_pixel(const PixelRay& middle, std::size_t x, std::size_t y, bool with_thin,
                  SampleLayer& layer) const;
  static void show(const PixelRay& ray, std::size_t column, std::size_t row, SampleLayer& layer);

  RayCaster caster_;
  const ParallelView& view_;
  std::size_t width_, height_;  ///< in pixels
  SampleLayer::Look look_;
  std::vector<PixelRay> middles_;
};

}  // namespace veritope::internal
