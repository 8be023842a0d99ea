// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/implicit_homogeneous.h: points of every kind as base + numerator / denominator over any
// ring, denominator > 0, and the polynomials of several such points: one place for all combinations.
#pragma once
#include <array>
#include <tuple>
#include <type_traits>
#include <utility>

#include "interval/interval.h"
#include "predicates/formulas.h"
#include "predicates/implicit_formulas.h"
#include "predicates/lattice.h"
#include "predicates/vec.h"

namespace veritope {

namespace formulas {

/// The two vectors of the plane through t[i], t[i + 1], t[i + 2], and the one from t[0] to t[i].
template <typename T, std::size_t N>
constexpr PlaneVectors<T> plane_vectors(const std::array<Triple<T>, N>& t, int i) {
  return {difference(t[i + 1], t[i]), difference(t[i + 2], t[i]), difference(t[i], t[0])};
}
/// The point that 5 points (LinePlanePoint) or 9 points (ThreePlanePoint) define, over its denominator.
template <typename T, std::size_t N>
constexpr auto homogeneous(const std::array<Triple<T>, N>& t) {
  if constexpr (N == 5) {
    const auto plane = plane_vectors(t, 2);
    return line_plane(difference(t[1], t[0]), plane.v, plane.w, plane.g);
  } else {
    return three_planes(plane_vectors(t, 0), plane_vectors(t, 3), plane_vectors(t, 6));
  }
}

/// One of several points: (base + numerator / denominator) 2^exponent. Numerator and denominator of an explicit point
/// are not read.
template <typename T>
struct Place {
  std::array<T, 3> base, numerator;
  T denominator;
  int exponent = 0;
  bool is_explicit = true;
};

/// p - q on an axis, times both denominators. REQUIRES equal exponents.
template <typename T>
T difference(const Place<T>& p, const Place<T>& q, int axis) {
  const T e = p.base[axis] - q.base[axis];
  if (p.is_explicit && q.is_explicit) return e;
  if (q.is_explicit) return e * p.denominator + p.numerator[axis];
  if (p.is_explicit) return e * q.denominator - q.numerator[axis];
  return (e * p.denominator + p.numerator[axis]) * q.denominator -
         q.numerator[axis] * p.denominator;
}
/// p - q as (v[0], v[1], v[2]) / w.
template <typename T>
struct Vector {
  std::array<T, 3> v;
  T w;
  bool is_whole;  ///< w = 1 and is not read
};
/// REQUIRES that q is explicit if p is.
template <typename T>
Vector<T> vector(const Place<T>& p, const Place<T>& q, int dimension) {
  Vector<T> r;
  for (int axis = 0; axis < dimension; ++axis) r.v[axis] = difference(p, q, axis);
  r.is_whole = p.is_explicit;
  if (!r.is_whole) r.w = q.is_explicit ? p.denominator : p.denominator * q.denominator;
  return r;
}

template <typename T>
T minor2(const Vector<T>& a, const Vector<T>& b, int i, int j) {
  return a.v[i] * b.v[j] - a.v[j] * b.v[i];
}
template <typename T>
T minor3(const Vector<T>& a, const Vector<T>& b, const Vector<T>& c) {
  return (a.v[2] * minor2(b, c, 0, 1) - b.v[2] * minor2(a, c, 0, 1)) + c.v[2] * minor2(a, b, 0, 1);
}
template <typename T>
T times_w(T value, const Vector<T>& a) {
  return a.is_whole ? value : value * a.w;
}

/// The determinant of the rows (v w, |v|^2) = (v / w, |v / w|^2) w^2, two columns of which are coordinates.
template <typename T>
T lifted(const Vector<T>& a, const Vector<T>& b, const Vector<T>& c) {
  const auto lift = [](const Vector<T>& r) -> T { return sqr(r.v[0]) + sqr(r.v[1]); };
  const T bc = times_w(times_w(minor2(b, c, 0, 1), b), c);
  const T ca = times_w(times_w(minor2(c, a, 0, 1), c), a);
  const T ab = times_w(times_w(minor2(a, b, 0, 1), a), b);
  return (lift(a) * bc + lift(b) * ca) + lift(c) * ab;
}
/// The determinant with three columns of coordinates, signed as in InSphere.
template <typename T>
T lifted(const Vector<T>& a, const Vector<T>& b, const Vector<T>& c, const Vector<T>& d) {
  const auto lift = [](const Vector<T>& r) -> T {
    return (sqr(r.v[0]) + sqr(r.v[1])) + sqr(r.v[2]);
  };
  const auto volume = [](const Vector<T>& p, const Vector<T>& q, const Vector<T>& r) -> T {
    return times_w(times_w(times_w(minor3(p, q, r), p), q), r);
  };
  return (lift(a) * volume(b, c, d) - lift(b) * volume(a, c, d)) +
         (lift(c) * volume(a, b, d) - lift(d) * volume(a, b, c));
}

}  // namespace formulas

namespace internal {

/// The number of points that define P.
template <typename P>
constexpr std::size_t kPoints =
    std::tuple_size_v<std::decay_t<decltype(std::declval<P>().points())>>;

template <std::size_t N>
std::array<double, 3 * N> coordinates(const std::array<Vec3d, N>& p) {
  std::array<double, 3 * N> c;
  for (std::size_t i = 0; i < N; ++i)
    c[3 * i] = p[i].x, c[3 * i + 1] = p[i].y, c[3 * i + 2] = p[i].z;
  return c;
}
template <std::size_t N>
std::array<double, 2 * N> coordinates(const std::array<Vec2d, N>& p) {
  std::array<double, 2 * N> c;
  for (std::size_t i = 0; i < N; ++i) c[2 * i] = p[i].x, c[2 * i + 1] = p[i].y;
  return c;
}
template <typename T, std::size_t N>
std::array<formulas::Triple<T>, N / 3> triples(const std::array<T, N>& c) {
  std::array<formulas::Triple<T>, N / 3> t;
  for (std::size_t i = 0; i < N / 3; ++i) t[i] = {c[3 * i], c[3 * i + 1], c[3 * i + 2]};
  return t;
}

/// Sets out to c[i] / 2^exponent: integers, with the largest exponent that they allow, or intervals (exponent 0).
template <std::size_t N>
int to_numbers(const std::array<double, N>& c, std::array<Interval, N>& out) {
  for (std::size_t i = 0; i < N; ++i) out[i] = Interval(c[i]);
  return 0;
}
template <typename T, std::size_t N>
int to_numbers(const std::array<double, N>& c, std::array<T, N>& out) {
  return to_integers(c, out);
}

}  // namespace internal
}  // namespace veritope
