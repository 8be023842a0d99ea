// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/cast_solid.h"

#include <algorithm>

#include "render/grid_painter_internal.h"
#include "render/parallel_view_internal.h"
#include "render/picture_hull_internal.h"
#include "render/picture_room_internal.h"
#include "render/solid_painter_internal.h"
#include "robust/base/parallel.h"

namespace veritope {
namespace {

using namespace internal;

constexpr Colour kWhitePaper{255, 255, 255};
constexpr std::size_t kBandRows = 16;  // of pixels

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
  const PictureBox room = picture_room(options);
  // First where the solid is, roughly, then cells of some pixels each: the picture shows what they contain.
  constexpr double kCoarse = 0x1p-6, kCellPixels = 4;
  const std::vector<Box3d> boxes =
      ValueCells(solid, bounds, kCoarse * extent(bounds), options.jobs, work).solid_boxes();
  if (boxes.empty()) return nothing_to_see();
  Box3d part = empty_box();
  for (const Box3d& box : boxes) part = hull(part, box);
  const ParallelView whole(part, options.view, room);
  const ParallelView rough = whole.fitted(picture_of_boxes(boxes, whole), room);
  const ValueCells cells(solid, part, kCellPixels * kSamples * rough.sample_side(), options.jobs,
                         work);
  if (cells.solid_boxes().empty()) return nothing_to_see();
  const ParallelView view = rough.fitted(picture_of_boxes(cells.solid_boxes(), rough), room);
  const SolidPainter painter(solid, cells, view, options, work);
  if (!painter.is_hit()) return nothing_to_see();
  return painted(painter, options, work);
}

Result<Image> draw_point_grid(const PointGrid& grid, const PictureOptions& options,
                              WorkShare* work) {
  if (const Status status = check_picture_options(options); !status) return status.error();
  return painted(GridPainter(grid, picture_room(options), options), options, work);
}

}  // namespace veritope
