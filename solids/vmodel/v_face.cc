// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <utility>
#include <vector>

#include "solids/vmodel/v_edge_internal.h"
#include "solids/vmodel/v_face_internal.h"
#include "splines/bspline_common.h"
#include "splines/bspline_domain.h"
#include "splines/de_boor.h"

namespace veritope::internal {
namespace {

using Place2 = std::array<std::size_t, 2>;

// p w(q) = q w(p) in coordinate c.
bool equal_in(const FaceView& f, int c, Place2 p, Place2 q) {
  if (!f.is_rational()) return f.at(c, p[0], p[1]) == f.at(c, q[0], q[1]);
  const Rational &w = f.weight(p[0], p[1]), &v = f.weight(q[0], q[1]);
  if (w == v) return f.at(c, p[0], p[1]) == f.at(c, q[0], q[1]);
  return f.at(c, p[0], p[1]) * v == f.at(c, q[0], q[1]) * w;
}
bool equal_points(const FaceView& f, Place2 p, Place2 q) {
  return equal_in(f, 0, p, q) && equal_in(f, 1, p, q) && equal_in(f, 2, p, q);
}

// Whether line `to` is line `from` up to the factor of their first points; each a line of points along axis k.
bool equal_lines(const FaceView& f, std::size_t k, std::size_t from, std::size_t to,
                 ControlRange range) {
  const auto place = [&](std::size_t line, std::size_t n) {
    return k == 0 ? Place2{n, line} : Place2{line, n};
  };
  const Place2 a = place(from, range.first), b = place(to, range.first);
  for (std::size_t n = range.first; n <= range.last; ++n) {
    const Place2 p = place(from, n), q = place(to, n);
    if (!f.is_rational()) {
      for (int c = 0; c < 3; ++c)
        if (f.at(c, p[0], p[1]) != f.at(c, q[0], q[1])) return false;
      continue;
    }
    const Rational &w = f.weight(a[0], a[1]), &v = f.weight(b[0], b[1]);
    for (int c = 0; c < 4; ++c) {
      const Rational &x = c == 3 ? f.weight(p[0], p[1]) : f.at(c, p[0], p[1]),
                     &y = c == 3 ? f.weight(q[0], q[1]) : f.at(c, q[0], q[1]);
      if (w == v ? x != y : x * v != y * w) return false;
    }
  }
  return true;
}

std::uint64_t mixed(std::uint64_t h) {
  h ^= h >> 31;
  h *= 0x7fb5d329728ea185u;
  h ^= h >> 27;
  h *= 0x81dadef4bc2dd44du;
  return h ^ (h >> 33);
}
std::uint64_t hash_number(std::uint64_t h, const Rational& x) {
  for (const Integer* n : {&x.numerator(), &x.denominator()})
    h = mixed(h ^ (n->low_bits() * 2 + (n->sign() < 0 ? 1 : 0) + (n->bit_length() << 56)));
  return h;
}

// ---- equality

bool has_inner_knots(const KnotAxis<Rational>& axis) {
  return axis.num_control() != static_cast<std::size_t>(axis.degree) + 1;
}

// Whether the knots, brought to [0,1] and those of a reversed if asked for, are equal.
bool same_knots(const KnotAxis<Rational>& a, const KnotAxis<Rational>& b, bool is_reversed) {
  if (a.degree != b.degree || a.knots.size() != b.knots.size()) return false;
  if (!has_inner_knots(a)) return true;
  if (!is_reversed && a.knots == b.knots) return true;
  const Rational length_a = a.domain_end() - a.domain_begin(),
                 length_b = b.domain_end() - b.domain_begin();
  for (std::size_t i = 0, n = a.knots.size(); i < n; ++i) {
    const Rational from =
        is_reversed ? a.domain_end() - a.knots[n - 1 - i] : a.knots[i] - a.domain_begin();
    if (from * length_b != (b.knots[i] - b.domain_begin()) * length_a) return false;
  }
  return true;
}

// Control points that correspond are equal up to the factor of the first ones. REQUIRES the same space.
bool same_nets(const FaceView& f, const FaceView& g, unsigned s) {
  const bool is_swapped = (s & 1) != 0;
  const bool is_rational = f.is_rational() || g.is_rational();
  const auto weight = [](const FaceView& h, std::size_t i, std::size_t j) {
    return h.is_rational() ? h.weight(i, j) : Rational(1);
  };
  const auto partner = [&](std::size_t i, std::size_t j) {
    Place2 at = is_swapped ? Place2{j, i} : Place2{i, j};
    if ((s & 2) != 0) at[0] = g.size(0) - 1 - at[0];
    if ((s & 4) != 0) at[1] = g.size(1) - 1 - at[1];
    return at;
  };
  Rational factor_f(1), factor_g(1);
  if (is_rational) {
    const Place2 q = partner(0, 0);
    factor_f = weight(g, q[0], q[1]), factor_g = weight(f, 0, 0);
  }
  const bool is_plain = factor_f == factor_g;
  for (std::size_t i = 0; i < f.size(0); ++i)
    for (std::size_t j = 0; j < f.size(1); ++j) {
      const Place2 q = partner(i, j);
      for (int c = 0; c < 3; ++c) {
        const Rational &x = f.at(c, i, j), &y = g.at(c, q[0], q[1]);
        if (is_plain ? x != y : x * factor_f != y * factor_g) return false;
      }
      if (is_rational && weight(f, i, j) * factor_f != weight(g, q[0], q[1]) * factor_g)
        return false;
    }
  return true;
}

// The coefficients are equal up to one factor. REQUIRES surfaces on the same axes, both rational or none.
bool same_coefficients(const BSplineSurface<Rational>& a, const BSplineSurface<Rational>& b) {
  if (!a.is_rational()) return a == b;
  const Rational &v = a.component(3)[0], &w = b.component(3)[0];
  const auto x = a.coefficients(), y = b.coefficients();
  for (std::size_t i = 0; i < x.size(); ++i)
    if (x[i] * w != y[i] * v) return false;
  return true;
}

bool equal_in_common_space(const FaceView& f, const FaceView& g, unsigned s) {
  const auto common = in_common_space(f, g, s);
  return same_coefficients(common.first, common.second);
}

bool same_corners(const FaceView& f, const FaceView& g, unsigned s) {
  for (const unsigned x : {0u, 1u})
    for (const unsigned y : {0u, 1u}) {
      const auto to = v_symmetry_image(s, {x, y});
      if (corner_of(f, x, y) != corner_of(g, to[0], to[1])) return false;
    }
  return true;
}

bool are_equal_under(const FaceView& f, const FaceView& g, unsigned s) {
  const std::size_t first = s & 1;  // of f, which becomes the first of g
  if (same_knots(f.knots(first), g.knots(0), (s & 2) != 0) &&
      same_knots(f.knots(1 - first), g.knots(1), (s & 4) != 0))
    return same_nets(f, g, s);
  return same_corners(f, g, s) && equal_in_common_space(f, g, s);
}

}  // namespace

BSplineSurface<Rational> on_unit_square(BSplineSurface<Rational> s) {
  for (std::size_t axis = 0; axis < 2; ++axis)
    s = with_domain(s, axis, Rational(0), Rational(1)).value();
  return s;
}

BSplineSurface<Rational> under_symmetry(BSplineSurface<Rational> face, unsigned s) {
  if ((s & 1) != 0) face = swapped(face, 0, 1);
  if ((s & 2) != 0) face = reversed(face, 0);
  if ((s & 4) != 0) face = reversed(face, 1);
  return face;
}

std::pair<BSplineSurface<Rational>, BSplineSurface<Rational>> in_common_space(const FaceView& f,
                                                                              const FaceView& g,
                                                                              unsigned s) {
  const bool is_rational = f.is_rational() || g.is_rational();
  return to_common_axes(under_symmetry(on_unit_square(surface_of(f, is_rational)), s),
                        on_unit_square(surface_of(g, is_rational)))
      .value();
}

VCollapse collapse_of(const FaceView& f, ControlRange i, ControlRange j) {
  const auto is_constant = [&](std::size_t k) {  // along parameter k
    const ControlRange &across = k == 0 ? i : j, &along = k == 0 ? j : i;
    for (std::size_t n = across.first + 1; n <= across.last; ++n)
      if (!equal_lines(f, 1 - k, across.first, n, along)) return false;
    return true;
  };
  const auto is_point = [&] {
    for (std::size_t m = i.first; m <= i.last; ++m)
      for (std::size_t n = j.first; n <= j.last; ++n)
        if (!equal_points(f, {i.first, j.first}, {m, n})) return false;
    return true;
  };
  if (is_point()) return VCollapse::kToPoint;
  if (is_constant(0)) return VCollapse::kAlongFirst;
  return is_constant(1) ? VCollapse::kAlongSecond : VCollapse::kNone;
}
VCollapse collapse_of(const FaceView& f) {
  return collapse_of(f, {0, f.size(0) - 1}, {0, f.size(1) - 1});
}

unsigned equal_symmetries(const FaceView& f, const FaceView& g, unsigned wanted) {
  unsigned out = 0;
  for (unsigned s = 0; s < 8; ++s)
    if ((wanted >> s & 1) != 0 && are_equal_under(f, g, s)) out |= 1u << s;
  return out;
}

std::uint64_t point_hash(const std::array<Rational, 3>& p) {
  std::uint64_t h = 0x9e3779b97f4a7c15u;
  for (const Rational& x : p) h = hash_number(h, x);
  return h;
}

std::array<Rational, 3> corner_of(const FaceView& f, unsigned x, unsigned y) {
  const std::size_t i = x == 0 ? 0 : f.size(0) - 1, j = y == 0 ? 0 : f.size(1) - 1;
  std::array<Rational, 3> p{f.at(0, i, j), f.at(1, i, j), f.at(2, i, j)};
  if (f.is_rational() && f.weight(i, j) != Rational(1))
    for (Rational& c : p) c /= f.weight(i, j);
  return p;
}

std::uint64_t corner_hash(const FaceView& f) {
  std::uint64_t h = 0;  // a sum: the order of the corners does not matter
  for (const unsigned x : {0u, 1u})
    for (const unsigned y : {0u, 1u}) h += mixed(point_hash(corner_of(f, x, y)));
  return h;
}

std::uint64_t inner_hash(const FaceView& f) {
  const auto surface = on_unit_square(surface_of(f, f.is_rational()));
  const Rational a(Integer(1), Integer(5)), b(Integer(1), Integer(3)), half(Integer(1), Integer(2));
  std::uint64_t h = 0;
  const auto add = [&](const Rational& u, const Rational& v) {
    const auto p = point(surface, {u, v}).value();
    h += mixed(point_hash({p[0], p[1], p[2]}));
  };
  add(half, half);
  for (const Rational& u : {a, Rational(1) - a})
    for (const Rational& v : {b, Rational(1) - b}) add(u, v), add(v, u);
  return h;
}

BSplineSurface<Rational> surface_of(const FaceView& f, bool is_rational) {
  std::vector<Rational> values;
  values.reserve(f.size(0) * f.size(1) * 4);
  for (int c = 0; c < (is_rational ? 4 : 3); ++c)
    for (std::size_t i = 0; i < f.size(0); ++i)
      for (std::size_t j = 0; j < f.size(1); ++j)
        values.push_back(c < 3 ? f.at(c, i, j) : f.is_rational() ? f.weight(i, j) : Rational(1));
  return {{f.knots(0), f.knots(1)}, is_rational ? 4 : 3, is_rational, std::move(values)};
}

bool is_edge_collapsed(const VVolume& cell, std::size_t edge) {
  // The edge is a side of the face across the lesser of the other two axes, at its begin or end.
  const std::size_t axis = edge / 4, lesser = axis == 0 ? 1 : 0;
  const FaceView face(cell, 2 * lesser + edge % 2);
  const std::size_t along = face.axis(0) == axis ? 0 : 1;
  const std::size_t line = (edge / 2 % 2) != 0 ? face.size(1 - along) - 1 : 0;
  const auto place = [&](std::size_t n) { return along == 0 ? Place2{n, line} : Place2{line, n}; };
  for (std::size_t n = face.size(along) - 1; n > 0; --n)
    if (!equal_points(face, place(0), place(n))) return false;
  return true;
}

}  // namespace veritope::internal
