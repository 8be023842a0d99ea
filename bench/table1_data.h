// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/table1_data.h: three sets of points with attributes, and domains for them, after table 1 of [HHQ04], whose
// data are not published: as many points, and functions and shapes of our own.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robust/base/random.h"
#include "solids/dms/dms_make.h"
#include "solids/dms/dms_region.h"
#include "solids/dms/fit/dms_data.h"
#include "tests/support/random_dms.h"

namespace veritope::bench {

using Place = std::array<double, 3>;

inline Rational ratio_of(long p, long q) { return Rational(p) / Rational(q); }

inline Place draw_place(Random& random) {
  constexpr std::int64_t kSteps = std::int64_t{1} << 30;
  Place out{};
  for (double& c : out)
    c = static_cast<double>(random.between(0, kSteps)) / static_cast<double>(kSteps);
  return out;
}

/// `count` points drawn from the unit cube and mapped; those that `map` refuses are drawn again.
template <typename Map, typename Value>
DmsData draw_data(std::size_t count, std::uint64_t seed, Map map, Value value) {
  DmsData data;
  Random random(seed);
  while (data.points.size() < count) {
    Place p = draw_place(random);
    if (!map(p)) continue;
    data.points.push_back(
        {Rational::from_double(p[0]), Rational::from_double(p[1]), Rational::from_double(p[2])});
    data.values.push_back(Rational::from_double(value(p)));
  }
  return data;
}

/// A domain as dms fit wants it: degree 1, the identity, without vertices that no tetrahedron has.
inline DmsModel identity_on(const DmsModel& grid) {
  DmsModel domain;
  std::vector<std::uint32_t> number(grid.clouds.size());
  for (TetrahedronCorners t : grid.tetrahedra) {
    for (std::uint32_t& v : t) {
      if (number[v] == 0) {
        domain.clouds.push_back(grid.clouds[v]);
        number[v] = static_cast<std::uint32_t>(domain.clouds.size());
      }
      v = number[v] - 1;
    }
    domain.tetrahedra.push_back(t);
  }
  set_control_by_rule(domain, DmsControlRule::kGreville, {});
  return domain;
}

// ---- a layer around a sphere in the unit cube

inline double layer_value(const Place& p) {
  const double r = std::hypot(p[0] - 0.5, p[1] - 0.5, p[2] - 0.5);
  return 0.5 + 0.5 * std::tanh(25 * (0.3 - r));
}
inline DmsData layer_data() {
  return draw_data(
      15832, 1, [](Place&) { return true; }, layer_value);
}
inline DmsModel cube_domain(int cells) {
  DmsModel domain = kuhn_domain({cells, cells, cells});
  for (DmsCloud& cloud : domain.clouds)
    for (Rational& c : cloud[0]) c /= Rational(cells);
  return identity_on(domain);
}

// ---- a cross of three bars, with a kink on the plane z = x / 5 + y / 10

inline DmsPlane cross_plane() { return {{ratio_of(-1, 5), ratio_of(-1, 10), Rational(1)}, 0}; }
inline double cross_value(const Place& p) {
  return 0.4 + 0.3 * std::abs(p[2] - p[0] / 5 - p[1] / 10) +
         0.1 * std::sin(2 * p[0] + p[2]) * std::cos(p[1]);
}
/// Bars of width 2/3 along the axes of the cube [-1,1]^3.
inline bool is_in_cross(const Place& p) {
  int narrow = 0;
  for (const double c : p) narrow += std::abs(c) <= 1.0 / 3;
  return narrow >= 2;
}
inline DmsData cross_data() {
  return draw_data(
      24128, 2,
      [](Place& p) {
        for (double& c : p) c = 2 * c - 1;
        return is_in_cross(p);
      },
      cross_value);
}
/// @param conforms  whether the plane is a union of faces: vertices of the plane z = 0 are moved along z
inline DmsModel cross_domain(bool conforms) {
  const auto is_middle = [](int i) { return i == 2 || i == 3; };
  DmsModel domain = kuhn_domain({6, 6, 6}, [&](int x, int y, int z) {
    return is_middle(x) + is_middle(y) + is_middle(z) >= 2;
  });
  for (DmsCloud& cloud : domain.clouds) {
    for (Rational& c : cloud[0]) c = c / Rational(3) - Rational(1);
    if (conforms && cloud[0][2] == Rational(0))
      cloud[0][2] = cloud[0][0] * ratio_of(1, 5) + cloud[0][1] * ratio_of(1, 10);
  }
  return identity_on(domain);
}

// ---- a curved part: half a ring

inline double ring_value(const Place& p) {
  return 0.5 + 0.25 * std::sin(9 * p[0]) * std::cos(7 * p[1]) +
         0.25 * std::sin(8 * p[2] + 3 * p[0]);
}
constexpr double kInnerRadius = 0.4, kOuterRadius = 0.9, kHeight = 0.5;

inline DmsData ring_data() {
  return draw_data(
      34744, 3,
      [](Place& p) {
        p = {2 * p[0] - 1, p[1], kHeight * p[2]};
        const double r = std::hypot(p[0], p[1]);
        return kInnerRadius <= r && r <= kOuterRadius;
      },
      ring_value);
}
/// Prisms around the ring: the outer boundary is circumscribed, the inner one inscribed.
inline DmsModel ring_domain(int around, int across, int up) {
  DmsModel domain = kuhn_domain({around, across, up});
  const double step = std::acos(-1.0) / around;
  for (DmsCloud& cloud : domain.clouds) {
    const double angle = step * (around - nearest_double(cloud[0][0])),
                 part = nearest_double(cloud[0][1]) / across,
                 outer = 1.0001 * kOuterRadius / std::cos(step / 2),
                 radius = (1 - part) * 0.9999 * kInnerRadius + part * outer;
    const bool is_end = cloud[0][0] == Rational(0) || cloud[0][0] == Rational(around);
    cloud[0] = {Rational::from_double(radius * std::cos(angle)),
                is_end ? Rational(0) : Rational::from_double(radius * std::sin(angle)),
                cloud[0][2] * Rational::from_double(kHeight) / Rational(up)};
  }
  return identity_on(domain);
}

}  // namespace veritope::bench
