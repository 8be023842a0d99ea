// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/enclosure/surface_enclosure.h"

#include <algorithm>

#include "interval/enclosure/bernstein_product_internal.h"
#include "interval/enclosure/spline_enclosure_internal.h"

namespace veritope {
namespace {

template <typename T>
using Vector = std::array<T, 3>;

template <typename T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <typename T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}
template <typename T>
T squared(const Vector<T>& a) {
  return (sqr(a[0]) + sqr(a[1])) + sqr(a[2]);
}
template <typename View>
Vector<typename View::Number> partial(const View& view, int u, int v) {
  return {view({u, v}, 0), view({u, v}, 1), view({u, v}, 2)};
}

struct NormalFormula {
  static internal::MultiIndex<2> base() { return {}; }
  template <typename View>
  auto operator()(const View& view) const {
    const auto n = cross(partial(view, 1, 0), partial(view, 0, 1));
    return std::vector<typename View::Number>(n.begin(), n.end());
  }
};

Interval not_negative(const Interval& a) {
  return intersection(a, Interval::from_bits(0, internal::kInfiniteBits));
}
template <std::size_t N>
Gradient<N> not_negative(const Gradient<N>& a) {
  return {not_negative(a.value), a.slope};
}

// With n = S_u x S_v, E, F, G of the first fundamental form, e = S_uu . n etc. (|n| times those of the second):
// K = (e g - f^2) / |n|^4, H = (e G - 2 f F + g E) / (2 |n|^3), principal curvatures H -+ sqrt(H^2 - K).
struct CurvatureFormula {
  static internal::MultiIndex<2> base() { return {}; }
  template <typename View>
  auto operator()(const View& view) const {
    using T = typename View::Number;
    const auto u = partial(view, 1, 0), v = partial(view, 0, 1), n = cross(u, v);
    const T e = dot(partial(view, 2, 0), n), f = dot(partial(view, 1, 1), n);
    const T g = dot(partial(view, 0, 2), n);
    const T n2 = squared(n), size = sqrt(n2);
    const T gauss = (e * g - sqr(f)) / sqr(n2);
    const T ff = f * dot(u, v);
    const T mean = ((e * squared(v) - (ff + ff)) + g * squared(u)) / (Interval(2.0) * (size * n2));
    const T root = sqrt(not_negative(sqr(mean) - gauss));
    return std::vector<T>{gauss, mean, mean - root, mean + root};
  }
};

Error wrong_dimension(int dimension) {
  return Error{Code::kBadArgument,
               {},
               "a surface of dimension " + std::to_string(dimension) + " has no normal in space"};
}

using Polynomial = internal::ScaledBernstein2;
using PolynomialVector = Vector<Polynomial>;

// The coefficients of the normal's numerator on the part of one cell.
PolynomialVector normal_numerator(const internal::EnclosureData<2>& data,
                                  const internal::CellPart<2>& part) {
  const auto& derivatives = data.cells[part.cell].derivatives;
  const auto cut = [&](const internal::MultiIndex<2>& order) {
    return on_box(derivatives[data.index_of(order)], part.local);
  };
  const auto x = cut({0, 0}), xu = cut({1, 0}), xv = cut({0, 1});
  const auto tangent = [&](const Bezier<Interval, 2>& slope) {
    PolynomialVector out;
    for (int c = 0; c < 3; ++c)
      out[static_cast<std::size_t>(c)] =
          data.is_rational
              ? Polynomial(slope, c) * Polynomial(x, 3) - Polynomial(x, c) * Polynomial(slope, 3)
              : Polynomial(slope, c);
    return out;
  };
  return cross(tangent(xu), tangent(xv));
}

std::optional<DirectionCone> cone_around(const std::vector<Vector<Interval>>& normals) {
  Vector<double> axis{};
  for (const auto& n : normals)
    for (std::size_t c = 0; c < 3; ++c) {
      if (!is_common(n[c])) return std::nullopt;
      axis[c] += mid(n[c]);
    }
  const Vector<Interval> a{Interval(axis[0]), Interval(axis[1]), Interval(axis[2])};
  double tangent = 0;
  for (const auto& n : normals) {
    // Coefficients that are all zero lie in every cone; the cone is convex and holds the combinations of the others.
    if (squared(n).sign() == Sign3::kZero) continue;
    const Interval along = dot(n, a);
    if (along.sign() != Sign3::kPositive) return std::nullopt;
    const double here = (sqrt(squared(cross(n, a))) / along).hi();
    if (!(here < 1e300)) return std::nullopt;
    tangent = std::max(tangent, here);
  }
  return DirectionCone{axis, tangent};
}

}  // namespace

Result<Box3> enclose_normal(const SplineEnclosure<2>& surface, const Box2& at, EnclosureForm form) {
  if (surface.dimension() != 3) return wrong_dimension(surface.dimension());
  const auto n = internal::enclosed(surface.data(), at, NormalFormula{}, 1, form);
  if (!n) return n.error();
  return Box3(n.value()[0], n.value()[1], n.value()[2]);
}

Result<CurvatureEnclosure> enclose_curvatures(const SplineEnclosure<2>& surface, const Box2& at,
                                              EnclosureForm form) {
  if (surface.dimension() != 3) return wrong_dimension(surface.dimension());
  const auto k = internal::enclosed(surface.data(), at, CurvatureFormula{}, 2, form);
  if (!k) return k.error();
  return CurvatureEnclosure{k.value()[0], k.value()[1], k.value()[2], k.value()[3]};
}

Result<std::optional<DirectionCone>> enclose_normal_cone(const SplineEnclosure<2>& surface,
                                                         const Box2& at) {
  if (surface.dimension() != 3) return wrong_dimension(surface.dimension());
  const ScopedUpward upward;
  const auto parts = internal::parts_of(surface.data(), at, 1);
  if (!parts) return parts.error();
  std::vector<Vector<Interval>> normals;
  for (const auto& part : parts.value()) {
    const PolynomialVector n = normal_numerator(surface.data(), part);
    for (std::size_t i = 0; i < n[0].size(); ++i)
      normals.push_back({n[0].scaled(i), n[1].scaled(i), n[2].scaled(i)});
  }
  return cone_around(normals);
}

bool are_within_right_angle(const DirectionCone& a, const DirectionCone& b) {
  Vector<Interval> p, q;
  for (std::size_t c = 0; c < 3; ++c) p[c] = Interval(a.axis[c]), q[c] = Interval(b.axis[c]);
  const Interval along = dot(p, q);
  if (along.sign() != Sign3::kPositive) return false;
  // tan of the angle between the axes, then of the sums of angles, each below a right angle: 1 - tan tan > 0.
  const Interval between = sqrt(squared(cross(p, q))) / along;
  const auto sum = [](const Interval& x, const Interval& y) -> std::optional<Interval> {
    const Interval rest = Interval(1.0) - x * y;
    if (rest.sign() != Sign3::kPositive) return std::nullopt;
    return (x + y) / rest;
  };
  const auto first = sum(Interval(a.tangent), Interval(b.tangent));
  return first && sum(*first, between).has_value();
}

}  // namespace veritope
