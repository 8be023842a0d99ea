// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/clip_oracle.h: the intersection of two triangles with small integer corners, by
// cutting one of them with the five half-spaces whose intersection is the other. Shares no line and
// no idea with predicates/triangle_triangle.cc.
#pragma once
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "robust/base/int128.h"

namespace veritope::oracle {

/// (x, y, z) / w with w > 0 and no common factor.
struct HPoint {
  std::int64_t x, y, z, w;
  friend bool operator==(const HPoint&, const HPoint&) = default;
};
using IPoint = std::array<std::int64_t, 3>;
using ITriangle = std::array<IPoint, 3>;

inline IPoint minus(const IPoint& a, const IPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline IPoint cross(const IPoint& a, const IPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The part of the convex hull of `polygon` (in cyclic order) where n . (p - through) >= 0.
inline std::vector<HPoint> cut(const std::vector<HPoint>& polygon, const IPoint& n,
                               const IPoint& through) {
  const auto height = [&](const HPoint& p) -> int128 {
    return static_cast<int128>(n[0]) * (p.x - through[0] * p.w) +
           static_cast<int128>(n[1]) * (p.y - through[1] * p.w) +
           static_cast<int128>(n[2]) * (p.z - through[2] * p.w);  // times p.w
  };
  std::vector<HPoint> out;
  const auto add = [&](const HPoint& p) {
    if (out.empty() || !(out.back() == p)) out.push_back(p);
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const HPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const int128 hp = height(p), hq = height(q);
    if (hp >= 0) add(p);
    if ((hp < 0 && hq > 0) || (hp > 0 && hq < 0)) {
      // Heights carry the factors p.w and q.w, so hq * p - hp * q is the homogeneous crossing
      // point.
      const int128 s = hp < 0 ? 1 : -1;
      int128 x = s * (hq * p.x - hp * q.x), y = s * (hq * p.y - hp * q.y),
             z = s * (hq * p.z - hp * q.z), w = s * (hq * p.w - hp * q.w);
      const auto gcd = [](int128 a, int128 b) {
        a = a < 0 ? -a : a, b = b < 0 ? -b : b;
        while (b != 0) {
          const int128 r = a % b;
          a = b, b = r;
        }
        return a;
      };
      const int128 g = gcd(gcd(x, y), gcd(z, w));
      add({static_cast<std::int64_t>(x / g), static_cast<std::int64_t>(y / g),
           static_cast<std::int64_t>(z / g), static_cast<std::int64_t>(w / g)});
    }
  }
  if (out.size() > 1 && out.front() == out.back()) out.pop_back();
  return out;
}

/// Points whose convex hull is what the closed triangle u and the hull of `points` (a point, a
/// segment or a triangle) have in common; empty iff they are disjoint. REQUIRES u non-degenerate.
inline std::vector<HPoint> intersection(const std::vector<IPoint>& points, const ITriangle& u) {
  std::vector<HPoint> polygon;
  for (const IPoint& p : points) polygon.push_back({p[0], p[1], p[2], 1});
  const IPoint n = cross(minus(u[1], u[0]), minus(u[2], u[0]));
  polygon = cut(polygon, n, u[0]);
  polygon = cut(polygon, {-n[0], -n[1], -n[2]}, u[0]);
  for (int i = 0; i < 3; ++i) polygon = cut(polygon, cross(n, minus(u[(i + 1) % 3], u[i])), u[i]);
  return polygon;
}
inline std::vector<HPoint> intersection(const ITriangle& t, const ITriangle& u) {
  return intersection(std::vector<IPoint>(t.begin(), t.end()), u);
}

inline bool degenerate(const ITriangle& t) {
  return cross(minus(t[1], t[0]), minus(t[2], t[0])) == IPoint{0, 0, 0};
}
inline bool coplanar(const ITriangle& t, const ITriangle& u) {
  const IPoint n = cross(minus(u[1], u[0]), minus(u[2], u[0]));
  for (const IPoint& p : t) {
    const IPoint d = minus(p, u[0]);
    if (n[0] * d[0] + n[1] * d[1] + n[2] * d[2] != 0) return false;
  }
  return true;
}
/// Is p on the closed segment a b, which may be a point?
inline bool on_segment(const HPoint& p, const IPoint& a, const IPoint& b) {
  const IPoint e = minus(b, a), d = {p.x - a[0] * p.w, p.y - a[1] * p.w, p.z - a[2] * p.w};
  if (e == IPoint{0, 0, 0}) return d == IPoint{0, 0, 0};
  if (cross(e, d) != IPoint{0, 0, 0}) return false;
  const std::int64_t along = e[0] * d[0] + e[1] * d[1] + e[2] * d[2];
  return along >= 0 && along <= p.w * (e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
}

}  // namespace veritope::oracle
