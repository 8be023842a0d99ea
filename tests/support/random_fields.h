// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/random_fields.h: random cages that are known to be regular, fields of directions sampled from their w
// lines, and the angles between a field and the w lines of a cage, by the splines of splines/ alone.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "robust/base/random.h"
#include "solids/micro/cage/fit_cage.h"
#include "solids/vmodel/jacobian_sign.h"
#include "solids/vmodel/v_model.h"
#include "splines/bspline_derivative.h"
#include "splines/convert.h"
#include "splines/de_boor.h"

namespace veritope::random_fields {

using Map = BSplineVolume<double>;
using Place = std::array<double, 3>;

inline double inner(const Point3d& a, const Point3d& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point3d product(const Point3d& a, const Point3d& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// The angle between two axes in degrees, from 0 to 90.
inline double angle(const Point3d& a, const Point3d& b) {
  const Point3d c = product(a, b);
  return std::atan2(std::sqrt(inner(c, c)), std::abs(inner(a, b))) * 57.29577951308232;
}
inline double uniform(Random& random, double low, double high) {
  return low + (high - low) * random.unit();
}
/// Near to a normal distribution of variance 1: a sum of twelve.
inline double normal(Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.unit();
  return sum;
}
/// A matrix of rotation: a random quaternion of unit length.
inline std::array<Point3d, 3> rotation(Random& random) {
  std::array<double, 4> q;
  double size = 0;
  while (size < 0.1) {
    size = 0;
    for (double& x : q) {
      x = normal(random);
      size += x * x;
    }
  }
  for (double& x : q) x /= std::sqrt(size);
  const auto [a, b, c, d] = q;
  return {{{1 - 2 * (c * c + d * d), 2 * (b * c - a * d), 2 * (b * d + a * c)},
           {2 * (b * c + a * d), 1 - 2 * (b * b + d * d), 2 * (c * d - a * b)},
           {2 * (b * d - a * c), 2 * (c * d + a * b), 1 - 2 * (b * b + c * c)}}};
}

/// How a box is deformed.
struct Deformation {
  Point3d sides{1, 1, 1};
  double bend = 0;    ///< degrees that the w lines turn through
  double toward = 0;  ///< degrees: the direction across w in which they bend
  double twist = 0;   ///< degrees, from one end to the other
  double taper = 0;   ///< the sides across w grow by this part
  double shake = 0;   ///< of the distance of control points
};

inline Point3d deformed(const Deformation& d, Point3d p) {
  constexpr double kDegree = 0.017453292519943295;
  const double w = p[2] / d.sides[2];  // from -1/2 to 1/2
  const double grow = 1 + d.taper * w;
  p[0] *= grow;
  p[1] *= grow;
  const auto turn = [&](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    p = {c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
  };
  turn(d.twist * kDegree * w);
  if (std::abs(d.bend) < 1e-9) return p;
  turn(-d.toward * kDegree);
  const double bend = d.bend * kDegree, radius = d.sides[2] / bend, at = bend * w;
  p = {radius - (radius - p[0]) * std::cos(at), p[1], (radius - p[0]) * std::sin(at)};
  turn(d.toward * kDegree);
  return p;
}

/// A cell whose determinant is proved positive, in any position; control points are multiples of 2^-20.
inline CellVolume known_cage(Random& random, const CageGrid& grid, const Deformation& d) {
  for (;;) {
    const CageBox box{{Rational(-1), Rational(-1), Rational(-1)},
                      {Rational(1), Rational(1), Rational(1)}};
    const CellVolume unit = box_cage(box, grid).value();
    const std::size_t n = unit.grid().count();
    const auto turn = rotation(random);
    const double size = uniform(random, 0.5, 8);
    const Point3d shift = {uniform(random, -20, 20), uniform(random, -20, 20),
                           uniform(random, -20, 20)};
    std::vector<Rational> all(3 * n);
    for (std::size_t i = 0; i < n; ++i) {
      Point3d p;
      for (std::size_t k = 0; k < 3; ++k) {
        const double step = d.sides[k] / static_cast<double>(unit.grid().size[k] - 1);
        p[k] = 0.5 * d.sides[k] * nearest_double(unit.coefficients()[k * n + i]) +
               d.shake * step * uniform(random, -1, 1);
      }
      p = deformed(d, p);
      for (std::size_t k = 0; k < 3; ++k)
        all[k * n + i] = Rational::from_double(
            std::nearbyint((size * inner(turn[k], p) + shift[k]) * 0x1p20) * 0x1p-20);
    }
    CellVolume cell(unit.axes(), 3, false, std::move(all));
    const auto model = make_v_model({cell}, VOrientation::kKeep);
    if (model && decide_determinants(*model).is_proved()) return cell;
  }
}

inline Deformation random_deformation(Random& random) {
  Deformation d;
  d.sides = {uniform(random, 0.7, 1.4), uniform(random, 0.7, 1.4), uniform(random, 1, 2.5)};
  d.bend = uniform(random, -90, 90);
  // No tighter than twice the width.
  const double most = 0.5 * 57.3 * d.sides[2] / std::max(d.sides[0], d.sides[1]);
  d.bend = std::clamp(d.bend, -most, most);
  d.toward = uniform(random, 0, 360);
  d.twist = uniform(random, -60, 60);
  d.taper = uniform(random, -0.5, 0.5);
  d.shake = uniform(random, 0, 0.2);
  return d;
}
inline CellVolume random_cage(Random& random) {
  CageGrid grid;
  for (std::size_t k = 0; k < 3; ++k) {
    grid.degrees[k] = static_cast<int>(random.between(2, 3));
    grid.spans[k] = static_cast<std::uint64_t>(random.between(1, 3));
  }
  return known_cage(random, grid, random_deformation(random));
}

/// A map and its derivatives.
class Sampler {
 public:
  explicit Sampler(const CellVolume& cell)
      : map_(nearest_double(cell).value()),
        slopes_{derivative(map_, 0), derivative(map_, 1), derivative(map_, 2)} {}

  Point3d at(const Place& place) const { return value(map_, place); }
  Point3d along(std::size_t axis, const Place& place) const { return value(slopes_[axis], place); }
  double begin(std::size_t k) const { return map_.axis(k).domain_begin(); }
  double end(std::size_t k) const { return map_.axis(k).domain_end(); }

  /// The parameters of p by Newton's iteration from some of the domain.
  std::optional<Place> find(const Point3d& p) const {
    for (int start = 0; start < 27; ++start) {
      Place place;
      for (std::size_t k = 0, n = static_cast<std::size_t>(start); k < 3; ++k, n /= 3) {
        constexpr std::array<double, 3> kParts = {0.5, 0.15, 0.85};
        place[k] = begin(k) + kParts[n % 3] * (end(k) - begin(k));
      }
      if (newton(p, place)) return place;
    }
    return std::nullopt;
  }

 private:
  static Point3d value(const Map& map, const Place& place) {
    const auto p = evaluate(map, place).value();
    return {p[0], p[1], p[2]};
  }
  bool newton(const Point3d& p, Place& place) const {
    for (int step = 0; step < 60; ++step) {
      const Point3d here = at(place), u = along(0, place), v = along(1, place), w = along(2, place);
      const Point3d off = {p[0] - here[0], p[1] - here[1], p[2] - here[2]};
      const double det = inner(u, product(v, w));
      const Point3d move = {inner(off, product(v, w)) / det, inner(off, product(w, u)) / det,
                            inner(off, product(u, v)) / det};
      double change = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double to = std::clamp(place[k] + move[k], begin(k), end(k));
        change = std::max(change, std::abs(to - place[k]));
        place[k] = to;
      }
      if (change > 1e-11) continue;
      return std::sqrt(inner(off, off)) < 1e-7 * (1 + std::sqrt(inner(p, p)));
    }
    return false;
  }

  Map map_;
  std::array<Map, 3> slopes_;
};

struct Sample {
  DirectionField field;
  std::vector<Point3d> truth;  ///< the directions without noise
};
/// Points at uniform parameters of the cage with the directions of its w lines, of random lengths and signs. Each
/// coordinate of a direction of length 1 is off by `noise` times a normal number.
inline Sample sample(Random& random, const CellVolume& cage, std::size_t count, double noise) {
  const Sampler sampler(cage);
  Sample out;
  for (std::size_t i = 0; i < count; ++i) {
    Place place;
    for (std::size_t k = 0; k < 3; ++k)
      place[k] = uniform(random, sampler.begin(k), sampler.end(k));
    Point3d d = sampler.along(2, place);
    out.truth.push_back(d);
    const double length = std::sqrt(inner(d, d));
    const double scale = (random.below(2) == 0 ? 1 : -1) * uniform(random, 0.1, 10);
    for (double& x : d) x = scale * (x / length + noise * normal(random));
    out.field.points.push_back(sampler.at(place));
    out.field.axes.push_back(d);
  }
  return out;
}

/// The angles between axes and the w lines of a cage at points; 90 where a point is not found in it.
inline std::vector<double> angles(const CellVolume& cage, const std::vector<Point3d>& points,
                                  const std::vector<Point3d>& axes) {
  const Sampler sampler(cage);
  std::vector<double> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto place = sampler.find(points[i]);
    out.push_back(place ? angle(sampler.along(2, *place), axes[i]) : 90);
  }
  return out;
}
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace veritope::random_fields
