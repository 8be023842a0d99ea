// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/patch_jet_internal.h"

#include <utility>

#include "splines/bezier_calculus.h"
#include "splines/bezier_triangle.h"
#include "splines/de_casteljau.h"

namespace veritope::internal {
namespace {

Barycentric<Rational> barycentric(const DomainPlace& at) {
  return {Rational(1) - at[0] - at[1], at[0], at[1]};
}

// The derivative of each component, weight included.
template <std::size_t N>
std::vector<Rational> homogeneous_derivative(const Bezier<Rational, N>& map, std::size_t axis,
                                             const std::array<Rational, N>& at) {
  const Bezier<Rational, N> components(map.degrees(), map.num_components(), false,
                                       {map.coefficients().begin(), map.coefficients().end()});
  return evaluate(derivative(components, axis), at);
}

Vector quotient_of(const std::vector<Rational>& f) {
  if (f.size() == 3) return {f[0], f[1], f[2]};
  return {f[0] / f[3], f[1] / f[3], f[2] / f[3]};
}

// d is the derivative of f: that of the quotient is (d - (f / w) d_w) / w.
Vector quotient_derivative(const std::vector<Rational>& f, const std::vector<Rational>& d) {
  if (f.size() == 3) return {d[0], d[1], d[2]};
  Vector out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = (d[k] - f[k] / f[3] * d[3]) / f[3];
  return out;
}

std::vector<Vector> control_points(const Patch& patch) {
  std::vector<Vector> out;
  for (std::size_t i = 0; i < patch.num_control(); ++i) {
    Vector p;
    for (int k = 0; k < 3; ++k) {
      p[static_cast<std::size_t>(k)] = patch.component(k)[i];
      if (patch.is_rational()) p[static_cast<std::size_t>(k)] /= patch.component(3)[i];
    }
    out.push_back(std::move(p));
  }
  return out;
}

}  // namespace

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector negated(const Vector& a) { return {-a[0], -a[1], -a[2]}; }
Vector crossed(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dotted(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Rational rounded_down(const Rational& x) { return floor_divide(x.numerator(), x.denominator()); }
bool is_zero(const Vector& a) { return a[0].sign() == 0 && a[1].sign() == 0 && a[2].sign() == 0; }

std::vector<Rational> homogeneous_at(const Patch& patch, const DomainPlace& at) {
  return patch.is_triangle() ? evaluate(patch.triangle(), barycentric(at))
                             : evaluate(patch.tensor(), at);
}

std::vector<Rational> homogeneous_derivative_at(const Patch& patch, std::size_t axis,
                                                const DomainPlace& at) {
  if (!patch.is_triangle()) return homogeneous_derivative(patch.tensor(), axis, at);
  const Barycentric<Rational> along =
      axis == 0 ? Barycentric<Rational>{-1, 1, 0} : Barycentric<Rational>{-1, 0, 1};
  return evaluate(directional_derivative(patch.triangle(), along), barycentric(at));
}

PatchJet jet(const Patch& patch, const DomainPlace& at) {
  const std::vector<Rational> f = homogeneous_at(patch, at);
  return {quotient_of(f),
          {quotient_derivative(f, homogeneous_derivative_at(patch, 0, at)),
           quotient_derivative(f, homogeneous_derivative_at(patch, 1, at))}};
}

CurveJet jet(const Patch::Curve& curve, const Rational& at) {
  const std::vector<Rational> f = evaluate(curve, {at});
  return {quotient_of(f), quotient_derivative(f, homogeneous_derivative<1>(curve, 0, {at}))};
}

DomainPlace on_side(const Patch& patch, std::uint32_t side, const Rational& t) {
  const Rational rest = Rational(1) - t;
  if (patch.is_triangle()) {
    if (side == 0) return {t, 0};
    return side == 1 ? DomainPlace{rest, t} : DomainPlace{0, rest};
  }
  switch (side) {
    case 0: return {t, 0};
    case 1: return {1, t};
    case 2: return {rest, 1};
    default: return {0, rest};
  }
}

Vector along_side(const Patch& patch, std::uint32_t side, const PatchJet& at) {
  const auto& [u, v] = at.derivative;
  if (patch.is_triangle()) {
    if (side == 0) return u;
    return side == 1 ? minus(v, u) : negated(v);
  }
  return side < 2 ? at.derivative[side] : negated(at.derivative[side - 2]);
}

std::optional<Vector> flat_normal(const Patch& patch) {
  const Rational part = Rational(1) / Rational(patch.is_triangle() ? 3 : 2);
  const PatchJet middle = jet(patch, {part, part});
  const Vector n = crossed(middle.derivative[0], middle.derivative[1]);
  if (is_zero(n)) return std::nullopt;
  const std::vector<Vector> points = control_points(patch);
  for (const Vector& p : points)
    if (dotted(n, minus(p, points[0])).sign() != 0) return std::nullopt;
  return n;
}

std::optional<Vector> straight_direction(const Patch& patch, std::uint32_t side) {
  const std::vector<Vector> points = control_points(patch);
  const std::size_t n = patch.side_length(side);
  const Vector& start = points[patch.side_index(side, 0)];
  const Vector d = minus(points[patch.side_index(side, n - 1)], start);
  for (std::size_t i = 1; i + 1 < n; ++i)
    if (!is_zero(crossed(d, minus(points[patch.side_index(side, i)], start)))) return std::nullopt;
  if (is_zero(d)) return std::nullopt;
  return d;
}

}  // namespace veritope::internal
