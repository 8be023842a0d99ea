// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/lattice_session.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <utility>

#include "predicates/fixed_formulas.h"
#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "robust/base/check.h"
#include "robust/binary64.h"

namespace veritope {
namespace internal {
namespace {

// An axis of a model: the unit is 2^unit, no difference is greater than 2^bits units.
struct Axis {
  bool is_constant = true;
  int unit = 0, bits = 0;
};

// Splits v so that its mantissa is odd, or 0.
Binary64 reduced(double v) {
  Binary64 part = split(v);
  if (part.mantissa == 0) return part;
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(part.mantissa));
  return {part.mantissa >> zeros, part.exponent + zeros};
}

// Sets vertices[i][k] to coordinate(i), i < n, as integers; their unit is the lowest bit that is set in any of them.
// Returns false if one of them reaches 2^62 units: it differs by more than 2^61 from the one that has the lowest bit,
// which is less than 2^53; and that difference is odd.
template <std::size_t Dim, typename Coordinate>
bool in_lowest_bits(LatticeModel<Dim>& model, std::size_t k, int& unit, Coordinate coordinate) {
  constexpr int kNone = 1 << 20;
  unit = kNone;
  for (std::size_t i = 0; i < model.vertices.size(); ++i) {
    if (!is_finite(coordinate(i))) return false;
    const Binary64 part = reduced(coordinate(i));
    if (part.mantissa != 0) unit = std::min(unit, part.exponent);
  }
  for (std::size_t i = 0; i < model.vertices.size(); ++i) {
    const Binary64 part = reduced(coordinate(i));
    if (part.mantissa == 0) continue;
    const auto size = static_cast<std::uint64_t>(std::abs(part.mantissa));
    if (static_cast<int>(std::bit_width(size)) + (part.exponent - unit) > 62) return false;
    model.vertices[i][k] = part.mantissa << (part.exponent - unit);
  }
  return true;
}

// Moves the first vertex to 0 and divides by the power of two that all vertices then share. Returns false if a
// difference is greater than 2^61.
template <std::size_t Dim>
bool from_first_vertex(LatticeModel<Dim>& model, std::size_t k, Axis& axis) {
  if (model.vertices.empty()) return true;
  const std::int64_t first = model.vertices[0][k];
  std::int64_t least = 0, most = 0;
  std::uint64_t any = 0;
  for (auto& v : model.vertices) {
    v[k] -= first;  // both are below 2^62
    least = std::min(least, v[k]), most = std::max(most, v[k]);
    any |= static_cast<std::uint64_t>(v[k]);
  }
  if (any == 0) return true;
  const int zeros = std::countr_zero(any);
  for (auto& v : model.vertices) v[k] >>= zeros;
  const std::uint64_t spread = static_cast<std::uint64_t>(most - least) >> zeros;
  axis = {false, axis.unit + zeros, static_cast<int>(std::bit_width(spread - 1))};
  return axis.bits <= OneLimb::kBudget.diff;
}

LatticeSpan span_of(int bits) {
  if (bits <= Tiny::kBudget.diff) return LatticeSpan::kTiny;
  if (bits <= Short::kBudget.diff) return LatticeSpan::kShort;
  return bits <= OneLimb::kBudget.diff ? LatticeSpan::kOneLimb : LatticeSpan::kTooWide;
}

// coordinate(i, k) of vertex i on axis k.
template <std::size_t Dim, typename Coordinate>
std::optional<LatticeModel<Dim>> lattice_model(std::size_t n, Coordinate coordinate) {
  LatticeModel<Dim> model;
  model.vertices.resize(n);
  std::array<Axis, Dim> axes;
  int unit = 1 << 20, own = 0, common = 0;
  for (std::size_t k = 0; k < Dim; ++k) {
    if (!in_lowest_bits(model, k, axes[k].unit, [&](std::size_t i) { return coordinate(i, k); }) ||
        !from_first_vertex(model, k, axes[k])) {
      return std::nullopt;
    }
    own = std::max(own, axes[k].bits);
    if (!axes[k].is_constant) unit = std::min(unit, axes[k].unit);
  }
  for (std::size_t k = 0; k < Dim; ++k) {
    if (axes[k].is_constant) continue;
    model.shift[k] = axes[k].unit - unit;
    common = std::max(common, axes[k].bits + model.shift[k]);
  }
  model.own = span_of(own);
  model.common = span_of(common);
  return model;
}

template <typename W, typename Point>
Sign orient2d_of(const Point& a, const Point& b, const Point& c) {
  return orient2d_fixed<W>({b[0] - a[0], c[0] - a[0]}, {b[1] - a[1], c[1] - a[1]});
}

template <typename W, typename Point>
Sign orient3d_of(const Point& a, const Point& b, const Point& c, const Point& d) {
  return orient3d_fixed<W>({b[0] - a[0], c[0] - a[0], d[0] - a[0]},
                           {b[1] - a[1], c[1] - a[1], d[1] - a[1]},
                           {b[2] - a[2], c[2] - a[2], d[2] - a[2]});
}

// The first points minus the last one, all axes in one unit, as the lifted determinants take them.
template <std::size_t Dim, typename... Points>
[[gnu::always_inline]] inline auto differences(const LatticeModel<Dim>& model,
                                               const std::array<std::int64_t, Dim>& last,
                                               const Points&... points) {
  std::array<std::int64_t, Dim * sizeof...(Points)> d;
  std::size_t i = 0;
  const auto add = [&](const auto& p) VT_TIER {
    VT_UNROLL for (std::size_t k = 0; k < Dim; ++k) d[i++] = (p[k] - last[k]) << model.shift[k];
  };
  (add(points), ...);
  return d;
}

}  // namespace
}  // namespace internal

