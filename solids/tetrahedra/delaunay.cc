// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/tetrahedra/delaunay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "predicates/exact_in_sphere.h"
#include "predicates/in_sphere.h"
#include "predicates/orient3d.h"
#include "predicates/projection.h"
#include "solids/tetrahedra/delaunay_internal.h"
#include "solids/tetrahedra/insertion_order.h"

namespace veritope {
namespace {

class DoublePoints {
 public:
  DoublePoints(std::span<const Vec3d> points, const std::vector<std::uint32_t>& order) {
    points_.reserve(order.size());
    for (const std::uint32_t i : order) points_.push_back(points[i]);
  }
  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }
  Sign orient3d(const TetrahedronCorners& c) const {
    return veritope::orient3d(points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]]);
  }
  Sign in_sphere(const TetrahedronCorners& c, std::uint32_t p) const {
    return veritope::in_sphere(points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]],
                               points_[p]);
  }
  bool are_collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return collinear(points_[a], points_[b], points_[c]);
  }
  bool is_before(std::uint32_t a, std::uint32_t b) const {
    const Vec3d &p = points_[a], &q = points_[b];
    if (p.x != q.x) return p.x < q.x;
    return p.y != q.y ? p.y < q.y : p.z < q.z;
  }

 private:
  std::vector<Vec3d> points_;
};

class RationalPoints {
 public:
  RationalPoints(std::span<const ExactPoint3> points, const std::vector<std::uint32_t>& order) {
    points_.reserve(order.size());
    for (const std::uint32_t i : order) points_.push_back(&points[i]);
  }
  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }
  Sign orient3d(const TetrahedronCorners& c) const {
    return veritope::orient3d(*points_[c[0]], *points_[c[1]], *points_[c[2]], *points_[c[3]]);
  }
  Sign in_sphere(const TetrahedronCorners& c, std::uint32_t p) const {
    return veritope::in_sphere(*points_[c[0]], *points_[c[1]], *points_[c[2]], *points_[c[3]],
                               *points_[p]);
  }
  bool are_collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    for (int axis = 0; axis < 3; ++axis)
      if (orient2d_projected(*points_[a], *points_[b], *points_[c], axis) != Sign::kZero)
        return false;
    return true;
  }
  // Rounding is monotone: where the nearest numbers differ they decide.
  bool is_before(std::uint32_t a, std::uint32_t b) const {
    const ExactPoint3 &p = *points_[a], &q = *points_[b];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = p.rounded()[static_cast<int>(axis)], y = q.rounded()[static_cast<int>(axis)];
      if (x != y) return x < y;
      if (p.at()[axis] != q.at()[axis]) return p.at()[axis] < q.at()[axis];
    }
    return false;
  }

 private:
  std::vector<const ExactPoint3*> points_;
};

Status check_number(std::size_t count) {
  if (count <= TetrahedralComplex::kMaxTetrahedra) return ok_status();
  return Error{Code::kOverLimit, {}, std::to_string(count) + " points are too many"};
}

bool is_finite(const Vec3d& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// Rounded coordinates, the largest finite ones for those beyond: good enough for an order.
std::vector<Vec3d> rounded(std::span<const ExactPoint3> points) {
  constexpr double kMost = std::numeric_limits<double>::max();
  const auto finite = [kMost](double x) { return std::clamp(x, -kMost, kMost); };
  std::vector<Vec3d> out;
  out.reserve(points.size());
  for (const ExactPoint3& p : points)
    out.push_back({finite(p.rounded().x), finite(p.rounded().y), finite(p.rounded().z)});
  return out;
}

}  // namespace

Result<DelaunayTetrahedra> delaunay_tetrahedra(std::span<const Vec3d> points,
                                               const DelaunayLimits& limits) {
  if (const Status status = check_number(points.size()); !status) return status.error();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_finite(points[i])) {
      Error error{
          Code::kNotFinite, {}, "a coordinate of point " + std::to_string(i) + " is not finite"};
      error.place.vertex = i;
      return error;
    }
  const std::vector<std::uint32_t> order = insertion_order(points);
  return internal::build_delaunay(DoublePoints(points, order), order, limits);
}

Result<DelaunayTetrahedra> delaunay_tetrahedra(std::span<const ExactPoint3> points,
                                               const DelaunayLimits& limits) {
  if (const Status status = check_number(points.size()); !status) return status.error();
  const std::vector<Vec3d> near = rounded(points);
  if (std::all_of(points.begin(), points.end(),
                  [](const ExactPoint3& p) { return p.is_binary64(); }))
    return delaunay_tetrahedra(std::span<const Vec3d>(near), limits);
  const std::vector<std::uint32_t> order = insertion_order(near);
  return internal::build_delaunay(RationalPoints(points, order), order, limits);
}

bool is_locally_delaunay(std::span<const ExactPoint3> points, const TetrahedralComplex& complex) {
  const auto& tetrahedra = complex.tetrahedra();
  for (TetrahedronFace f = 0; f < 4 * tetrahedra.size(); ++f) {
    const auto partner = complex.partner(f);
    if (!partner || *partner < f) continue;
    const TetrahedronCorners& t = tetrahedra[face_tetrahedron(f)];
    const std::uint32_t opposite = tetrahedra[face_tetrahedron(*partner)][face_corner(*partner)];
    if (in_sphere(points[t[0]], points[t[1]], points[t[2]], points[t[3]], points[opposite]) ==
        Sign::kPositive)
      return false;
  }
  return true;
}

}  // namespace veritope
