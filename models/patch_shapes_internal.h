// SPDX-License-Identifier: LGPL-3.0-or-later
// models/patch_shapes_internal.h: what the builders of example models share.
#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "models/patch_shapes.h"
#include "splines/bezier_components.h"
#include "splines/bezier_degree.h"
#include "splines/bezier_domain.h"
#include "splines/bezier_product.h"

namespace veritope::patch_shapes::internal {

/// A polynomial in the parameters u and v of a patch.
class Scalar {
 public:
  Scalar(Bezier<Rational, 2> map) : map_(std::move(map)) {}
  Scalar(const Rational& constant) : map_({0, 0}, 1, false, {constant}) {}
  Scalar(int constant) : Scalar(Rational(constant)) {}
  /// The linear polynomial from `begin` to `end` along an axis.
  static Scalar linear(std::size_t axis, const Rational& begin, const Rational& end) {
    return Bezier<Rational, 2>({axis == 0 ? 1 : 0, axis == 1 ? 1 : 0}, 1, false, {begin, end});
  }
  /// The polynomial with these Bernstein coefficients along an axis.
  static Scalar along(std::size_t axis, std::vector<Rational> b) {
    const int n = static_cast<int>(b.size()) - 1;
    return Bezier<Rational, 2>({axis == 0 ? n : 0, axis == 1 ? n : 0}, 1, false, std::move(b));
  }
  const Bezier<Rational, 2>& map() const { return map_; }

  friend Scalar operator+(const Scalar& a, const Scalar& b) { return sum(a.map_, b.map_); }
  friend Scalar operator-(const Scalar& a, const Scalar& b) { return difference(a.map_, b.map_); }
  friend Scalar operator*(const Scalar& a, const Scalar& b) {
    return componentwise_product(a.map_, b.map_);
  }

 private:
  Bezier<Rational, 2> map_;
};

/// The patch (x, y, z), or (x, y, z) / w. REQUIRES degrees of 1 or more along both axes.
inline Patch::Tensor tensor_of(const Scalar& x, const Scalar& y, const Scalar& z) {
  return veritope::joined(veritope::joined(x.map(), y.map()), z.map());
}
inline Patch::Tensor tensor_of(const Scalar& x, const Scalar& y, const Scalar& z, const Scalar& w) {
  return quotient(tensor_of(x, y, z), w.map());
}
/// Adds a patch; the number in its origin is its place in the list.
inline void add(Patches& to, Patch::Tensor map) {
  to.push_back(make_patch(std::move(map), {PatchOrigin::Kind::kBuilt, to.size(), {}}).value());
}
inline void add(Patches& to, Patch::Triangle map) {
  to.push_back(make_patch(std::move(map), {PatchOrigin::Kind::kBuilt, to.size(), {}}).value());
}
/// A bilinear patch with these corners.
Patch::Tensor bilinear(const std::array<Point, 4>& corners);

/// (x, y) rotated by `quarters` right angles.
template <typename T>
std::pair<T, T> turned_xy(T x, T y, int quarters) {
  for (; quarters > 0; --quarters) {
    T old = std::move(x);
    x = T(0) - y;
    y = std::move(old);
  }
  return {std::move(x), std::move(y)};
}

/// Homogeneous Bernstein coefficients of a plane curve.
struct PlaneCurve {
  std::vector<Rational> x, y, w;
};
/// The unit circle from angle 90 quarter to 90 (quarter + 1) degrees: weights 1, 1, 2, or 2, 1, 1 if quarter is odd.
PlaneCurve quarter_circle(int quarter);
/// The unit circle, once around from (1, 0), of degree 5 with positive weights; the weights of the ends are 1.
PlaneCurve whole_circle();

/// Profiles (rho, z) revolved about the z axis, each in four quarters. The normals point to the right of the profile's
/// direction of travel in the half-plane rho >= 0, z up: counterclockwise profiles give normals that point out. Points
/// with rho = 0 become poles.
void add_revolved(Patches& to, const std::vector<PlaneCurve>& profiles);

/// An end of a solid of revolution: a circle at `height`, joined by four patches to a level square of half-diagonal
/// radius / 2 around `centre`.
struct EndDisk {
  Rational radius, height;
  Point centre;
  bool faces_up;
};
void add_end(Patches& to, const EndDisk& disk);
/// Five cubic spans from the lower pole to the upper one.
std::vector<PlaneCurve> teapot_profile();

using Cube = std::array<int, 3>;
/// The corners of a face, counterclockwise from outside.
std::array<Cube, 4> cube_face(const Cube& cube, std::size_t axis, bool at_high);
/// The boundary of the cubes' union, its vertices moved.
Patches block_faces(const std::vector<Cube>& cubes, const std::function<Point(const Cube&)>& place);
Point at_integers(const Cube& p);
std::vector<Cube> plate_cubes(int g);

/// See pn_torus; `radius` of the circle that is revolved.
Patches pn_torus(int m, int n, double radius);
/// See knotted_tube; flat: around the projection of the trefoil to z = 0, which crosses itself in three points.
Patches tube(const Rational& radius, int around, int along, bool is_flat);

}  // namespace veritope::patch_shapes::internal
