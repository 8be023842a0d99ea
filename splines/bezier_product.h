// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/bezier_product.h: sums and products of Bezier maps.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "robust/base/check.h"
#include "splines/bezier.h"
#include "splines/bezier_components.h"
#include "splines/bezier_degree.h"
#include "splines/scaled_bernstein.h"

namespace veritope {
namespace internal {

/// A sum of products of components, in scaled form until the end.
template <Ring R, std::size_t N>
class ProductSum {
 public:
  ProductSum(const Bezier<R, N>& a, const Bezier<R, N>& b, int num_components, bool is_rational)
      : a_(to_scaled(a)), b_(to_scaled(b)), out_(sum(a, b), num_components, is_rational) {}
  /// Component `to` += a_i b_j.
  void add(int to, int i, int j) {
    const Bezier<R, N>&a = a_, &b = b_;
    add_scaled_product<R, N>(a.component(i), a.grid(), b.component(j), b.grid(), out_.component(to),
                             out_.grid());
  }
  void subtract(int to, int i, int j) {
    for (R& v : out_.component(to)) v = -v;
    add(to, i, j);
    for (R& v : out_.component(to)) v = -v;
  }
  Bezier<R, N> result() && { return from_scaled(std::move(out_)); }

 private:
  static std::array<int, N> sum(const Bezier<R, N>& a, const Bezier<R, N>& b) {
    std::array<int, N> degrees = a.degrees();
    for (std::size_t i = 0; i < N; ++i) degrees[i] += b.degree(i);
    return degrees;
  }
  Bezier<R, N> a_, b_, out_;
};

template <Ring R, std::size_t N, typename Combine>
Bezier<R, N> combined(const Bezier<R, N>& a, const Bezier<R, N>& b, Combine combine) {
  auto [first, second] = to_common_degrees(a, b);
  const std::span<R> to = first.coefficients();
  const std::span<const R> from = std::as_const(second).coefficients();
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = combine(to[i], from[i]);
  return std::move(first);
}

}  // namespace internal

/// s times every component of the map, where s is a scalar map. If either is rational, so is the product.
template <Ring R, std::size_t N>
Bezier<R, N> multiplied(const Bezier<R, N>& s, const Bezier<R, N>& map) {
  VT_CHECK(s.dimension() == 1, "the factor of a map is a scalar");
  if (s.is_rational() != map.is_rational()) return multiplied(to_rational(s), to_rational(map));
  internal::ProductSum<R, N> out(s, map, map.num_components(), map.is_rational());
  for (int c = 0; c < map.dimension(); ++c) out.add(c, 0, c);
  if (map.is_rational()) out.add(map.dimension(), 1, map.dimension());
  return std::move(out).result();
}

/// Component times component. Either may be rational. REQUIRES the same dimension.
template <Ring R, std::size_t N>
Bezier<R, N> componentwise_product(const Bezier<R, N>& a, const Bezier<R, N>& b) {
  VT_CHECK(a.dimension() == b.dimension(), "a product of maps of different dimensions");
  if (a.is_rational() != b.is_rational())
    return componentwise_product(to_rational(a), to_rational(b));
  internal::ProductSum<R, N> out(a, b, a.num_components(), a.is_rational());
  for (int c = 0; c < a.num_components(); ++c) out.add(c, c, c);
  return std::move(out).result();
}

/// The scalar product. REQUIRES polynomial maps of the same dimension.
template <Ring R, std::size_t N>
Bezier<R, N> dot(const Bezier<R, N>& a, const Bezier<R, N>& b) {
  VT_CHECK(!a.is_rational() && !b.is_rational(), "dot of a rational map");
  VT_CHECK(a.dimension() == b.dimension(), "dot of maps of different dimensions");
  internal::ProductSum<R, N> out(a, b, 1, false);
  for (int c = 0; c < a.dimension(); ++c) out.add(0, c, c);
  return std::move(out).result();
}

/// The vector product. REQUIRES polynomial maps of dimension 3.
template <Ring R, std::size_t N>
Bezier<R, N> cross(const Bezier<R, N>& a, const Bezier<R, N>& b) {
  VT_CHECK(!a.is_rational() && !b.is_rational(), "cross of a rational map");
  VT_CHECK(a.dimension() == 3 && b.dimension() == 3, "cross needs three dimensions");
  internal::ProductSum<R, N> out(a, b, 3, false);
  for (int c = 0; c < 3; ++c) {
    out.add(c, (c + 1) % 3, (c + 2) % 3);
    out.subtract(c, (c + 2) % 3, (c + 1) % 3);
  }
  return std::move(out).result();
}

/// a + b and a - b, with the greater degree along each axis, or with the sum of the degrees if one is rational.
/// REQUIRES the same dimension.
template <Ring R, std::size_t N>
Bezier<R, N> sum(const Bezier<R, N>& a, const Bezier<R, N>& b) {
  VT_CHECK(a.dimension() == b.dimension(), "a sum of maps of different dimensions");
  if (a.is_rational() || b.is_rational())
    return quotient(sum(multiplied(weight(b), numerators(a)), multiplied(weight(a), numerators(b))),
                    multiplied(weight(a), weight(b)));
  return internal::combined(a, b, [](const R& x, const R& y) -> R { return x + y; });
}
template <Ring R, std::size_t N>
Bezier<R, N> difference(const Bezier<R, N>& a, const Bezier<R, N>& b) {
  VT_CHECK(a.dimension() == b.dimension(), "a difference of maps of different dimensions");
  if (a.is_rational() || b.is_rational())
    return quotient(
        difference(multiplied(weight(b), numerators(a)), multiplied(weight(a), numerators(b))),
        multiplied(weight(a), weight(b)));
  return internal::combined(a, b, [](const R& x, const R& y) -> R { return x - y; });
}

// Compiled once, in rational_instances.cc.
extern template Bezier<Rational, 1> componentwise_product(const Bezier<Rational, 1>&,
                                                          const Bezier<Rational, 1>&);
extern template Bezier<Rational, 2> componentwise_product(const Bezier<Rational, 2>&,
                                                          const Bezier<Rational, 2>&);
extern template Bezier<Rational, 3> componentwise_product(const Bezier<Rational, 3>&,
                                                          const Bezier<Rational, 3>&);

}  // namespace veritope
