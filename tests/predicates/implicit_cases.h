// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/implicit_cases.h: the points of named_predicates/hard_implicit_points.h as points of every kind; and as text.
#pragma once
#include <array>
#include <cstdio>
#include <string>
#include <variant>
#include <vector>

#include "named_predicates/hard_implicit_points.h"
#include "predicates/implicit_cache.h"
#include "predicates/implicit_kinds.h"
#include "tests/predicates/point_generators.h"

namespace veritope::generate {

using Point3 = std::variant<Vec3d, SegmentPoint, TrianglePoint, LinePlanePoint, ThreePlanePoint,
                            CachedPoint<LinePlanePoint>, CachedPoint<ThreePlanePoint>>;
using Point2 = std::variant<Vec2d, SegmentPoint2d, SegmentSegmentPoint2d>;

inline AnyPoint3 any(const Point3& p) {
  return std::visit([](const auto& v) { return AnyPoint3(v); }, p);
}
inline AnyPoint2 any(const Point2& p) {
  return std::visit([](const auto& v) { return AnyPoint2(v); }, p);
}
/// The points' numbers in order, and whether a point that can remember digits does.
inline Point3 make3(const Disguised& d, bool is_cached) {
  const auto& v = d.numbers;
  const auto at = [&](std::size_t i) { return Vec3d{v[3 * i], v[3 * i + 1], v[3 * i + 2]}; };
  switch (d.kind) {
    case 's': return SegmentPoint(at(0), at(1), v[6], v[7]);
    case 't': return TrianglePoint(at(0), at(1), at(2), v[9], v[10], v[11]);
    case 'l': {
      const LinePlanePoint p(at(0), at(1), at(2), at(3), at(4));
      return is_cached ? Point3(CachedPoint(p)) : Point3(p);
    }
    case 'p': {
      const ThreePlanePoint p({at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7), at(8)});
      return is_cached ? Point3(CachedPoint(p)) : Point3(p);
    }
    default: return at(0);
  }
}
inline Point2 make2(const Disguised& d) {
  const auto& v = d.numbers;
  const auto at = [&](std::size_t i) { return Vec2d{v[2 * i], v[2 * i + 1]}; };
  if (d.kind == 'S') return SegmentPoint2d(at(0), at(1), v[4], v[5]);
  if (d.kind == 'X') return SegmentSegmentPoint2d(at(0), at(1), at(2), at(3));
  return at(0);
}

inline std::string text(const Disguised& d) {
  std::string out(1, d.kind);
  for (const double v : d.numbers) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, " %a", v);
    out += buffer;
  }
  return out + "; ";
}

/// Five points of random kinds, a third of them explicit.
inline std::vector<Disguised> implicit_case(Random& random, int dimension) {
  const std::string_view letters = dimension == 3 ? "eestlp" : "EESX";
  std::string kinds;
  for (int i = 0; i < 5; ++i) kinds += letters[random.below(letters.size())];
  return disguised_points(kinds, static_cast<Wanted>(random.below(3)), random);
}

}  // namespace veritope::generate
