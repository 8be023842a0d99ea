// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "render/picture_caption_internal.h"

namespace veritope::internal {
namespace {

constexpr Colour kText{40, 40, 40};
constexpr std::size_t kMargin = 8, kLineHeight = 12, kSwatch = 7, kIndent = 11,
                      kGap = 16;  // at scale 1

// Twice the font's size in a picture of 1200 x 900 pixels.
std::size_t text_scale(std::size_t width, std::size_t height) {
  return std::max<std::size_t>(1, std::min(width / 600, height / 450));
}

}  // namespace

CaptionLayout::CaptionLayout(const Scene& scene, std::size_t width, std::size_t height)
    : scene_(scene),
      width_(width),
      height_(height),
      scale_(text_scale(width, height)),
      margin_(kMargin * scale_),
      line_height_(kLineHeight * scale_),
      indent_(kIndent * scale_) {
  choose_columns();
}

// The widest entry says how many columns there are.
void CaptionLayout::choose_columns() {
  const std::size_t most = width_ - 2 * margin_, gap = kGap * scale_;
  for (const LegendEntry& entry : scene_.legend)
    column_width_ = std::max(column_width_, indent_ + text_columns(entry.text, scale_));
  column_width_ = std::min(column_width_, most);
  num_columns_ = std::max<std::size_t>(1, (most + gap) / (column_width_ + gap));
  num_entries_ = std::min(scene_.legend.size(), num_columns_ * most_rows());
}

std::size_t CaptionLayout::most_rows() const {
  return std::max<std::size_t>(1, height_ / 3 / line_height_);
}
std::size_t CaptionLayout::num_title_rows() const {
  return std::min(scene_.title.size(), most_rows());
}
std::size_t CaptionLayout::num_legend_rows() const {
  return (num_entries_ + num_columns_ - 1) / num_columns_;
}

TextPlace CaptionLayout::title_place(std::size_t row) const {
  return {margin_, margin_ + row * line_height_, scale_};
}
TextPlace CaptionLayout::legend_place(std::size_t entry) const {
  const std::size_t top = height_ - margin_ - num_legend_rows() * line_height_;
  return {margin_ + entry % num_columns_ * (column_width_ + kGap * scale_),
          top + entry / num_columns_ * line_height_, scale_};
}

PictureBox CaptionLayout::room() const {
  const auto bottom = static_cast<double>(
      num_entries_ == 0 ? height_ - margin_
                        : legend_place(0).y - std::min(margin_, legend_place(0).y));
  const auto margin = static_cast<double>(margin_);
  return {margin, static_cast<double>(title_place(num_title_rows()).y),
          static_cast<double>(width_) - margin, bottom};
}

void CaptionLayout::draw_entry(const TextPlace& place, const LegendEntry& entry,
                               Image* image) const {
  for (std::size_t y = place.y; y < std::min(place.y + kSwatch * scale_, image->height); ++y)
    for (std::size_t x = place.x; x < std::min(place.x + kSwatch * scale_, image->width); ++x)
      image->at(x, y) = entry.colour;
  draw_text({place.x + indent_, place.y, scale_},
            shortened_text(entry.text, scale_, column_width_ - indent_), kText, image);
}

void CaptionLayout::draw(Image* image) const {
  for (std::size_t i = 0; i < num_title_rows(); ++i)
    draw_text(title_place(i), shortened_text(scene_.title[i], scale_, width_ - 2 * margin_), kText,
              image);
  const bool is_whole = num_entries_ == scene_.legend.size();
  const std::size_t num_drawn = num_entries_ - (is_whole ? 0 : 1);
  for (std::size_t i = 0; i < num_drawn; ++i) draw_entry(legend_place(i), scene_.legend[i], image);
  if (!is_whole)
    draw_text(legend_place(num_drawn),
              "and " + std::to_string(scene_.legend.size() - num_drawn) + " more", kText, image);
}

}  // namespace veritope::internal
