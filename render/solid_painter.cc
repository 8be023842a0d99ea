// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/solid_painter_internal.h"

#include <algorithm>
#include <cmath>

#include "robust/base/parallel.h"

namespace veritope::internal {
namespace {

static_assert(kSamples == 3, "a pixel has a sample in its middle");

constexpr Colour kSolidColour{178, 196, 216}, kCutColour{236, 188, 120};

// The parabola through values at -1, 0 and 1, at x.
double parabola(const std::array<double, 3>& v, double x) {
  return v[1] + 0.5 * x * (v[2] - v[0] + x * (v[0] - 2 * v[1] + v[2]));
}

// Whether five heights, a pixel apart, are nearly those of a parabola, or the three in the middle those of a line.
bool is_smooth(const std::array<double, 5>& h) {
  constexpr double kMost = 0.2;  // of a side of a sample
  const auto bend = [&h](std::size_t i) { return h[i - 1] - 2 * h[i] + h[i + 1]; };
  if (std::abs(bend(2)) <= kMost) return true;
  return std::abs(bend(2) - bend(1)) <= kMost && std::abs(bend(3) - bend(2)) <= kMost;
}

}  // namespace

SolidPainter::SolidPainter(const SolidProbe& solid, const ValueCells& cells,
                           const ParallelView& view, const PictureOptions& options, WorkShare* work)
    : caster_(solid, cells),
      view_(view),
      width_(options.width),
      height_(options.height),
      middles_(options.width * options.height) {
  look_.has_outlines = options.has_outlines;
  look_.step = extent(cells.box()) / view.sample_side() / 32;
  WorkStep step(work, static_cast<double>(height_));
  parallel_for(height_, 1, options.jobs, [&](std::size_t, std::size_t y, std::size_t) {
    cast_middles(y);
    step.add(1);
  });
}

bool SolidPainter::is_hit() const {
  return std::any_of(middles_.begin(), middles_.end(),
                     [](const PixelRay& ray) { return ray.is_hit(); });
}

SolidPainter::PixelRay SolidPainter::cast(std::size_t column, std::size_t row,
                                          std::optional<double> guess, bool with_thin) const {
  const Point3d& toward = view_.toward();
  const ParametricRay ray{
      view_.to_space({static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5, 0}),
      {-toward[0], -toward[1], -toward[2]}};
  const RayAnswer answer = caster_.first_hit(ray, guess, with_thin);
  PixelRay out;
  if (answer.met_cells) out.flags |= kMet;
  if (!answer.hit) return out;
  out.height = -answer.hit->t;
  if (answer.hit->is_cut) out.flags |= kCut;
  if (answer.hit->is_thin) out.flags |= kThin;
  return out;
}

// From left to right: a hit is guessed from the two before it. So rows do not depend on each other.
void SolidPainter::cast_middles(std::size_t y) {
  std::optional<double> last, before;
  for (std::size_t x = 0; x < width_; ++x) {
    const std::optional<double> guess = last && before ? std::optional(2 * *last - *before) : last;
    PixelRay& ray = middles_[y * width_ + x];
    ray = cast(x * kSamples + 1, y * kSamples + 1, guess, true);
    before = last;
    last = ray.is_hit() ? std::optional(-ray.height) : std::nullopt;
  }
}

// Beyond the picture there is nothing.
SolidPainter::Neighbours SolidPainter::neighbours_of(std::size_t x, std::size_t y) const {
  Neighbours out;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < 5; ++j) {
      const std::size_t row = y + i - 2, column = x + j - 2;  // wraps to huge numbers
      if (row < height_ && column < width_) out[i][j] = middles_[row * width_ + column];
    }
  return out;
}

