// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "interval/box_geometry.h"
#include "interval/intersect/intersection_contact.h"
#include "interval/solvers/krawczyk.h"

namespace veritope {
namespace {

using Matrix4 = ApproxMatrix<4>;
using IntervalMatrix4 = IntervalMatrix<4>;

using internal::approx_middle, internal::approx_radius;
using internal::cross, internal::dot;

/// Values and Jacobian of the four equations over a box.
struct System {
  Box4 value;
  IntervalMatrix4 jacobian;
  Box3 gap, normal;
};
System evaluate_system(const EnclosedSurface& s1, const EnclosedSurface& s2, const Box4& x) {
  const auto a = s1.range(x[0], x[1]), b = s2.range(x[2], x[3]);
  const auto aa = s1.second_range(x[0], x[1]), bb = s2.second_range(x[2], x[3]);
  System out;
  const Box3 d = a.point - b.point, n = cross(a.du, a.dv);
  out.gap = d, out.normal = n;
  out.value = Box4(dot(d, a.du), dot(d, a.dv), dot(n, b.du), dot(n, b.dv));
  const Box3 n_u = cross(aa.duu, a.dv) + cross(a.du, aa.duv);
  const Box3 n_v = cross(aa.duv, a.dv) + cross(a.du, aa.dvv);
  auto& j = out.jacobian;
  j[0] = {dot(a.du, a.du) + dot(d, aa.duu), dot(a.dv, a.du) + dot(d, aa.duv), -dot(b.du, a.du),
          -dot(b.dv, a.du)};
  j[1] = {dot(a.du, a.dv) + dot(d, aa.duv), dot(a.dv, a.dv) + dot(d, aa.dvv), -dot(b.du, a.dv),
          -dot(b.dv, a.dv)};
  j[2] = {dot(n_u, b.du), dot(n_v, b.du), dot(n, bb.duu), dot(n, bb.duv)};
  j[3] = {dot(n_u, b.dv), dot(n_v, b.dv), dot(n, bb.duv), dot(n, bb.dvv)};
  return out;
}

/// Inverts the matrix of the middles approximately; returns false if it is singular in doubles.
bool invert_middle(const IntervalMatrix4& j, Matrix4* out) {
  Matrix4 m;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k) m[i][k] = approx_middle(j[i][k]);
  const auto inverse = eliminate<4>(m).inverse;
  if (inverse) *out = *inverse;
  return inverse.has_value();
}

Box4 point_box(const Point4& p) {
  return Box4(Interval(p[0]), Interval(p[1]), Interval(p[2]), Interval(p[3]));
}

/// c - C f(c) + (I - C J(x)) (x - c).
Box4 krawczyk(const Matrix4& inverse, const Point4& c, const Box4& value, const IntervalMatrix4& j,
              const Box4& x) {
  Box4 out;
  for (std::size_t i = 0; i < 4; ++i) {
    out[i] = Interval(c[i]);
    for (std::size_t k = 0; k < 4; ++k) {
      out[i] = out[i] - Interval(inverse[i][k]) * value[k];
      Interval excess(i == k ? 1.0 : 0.0);
      for (std::size_t m = 0; m < 4; ++m) excess = excess - Interval(inverse[i][m]) * j[m][k];
      out[i] = out[i] + excess * (x[k] - Interval(c[k]));
    }
  }
  return out;
}

Interval determinant3(const IntervalMatrix4& j, std::size_t row0,
                      const std::array<std::size_t, 3>& c) {
  const auto m = [&](std::size_t i, std::size_t k) { return j[row0 + i][c[k]]; };
  return m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) -
         m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
         m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
}
Interval determinant(const IntervalMatrix4& j) {
  return j[0][0] * determinant3(j, 1, {1, 2, 3}) - j[0][1] * determinant3(j, 1, {0, 2, 3}) +
         j[0][2] * determinant3(j, 1, {0, 1, 3}) - j[0][3] * determinant3(j, 1, {0, 1, 2});
}

/// Newton's method in doubles; false if it leaves the domains.
bool approach(const EnclosedSurface& s1, const EnclosedSurface& s2, Point4* x) {
  for (int step = 0; step < 8; ++step) {
    const System at = evaluate_system(s1, s2, point_box(*x));
    Matrix4 inverse;
    if (!invert_middle(at.jacobian, &inverse)) return false;
    for (std::size_t i = 0; i < 4; ++i) {
      double move = 0;
      for (std::size_t k = 0; k < 4; ++k) move += inverse[i][k] * approx_middle(at.value[k]);
      (*x)[i] -= move;
      const EnclosedSurface& s = i < 2 ? s1 : s2;
      const double size = s.domain_end(i % 2) - s.domain_begin(i % 2);
      if (!((*x)[i] > s.domain_begin(i % 2) - size && (*x)[i] < s.domain_end(i % 2) + size))
        return false;
    }
  }
  return true;
}

}  // namespace

std::optional<CommonNormal> find_common_normal(const EnclosedSurface& s1, const EnclosedSurface& s2,
                                               const Box4& x) {
  Point4 center{};
  for (std::size_t i = 0; i < 4; ++i) center[i] = approx_middle(x[i]);
  if (!approach(s1, s2, &center)) return std::nullopt;
  CommonNormal out;
  for (std::size_t i = 0; i < 4; ++i) {
    const double r = 1.5 * std::max(center[i] - x[i].lo(), x[i].hi() - center[i]);
    if (!(r < 1e300)) return std::nullopt;
    out.unique_in[i] = Interval::from_bounds(center[i] - r, center[i] + r);
  }
  const System over = evaluate_system(s1, s2, out.unique_in);
  const System at = evaluate_system(s1, s2, point_box(center));
  Matrix4 inverse;
  if (!invert_middle(over.jacobian, &inverse)) return std::nullopt;
  Box4 found = krawczyk(inverse, center, at.value, over.jacobian, out.unique_in);
  if (!is_interior(found, out.unique_in)) return std::nullopt;
  for (int step = 0; step < 4; ++step) {
    for (std::size_t i = 0; i < 4; ++i) center[i] = approx_middle(found[i]);
    const System near = evaluate_system(s1, s2, found),
                 here = evaluate_system(s1, s2, point_box(center));
    const Box4 next =
        intersection(found, krawczyk(inverse, center, here.value, near.jacobian, found));
    VT_CHECK(!next.is_empty(), "a proved common normal has vanished");
    const bool is_narrower =
        approx_radius(next[widest_side(found)]) < 0.5 * approx_radius(found[widest_side(found)]);
    found = next;
    if (!is_narrower) break;
  }
  out.parameters = found;
  const System narrow = evaluate_system(s1, s2, found);
  const Interval size = sqrt(dot(narrow.normal, narrow.normal));
  if (!(size.lo() > 0)) return std::nullopt;
  out.separation = -dot(narrow.gap, narrow.normal) / size;
  const Sign3 sign = determinant(narrow.jacobian).sign();
  if (sign == Sign3::kPositive) out.shape = IntersectionContact::Shape::kElliptic;
  if (sign == Sign3::kNegative) out.shape = IntersectionContact::Shape::kHyperbolic;
  return out;
}

}  // namespace veritope
