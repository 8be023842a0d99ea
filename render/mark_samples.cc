// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/mark_samples_internal.h"

#include <algorithm>
#include <cmath>

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

// A mark, asked for one sample after the other.
class MarkShape {
 public:
  explicit MarkShape(const FlatMark& mark)
      : mark_(mark),
        dx_(mark.b.x - mark.a.x),
        dy_(mark.b.y - mark.a.y),
        square_(dx_ * dx_ + dy_ * dy_) {}

  double radius_of_rim() const { return mark_.radius + kRim; }
  // An interval of x that contains all points of the mark and its rim in a row.
  std::array<double, 2> range_in_row(double y) const {
    double from = 0, to = 1;
    if (std::abs(dy_) > radius_of_rim()) {
      const double s = (y - radius_of_rim() - mark_.a.y) / dy_,
                   t = (y + radius_of_rim() - mark_.a.y) / dy_;
      from = std::clamp(std::min(s, t), 0.0, 1.0), to = std::clamp(std::max(s, t), 0.0, 1.0);
    }
    const double p = mark_.a.x + from * dx_, q = mark_.a.x + to * dx_;
    return {std::min(p, q) - radius_of_rim() - 1, std::max(p, q) + radius_of_rim() + 1};
  }
  // Where the point of the segment nearest to (x, y) is, from 0 at a to 1 at b. A segment that looks like a point is
  // seen from its near end.
  double nearest(double x, double y) const {
    constexpr double kShort = 0x1p-40;  // in pixels squared
    if (square_ < kShort) return mark_.a.depth <= mark_.b.depth ? 0 : 1;
    return std::clamp(((x - mark_.a.x) * dx_ + (y - mark_.a.y) * dy_) / square_, 0.0, 1.0);
  }
  double squared_distance(double x, double y, double at) const {
    const double u = x - (mark_.a.x + at * dx_), v = y - (mark_.a.y + at * dy_);
    return u * u + v * v;
  }
  double depth(double at) const {
    return std::clamp(mark_.a.depth + at * (mark_.b.depth - mark_.a.depth), 0.0, kDeepest);
  }

 private:
  const FlatMark& mark_;
  double dx_, dy_, square_;
};

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
