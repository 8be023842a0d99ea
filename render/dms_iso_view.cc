// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "render/dms_surface_scene.h"
#include "robust/base/check.h"
#include "solids/dms/fast/fast_dms.h"

namespace veritope {
namespace {

constexpr Colour kIso{229, 160, 64};

// The values and the gradients of all components at vertices in the domain; where rounding moves one outside, at its
// exact place.
class PointValues {
 public:
  PointValues(const DmsModel& model, const DmsIso& iso)
      : stride_(model.num_components()),
        value_(iso.places.size() * stride_),
        gradient_(3 * value_.size()) {
    VT_CHECK(iso.places.size() == iso.mesh.positions.size(), "a place for each vertex");
    const std::vector<Vec3d>& points = iso.mesh.positions;
    if (points.empty()) return;
    FastDmsOptions options;
    options.exact_first = 0;
    options.with_gradient = true;
    FastDms fast(model, options);
    fast.evaluate(points, {value_.data(), nullptr, gradient_.data(), nullptr, nullptr});
    std::vector<Vec3d> moved;
    std::vector<std::pair<std::size_t, DmsPoint>> exact;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!std::isnan(value_[i * stride_])) continue;
      exact.emplace_back(moved.size(), iso.places[i]);
      moved.push_back(points[i]);
      numbers.push_back(i);
    }
    if (moved.empty()) return;
    std::vector<double> value(moved.size() * stride_), gradient(3 * value.size());
    fast.evaluate(moved, {value.data(), nullptr, gradient.data(), nullptr, nullptr}, exact);
    for (std::size_t k = 0; k < moved.size(); ++k) {
      std::copy_n(&value[k * stride_], stride_, &value_[numbers[k] * stride_]);
      std::copy_n(&gradient[3 * k * stride_], 3 * stride_, &gradient_[3 * numbers[k] * stride_]);
    }
  }
  double value(std::size_t point, std::size_t component) const {
    return value_[point * stride_ + component];
  }
  Point3d gradient(std::size_t point, std::size_t component) const {
    const double* const g = &gradient_[3 * (point * stride_ + component)];
    return {g[0], g[1], g[2]};
  }

 private:
  std::size_t stride_;
  std::vector<double> value_, gradient_;
};

Point3d cross(const Point3d& u, const Point3d& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// Multiplies all vectors by one power of two, so that their products of three are in range.
template <std::size_t N>
void bring_near_1(std::array<Point3d, N>& vectors) {
  double most = 0;
  for (const Point3d& v : vectors)
    for (const double x : v) most = std::max(most, std::abs(x));
  if (!(most > 0) || !std::isfinite(most)) return;
  const int exponent = std::ilogb(most);
  for (Point3d& v : vectors)
    for (double& x : v) x = std::ldexp(x, -exponent);
}

// The normal of the image of a level set: the cofactors of Ds times the gradient.
Point3d image_of_normal(const PointValues& values, std::size_t i, const Point3d& gradient) {
  std::array<Point3d, 3> slopes{values.gradient(i, 0), values.gradient(i, 1),
                                values.gradient(i, 2)};
  bring_near_1(slopes);
  const auto& [x, y, z] = slopes;
  const Point3d a = cross(y, z), b = cross(z, x), c = cross(x, y);
  const auto along = [&](const Point3d& row) {
    return row[0] * gradient[0] + row[1] * gradient[1] + row[2] * gradient[2];
  };
  return {along(a), along(b), along(c)};
}

}  // namespace

Result<SceneSurface> view_of_iso(const DmsModel& model, std::size_t component, const DmsIso& iso,
                                 bool in_solid) {
  const PointValues values(model, iso);
  SceneSurface out;
  out.name = "level";
  out.paints = {{kIso}};
  out.triangles.assign(iso.mesh.faces.begin(), iso.mesh.faces.end());
  for (std::size_t i = 0; i < iso.mesh.positions.size(); ++i) {
    const Vec3d& p = iso.mesh.positions[i];
    std::array<Point3d, 1> gradient{values.gradient(i, component)};
    bring_near_1(gradient);
    out.points.push_back(in_solid
                             ? Point3d{values.value(i, 0), values.value(i, 1), values.value(i, 2)}
                             : Point3d{p.x, p.y, p.z});
    out.normals.push_back(in_solid ? image_of_normal(values, i, gradient[0]) : gradient[0]);
    // A FastDms has the greatest number in the place of one beyond binary64.
    for (const double x : out.points.back())
      if (!(std::abs(x) < std::numeric_limits<double>::max()))
        return Error{Code::kNotFinite, {}, "points of the surface are beyond binary64"};
  }
  return out;
}

}  // namespace veritope
