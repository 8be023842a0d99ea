// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/mark_samples_internal.h"

#include <algorithm>
#include <cmath>

#include "render/mark_shape_internal.h"

namespace veritope::internal {
namespace {

constexpr double kPerPixel = kSamples;

// The sample that contains a coordinate given in pixels, or the nearest in [0, count].
std::uint32_t sample_at(double pixels, std::size_t count) {
  const double sample = std::floor(pixels * kPerPixel);
  return static_cast<std::uint32_t>(std::clamp(sample, 0.0, static_cast<double>(count)));
}

double centre_of(std::size_t sample) {
  return (static_cast<double>(sample) + 0.5) * (1 / kPerPixel);
}

void keep_nearer(std::uint64_t key, std::uint64_t* kept) { *kept = std::min(*kept, key); }

std::uint32_t mark_of(std::uint64_t key) { return ~order_of(key); }

}  // namespace

std::array<std::uint32_t, 2> rows_of_mark(const FlatMark& mark, std::size_t num_rows) {
  const double reach = mark.radius + kRim;
  const auto [least, most] = std::minmax(mark.a.y, mark.b.y);
  return {sample_at(least - reach, num_rows), sample_at(most + reach + 1, num_rows)};
}

MarkSamples::MarkSamples(const SampleRows& rows, const FlatScene& scene)
    : rows_(rows), scene_(&scene), marks_(rows.size(), kNoKey), rims_(rows.size(), kNoKey) {}

void MarkSamples::add(std::uint32_t mark) {
  const MarkShape shape(scene_->marks[mark]);
  const double radius = scene_->marks[mark].radius, reach = shape.radius_of_rim();
  const auto [first, last] = rows_of_mark(scene_->marks[mark], rows_.end());
  for (std::size_t row = std::max<std::size_t>(first, rows_.first); row < last; ++row) {
    const double y = centre_of(row);
    const auto [left, right] = shape.range_in_row(y);
    const std::size_t end = sample_at(right, rows_.width);
    for (std::size_t column = sample_at(left, rows_.width); column < end; ++column) {
      const double x = centre_of(column), at = shape.nearest(x, y),
                   square = shape.squared_distance(x, y, at);
      if (square > reach * reach) continue;
      const std::uint64_t key = depth_key(shape.depth(at), ~mark, false);
      keep_nearer(key, &(square <= radius * radius ? marks_ : rims_)[rows_.index(column, row)]);
    }
  }
}

void MarkSamples::draw_over(std::span<Colour> colours) const {
  constexpr auto kWellInFront = static_cast<std::uint64_t>(kDeepest / 32);
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    const std::uint64_t mark = marks_[i], rim = rims_[i];
    if (rim != kNoKey && (mark == kNoKey || depth_of(rim) + kWellInFront < depth_of(mark))) {
      colours[i] = rim_colour(scene_->marks[mark_of(rim)].colour);
    } else if (mark != kNoKey) {
      colours[i] = scene_->marks[mark_of(mark)].colour;
    }
  }
}

Colour rim_colour(Colour colour) {
  constexpr Colour kWhite{255, 255, 255}, kDark{48, 48, 48};
  constexpr int kBright = 165;
  const int luminance = (2126 * colour.red + 7152 * colour.green + 722 * colour.blue) / 10000;
  return luminance > kBright ? kDark : kWhite;
}

}  // namespace veritope::internal
