// SPDX-License-Identifier: LGPL-3.0-or-later
#include "examples/esc_figures/chain_part.h"

#include "predicates/orient3d.h"
#include "robust/base/check.h"
#include "solids/chain/free_form_cell.h"

using namespace veritope;

namespace {

Vec3d exact_double(const PatchPoint& p) {
  const Vec3d out{nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
  for (int k = 0; k < 3; ++k)
    VT_CHECK(Rational::from_double(out[k]) == p[static_cast<std::size_t>(k)],
             "corners are vertices of a mesh");
  return out;
}

}  // namespace

ChainPart::ChainPart(const PatchComplex& complex, std::uint32_t first, std::uint32_t last,
                     const Vec3d& origin)
    : origin_(origin) {
  const int scale = scale_of(complex);
  for (std::uint32_t p = first; p < last; ++p) {
    const Patch& patch = complex.patch(p);
    for (const BaseTriangle& base : base_triangles(patch))
      bases_.push_back({exact_double(base[0]), exact_double(base[1]), exact_double(base[2])});
    if (!patch.is_flat_triangle()) cells_.emplace_back(free_form_cell(patch, scale, 0, 0), scale);
  }
}

// Its coefficient in the interior of the simplex, 0 off it, nothing on its sides.
std::optional<int> ChainPart::simplex_value(const Base& base, const Vec3d& q) const {
  const auto& [a, b, c] = base;
  const Sign sign = orient3d(origin_, a, b, c);
  if (sign == 0) return 0;
  bool is_on_side = false;
  for (const Sign side : {orient3d(q, a, b, c), orient3d(origin_, q, b, c),
                          orient3d(origin_, a, q, c), orient3d(origin_, a, b, q)}) {
    if (side * sign == Sign::kNegative) return 0;
    is_on_side = is_on_side || side == 0;
  }
  if (is_on_side) return std::nullopt;
  return to_int(sign);
}

std::optional<int> ChainPart::value(const Vec3d& q) const {
  int sum = 0;
  for (const Base& base : bases_) {
    const auto value = simplex_value(base, q);
    if (!value) return std::nullopt;
    sum += *value;
  }
  constexpr int kLevels = 64;
  for (const PatchRays& cell : cells_) {
    const RayPoint point(q, cell.scale());
    if (!meets(cell.hull(), point.box())) continue;
    const RayCount count =
        cell.count_some(point, 0, static_cast<std::uint32_t>(cell.num_patches()), kLevels);
    if (count.state != RayCount::State::kCounted) return std::nullopt;
    for (const auto& [shell, winding] : count.windings) sum += winding;
  }
  return sum;
}
