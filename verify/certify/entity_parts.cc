// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/entity_parts.h"

#include <algorithm>
#include <utility>

#include "verify/certify/parameter_text.h"

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
// By the affine map that takes 0 to lo and 1 to hi.
Bounds mapped(const Bounds& b, const Rational& lo, const Rational& hi) {
  return {lo + (hi - lo) * b[0], lo + (hi - lo) * b[1]};
}
constexpr const char* kParameters[] = {"u", "v", "w"};

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

std::uint64_t EntityParts::number_in_file(std::size_t entity) const {
  return entities_[entity].face ? entities_[entity].face->volume : entity;
}

std::string EntityParts::name(std::size_t entity) const {
  const auto& face = entities_[entity].face;
  if (!face) return entity_text(entity);
  return std::string("face ") + kParameters[face->axis] + " = " + number_text(face->at) + " of " +
         entity_text(face->volume);
}

std::string EntityParts::name_of(PatchSide side) const {
  const auto& face = entities_[entity_of(side.patch)].face;
  if (!face)
    return "side " + std::to_string(*of(side, {Rational(0), Rational(1)}).side) + " of " +
           name_of(side.patch);
  const std::vector<Bounds> at =
      in_volume(*face, on_side(side, {Rational(0), Rational(1)}), Bounds{face->at, face->at});
  std::string text;
  for (std::size_t k = 0; k < 3; ++k)
    if (at[k][0] == at[k][1])
      text += (text.empty() ? "edge " : ", ") + std::string(kParameters[k]) + " = " +
              number_text(at[k][0]);
  return text + " of " + entity_text(face->volume);
}

std::size_t EntityParts::parameter(std::uint32_t patch, std::size_t axis) const {
  const auto& face = entities_[entity_of(patch)].face;
  return face ? face->axes[axis] : axis;
}
std::string EntityParts::parameter_name(std::uint32_t patch, std::size_t axis) const {
  if (complex_.patch(patch).is_triangle()) return "b" + std::to_string(axis);
  return kParameters[parameter(patch, axis)];
}

template <typename Number>
std::vector<Number> EntityParts::in_volume(const VolumeFace& face, std::vector<Number> parameters,
                                           const Number& across) const {
  std::vector<Number> out(3, across);
  for (std::size_t k = 0; k < 2; ++k) out[face.axes[k]] = std::move(parameters[k]);
  return out;
}

EntityPart EntityParts::in_file(EntityPart part) const {
  const auto& face = entities_[part.entity].face;
  if (!face) return part;
  part.entity = face->volume;
  part.side.reset();
  part.face = static_cast<std::uint8_t>(2 * face->axis + face->end);
  part.parameters =
      in_volume(*face, std::move(part.parameters), outward(Bounds{face->at, face->at}));
  return part;
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
  return in_file(std::move(out));
}

EntityPart EntityParts::of(const PatchPlace& where) const {
  EntityPart out;
  out.entity = entity_of(where.patch);
  const auto& [s, t] = where.at;
  out.parameters = outward(on_tensor_form(where.patch, {s, s}, {t, t}));
  return in_file(std::move(out));
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
  return in_file(std::move(out));
}

EntityPart EntityParts::of(const SideArc& arc) const { return of(arc.side, bounds_of(arc.at)); }

EntityPart EntityParts::of(PatchSide side, const Bounds& along) const {
  EntityPart out;
  out.entity = entity_of(side.patch);
  const std::uint32_t n = complex_.patch(side.patch).num_sides();
  out.side = static_cast<std::uint8_t>(is_reversed(side.patch) ? n - 1 - side.side : side.side);
  out.parameters = outward(on_side(side, along));
  return in_file(std::move(out));
}

std::string EntityParts::point_text(PatchSide side, const Rational& t) const {
  std::vector<Bounds> at = on_side(side, {t, t});
  std::string names = at.size() == 3 ? "b0, b1, b2" : "u, v", numbers;
  const std::size_t entity = entity_of(side.patch);
  if (const auto& face = entities_[entity].face) {
    at = in_volume(*face, std::move(at), Bounds{face->at, face->at});
    names = "u, v, w";
  }
  for (const Bounds& b : at) numbers += (numbers.empty() ? "" : ", ") + number_text(b[0]);
  return "(" + names + ") = (" + numbers + ") of " + entity_text(number_in_file(entity));
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

// Converts parameters in [0,1]^2 of the file's patch to those of the surface, or, if that is a piece of a face, to
// those of the volume.
std::vector<Bounds> EntityParts::in_entity(std::uint32_t patch, const Bounds& u,
                                           const Bounds& v) const {
  const StarBoxEntity& entity = entities_[entity_of(patch)];
  const auto& breaks = entity.breaks;
  std::vector<Bounds> out = {u, v};
  if (!breaks[0].empty()) {
    const std::size_t piece = patch - entity.first_patch, columns = breaks[1].size() - 1;
    const std::size_t at[2] = {piece / columns, piece % columns};
    for (std::size_t axis = 0; axis < 2; ++axis)
      out[axis] = mapped(out[axis], breaks[axis][at[axis]], breaks[axis][at[axis] + 1]);
  }
  if (!entity.face || !entity.face->piece) return out;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto& [lo, hi] = (*entity.face->piece)[axis];
    out[axis] = mapped(out[axis], lo, hi);
  }
  return out;
}

}  // namespace veritope
