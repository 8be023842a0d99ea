// SPDX-License-Identifier: LGPL-3.0-or-later
// named_predicates/hard_points.h: seeded points for self-tests and differential tests. Each class is a way in which
// predicates have failed.
#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "predicates/vec.h"
#include "robust/base/random.h"

namespace veritope::generate {

enum class Kind {
  kGeneric,        ///< uniform in (-1, 1)^3
  kSmallGrid,      ///< integers in [-3, 3]: many zeros
  kFlat,           ///< exactly coplanar (and, in x and y, collinear) integers of up to 40 bits
  kRound,          ///< exactly cospherical (in x and y: cocircular): corners of a box
  kNearFlat,       ///< kFlat / 2^40, each coordinate then moved by up to 2 ulp
  kNearRound,      ///< kRound / 2^20, each coordinate then moved by up to 2 ulp
  kScaledFlat,     ///< kFlat times a power of two between 2^-1000 and 2^900
  kScaledRound,    ///< kRound times such a power
  kWideExponents,  ///< full mantissas, exponents spread over 2^-40..1
  kRandomBits,     ///< any finite binary64, uniformly by its bits
  kSubnormal,      ///< small multiples of 2^-1074
  kMixedExtremes,  ///< 0, -0, 1, the least subnormal, the largest number, and their neighbours
  kNearLimits,  ///< full mantissas; products of two to five of them overflow or underflow, or nearly
};
inline constexpr int kNumKinds = 13;
inline constexpr const char* kKindNames[kNumKinds] = {
    "generic",    "small grid",     "flat",         "round",          "near flat",
    "near round", "scaled flat",    "scaled round", "wide exponents", "random bits",
    "subnormal",  "mixed extremes", "near limits"};

using Points = std::array<Vec3d, 5>;

inline double random_finite(Random& random) {
  for (;;) {
    const double v = std::bit_cast<double>(random.next());
    if (std::isfinite(v)) return v;
  }
}

inline double nudged(double v, Random& random) {
  for (std::int64_t steps = random.between(-2, 2); steps != 0; steps += steps > 0 ? -1 : 1) {
    v = std::nextafter(v, steps > 0 ? 1e308 : -1e308);
  }
  return v;
}

inline Points flat(Random& random) {
  const std::int64_t range = std::int64_t{1} << random.between(2, 18);
  std::array<std::int64_t, 3> origin, u, v;
  for (int i = 0; i < 3; ++i) {
    origin[i] = random.between(-range, range) * range;
    u[i] = random.between(-range, range), v[i] = random.between(-range, range);
  }
  const bool line_in_xy = random.below(2) == 0;
  if (line_in_xy) v[0] = 2 * u[0], v[1] = 2 * u[1];
  Points points;
  for (Vec3d& p : points) {
    const std::int64_t s = random.between(-range, range), t = random.between(-range, range);
    p = {static_cast<double>(origin[0] + s * u[0] + t * v[0]),
         static_cast<double>(origin[1] + s * u[1] + t * v[1]),
         static_cast<double>(origin[2] + s * u[2] + t * v[2])};
  }
  return points;
}

inline Points round(Random& random) {
  const std::int64_t range = std::int64_t{1} << random.between(1, 25);
  std::array<double, 3> centre, half;
  for (int i = 0; i < 3; ++i) {
    centre[i] = static_cast<double>(random.between(-range, range));
    half[i] = static_cast<double>(random.between(0, range));
  }
  Points points;
  for (Vec3d& p : points) {
    const std::uint64_t side = random.below(8);
    p = {centre[0] + (side & 1 ? half[0] : -half[0]), centre[1] + (side & 2 ? half[1] : -half[1]),
         centre[2] + (side & 4 ? half[2] : -half[2])};
  }
  return points;
}

template <typename Change>
Points changed(Points points, Change change) {
  for (Vec3d& p : points) p = {change(p.x), change(p.y), change(p.z)};
  return points;
}

inline Points near_limits(Random& random) {
  constexpr int kLimits[] = {1024, -900, -960, -1022, -1074};
  const int degree = static_cast<int>(random.between(2, 5));
  const int exponent = kLimits[random.below(5)] / degree + static_cast<int>(random.between(-3, 3));
  // In half of the cases one axis is longer and another shorter.
  const int slant = random.below(2) == 0 ? 0 : static_cast<int>(random.between(-8, 8));
  Points points;
  for (Vec3d& p : points) {
    const auto draw = [&](int e) { return std::ldexp(2 * random.unit() - 1, e); };
    p = {draw(exponent + slant), draw(exponent), draw(exponent - slant)};
  }
  if (random.below(2) == 0) points[4] = {};  // a circle or sphere seen from the origin
  return points;
}

inline Points points(Kind kind, Random& random) {
  Points out;
  const auto fill = [&](auto draw) {
    return changed(out, [&](double) -> double { return draw(); });
  };
  switch (kind) {
    case Kind::kGeneric: return fill([&] { return 2 * random.unit() - 1; });
    case Kind::kSmallGrid: return fill([&] { return static_cast<double>(random.between(-3, 3)); });
    case Kind::kFlat: return flat(random);
    case Kind::kRound: return round(random);
    case Kind::kNearFlat:
      return changed(flat(random), [&](double v) { return nudged(v * 0x1p-40, random); });
    case Kind::kNearRound:
      return changed(round(random), [&](double v) { return nudged(v * 0x1p-20, random); });
    case Kind::kScaledFlat:
    case Kind::kScaledRound: {
      const int exponent = static_cast<int>(random.between(-1000, 900));
      return changed(kind == Kind::kScaledFlat ? flat(random) : round(random),
                     [&](double v) { return std::ldexp(v, exponent); });
    }
    case Kind::kWideExponents:
      return fill([&] {
        return std::ldexp(2 * random.unit() - 1, static_cast<int>(random.between(-40, 0)));
      });
    case Kind::kRandomBits: return fill([&] { return random_finite(random); });
    case Kind::kSubnormal:
      return fill([&] { return static_cast<double>(random.between(-4, 4)) * 0x1p-1074; });
    case Kind::kMixedExtremes:
      return fill([&] {
        constexpr double kBase[] = {0.0,       -0.0, 1.0,     0x1p-1074, 0x1.fffffffffffffp1023,
                                    0x1p-1022, 3.0,  0x1p511, 0x1p-537};
        const double v = nudged(kBase[random.below(9)], random);
        const double finite = std::isfinite(v) ? v : 0x1.fffffffffffffp1023;
        return random.below(2) == 0 ? finite : -finite;
      });
    case Kind::kNearLimits: return near_limits(random);
  }
  return out;
}

}  // namespace veritope::generate