// Infinite differences, where a ray misses, are not smooth.
bool SolidPainter::are_smooth(const Neighbours& near) {
  constexpr std::array<std::array<int, 2>, 4> kLines = {{{1, 0}, {0, 1}, {1, 1}, {1, -1}}};
  return std::all_of(kLines.begin(), kLines.end(), [&near](const std::array<int, 2>& line) {
    std::array<double, 5> heights;
    for (int k = -2; k <= 2; ++k)
      heights[static_cast<std::size_t>(k + 2)] =
          near[static_cast<std::size_t>(2 + k * line[0])][static_cast<std::size_t>(2 + k * line[1])]
              .height;
    return is_smooth(heights);
  });
}

void SolidPainter::fill_pixel(std::size_t x, std::size_t y, SampleLayer& layer) const {
  const Neighbours near = neighbours_of(x, y);
  const PixelRay& middle = near[2][2];
  bool are_met = false, are_thin = false, are_alike = true;
  for (std::size_t i = 1; i <= 3; ++i)
    for (std::size_t j = 1; j <= 3; ++j) {
      const PixelRay& ray = near[i][j];
      are_met = are_met || (ray.flags & kMet) != 0;
      are_thin = are_thin || (ray.flags & kThin) != 0;
      are_alike = are_alike && ray.is_hit() && ((ray.flags ^ middle.flags) & kCut) == 0;
    }
  if (!are_met) return;
  if (are_alike && !are_thin && are_smooth(near))
    interpolate_pixel(near, x, y, layer);
  else
    cast_pixel(middle, x, y, are_thin, layer);
}

void SolidPainter::interpolate_pixel(const Neighbours& near, std::size_t x, std::size_t y,
                                     SampleLayer& layer) {
  for (std::size_t i = 0; i < kSamples; ++i)
    for (std::size_t j = 0; j < kSamples; ++j) {
      std::array<double, 3> lines;
      for (std::size_t k = 0; k < 3; ++k)
        lines[k] = parabola({near[k + 1][1].height, near[k + 1][2].height, near[k + 1][3].height},
                            (static_cast<double>(j) - 1) / 3);
      PixelRay ray = near[2][2];
      ray.height = parabola(lines, (static_cast<double>(i) - 1) / 3);
      show(ray, x * kSamples + j, y * kSamples + i, layer);
    }
}

// In each row of samples a hit is guessed from those before it.
void SolidPainter::cast_pixel(const PixelRay& middle, std::size_t x, std::size_t y, bool with_thin,
                              SampleLayer& layer) const {
  for (std::size_t i = 0; i < kSamples; ++i) {
    std::optional<double> last, before;
    if (middle.is_hit()) last = -middle.height;
    for (std::size_t j = 0; j < kSamples; ++j) {
      const std::size_t row = y * kSamples + i, column = x * kSamples + j;
      const std::optional<double> guess = j == 2 && last && before ? 2 * *last - *before : last;
      const PixelRay ray = i == 1 && j == 1 ? middle : cast(column, row, guess, with_thin);
      if (!ray.is_hit()) continue;
      show(ray, column, row, layer);
      before = last;
      last = -ray.height;
    }
  }
}

void SolidPainter::show(const PixelRay& ray, std::size_t column, std::size_t row,
                        SampleLayer& layer) {
  LayerSample& sample = layer.at(column, row);
  sample.height = ray.height;
  sample.colour = (ray.flags & kCut) != 0 ? kCutColour : kSolidColour;
}

void SolidPainter::draw(std::size_t first, std::size_t last, Image* image) const {
  constexpr std::size_t kReachPixels = 2;  // of normals, and of outlines that compare them
  static_assert(2 * SampleLayer::kReach <= kReachPixels * kSamples);
  const std::size_t begin = first - std::min(first, kReachPixels),
                    end = std::min(last + kReachPixels, height_);
  SampleLayer layer({width_ * kSamples, begin * kSamples, (end - begin) * kSamples});
  for (std::size_t y = begin; y < end; ++y)
    for (std::size_t x = 0; x < width_; ++x) fill_pixel(x, y, layer);
  layer.find_normals();
  layer.draw(first, last, look_, image);
}

}  // namespace veritope::internal
