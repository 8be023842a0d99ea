// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/projection.h"
#include "robust/filter.h"
#include "solids/classify/facet_tests_internal.h"

namespace veritope::internal {
namespace {

Sign compare(const Vec3d& p, std::size_t k, double c) {
  return sign_of(p[static_cast<int>(k)] - c);
}
Sign compare(const ScaledPoint& p, std::size_t k, double c) { return p.compare(k, c); }

// Whether q lies between a and b on their line, the ends included.
template <typename Point>
bool is_on_segment(const Vec3d& a, const Vec3d& b, const Point& q) {
  for (int axis = 0; axis < 3; ++axis)
    if (orient2d(a, b, q, axis) != Sign::kZero) return false;
  const Point3d from = to_point(a), to = to_point(b);
  for (std::size_t k = 0; k < 3; ++k)
    if (compare(q, k, std::min(from[k], to[k])) < 0 || compare(q, k, std::max(from[k], to[k])) > 0)
      return false;
  return true;
}

// The closed triangle t, of the plane of q.
template <typename Point>
bool is_on_triangle(const std::array<Vec3d, 3>& t, const Point& q) {
  const AxisProjection seen = projection_of(t[0], t[1], t[2]);
  if (seen.sign == Sign::kZero)
    return is_on_segment(t[0], t[1], q) || is_on_segment(t[1], t[2], q) ||
           is_on_segment(t[2], t[0], q);
  for (std::size_t i = 0; i < 3; ++i)
    if (orient2d(t[i], t[(i + 1) % 3], q, seen.axis) * seen.sign == Sign::kNegative) return false;
  return true;
}

}  // namespace

FacetTests::FacetTests(const TriangleMesh& mesh, const Vec3d& lo, const Vec3d& hi)
    : mesh_(&mesh), session_(lo, hi) {
  records_.reserve(mesh.faces.size());
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& t = mesh.faces[f];
    records_.push_back(
        {Session3d::plane(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]), f, t});
  }
}

void FacetTests::reorder(const std::vector<std::uint32_t>& order) {
  std::vector<FacetRecord> records;
  records.reserve(order.size());
  for (const std::uint32_t i : order) records.push_back(records_[i]);
  records_ = std::move(records);
}

Sign FacetTests::exact_side(std::uint32_t facet, const Vec3d& q) const {
  const auto t = corners(facet);
  return veritope::orient3d(t[0], t[1], t[2], q);
}

// The exact plane function differs between q and its rounded place by at most |N| . slack, and |N| from the stored
// normal by less than the session's bound allows for a step of the box's extent, which is greater.
Sign FacetTests::side(std::uint32_t facet, const ScaledPoint& q) const {
  const SessionPlane& plane = records_[facet].plane;
  const double step =
      (std::abs(static_cast<double>(plane.x)) + std::abs(static_cast<double>(plane.y)) +
       std::abs(static_cast<double>(plane.z))) *
      q.slack;
  const double bound = 2 * session_.orient3d_error() + step * (1 + 0x1p-40);
  const Sign3 s = sign_beyond(Session3d::plane_value(plane, q.rounded), bound);
  if (is_certain(s)) return to_sign(s);
  const auto t = corners(facet);
  return orient3d(t[0], t[1], t[2], q);
}

Passage FacetTests::passage(std::uint32_t facet, const Vec3d& from, const Vec3d& to) const {
  const auto t = corners(facet);
  const Sign ab = session_.orient3d(from, to, t[0], t[1]),
             bc = session_.orient3d(from, to, t[1], t[2]);
  if (ab * bc == Sign::kNegative) return Passage::kMisses;
  return passage_of(ab, bc, session_.orient3d(from, to, t[2], t[0]));
}

Passage FacetTests::passage(std::uint32_t facet, const Vec3d& from, const ScaledPoint& to) const {
  const auto t = corners(facet);
  // Cyclic orders of four points with `from` first have one orientation.
  return passage_of(orient3d(from, t[0], t[1], to), orient3d(from, t[1], t[2], to),
                    orient3d(from, t[2], t[0], to));
}

bool FacetTests::contains(std::uint32_t facet, const Vec3d& q) const {
  return is_on_triangle(corners(facet), q);
}

bool FacetTests::contains(std::uint32_t facet, const ScaledPoint& q) const {
  return is_on_triangle(corners(facet), q);
}

bool FacetTests::is_degenerate(std::uint32_t facet) const {
  const auto t = corners(facet);
  return collinear(t[0], t[1], t[2]);
}

}  // namespace veritope::internal
