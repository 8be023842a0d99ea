// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/patch_cone.h"

#include <algorithm>
#include <array>
#include <utility>

#include "robust/base/check.h"
#include "splines/bezier_triangle.h"
#include "splines/de_casteljau.h"

namespace veritope {
namespace {

using Vector = std::array<Rational, 3>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector negated(const Vector& a) { return {-a[0], -a[1], -a[2]}; }
Vector crossed(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dotted(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
bool is_zero(const Vector& a) { return a[0].sign() == 0 && a[1].sign() == 0 && a[2].sign() == 0; }

Direction direction(const Vector& a) {
  Integer unit(1);
  for (const Rational& x : a) unit = lcm(unit, x.denominator());
  std::array<Dyadic, 3> out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = Dyadic(a[k].numerator() * divide_exactly(unit, a[k].denominator()));
  return Direction(std::move(out));
}

// The derivatives along both axes of the domain, times a positive number: of a triangle towards corners 1 and 2.
using Tangents = std::array<Vector, 2>;

// (F' w - F w') for homogeneous values and their derivative.
Vector quotient_tangent(const std::vector<Rational>& f, const std::vector<Rational>& d) {
  if (f.size() == 3) return {d[0], d[1], d[2]};
  Vector out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = d[k] * f[3] - f[k] * d[3];
  return out;
}

Tangents tangents(const Patch::Tensor& map, const std::array<Rational, 2>& at) {
  const std::vector<Rational> f = evaluate(map, at);
  Tangents out;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    // The last differences of de Casteljau's scheme.
    std::vector<Rational> d;
    const int n = map.degree(axis);
    const auto value = [&](int from) {
      auto degrees = map.degrees();
      degrees[axis] = n - 1;
      Patch::Tensor part(degrees, map.num_components(), map.is_rational());
      const auto columns = static_cast<std::size_t>(map.degree(1) + 1),
                 part_columns = static_cast<std::size_t>(degrees[1] + 1);
      for (int c = 0; c < map.num_components(); ++c)
        for (std::size_t i = 0; i <= static_cast<std::size_t>(degrees[0]); ++i)
          for (std::size_t j = 0; j < part_columns; ++j) {
            const std::size_t shift = static_cast<std::size_t>(from);
            part.component(c)[i * part_columns + j] = map.component(
                c)[(axis == 0 ? i + shift : i) * columns + (axis == 0 ? j : j + shift)];
          }
      return evaluate(part, at);
    };
    const std::vector<Rational> a = value(0), b = value(1);
    for (std::size_t k = 0; k < a.size(); ++k) d.push_back(b[k] - a[k]);
    out[axis] = quotient_tangent(f, d);
  }
  return out;
}

std::vector<Rational> values_of(const Patch::Triangle& map, const Barycentric<Rational>& at,
                                const Barycentric<Rational>* along) {
  std::vector<Rational> out;
  for (int c = 0; c < map.num_components(); ++c) {
    std::vector<Rational> work(map.component(c).begin(), map.component(c).end());
    int degree = map.degree();
    if (along != nullptr) internal::set_argument(work.data(), degree--, *along);
    for (; degree > 0; --degree) internal::set_argument(work.data(), degree, at);
    out.push_back(work.front());
  }
  return out;
}

Tangents tangents(const Patch::Triangle& map, const Barycentric<Rational>& at) {
  const std::vector<Rational> f = values_of(map, at, nullptr);
  const Barycentric<Rational> to_1{-1, 1, 0}, to_2{-1, 0, 1};
  return {quotient_tangent(f, values_of(map, at, &to_1)),
          quotient_tangent(f, values_of(map, at, &to_2))};
}

// A point of the domain of a patch: (u, v), or two barycentric coordinates.
using DomainPlace = std::array<Rational, 2>;

Tangents tangents(const Patch& patch, const DomainPlace& at) {
  if (!patch.is_triangle()) return tangents(patch.tensor(), at);
  return tangents(patch.triangle(), {Rational(1) - at[0] - at[1], at[0], at[1]});
}

// The point at t of a side, in its direction of travel.
DomainPlace on_side(const Patch& patch, std::uint32_t side, const Rational& t) {
  const Rational rest = Rational(1) - t;
  if (patch.is_triangle()) {
    if (side == 0) return {t, 0};
    return side == 1 ? DomainPlace{rest, t} : DomainPlace{0, rest};
  }
  switch (side) {
    case 0: return {t, 0};
    case 1: return {1, t};
    case 2: return {rest, 1};
    default: return {0, rest};
  }
}

// The derivative along a side, in its direction of travel.
Vector along_side(const Patch& patch, std::uint32_t side, const Tangents& t) {
  if (patch.is_triangle()) {
    if (side == 0) return t[0];
    return side == 1 ? minus(t[1], t[0]) : negated(t[1]);
  }
  return side < 2 ? t[side] : negated(t[side - 2]);
}

std::vector<Vector> control_points(const Patch& patch) {
  std::vector<Vector> out;
  for (std::size_t i = 0; i < patch.num_control(); ++i) {
    Vector p;
    for (int k = 0; k < 3; ++k) {
      p[static_cast<std::size_t>(k)] = patch.component(k)[i];
      if (patch.is_rational()) p[static_cast<std::size_t>(k)] /= patch.component(3)[i];
    }
    out.push_back(std::move(p));
  }
  return out;
}

Vector middle_normal(const Patch& patch) {
  const Rational part = Rational(1) / Rational(patch.is_triangle() ? 3 : 2);
  const Tangents t = tangents(patch, {part, part});
  return crossed(t[0], t[1]);
}

// The normal of a patch in a plane.
std::optional<Vector> flat_normal(const Patch& patch) {
  const Vector n = middle_normal(patch);
  if (is_zero(n)) return std::nullopt;
  const std::vector<Vector> points = control_points(patch);
  for (const Vector& p : points)
    if (dotted(n, minus(p, points[0])).sign() != 0) return std::nullopt;
  return n;
}

// The direction of a side in a straight line, from its start to its end.
std::optional<Vector> straight_direction(const Patch& patch, std::uint32_t side) {
  const std::vector<Vector> points = control_points(patch);
  const std::size_t n = patch.side_length(side);
  const Vector& start = points[patch.side_index(side, 0)];
  const Vector d = minus(points[patch.side_index(side, n - 1)], start);
  for (std::size_t i = 1; i + 1 < n; ++i)
    if (!is_zero(crossed(d, minus(points[patch.side_index(side, i)], start)))) return std::nullopt;
  if (is_zero(d)) return std::nullopt;
  return d;
}

Sector plane(const Vector& normal, const Vector& u) {
  const Direction n = direction(normal), d = direction(u), w = cross(n, d);
  return {n, {}, {d, w, -d, -w, d}};
}
// To the left of a side, seen from the normal's tip.
Sector half_plane(const Vector& normal, const Vector& along) {
  const Direction n = direction(normal), d = direction(along), w = cross(n, d);
  return {n, {w}, {d, w, -d}};
}

// A vector in the plane of the normal.
Vector any_across(const Vector& normal) {
  const std::size_t k = normal[0].sign() != 0 ? 0 : normal[1].sign() != 0 ? 1 : 2;
  Vector unit;
  unit[(k + 1) % 3] = Rational(1);
  return crossed(normal, unit);
}

class ConeBuilder {
 public:
  // False: the normal is 0 there.
  bool add_interior(const Patch& patch, const DomainPlace& at) {
    const Tangents t = tangents(patch, at);
    const Vector n = crossed(t[0], t[1]);
    if (is_zero(n)) return false;
    out_.sectors.push_back(plane(n, t[0]));
    note(patch);
    return true;
  }
  bool add_side(const Patch& patch, std::uint32_t side, const Rational& at) {
    const Tangents t = tangents(patch, on_side(patch, side, at));
    const Vector n = crossed(t[0], t[1]);
    if (is_zero(n)) return false;
    out_.sectors.push_back(half_plane(n, along_side(patch, side, t)));
    note(patch);
    return true;
  }
  bool add_corner(const Patch& patch, std::uint32_t corner) {
    const Tangents t = tangents(patch, on_side(patch, corner, 0));
    const Vector n = crossed(t[0], t[1]);
    if (is_zero(n)) return false;
    const std::uint32_t before = (corner + patch.num_sides() - 1) % patch.num_sides();
    const Direction normal = direction(n), ahead = direction(along_side(patch, corner, t)),
                    back = -direction(along_side(patch, before, t));
    out_.sectors.push_back({normal, {cross(normal, ahead), -cross(normal, back)}, {ahead, back}});
    note(patch);
    return true;
  }
  // Places whose parameters are irrational: of flat patches and straight sides only.
  bool add_flat_interior(const Patch& patch) {
    const auto n = flat_normal(patch);
    if (!n) return false;
    out_.sectors.push_back(plane(*n, any_across(*n)));
    return true;
  }
  bool add_flat_side(const Patch& patch, std::uint32_t side) {
    const auto n = flat_normal(patch);
    const auto along = straight_direction(patch, side);
    if (!n || !along) return false;
    out_.sectors.push_back(half_plane(*n, *along));
    return true;
  }
  // Nothing if two sectors have more than rims in common: then they do not tell which directions are inside.
  std::optional<TangentCone> take() {
    for (std::size_t i = 0; i < out_.sectors.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (overlap(out_.sectors[i], out_.sectors[k])) return std::nullopt;
    return std::move(out_);
  }

 private:
  static bool overlap(const Sector& a, const Sector& b) {
    if (is_parallel(a.normal, b.normal)) {
      const auto inner = [](const Sector& s) { return s.rays[0] + s.rays[1]; };
      const auto has_ray_inside = [](const Sector& s, const Sector& of) {
        return std::any_of(of.rays.begin(), of.rays.end(),
                           [&](const Direction& d) { return s.holds(d); });
      };
      return a.holds(inner(b)) || b.holds(inner(a)) || has_ray_inside(a, b) || has_ray_inside(b, a);
    }
    const Direction common = cross(a.normal, b.normal);
    for (const Direction& d : {common, -common})
      if ((a.holds(d) && b.contains(d)) || (a.contains(d) && b.holds(d))) return true;
    return false;
  }
  void note(const Patch& patch) { out_.is_flat = out_.is_flat && flat_normal(patch).has_value(); }

  TangentCone out_;
};

// Where a point lies: on a side of the square form, which is a side of the patch, or none.
struct SquareSide {
  std::uint32_t side;
  const AlgebraicNumber* along;
  bool is_downward;
};

bool equals(const AlgebraicNumber& a, std::int64_t value) {
  return a.is_rational() && a.lo == Rational(value);
}

}  // namespace

PatchCones::PatchCones(const PatchComplex& complex)
    : complex_(complex), corners_(complex.num_vertices()) {
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p)
    for (std::uint32_t c = 0; c < complex.patch(p).num_sides(); ++c)
      corners_[complex.vertex({p, c})].push_back({p, c});
}

std::optional<TangentCone> PatchCones::at(const OnPatch& where) const {
  const Patch& patch = complex_.patch(where.patch);
  const AlgebraicNumber &u = where.parameters[0], &v = where.parameters[1];
  std::vector<SquareSide> sides;
  if (equals(v, 0)) sides.push_back({0, &u, false});
  if (equals(u, 1)) sides.push_back({1, &v, false});
  if (equals(v, 1)) sides.push_back({2, &u, true});
  if (equals(u, 0)) sides.push_back({3, &v, true});
  ConeBuilder cone;
  const bool is_corner_of_triangle = patch.is_triangle() && equals(u, 0);
  if (sides.empty()) {
    const bool is_known = u.is_rational() && v.is_rational();
    const auto place = [&]() -> DomainPlace {
      if (!patch.is_triangle()) return {u.lo, v.lo};
      return {u.lo * (Rational(1) - v.lo), u.lo * v.lo};
    };
    if (!(is_known ? cone.add_interior(patch, place()) : cone.add_flat_interior(patch)))
      return std::nullopt;
    return cone.take();
  }
  if (sides.size() == 1 && !is_corner_of_triangle) {
    const auto& [side, along, is_downward] = sides[0];
    if (complex_.is_collapsed({where.patch, side})) return std::nullopt;
    const PatchSide mate = *complex_.mate({where.patch, side});
    const Patch& other = complex_.patch(mate.patch);
    if (along->is_rational()) {
      const Rational t = is_downward ? Rational(1) - along->lo : along->lo;
      if (!cone.add_side(patch, side, t) || !cone.add_side(other, mate.side, Rational(1) - t))
        return std::nullopt;
    } else if (!cone.add_flat_side(patch, side) || !cone.add_flat_side(other, mate.side)) {
      return std::nullopt;
    }
    return cone.take();
  }
  // Corner c is where side c starts.
  std::uint32_t corner = 0;
  if (!is_corner_of_triangle)
    corner = equals(v, 0) ? (equals(u, 0) ? 0 : 1) : (equals(u, 1) ? 2 : 3);
  for (const PatchCorner& c : corners_[complex_.vertex({where.patch, corner})]) {
    const Patch& at_vertex = complex_.patch(c.patch);
    const std::uint32_t before = (c.corner + at_vertex.num_sides() - 1) % at_vertex.num_sides();
    if (complex_.is_collapsed({c.patch, c.corner}) || complex_.is_collapsed({c.patch, before}) ||
        !cone.add_corner(at_vertex, c.corner))
      return std::nullopt;
  }
  return cone.take();
}

}  // namespace veritope
