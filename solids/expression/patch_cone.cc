// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/patch_cone.h"

#include "robust/base/check.h"
#include "solids/expression/cone_builder_internal.h"
#include "solids/expression/enclosed_place_internal.h"

namespace veritope {
namespace {

// Where a point lies: on a side of the square form, which is a side of the patch, or none.
struct SquareSide {
  std::uint32_t side;
  const AlgebraicNumber* along;
  bool is_downward;
};

bool equals(const AlgebraicNumber& a, std::int64_t value) {
  return a.is_rational() && a.lo == Rational(value);
}

bool add_vertex(const PatchComplex& complex, const std::vector<PatchCorner>& corners,
                internal::ConeBuilder& cone) {
  for (const PatchCorner& c : corners) {
    const Patch& patch = complex.patch(c.patch);
    const std::uint32_t before = (c.corner + patch.num_sides() - 1) % patch.num_sides();
    const bool starts_pole = complex.is_collapsed({c.patch, c.corner}),
               ends_pole = complex.is_collapsed({c.patch, before});
    if (starts_pole && ends_pole) return false;
    if (ends_pole) continue;  // the side's start is a corner at this vertex, too
    const bool is_added = starts_pole ? cone.add_pole(patch, c.patch, c.corner)
                                      : cone.add_corner(patch, c.patch, c.corner);
    if (!is_added) return false;
  }
  return true;
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
  internal::ConeBuilder cone;
  const bool is_corner_of_triangle = patch.is_triangle() && equals(u, 0);
  if (sides.empty()) {
    const auto place = domain_place(patch, where.parameters);
    const bool is_added =
        place ? cone.add_interior(patch, where.patch, *place)
              : cone.add_flat_interior(patch, where.patch) ||
                    cone.add_enclosed_interior(patch, where.patch,
                                               internal::domain_enclosure(patch, where.parameters));
    if (!is_added) return std::nullopt;
    return cone.take();
  }
  const bool is_on_side = sides.size() == 1 && !is_corner_of_triangle;
  if (is_on_side && !complex_.is_collapsed({where.patch, sides[0].side})) {
    const auto& [side, along, is_downward] = sides[0];
    const PatchSide mate = *complex_.mate({where.patch, side});
    const Patch& other = complex_.patch(mate.patch);
    if (along->is_rational()) {
      const Rational t = is_downward ? Rational(1) - along->lo : along->lo;
      if (!cone.add_side(patch, where.patch, side, t) ||
          !cone.add_side(other, mate.patch, mate.side, Rational(1) - t))
        return std::nullopt;
    } else if (!cone.add_flat_side(patch, where.patch, side) ||
               !cone.add_flat_side(other, mate.patch, mate.side)) {
      const ExactInterval at = internal::enclosed(*along);
      internal::ConeBuilder enclosed;
      enclosed.add_enclosed_edge(
          {&patch, &other}, {PatchSide{where.patch, side}, mate},
          is_downward ? ExactInterval{Rational(1) - at.hi, Rational(1) - at.lo} : at);
      return enclosed.take();
    }
    return cone.take();
  }
  // Corner c is where side c starts; both ends of a collapsed side are one vertex.
  std::uint32_t corner = 0;
  if (is_on_side)
    corner = sides[0].side;
  else if (!is_corner_of_triangle)
    corner = equals(v, 0) ? (equals(u, 0) ? 0 : 1) : (equals(u, 1) ? 2 : 3);
  if (!add_vertex(complex_, corners_[complex_.vertex({where.patch, corner})], cone))
    return std::nullopt;
  return cone.take();
}

std::optional<std::array<Rational, 2>> domain_place(const Patch& patch, const AlgebraicPair& at) {
  if (!at.is_rational()) return std::nullopt;
  const Rational &u = at[0].lo, &v = at[1].lo;
  if (!patch.is_triangle()) return std::array<Rational, 2>{u, v};
  return std::array<Rational, 2>{u * (Rational(1) - v), u * v};
}

}  // namespace veritope
