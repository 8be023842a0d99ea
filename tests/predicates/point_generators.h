// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/point_generators.h: the points of veritope selftest, for differential tests; and as text.
#pragma once
#include <array>
#include <cstdio>
#include <string>

#include "named_predicates/hard_points.h"

namespace veritope::generate {

/// Exact text that pastes back into a test.
inline std::string text(const Points& points) {
  std::string out;
  for (const Vec3d& p : points) {
    char buffer[128];
    std::snprintf(buffer, sizeof buffer, "{%a, %a, %a}, ", p.x, p.y, p.z);
    out += buffer;
  }
  return out;
}

inline Vec2d xy(const Vec3d& p) { return {p.x, p.y}; }

}  // namespace veritope::generate
