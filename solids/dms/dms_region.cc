// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_region.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace veritope {
namespace {

constexpr std::size_t kAxisBits = 6;

DmsPoint normal_of(const DmsPoint& a, const DmsPoint& b, const DmsPoint& c) {
  return cross_product(difference(b, a), difference(c, a));
}
DmsPlane plane_through(const DmsPoint& a, const DmsPoint& b, const DmsPoint& c) {
  DmsPlane plane{normal_of(a, b, c), {}};
  plane.number = dot_product(plane.vector, a);
  return plane;
}
bool is_zero(const DmsPoint& v) {
  return std::all_of(v.begin(), v.end(), [](const Rational& x) { return x.sign() == Sign::kZero; });
}
bool is_less(const Rational& a, double rounded_a, const Rational& b, double rounded_b) {
  if (rounded_a < rounded_b) return true;  // nearest doubles never are in the wrong order
  return !(rounded_a > rounded_b) && a < b;
}
int sign_as_int(const Rational& x) { return static_cast<int>(x.sign()); }

}  // namespace

int side_of_plane(std::span<const DmsPoint> corners, const DmsPlane& plane) {
  int found = 0;
  for (const DmsPoint& p : corners) {
    const int sign = sign_as_int(dot_product(plane.vector, p) - plane.number);
    if (sign * found < 0) return 0;
    if (sign != 0) found = sign;
  }
  return found;
}

std::vector<DmsPlane> face_planes(std::span<const DmsPoint> corners) {
  return {plane_through(corners[1], corners[2], corners[3]),
          plane_through(corners[0], corners[2], corners[3]),
          plane_through(corners[0], corners[1], corners[3]),
          plane_through(corners[0], corners[1], corners[2])};
}

std::vector<DmsPlane> upright_planes(std::span<const DmsPoint> corners) {
  const DmsPoint normal = normal_of(corners[0], corners[1], corners[2]);
  std::vector<DmsPlane> out;
  for (std::size_t i = 0; i < 3; ++i) {
    DmsPlane plane{cross_product(normal, difference(corners[(i + 1) % 3], corners[i])), {}};
    plane.number = dot_product(plane.vector, corners[i]);
    out.push_back(std::move(plane));
  }
  return out;
}

DmsRegion::Wall DmsRegion::wall_of(DmsPlane plane) {
  Wall out;
  for (std::size_t c = 0; c < 3; ++c) out.rounded[c] = bounded_double(plane.vector[c]);
  out.rounded[3] = bounded_double(plane.number);
  out.plane = std::move(plane);
  return out;
}

// Bound: of the seven roundings of a term, of its factors and of the sum, none is above u = 2^-53 of a term, in any
// rounding mode 2 u; so the error is below 14 u S, S the sum of the terms' sizes, and 2^-49 S pays for rounding S, too,
// and, while S >= 2^-900 and all numbers are at most 2^100, for underflow. NaN makes both comparisons false.
Sign DmsRegion::Wall::side_of(const DmsPoint& p, const std::array<double, 3>& rounded_p) const {
  const double x = rounded[0] * rounded_p[0], y = rounded[1] * rounded_p[1],
               z = rounded[2] * rounded_p[2], height = x + y + z - rounded[3],
               size = std::abs(x) + std::abs(y) + std::abs(z) + std::abs(rounded[3]);
  if (size >= 0x1p-900) {
    if (height > 0x1p-49 * size) return Sign::kPositive;
    if (height < -0x1p-49 * size) return Sign::kNegative;
  }
  return (dot_product(plane.vector, p) - plane.number).sign();
}

DmsRegion::DmsRegion(const DmsKnotTable& knots, std::vector<DmsPoint> corners,
                     const std::vector<DmsPlane>& planes)
    : knots_(knots), corners_(std::move(corners)), is_triangle_(corners_.size() == 3) {
  if (is_triangle_) base_ = wall_of(plane_through(corners_[0], corners_[1], corners_[2]));
  low_ = high_ = corners_[0];
  for (const DmsPoint& p : corners_) {
    rounded_corners_.push_back(bounded_doubles(p));
    for (std::size_t c = 0; c < 3; ++c) {
      low_[c] = std::min(low_[c], p[c]);
      high_[c] = std::max(high_[c], p[c]);
    }
  }
  rounded_low_ = bounded_doubles(low_);
  rounded_high_ = bounded_doubles(high_);
  for (const DmsPlane& plane : planes) {
    if (walls_.size() == kMaxPlanes) break;
    Wall wall = wall_of(plane);
    const int side = side_of(wall);
    if (side == 0) continue;
    if (side < 0) {
      for (Rational& x : wall.plane.vector) x.negate();
      wall.plane.number.negate();
      for (double& x : wall.rounded) x = -x;
    }
    walls_.push_back(std::move(wall));
  }
}

