// SPDX-License-Identifier: LGPL-3.0-or-later
// render/picture_caption_internal.h: the title above a picture and the legend below it.
#pragma once
#include <cstddef>

#include "render/picture_font.h"
#include "render/scene.h"
#include "render/scene_camera_internal.h"

namespace veritope::internal {

/// Where the lines of text of a picture lie. Title and legend take at most a third of the height each: lines of the
/// title that do not fit are left out, and so are entries of the legend, whose last place then shows how many.
/// Text that is too wide is shortened.
class CaptionLayout {
 public:
  /// Keeps a reference to the scene.
  CaptionLayout(const Scene& scene, std::size_t width, std::size_t height);

  /// What is left for the scene.
  PictureBox room() const;
  void draw(Image* image) const;

 private:
  void choose_columns();
  void draw_entry(const TextPlace& place, const LegendEntry& entry, Image* image) const;
  std::size_t most_rows() const;
  std::size_t num_title_rows() const;
  std::size_t num_legend_rows() const;
  TextPlace title_place(std::size_t row) const;
  TextPlace legend_place(std::size_t entry) const;

  const Scene& scene_;
  std::size_t width_, height_, scale_, margin_, line_height_, indent_;
  std::size_t num_columns_ = 1, column_width_ = 0, num_entries_ = 0;  // of the legend
};

}  // namespace veritope::internal
