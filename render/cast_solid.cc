// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/cast_solid.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "render/parallel_view_internal.h"
#include "render/ray_caster_internal.h"
#include "render/sample_layer_internal.h"
#include "robust/base/parallel.h"

namespace veritope {
namespace {

using namespace internal;

constexpr Colour kWhitePaper{255, 255, 255};
constexpr Colour kSolidColour{178, 196, 216}, kCutColour{236, 188, 120};
constexpr std::size_t kBandRows = 16;  // of pixels

PictureBox room_of(const PictureOptions& options) {
  const auto width = static_cast<double>(options.width),
             height = static_cast<double>(options.height);
  const double margin = std::min(width, height) / 32;
  return {margin, margin, width - margin, height - margin};
}

Status check_bounds(const Box3d& bounds) {
  if (is_viewable(bounds)) return ok_status();
  return Error{Code::kOverLimit,
               {},
               "the box of the picture has coordinates beyond binary64, or its longest side is not "
               "between 2^-900 and 2^900"};
}

Error nothing_to_see() {
  return Error{Code::kEmpty, {}, "no point of the solid is seen in the box of the picture"};
}

// The rows of samples of pixels [first, last), and those around them that their looks depend on.
SampleRows rows_around(std::size_t first, std::size_t last, std::size_t reach,
                       const PictureOptions& options) {
  const std::size_t begin = first * kSamples - std::min(first * kSamples, reach),
                    end = std::min(last * kSamples + reach, options.height * kSamples);
  return {options.width * kSamples, begin, end - begin};
}

// The least rectangle around points in a picture, in samples.
class PictureHull {
 public:
  void add(const SamplePoint& p, double radius = 0) {
    box_ = {std::min(box_.left, p.x - radius), std::min(box_.top, p.y - radius),
            std::max(box_.right, p.x + radius), std::max(box_.bottom, p.y + radius)};
  }
  const PictureBox& box() const { return box_; }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  PictureBox box_{kInfinity, kInfinity, -kInfinity, -kInfinity};
};

PictureBox picture_of_boxes(const std::vector<Box3d>& boxes, const ParallelView& view) {
  PictureHull hull;
  for (const Box3d& box : boxes)
    for (unsigned corner = 0; corner < 8; ++corner) {
      Point3d p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = (corner >> k & 1U) != 0 ? box.hi[k] : box.lo[k];
      hull.add(view.to_picture(p));
    }
  return hull.box();
}

class SolidPainter {
 public:
  SolidPainter(const SolidProbe& solid, const ValueCells& cells, const ParallelView& view,
               const PictureOptions& options)
      : caster_(solid, cells), view_(view), options_(options) {
    look_.has_outlines = options.has_outlines;
    look_.step = extent(cells.box()) / view.sample_side() / 32;
  }

  void draw(std::size_t first, std::size_t last, Image* image) const {
    SampleLayer layer(rows_around(first, last, 2 * SampleLayer::kReach, options_));
    for (std::size_t row = layer.rows().first; row < layer.rows().end(); ++row)
      cast_row(row, layer);
    layer.find_normals();
    layer.draw(first, last, look_, image);
  }
  // Whether some ray hit.
  bool has_drawn() const { return has_drawn_; }

 private:
  // From left to right: a hit is guessed from the two before it. So rows do not depend on each other.
  void cast_row(std::size_t row, SampleLayer& layer) const {
    std::optional<double> last, before;
    for (std::size_t column = 0; column < layer.rows().width; ++column) {
      const std::optional<double> guess =
          last && before ? std::optional(2 * *last - *before) : last;
      const auto hit = caster_.first_hit(ray(column, row), guess);
      before = last;
      last = hit ? std::optional(hit->t) : std::nullopt;
      if (!hit) continue;
      LayerSample& sample = layer.at(column, row);
      has_drawn_ = true;
      sample.height = -hit->t;
      sample.colour = hit->is_cut ? kCutColour : kSolidColour;
    }
  }
  ParametricRay ray(std::size_t column, std::size_t row) const {
    const Point3d& toward = view_.toward();
    return {view_.to_space({static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5, 0}),
            {-toward[0], -toward[1], -toward[2]}};
  }

