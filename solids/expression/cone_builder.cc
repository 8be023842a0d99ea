// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/cone_builder_internal.h"

#include <algorithm>
#include <utility>

#include "solids/expression/enclosed_place_internal.h"

namespace veritope::internal {
namespace {

// A next row that turns by a half turn or more is cut into up to 2^kMostCuts parts.
constexpr int kMostCuts = 6;

Direction direction(const Vector& a) {
  Integer unit(1);
  for (const Rational& x : a) unit = lcm(unit, x.denominator());
  std::array<Dyadic, 3> out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = Dyadic(a[k].numerator() * divide_exactly(unit, a[k].denominator()));
  return Direction(std::move(out));
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
// Less than a half turn, counter-clockwise.
Sector sector_between(const Vector& normal, const Vector& from, const Vector& to) {
  const Direction n = direction(normal), a = direction(from), b = direction(to);
  return {n, {cross(n, a), -cross(n, b)}, {a, b}};
}

// A vector in the plane of the normal.
Vector any_across(const Vector& normal) {
  const std::size_t k = normal[0].sign() != 0 ? 0 : normal[1].sign() != 0 ? 1 : 2;
  Vector unit;
  unit[(k + 1) % 3] = Rational(1);
  return crossed(normal, unit);
}

SheetRim rim_along(const Patch& patch, std::uint32_t side, const Rational& at) {
  SheetRim out;
  out.is_straight = straight_direction(patch, side).has_value();
  if (!out.is_straight) out.patch = &patch;
  out.side = side;
  out.at = at;
  return out;
}

std::uint32_t side_before(const Patch& patch, std::uint32_t side) {
  return (side + patch.num_sides() - 1) % patch.num_sides();
}

bool overlap(const Sector& a, const Sector& b) {
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

// ---- collapsed sides

// Vectors along which the patch leaves a collapsed side, as coefficients of a Bezier curve along it: the derivative
// across the side is a positive multiple of the curve.
using Fan = std::vector<Vector>;

// The place of a control point in a component: the i-th one of the row beside a side, against its direction of travel.
std::size_t next_row_index(const Patch& patch, std::uint32_t side, std::size_t i) {
  if (patch.is_triangle()) {
    // Barycentric indices: 1 at the opposite corner.
    const int n = patch.triangle().degree();
    std::array<int, 3> at{};
    at[(side + 2) % 3] = 1;
    at[(side + 1) % 3] = n - 1 - static_cast<int>(i);
    at[side] = static_cast<int>(i);
    return triangle_index(at[1], at[2]);
  }
  const auto [m, n] = patch.tensor().degrees();
  const auto columns = static_cast<std::size_t>(n + 1);
  const auto last_u = static_cast<std::size_t>(m), last_v = static_cast<std::size_t>(n);
  switch (side) {
    case 0: return (last_u - i) * columns + 1;
    case 1: return (last_u - 1) * columns + (last_v - i);
    case 2: return i * columns + (last_v - 1);
    default: return columns + i;
  }
}

Fan fan_of(const Patch& patch, std::uint32_t side) {
  const std::size_t count = patch.side_length(side) - (patch.is_triangle() ? 1 : 0);
  const Vector apex = jet(patch.side(side), Rational(0)).at;
  Fan out;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = next_row_index(patch, side, i);
    const Rational weight = patch.is_rational() ? patch.component(3)[at] : Rational(1);
    Vector d;
    for (std::size_t k = 0; k < 3; ++k)
      d[k] = patch.component(static_cast<int>(k))[at] - weight * apex[k];
    out.push_back(std::move(d));
  }
  return out;
}

// Its normal, if it is in one plane and turns at its ends; of two normals the one around which it turns
// counter-clockwise at its start.
std::optional<Vector> normal_of(const Fan& fan) {
  if (fan.size() < 2) return std::nullopt;
  const Vector n = crossed(fan[0], fan[1]);
  if (is_zero(n) || std::any_of(fan.begin(), fan.end(),
                                [&](const Vector& d) { return dotted(n, d).sign() != 0; }))
    return std::nullopt;
  return n;
}

// Whether all coefficients are in order, within less than a half turn: then the curve turns everywhere, since a x a' is
// a combination of the products of two of them, with positive numbers, those of the ends included.
bool turns_within_half(const Fan& fan, const Vector& n) {
  const auto turn_of = [&](std::size_t i, std::size_t k) {
    return dotted(n, crossed(fan[i], fan[k])).sign();
  };
  for (std::size_t i = 0; i < fan.size(); ++i)
    for (std::size_t k = i + 1; k < fan.size(); ++k)
      if (turn_of(i, k) < 0) return false;
  return turn_of(0, 1) > 0 && turn_of(fan.size() - 2, fan.size() - 1) > 0 &&
         turn_of(0, fan.size() - 1) > 0;
}

std::pair<Fan, Fan> halves(Fan fan) {
  Fan left, right(fan.size());
  const Rational half = Rational(1) / Rational(2);
  for (std::size_t count = fan.size(); count > 0; --count) {
    left.push_back(fan[0]);
    right[count - 1] = fan[count - 1];
    for (std::size_t i = 0; i + 1 < count; ++i)
      for (std::size_t k = 0; k < 3; ++k) fan[i][k] = half * (fan[i][k] + fan[i + 1][k]);
  }
  return {std::move(left), std::move(right)};
}

struct FanPart {
  Fan fan;
  Rational from, to;  // parameters along the fan
};

bool cut_fan(FanPart part, const Vector& n, int cuts, std::vector<FanPart>& out) {
  if (turns_within_half(part.fan, n)) {
    out.push_back(std::move(part));
    return true;
  }
  if (cuts == 0) return false;
  auto [left, right] = halves(std::move(part.fan));
  const Rational middle = (part.from + part.to) / Rational(2);
  return cut_fan({std::move(left), part.from, middle}, n, cuts - 1, out) &&
         cut_fan({std::move(right), middle, part.to}, n, cuts - 1, out);
}

}  // namespace

ConeSheet& ConeBuilder::add(Sector sector, const Patch& patch, std::uint32_t number) {
  ConeSheet sheet;
  sheet.number = number;
  sheet.is_flat = flat_normal(patch).has_value();
  if (!sheet.is_flat) sheet.patch = &patch;
  out_.is_flat = out_.is_flat && sheet.is_flat;
  out_.sectors.push_back(std::move(sector));
  out_.sheets.push_back(std::move(sheet));
  return out_.sheets.back();
}

bool ConeBuilder::add_interior(const Patch& patch, std::uint32_t number, const DomainPlace& at) {
  const PatchJet j = jet(patch, at);
  const Vector n = crossed(j.derivative[0], j.derivative[1]);
  if (is_zero(n)) return false;
  add(plane(n, j.derivative[0]), patch, number).at = at;
  return true;
}

bool ConeBuilder::add_side(const Patch& patch, std::uint32_t number, std::uint32_t side,
                           const Rational& at) {
  const DomainPlace place = on_side(patch, side, at);
  const PatchJet j = jet(patch, place);
  const Vector n = crossed(j.derivative[0], j.derivative[1]);
  if (is_zero(n)) return false;
  ConeSheet& sheet = add(half_plane(n, along_side(patch, side, j)), patch, number);
  sheet.at = place;
  sheet.rims = {rim_along(patch, side, at), rim_along(patch, side, at)};
  return true;
}

bool ConeBuilder::add_corner(const Patch& patch, std::uint32_t number, std::uint32_t corner) {
  const DomainPlace place = on_side(patch, corner, 0);
  const PatchJet j = jet(patch, place);
  const Vector n = crossed(j.derivative[0], j.derivative[1]);
  if (is_zero(n)) return false;
  const std::uint32_t before = side_before(patch, corner);
  ConeSheet& sheet =
      add(sector_between(n, along_side(patch, corner, j), negated(along_side(patch, before, j))),
          patch, number);
  sheet.at = place;
  sheet.rims = {rim_along(patch, corner, 0), rim_along(patch, before, 1)};
  return true;
}

bool ConeBuilder::add_pole(const Patch& patch, std::uint32_t number, std::uint32_t side) {
  Fan fan = fan_of(patch, side);
  const auto n = normal_of(fan);
  std::vector<FanPart> parts;
  if (!n || !cut_fan({std::move(fan), 0, 1}, *n, kMostCuts, parts)) return false;
  SheetRim cut;
  cut.is_cut = true;
  const std::uint32_t after = (side + 1) % patch.num_sides();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const FanPart& part = parts[i];
    ConeSheet& sheet = add(sector_between(*n, part.fan.front(), part.fan.back()), patch, number);
    sheet.pole = side;
    sheet.pole_part = {Rational(1) - part.to, Rational(1) - part.from};
    sheet.rims = {i == 0 ? rim_along(patch, after, 0) : cut,
                  i + 1 == parts.size() ? rim_along(patch, side_before(patch, side), 1) : cut};
  }
  return true;
}

bool ConeBuilder::add_enclosed_interior(const Patch& patch, std::uint32_t number,
                                        const std::array<ExactInterval, 2>& at) {
  ConeSheet sheet;
  sheet.number = number;
  sheet.is_flat = out_.is_flat = false;
  sheet.patch = &patch;
  out_.sheets.push_back(std::move(sheet));
  out_.enclosure = {at, jet_enclosure(patch, at).normal};
  return true;
}

void ConeBuilder::add_enclosed_edge(const std::array<const Patch*, 2>& patches,
                                    const std::array<PatchSide, 2>& sides,
                                    const ExactInterval& along) {
  ConeSheet sheet;
  sheet.number = sides[0].patch;
  sheet.is_flat = out_.is_flat = false;
  sheet.patch = patches[0];
  out_.sheets.push_back(std::move(sheet));
  const ExactInterval back{Rational(1) - along.hi, Rational(1) - along.lo};
  TangentCone::EnclosedEdge edge;
  EnclosedVector travel;
  for (std::size_t i = 0; i < 2; ++i) {
    const JetEnclosure jet = jet_enclosure(
        *patches[i], side_enclosure(*patches[i], sides[i].side, i == 0 ? along : back));
    edge.normals[i] = jet.normal;
    if (i == 0) travel = along_side(*patches[0], sides[0].side, jet);
  }
  for (const Patch* patch : patches)
    if (const auto n = flat_normal(*patch)) edge.plane = plane(*n, any_across(*n));
  // The first patch lies to the left of the travel, seen from the tip of its normal, and the second one to the right.
  edge.convexity = sign_of(dotted(crossed(edge.normals[0], edge.normals[1]), travel));
  out_.edge = std::move(edge);
}

bool ConeBuilder::add_flat_interior(const Patch& patch, std::uint32_t number) {
  const auto n = flat_normal(patch);
  if (!n) return false;
  add(plane(*n, any_across(*n)), patch, number);
  return true;
}

bool ConeBuilder::add_flat_side(const Patch& patch, std::uint32_t number, std::uint32_t side) {
  const auto n = flat_normal(patch);
  const auto along = straight_direction(patch, side);
  if (!n || !along) return false;
  add(half_plane(*n, *along), patch, number);  // its rims are straight
  return true;
}

std::optional<TangentCone> ConeBuilder::take() {
  for (std::size_t i = 0; i < out_.sectors.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (overlap(out_.sectors[i], out_.sectors[k])) return std::nullopt;
  return std::move(out_);
}

}  // namespace veritope::internal
