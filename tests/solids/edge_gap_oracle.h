// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/solids/edge_gap_oracle.h: gaps of edges in rationals, word by word as solids/polyhedron/edge_gap.h defines
// them, and random edges that are near to the cases where answers change.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "robust/base/random.h"
#include "solids/polyhedron/edge_gap.h"
#include "tests/support/exact_geometry.h"

namespace veritope::oracle {

struct RSegment {
  RVec a, b;
};
inline RSegment rational(const EdgeEnds& e) { return {rational(e.a), rational(e.b)}; }

/// Where p is projected to, as a parameter of the line of f. REQUIRES that the ends of f differ.
inline Rational foot(const RVec& p, const RSegment& f) {
  const RVec d = f.b - f.a;
  return dot(p - f.a, d) / dot(d, d);
}

inline Rational squared_distance(const RVec& p, const RSegment& f) {
  Rational t;
  if (!is_zero(f.b - f.a)) t = std::clamp(foot(p, f), Rational(0), Rational(1));
  const RVec r = p - (f.a + t * (f.b - f.a));
  return dot(r, r);
}

inline Rational squared_gap(const RSegment& e, const RSegment& f) {
  return std::min(std::max(squared_distance(e.a, f), squared_distance(e.b, f)),
                  std::max(squared_distance(f.a, e), squared_distance(f.b, e)));
}

inline bool run_along(const RSegment& e, const RSegment& f) {
  const RVec d = e.b - e.a, g = f.b - f.a;
  if (is_zero(d) || is_zero(g)) return false;
  const Rational cosine = dot(d, g);
  if (cosine * cosine / (dot(d, d) * dot(g, g)) <= Rational(3) / Rational(4)) return false;
  const Rational half = Rational(1) / Rational(2);
  const auto is_inside = [](const Rational& t) { return Rational(0) <= t && t <= Rational(1); };
  return is_inside(foot(half * (e.a + e.b), f)) || is_inside(foot(half * (f.a + f.b), e));
}

inline std::string text(const Vec3d& p) {
  char out[100];
  std::snprintf(out, sizeof out, "{%a, %a, %a}", p.x, p.y, p.z);
  return out;
}
inline std::string text(const EdgeEnds& e) { return "{" + text(e.a) + ", " + text(e.b) + "}"; }

/// Kinds of random edges: on a small grid; anywhere; on a line, up to the last bits; exponents from least to greatest;
/// all subnormal; all huge; small ones so far from the origin that sums of coordinates are rounded.
inline constexpr int kNumEdgeKinds = 7;

inline Vec3d random_point(Random& random, int kind) {
  const auto one = [&]() -> double {
    const double unit = 2 * random.unit() - 1;
    switch (kind) {
      case 0: return static_cast<double>(random.between(0, 2));
      case 1: return unit;
      case 3: return std::ldexp(unit, static_cast<int>(random.between(-1074, 1023)));
      case 4: return std::ldexp(static_cast<double>(random.between(-9, 9)), -1074);
      case 6: return 0x1p52 + static_cast<double>(random.between(0, 6));
      default: return std::ldexp(unit, 1024);
    }
  };
  if (kind != 2) return {one(), one(), one()};
  const double t = static_cast<double>(random.between(-8, 8)) / 8, e = 0x1p-52;
  const auto noise = [&] { return e * static_cast<double>(random.between(-1, 1)); };
  return {1 + t + noise(), 1 - 2 * t + noise(), 3 * t + noise()};
}
inline EdgeEnds random_edge(Random& random, int kind) {
  return {random_point(random, kind), random_point(random, kind)};
}

}  // namespace veritope::oracle
