// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/implicit_predicates.h"

#include <algorithm>
#include <array>

#include "predicates/implicit_cache.h"
#include "predicates/implicit_exact.h"
#include "predicates/implicit_homogeneous.h"
#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/projection.h"
#include "robust/base/check.h"

namespace veritope {
namespace {

using formulas::Place;
using formulas::Triple;
using formulas::Vector;

void check_defined(bool is_defined) { VT_CHECK(is_defined, "a point that is not defined"); }

// ---- Points as places over a ring ------------------------------------------------------------------

template <typename T>
Place<T> explicit_place(const Vec3d& p) {
  Place<T> r;
  r.exponent = internal::to_numbers<>(std::array<double, 3>{p.x, p.y, p.z}, r.base);
  return r;
}
template <typename T>
Place<T> explicit_place(const Vec2d& p) {
  Place<T> r;
  std::array<T, 2> v;
  r.exponent = internal::to_numbers<>(std::array<double, 2>{p.x, p.y}, v);
  r.base[0] = v[0], r.base[1] = v[1];
  return r;
}

// a + sum of (point i - a) weight i / the last weight.
template <typename T, typename P>
Place<T> weighted_place(const P& p) {
  check_defined(p.is_defined());
  const auto c = internal::coordinates(p.points());
  constexpr std::size_t kPoints = internal::kPoints<P>, kDim = c.size() / kPoints;
  std::array<T, c.size()> v;
  std::array<T, kPoints> weight;
  Place<T> r;
  r.is_explicit = false;
  r.exponent = internal::to_numbers(c, v);
  internal::to_numbers(p.weights(), weight);
  for (std::size_t axis = 0; axis < kDim; ++axis) {
    r.base[axis] = v[axis];
    r.numerator[axis] = (v[kDim + axis] - v[axis]) * weight[0];
    for (std::size_t i = 2; i < kPoints; ++i)
      r.numerator[axis] = r.numerator[axis] + (v[kDim * i + axis] - v[axis]) * weight[i - 1];
  }
  r.denominator = weight[kPoints - 1];
  return r;
}

template <typename T>
void make_denominator_positive(Place<T>& p, Sign denominator) {
  if (denominator == Sign::kPositive) return;
  for (T& n : p.numerator) n = -n;
  p.denominator = -p.denominator;
}

// Claim: each coordinate of layer is within the intervals' width of the exact one:
// docs/bounds/implicit_point.md.
template <typename P>
Place<Interval> layer_place(const P& p) {
  const internal::ImplicitLayer& layer = p.layer();
  const Vec3d& base = p.points()[0];
  const Interval abs(internal::kImplicitAbs), scale(layer.scale);
  const double d_error = (scale + abs).hi();
  const double error = (scale * Interval(layer.reach) + abs).hi();
  const Interval spread = Interval::from_bounds(-error, error);
  Place<Interval> r;
  r.is_explicit = false;
  r.base = {Interval(base.x), Interval(base.y), Interval(base.z)};
  r.numerator = {Interval(layer.x) + spread, Interval(layer.y) + spread,
                 Interval(layer.z) + spread};
  r.denominator = Interval(layer.d) + Interval::from_bounds(-d_error, d_error);
  return r;
}

template <typename T, typename P>
Place<T> general_place(const P& p) {
  std::array<T, 3 * internal::kPoints<P>> v;
  Place<T> r;
  r.is_explicit = false;
  r.exponent = internal::to_numbers(internal::coordinates(p.points()), v);
  const auto h = formulas::homogeneous(internal::triples(v));
  r.base = {v[0], v[1], v[2]};
  r.numerator = {h.numerator.x, h.numerator.y, h.numerator.z};
  r.denominator = h.denominator;
  make_denominator_positive(r, p.denominator_sign());
  return r;
}

template <typename T, int N>
T from_digits(const Digits<N>& v) {
  return T::from_digits(v.d.data(), N);
}
template <typename T>
Place<T> place_of_digits(const internal::LinePlaneDigits& d) {
  Place<T> r;
  const T t = from_digits<T>(d.t);
  for (int i = 0; i < 3; ++i) r.base[i] = T(d.base[i]), r.numerator[i] = t * T(d.u[i]);
  r.denominator = from_digits<T>(d.denominator);
  return r;
}
template <typename T>
Place<T> place_of_digits(const internal::ThreePlanesDigits& d) {
  Place<T> r;
  for (int i = 0; i < 3; ++i)
    r.base[i] = T(d.base[i]), r.numerator[i] = from_digits<T>(d.numerator[i]);
  r.denominator = from_digits<T>(d.denominator);
  return r;
}
template <typename T, typename D>
Place<T> place_with_sign(const D& digits, Sign denominator) {
  Place<T> r = place_of_digits<T>(digits);
  r.is_explicit = false;
  r.exponent = digits.lattice.exponent;
  make_denominator_positive(r, denominator);
  return r;
}
template <typename T>
constexpr bool kTakesDigits = requires {
  T::from_digits(nullptr, 0);
};

// Digits of fixed lengths are faster, if the point has them.
template <typename T, typename P>
Place<T> planes_place(const P& p) {
  check_defined(p.is_defined());
  if constexpr (kTakesDigits<T>) {
    internal::PointDigits<P> digits;
    if (internal::find_digits(p, digits)) return place_with_sign<T>(digits, p.denominator_sign());
  }
  if constexpr (std::is_same_v<T, Interval>) {
    if (p.layer().d > 0) return layer_place(p);
  }
  return general_place<T>(p);
}
template <typename T, typename P>
Place<T> cached_place(const CachedPoint<P>& p) {
  if constexpr (kTakesDigits<T>) {
    check_defined(p.is_defined());
    const auto* const digits = p.digits();
    if (digits != nullptr) return place_with_sign<T>(*digits, p.point().denominator_sign());
  }
  return planes_place<T>(p.point());
}

// a + (b - a) (g x s) / (r x s) with r = b - a, s = d - c, g = c - a.
template <typename T>
Place<T> crossing_place(const SegmentSegmentPoint2d& p) {
  check_defined(p.is_defined());
  std::array<T, 8> v;
  Place<T> r;
  r.is_explicit = false;
  r.exponent = internal::to_numbers(internal::coordinates(p.points()), v);
  const T rx = v[2] - v[0], ry = v[3] - v[1], sx = v[6] - v[4], sy = v[7] - v[5];
  const T t = (v[4] - v[0]) * sy - (v[5] - v[1]) * sx;
  r.base[0] = v[0], r.base[1] = v[1];
  r.numerator[0] = rx * t, r.numerator[1] = ry * t;
  r.denominator = rx * sy - ry * sx;
  make_denominator_positive(r, p.denominator_sign());
  return r;
}

template <typename T>
Place<T> place(const AnyPoint3& p) {
  using Kind = AnyPoint3::Kind;
  switch (p.kind()) {
    case Kind::kSegment: return weighted_place<T>(p.as<SegmentPoint>());
    case Kind::kTriangle: return weighted_place<T>(p.as<TrianglePoint>());
    case Kind::kLinePlane: return planes_place<T>(p.as<LinePlanePoint>());
    case Kind::kCachedLinePlane: return cached_place<T>(p.as<CachedPoint<LinePlanePoint>>());
    case Kind::kThreePlanes: return planes_place<T>(p.as<ThreePlanePoint>());
    case Kind::kCachedThreePlanes: return cached_place<T>(p.as<CachedPoint<ThreePlanePoint>>());
    default: return explicit_place<T>(p.as<Vec3d>());
  }
}
template <typename T>
Place<T> place(const AnyPoint2& p) {
  using Kind = AnyPoint2::Kind;
  switch (p.kind()) {
    case Kind::kSegment: return weighted_place<T>(p.as<SegmentPoint2d>());
    case Kind::kSegmentSegment: return crossing_place<T>(p.as<SegmentSegmentPoint2d>());
    default: return explicit_place<T>(p.as<Vec2d>());
  }
}

// The places of the points, all with one exponent.
template <typename T, typename Point, std::size_t N>
std::array<Place<T>, N> places(const std::array<const Point*, N>& points) {
  std::array<Place<T>, N> r;
  for (std::size_t i = 0; i < N; ++i) r[i] = place<T>(*points[i]);
  if constexpr (!std::is_same_v<T, Interval>) {
    int least = r[0].exponent;
    for (const Place<T>& p : r) least = std::min(least, p.exponent);
    for (Place<T>& p : r) {
      if (p.exponent == least) continue;
      for (T& v : p.base) v = v << (p.exponent - least);
      if (p.is_explicit) continue;
      for (T& v : p.numerator) v = v << (p.exponent - least);
    }
  }
  return r;
}

// ---- The tiers ---------------------------------------------------------------------------------------

// value(type_identity<T>()): the polynomial over intervals, then over integers.
template <bool IsLong, typename Value>
Sign decide(TierCounts* tally, Value value) {
  return cascade<static_cast<std::size_t>(Tier::kInterval)>(
      tally,
      [&]() -> Sign3 {
        const ScopedUpward upward;
        return value(std::type_identity<Interval>()).sign();
      },
      [&] { return internal::exact_sign<IsLong>(value); });
}

// The predicate is antisymmetric: the cheapest point is moved to the front, to be the origin of the others.
template <typename Point, std::size_t N>
Sign cheapest_first(std::array<const Point*, N>& points) {
  const auto least = std::min_element(points.begin(), points.end(),
                                      [](auto* a, auto* b) { return a->kind() < b->kind(); });
  if (least == points.begin()) return Sign::kPositive;
  std::swap(*least, points[0]);
  return Sign::kNegative;
}
template <typename T, typename Point, std::size_t N>
std::array<Vector<T>, N - 1> from_first(const std::array<const Point*, N>& points, int dimension) {
  const std::array<Place<T>, N> p = places<T>(points);
  std::array<Vector<T>, N - 1> r;
  for (std::size_t i = 1; i < N; ++i) r[i - 1] = formulas::vector(p[i], p[0], dimension);
  return r;
}
template <typename Point, std::size_t N>
bool all_explicit(const std::array<const Point*, N>& points) {
  return std::all_of(points.begin(), points.end(), [](auto* p) { return p->is_explicit(); });
}

template <typename Point>
Sign turn(std::array<const Point*, 3> p, int i, int j, TierCounts* tally) {
  const Sign order = cheapest_first(p);
  return order * decide<false>(tally, [&]<typename T>(std::type_identity<T>) {
           const auto v = from_first<T>(p, std::max(i, j) + 1);
           return formulas::minor2(v[0], v[1], i, j);
         });
}
template <typename Point>
Sign compare(const Point& p, const Point& q, int axis, TierCounts* tally) {
  return decide<false>(tally, [&]<typename T>(std::type_identity<T>) {
    const auto v = places<T>(std::array<const Point*, 2>{&p, &q});
    return formulas::difference(v[0], v[1], axis);
  });
}
template <typename Point, std::size_t N>
Sign along(const std::array<double, N>& direction, const Point& p, const Point& q,
           TierCounts* tally) {
  return decide<false>(tally, [&]<typename T>(std::type_identity<T>) {
    const auto v = places<T>(std::array<const Point*, 2>{&p, &q});
    std::array<T, N> d;
    internal::to_numbers(direction, d);
    T sum = d[0] * formulas::difference(v[0], v[1], 0);
    for (std::size_t i = 1; i < N; ++i)
      sum = sum + d[i] * formulas::difference(v[0], v[1], static_cast<int>(i));
    return sum;
  });
}

template <typename P>
Sign orient_planes(const AnyPoint3& a, const AnyPoint3& b, const AnyPoint3& c, const AnyPoint3& d,
                   TierCounts* tally) {
  return orient3d(a.as<Vec3d>(), b.as<Vec3d>(), c.as<Vec3d>(), d.as<P>(), tally);
}

}  // namespace

Sign orient3d(const AnyPoint3& a, const AnyPoint3& b, const AnyPoint3& c, const AnyPoint3& d,
              TierCounts* tally) {
  using Kind = AnyPoint3::Kind;
  std::array<const AnyPoint3*, 4> p{&a, &b, &c, &d};
  const auto most =
      std::max_element(p.begin(), p.end(), [](auto* v, auto* w) { return v->kind() < w->kind(); });
  Sign order = most == p.end() - 1 ? Sign::kPositive : Sign::kNegative;
  std::swap(*most, p[3]);
  if (p[0]->is_explicit() && p[1]->is_explicit() && p[2]->is_explicit()) {
    switch (p[3]->kind()) {
      case Kind::kExplicit:
        return order * orient3d(p[0]->as<Vec3d>(), p[1]->as<Vec3d>(), p[2]->as<Vec3d>(),
                                p[3]->as<Vec3d>(), tally);
      case Kind::kLinePlane:
        return order * orient_planes<LinePlanePoint>(*p[0], *p[1], *p[2], *p[3], tally);
      case Kind::kThreePlanes:
        return order * orient_planes<ThreePlanePoint>(*p[0], *p[1], *p[2], *p[3], tally);
      case Kind::kCachedLinePlane:
        return order *
               orient_planes<CachedPoint<LinePlanePoint>>(*p[0], *p[1], *p[2], *p[3], tally);
      case Kind::kCachedThreePlanes:
        return order *
               orient_planes<CachedPoint<ThreePlanePoint>>(*p[0], *p[1], *p[2], *p[3], tally);
      default: break;
    }
  }
  order = order * cheapest_first(p);
  return order * decide<false>(tally, [&]<typename T>(std::type_identity<T>) {
           const auto v = from_first<T>(p, 3);
           return formulas::minor3(v[0], v[1], v[2]);
         });
}

Sign in_sphere(const AnyPoint3& a, const AnyPoint3& b, const AnyPoint3& c, const AnyPoint3& d,
               const AnyPoint3& e, TierCounts* tally) {
  std::array<const AnyPoint3*, 5> p{&e, &a, &b, &c,
                                    &d};  // e first: the other order of five, reversed
  if (all_explicit(p)) {
    return in_sphere(a.as<Vec3d>(), b.as<Vec3d>(), c.as<Vec3d>(), d.as<Vec3d>(), e.as<Vec3d>(),
                     tally);
  }
  const Sign order = cheapest_first(p);
  return order * decide<true>(tally, [&]<typename T>(std::type_identity<T>) {
           const auto v = from_first<T>(p, 3);
           return formulas::lifted(v[0], v[1], v[2], v[3]);
         });
}

Sign orient2d_projected(const AnyPoint3& a, const AnyPoint3& b, const AnyPoint3& c, int axis,
                        TierCounts* tally) {
  VT_CHECK(0 <= axis && axis < 3, "an axis is 0, 1 or 2");
  const std::array<const AnyPoint3*, 3> p{&a, &b, &c};
  if (all_explicit(p)) {
    return orient2d(drop_axis(a.as<Vec3d>(), axis), drop_axis(b.as<Vec3d>(), axis),
                    drop_axis(c.as<Vec3d>(), axis), tally);
  }
  return turn(p, (axis + 1) % 3, (axis + 2) % 3, tally);
}

Sign compare_along(const Vec3d& direction, const AnyPoint3& p, const AnyPoint3& q,
                   TierCounts* tally) {
  if (p.is_explicit() && q.is_explicit())
    return compare_along(direction, p.as<Vec3d>(), q.as<Vec3d>(), tally);
  return along(std::array<double, 3>{direction.x, direction.y, direction.z}, p, q, tally);
}

Sign side_of_plane(const PlaneCoefficients& plane, const AnyPoint3& p, TierCounts* tally) {
  if (p.is_explicit()) return side_of_plane(plane, p.as<Vec3d>(), tally);
  return decide<false>(tally, [&]<typename T>(std::type_identity<T>) {
    const Place<T> at = place<T>(p);
    std::array<T, 4> k;
    internal::to_numbers(
        std::array<double, 4>{plane.normal.x, plane.normal.y, plane.normal.z, plane.offset}, k);
    T offset = k[3] * at.denominator;
    T sum = k[0] * (at.base[0] * at.denominator + at.numerator[0]);
    sum = sum + k[1] * (at.base[1] * at.denominator + at.numerator[1]);
    sum = sum + k[2] * (at.base[2] * at.denominator + at.numerator[2]);
    if constexpr (!std::is_same_v<T, Interval>) {  // the coordinates are in units of 2^exponent
      if (at.exponent > 0) sum = sum << at.exponent;
      if (at.exponent < 0) offset = offset << -at.exponent;
    }
    return sum + offset;
  });
}

Sign compare_axis(const AnyPoint3& p, const AnyPoint3& q, int axis, TierCounts* tally) {
  VT_CHECK(0 <= axis && axis < 3, "an axis is 0, 1 or 2");
  return compare(p, q, axis, tally);
}
Sign compare_lexicographic(const AnyPoint3& p, const AnyPoint3& q, TierCounts* tally) {
  Sign s = Sign::kZero;
  for (int axis = 0; axis < 3 && s == Sign::kZero; ++axis) s = compare(p, q, axis, tally);
  return s;
}

Sign orient2d(const AnyPoint2& a, const AnyPoint2& b, const AnyPoint2& c, TierCounts* tally) {
  const std::array<const AnyPoint2*, 3> p{&a, &b, &c};
  if (all_explicit(p)) return orient2d(a.as<Vec2d>(), b.as<Vec2d>(), c.as<Vec2d>(), tally);
  return turn(p, 0, 1, tally);
}

Sign in_circle(const AnyPoint2& a, const AnyPoint2& b, const AnyPoint2& c, const AnyPoint2& d,
               TierCounts* tally) {
  std::array<const AnyPoint2*, 4> p{&d, &a, &b, &c};
  if (all_explicit(p)) {
    return in_circle(a.as<Vec2d>(), b.as<Vec2d>(), c.as<Vec2d>(), d.as<Vec2d>(), tally);
  }
  const Sign order = cheapest_first(p);
  return order * decide<true>(tally, [&]<typename T>(std::type_identity<T>) {
           const auto v = from_first<T>(p, 2);
           return formulas::lifted(v[0], v[1], v[2]);
         });
}

Sign compare_along(const Vec2d& direction, const AnyPoint2& p, const AnyPoint2& q,
                   TierCounts* tally) {
  return along(std::array<double, 2>{direction.x, direction.y}, p, q, tally);
}
Sign compare_axis(const AnyPoint2& p, const AnyPoint2& q, int axis, TierCounts* tally) {
  VT_CHECK(axis == 0 || axis == 1, "an axis is 0 or 1");
  return compare(p, q, axis, tally);
}
Sign compare_lexicographic(const AnyPoint2& p, const AnyPoint2& q, TierCounts* tally) {
  const Sign s = compare(p, q, 0, tally);
  return s != Sign::kZero ? s : compare(p, q, 1, tally);
}

}  // namespace veritope
