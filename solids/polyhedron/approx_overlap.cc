// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/approx_overlap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "predicates/projection.h"

namespace veritope {
namespace {

using Corners = std::array<Vec3d, 3>;

Vec3d difference_of(const Vec3d& a, const Vec3d& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3d cross_of(const Vec3d& a, const Vec3d& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot_of(const Vec3d& a, const Vec3d& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length_of(const Vec3d& a) { return std::sqrt(dot_of(a, a)); }
Vec3d point_between(const Vec3d& a, const Vec3d& b, double s) {
  return {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z)};
}
double largest_component(const Vec3d& a) {
  return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}
Vec3d normal_of(const Corners& t) {
  return cross_of(difference_of(t[1], t[0]), difference_of(t[2], t[0]));
}

// Both triangles, halved, with a corner of the first one in the origin, and scaled by 2^-exponent so that products
// neither overflow nor underflow.
struct Pair {
  Corners t, u;
  int exponent = 0;
};
Pair brought_near_one(const Corners& t, const Corners& u) {
  Pair out;
  const auto halved = [&](const Vec3d& p) {
    return Vec3d{p.x / 2 - t[0].x / 2, p.y / 2 - t[0].y / 2, p.z / 2 - t[0].z / 2};
  };
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    out.t[i] = halved(t[i]), out.u[i] = halved(u[i]);
    largest = std::max({largest, largest_component(out.t[i]), largest_component(out.u[i])});
  }
  std::frexp(largest, &out.exponent);
  // A factor is faster than ldexp, where there is one.
  const bool has_factor = std::abs(out.exponent) < 1000;
  const double factor = has_factor ? std::ldexp(1.0, -out.exponent) : 1;
  const auto scaled = [&](double x) {
    return has_factor ? x * factor : std::ldexp(x, -out.exponent);
  };
  for (Corners* const corners : {&out.t, &out.u})
    for (Vec3d& p : *corners) p = {scaled(p.x), scaled(p.y), scaled(p.z)};
  return out;
}

// Where a triangle meets a plane, along a direction of the plane.
struct Range {
  double least = HUGE_VAL, most = -HUGE_VAL;
  Vec3d first, last;  // the points there
  void add(double x, const Vec3d& p) {
    if (x < least) least = x, first = p;
    if (x > most) most = x, last = p;
  }
};
Range range_in_plane(const Corners& t, const Vec3d& origin, const Vec3d& unit_normal,
                     const Vec3d& along) {
  constexpr double kOnPlane = 0x1p-46;  // coordinates are less than 1
  std::array<double, 3> height;
  Range out;
  for (std::size_t i = 0; i < 3; ++i) {
    height[i] = dot_of(unit_normal, difference_of(t[i], origin));
    if (std::abs(height[i]) > kOnPlane) continue;
    height[i] = 0;
    out.add(dot_of(along, t[i]), t[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (i + 1) % 3;
    if (!(height[i] * height[k] < 0)) continue;
    const Vec3d p = point_between(t[i], t[k], height[i] / (height[i] - height[k]));
    out.add(dot_of(along, p), p);
  }
  return out;
}

// What triangles in different planes have in common on the line in which the planes meet.
Range common_range(const Pair& pair, const Vec3d& n, const Vec3d& m, const Vec3d& along) {
  const auto unit = [](const Vec3d& a) {
    const double l = length_of(a);
    return Vec3d{a.x / l, a.y / l, a.z / l};
  };
  const Vec3d direction = unit(along);
  const Range of_t = range_in_plane(pair.t, pair.u[0], unit(m), direction),
              of_u = range_in_plane(pair.u, pair.t[0], unit(n), direction);
  Range out;
  out.least = std::max(of_t.least, of_u.least), out.most = std::min(of_t.most, of_u.most);
  out.first = of_t.least > of_u.least ? of_t.first : of_u.first;
  out.last = of_t.most < of_u.most ? of_t.last : of_u.last;
  return out;
}

// Clips a convex polygon by the half-plane to the left of the line from a to b, or to its right if the sign is -1;
// seen along an axis.
std::vector<Vec3d> clipped(const std::vector<Vec3d>& polygon, const Vec3d& a, const Vec3d& b,
                           int axis, double sign) {
  const Vec2d p = drop_axis(a, axis), q = drop_axis(b, axis);
  const auto side = [&](const Vec3d& point) {
    const Vec2d r = drop_axis(point, axis);
    return sign * ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
  };
  std::vector<Vec3d> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double here = side(from), there = side(to);
    if (here >= 0) out.push_back(from);
    if ((here < 0 && there > 0) || (here > 0 && there < 0))
      out.push_back(point_between(from, to, here / (here - there)));
  }
  return out;
}

double diameter_of(const Corners& t) {
  return std::max({length_of(difference_of(t[1], t[0])), length_of(difference_of(t[2], t[1])),
                   length_of(difference_of(t[0], t[2]))});
}

// The diameter of what triangles in one plane have in common. Where one of them is so small that all sides are 0,
// nothing is clipped.
double common_diameter(const Corners& t, const Corners& u, const Vec3d& normal_of_u) {
  const double largest = largest_component(normal_of_u);
  const int axis = std::abs(normal_of_u.x) == largest   ? 0
                   : std::abs(normal_of_u.y) == largest ? 1
                                                        : 2;
  const Vec2d a = drop_axis(u[0], axis), b = drop_axis(u[1], axis), c = drop_axis(u[2], axis);
  const double sign = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) < 0 ? -1 : 1;
  std::vector<Vec3d> polygon(t.begin(), t.end());
  for (std::size_t i = 0; i < 3; ++i) polygon = clipped(polygon, u[i], u[(i + 1) % 3], axis, sign);
  double most = 0;
  for (const Vec3d& p : polygon)
    for (const Vec3d& q : polygon) most = std::max(most, length_of(difference_of(p, q)));
  return std::min({most, diameter_of(t), diameter_of(u)});
}

// Whether the planes with these normals, and this cross product of them, have a line in common that is known well.
bool has_line(const Vec3d& n, const Vec3d& m, const Vec3d& along) {
  constexpr double kParallel = 0x1p-30;  // the sine of the angle of the planes
  return length_of(along) > kParallel * length_of(n) * length_of(m);
}

}  // namespace

double approx_common_extent(const std::array<Vec3d, 3>& t, const std::array<Vec3d, 3>& u) {
  const Pair pair = brought_near_one(t, u);
  const Vec3d n = normal_of(pair.t), m = normal_of(pair.u), along = cross_of(n, m);
  double out = 0;
  if (has_line(n, m, along)) {
    const Range range = common_range(pair, n, m, along);
    out = range.most - range.least;
  } else {
    out = common_diameter(pair.t, pair.u, m);
  }
  return out > 0 ? std::ldexp(out, pair.exponent + 1) : 0;
}

std::optional<std::array<Vec3d, 2>> approx_common_segment(const std::array<Vec3d, 3>& t,
                                                          const std::array<Vec3d, 3>& u) {
  const Pair pair = brought_near_one(t, u);
  const Vec3d n = normal_of(pair.t), m = normal_of(pair.u), along = cross_of(n, m);
  if (!has_line(n, m, along)) return std::nullopt;
  const Range range = common_range(pair, n, m, along);
  if (!(range.least < range.most)) return std::nullopt;
  const auto in_space = [&](const Vec3d& p) {
    const auto back = [&](double from, double by) {
      return from + std::ldexp(by, pair.exponent + 1);
    };
    return Vec3d{back(t[0].x, p.x), back(t[0].y, p.y), back(t[0].z, p.z)};
  };
  return std::array{in_space(range.first), in_space(range.last)};
}

}  // namespace veritope
