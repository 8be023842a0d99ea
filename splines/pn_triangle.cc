// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/pn_triangle.h"

#include <string>
#include <utility>

#include "robust/dyadic.h"

namespace veritope {
namespace {

template <typename S>
using Vector = std::array<S, 3>;

template <typename S>
Vector<S> operator-(const Vector<S>& a, const Vector<S>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <typename S>
Vector<S> operator+(const Vector<S>& a, const Vector<S>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <typename S>
S dot(const Vector<S>& a, const Vector<S>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <typename S>
Vector<S> cross(const Vector<S>& a, const Vector<S>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <typename S>
bool is_zero(const Vector<S>& a) {
  return a[0].sign() == Sign::kZero && a[1].sign() == Sign::kZero && a[2].sign() == Sign::kZero;
}

const Rational& as_rational(const Rational& v) { return v; }
Rational as_rational(const Dyadic& v) { return v.to_rational(); }
template <typename S>
std::string text(const Vector<S>& v) {
  return "(" + as_rational(v[0]).to_string() + ", " + as_rational(v[1]).to_string() + ", " +
         as_rational(v[2]).to_string() + ")";
}

// a / b: the only place where a common divisor is looked for.
Rational quotient(const Rational& a, const Rational& b) { return a / b; }
Rational quotient(const Dyadic& a, const Dyadic& b) {
  Integer p = a.mantissa(), q = b.mantissa();
  const std::int64_t shift = a.exponent() - b.exponent();
  if (shift >= 0) {
    p.shift_left(static_cast<std::uint64_t>(shift));
  } else {
    q.shift_left(static_cast<std::uint64_t>(-shift));
  }
  return Rational(std::move(p), std::move(q));
}

}  // namespace

template <typename S>
PnPoint pn_edge_point(const Vector<S>& p, const Vector<S>& q, const Vector<S>& n) {
  const S nn = dot(n, n), f = dot(q - p, n), denominator = S(3) * nn;
  PnPoint b;
  for (std::size_t c = 0; c < 3; ++c)
    b[c] = quotient((p[c] + p[c] + q[c]) * nn - f * n[c], denominator);
  return b;
}

template <typename S>
PnPoint pn_edge_normal(const Vector<S>& p, const Vector<S>& q, const Vector<S>& n,
                       const Vector<S>& m) {
  const Vector<S> d = q - p, sum = n + m;
  const S dd = dot(d, d), f = S(2) * dot(d, sum), denominator = S(2) * dd;
  PnPoint h;
  for (std::size_t c = 0; c < 3; ++c) h[c] = quotient(sum[c] * dd - f * d[c], denominator);
  return h;
}

// The two edge points at corner i add up to ((4 p + a + b) (n.n) - ((a + b - 2p).n) n) / (3 n.n) for the other corners
// a, b. Their sum over all corners, over a common denominator, minus two thirds of the corners' sum is four times the
// centre.
template <typename S>
PnPoint pn_centre(const PnCorners<S>& corners) {
  std::array<S, 3> nn;
  for (std::size_t i = 0; i < 3; ++i) nn[i] = dot(corners.normals[i], corners.normals[i]);
  const Vector<S> total = corners.points[0] + corners.points[1] + corners.points[2];
  const S all = nn[0] * nn[1] * nn[2];
  Vector<S> numerator;
  for (std::size_t c = 0; c < 3; ++c) numerator[c] = -(S(2) * total[c] * all);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector<S>&p = corners.points[i], &n = corners.normals[i];
    const S others = nn[(i + 1) % 3] * nn[(i + 2) % 3];
    const S f = dot(total - p - p - p, n);
    for (std::size_t c = 0; c < 3; ++c)
      numerator[c] = numerator[c] + ((S(3) * p[c] + total[c]) * nn[i] - f * n[c]) * others;
  }
  PnPoint b;
  for (std::size_t c = 0; c < 3; ++c) b[c] = quotient(numerator[c], S(12) * all);
  return b;
}

template <typename S>
Status check_pn_triangle(const PnCorners<S>& corners) {
  const auto& [p, normals] = corners;
  const Vector<S> plane = cross(p[1] - p[0], p[2] - p[0]);
  if (is_zero(plane))
    return Error{Code::kBadArgument,
                 {},
                 "the triangle is degenerate: " + text(p[0]) + " " + text(p[1]) + " " + text(p[2])};
  for (std::size_t i = 0; i < 3; ++i) {
    if (dot(plane, normals[i]).sign() == Sign::kPositive) continue;
    Error error{Code::kBadArgument, {}, "the normal of corner " + std::to_string(i)};
    error.place.vertex = i;
    if (is_zero(normals[i])) {
      error.message += " is zero";
    } else {
      error.message += ", " + text(normals[i]) +
                       ", is 90 degrees or more off the plane's normal, " + text(plane);
    }
    return error;
  }
  return ok_status();
}

#define VT_PN(S)                                                                        \
  template Status check_pn_triangle(const PnCorners<S>&);                               \
  template PnPoint pn_edge_point(const Vector<S>&, const Vector<S>&, const Vector<S>&); \
  template PnPoint pn_edge_normal(const Vector<S>&, const Vector<S>&, const Vector<S>&, \
                                  const Vector<S>&);                                    \
  template PnPoint pn_centre(const PnCorners<S>&);
VT_PN(Rational)
VT_PN(Dyadic)
#undef VT_PN

Result<PnTriangle> make_pn_triangle(const std::array<PnPoint, 3>& corners,
                                    const std::array<PnPoint, 3>& normals) {
  const PnCorners<Rational> all{corners, normals};
  if (Status status = check_pn_triangle(all); !status) return status.error();
  std::array<std::array<PnPoint, 2>, 3> edge_points;
  std::array<PnPoint, 3> edge_normals;
  for (std::size_t e = 0; e < 3; ++e) {
    const std::size_t a = (e + 1) % 3, b = (e + 2) % 3;
    edge_points[e] = {pn_edge_point(corners[a], corners[b], normals[a]),
                      pn_edge_point(corners[b], corners[a], normals[b])};
    edge_normals[e] = pn_edge_normal(corners[a], corners[b], normals[a], normals[b]);
  }
  return PnTriangle{pn_points<Rational>(corners, edge_points, pn_centre(all)),
                    pn_normals<Rational>(normals, edge_normals)};
}

}  // namespace veritope
