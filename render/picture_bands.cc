// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/picture_bands_internal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "render/mark_samples_internal.h"
#include "render/surface_samples_internal.h"
#include "render/triangle_samples_internal.h"
#include "robust/base/parallel.h"

namespace veritope::internal {
namespace {

constexpr std::size_t kRowsPerBand = 16;  // of pixels

TriangleSamples samples_of(const FlatScene& scene, const FlatTriangle& t) {
  return {scene.corners[t.corners[0]], scene.corners[t.corners[1]], scene.corners[t.corners[2]]};
}

// The rows of samples of each triangle, or of each mark.
struct RowRange {
  std::uint16_t first, last;
  bool meets(const SampleRows& rows) const { return first < rows.end() && rows.first < last; }
};
template <typename Row>
RowRange row_range(Row first, Row last) {
  static_assert(kMostPictureSide * kSamples <= std::numeric_limits<std::uint16_t>::max());
  return {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(last)};
}

struct RowRanges {
  std::vector<RowRange> triangles, marks;
};
RowRanges row_ranges(const FlatScene& scene, std::size_t num_rows) {
  RowRanges out;
  out.triangles.reserve(scene.triangles.size());
  for (const FlatTriangle& t : scene.triangles) {
    const TriangleSamples samples = samples_of(scene, t);
    const bool is_seen = !samples.is_flat() && t.paint.opacity > 0;
    out.triangles.push_back(is_seen ? row_range(samples.rows().first, samples.rows().last)
                                    : RowRange{0, 0});
  }
  out.marks.reserve(scene.marks.size());
  for (const FlatMark& mark : scene.marks) {
    const auto [first, last] = rows_of_mark(mark, num_rows);
    out.marks.push_back(row_range(first, last));
  }
  return out;
}

// Adds the triangles or marks [first, last) that meet the rows.
template <typename Samples>
void add_meeting(const std::vector<RowRange>& ranges, std::size_t first, std::size_t last,
                 const SampleRows& rows, Samples* samples) {
  for (std::size_t i = first; i < last; ++i)
    if (ranges[i].meets(rows)) samples->add(static_cast<std::uint32_t>(i));
}
bool is_any_meeting(const std::vector<RowRange>& ranges, std::size_t first, std::size_t last,
                    const SampleRows& rows) {
  const auto at = [&](std::size_t i) { return ranges.begin() + static_cast<std::ptrdiff_t>(i); };
  return std::any_of(at(first), at(last), [&](const RowRange& r) { return r.meets(rows); });
}

// Where each layer of marks begins, and the end of the last one.
std::vector<std::size_t> layer_bounds(const std::vector<FlatMark>& marks) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (i == 0 || marks[i].layer != marks[i - 1].layer) out.push_back(i);
  out.push_back(marks.size());
  return out;
}

// The mean of the samples of a pixel, rounded. Equal samples give their colour exactly.
Colour mean_colour(std::span<const Colour> colours, const SampleRows& rows, std::size_t x,
                   std::size_t y) {
  constexpr std::uint32_t kCount = kSamples * kSamples;
  std::uint32_t red = kCount / 2, green = kCount / 2, blue = kCount / 2;
  for (std::size_t row = y * kSamples; row < (y + 1) * kSamples; ++row)
    for (std::size_t column = x * kSamples; column < (x + 1) * kSamples; ++column) {
      const Colour& c = colours[rows.index(column, row)];
      red += c.red, green += c.green, blue += c.blue;
    }
  const auto channel = [](std::uint32_t sum) { return static_cast<std::uint8_t>(sum / kCount); };
  return {channel(red), channel(green), channel(blue)};
}

// Draws bands of one scene.
class BandPainter {
 public:
  BandPainter(const FlatScene& scene, bool with_outlines, Image* image)
      : scene_(scene),
        with_outlines_(with_outlines),
        image_(*image),
        num_rows_(image->height * kSamples),
        ranges_(row_ranges(scene, num_rows_)),
        layers_(layer_bounds(scene.marks)) {}

  // The rows [first, last) of pixels.
  void draw(std::size_t first, std::size_t last) {
    const SampleRows rows{image_.width * kSamples, first * kSamples, (last - first) * kSamples};
    std::vector<Colour> colours(rows.size(), image_.at(0, first));
    draw_surfaces(rows, colours);
    draw_marks(rows, colours);
    for (std::size_t y = first; y < last; ++y)
      for (std::size_t x = 0; x < image_.width; ++x)
        image_.at(x, y) = mean_colour(colours, rows, x, y);
  }

 private:
  void draw_surfaces(const SampleRows& rows, std::span<Colour> colours) const {
    constexpr std::size_t kReach = SurfaceSamples::kReach;
    const std::size_t num_triangles = ranges_.triangles.size();
    if (!is_any_meeting(ranges_.triangles, 0, num_triangles, rows)) return;
    const std::size_t first = rows.first - std::min(rows.first, kReach),
                      last = std::min(rows.end() + kReach, num_rows_);
    const SampleRows wider{rows.width, first, last - first};
    SurfaceSamples samples(wider, scene_);
    add_meeting(ranges_.triangles, 0, num_triangles, wider, &samples);
    samples.draw_over(rows, with_outlines_, colours);
  }
  void draw_marks(const SampleRows& rows, std::span<Colour> colours) const {
    for (std::size_t k = 0; k + 1 < layers_.size(); ++k) {
      if (!is_any_meeting(ranges_.marks, layers_[k], layers_[k + 1], rows)) continue;
      MarkSamples samples(rows, scene_);
      add_meeting(ranges_.marks, layers_[k], layers_[k + 1], rows, &samples);
      samples.draw_over(colours);
    }
  }

  const FlatScene& scene_;
  bool with_outlines_;
  Image& image_;
  std::size_t num_rows_;  // of samples
  RowRanges ranges_;
  std::vector<std::size_t> layers_;
};

}  // namespace

double num_drawn_samples(const FlatScene& scene) {
  double sum = 0;
  for (const FlatTriangle& t : scene.triangles)
    sum += static_cast<double>(samples_of(scene, t).area());
  for (const FlatMark& m : scene.marks) {
    const double width = 2 * (m.radius + kRim),
                 length = std::max(std::abs(m.a.x - m.b.x), std::abs(m.a.y - m.b.y));
    sum += width * (width + length) * static_cast<double>(kSamples * kSamples);
  }
  return sum;
}

void draw_bands(const FlatScene& scene, bool with_outlines, unsigned jobs, Image* image) {
  BandPainter painter(scene, with_outlines, image);
  parallel_for(
      image->height, kRowsPerBand, jobs,
      [&painter](std::size_t, std::size_t first, std::size_t last) { painter.draw(first, last); });
}

}  // namespace veritope::internal
