// SPDX-License-Identifier: LGPL-3.0-or-later
#include "predicates/distance.h"

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "interval/interval.h"
#include "interval/upward.h"

namespace veritope {
namespace {

template <typename T>
using Vector3 = std::array<T, 3>;

template <typename T>
Vector3<T> minus(const Vector3<T>& p, const Vector3<T>& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
template <typename T>
Vector3<T> plus(const Vector3<T>& p, const Vector3<T>& q) {
  return {p[0] + q[0], p[1] + q[1], p[2] + q[2]};
}
template <typename T>
Vector3<T> scaled(const T& factor, const Vector3<T>& p) {
  return {factor * p[0], factor * p[1], factor * p[2]};
}
template <typename T>
T dot(const Vector3<T>& p, const Vector3<T>& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
template <typename T>
T squared(const Vector3<T>& p) {
  return dot(p, p);
}
template <typename T>
Vector3<T> cross(const Vector3<T>& p, const Vector3<T>& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

// The sign of value(Interval or Rational coordinates of the points).
template <typename Value, std::size_t N>
Sign sign_of_value(TierCounts* tally, const std::array<const ExactPoint3*, N>& points,
                   Value value) {
  return cascade<2>(
      tally,
      [&] {
        const ScopedUpward upward;
        std::array<Vector3<Interval>, N> p;
        for (std::size_t i = 0; i < N; ++i) p[i] = points[i]->enclosure();
        return value(p).sign();
      },
      [&] {
        std::array<Vector3<Rational>, N> p;
        for (std::size_t i = 0; i < N; ++i) p[i] = points[i]->at();
        return value(p).sign();
      });
}

// The sign of the given angle minus that between u and v, which are not zero. Where their product is not negative, it
// is the sign of its square minus the squared cosine times their squares.
template <typename Pair, std::size_t N>
Sign compare_angle_to(TierCounts* tally, const std::array<const ExactPoint3*, N>& points,
                      const Rational& squared_cosine, Pair pair) {
  const Sign product = sign_of_value(tally, points, [&](const auto& p) {
    const auto [u, v] = pair(p);
    return dot(u, v);
  });
  if (product == Sign::kNegative) return Sign::kNegative;
  const Rational numerator(squared_cosine.numerator()), denominator(squared_cosine.denominator());
  const Interval n = enclose(numerator), d = enclose(denominator);
  return sign_of_value(tally, points, [&](const auto& p) {
    const auto [u, v] = pair(p);
    const auto product_of = dot(u, v);
    using T = std::decay_t<decltype(product_of)>;
    if constexpr (std::is_same_v<T, Interval>) {
      return d * product_of * product_of - n * squared(u) * squared(v);
    } else {
      return denominator * product_of * product_of - numerator * squared(u) * squared(v);
    }
  });
}

template <typename Pair, std::size_t N>
bool is_angle_at_most(TierCounts* tally, const std::array<const ExactPoint3*, N>& points,
                      const Rational& squared_cosine, Pair pair) {
  return compare_angle_to(tally, points, squared_cosine, pair) != Sign::kNegative;
}

}  // namespace

Sign compare_distances(const ExactPoint3& p, const ExactPoint3& q, const ExactPoint3& r,
                       TierCounts* tally) {
  return sign_of_value(tally, std::array{&p, &q, &r}, [](const auto& x) {
    return squared(minus(x[0], x[1])) - squared(minus(x[0], x[2]));
  });
}

// With twice the differences there is no division: (a - centre) + (b - centre), and 2 (surface - centre).
Sign compare_middle_to_ball(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& centre,
                            const ExactPoint3& surface, TierCounts* tally) {
  return sign_of_value(tally, std::array{&a, &b, &centre, &surface}, [](const auto& x) {
    const auto radius = squared(minus(x[3], x[2])), two = radius + radius;
    return squared(plus(minus(x[0], x[2]), minus(x[1], x[2]))) - (two + two);
  });
}

// With the edges u, v, w at a corner the vector from it to the centre is (u^2 (v x w) + v^2 (w x u) + w^2 (u x v)) / (2
// u.(v x w)).
Sign compare_circumradius(const std::array<const ExactPoint3*, 4>& tetrahedron,
                          const ExactPoint3& p, const ExactPoint3& q, const Rational& factor,
                          TierCounts* tally) {
  const std::array<const ExactPoint3*, 6> points{
      tetrahedron[0], tetrahedron[1], tetrahedron[2], tetrahedron[3], &p, &q};
  const Rational exact_factor = factor * factor * Rational(4);
  const Interval near_factor = enclose(exact_factor);
  return sign_of_value(tally, points, [&](const auto& x) {
    const auto u = minus(x[1], x[0]), v = minus(x[2], x[0]), w = minus(x[3], x[0]);
    const auto vw = cross(v, w);
    const auto triple = dot(u, vw);
    const auto normal = plus(plus(scaled(squared(u), vw), scaled(squared(v), cross(w, u))),
                             scaled(squared(w), cross(u, v)));
    using T = std::decay_t<decltype(triple)>;
    if constexpr (std::is_same_v<T, Interval>) {
      return squared(normal) - near_factor * triple * triple * squared(minus(x[4], x[5]));
    } else {
      return squared(normal) - exact_factor * triple * triple * squared(minus(x[4], x[5]));
    }
  });
}

Sign compare_volume(const std::array<const ExactPoint3*, 4>& tetrahedron, const Rational& volume,
                    TierCounts* tally) {
  const Rational exact_limit = volume * Rational(6);
  const Interval near_limit = enclose(exact_limit);
  return sign_of_value(tally, tetrahedron, [&](const auto& x) {
    const auto triple = dot(minus(x[1], x[0]), cross(minus(x[2], x[0]), minus(x[3], x[0])));
    using T = std::decay_t<decltype(triple)>;
    if constexpr (std::is_same_v<T, Interval>) {
      return triple - near_limit;
    } else {
      return triple - exact_limit;
    }
  });
}

bool is_angle_less(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                   const Rational& squared_cosine, TierCounts* tally) {
  return compare_angle_to(tally, std::array{&a, &b, &c}, squared_cosine, [](const auto& x) {
           return std::pair(minus(x[0], x[1]), minus(x[2], x[1]));
         }) == Sign::kPositive;
}

bool is_dihedral_less(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                      const ExactPoint3& d, const Rational& squared_cosine, TierCounts* tally) {
  return compare_angle_to(tally, std::array{&a, &b, &c, &d}, squared_cosine, [](const auto& x) {
           const auto edge = minus(x[1], x[0]);
           return std::pair(cross(edge, minus(x[2], x[0])), cross(edge, minus(x[3], x[0])));
         }) == Sign::kPositive;
}

bool turns_more(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                const Rational& squared_cosine, TierCounts* tally) {
  return !is_angle_at_most(tally, std::array{&a, &b, &c}, squared_cosine, [](const auto& x) {
    return std::pair(minus(x[1], x[0]), minus(x[2], x[1]));
  });
}

bool folds_more(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                const ExactPoint3& d, const Rational& squared_cosine, TierCounts* tally) {
  return !is_angle_at_most(tally, std::array{&a, &b, &c, &d}, squared_cosine, [](const auto& x) {
    const auto ab = minus(x[1], x[0]);
    return std::pair(cross(ab, minus(x[2], x[0])), cross(minus(x[3], x[0]), ab));
  });
}

}  // namespace veritope
