// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/grid_painter_internal.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/picture_hull_internal.h"

namespace veritope::internal {
namespace {

Colour colour_of(GridMark mark) {
  switch (mark) {
    case GridMark::kIn: return {88, 140, 200};
    case GridMark::kOn: return {244, 176, 60};
    case GridMark::kUndecided: return {160, 70, 180};
    case GridMark::kExcess: return {220, 50, 40};
    case GridMark::kNone: break;
  }
  return {255, 255, 255};
}

// From its low side, in units of the longest side.
Box3d unit_box(const ExactBox<3>& bounds) {
  const Rational longest = bounds.width();
  Box3d out{};
  for (std::size_t k = 0; k < 3; ++k) out.hi[k] = nearest_double(bounds[k].width() / longest);
  return out;
}

}  // namespace

// The first and the last mark of each line (i, j, k) for all k: the others lie between them.
template <typename Visit>
void GridPainter::for_each_end(Visit&& visit) const {
  const std::uint32_t n = grid_.n();
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      std::uint32_t first = 0, last = n;
      while (first < n && grid_.mark(i, j, first) == GridMark::kNone) ++first;
      if (first == n) continue;
      while (grid_.mark(i, j, last - 1) == GridMark::kNone) --last;
      visit(place(i, j, first));
      visit(place(i, j, last - 1));
    }
}

GridPainter::GridPainter(const PointGrid& grid, const PictureBox& room,
                         const PictureOptions& options)
    : grid_(grid),
      view_(unit_box(grid.bounds()), options.view, room),
      width_(options.width * kSamples) {
  constexpr double kShare = 0.36;  // of the least distance of points
  const Box3d box = unit_box(grid.bounds());
  double least = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double step = box.hi[axis] / grid.n();
    for (std::uint32_t i = 0; i < grid.n(); ++i) coordinates_[axis].push_back((i + 0.5) * step);
    least = std::min(least, step);
  }
  const double radius = kShare * least;
  PictureHull hull;
  for_each_end([&](const SamplePoint& p) { hull.add(p, radius / view_.sample_side()); });
  if (hull.box().left <= hull.box().right) view_ = view_.fitted(hull.box(), room);
  radius_ = std::max(radius / view_.sample_side(), 0.75);
  look_.haze = haze();
}

void GridPainter::draw(std::size_t first, std::size_t last, Image* image) const {
  SampleLayer layer({width_, first * kSamples, (last - first) * kSamples});
  for (std::uint32_t i = 0; i < grid_.n(); ++i)
    for (std::uint32_t j = 0; j < grid_.n(); ++j) draw_line(i, j, layer);
  layer.draw(first, last, look_, image);
}

SamplePoint GridPainter::place(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  return view_.to_picture({coordinates_[0][i], coordinates_[1][j], coordinates_[2][k]});
}

// The points (i, j, k) for all k that may meet the rows: their rows are linear in k.
void GridPainter::draw_line(std::uint32_t i, std::uint32_t j, SampleLayer& layer) const {
  const std::uint32_t n = grid_.n();
  const double begin = place(i, j, 0).y, end = place(i, j, n - 1).y,
               top = static_cast<double>(layer.rows().first) - radius_ - 1,
               bottom = static_cast<double>(layer.rows().end()) + radius_ + 1;
  std::uint32_t first = 0, last = n;
  const double step = n > 1 ? (end - begin) / (n - 1) : 0;
  if (std::abs(step) * n > 1) {  // else the line is a point, or nearly
    const double a = (top - begin) / step, b = (bottom - begin) / step;
    const auto whole = [n](double x) {
      return static_cast<std::uint32_t>(std::clamp(x, 0.0, static_cast<double>(n)));
    };
    first = whole(std::floor(std::min(a, b)));
    last = whole(std::ceil(std::max(a, b)) + 1);
  }
  for (std::uint32_t k = first; k < last; ++k)
    if (const GridMark mark = grid_.mark(i, j, k); mark != GridMark::kNone)
      draw_ball(place(i, j, k), colour_of(mark), layer);
}

// The first one of several balls that show the same height is in front.
void GridPainter::draw_ball(const SamplePoint& at, Colour colour, SampleLayer& layer) const {
  const auto range = [this](double middle, std::size_t first, std::size_t end) {
    const auto whole = [&](double x) {
      return static_cast<std::size_t>(
          std::clamp(x, static_cast<double>(first), static_cast<double>(end)));
    };
    return std::array{whole(std::floor(middle - radius_)), whole(std::ceil(middle + radius_))};
  };
  const auto rows = range(at.y, layer.rows().first, layer.rows().end()),
             columns = range(at.x, 0, layer.rows().width);
  for (std::size_t row = rows[0]; row < rows[1]; ++row)
    for (std::size_t column = columns[0]; column < columns[1]; ++column) {
      const double x = (static_cast<double>(column) + 0.5 - at.x) / radius_,
                   y = (at.y - static_cast<double>(row) - 0.5) / radius_,
                   square = 1 - x * x - y * y;
      if (!(square > 0)) continue;
      const double z = std::sqrt(square), height = at.height + radius_ * z;
      LayerSample& sample = layer.at(column, row);
      if (height <= sample.height) continue;
      sample = {
          height, {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)}, colour};
    }
}

// From the nearest to the farthest mark.
Haze GridPainter::haze() const {
  Haze out{std::numeric_limits<double>::infinity(), LayerSample::kNothing, 0.55};
  for_each_end([&](const SamplePoint& p) {
    out.lowest = std::min(out.lowest, p.height);
    out.highest = std::max(out.highest, p.height);
  });
  return out;
}

}  // namespace veritope::internal
