// SPDX-License-Identifier: LGPL-3.0-or-later
// Solids whose points and boxes are decided by rational arithmetic of the test's own, for the tests of ray casting.
#pragma once
#include <functional>
#include <utility>

#include "render/solid_probe.h"

namespace veritope::picture_test {

/// x^2 + y^2 + z^2 <= r^2.
class BallProbe : public SolidProbe {
 public:
  explicit BallProbe(Rational radius) : square_(radius * radius) {}

  PointWord word(const ExactPoint& p) const override {
    const Rational distance = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    if (distance == square_) return PointWord::kOn;
    return distance < square_ ? PointWord::kIn : PointWord::kOut;
  }
  PointWord word(const Vec3d& p) const override {
    const double near = nearest_double(square_), gap = p.x * p.x + p.y * p.y + p.z * p.z - near;
    if (gap > 0x1p-40 * near) return PointWord::kOut;  // rounding errors are at most 2^-50 of both
    if (gap < -0x1p-40 * near) return PointWord::kIn;
    return word(ExactPoint{Rational::from_double(p.x), Rational::from_double(p.y),
                           Rational::from_double(p.z)});
  }
  Value3 value(const Box3d& box) const override {
    Rational least, most;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational a = Rational::from_double(box.lo[k]), b = Rational::from_double(box.hi[k]);
      const Rational a2 = a * a, b2 = b * b;
      most += a2 < b2 ? b2 : a2;
      if (!(a <= Rational(0) && Rational(0) <= b)) least += a2 < b2 ? a2 : b2;
    }
    if (most < square_) return Value3::kOne;
    return square_ < least ? Value3::kZero : Value3::kMixed;
  }
  bool has_own_walls() const override { return true; }

 private:
  Rational square_;
};

/// lo <= x <= hi, where x is one of the coordinates.
class SlabProbe : public SolidProbe {
 public:
  SlabProbe(std::size_t axis, double lo, double hi) : axis_(axis), lo_(lo), hi_(hi) {}
  PointWord word(const Vec3d& p) const override { return word_at(to_point(p)[axis_]); }
  PointWord word(const ExactPoint& p) const override {
    const Rational lo = Rational::from_double(lo_), hi = Rational::from_double(hi_);
    if (p[axis_] == lo || p[axis_] == hi) return PointWord::kOn;
    return lo < p[axis_] && p[axis_] < hi ? PointWord::kIn : PointWord::kOut;
  }
  Value3 value(const Box3d& box) const override {
    if (box.hi[axis_] < lo_ || hi_ < box.lo[axis_]) return Value3::kZero;
    return lo_ < box.lo[axis_] && box.hi[axis_] < hi_ ? Value3::kOne : Value3::kMixed;
  }
  bool has_own_walls() const override { return true; }

 private:
  PointWord word_at(double x) const {
    if (x == lo_ || x == hi_) return PointWord::kOn;
    return lo_ < x && x < hi_ ? PointWord::kIn : PointWord::kOut;
  }
  std::size_t axis_;
  double lo_, hi_;
};

/// A probe whose boxes are mixed near a wall that it does not have: the plane where a coordinate is `at`.
class FalseWallProbe : public SlabProbe {
 public:
  FalseWallProbe(std::size_t axis, double at) : SlabProbe(axis, at, at) {}
  PointWord word(const Vec3d&) const override { return PointWord::kOut; }
  bool has_own_walls() const override { return false; }
};

}  // namespace veritope::picture_test
