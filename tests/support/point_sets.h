// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/point_sets.h: random sets of points of all kinds, degenerate ones, too.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "predicates/vec.h"
#include "robust/base/random.h"

namespace veritope {

struct PointSet {
  std::string kind;
  std::vector<Vec3d> points;
};

inline constexpr int kPointSetKinds = 14;

namespace internal {

inline double signed_unit(Random& random) { return 2 * random.unit() - 1; }

// Integer points of a sphere around the origin, so many of one radius as there are.
inline std::vector<Vec3d> lattice_sphere(std::size_t count) {
  for (int radius = 3;; radius += 2) {
    std::vector<Vec3d> out;
    for (int x = -radius; x <= radius; ++x)
      for (int y = -radius; y <= radius; ++y) {
        const int rest = radius * radius - x * x - y * y;
        if (rest < 0) continue;
        const int z = static_cast<int>(std::lround(std::sqrt(rest)));
        if (z * z != rest) continue;
        out.push_back({double(x), double(y), double(z)});
        if (z != 0) out.push_back({double(x), double(y), -double(z)});
      }
    if (out.size() >= count) return out;
  }
}

}  // namespace internal

/// REQUIRES 0 <= kind < kPointSetKinds, count >= 5. The set spans space; it may have more or fewer points than asked.
inline PointSet make_point_set(int kind, std::size_t count, Random& random) {
  PointSet set;
  std::vector<Vec3d>& out = set.points;
  const auto u = [&] { return internal::signed_unit(random); };
  const auto side = static_cast<int>(std::ceil(std::cbrt(static_cast<double>(count))));
  const auto lattice = [&](int n) { return static_cast<double>(random.between(0, n)); };
  switch (kind) {
    case 0:
      set.kind = "uniform";
      for (std::size_t i = 0; i < count; ++i) out.push_back({u(), u(), u()});
      break;
    case 1:
      set.kind = "grid";
      for (int x = 0; x < side; ++x)
        for (int y = 0; y < side; ++y)
          for (int z = 0; z < side; ++z) out.push_back({double(x), double(y), double(z)});
      break;
    case 2:
      set.kind = "random points of a grid, with duplicates";
      for (std::size_t i = 0; i < count; ++i)
        out.push_back({lattice(side), lattice(side), lattice(side)});
      break;
    case 3:
      set.kind = "integer points of one sphere";
      out = internal::lattice_sphere(std::min<std::size_t>(count, 500));
      break;
    case 4:
      set.kind = "nearly on a sphere";
      for (std::size_t i = 0; i < count; ++i) {
        const double x = u(), y = u(), z = u(), r = std::sqrt(x * x + y * y + z * z) + 1e-9;
        out.push_back({x / r, y / r, z / r});
      }
      break;
    case 5:
      set.kind = "nearly coplanar";
      for (std::size_t i = 0; i < count; ++i) {
        const double x = u(), y = u();
        out.push_back({x, y, x / 3 + y / 7 + 0x1p-52 * std::floor(4 * u())});
      }
      break;
    case 6:
      set.kind = "huge and tiny";
      for (std::size_t i = 0; i < count; ++i) {
        const auto any = [&] {
          return std::ldexp(u(), static_cast<int>(random.between(-300, 300)));
        };
        out.push_back({any(), any(), any()});
      }
      break;
    case 7:
      set.kind = "clusters";
      for (std::size_t i = 0; i < count; ++i) {
        const double size = std::ldexp(1.0, -static_cast<int>(random.below(40)));
        const double at = static_cast<double>(random.below(5));
        out.push_back({at + size * u(), at * at + size * u(), size * u()});
      }
      break;
    case 8:
      set.kind = "on the walls of a box";
      for (std::size_t i = 0; i < count; ++i) {
        std::array<double, 3> p{u(), u(), u()};
        p[random.below(3)] = random.below(2) == 0 ? -1 : 1;
        out.push_back({p[0], p[1], p[2]});
      }
      break;
    case 9:
      set.kind = "on two skew lines";
      for (std::size_t i = 0; i < std::min<std::size_t>(count, 150); ++i)
        out.push_back(i % 2 == 0 ? Vec3d{u(), 0, 0} : Vec3d{0, u(), 1});
      break;
    case 10:
      set.kind = "on a line, and some more";
      for (std::size_t i = 0; i < std::min<std::size_t>(count, 300); ++i) {
        const double t = lattice(50);
        out.push_back(i % 7 == 0 ? Vec3d{lattice(9), lattice(9), lattice(9)}
                                 : Vec3d{t, 2 * t, 3 * t});
      }
      break;
    case 11:
      set.kind = "small integers";
      for (std::size_t i = 0; i < std::max<std::size_t>(count / 4, 5); ++i)
        out.push_back({lattice(2), lattice(3), lattice(2)});
      break;
    case 12:
      set.kind = "few points of a plane, nearly cospherical";
      for (std::size_t i = 0; i < count; ++i) {
        const double phi = 6.2831853 * random.unit(), z = lattice(2);
        out.push_back({std::cos(phi), std::sin(phi), z});
      }
      break;
    default:
      set.kind = "a grid, subnormal";
      for (std::size_t i = 0; i < count; ++i)
        out.push_back(
            {0x1p-1074 * lattice(side), 0x1p-1074 * lattice(side), 0x1p-1074 * lattice(side)});
      break;
  }
  if (kind == 2 || kind == 10 || kind == 11 || kind >= 13) {  // so that they span space
    const double unit = kind == 13 ? 0x1p-1074 : 1;
    for (const Vec3d& p : {Vec3d{0, 0, 0}, {unit, 0, 0}, {0, unit, 0}, {0, 0, unit}})
      out.push_back(p);
  }
  std::shuffle(out.begin(), out.end(), random);
  return set;
}

}  // namespace veritope
