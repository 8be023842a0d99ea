// SPDX-License-Identifier: LGPL-3.0-or-later
// Circles, spheres, tori: rational patches that are exact.
#include "models/patch_shapes.h"

#include <tuple>

#include "models/patch_shapes_internal.h"

namespace veritope::patch_shapes {
namespace internal {

PlaneCurve quarter_circle(int quarter) {
  PlaneCurve out = quarter % 2 == 0 ? PlaneCurve{{1, 1, 0}, {0, 1, 2}, {1, 1, 2}}
                                    : PlaneCurve{{2, 1, 0}, {0, 1, 1}, {2, 1, 1}};
  for (std::size_t i = 0; i < 3; ++i)
    std::tie(out.x[i], out.y[i]) = turned_xy(out.x[i], out.y[i], quarter % 4);
  return out;
}

// q^2 / |q|^2 for q = 1, i, -1 in Bernstein form of degree 2, which runs in the upper half-plane: degree 4 with weights
// 1, 0, 1/3, 0, 1; raised to degree 5 they are 1, 1/5, 1/5, 1/5, 1/5, 1.
PlaneCurve whole_circle() {
  const auto raised = [](std::array<Rational, 5> b) {
    std::vector<Rational> out{b[0]};
    for (int i = 1; i < 5; ++i) {
      const auto at = static_cast<std::size_t>(i);
      out.push_back((Rational(i) * b[at - 1] + Rational(5 - i) * b[at]) / Rational(5));
    }
    out.push_back(b[4]);
    return out;
  };
  return {raised({1, 0, -1, 0, 1}), raised({0, 1, 0, -1, 0}),
          raised({1, 0, Rational(1) / 3, 0, 1})};
}

void add_revolved(Patches& to, const std::vector<PlaneCurve>& profiles) {
  for (const PlaneCurve& profile : profiles)
    for (int quarter = 0; quarter < 4; ++quarter) {
      const PlaneCurve circle = quarter_circle(quarter);
      const auto u = [](const std::vector<Rational>& b) { return Scalar::along(0, b); };
      const Scalar rho = Scalar::along(1, profile.x);
      add(to,
          tensor_of(rho * u(circle.x), rho * u(circle.y), Scalar::along(1, profile.y) * u(circle.w),
                    Scalar::along(1, profile.w) * u(circle.w)));
    }
}

namespace {

// Centre (R, 0), radius r.
PlaneCurve moved(PlaneCurve circle, const Rational& big_radius, const Rational& radius) {
  for (std::size_t i = 0; i < circle.x.size(); ++i) {
    circle.x[i] = big_radius * circle.w[i] + radius * circle.x[i];
    circle.y[i] = radius * circle.y[i];
  }
  return circle;
}

}  // namespace
}  // namespace internal

using internal::Scalar;

Patches octant_sphere() {
  Patches out;
  internal::add_revolved(out, {internal::quarter_circle(3), internal::quarter_circle(0)});
  return out;
}

Patches torus(const Rational& big_radius, const Rational& radius) {
  std::vector<internal::PlaneCurve> profiles;
  for (int quarter = 0; quarter < 4; ++quarter)
    profiles.push_back(internal::moved(internal::quarter_circle(quarter), big_radius, radius));
  Patches out;
  internal::add_revolved(out, profiles);
  return out;
}

Patches one_patch_torus(const Rational& big_radius, const Rational& radius) {
  const internal::PlaneCurve circle = internal::whole_circle(),
                             profile = internal::moved(circle, big_radius, radius);
  const Scalar rho = Scalar::along(1, profile.x), w = Scalar::along(0, circle.w);
  Patches out;
  internal::add(
      out, internal::tensor_of(rho * Scalar::along(0, circle.x), rho * Scalar::along(0, circle.y),
                               Scalar::along(1, profile.y) * w, Scalar::along(1, profile.w) * w));
  return out;
}

// Points (2 Re(p conj q), 2 Im(p conj q), |p|^2 - |q|^2) / (|p|^2 + |q|^2) of complex polynomials p, q, that is, the
// projections of z = p / q from the north pole; -1 <= s, t <= 1.
//   south  z = a (s + i t), the square of half-side a = 3/8
//   north  1 / z = a (s - i t), times 1 + i s t
//   side   z = (1 + i t) ((1 - r) a + r) / ((1 - r) + r a (1 + t^2)), 0 <= r <= 1, and this rotated by right angles:
//   the
//          argument depends on t alone, |z| rises with r since a^2 (1 + t^2) < 1. At r = 0 it is z = a (1 + i t), at
//          r = 1 the north's side s = 1 with its factor.
Patches sphere() {
  const Rational a = Rational(3) / 8;
  const Scalar s = Scalar::linear(0, -1, 1), t = Scalar::linear(1, -1, 1), two = 2, one = 1;
  const Scalar square = Scalar(a * a) * (s * s + t * t), factor = one + s * s * (t * t);
  std::vector<Patch::Tensor> maps;
  maps.push_back(internal::tensor_of(two * a * t, two * a * s, square - one, square + one));
  maps.push_back(internal::tensor_of(two * a * s * factor, two * a * t * factor,
                                     (one - square) * factor, (one + square) * factor));
  const Scalar along = Scalar::linear(0, -1, 1), r = Scalar::linear(1, 0, 1);
  const Scalar spread = one + along * along, p = Scalar(a) + r * Scalar(Rational(1) - a),
               q = one - r + r * Scalar(a) * spread;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const auto [x, y] = internal::turned_xy(two * p * q, two * along * p * q, quarter);
    maps.push_back(internal::tensor_of(x, y, spread * p * p - q * q, spread * p * p + q * q));
  }
  Patches out;
  for (const Patch::Tensor& map : maps) internal::add(out, elevate_to(map, {4, 4}));
  return out;
}

}  // namespace veritope::patch_shapes
