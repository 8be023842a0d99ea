// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/noisy_scans.h: noisy samples of solids of known genus, as of a volume scanner: points that are far from
// each other and close to every place inside, each moved by a random amount.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "predicates/vec.h"
#include "robust/base/random.h"

namespace veritope {

struct ScannedSolid {
  std::string name;
  int genus = 0;
  double half_size = 1;  ///< it lies in [-half_size, half_size]^3
  bool (*contains)(const Vec3d&) = nullptr;
};

namespace internal {
inline bool in_ring(double x, double y, double z, double centre) {
  const double r = std::hypot(x - centre, y) - 1.0;
  return r * r + z * z <= 0.16;
}
}  // namespace internal

inline std::vector<ScannedSolid> scanned_solids() {
  return {
      {"ball", 0, 1.0, [](const Vec3d& p) { return p.x * p.x + p.y * p.y + p.z * p.z <= 1; }},
      {"torus", 1, 1.5, [](const Vec3d& p) { return internal::in_ring(p.x, p.y, p.z, 0); }},
      {"double torus", 2, 2.6,
       [](const Vec3d& p) {
         return internal::in_ring(p.x, p.y, p.z, -1.1) || internal::in_ring(p.x, p.y, p.z, 1.1);
       }},
      {"block with a hole", 1, 1.0,
       [](const Vec3d& p) {
         return std::abs(p.z) <= 0.4 && std::max(std::abs(p.x), std::abs(p.y)) <= 1 &&
                std::hypot(p.x, p.y) >= 0.45;
       }},
      {"block with three holes", 3, 2.0,
       [](const Vec3d& p) {
         if (std::abs(p.z) > 0.35 || std::abs(p.y) > 0.9 || std::abs(p.x) > 2) return false;
         for (const double centre : {-1.2, 0.0, 1.2})
           if (std::hypot(p.x - centre, p.y) < 0.4) return false;
         return true;
       }},
      {"L-shaped bar", 0, 1.0,
       [](const Vec3d& p) {
         const double r = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z) * 2});
         return r <= 1 && !(p.x > -0.2 && p.y > -0.2);
       }},
  };
}

/// Points of the solid that are at least `distance` apart, as many as random attempts find; then each coordinate moves
/// by at most noise * distance.
inline std::vector<Vec3d> scan(const ScannedSolid& solid, double distance, double noise,
                               Random& random) {
  std::unordered_map<std::uint64_t, std::vector<Vec3d>> cells;
  const auto key = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    return static_cast<std::uint64_t>(((x + 4096) * 8192 + y + 4096) * 8192 + z + 4096);
  };
  const auto cell = [&](double x) { return static_cast<std::int64_t>(std::floor(x / distance)); };
  const auto is_free = [&](const Vec3d& p) {
    for (std::int64_t i = -1; i <= 1; ++i)
      for (std::int64_t j = -1; j <= 1; ++j)
        for (std::int64_t k = -1; k <= 1; ++k) {
          const auto found = cells.find(key(cell(p.x) + i, cell(p.y) + j, cell(p.z) + k));
          if (found == cells.end()) continue;
          for (const Vec3d& q : found->second)
            if (std::hypot(p.x - q.x, p.y - q.y, p.z - q.z) < distance) return false;
        }
    return true;
  };
  const auto u = [&] { return solid.half_size * (2 * random.unit() - 1); };
  const double volume = 8 * std::pow(solid.half_size / distance, 3);
  std::vector<Vec3d> out;
  for (auto attempts = static_cast<std::size_t>(100 * volume); attempts > 0; --attempts) {
    const Vec3d p{u(), u(), u()};
    if (!solid.contains(p) || !is_free(p)) continue;
    cells[key(cell(p.x), cell(p.y), cell(p.z))].push_back(p);
    out.push_back(p);
  }
  const auto move = [&](double x) { return x + noise * distance * (2 * random.unit() - 1); };
  for (Vec3d& p : out) p = {move(p.x), move(p.y), move(p.z)};
  return out;
}

}  // namespace veritope
