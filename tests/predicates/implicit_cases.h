// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/predicates/implicit_cases.h: hard cases for predicates on implicit points. Integer points that
// are exactly degenerate (on a plane, a sphere, a small grid) are disguised: written as points of another
// kind. Then all is scaled, or moved by some units in the last place; or the defining points are any.
#pragma once
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <variant>
#include <vector>

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
inline constexpr int kNumKinds3 = std::variant_size_v<Point3>,
                     kNumKinds2 = std::variant_size_v<Point2>;

/// The numbers from which a point of the kind (an index of Point3 or Point2) is made: coordinates of points,
/// then weights.
struct Definition {
  std::size_t kind = 0;
  int dimension = 3;
  std::vector<double> numbers;

  Vec3d at(std::size_t i) const { return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]}; }
  Vec2d at2(std::size_t i) const { return {numbers[2 * i], numbers[2 * i + 1]}; }
  /// How many are coordinates.
  std::size_t num_coordinates() const {
    constexpr std::size_t kOf3[] = {3, 6, 9, 15, 27, 15, 27}, kOf2[] = {2, 4, 8};
    return dimension == 3 ? kOf3[kind] : kOf2[kind];
  }
  std::string text() const {
    std::string out = (dimension == 3 ? "3d kind " : "2d kind ") + std::to_string(kind) + ":";
    for (const double v : numbers) {
      char buffer[32];
      std::snprintf(buffer, sizeof buffer, " %a", v);
      out += buffer;
    }
    return out + "; ";
  }
};

inline Point3 make3(const Definition& d) {
  const auto weight = [&](std::size_t i) { return d.numbers[d.num_coordinates() + i]; };
  const auto line = [&] { return LinePlanePoint(d.at(0), d.at(1), d.at(2), d.at(3), d.at(4)); };
  const auto planes = [&] {
    return ThreePlanePoint(
        {d.at(0), d.at(1), d.at(2), d.at(3), d.at(4), d.at(5), d.at(6), d.at(7), d.at(8)});
  };
  switch (d.kind) {
    case 0: return d.at(0);
    case 1: return SegmentPoint(d.at(0), d.at(1), weight(0), weight(1));
    case 2: return TrianglePoint(d.at(0), d.at(1), d.at(2), weight(0), weight(1), weight(2));
    case 3: return line();
    case 4: return planes();
    case 5: return CachedPoint(line());
    default: return CachedPoint(planes());
  }
}
inline Point2 make2(const Definition& d) {
  if (d.kind == 0) return d.at2(0);
  if (d.kind == 1) return SegmentPoint2d(d.at2(0), d.at2(1), d.numbers[4], d.numbers[5]);
  return SegmentSegmentPoint2d(d.at2(0), d.at2(1), d.at2(2), d.at2(3));
}

class Disguise {
 public:
  Disguise(Random& random, int dimension) : random_(random), dimension_(dimension) {}

  /// The point as one of the kind. REQUIRES integers below 2^48.
  Definition operator()(const Vec3d& p, std::size_t kind) {
    Definition d{kind, dimension_, {}};
    const auto put = [&](const Vec3d& v) {
      for (int axis = 0; axis < dimension_; ++axis) d.numbers.push_back(v[axis]);
    };
    const auto put_line = [&] {
      const Vec3d u = vector();
      put(moved(p, -factor(), u)), put(moved(p, factor(), u));
    };
    const auto put_plane = [&] {
      const Vec3d v = vector(), w = vector();
      const double i = factor(), j = factor(), k = factor();
      put(moved(moved(p, i, v), j, w)), put(moved(moved(p, -k, v), j, w));
      put(moved(moved(p, i, v), -k, w));
    };
    if (kind == 0) {
      put(p);
    } else if (kind == 1) {
      const Vec3d u = vector();
      const double k = factor(), m = factor(), sign = random_.below(2) == 0 ? 1 : -1;
      put(moved(p, -k, u)), put(moved(p, m, u));
      d.numbers.insert(d.numbers.end(), {sign * k, sign * (k + m)});
    } else if (dimension_ == 2) {
      put_line(), put_line();
    } else if (kind == 2) {
      const Vec3d v = vector(), w = vector();
      const double i = factor(), j = factor(), r = factor(), s = factor();
      const Vec3d a = moved(moved(p, -i, v), -j, w);
      put(a), put(moved(a, r, v)), put(moved(a, s, w));
      d.numbers.insert(d.numbers.end(), {i * s, j * r, r * s});
    } else if (kind == 3 || kind == 5) {
      put_line(), put_plane();
    } else {
      put_plane(), put_plane(), put_plane();
    }
    return d;
  }

 private:
  static Vec3d moved(const Vec3d& p, double t, const Vec3d& u) {
    return {p.x + t * u.x, p.y + t * u.y, p.z + t * u.z};
  }
  Vec3d vector() {
    const auto draw = [&] { return static_cast<double>(random_.between(-range_, range_)); };
    return {draw(), draw(), draw()};
  }
  double factor() { return static_cast<double>(random_.between(1, 3)); }

  Random& random_;
  int dimension_;
  std::int64_t range_ = 1 << random_.between(2, 12);
};

/// Five definitions of points of random kinds (the first always explicit every third time).
inline std::array<Definition, 5> implicit_case(Random& random, int dimension) {
  std::array<Definition, 5> out;
  const std::uint64_t num_kinds = dimension == 3 ? kNumKinds3 : kNumKinds2;
  const std::uint64_t how = random.below(8);
  const Kind base = how < 3 ? Kind::kFlat : (how < 5 ? Kind::kRound : Kind::kSmallGrid);
  const Points shape = points(base, random);
  Disguise disguise(random, dimension);
  const Kind raw = static_cast<Kind>(random.below(kNumKinds));
  for (std::size_t i = 0; i < 5; ++i) {
    const std::size_t kind = random.below(3) == 0 ? 0 : random.below(num_kinds);
    out[i] = disguise(shape[i], kind);
    if (how != 7) continue;
    for (std::size_t k = 0; k < out[i].num_coordinates();
         k += static_cast<std::size_t>(dimension)) {
      const Points any = points(raw, random);
      for (int axis = 0; axis < dimension; ++axis)
        out[i].numbers[k + static_cast<std::size_t>(axis)] = any[k % 5][axis];
    }
    for (std::size_t k = out[i].num_coordinates(); k < out[i].numbers.size(); ++k)
      out[i].numbers[k] = points(raw, random)[0].x;
  }
  const bool is_scaled = random.below(3) == 0, is_nudged = how < 7 && random.below(4) == 0;
  const int exponent = is_scaled ? static_cast<int>(random.between(-1000, 900)) : 0;
  for (Definition& d : out) {
    for (std::size_t k = 0; how < 7 && k < d.num_coordinates(); ++k) {
      if (is_nudged) d.numbers[k] = nudged(d.numbers[k], random);
      d.numbers[k] = std::ldexp(d.numbers[k], exponent);
    }
  }
  return out;
}

}  // namespace veritope::generate
