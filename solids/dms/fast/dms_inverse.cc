// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fast/dms_inverse.h"

#include <algorithm>
#include <cmath>

#include "robust/base/check.h"
#include "robust/base/nearest_on_triangle.h"
#include "solids/dms/fast/dms_inverse_internal.h"
#include "splines/dms_spline.h"

namespace veritope {
namespace {

using internal::dot;
using internal::kInverseDone;
using internal::kInverseEdge;
using internal::minus;
using internal::times;

double size_of(const Point3d& p) {
  return std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
}

}  // namespace

DmsInverse::DmsInverse(int degree, std::size_t num_components)
    : degree_(degree),
      count_(num_tetrahedral_indices(degree)),
      components_(num_components),
      stride_(count_ * num_components) {
  for_each_tetrahedral_index(degree, [&](const TetrahedralIndex& index) {
    exponents_.push_back({index[1], index[2], index[3]});
  });
}

DmsInverse::Evaluated DmsInverse::evaluate(const double* net, const Point3d& at) const {
  double power[3][kMaxDmsDegree + 1];
  for (std::size_t k = 0; k < 3; ++k) {
    power[k][0] = 1;
    for (int i = 1; i <= degree_; ++i) power[k][i] = power[k][i - 1] * at[k];
  }
  Evaluated out{};
  for (std::size_t m = 0; m < count_; ++m) {
    const auto& [i, j, l] = exponents_[m];
    const double x = power[0][i], y = power[1][j], z = power[2][l];
    const double all = x * y * z, dx = i > 0 ? i * power[0][i - 1] * y * z : 0,
                 dy = j > 0 ? j * x * power[1][j - 1] * z : 0,
                 dz = l > 0 ? l * x * y * power[2][l - 1] : 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double b = net[c * count_ + m];
      out.value[c] += b * all;
      out.along[0][c] += b * dx, out.along[1][c] += b * dy, out.along[2][c] += b * dz;
    }
  }
  return out;
}

// Newton's method first. Where it leaves the part, steps by the derivative of the middle, each followed by a projection
// on the part: they halve the distance from the preimage in it, if there is one.
std::optional<Point3d> DmsInverse::find_in(std::size_t number, const Point3d& x) const {
  constexpr int kNewtonSteps = 8, kSteps = 64;
  const Leaf& leaf = leaves_[number];
  const double slack = kInverseEdge + leaf.noise, done = kInverseDone + leaf.noise;
  const auto is_within = [&](const Point3d& at, double distance) {
    for (std::size_t m = 0; m < 4; ++m)
      if (!(dot(leaf.normals[m], at) + leaf.heights[m] >= -distance)) return false;
    return true;
  };
  const auto projected = [&](const Point3d& at) {
    if (is_within(at, 0)) return at;
    Point3d out = leaf.corners[0];
    for (std::size_t m = 0; m < 4; ++m) {
      const Point3d on = approx_nearest_on_triangle(
          at, leaf.corners[(m + 1) % 4], leaf.corners[(m + 2) % 4], leaf.corners[(m + 3) % 4]);
      const Point3d before = minus(at, out), now = minus(at, on);
      if (dot(now, now) < dot(before, before)) out = on;
    }
    return out;
  };
  const Point3d middle{net(number)[0], net(number)[count_], net(number)[2 * count_]};
  const Point3d start = times(leaf.linear, minus(x, middle));
  if (!is_within(start, leaf.off + slack)) return std::nullopt;
  Point3d at = projected(start);
  for (int step = 0; step < kNewtonSteps; ++step) {
    const Evaluated here = evaluate(net(number), at);
    const Point3d rest = minus(x, here.value);
    if (size_of(times(leaf.linear, rest)) <= done) {
      // Beside all planes of a thin part by little one may be far from it.
      const Point3d near = projected(at);
      if (size_of(minus(near, at)) <= slack) return near;
      break;
    }
    const Point3d more = internal::solved(here.along, rest);
    for (std::size_t k = 0; k < 3; ++k) at[k] += more[k];
    if (!is_within(at, 1)) break;
  }
  at = projected(start);
  for (int step = 0; step < kSteps; ++step) {
    const Point3d rest = times(leaf.linear, minus(x, evaluate(net(number), at).value));
    if (size_of(rest) <= slack) return at;
    const Point3d next = projected({at[0] + rest[0], at[1] + rest[1], at[2] + rest[2]});
    if (size_of(minus(next, at)) <= done) break;
    at = next;
  }
  return std::nullopt;
}

std::optional<DmsInverse::Place> DmsInverse::find(const Point3d& p) const {
  std::optional<Place> out;
  const Point3d beside = minus(p, offset_),
                x{beside[0] * scale_, beside[1] * scale_, beside[2] * scale_};
  const auto holds = [&](const Box3d& b) {
    for (std::size_t c = 0; c < 3; ++c)
      if (!(x[c] >= b.lo[c] && x[c] <= b.hi[c])) return false;
    return !out;
  };
  boxes_.visit(holds, [&](std::uint32_t leaf) {
    if (const auto at = find_in(leaf, x)) out = Place{leaf, *at};
  });
  return out;
}

Point3d DmsInverse::domain_point(const Place& place, double inward) const {
  const Leaf& leaf = leaves_[place.leaf];
  Point3d out = leaf.middle;
  for (std::size_t k = 0; k < 3; ++k) out[k] += (1 - inward) * leaf.radius * place.at[k];
  return out;
}

double DmsInverse::value(const Place& place) const {
  VT_CHECK(has_component(), "a component was asked for");
  double power[3][kMaxDmsDegree + 1], out = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    power[k][0] = 1;
    for (int i = 1; i <= degree_; ++i) power[k][i] = power[k][i - 1] * place.at[k];
  }
  for (std::size_t m = 0; m < count_; ++m) {
    const auto& [i, j, l] = exponents_[m];
    out += net(place.leaf)[3 * count_ + m] * power[0][i] * power[1][j] * power[2][l];
  }
  return out;
}

}  // namespace veritope