  mutable std::atomic<bool> has_drawn_ = false;
  RayCaster caster_;
  const ParallelView& view_;
  const PictureOptions& options_;
  SampleLayer::Look look_;
};

Colour colour_of(GridMark mark) {
  switch (mark) {
    case GridMark::kIn: return {88, 140, 200};
    case GridMark::kOn: return {244, 176, 60};
    case GridMark::kUndecided: return {160, 70, 180};
    case GridMark::kExcess: return {220, 50, 40};
    case GridMark::kNone: break;
  }
  return kWhitePaper;
}

Box3d box_of_grid(const ExactBox<3>& bounds) {
  Box3d out;
  for (std::size_t k = 0; k < 3; ++k)
    out.lo[k] = nearest_double(bounds[k].lo), out.hi[k] = nearest_double(bounds[k].hi);
  return out;
}

// Balls in the place of points.
class GridPainter {
 public:
  GridPainter(const PointGrid& grid, const ParallelView& view, const PictureBox& room,
              const PictureOptions& options)
      : grid_(grid), view_(view), options_(options) {
    constexpr double kShare = 0.36;  // of the least distance of points
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::uint32_t i = 0; i < grid.n(); ++i)
        coordinates_[axis].push_back(nearest_double(grid.coordinate(axis, i)));
      least = std::min(least, nearest_double(grid.bounds()[axis].width()) / grid.n());
    }
    const double radius = kShare * least;
    PictureHull hull;
    for_each_end([&](const SamplePoint& p) { hull.add(p, radius / view_.sample_side()); });
    if (hull.box().left <= hull.box().right) view_ = view_.fitted(hull.box(), room);
    radius_ = std::max(radius / view_.sample_side(), 0.75);
    look_.haze = haze();
  }

  void draw(std::size_t first, std::size_t last, Image* image) const {
    SampleLayer layer(rows_around(first, last, 0, options_));
    for (std::uint32_t i = 0; i < grid_.n(); ++i)
      for (std::uint32_t j = 0; j < grid_.n(); ++j) draw_line(i, j, layer);
    layer.draw(first, last, look_, image);
  }

 private:
  SamplePoint place(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return view_.to_picture({coordinates_[0][i], coordinates_[1][j], coordinates_[2][k]});
  }

  // The points (i, j, k) for all k that may meet the rows: their rows are linear in k.
  void draw_line(std::uint32_t i, std::uint32_t j, SampleLayer& layer) const {
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
  void draw_ball(const SamplePoint& at, Colour colour, SampleLayer& layer) const {
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

  // The first and the last mark of each line (i, j, k) for all k: the others lie between them.
  template <typename Visit>
  void for_each_end(Visit&& visit) const {
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
  // From the nearest to the farthest mark.
  Haze haze() const {
    Haze out{std::numeric_limits<double>::infinity(), LayerSample::kNothing, 0.55};
    for_each_end([&](const SamplePoint& p) {
      out.lowest = std::min(out.lowest, p.height);
      out.highest = std::max(out.highest, p.height);
    });
    return out;
  }

  const PointGrid& grid_;
  ParallelView view_;
  const PictureOptions& options_;
  std::array<std::vector<double>, 3> coordinates_;
  double radius_ = 1;
  SampleLayer::Look look_;
};

// Bands of rows, which do not depend on each other.
template <typename Painter>
Image painted(const Painter& painter, const PictureOptions& options, WorkShare* work) {
  Image image(options.width, options.height, kWhitePaper);
  WorkStep step(work, static_cast<double>(options.height));
  parallel_for(options.height, kBandRows, options.jobs,
               [&](std::size_t, std::size_t first, std::size_t last) {
                 painter.draw(first, last, &image);
                 step.add(static_cast<double>(last - first));
               });
  return image;
}

}  // namespace

Result<Image> cast_solid(const SolidProbe& solid, const Box3d& bounds,
                         const PictureOptions& options, WorkShare* work) {
  if (const Status status = check_picture_options(options); !status) return status.error();
  if (const Status status = check_bounds(bounds); !status) return status.error();
  const PictureBox room = room_of(options);
  // Where the solid is, roughly, so that it fills the picture.
  constexpr double kCoarse = 0x1p-6;
  const std::vector<Box3d> boxes =
      ValueCells(solid, bounds, kCoarse * extent(bounds), options.jobs, work).solid_boxes();
  if (boxes.empty()) return nothing_to_see();
  Box3d part = empty_box();
  for (const Box3d& box : boxes) part = hull(part, box);
  const ParallelView whole(part, options.view, room);
  const ParallelView view = whole.fitted(picture_of_boxes(boxes, whole), room);
  constexpr double kCellPixels = 3;
  const ValueCells cells(solid, part, kCellPixels * kSamples * view.sample_side(), options.jobs,
                         work);
  const SolidPainter painter(solid, cells, view, options);
  Image image = painted(painter, options, work);
  if (!painter.has_drawn()) return nothing_to_see();
  return image;
}

Result<Image> draw_point_grid(const PointGrid& grid, const PictureOptions& options,
                              WorkShare* work) {
  if (const Status status = check_picture_options(options); !status) return status.error();
  const Box3d bounds = box_of_grid(grid.bounds());
  if (const Status status = check_bounds(bounds); !status) return status.error();
  const PictureBox room = room_of(options);
  const ParallelView view(bounds, options.view, room);
  return painted(GridPainter(grid, view, room, options), options, work);
}

}  // namespace veritope
