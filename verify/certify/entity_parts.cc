// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/entity_parts.h"

#include <algorithm>
#include <utility>

namespace veritope {
namespace {

using Bounds = EntityParts::Bounds;

Bounds bounds_of(const DyadicInterval& t) { return {t.lower(), t.upper()}; }
Bounds mirrored(const Bounds& b) { return {Rational(1) - b[1], Rational(1) - b[0]}; }
std::array<double, 2> outward(const Bounds& b) { return {round_down(b[0]), round_up(b[1])}; }

std::vector<std::array<double, 2>> outward(const std::vector<Bounds>& bounds) {
  std::vector<std::array<double, 2>> out;
  for (const Bounds& b : bounds) out.push_back(outward(b));
  return out;
}
Bounds exactly(const std::array<double, 2>& b) {
  return {Rational::from_double(b[0]), Rational::from_double(b[1])};
}

}  // namespace

std::size_t EntityParts::entity_of(std::uint32_t patch) const {
  const auto next =
      std::upper_bound(entities_.begin(), entities_.end(), patch,
                       [](std::uint32_t p, const StarBoxEntity& e) { return p < e.first_patch; });
  return static_cast<std::size_t>(next - entities_.begin()) - 1;
}

Patch EntityParts::file_patch(std::uint32_t patch) const {
  return is_reversed(patch) ? reversed(complex_.patch(patch)) : complex_.patch(patch);
}

// Converts parameters of the tensor form of the file's patch.
std::vector<Bounds> EntityParts::on_tensor_form(std::uint32_t patch, const Bounds& s,
                                                const Bounds& t) const {
  if (!complex_.patch(patch).is_triangle()) return in_entity(patch, s, t);
  const Bounds back = mirrored(t);
  return {mirrored(s), {s[0] * back[0], s[1] * back[1]}, {s[0] * t[0], s[1] * t[1]}};
}

EntityPart EntityParts::of(const PatchRectangle& where) const {
  EntityPart out;
  out.entity = entity_of(where.patch);
  out.parameters =
      outward(on_tensor_form(where.patch, bounds_of(where.at[0]), bounds_of(where.at[1])));
  return out;
}

EntityPart EntityParts::of(const PatchPlace& where) const {
  EntityPart out;
  out.entity = entity_of(where.patch);
  for (const Rational& v : point_of(where)) out.parameters.push_back(outward(Bounds{v, v}));
  return out;
}

std::vector<Rational> EntityParts::point_of(const PatchPlace& where) const {
  std::vector<Rational> out;
  const auto& [s, t] = where.at;
  for (const Bounds& b : on_tensor_form(where.patch, {s, s}, {t, t})) out.push_back(b[0]);
  return out;
}

EntityPart EntityParts::of(const PatchPart& part) const {
  EntityPart out;
  out.entity = entity_of(part.patch);
  const bool is_back = is_reversed(part.patch);
  if (part.parameters.size() == 3) {
    out.parameters = part.parameters;
    if (is_back) std::swap(out.parameters[1], out.parameters[2]);
    return out;
  }
  const Bounds s = exactly(part.parameters[0]), t = exactly(part.parameters[1]);
  out.parameters = outward(is_back ? in_entity(part.patch, t, s) : in_entity(part.patch, s, t));
  return out;
}

EntityPart EntityParts::of(const SideArc& arc) const { return of(arc.side, bounds_of(arc.at)); }

EntityPart EntityParts::of(PatchSide side, const Bounds& along) const {
  EntityPart out;
  out.entity = entity_of(side.patch);
  const std::uint32_t n = complex_.patch(side.patch).num_sides();
  out.side = static_cast<std::uint8_t>(is_reversed(side.patch) ? n - 1 - side.side : side.side);
  out.parameters = outward(on_side(side, along));
  return out;
}

std::vector<Rational> EntityParts::point_of(PatchSide side, const Rational& t) const {
  std::vector<Rational> out;
  for (const Bounds& b : on_side(side, {t, t})) out.push_back(b[0]);
  return out;
}

std::vector<Bounds> EntityParts::on_side(PatchSide of, const Bounds& in_complex) const {
  const std::uint32_t n = complex_.patch(of.patch).num_sides();
  const bool is_back = is_reversed(of.patch);
  const std::uint32_t side = is_back ? n - 1 - of.side : of.side;
  const Bounds along = is_back ? mirrored(in_complex) : in_complex;
  const Rational zero(0), one(1);
  if (n == 3) {
    std::vector<Bounds> out(3, Bounds{zero, zero});
    out[(side + 1) % 3] = along;
    out[side] = mirrored(along);
    return out;
  }
  const Bounds rising = side < 2 ? along : mirrored(along);
  const Bounds end = side == 0 || side == 3 ? Bounds{zero, zero} : Bounds{one, one};
  return side % 2 == 0 ? in_entity(of.patch, rising, end) : in_entity(of.patch, end, rising);
}

// Converts parameters in [0,1]^2 of the file's patch to those of the surface.
std::vector<Bounds> EntityParts::in_entity(std::uint32_t patch, const Bounds& u,
                                           const Bounds& v) const {
  const StarBoxEntity& entity = entities_[entity_of(patch)];
  const auto& breaks = entity.breaks;
  if (breaks[0].empty()) return {u, v};
  const std::size_t piece = patch - entity.first_patch, columns = breaks[1].size() - 1;
  const std::size_t at[2] = {piece / columns, piece % columns};
  std::vector<Bounds> out;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Rational &lo = breaks[axis][at[axis]], &hi = breaks[axis][at[axis] + 1];
    const Bounds& b = axis == 0 ? u : v;
    out.push_back({lo + (hi - lo) * b[0], lo + (hi - lo) * b[1]});
  }
  return out;
}

}  // namespace veritope
