// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/flat_cone.h"

#include <algorithm>
#include <optional>

#include "robust/base/check.h"

namespace veritope {
namespace {

// A plane has the rays of four quarter turns, a half-plane those of two: in exact numbers without square roots.
Sector plane_sector(const Direction& normal, const Direction& u) {
  const Direction w = cross(normal, u);
  return {normal, {}, {u, w, -u, -w, u}};
}
Sector half_plane_sector(const Direction& normal, const Direction& rim, const Direction& inward) {
  return {normal, {inward}, {rim, inward, -rim}};
}

// at / weight, with a positive weight.
struct WeightedPoint {
  std::array<Dyadic, 3> at;
  Dyadic weight;
};

WeightedPoint weighted(const ExactPoint& p) {
  const Integer &x = p[0].denominator(), &y = p[1].denominator(), &z = p[2].denominator();
  return {{Dyadic(p[0].numerator() * y * z), Dyadic(p[1].numerator() * x * z),
           Dyadic(p[2].numerator() * x * y)},
          Dyadic(x * y * z)};
}

// a - p, by a positive factor.
Direction from_point(const WeightedPoint& p, const Vec3d& a) {
  std::array<Dyadic, 3> out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = p.weight * Dyadic::from_double(a[static_cast<int>(k)]) - p.at[k];
  return Direction(std::move(out));
}

Sector facet_sector(const std::array<Vec3d, 3>& t, const WeightedPoint& p) {
  std::array<Direction, 3> edge;
  for (std::size_t i = 0; i < 3; ++i) edge[i] = difference(t[(i + 1) % 3], t[i]);
  const Direction normal = cross(edge[0], edge[1]);
  std::vector<std::size_t> through;  // the edges that contain p
  for (std::size_t i = 0; i < 3; ++i)
    if (side(cross(normal, edge[i]), from_point(p, t[i])) == 0) through.push_back(i);
  if (through.empty()) return plane_sector(normal, edge[0]);
  const std::size_t i = through[0];
  if (through.size() == 1) return half_plane_sector(normal, edge[i], cross(normal, edge[i]));
  // Two edges meet in the vertex from which the second one starts, in the order of the corners.
  const std::size_t last = (through[0] + 1) % 3 == through[1] ? through[1] : through[0];
  const std::size_t before = (last + 2) % 3;
  return {normal,
          {cross(normal, edge[last]), cross(normal, edge[before])},
          {edge[last], -edge[before]}};
}

// On which side of a rim the segment from r to e meets the plane of the sector, where it has the parts `to` and `from`
// of r and e.
Sign side_of_rim(const Direction& inward, const Direction& r, const Direction& e,
                 const Dyadic& from, const Dyadic& to) {
  const Sign start = side(inward, r), end = side(inward, e);
  if (start == end) return start;
  return (to * dot(inward, r) + from * dot(inward, e)).sign();
}

// How a segment of directions from r to e passes a sector: +1 from front to back, -1 from back to front, 0 not at all;
// nothing if it touches a rim, or lies in the plane. REQUIRES that the sector contains neither r nor e.
std::optional<int> passage_through(const Sector& s, const Direction& r, const Direction& e) {
  const Sign start = side(s.normal, r), end = side(s.normal, e);
  if (start == 0 && end == 0) return std::nullopt;
  if (start * end != Sign::kNegative) return 0;
  Dyadic from = dot(s.normal, r), to = dot(s.normal, e);  // of different signs: made positive
  if (start > 0)
    to = -to;
  else
    from = -from;
  bool touches = false;
  for (const Direction& inward : s.inward) {
    const Sign inner = side_of_rim(inward, r, e, from, to);
    if (inner < 0) return 0;
    touches |= inner == 0;
  }
  if (touches) return std::nullopt;
  return to_int(start);
}

// Whether e is inside, found along the segment from the direction r in the open sector number `first`; nothing if the
// segment touches a rim.
std::optional<bool> inside_from(const FlatCone& cone, std::size_t first, const Direction& r,
                                const Direction& e) {
  int winding = side(cone[first].normal, e) < 0 ? 1 : 0;
  for (std::size_t i = 0; i < cone.size(); ++i) {
    if (i == first) continue;
    const std::optional<int> passage = passage_through(cone[i], r, e);
    if (!passage) return std::nullopt;
    winding += *passage;
  }
  VT_CHECK(winding == 0 || winding == 1, "a cone that does not bound a solid");
  return winding == 1;
}

}  // namespace

bool Sector::contains(const Direction& d) const {
  return std::all_of(inward.begin(), inward.end(),
                     [&](const Direction& w) { return side(w, d) >= 0; });
}

bool Sector::holds(const Direction& d) const {
  return std::all_of(inward.begin(), inward.end(),
                     [&](const Direction& w) { return side(w, d) > 0; });
}

// Each rim and each plane excludes one of the directions r of a sector, so that one of these tries succeeds.
bool is_inside(const FlatCone& cone, const Direction& d) {
  for (std::size_t i = 0; i < cone.size(); ++i) {
    if (side(cone[i].normal, d) == 0) continue;
    for (std::size_t k = 1; k <= 3 * cone.size() + 1; ++k) {
      const Direction r = cone[i].rays[0] + Dyadic(static_cast<std::int64_t>(k)) * cone[i].rays[1];
      if (const auto inside = inside_from(cone, i, r, d)) return *inside;
    }
  }
  throw InternalError("a direction off a cone lies in all planes of the cone");
}

FlatCone flat_cone(const TriangleMesh& mesh, std::span<const std::uint32_t> facets,
                   const ExactPoint& point) {
  const WeightedPoint p = weighted(point);
  FlatCone out;
  for (const std::uint32_t f : facets) {
    const auto& t = mesh.faces[f];
    out.push_back(
        facet_sector({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}, p));
  }
  return out;
}

FlatCone flat_cone(const ExactBox<3>& box, const ExactPoint& point) {
  std::array<int, 3> at{};  // the sides that contain the point: -1 and 1
  for (std::size_t k = 0; k < 3; ++k)
    at[k] = point[k] == box[k].lo ? -1 : point[k] == box[k].hi ? 1 : 0;
  FlatCone out;
  for (std::size_t k = 0; k < 3; ++k) {
    if (at[k] == 0) continue;
    const Direction normal = axis_direction(k, at[k]);
    const std::size_t p = (k + 1) % 3, q = (k + 2) % 3;
    // Inward along both other axes; u and v turn counter-clockwise around the normal.
    const Direction u = axis_direction(p, at[p] == 0 ? 1 : -at[p]),
                    v = axis_direction(q, at[q] == 0 ? 1 : -at[q]);
    if (at[p] == 0 && at[q] == 0) {
      out.push_back(plane_sector(normal, u));
    } else if (at[p] == 0 || at[q] == 0) {
      const Direction& inward = at[p] == 0 ? v : u;
      out.push_back(half_plane_sector(normal, cross(inward, normal), inward));
    } else {
      const bool is_turned = turn(normal, u, v) < 0;
      out.push_back({normal, {u, v}, is_turned ? std::vector{v, u} : std::vector{u, v}});
    }
  }
  return out;
}

}  // namespace veritope
