// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/base_side.h"

#include <utility>

#include "robust/base/parallel.h"
#include "solids/chain/exact_vector_internal.h"
#include "solids/chain/free_form_cell.h"
#include "solids/chain/literal_sign_internal.h"
#include "splines/bezier_triangle_algebra.h"

namespace veritope {
namespace {

using internal::Decision;

BezierTriangle<Rational> height_over(const BaseTriangle& base, const ExactPoint& normal,
                                     const Patch::Triangle& map) {
  const Rational offset = internal::dot(normal, base[0]);
  std::vector<Rational> out;
  for (std::size_t i = 0; i < map.count(); ++i) {
    Rational v = map.is_rational() ? -(offset * map.component(3)[i]) : -offset;
    for (std::size_t k = 0; k < 3; ++k) v += normal[k] * map.component(static_cast<int>(k))[i];
    out.push_back(std::move(v));
  }
  return BezierTriangle<Rational>(map.degree(), 1, false, std::move(out));
}

BezierTriangle<Rational> negated(BezierTriangle<Rational> f) {
  for (Rational& c : f.coefficients()) c.negate();
  return f;
}

}  // namespace

std::vector<Patch::Triangle> triangles_of(const Patch& patch) {
  if (patch.is_triangle()) return {patch.triangle()};
  const Rational o(1), z;
  return {on_triangle<Rational>(patch.tensor(), {{{z, z}, {o, z}, {o, o}}}),
          on_triangle<Rational>(patch.tensor(), {{{z, z}, {o, o}, {z, o}}})};
}

BaseSide base_side(const Patch& patch) {
  if (patch.is_flat_triangle()) return BaseSide::kZero;
  bool has_plane = false, is_open = false, is_before = false, is_behind = false;
  const std::vector<Patch::Triangle> maps = triangles_of(patch);
  for (const BaseTriangle& base : base_triangles(patch)) {
    const ExactPoint normal =
        internal::cross(internal::minus(base[1], base[0]), internal::minus(base[2], base[0]));
    if (internal::is_zero(normal)) continue;
    has_plane = true;
    for (const Patch::Triangle& map : maps) {
      const auto h = height_over(base, normal, map);
      const auto before = internal::nowhere_negative(negated(h)),
                 behind = internal::nowhere_negative(h);
      is_before = is_before || before.decision == Decision::kViolated;
      is_behind = is_behind || behind.decision == Decision::kViolated;
      is_open = is_open || before.decision == Decision::kOpen || behind.decision == Decision::kOpen;
    }
  }
  if (is_before && is_behind) return BaseSide::kMixed;
  if (is_open || !has_plane) return BaseSide::kOpen;
  return is_before ? BaseSide::kPlus : is_behind ? BaseSide::kMinus : BaseSide::kZero;
}

void BaseSideCounts::add(BaseSide side) {
  ++(side == BaseSide::kPlus    ? plus
     : side == BaseSide::kMinus ? minus
     : side == BaseSide::kZero  ? zero
     : side == BaseSide::kMixed ? mixed
                                : open);
}

BaseSideCounts count_base_sides(std::span<const Patch> patches, unsigned jobs) {
  std::vector<BaseSide> sides(patches.size());
  parallel_for(patches.size(), 64, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) sides[i] = base_side(patches[i]);
  });
  BaseSideCounts out;
  for (const BaseSide side : sides) out.add(side);
  return out;
}

}  // namespace veritope
