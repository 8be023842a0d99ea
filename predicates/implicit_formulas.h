// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/implicit_formulas.h: points that are given by planes and lines, and their orientation,
// over any ring. On FixedInt each product is as wide as its factors together, on Digits sums of
// products are carried before they are factors: implicit_point.cc has the budgets.
// Source: [Att20] (LPI, TPI).
#pragma once
#include <type_traits>

#include "robust/digits.h"
#include "robust/fixed_int.h"

namespace veritope::formulas {

template <typename A, typename B>
constexpr auto product(const A& a, const B& b) {
  return a * b;
}
template <int A, int B>
constexpr auto product(const FixedInt<A>& a, const FixedInt<B>& b) {
  return wide_product(a, b);
}

template <int A, int B>
constexpr auto product(const Digits<A>& a, const Digits<B>& b) {
  return column_product(a, b);
}
/// A sum of products as a factor of further ones.
template <typename T>
constexpr const T& settle(const T& v) {
  return v;
}
template <int N>
constexpr Digits<N + 1> settle(const Columns<N>& v) {
  return settled(v);
}
/// The last sum of a formula, of which only the sign is used.
template <typename A, typename B>
constexpr auto last_sum(const A& a, const B& b) {
  return a + b;
}
template <int N>
constexpr Columns<N + 1> last_sum(const Columns<N>& a, const Columns<N>& b) {
  Columns<N + 1> r = carried(a);
  for (int i = 0; i < N; ++i) r.c[i] += b.c[i];
  return r;
}

template <typename T>
struct Triple {
  T x, y, z;
};
template <typename T>
constexpr Triple<T> difference(const Triple<T>& a, const Triple<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename A, typename B>
constexpr auto cross(const Triple<A>& a, const Triple<B>& b) {
  using R = std::decay_t<decltype(settle(product(a.x, b.x)))>;
  return Triple<R>{settle(product(a.y, b.z) - product(a.z, b.y)),
                   settle(product(a.z, b.x) - product(a.x, b.z)),
                   settle(product(a.x, b.y) - product(a.y, b.x))};
}
template <typename A, typename B>
constexpr auto dot(const Triple<A>& a, const Triple<B>& b) {
  return settle((product(a.x, b.x) + product(a.y, b.y)) + product(a.z, b.z));
}
template <typename A, typename B>
constexpr auto times(const A& a, const Triple<B>& b) {
  using R = decltype(product(a, b.x));
  return Triple<R>{product(a, b.x), product(a, b.y), product(a, b.z)};
}

/// The point base + numerator / denominator.
template <typename N, typename D>
struct Homogeneous {
  Triple<N> numerator;
  D denominator;
};

/// Line and plane: u along the line, v and w in the plane, g from the base, a point of the line, to a
/// point of the plane. Denominator 0: they are parallel.
template <typename T>
constexpr auto line_plane(const Triple<T>& u, const Triple<T>& v, const Triple<T>& w,
                          const Triple<T>& g) {
  const auto n = cross(v, w);
  const auto numerator = times(dot(n, g), u);
  const auto denominator = dot(n, u);
  using N = decltype(numerator.x);
  return Homogeneous<std::remove_cv_t<N>, std::remove_cv_t<decltype(denominator)>>{numerator,
                                                                                   denominator};
}

/// Two vectors in a plane, and one from the base to a point of it.
template <typename T>
struct PlaneVectors {
  Triple<T> v, w, g;
};
/// Three planes; the base is a point of the first one, whose g is 0 and is not read. Denominator 0: they do not meet in
/// one point.
template <typename T>
constexpr auto three_planes(const PlaneVectors<T>& first, const PlaneVectors<T>& second,
                            const PlaneVectors<T>& third) {
  const auto n1 = cross(first.v, first.w), n2 = cross(second.v, second.w),
             n3 = cross(third.v, third.w);
  const auto c31 = cross(n3, n1), c12 = cross(n1, n2);
  const auto p = times(dot(n2, second.g), c31), q = times(dot(n3, third.g), c12);
  const auto denominator = dot(n2, c31);
  using N = std::remove_cv_t<decltype(p.x)>;
  return Homogeneous<N, std::remove_cv_t<decltype(denominator)>>{{p.x + q.x, p.y + q.y, p.z + q.z},
                                                                 denominator};
}

/// (point - a) . (v x w), times the denominator, for e = base - a and v, w in a plane through a.
template <typename N, typename D, typename T>
constexpr auto orientation(const Homogeneous<N, D>& h, const Triple<T>& e, const Triple<T>& v,
                           const Triple<T>& w) {
  const auto n = cross(v, w);
  return dot(h.numerator, n) + product(h.denominator, dot(e, n));
}

/// Equal to orientation(line_plane(u, v, w, g), e, v1, w1), with fewer and shorter products.
template <typename T>
constexpr auto line_plane_orientation(const Triple<T>& u, const Triple<T>& v, const Triple<T>& w,
                                      const Triple<T>& g, const Triple<T>& e, const Triple<T>& v1,
                                      const Triple<T>& w1) {
  const auto n = cross(v, w), m = cross(v1, w1);
  return product(dot(n, g), dot(u, m)) + product(dot(n, u), dot(e, m));
}
/// Equal to orientation(three_planes(first, second, third), e, v, w).
template <typename T>
constexpr auto three_planes_orientation(const PlaneVectors<T>& first, const PlaneVectors<T>& second,
                                        const PlaneVectors<T>& third, const Triple<T>& e,
                                        const Triple<T>& v, const Triple<T>& w) {
  const auto n1 = cross(first.v, first.w), n2 = cross(second.v, second.w),
             n3 = cross(third.v, third.w), m = cross(v, w);
  const auto p = cross(n1, m), q = cross(n3, n1);
  return last_sum(product(dot(n2, second.g), dot(n3, p)) - product(dot(n3, third.g), dot(n2, p)),
                  product(dot(e, m), dot(n2, q)));
}

}  // namespace veritope::formulas
