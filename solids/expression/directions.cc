// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/directions.h"

#include <algorithm>

#include "solids/expression/arc_walk_internal.h"

namespace veritope {
namespace internal {

void add_common_directions(const Sector& s, const Sector& t, std::vector<Direction>& out) {
  if (is_parallel(s.normal, t.normal)) {
    out.insert(out.end(), t.rays.begin(), t.rays.end());
    return;
  }
  // The line of both planes has the directions n_s x n_t and its negative.
  bool has_line = true, has_negative = true;
  for (const Direction& inward : t.inward) {
    const Sign side_of_line = turn(inward, s.normal, t.normal);
    has_line &= side_of_line >= 0;
    has_negative &= side_of_line <= 0;
  }
  if (!has_line && !has_negative) return;
  const Direction line = cross(s.normal, t.normal);
  if (has_line) out.push_back(line);
  if (has_negative) out.push_back(-line);
}

}  // namespace internal

namespace {

// The sphere of directions is cut by the arcs of all sectors. Each cell of what remains has an arc on its border, as
// there is one, and lies beside a part of it between two neighbouring common directions of arcs: so both sides of all
// these parts are all cells.
class Arcs {
 public:
  Arcs(std::span<const TangentCone> cones, const NearbyFunction& f)
      : cones_(cones), f_(f), bits_(cones.size()) {}

  std::optional<bool> common_value() {
    internal::walk_arcs(
        cones_,
        [&](std::size_t own, const Sector& s, const Direction& d) { return visit(own, s, d); },
        [](std::size_t, const Sector&, const Direction&) { return true; });
    return has_both_ ? std::nullopt : value_;
  }

 private:
  // Both sides of the arc of s at a direction in which other arcs lie along it or not at all.
  bool visit(std::size_t own, const Sector& s, const Direction& d) {
    NearbyBits front(cones_.size());
    for (std::size_t j = 0; j < cones_.size(); ++j) {
      const Sector* const along = j == own ? &s : sector_along(cones_[j].sectors, s, d);
      if (along == nullptr) {
        front[j] = bits_[j] = is_inside(cones_[j].sectors, d);
      } else {  // the solid is at the back of its sector
        front[j] = side(along->normal, s.normal) < 0;
        bits_[j] = !front[j];
      }
    }
    return take(f_(bits_)) && take(f_(front));
  }

  // A sector of the cone in the plane of s that holds the direction; null: none.
  static const Sector* sector_along(const FlatCone& cone, const Sector& s, const Direction& d) {
    const auto found = std::find_if(cone.begin(), cone.end(), [&](const Sector& t) {
      return side(t.normal, d) == 0 && is_parallel(t.normal, s.normal) && t.holds(d);
    });
    return found == cone.end() ? nullptr : &*found;
  }

  bool take(bool value) {
    has_both_ = value_ && *value_ != value;
    value_ = value;
    return !has_both_;
  }

  std::span<const TangentCone> cones_;
  const NearbyFunction& f_;
  NearbyBits bits_;  // at the back of the arc
  std::optional<bool> value_;
  bool has_both_ = false;
};

}  // namespace

std::optional<bool> common_value(std::span<const TangentCone> cones, const NearbyFunction& f) {
  return Arcs(cones, f).common_value();
}

TangentCone flat_tangent_cone(FlatCone sectors) {
  TangentCone out;
  out.sheets.resize(sectors.size());
  out.sectors = std::move(sectors);
  return out;
}

}  // namespace veritope