int DmsRegion::side_of(const Wall& wall) const {
  int found = 0;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const int sign = static_cast<int>(wall.side_of(corners_[i], rounded_corners_[i]));
    if (sign * found < 0) return 0;
    if (sign != 0) found = sign;
  }
  return found;
}

const DmsRegion::Place& DmsRegion::place(std::uint32_t knot) {
  const auto [found, is_new] = places_.try_emplace(knot);
  if (!is_new) return found->second;
  Place& out = found->second;
  const DmsPoint& p = knots_.point(knot);
  const std::array<double, 3>& r = knots_.rounded(knot);
  const auto set = [&](std::size_t bit, bool value) { out.sides |= std::uint64_t{value} << bit; };
  for (std::size_t c = 0; c < 3; ++c) {
    const bool is_flat = low_[c] == high_[c];
    const bool is_below = is_less(p[c], r[c], low_[c], rounded_low_[c]),
               is_above = is_less(high_[c], rounded_high_[c], p[c], r[c]);
    set(2 * c, is_below || (!is_flat && p[c] == low_[c]));
    set(2 * c + 1, is_above || (!is_flat && p[c] == high_[c]));
  }
  for (std::size_t i = 0; i < walls_.size(); ++i)
    set(kAxisBits + i, walls_[i].side_of(p, r) != Sign::kPositive);
  if (is_triangle_) out.height = static_cast<int>(base_.side_of(p, r));
  return out;
}

bool DmsRegion::misses(std::span<const std::uint32_t> knots) {
  bool is_above = false, is_below = false;
  for (const std::uint32_t k : knots) {
    is_above |= place(k).height > 0;
    is_below |= place(k).height < 0;
  }
  const bool only_in_plane = is_triangle_ && !(is_above && is_below);
  std::uint64_t sides = ~std::uint64_t{0};
  for (const std::uint32_t k : knots)
    if (!only_in_plane || place(k).height == 0) sides &= place(k).sides;
  return sides != 0;
}

bool DmsRegion::misses_triangle(const std::array<std::uint32_t, 3>& knots) {
  return misses(knots) ||
         side_of(wall_of(plane_through(knots_.point(knots[0]), knots_.point(knots[1]),
                                       knots_.point(knots[2])))) != 0;
}

std::vector<DmsSupport> DmsRegion::supports() {
  std::vector<DmsSupport> out;
  for (const std::uint32_t t : knots_.near(box_around(corners_)))
    for (const TetrahedralIndex& gamma : knots_.gammas()) {
      const DmsSupport support{t, gamma};
      if (!misses(knots_.knots(support))) out.push_back(support);
    }
  return out;
}

// visit(three) says whether to go on; false if it was not.
template <typename Visit>
bool DmsRegion::visit_cuts(std::span<const DmsSupport> supports, Visit visit) {
  std::set<std::array<std::uint32_t, 3>> seen;
  for (const DmsSupport& support : supports) {
    std::vector<std::uint32_t> k = knots_.knots(support);
    std::sort(k.begin(), k.end());
    for (std::size_t a = 0; a < k.size(); ++a)
      for (std::size_t b = a + 1; b < k.size(); ++b)
        for (std::size_t c = b + 1; c < k.size(); ++c) {
          const std::array<std::uint32_t, 3> three = {k[a], k[b], k[c]};
          if (is_triangle_ && place(three[0]).height == 0 && place(three[1]).height == 0 &&
              place(three[2]).height == 0)
            continue;
          if (misses(three) || !seen.insert(three).second) continue;
          if (is_zero(normal_of(knots_.point(three[0]), knots_.point(three[1]),
                                knots_.point(three[2]))))
            continue;
          if (!misses_triangle(three) && !visit(three)) return false;
        }
  }
  return true;
}

std::optional<std::array<std::uint32_t, 3>> DmsRegion::find_cut(
    std::span<const DmsSupport> supports) {
  std::optional<std::array<std::uint32_t, 3>> found;
  visit_cuts(supports, [&](const auto& three) {
    found = three;
    return false;
  });
  return found;
}

std::vector<std::array<std::uint32_t, 3>> DmsRegion::find_cuts(
    std::span<const DmsSupport> supports) {
  std::vector<std::array<std::uint32_t, 3>> found;
  visit_cuts(supports, [&](const auto& three) {
    found.push_back(three);
    return true;
  });
  return found;
}

}  // namespace veritope
