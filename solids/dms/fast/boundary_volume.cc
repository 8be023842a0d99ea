// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fast/boundary_volume.h"

#include <array>
#include <utility>
#include <vector>

#include "interval/upward.h"
#include "solids/dms/dms_knots.h"
#include "solids/dms/fast/fast_dms.h"

namespace veritope {
namespace {

using IntervalPoint = std::array<Interval, 3>;

constexpr std::size_t kMostParts = 64;  // of an edge

std::size_t points_of_face(std::size_t parts) { return (parts + 1) * (parts + 2) / 2; }

// The images of the points with the coordinates (i, j) / parts on a face; i goes first, j along the second edge.
std::vector<IntervalPoint> images(const std::array<DmsPoint, 3>& corners, std::size_t parts,
                                  FastDms& map) {
  std::vector<Vec3d> points;
  std::vector<std::pair<std::size_t, DmsPoint>> exact;
  const DmsPoint first = difference(corners[1], corners[0]),
                 second = difference(corners[2], corners[0]);
  for (std::size_t i = 0; i <= parts; ++i)
    for (std::size_t j = 0; i + j <= parts; ++j) {
      DmsPoint p = corners[0];
      for (std::size_t c = 0; c < 3; ++c)
        p[c] += (Rational(i) * first[c] + Rational(j) * second[c]) / Rational(parts);
      points.push_back({nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])});
      exact.emplace_back(exact.size(), std::move(p));
    }
  const std::size_t n = map.num_components();
  std::vector<double> value(points.size() * n), bound(points.size() * n);
  FastDmsOutput out;
  out.value = value.data();
  out.value_bound = bound.data();
  map.evaluate(points, out, exact);
  std::vector<IntervalPoint> found(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [lo, hi] = enclosure_of(value[i * n + c], bound[i * n + c]);
      found[i][c] = Interval::from_bounds(lo, hi);
    }
  return found;
}

// Six times the volume between the origin and the triangle. REQUIRES a live ScopedUpward.
Interval determinant(const IntervalPoint& a, const IntervalPoint& b, const IntervalPoint& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Interval volume_of_triangles(const std::vector<IntervalPoint>& points, std::size_t parts,
                             const IntervalPoint& origin) {
  const ScopedUpward upward;
  std::vector<IntervalPoint> from_origin = points;
  for (IntervalPoint& p : from_origin)
    for (std::size_t c = 0; c < 3; ++c) p[c] = p[c] - origin[c];
  Interval sum(0.0);
  for (std::size_t i = 0, row = 0; i < parts; row += parts + 1 - i, ++i)
    for (std::size_t j = 0; i + j < parts; ++j) {
      // Counter-clockwise as the corners of the face: the next row is one point shorter.
      const std::size_t here = row + j, above = row + (parts + 1 - i) + j;
      sum = sum + determinant(from_origin[here], from_origin[above], from_origin[here + 1]);
      if (i + j + 1 < parts)
        sum = sum + determinant(from_origin[here + 1], from_origin[above], from_origin[above + 1]);
    }
  return sum;
}

}  // namespace

Interval boundary_volume(const DmsModel& model, const TetrahedralComplex& complex,
                         std::span<const DmsFaceBounds> bounds,
                         const BoundaryVolumeOptions& options) {
  std::size_t parts = 2;
  while (2 * parts <= kMostParts &&
         points_of_face(2 * parts) * bounds.size() <= options.max_points)
    parts *= 2;
  FastDmsOptions with_tables_at_once;
  with_tables_at_once.exact_first = 0;
  FastDms map(model, with_tables_at_once);
  IntervalPoint origin;
  for (std::size_t c = 0; c < 3; ++c) origin[c] = Interval(nearest_double(model.value(0)[c]));
  Interval six_volumes(0.0), apart(0.0);
  for (std::size_t f = 0; f < bounds.size(); ++f) {
    std::array<DmsPoint, 3> corners;
    const auto v = complex.vertices(complex.boundary()[f]);
    for (std::size_t i = 0; i < 3; ++i) corners[i] = model.knot(v[i], 0);
    const Interval of_face = volume_of_triangles(images(corners, parts, map), parts, origin);
    const ScopedUpward upward;
    six_volumes = six_volumes + of_face;
    apart = apart + Interval(bounds[f].spread) * Interval(bounds[f].slopes[0]) *
                        Interval(bounds[f].slopes[1]);
  }
  // A part is at most 2/3 spread / parts away from its triangle, and of all surfaces between them none has more area
  // than the product of both slopes, half of it for all parts of a face together.
  const ScopedUpward upward;
  const Interval most = apart / Interval(3.0 * static_cast<double>(parts));
  const Interval both = Interval::from_bounds(-most.hi(), most.hi());
  return six_volumes / Interval(6.0) + both;
}

}  // namespace veritope