using internal::LatticeSpan;
using internal::OneLimb;
using internal::OneLimbCircle;
using internal::Short;
using internal::ShortCircle;
using internal::Tiny;

std::optional<LatticeSession2d> LatticeSession2d::of(const Vec2d* points, std::size_t n) {
  auto model = internal::lattice_model<2>(
      n, [&](std::size_t i, std::size_t k) { return k == 0 ? points[i].x : points[i].y; });
  if (!model) return std::nullopt;
  LatticeSession2d session;
  session.model_ = std::move(*model);
  if (session.model_.common > LatticeSpan::kShort) session.points_.assign(points, points + n);
  return session;
}

std::optional<LatticeSession3d> LatticeSession3d::of(const Vec3d* points, std::size_t n) {
  auto model = internal::lattice_model<3>(n, [&](std::size_t i, std::size_t k) {
    const Vec3d& p = points[i];
    return k == 0 ? p.x : (k == 1 ? p.y : p.z);
  });
  if (!model) return std::nullopt;
  LatticeSession3d session;
  session.model_ = std::move(*model);
  if (session.model_.common > LatticeSpan::kTiny) session.points_.assign(points, points + n);
  return session;
}

// An axis in its own units is never wider than in the common one: where `own` needs the filter's
// points, they are kept.

Sign LatticeSession2d::orient2d(std::size_t a, std::size_t b, std::size_t c,
                                TierCounts* tally) const {
  VT_SLOW_CHECK(a < size() && b < size() && c < size(), "no such vertex");
  const auto& v = model_.vertices;
  if (model_.own <= LatticeSpan::kShort) {
    return cascade<1>(tally,
                      [&]() VT_TIER { return internal::orient2d_of<Short>(v[a], v[b], v[c]); });
  }
  return cascade(
      tally, [&]() VT_TIER { return orient2d_filter(points_[a], points_[b], points_[c]); },
      [&]() { return internal::orient2d_of<OneLimb>(v[a], v[b], v[c]); });
}

Sign LatticeSession2d::in_circle(std::size_t a, std::size_t b, std::size_t c, std::size_t d,
                                 TierCounts* tally) const {
  VT_SLOW_CHECK(a < size() && b < size() && c < size() && d < size(), "no such vertex");
  const auto& v = model_.vertices;
  const auto from_d = [&]()
                          VT_TIER { return internal::differences(model_, v[d], v[a], v[b], v[c]); };
  switch (model_.common) {
    case LatticeSpan::kTiny:
      return cascade<1>(tally, [&]() VT_TIER { return internal::in_circle_fixed<Tiny>(from_d()); });
    case LatticeSpan::kShort:
      return cascade<1>(tally,
                        [&]() VT_TIER { return internal::in_circle_fixed<ShortCircle>(from_d()); });
    default:
      VT_CHECK(has_circles(), "in_circle of a model whose axes fit no lattice in common");
      return cascade(
          tally,
          [&]()
              VT_TIER { return in_circle_filter(points_[a], points_[b], points_[c], points_[d]); },
          [&]() { return internal::in_circle_fixed<OneLimbCircle>(from_d()); });
  }
}

Sign LatticeSession3d::orient3d(std::size_t a, std::size_t b, std::size_t c, std::size_t d,
                                TierCounts* tally) const {
  VT_SLOW_CHECK(a < size() && b < size() && c < size() && d < size(), "no such vertex");
  const auto& v = model_.vertices;
  switch (model_.own) {
    case LatticeSpan::kTiny:
      return cascade<1>(
          tally, [&]() VT_TIER { return internal::orient3d_of<Tiny>(v[a], v[b], v[c], v[d]); });
    case LatticeSpan::kShort:
      return cascade<1>(
          tally, [&]() VT_TIER { return internal::orient3d_of<Short>(v[a], v[b], v[c], v[d]); });
    default:
      return cascade(
          tally,
          [&]() VT_TIER { return orient3d_filter(points_[a], points_[b], points_[c], points_[d]); },
          [&]() { return internal::orient3d_of<OneLimb>(v[a], v[b], v[c], v[d]); });
  }
}

Sign LatticeSession3d::in_sphere(std::size_t a, std::size_t b, std::size_t c, std::size_t d,
                                 std::size_t e, TierCounts* tally) const {
  VT_SLOW_CHECK(a < size() && b < size() && c < size() && d < size() && e < size(),
                "no such vertex");
  const auto& v = model_.vertices;
  const auto from_e = [&]() VT_TIER {
    return internal::differences(model_, v[e], v[a], v[b], v[c], v[d]);
  };
  const auto filter = [&]() VT_TIER {
    return in_sphere_filter(points_[a], points_[b], points_[c], points_[d], points_[e]);
  };
  switch (model_.common) {
    case LatticeSpan::kTiny:
      return cascade<1>(tally, [&]() VT_TIER { return internal::in_sphere_fixed<Tiny>(from_e()); });
    case LatticeSpan::kShort:
      return cascade(tally, filter, [&]() { return internal::in_sphere_fixed<Short>(from_e()); });
    default:
      VT_CHECK(has_spheres(), "in_sphere of a model whose axes fit no lattice in common");
      return cascade(tally, filter, [&]() { return internal::in_sphere_fixed<OneLimb>(from_e()); });
  }
}

}  // namespace veritope
