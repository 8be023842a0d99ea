// SPDX-License-Identifier: LGPL-3.0-or-later
// named_predicates/hard_implicit_points.h: hard cases for predicates on implicit points, seeded. Integer points that
// are exactly degenerate (on a plane, on a sphere, on a small grid, coincident) are disguised: written as points of
// another kind. Then all numbers are scaled, or moved by some units in the last place. Other cases have arbitrary
// defining points.
#pragma once
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "named_predicates/hard_points.h"

namespace veritope::generate {

/// The kinds of points as letters, in space e: explicit, s: on a segment (two points, numerator, denominator),
/// t: on a triangle (three points, two numerators, denominator), l: line and plane (two points, three points),
/// p: three planes (nine points); in the plane E: explicit, S: on a segment, X: where two lines meet (four points).
struct Disguised {
  char kind = 'e';
  std::vector<double> numbers;      ///< coordinates, then weights
  std::size_t num_coordinates = 0;  ///< the number of coordinates
};

constexpr bool is_flat_kind(char kind) { return kind == 'E' || kind == 'S' || kind == 'X'; }

class Disguise {
 public:
  explicit Disguise(Random& random) : random_(random), range_(1 << random.between(2, 12)) {}

  /// The point p, written as a point of this kind. REQUIRES integers below 2^48.
  Disguised operator()(const Vec3d& p, char kind) {
    Disguised d{kind, {}, 0};
    const int dimension = is_flat_kind(kind) ? 2 : 3;
    const auto put = [&](const Vec3d& v) {
      for (int axis = 0; axis < dimension; ++axis) d.numbers.push_back(v[axis]);
      d.num_coordinates = d.numbers.size();
    };
    const auto put_line = [&] {
      const Vec3d u = vector();
      const double k = factor(), m = factor();
      put(moved(p, -k, u)), put(moved(p, m, u));
      return std::array<double, 2>{k, k + m};
    };
    const auto put_plane = [&] {
      const Vec3d v = vector(), w = vector();
      const double i = factor(), j = factor(), k = factor();
      put(moved(moved(p, i, v), j, w)), put(moved(moved(p, -k, v), j, w));
      put(moved(moved(p, i, v), -k, w));
    };
    switch (kind) {
      case 's':
      case 'S': {
        const auto weights = put_line();
        const double sign = random_.below(2) == 0 ? 1 : -1;
        d.numbers.insert(d.numbers.end(), {sign * weights[0], sign * weights[1]});
        break;
      }
      case 't': {
        const Vec3d v = vector(), w = vector();
        const double i = factor(), j = factor(), r = factor(), s = factor();
        const Vec3d a = moved(moved(p, -i, v), -j, w);
        put(a), put(moved(a, r, v)), put(moved(a, s, w));
        d.numbers.insert(d.numbers.end(), {i * s, j * r, r * s});
        break;
      }
      case 'X': put_line(), put_line(); break;
      case 'l': put_line(), put_plane(); break;
      case 'p': put_plane(), put_plane(), put_plane(); break;
      default: put(p);
    }
    return d;
  }

 private:
  static Vec3d moved(const Vec3d& p, double t, const Vec3d& u) {
    return {p.x + t * u.x, p.y + t * u.y, p.z + t * u.z};
  }
  Vec3d vector() {
    const auto draw = [&] { return static_cast<double>(random_.between(-range_, range_)); };
    const double x = draw(), y = draw(), z = draw();  // braces would fix the order, too
    return {x, y, z};
  }
  double factor() { return static_cast<double>(random_.between(1, 3)); }

  Random& random_;
  std::int64_t range_;
};

/// Replaces all numbers by others, of any kind of points.
inline void replace_by_any(Disguised& d, Kind kind, Random& random) {
  const int dimension = is_flat_kind(d.kind) ? 2 : 3;
  for (std::size_t k = 0; k < d.num_coordinates;) {
    for (const Vec3d& p : points(kind, random)) {
      for (int axis = 0; axis < dimension && k < d.num_coordinates; ++axis)
        d.numbers[k++] = p[axis];
    }
  }
  for (std::size_t k = d.num_coordinates; k < d.numbers.size(); ++k)
    d.numbers[k] = points(kind, random)[0].x;
}

enum class Wanted { kFlat, kRound, kEqual };  ///< what the points are exactly, in some cases

/// At most five points of the kinds. In approximately one case in a hundred they do not exist.
inline std::vector<Disguised> disguised_points(std::string_view kinds, Wanted wanted,
                                               Random& random) {
  const std::uint64_t how = random.below(8);  // 0 to 4: wanted, 5: on a small grid, 6: flat, 7: any
  Kind base = how == 5 ? Kind::kSmallGrid : Kind::kFlat;
  if (how < 5 && wanted == Wanted::kRound) base = Kind::kRound;
  Points shape = points(base, random);
  if (how < 5 && wanted == Wanted::kEqual) shape[1] = shape[0];
  if (wanted != Wanted::kEqual && random.below(8) == 0) shape[random.below(2)] = shape[2];
  const Kind any_kind = static_cast<Kind>(random.below(kNumKinds));
  Disguise disguise(random);
  std::vector<Disguised> out;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    out.push_back(disguise(shape[i], kinds[i]));
    if (how == 7) replace_by_any(out.back(), any_kind, random);
  }
  if (how == 7) return out;
  const bool is_nudged = random.below(4) == 0;
  const int exponent = random.below(3) == 0 ? static_cast<int>(random.between(-1000, 900)) : 0;
  for (Disguised& d : out) {
    for (std::size_t k = 0; k < d.num_coordinates; ++k) {
      if (is_nudged) d.numbers[k] = nudged(d.numbers[k], random);
      d.numbers[k] = std::ldexp(d.numbers[k], exponent);
    }
  }
  return out;
}

}  // namespace veritope::generate
