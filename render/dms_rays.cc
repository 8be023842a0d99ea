// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/dms_rays.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "render/parallel_view_internal.h"
#include "render/picture_hull_internal.h"
#include "render/picture_room_internal.h"

namespace veritope {
namespace {

using internal::ParallelView;

Error wrong_box() {
  return {Code::kOverLimit,
          {},
          "the domain has coordinates beyond binary64, or its longest side is not between "
          "2^-900 and 2^900"};
}

Status check_rays(const Box3d& box, const PictureOptions& look) {
  if (Status status = check_picture_options(look); !status) return status;
  if (look.width * look.height > kMostDmsPixels)
    return bad_argument("a picture of a domain has at most 16777216 pixels, not " +
                        std::to_string(look.width * look.height));
  return internal::is_viewable(box) ? ok_status() : wrong_box();
}

// The heights of the corners of a box, from the least to the greatest.
struct Heights {
  double least = 0, most = 0;
};
Heights heights_of(const Box3d& box, const ParallelView& view) {
  Heights out;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Point3d p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = (corner >> k & 1U) != 0 ? box.hi[k] : box.lo[k];
    const double height = view.to_picture(p).height;
    if (corner == 0) out = {height, height};
    out = {std::min(out.least, height), std::max(out.most, height)};
  }
  return out;
}

Point3d step_between(const Point3d& a, const Point3d& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// Pixel centres at one height; `along` goes `depth` below it.
DmsRayGrid grid_of(const ParallelView& view, const PictureOptions& look, double height,
                   double depth) {
  constexpr double kPixel = internal::kSamples, kHalf = kPixel / 2;
  DmsRayGrid grid;
  grid.columns = look.width, grid.rows = look.height;
  const auto at = [&](double x, double y, double h) { return view.to_space({x, y, h}); };
  grid.origin = at(kHalf, kHalf, height);
  grid.right = step_between(at(kHalf + kPixel, kHalf, height), grid.origin);
  grid.down = step_between(at(kHalf, kHalf + kPixel, height), grid.origin);
  grid.along = step_between(at(kHalf, kHalf, height - depth), grid.origin);
  return grid;
}

Rational exact_dot(const DmsPoint& a, const DmsPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

DmsPoint exact_point(const Point3d& p) {
  return {Rational::from_double(p[0]), Rational::from_double(p[1]), Rational::from_double(p[2])};
}

// The direction against a vector, scaled so that no coordinate overflows.
Point3d against(const DmsPoint& vector) {
  Rational most;
  for (const Rational& x : vector) most = std::max(most, x < Rational(0) ? -x : x);
  Point3d out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = nearest_double(-vector[k] / most);
  return out;
}

}  // namespace

Box3d domain_box(const DmsModel& model) {
  Box3d box = empty_box();
  for (const TetrahedronCorners& tetrahedron : model.tetrahedra)
    for (const std::uint32_t vertex : tetrahedron)
      for (std::size_t k = 0; k < 3; ++k) {
        const Rational& x = model.clouds[vertex][0][k];
        box.lo[k] = std::min(box.lo[k], round_down(x));
        box.hi[k] = std::max(box.hi[k], round_up(x));
      }
  return box;
}

Result<DmsRayGrid> rays_of_picture(const Box3d& box, const PictureOptions& look) {
  if (const Status status = check_rays(box, look); !status) return status.error();
  const ParallelView view(box, look.view, internal::picture_room(look));
  const Heights heights = heights_of(box, view);
  const double margin = (heights.most - heights.least) / 64;
  return grid_of(view, look, heights.most + margin, heights.most - heights.least + 2 * margin);
}

Result<DmsRayGrid> points_of_picture(const Box3d& box, const DmsSlicePlane& cut,
                                     const PictureOptions& look) {
  PictureOptions across = look;
  across.view = against(cut.vector);
  if (const Status status = check_rays(box, across); !status) return status.error();
  const ParallelView view(box, across.view, internal::picture_room(look));
  DmsRayGrid grid = grid_of(view, look, 0, 1);
  // Onto the plane, exactly, and rounded once.
  DmsPoint origin = exact_point(grid.origin);
  const Rational factor =
      (cut.number - exact_dot(cut.vector, origin)) / exact_dot(cut.vector, cut.vector);
  for (std::size_t k = 0; k < 3; ++k)
    grid.origin[k] = nearest_double(origin[k] + factor * cut.vector[k]);
  return grid;
}

Result<DmsSlicePlane> middle_cut(const Box3d& box, const Point3d& view) {
  if (!is_finite(box)) return wrong_box();
  DmsSlicePlane cut;
  const DmsPoint lo = exact_point(box.lo), hi = exact_point(box.hi), direction = exact_point(view);
  DmsPoint middle;
  for (std::size_t k = 0; k < 3; ++k) {
    cut.vector[k] = -direction[k];
    middle[k] = (lo[k] + hi[k]) / Rational(2);
  }
  cut.number = exact_dot(cut.vector, middle);
  return cut;
}

}  // namespace veritope
