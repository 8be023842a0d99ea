// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/same_sheet_internal.h"

#include <algorithm>
#include <utility>

#include "solids/expression/patch_jet_internal.h"
#include "splines/de_casteljau.h"

namespace veritope::internal {
namespace {

// x -> at + linear (x - from): of the parameters of one patch to those of another one.
struct AffineChange {
  DomainPlace from, at;
  std::array<DomainPlace, 2> linear;  // its columns

  DomainPlace operator()(const DomainPlace& x) const {
    const Rational u = x[0] - from[0], v = x[1] - from[1];
    return {at[0] + linear[0][0] * u + linear[1][0] * v,
            at[1] + linear[0][1] * u + linear[1][1] * v};
  }
};

// The only change A that may serve in b = a(A): the one with equal derivatives.
std::optional<AffineChange> change_between(const Patch& a, const DomainPlace& at_a, const Patch& b,
                                           const DomainPlace& at_b) {
  const PatchJet ja = jet(a, at_a), jb = jet(b, at_b);
  const auto& [u, v] = ja.derivative;
  const Vector n = crossed(u, v);
  const Rational square = dotted(n, n);
  if (square.sign() == 0 || ja.at != jb.at) return std::nullopt;
  AffineChange out{at_b, at_a, {}};
  for (std::size_t k = 0; k < 2; ++k) {
    const Vector& x = jb.derivative[k];
    out.linear[k] = {dotted(crossed(x, v), n) / square, dotted(crossed(u, x), n) / square};
  }
  return out;
}

// The degrees of a in the parameters of b.
std::array<int, 2> composed_degrees(const Patch& a, const AffineChange& change) {
  if (a.is_triangle()) return {a.triangle().degree(), a.triangle().degree()};
  const auto [m, n] = a.tensor().degrees();
  const auto is_zero_at = [&](std::size_t column, std::size_t row) {
    return change.linear[column][row].sign() == 0;
  };
  if (is_zero_at(0, 1) && is_zero_at(1, 0)) return {m, n};
  if (is_zero_at(0, 0) && is_zero_at(1, 1)) return {n, m};
  return {m + n, m + n};
}

std::array<int, 2> degrees_of(const Patch& b) {
  if (b.is_triangle()) return {b.triangle().degree(), b.triangle().degree()};
  return b.tensor().degrees();
}

// Whether two homogeneous values are one point.
bool is_same_point(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  const Rational one(1);
  const Rational &wa = a.size() == 4 ? a[3] : one, &wb = b.size() == 4 ? b[3] : one;
  for (std::size_t k = 0; k < 3; ++k)
    if (a[k] * wb != b[k] * wa) return false;
  return true;
}

// Whether b = a(change): the difference of the cross products is a polynomial with as many coefficients as are tried.
bool is_composition(const Patch& b, const Patch& a, const AffineChange& change) {
  const std::array<int, 2> da = composed_degrees(a, change), db = degrees_of(b);
  std::array<int, 2> degrees;
  for (std::size_t k = 0; k < 2; ++k)
    degrees[k] = a.is_rational() || b.is_rational() ? da[k] + db[k] : std::max(da[k], db[k]);
  const auto node = [](int i, int n) { return n == 0 ? Rational(0) : Rational(i) / Rational(n); };
  for (int i = 0; i <= degrees[0]; ++i)
    for (int j = 0; j <= degrees[1]; ++j) {
      const DomainPlace x{node(i, degrees[0]), node(j, degrees[1])};
      if (!is_same_point(homogeneous_at(b, x), homogeneous_at(a, change(x)))) return false;
    }
  return true;
}

// The point of the domain at distance `depth` from the collapsed side: on the line to the side's opposite.
DomainPlace beside_pole(const Patch& patch, std::uint32_t side, const Rational& t,
                        const Rational& depth) {
  const DomainPlace on = on_side(patch, side, t);
  // The ends of the lines: the opposite corner of a triangle, the opposite point of a square.
  const DomainPlace to = patch.is_triangle() ? on_side(patch, (side + 2) % 3, 0)
                                             : on_side(patch, (side + 2) % 4, Rational(1) - t);
  return {on[0] + depth * (to[0] - on[0]), on[1] + depth * (to[1] - on[1])};
}

bool is_inside_domain(const Patch& patch, const DomainPlace& at) {
  if (at[0].sign() <= 0 || at[1].sign() <= 0) return false;
  return patch.is_triangle() ? at[0] + at[1] < Rational(1)
                             : at[0] < Rational(1) && at[1] < Rational(1);
}

// The middle of the cell of a grid that holds a corner of a box, if it is inside the domain.
std::optional<DomainPlace> cell_middle(const Patch& patch, const std::array<ExactInterval, 2>& box,
                                       int parts) {
  DomainPlace out;
  for (std::size_t k = 0; k < 2; ++k)
    out[k] =
        (rounded_down(box[k].lo * Rational(parts)) + Rational::power_of_two(-1)) / Rational(parts);
  if (!is_inside_domain(patch, out)) return std::nullopt;
  return out;
}

// Whether the image of a box is inside the domain: that of its corners is, and domains are convex.
bool maps_inside(const AffineChange& change, const std::array<ExactInterval, 2>& box,
                 const Patch& patch) {
  for (const Rational& u : {box[0].lo, box[0].hi})
    for (const Rational& v : {box[1].lo, box[1].hi})
      if (!is_inside_domain(patch, change({u, v}))) return false;
  return true;
}

// Where on its side a place is, if it is there.
std::optional<Rational> place_on_side(const Patch& patch, std::uint32_t side,
                                      const DomainPlace& at) {
  const DomainPlace from = on_side(patch, side, 0), to = on_side(patch, side, 1);
  const std::size_t k = from[0] != to[0] ? 0 : 1;
  const Rational t = (at[k] - from[k]) / (to[k] - from[k]);
  if (on_side(patch, side, t) != at) return std::nullopt;
  return t;
}

// Both have a pole at the apex. A point of b near it, in a direction that both sectors hold, is looked for in a; the
// derivatives there tell the change of parameters, which has to take b's collapsed side to a's, and the direction to a
// place between the rims of a.
bool is_same_at_poles(const SheetOf& a, const SheetOf& b) {
  const ConeSheet &sa = a.sheet(), &sb = b.sheet();
  if (!a.cone->place_of) return false;
  const Rational width = sb.pole_part[1] - sb.pole_part[0];
  for (int n = 2; n <= 8; n *= 2)
    for (int i = 1; i < n; i += 2) {
      const Rational t = sb.pole_part[0] + width * (Rational(i) / Rational(n));
      for (const int depth : {2, 8}) {
        const DomainPlace near = beside_pole(*sb.patch, *sb.pole, t, Rational(1) / Rational(depth));
        const PatchJet there = jet(*sb.patch, near);
        const auto found = a.cone->place_of(*sa.patch, there.at);
        if (!found) continue;
        const auto change = change_between(*sa.patch, *found, *sb.patch, near);
        if (!change || !is_composition(*sb.patch, *sa.patch, *change)) return false;
        const auto start =
            place_on_side(*sa.patch, *sa.pole, (*change)(on_side(*sb.patch, *sb.pole, 0)));
        const auto on =
            place_on_side(*sa.patch, *sa.pole, (*change)(on_side(*sb.patch, *sb.pole, t)));
        return start && on && *on > sa.pole_part[0] && *on < sa.pole_part[1];
      }
    }
  return false;
}

}  // namespace

bool is_same_surface(const SheetOf& a, const SheetOf& b) {
  const ConeSheet &sa = a.sheet(), &sb = b.sheet();
  if (!is_parallel(a.sector().normal, b.sector().normal)) return false;
  if (sa.is_flat || sb.is_flat) return sa.is_flat && sb.is_flat;
  if (sa.pole.has_value() != sb.pole.has_value()) return false;
  if (sa.pole) return is_same_at_poles(a, b) || is_same_at_poles(b, a);
  const auto change = change_between(*sa.patch, sa.at, *sb.patch, sb.at);
  return change && is_composition(*sb.patch, *sa.patch, *change);
}

int enclosed_tie(const TangentCone& a, const TangentCone& b) {
  const Patch &pa = *a.sheets[0].patch, &pb = *b.sheets[0].patch;
  if (&pa == &pb) return 1;
  const auto& box = b.enclosure->at;
  // A point of b that both have tells the change of parameters.
  for (const int parts : {1, 2, 4, 8, 16, 64, 1024}) {
    const std::optional<DomainPlace> near = cell_middle(pb, box, parts);
    if (!near) continue;
    const auto found = a.place_of(pa, jet(pb, *near).at);
    if (!found) continue;
    const auto change = change_between(pa, *found, pb, *near);
    if (!change || !is_composition(pb, pa, *change)) return 0;
    const auto& [x, y] = change->linear;
    const Sign turn = (x[0] * y[1] - x[1] * y[0]).sign();
    return maps_inside(*change, box, pa) ? to_int(turn) : 0;
  }
  return 0;
}

bool is_same_curve(const SheetRim& a, const SheetRim& b) {
  if (a.is_straight || b.is_straight) return a.is_straight && b.is_straight;
  const Patch::Curve ca = a.patch->side(a.side), cb = b.patch->side(b.side);
  const CurveJet ja = jet(ca, a.at), jb = jet(cb, b.at);
  const Rational square = dotted(ja.derivative, ja.derivative);
  if (square.sign() == 0 || ja.at != jb.at) return false;
  const Rational speed = dotted(ja.derivative, jb.derivative) / square;
  const bool is_rational = ca.is_rational() || cb.is_rational();
  const int degree =
      is_rational ? ca.degree(0) + cb.degree(0) : std::max(ca.degree(0), cb.degree(0));
  for (int i = 0; i <= degree; ++i) {
    const Rational x = Rational(i) / Rational(degree);
    if (!is_same_point(evaluate(cb, {x}), evaluate(ca, {a.at + speed * (x - b.at)}))) return false;
  }
  return true;
}

bool is_in_plane(const SheetRim& curve, const Sector& plane) {
  if (curve.is_straight) return true;  // its direction lies in the plane
  const Patch::Curve c = curve.patch->side(curve.side);
  const Vector apex = jet(c, curve.at).at;
  // n (c_i - w_i apex) = 0 for all control points; n in integers times a power of two.
  for (std::size_t i = 0; i < c.component(0).size(); ++i) {
    Rational sum(0);
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational w = c.is_rational() ? c.component(3)[i] : Rational(1);
      sum += plane.normal[k].to_rational() * (c.component(static_cast<int>(k))[i] - w * apex[k]);
    }
    if (sum.sign() != 0) return false;
  }
  return true;
}

}  // namespace veritope::internal
