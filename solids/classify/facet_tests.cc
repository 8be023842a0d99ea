// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <utility>

#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/projection.h"
#include "solids/classify/facet_tests_internal.h"
#include "solids/classify/rational_orient_internal.h"

namespace veritope::internal {
namespace {

std::array<double, 3> coordinates(const Vec3d& p) { return to_point(p); }
const ExactPoint& coordinates(const ExactPoint& p) { return p; }

// Whether q lies between a and b on their line, the ends included.
template <typename Point>
bool is_on_segment(const Point& a, const Point& b, const Point& q) {
  for (int axis = 0; axis < 3; ++axis)
    if (orient2d(a, b, q, axis) != Sign::kZero) return false;
  const auto from = coordinates(a), to = coordinates(b), at = coordinates(q);
  for (std::size_t k = 0; k < 3; ++k)
    if (at[k] < std::min(from[k], to[k]) || std::max(from[k], to[k]) < at[k]) return false;
  return true;
}

// The closed triangle t, of the plane of q.
template <typename Point>
bool is_on_triangle(const std::array<Point, 3>& t, const AxisProjection& seen, const Point& q) {
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

Sign FacetTests::side(std::uint32_t facet, const ExactPoint& q) const {
  const auto t = corners(facet);
  return orient3d(to_rational(t[0]), to_rational(t[1]), to_rational(t[2]), q);
}

Passage FacetTests::passage(std::uint32_t facet, const Vec3d& from, const Vec3d& to) const {
  const auto t = corners(facet);
  const Sign ab = session_.orient3d(from, to, t[0], t[1]),
             bc = session_.orient3d(from, to, t[1], t[2]);
  if (ab * bc == Sign::kNegative) return Passage::kMisses;
  return passage_of(ab, bc, session_.orient3d(from, to, t[2], t[0]));
}

Passage FacetTests::passage(std::uint32_t facet, const Vec3d& from, const ExactPoint& to) const {
  const auto t = corners(facet);
  const ExactPoint f = to_rational(from), a = to_rational(t[0]), b = to_rational(t[1]),
                   c = to_rational(t[2]);
  return passage_of(orient3d(f, to, a, b), orient3d(f, to, b, c), orient3d(f, to, c, a));
}

bool FacetTests::contains(std::uint32_t facet, const Vec3d& q) const {
  const auto t = corners(facet);
  return is_on_triangle(t, projection_of(t[0], t[1], t[2]), q);
}

bool FacetTests::contains(std::uint32_t facet, const ExactPoint& q) const {
  const auto t = corners(facet);
  const std::array<ExactPoint, 3> exact{to_rational(t[0]), to_rational(t[1]), to_rational(t[2])};
  return is_on_triangle(exact, projection_of(t[0], t[1], t[2]), q);
}

bool FacetTests::is_degenerate(std::uint32_t facet) const {
  const auto t = corners(facet);
  return collinear(t[0], t[1], t[2]);
}

}  // namespace veritope::internal
