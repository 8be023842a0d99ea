// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/patch_place.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace veritope {
namespace {

struct Vertex {
  std::uint32_t number;
  friend bool operator==(const Vertex&, const Vertex&) = default;
};
// The parameter is that of the lesser side of the edge.
struct EdgePoint {
  PatchSide side;
  Rational at;
  friend bool operator==(const EdgePoint&, const EdgePoint&) = default;
};
using SurfacePoint = std::variant<Vertex, EdgePoint, PatchPlace>;

// The parameter on a side, from 0 where the side starts to 1; nothing if the place is not on it.
std::optional<Rational> on_side_of_tensor(const PatchPlace& place, std::uint32_t side) {
  const Rational one(1);
  const auto& [u, v] = place.at;
  switch (side) {
    case 0: return v.sign() == Sign::kZero ? std::optional(u) : std::nullopt;
    case 1: return u == one ? std::optional(v) : std::nullopt;
    case 2: return v == one ? std::optional(one - u) : std::nullopt;
    default: return u.sign() == Sign::kZero ? std::optional(one - v) : std::nullopt;
  }
}
std::optional<Rational> on_side_of_triangle(const PatchPlace& place, std::uint32_t side) {
  const Rational one(1);
  const auto& [s, t] = place.at;
  const std::array<Rational, 3> barycentric{one - s, s * (one - t), s * t};
  if (barycentric[(side + 2) % 3].sign() != Sign::kZero) return std::nullopt;
  return barycentric[(side + 1) % 3];
}

SurfacePoint surface_point(const PatchComplex& complex, const PatchPlace& place) {
  const Patch& patch = complex.patch(place.patch);
  std::optional<EdgePoint> on_edge;
  for (std::uint32_t s = 0; s < patch.num_sides(); ++s) {
    const auto at =
        patch.is_triangle() ? on_side_of_triangle(place, s) : on_side_of_tensor(place, s);
    if (!at) continue;
    const PatchSide side{place.patch, s};
    if (complex.is_collapsed(side) || at->sign() == Sign::kZero)
      return Vertex{complex.vertex({place.patch, s})};
    if (*at == Rational(1))
      return Vertex{complex.vertex({place.patch, (s + 1) % patch.num_sides()})};
    const PatchSide mate = *complex.mate(side);
    on_edge = mate < side ? EdgePoint{mate, Rational(1) - *at} : EdgePoint{side, *at};
  }
  if (on_edge) return *on_edge;
  return place;
}

}  // namespace

bool is_in_open_domain(const PatchPlace& place) {
  return std::all_of(place.at.begin(), place.at.end(), [](const Rational& v) {
    return v.sign() == Sign::kPositive && v < Rational(1);
  });
}

bool is_glued(const PatchComplex& complex) {
  if (!complex.is_closed_oriented_surface()) return false;
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p)
    for (std::uint32_t s = 0; s < complex.patch(p).num_sides(); ++s)
      if (!complex.is_collapsed({p, s}) && complex.travel({p, s}) == Travel::kBoth) return false;
  return true;
}

bool are_one_point(const PatchComplex& complex, const PatchPlace& a, const PatchPlace& b) {
  return surface_point(complex, a) == surface_point(complex, b);
}

}  // namespace veritope
