// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "render/mark_shape_internal.h"
#include "render/mark_widths_internal.h"

namespace veritope::internal {
namespace {

constexpr std::size_t kEnough = 144;  // pixels: a square of 12 x 12
constexpr double kStep = 6;           // the rim of the mark in front takes kRim of it
constexpr double kWidest = 64;        // radius
// Marks of larger layers are everywhere. They are not widened, which would take long and hide the model.
constexpr std::size_t kMostInLayer = 2000;
constexpr double kBorder =
    0.75;  // pixels nearer to the border of a mark are not in exactly its colour

std::size_t pixel_at(double x, std::size_t count) {
  return static_cast<std::size_t>(std::clamp(std::floor(x), 0.0, static_cast<double>(count)));
}

// Which mark each pixel shows, as far as marks have been painted.
class Coverage {
 public:
  Coverage(std::size_t width, std::size_t height)
      : width_(width), height_(height), shown_(width * height, kNothing) {}

  struct Count {
    std::size_t all = 0, seen = 0;
  };
  // The pixels that a mark of this radius has, and those where it is in front, or a mark of its colour or its rim is.
  Count count(const FlatMark& mark, double radius) const {
    Count out;
    const std::uint32_t code = code_of(mark.colour);
    for_each_pixel(mark, radius - kBorder, [&](std::size_t i) {
      ++out.all;
      if (shown_[i] == kNothing || (shown_[i] & ~kRimBit) == code) ++out.seen;
    });
    return out;
  }
  // Paints marks behind what is there; their borders as rims.
  void add(const std::vector<FlatMark>& marks, std::size_t first, std::size_t last) {
    for (std::size_t m = first; m < last; ++m)
      paint(marks[m], marks[m].radius - kBorder, code_of(marks[m].colour));
    for (std::size_t m = first; m < last; ++m)
      paint(marks[m], marks[m].radius + kRim, kRimBit | code_of(marks[m].colour));
  }
  std::size_t num_pixels(Colour colour) const {
    return static_cast<std::size_t>(std::count(shown_.begin(), shown_.end(), code_of(colour)));
  }

 private:
  static constexpr std::uint32_t kNothing = 0, kColour = 1 << 24, kRimBit = 1 << 25;
  static std::uint32_t code_of(Colour c) {
    return kColour | std::uint32_t{c.red} << 16 | std::uint32_t{c.green} << 8 | c.blue;
  }
  void paint(const FlatMark& mark, double radius, std::uint32_t code) {
    for_each_pixel(mark, radius, [&](std::size_t i) {
      if (shown_[i] == kNothing) shown_[i] = code;
    });
  }
  template <typename Visit>
  void for_each_pixel(FlatMark mark, double radius, Visit visit) const {
    if (!(radius > 0)) return;
    mark.radius = radius;
    const MarkShape shape(mark);
    const auto [least, most] = std::minmax(mark.a.y, mark.b.y);
    const std::size_t last = pixel_at(most + radius + 1, height_);
    for (std::size_t row = pixel_at(least - radius, height_); row < last; ++row) {
      const double y = static_cast<double>(row) + 0.5;
      const auto [left, right] = shape.range_in_row(y);
      const std::size_t end = pixel_at(right, width_);
      for (std::size_t column = pixel_at(left, width_); column < end; ++column) {
        const double x = static_cast<double>(column) + 0.5;
        if (shape.squared_distance(x, y, shape.nearest(x, y)) <= radius * radius)
          visit(row * width_ + column);
      }
    }
  }

  std::size_t width_, height_;
  std::vector<std::uint32_t> shown_;
};

// Until it is seen around the marks in front of it. A mark among so many that this does not help stays as it is.
void widen_if_hidden(const Coverage& coverage, FlatMark* mark) {
  const Coverage::Count at_first = coverage.count(*mark, mark->radius);
  const std::size_t wanted = std::min(kEnough, at_first.all / 2);
  std::size_t seen = at_first.seen;
  double radius = mark->radius;
  while (seen < wanted && radius + kStep <= kWidest) {
    radius += kStep;
    seen = coverage.count(*mark, radius).seen;
  }
  if (seen >= wanted) mark->radius = radius;
}

// The first mark of each colour in [first, last) that covers too little.
void widen_if_tiny(const Coverage& covered, const Coverage& before, std::size_t first,
                   std::size_t last, std::vector<FlatMark>* marks) {
  std::vector<Colour> done;
  for (std::size_t m = first; m < last; ++m) {
    FlatMark& mark = (*marks)[m];
    if (std::find(done.begin(), done.end(), mark.colour) != done.end()) continue;
    done.push_back(mark.colour);
    if (covered.num_pixels(mark.colour) >= kEnough) continue;
    while (before.count(mark, mark.radius).seen < kEnough && mark.radius + kStep <= kWidest)
      mark.radius += kStep;
  }
}

}  // namespace

void widen_hidden_marks(std::size_t width, std::size_t height, FlatScene* scene) {
  std::vector<FlatMark>& marks = scene->marks;
  if (marks.empty() || marks.back().layer == 0) return;
  Coverage coverage(width, height);
  for (std::size_t last = marks.size(); last > 0 && marks[last - 1].layer > 0;) {
    std::size_t first = last;
    while (first > 0 && marks[first - 1].layer == marks[last - 1].layer) --first;
    for (std::size_t m = first; m < last && last - first <= kMostInLayer; ++m)
      widen_if_hidden(coverage, &marks[m]);
    Coverage with_layer = coverage;
    with_layer.add(marks, first, last);
    widen_if_tiny(with_layer, coverage, first, last, &marks);
    coverage.add(marks, first, last);
    last = first;
  }
}

}  // namespace veritope::internal
