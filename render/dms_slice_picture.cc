// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/dms_slice_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "render/colour_map.h"
#include "render/dms_sampler_internal.h"

namespace veritope {
namespace {

using internal::DmsSampler;

constexpr Colour kPaper{255, 255, 255}, kLine{30, 30, 30};

std::vector<double> values_of(const DmsField& field, const DmsRayGrid& grid, unsigned jobs) {
  std::vector<double> out(grid.columns * grid.rows);
  internal::draw_rows(
      field, grid.rows, jobs, [&](DmsSampler& sampler, std::size_t first, std::size_t last) {
        std::vector<Vec3d> points(grid.columns);
        for (std::size_t j = first; j < last; ++j) {
          for (std::size_t i = 0; i < grid.columns; ++i)
            points[i] = internal::point_of(grid, static_cast<double>(i), static_cast<double>(j), 0);
          const auto values = sampler.values(points);
          std::copy(values.begin(), values.end(),
                    out.begin() + static_cast<std::ptrdiff_t>(j * grid.columns));
        }
      });
  return out;
}

// Which of the parts of the range the value lies in.
class Bands {
 public:
  Bands(double low, double high, std::size_t num_lines)
      : low_(low), scale_(static_cast<double>(num_lines + 1) / (high - low)) {}
  double operator()(double value) const { return std::floor((value - low_) * scale_); }

 private:
  double low_, scale_;
};

void draw_isolines(const std::vector<double>& values, const Bands& band, Image& image) {
  for (std::size_t j = 0; j < image.height; ++j)
    for (std::size_t i = 0; i < image.width; ++i) {
      const double here = values[j * image.width + i];
      if (std::isnan(here)) continue;
      const auto is_beyond = [&](std::size_t x, std::size_t y) {
        if (x == image.width || y == image.height) return false;
        const double there = values[y * image.width + x];
        return !std::isnan(there) && band(there) != band(here);
      };
      if (is_beyond(i + 1, j) || is_beyond(i, j + 1)) image.at(i, j) = kLine;
    }
}

}  // namespace

Result<DmsSlicePicture> draw_dms_slice(const DmsField& field, const DmsSlicePlane& cut,
                                       const PictureOptions& look, const DmsSliceOptions& options) {
  if (const Status status = field.check(); !status) return status.error();
  const Result<DmsRayGrid> grid = points_of_picture(field.box(), cut, look);
  if (!grid) return grid.error();
  const std::vector<double> values = values_of(field, *grid, look.jobs);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double low = kInfinity, high = -kInfinity;
  for (const double v : values)
    if (!std::isnan(v)) low = std::min(low, v), high = std::max(high, v);
  if (low > high)
    return Error{Code::kEmpty,
                 {},
                 field.solid != nullptr ? "no pixel shows a point of the solid"
                                        : "no pixel shows a point of the domain"};
  if (options.range) low = (*options.range)[0], high = (*options.range)[1];
  if (!std::isfinite(high - low))
    return Error{Code::kNotFinite, {}, "values of the attribute are beyond binary64"};
  DmsSlicePicture out{Image(look.width, look.height, kPaper), *grid, low, high};
  const double width = high > low ? high - low : 1;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isnan(values[i])) out.image.pixels[i] = map_colour((values[i] - low) / width);
  if (options.num_isolines > 0)
    draw_isolines(values, Bands(low, low + width, options.num_isolines), out.image);
  return out;
}

}  // namespace veritope
