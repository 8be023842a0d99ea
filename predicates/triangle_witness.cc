// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/triangle_witness.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "predicates/projection.h"
#include "predicates/triangle_triangle_internal.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

using Point = std::array<Rational, 3>;
using Corners = std::array<Point, 3>;

Corners corners(const IndexedTriangle& t) {
  Corners out;
  for (int i = 0; i < 3; ++i) {
    out[i] = {Rational::from_double(t.point[i].x), Rational::from_double(t.point[i].y),
              Rational::from_double(t.point[i].z)};
  }
  return out;
}
Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Rational dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point normal(const Corners& t) { return cross(t[1] - t[0], t[2] - t[0]); }
// a + s (b - a)
Point between(const Point& a, const Point& b, const Rational& s) {
  const Point d = b - a;
  return {a[0] + s * d[0], a[1] + s * d[1], a[2] + s * d[2]};
}

// Mean of the points, two of them with the greatest distance, and its square.
struct Extent {
  Point mean;
  std::array<Point, 2> ends;
  Rational squared;
};
Extent extent(const std::vector<Point>& points) {
  Extent out;
  out.ends = {points.front(), points.front()};
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int k = 0; k < 3; ++k) out.mean[k] += points[i][k];
    for (std::size_t j = 0; j < i; ++j) {
      const Point d = points[i] - points[j];
      const Rational squared = dot(d, d);
      if (squared <= out.squared) continue;
      out.squared = squared;
      out.ends = {points[j], points[i]};
    }
  }
  for (Rational& c : out.mean) c /= Rational(points.size());
  return out;
}

// The ends of t's section by a plane; heights[i] is that of t[i] over the plane, on any scale.
std::array<Point, 2> section_ends(const Corners& t, const std::array<Rational, 3>& heights) {
  const internal::PlaneSection s =
      internal::plane_section({heights[0].sign(), heights[1].sign(), heights[2].sign()});
  const auto crossing = [&](internal::PlaneCrossing c) {
    const Rational &low = heights[c.below], &high = heights[c.above];
    return between(t[c.below], t[c.above], low / (low - high));
  };
  return {crossing(s.rising), crossing(s.falling)};
}

// The intersection of the two segments on the line of the planes.
std::vector<Point> transversal(const Corners& t, const Corners& u) {
  const Point nt = normal(t), nu = normal(u);
  std::array<Rational, 3> ht, hu;
  for (int i = 0; i < 3; ++i) ht[i] = dot(nu, t[i] - u[0]), hu[i] = dot(nt, u[i] - t[0]);
  const std::array<Point, 2> on_t = section_ends(t, ht);
  auto [u_last, u_first] =
      section_ends(u, hu);  // plane_section orders u along the opposite direction
  const Point direction = cross(nt, nu);
  const auto precedes = [&](const Point& p, const Point& q) {
    return dot(direction, p) < dot(direction, q);
  };
  const Point& first = precedes(on_t[0], u_first) ? u_first : on_t[0];
  const Point& last = precedes(on_t[1], u_last) ? on_t[1] : u_last;
  VT_CHECK(!precedes(last, first), "the triangles do not meet");
  std::vector<Point> ends(1, first);
  ends.push_back(last);
  return ends;
}

// Twice the signed area of three points seen along an axis.
Rational area(const Point& a, const Point& b, const Point& c, int axis) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  return (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
}

// The part of t inside the three half-planes of u.
std::vector<Point> coplanar(const Corners& t, const Corners& u, const AxisProjection& u_view) {
  std::vector<Point> polygon(t.begin(), t.end());
  for (int e = 0; e < 3; ++e) {
    const Point &a = u[e], &b = u[(e + 1) % 3];
    std::vector<Point> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      Rational hp = area(a, b, p, u_view.axis), hq = area(a, b, q, u_view.axis);
      if (u_view.sign == Sign::kNegative) hp.negate(), hq.negate();
      if (hp.sign() != Sign::kNegative) kept.push_back(p);
      if (hp.sign() * hq.sign() == Sign::kNegative) kept.push_back(between(p, q, hp / (hp - hq)));
    }
    polygon.clear();
    for (Point& p : kept) {
      if (polygon.empty() || (polygon.back() != p && polygon.front() != p))
        polygon.push_back(std::move(p));
    }
  }
  VT_CHECK(!polygon.empty(), "the triangles do not meet");
  return polygon;
}

// Coprime non-negative weights of p, a point of the triangle t.
std::array<Integer, 3> weights(const Point& p, const Corners& t, int axis) {
  std::array<Rational, 3> w;
  Integer scale(1);
  for (int i = 0; i < 3; ++i) {
    w[i] = abs(area(p, t[(i + 1) % 3], t[(i + 2) % 3], axis));
    scale *= w[i].denominator();
  }
  std::array<Integer, 3> out;
  for (int i = 0; i < 3; ++i) out[i] = divide_exactly(w[i].numerator() * scale, w[i].denominator());
  const Integer common = gcd(gcd(out[0], out[1]), out[2]);
  for (Integer& x : out) x = divide_exactly(x, common);
  return out;
}

}  // namespace

TriangleWitness triangle_witness(const IndexedTriangle& t, const IndexedTriangle& u) {
  const TriangleContact contact = triangle_triangle(t, u);
  VT_CHECK(contact == TriangleContact::kImproper || contact == TriangleContact::kCoplanarOverlap,
           "triangle_witness of a pair that meets properly");
  const Corners a = corners(t), b = corners(u);
  const AxisProjection t_view = projection_of(t.point[0], t.point[1], t.point[2]);
  const AxisProjection u_view = projection_of(u.point[0], u.point[1], u.point[2]);
  std::vector<Point> meet;
  if (contact == TriangleContact::kImproper) {
    meet = transversal(a, b);
  } else {
    meet = coplanar(a, b, u_view);
  }
  const Extent e = extent(meet);
  return {weights(e.mean, a, t_view.axis), weights(e.mean, b, u_view.axis), e.mean, e.ends, e.squared};
}

}  // namespace veritope
