// SPDX-License-Identifier: LGPL-3.0-or-later
#include <cmath>
#include <utility>
#include <vector>

#include "render/dms_surface_scene.h"
#include "solids/dms/fast/fast_dms.h"

namespace veritope {
namespace {

constexpr Colour kIso{229, 160, 64};

// The values and the gradients of all components at points of the domain.
class PointValues {
 public:
  PointValues(const DmsModel& model, const std::vector<Vec3d>& points)
      : stride_(model.num_components()),
        value_(points.size() * stride_),
        gradient_(3 * value_.size()) {
    if (points.empty()) return;
    FastDmsOptions options;
    options.exact_first = 0;
    options.with_gradient = true;
    FastDmsOutput out;
    out.value = value_.data();
    out.gradient = gradient_.data();
    FastDms(model, options).evaluate(points, out);
  }
  double value(std::size_t point, std::size_t component) const {
    return value_[point * stride_ + component];
  }
  Point3d gradient(std::size_t point, std::size_t component) const {
    const double* const g = &gradient_[3 * (point * stride_ + component)];
    return {g[0], g[1], g[2]};
  }
  bool is_outside(std::size_t point) const { return std::isnan(value(point, 0)); }

 private:
  std::size_t stride_;
  std::vector<double> value_, gradient_;
};

Point3d cross(const Point3d& u, const Point3d& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

// The normal of the image of a level set: the cofactors of Ds times the gradient.
Point3d image_of_normal(const PointValues& values, std::size_t i, const Point3d& gradient) {
  const Point3d x = values.gradient(i, 0), y = values.gradient(i, 1), z = values.gradient(i, 2);
  const Point3d a = cross(y, z), b = cross(z, x), c = cross(x, y);
  const auto along = [&](const Point3d& row) {
    return row[0] * gradient[0] + row[1] * gradient[1] + row[2] * gradient[2];
  };
  return {along(a), along(b), along(c)};
}

// Points that are outside of the domain by rounding move toward the middle of a triangle, which is inside.
std::vector<Vec3d> moved_inside(const TriangleMesh& mesh, const PointValues& values) {
  constexpr double kShare = 0x1p-20;
  std::vector<Vec3d> out = mesh.positions;
  for (const auto& face : mesh.faces) {
    Vec3d middle{0, 0, 0};
    for (const std::uint32_t v : face) {
      const Vec3d& p = mesh.positions[v];
      middle.x += p.x / 3, middle.y += p.y / 3, middle.z += p.z / 3;
    }
    for (const std::uint32_t v : face) {
      if (!values.is_outside(v)) continue;
      const Vec3d& p = mesh.positions[v];
      out[v] = {p.x + kShare * (middle.x - p.x), p.y + kShare * (middle.y - p.y),
                p.z + kShare * (middle.z - p.z)};
    }
  }
  return out;
}

}  // namespace

Result<SceneSurface> view_of_iso(const DmsModel& model, std::size_t component,
                                 const TriangleMesh& mesh, bool in_solid) {
  const std::vector<Vec3d> points = moved_inside(mesh, PointValues(model, mesh.positions));
  const PointValues values(model, points);
  SceneSurface out;
  out.name = "level";
  out.paints = {{kIso}};
  out.triangles.assign(mesh.faces.begin(), mesh.faces.end());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3d gradient = values.gradient(i, component);
    const bool is_mapped = in_solid && !values.is_outside(i);
    out.points.push_back(is_mapped
                             ? Point3d{values.value(i, 0), values.value(i, 1), values.value(i, 2)}
                             : Point3d{points[i].x, points[i].y, points[i].z});
    out.normals.push_back(is_mapped ? image_of_normal(values, i, gradient) : gradient);
    for (const double x : out.points.back())
      if (!std::isfinite(x) || (in_solid && values.is_outside(i)))
        return Error{Code::kNotFinite, {}, "points of the surface are beyond binary64"};
  }
  return out;
}

}  // namespace veritope
