// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/plane_arc.h"

#include <algorithm>
#include <string>
#include <utility>

#include "solids/chain/simplex_cell.h"
#include "solids/classify/curve_passes.h"
#include "solids/patches/common_roots.h"
#include "splines/scaled_bernstein.h"

namespace veritope {
namespace {

Rational coordinate(const PlaneArc::Curve& c, int k, std::size_t i) {
  return c.is_rational() ? c.component(k)[i] / c.component(2)[i] : c.component(k)[i];
}
PointIn<2> control_point(const PlaneArc::Curve& c, std::size_t i) {
  return {coordinate(c, 0, i), coordinate(c, 1, i)};
}

int is_after(const Rational& y) { return y.sign() > 0 ? 1 : 0; }

}  // namespace

Result<PlaneArc> PlaneArc::make(Curve curve) {
  if (curve.dimension() != 2)
    return bad_argument("a curve of the plane has two coordinates, not " +
                        std::to_string(curve.dimension()));
  if (curve.degree(0) < 1) return bad_argument("a curve of the plane has a degree of 1 or more");
  if (curve.is_rational())
    for (const Rational& w : curve.component(2))
      if (w.sign() <= 0)
        return bad_argument("the weights of a curve are positive, not " + w.to_string());
  const auto last = static_cast<std::size_t>(curve.degree(0));
  Box3d box = box_around<2>(control_point(curve, 0));
  for (std::size_t i = 1; i <= last; ++i) box = hull(box, box_around<2>(control_point(curve, i)));
  PointIn<2> start = control_point(curve, 0), end = control_point(curve, last);
  return PlaneArc(std::move(curve), std::move(start), std::move(end), box);
}

PlaneArc::PlaneArc(Curve curve, PointIn<2> start, PointIn<2> end, Box3d box)
    : curve_(std::move(curve)), start_(std::move(start)), end_(std::move(end)), box_(box) {
  const internal::OverOne all(curve_.coefficients());
  const auto n = static_cast<std::size_t>(curve_.degree(0)) + 1;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < n; ++i)
      control_[c].push_back(c == 2 && !curve_.is_rational() ? all.denominator
                                                            : all.numerators[c * n + i]);
}

std::optional<PlaneArc::Sides> PlaneArc::sides() const {
  if (start_ == end_) return std::nullopt;
  Sides out;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(curve_.degree(0)); ++i) {
    const Sign s = orientation_of<2>({start_, end_, control_point(curve_, i)});
    out.has_left = out.has_left || s > 0;
    out.has_right = out.has_right || s < 0;
  }
  return out;
}

std::optional<int> PlaneArc::passes(const ChainPoint<2>& q, std::size_t axis) const {
  const std::size_t other = 1 - axis;
  const Box3d& at = q.box();
  if (box_.hi[axis] < at.lo[axis] || box_.hi[other] < at.lo[other] || at.hi[other] < box_.lo[other])
    return 0;
  // Across the ray: y for the axis x, -x for the axis y, so that both turn counter-clockwise.
  const auto height = [&](const PointIn<2>& p) {
    return axis == 0 ? p[1] - q.exact()[1] : q.exact()[0] - p[0];
  };
  if (at.hi[axis] < box_.lo[axis]) return is_after(height(end_)) - is_after(height(start_));
  const Rational &x = q.exact()[0], &y = q.exact()[1];
  const Integer common = x.denominator() * y.denominator(), left = x.numerator() * y.denominator(),
                below = y.numerator() * x.denominator();
  RelativeCurve relative;
  for (std::size_t i = 0; i < control_[0].size(); ++i) {
    relative.along.push_back(control_[0][i] * common - control_[2][i] * left);
    relative.across.push_back(control_[1][i] * common - control_[2][i] * below);
  }
  if (axis == 1) {
    std::swap(relative.along, relative.across);
    for (Integer& v : relative.across) v = -v;
  }
  return passes_of(relative);
}

std::optional<ArcParameter> PlaneArc::parameter_of(const PointIn<2>& q) const {
  std::array<Polynomial, 2> relative;
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<Rational> bernstein;
    for (std::size_t i = 0; i < control_[k].size(); ++i)
      bernstein.push_back(Rational(control_[k][i]) - q[k] * Rational(control_[2][i]));
    relative[k] = polynomial_of(bernstein);
  }
  const CommonRoots roots = common_roots(relative);
  if (roots.is_everywhere) return ArcParameter{};
  if (roots.roots.empty()) return std::nullopt;
  return roots.roots.front();
}

int passes_of_segment(const PointIn<2>& a, const PointIn<2>& b, const PointIn<2>& q,
                      std::size_t axis) {
  const auto height = [&](const PointIn<2>& p) {
    return is_after(axis == 0 ? p[1] - q[1] : q[0] - p[0]);
  };
  const int turn = height(b) - height(a);
  return turn != 0 && to_int(orientation_of<2>({a, b, q})) == turn ? turn : 0;
}

}  // namespace veritope
