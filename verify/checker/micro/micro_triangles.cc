// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_triangles.cc: which points are apart from triangles, or near to one; docs/certificates/micro-inside.md,
// sections 3 and 6.
#include <cstring>

#include "micro_net.h"

namespace {

typedef const double* Point3;

double binary64(int64_t key) {
  const uint64_t bits = magnitude(key) | uint64_t(key < 0) << 63;
  double r;
  static_assert(sizeof r == sizeof bits, "binary64");
  std::memcpy(&r, &bits, sizeof r);
  return r;
}
double largest(Point3 a) {
  return std::max(std::abs(a[0]), std::max(std::abs(a[1]), std::abs(a[2])));
}
double dot(Point3 a, Point3 b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
void subtract(Point3 a, Point3 b, double* to) {
  for (size_t k = 0; k < 3; ++k) to[k] = a[k] - b[k];
}
void cross(Point3 a, Point3 b, double* to) {
  for (size_t k = 0; k < 3; ++k)
    to[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

struct Direction {
  double d[3], error;  // of each component
};
// The triangle's values of d.(x - corner), for the exact d, are between 0 and `most`. Whether all points' values are
// less than 0, or all greater than `most`.
//
// With r for the largest coordinate of point - corner, which may be wrong by the hull's error e and 2^-51 r, and D for
// the largest component of d, a computed value differs by less than 3 (D (e + 2^-51 r) + error (r + e)) + 2^-48 D r
// from the exact one.
bool is_apart(const PointHull& hull, Point3 corner, const Direction& d, double most) {
  double least_value = 0, most_value = 0, r = 0;
  for (size_t i = 0; i < hull.p.size(); i += 3) {
    double to[3];
    subtract(&hull.p[i], corner, to);
    const double value = dot(d.d, to);
    least_value = i == 0 ? value : std::min(least_value, value);
    most_value = i == 0 ? value : std::max(most_value, value);
    r = std::max(r, largest(to));
  }
  const double size = largest(d.d), e = hull.error;
  const double tolerance =
      4 * (size * e + d.error * (r + e)) + std::ldexp(size * (r + e), -45) + kTiny;
  return most_value < -tolerance || least_value > most + tolerance;
}
// With E for the largest component of the edges, one of n differs by less than 2^-47 E^2 from the exact one, and one of
// n x edge by less than 3 E times that and 2^-47 E^3. (Differences of corners are wrong by 2^-51 E.)
bool is_apart(const PointHull& hull, const double (*corner)[3]) {
  double edge[3][3];
  double size = 0;
  for (size_t i = 0; i < 3; ++i) {
    subtract(corner[(i + 1) % 3], corner[i], edge[i]);
    size = std::max(size, largest(edge[i]));
  }
  Direction n;
  cross(edge[0], edge[1], n.d);  // (b - a) x (c - b) = (b - a) x (c - a)
  n.error = std::ldexp(size * size, -46) + kTiny;
  if (is_apart(hull, corner[0], n, 0)) return true;
  double square = 0;  // not less than that of the normal
  for (double x : n.d) square += (std::abs(x) + n.error) * (std::abs(x) + n.error);
  square += std::ldexp(square, -45) + kTiny;
  for (size_t i = 0; i < 3; ++i) {  // 0 at the edge's ends, n.n at the third corner
    Direction side;
    cross(n.d, edge[i], side.d);
    side.error = 4 * size * n.error + std::ldexp(size * size * size, -45) + kTiny;
    if (is_apart(hull, corner[i], side, square)) return true;
  }
  return false;
}

// A number that is not less than the distance of a point from a triangle. Any weights >= 0 name a point of the
// triangle; these are those of a nearest one but for rounding. [Ericson, Real-Time Collision Detection, 5.1.5]
double distance(Point3 p, const double (*t)[3]) {
  double ab[3], ac[3], ap[3], bp[3], cp[3];
  subtract(t[1], t[0], ab), subtract(t[2], t[0], ac);
  subtract(p, t[0], ap), subtract(p, t[1], bp), subtract(p, t[2], cp);
  const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp),
               d5 = dot(ab, cp), d6 = dot(ac, cp);
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  double w[3] = {va, vb, vc};
  if (d1 <= 0 && d2 <= 0)
    w[0] = 1, w[1] = 0, w[2] = 0;
  else if (d3 >= 0 && d4 <= d3)
    w[0] = 0, w[1] = 1, w[2] = 0;
  else if (d6 >= 0 && d5 <= d6)
    w[0] = 0, w[1] = 0, w[2] = 1;
  else if (vc <= 0 && d1 >= 0 && d3 <= 0)
    w[0] = -d3, w[1] = d1, w[2] = 0;
  else if (vb <= 0 && d2 >= 0 && d6 <= 0)
    w[0] = -d6, w[1] = 0, w[2] = d2;
  else if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    w[0] = 0, w[1] = d5 - d6, w[2] = d4 - d3;
  for (double& x : w) x = x > 0 ? x : 0;
  const double sum = w[0] + w[1] + w[2];
  for (double& x : w) x /= sum;
  double square = 0, size = 0;
  for (size_t k = 0; k < 3; ++k) {
    const double x = w[0] * t[0][k] + w[1] * t[1][k] + w[2] * t[2][k] - p[k];
    square += x * x;
    size = std::max(size, std::abs(t[0][k]) + std::abs(t[1][k]) + std::abs(t[2][k]));
  }
  const double r = std::sqrt(square);
  // If sum is 0 or overflows, r is not a number, and no comparison holds. Weights that are not exact move the point
  // along the triangle only, but for a sum that is 1 up to 2^-48.
  return r + std::ldexp(r, -45) + std::ldexp(size + largest(p), -44) + 1e-140;
}

std::vector<double> points_of(const Model& model) {
  std::vector<double> r;
  for (int64_t key : model.key) r.push_back(binary64(key));
  return r;
}
std::vector<DoubleBox> boxes_of(const Model& model, const std::vector<double>& points) {
  std::vector<DoubleBox> r(model.faces());
  for (size_t c = 0; c < model.tri.size(); ++c) {
    DoubleBox& b = r[c / 3];
    for (size_t k = 0; k < 3; ++k) {
      const double x = points[3 * size_t(model.tri[c]) + k];
      b.lo[k] = c % 3 == 0 ? x : std::min(b.lo[k], x);
      b.hi[k] = c % 3 == 0 ? x : std::max(b.hi[k], x);
    }
  }
  return r;
}

}  // namespace

Triangles::Triangles(const Model& model)
    : model_(model), points_(points_of(model)), tree_(boxes_of(model, points_)) {}

bool Triangles::misses(const PointHull& hull, uint64_t* pairs) {
  return hull.is_known && tree_.each(hull.box, [&](uint32_t face) {
    ++*pairs;
    double corner[3][3];
    corners(face, corner);
    return is_apart(hull, corner);
  });
}
bool Triangles::is_near(const PointHull& hull, double most, uint64_t* pairs) {
  if (!hull.is_known) return false;
  DoubleBox grown = hull.box;
  for (size_t k = 0; k < 3; ++k) {
    const double more =
        most + std::ldexp(std::abs(grown.lo[k]) + std::abs(grown.hi[k]) + most, -45);
    grown.lo[k] -= more, grown.hi[k] += more;
  }
  // False if such a triangle is found.
  return !tree_.each(grown, [&](uint32_t face) {
    ++*pairs;
    double corner[3][3];
    corners(face, corner);
    for (size_t i = 0; i < hull.p.size(); i += 3)
      if (!(distance(&hull.p[i], corner) + 2 * hull.error <= most)) return true;
    return false;
  });
}
