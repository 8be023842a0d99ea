// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/implicit_oracle.h: implicit points as GMP's own rationals, by Cramer's rule, and
// the predicates on them as determinants. Shares no line with robust/ or predicates/.
#pragma once
#include <gmpxx.h>

#include <array>
#include <optional>
#include <vector>

#include "predicates/implicit_cache.h"
#include "predicates/implicit_kinds.h"
#include "tests/predicates/rational_oracle.h"

namespace veritope::oracle {

/// Two or three coordinates; none if the point does not exist.
using Exact = std::vector<mpq_class>;
using MaybeExact = std::optional<Exact>;

inline Exact exact(const Vec3d& p) { return {p.x, p.y, p.z}; }
inline Exact exact(const Vec2d& p) { return {p.x, p.y}; }
inline Exact minus(const Exact& a, const Exact& b) {
  Exact r;
  for (std::size_t i = 0; i < a.size(); ++i) r.push_back(a[i] - b[i]);
  return r;
}
inline Exact cross(const Exact& a, const Exact& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline mpq_class dot(const Exact& a, const Exact& b) {
  mpq_class r;
  for (std::size_t i = 0; i < a.size(); ++i) r += a[i] * b[i];
  return r;
}
/// a + t u
inline Exact moved(const Exact& a, const mpq_class& t, const Exact& u) {
  Exact r;
  for (std::size_t i = 0; i < a.size(); ++i) r.push_back(a[i] + t * u[i]);
  return r;
}

inline MaybeExact point(const Vec3d& p) { return exact(p); }
inline MaybeExact point(const Vec2d& p) { return exact(p); }
// The weights as the point keeps them: it may have negated all of them.
template <typename P>
MaybeExact weighted(const P& p) {
  const auto& points = p.points();
  const auto& weights = p.weights();
  const mpq_class d = weights.back();
  if (sgn(d) == 0) return std::nullopt;
  Exact r = exact(points[0]);
  for (std::size_t i = 1; i < points.size(); ++i)
    r = moved(r, weights[i - 1] / d, minus(exact(points[i]), exact(points[0])));
  return r;
}
inline MaybeExact point(const SegmentPoint& p) { return weighted(p); }
inline MaybeExact point(const TrianglePoint& p) { return weighted(p); }
inline MaybeExact point(const SegmentPoint2d& p) { return weighted(p); }
inline MaybeExact point(const SegmentSegmentPoint2d& s) {
  const Exact a = exact(s.points()[0]), u = minus(exact(s.points()[1]), a),
              c = exact(s.points()[2]), w = minus(exact(s.points()[3]), c);
  const mpq_class d = u[0] * w[1] - u[1] * w[0];
  if (sgn(d) == 0) return std::nullopt;
  const Exact g = minus(c, a);
  return moved(a, (g[0] * w[1] - g[1] * w[0]) / d, u);
}
inline Exact normal(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return cross(minus(exact(b), exact(a)), minus(exact(c), exact(a)));
}
inline MaybeExact point(const LinePlanePoint& p) {
  const auto& v = p.points();
  const Exact n = normal(v[2], v[3], v[4]), a = exact(v[0]), u = minus(exact(v[1]), a);
  const mpq_class d = dot(n, u);
  if (sgn(d) == 0) return std::nullopt;
  return moved(a, dot(n, minus(exact(v[2]), a)) / d, u);
}
inline MaybeExact point(const ThreePlanePoint& p) {
  const auto& v = p.points();
  std::array<Exact, 3> n;
  std::array<mpq_class, 3> k;
  for (int i = 0; i < 3; ++i) {
    n[i] = normal(v[3 * i], v[3 * i + 1], v[3 * i + 2]);
    k[i] = dot(n[i], exact(v[3 * i]));
  }
  const Exact a = cross(n[1], n[2]), b = cross(n[2], n[0]), c = cross(n[0], n[1]);
  const mpq_class d = dot(n[0], a);
  if (sgn(d) == 0) return std::nullopt;
  return Exact{(k[0] * a[0] + k[1] * b[0] + k[2] * c[0]) / d,
               (k[0] * a[1] + k[1] * b[1] + k[2] * c[1]) / d,
               (k[0] * a[2] + k[1] * b[2] + k[2] * c[2]) / d};
}
template <typename P>
MaybeExact point(const CachedPoint<P>& p) {
  return point(p.point());
}

/// orient2d and orient3d, of three and four points of two and three coordinates.
inline int orient(const std::vector<Exact>& points) {
  Matrix m;
  for (const Exact& p : points) {
    m.push_back({1});
    m.back().insert(m.back().end(), p.begin(), p.end());
  }
  return determinant_sign(std::move(m));
}
/// in_circle and in_sphere, of four and five points.
inline int in_ball(const std::vector<Exact>& points) {
  Matrix m;
  for (const Exact& p : points) {
    m.push_back({1});
    m.back().insert(m.back().end(), p.begin(), p.end());
    m.back().push_back(dot(p, p));
  }
  return -determinant_sign(std::move(m));
}
inline int along(const Exact& direction, const Exact& p, const Exact& q) {
  return sgn(dot(direction, minus(p, q)));
}

}  // namespace veritope::oracle
