// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/refutation_finding.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "splines/de_casteljau.h"
#include "verify/certify/miranda_internal.h"

namespace veritope {
namespace {

using Bounds = std::array<Rational, 2>;

Bounds bounds_of(const DyadicInterval& t) { return {t.lower(), t.upper()}; }
Bounds mirrored(const Bounds& b) { return {Rational(1) - b[1], Rational(1) - b[0]}; }
std::array<double, 2> outward(const Bounds& b) { return {round_down(b[0]), round_up(b[1])}; }

std::string shortest(double v) {
  std::array<char, 32> text;
  return std::string(text.data(), std::to_chars(text.data(), text.data() + text.size(), v).ptr);
}
std::string point_text(const Point3d& p) {
  return "(" + shortest(p[0]) + ", " + shortest(p[1]) + ", " + shortest(p[2]) + ")";
}

// False if a coordinate lies beyond binary64.
bool is_finite(const Point3d& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

class FactFinder {
 public:
  FactFinder(const PatchComplex& complex, const std::vector<StarBoxEntity>& entities)
      : complex_(complex), entities_(entities) {}

  Finding operator()(const CrossingWitness& found) const {
    std::array<Patch, 2> patches{file_patch(found.sheets[0].patch),
                                 file_patch(found.sheets[1].patch)};
    const CrossingWitness w = with_reversed(
        complex_.patch(found.sheets[0].patch), complex_.patch(found.sheets[1].patch),
        {is_reversed(found.sheets[0].patch), is_reversed(found.sheets[1].patch)}, found);
    Finding out;
    out.code = "patches-crossing";
    for (const PatchRectangle& sheet : w.sheets) out.place.parts.push_back(part_of(sheet));
    out.place.near = middle_of(patches[0], w.sheets[0]);
    out.place.box = common(hull_of(patches[0], w.sheets[0]), hull_of(patches[1], w.sheets[1]));
    const std::uint64_t a = out.place.parts[0].entity, b = out.place.parts[1].entity;
    out.message =
        (a == b ? "entity " + std::to_string(a) + " crosses itself"
                : "entities " + std::to_string(a) + " and " + std::to_string(b) + " cross") +
        " near " + point_text(*out.place.near);
    return out;
  }

  Finding operator()(const SideWitness& found) const {
    Finding out;
    const std::size_t n = found.arcs.size();
    for (const SideArc& arc : found.arcs) out.place.parts.push_back(part_of(arc));
    const PatchPoint p = point_of(complex_, found);
    out.witness.point = RationalPoint{{p[0], p[1], p[2]}};
    out.place.near = {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
    const EntityPart& first = out.place.parts.front();
    const std::string side =
        "side " + std::to_string(*first.side) + " of entity " + std::to_string(first.entity);
    if (n == 1) {
      out.code = "side-open";
      out.message = side + " is an open border";
    } else if (n == 2) {
      out.code = "side-direction";
      out.message = side + " and side " + std::to_string(*out.place.parts[1].side) + " of entity " +
                    std::to_string(out.place.parts[1].entity) + " run in the same direction";
    } else {
      out.code = "side-overused";
      out.message = side + " and " + std::to_string(n - 1) + " other sides are one curve";
    }
    if (is_finite(*out.place.near)) out.message += ", near " + point_text(*out.place.near);
    return out;
  }

  Finding operator()(const ReversedShell& reversed) const {
    Finding out;
    out.code = "shell-turned";
    out.place.shell = reversed.shell;
    out.witness.winding = reversed.winding;
    const std::uint32_t patch = complex_.shells()[reversed.shell].first_patch;
    out.place.parts.push_back(
        part_of(PatchRectangle{patch, {DyadicInterval::whole(), DyadicInterval::whole()}}));
    out.message =
        "the winding number is " + std::to_string(reversed.winding) +
        " on the inner side of shell " + std::to_string(reversed.shell) + " (entity " +
        std::to_string(out.place.parts[0].entity) + ") and " +
        std::to_string(reversed.winding - 1) +
        " on its outer side, not 1 and 0: its normals point the wrong way, or it is wrongly "
        "nested";
    return out;
  }

 private:
  std::size_t entity_of(std::uint32_t patch) const {
    const auto next =
        std::upper_bound(entities_.begin(), entities_.end(), patch,
                         [](std::uint32_t p, const StarBoxEntity& e) { return p < e.first_patch; });
    return static_cast<std::size_t>(next - entities_.begin()) - 1;
  }
  bool is_reversed(std::uint32_t patch) const { return entities_[entity_of(patch)].is_reversed; }
  Patch file_patch(std::uint32_t patch) const {
    return is_reversed(patch) ? reversed(complex_.patch(patch)) : complex_.patch(patch);
  }

  // The rectangle in the parameters of the file's patch.
  EntityPart part_of(const PatchRectangle& where) const {
    const std::size_t e = entity_of(where.patch);
    EntityPart out;
    out.entity = e;
    const Bounds s = bounds_of(where.at[0]), t = bounds_of(where.at[1]);
    if (!complex_.patch(where.patch).is_triangle()) {
      out.parameters = in_entity(e, where.patch, s, t);
      return out;
    }
    const Bounds back = mirrored(t);
    out.parameters = {outward(mirrored(s)), outward({s[0] * back[0], s[1] * back[1]}),
                      outward({s[0] * t[0], s[1] * t[1]})};
    return out;
  }
  // The arc in the parameters of its entity; `arc` has those of the complex's patch.
  EntityPart part_of(const SideArc& arc) const {
    const std::uint32_t p = arc.side.patch, n = complex_.patch(p).num_sides();
    const std::size_t e = entity_of(p);
    const bool is_back = entities_[e].is_reversed;
    const std::uint32_t side = is_back ? n - 1 - arc.side.side : arc.side.side;
    const Bounds along = is_back ? mirrored(bounds_of(arc.at)) : bounds_of(arc.at);
    EntityPart out;
    out.entity = e;
    out.side = static_cast<std::uint8_t>(side);
    const Rational zero(0), one(1);
    if (n == 3) {
      out.parameters.assign(3, {0, 0});
      out.parameters[(side + 1) % 3] = outward(along);
      out.parameters[side] = outward(mirrored(along));
      return out;
    }
    const Bounds rising = side < 2 ? along : mirrored(along);
    const Bounds end = side == 0 || side == 3 ? Bounds{zero, zero} : Bounds{one, one};
    out.parameters = side % 2 == 0 ? in_entity(e, p, rising, end) : in_entity(e, p, end, rising);
    return out;
  }
  // Converts parameters in [0,1]^2 to those of the surface.
  std::vector<std::array<double, 2>> in_entity(std::size_t e, std::uint32_t patch, const Bounds& u,
                                               const Bounds& v) const {
    const auto& breaks = entities_[e].breaks;
    if (breaks[0].empty()) return {outward(u), outward(v)};
    const std::size_t piece = patch - entities_[e].first_patch, columns = breaks[1].size() - 1;
    const std::size_t at[2] = {piece / columns, piece % columns};
    std::vector<std::array<double, 2>> out;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Rational &lo = breaks[axis][at[axis]], &hi = breaks[axis][at[axis] + 1];
      const Bounds& b = axis == 0 ? u : v;
      out.push_back(outward({lo + (hi - lo) * b[0], lo + (hi - lo) * b[1]}));
    }
    return out;
  }

  static Point3d middle_of(const Patch& patch, const PatchRectangle& where) {
    std::array<Rational, 2> at;
    for (std::size_t axis = 0; axis < 2; ++axis)
      at[axis] = (where.at[axis].lower() + where.at[axis].upper()) / Rational(2);
    const std::vector<Rational> p = evaluate(tensor_form(patch), at);
    return approx_point(std::span<const Rational>(p));
  }
  static Box3d hull_of(const Patch& patch, const PatchRectangle& where) {
    BezierSurface<Rational> map = tensor_form(patch);
    for (std::size_t axis = 0; axis < 2; ++axis)
      map = internal::part_along(std::move(map), axis, where.at[axis].lower(),
                                 where.at[axis].upper());
    Box3d out;
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<Rational, 3> y{};
      y[k] = Rational(1);
      const auto range = internal::control_values(map, y, std::nullopt);
      out.lo[k] = round_down(range.least), out.hi[k] = round_up(range.greatest);
    }
    return out;
  }
  const PatchComplex& complex_;
  const std::vector<StarBoxEntity>& entities_;
};

}  // namespace

Finding finding_of(const PatchComplex& complex, const std::vector<StarBoxEntity>& entities,
                   const PatchRefutation& refutation) {
  return std::visit(FactFinder(complex, entities), refutation);
}

}  // namespace veritope
