// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/expression/directions.h"

#include <algorithm>

namespace veritope {
namespace {

// The sphere of directions is cut by the arcs of all sectors. Each cell of what remains has an arc on its border, as
// there is one, and lies beside a part of it between two neighbouring common directions of arcs: so both sides of all
// these parts are all cells.
class Arcs {
 public:
  Arcs(std::span<const FlatCone> cones, const std::function<bool(const NearbyBits&)>& f)
      : cones_(cones), f_(f), bits_(cones.size()) {}

  std::optional<bool> common_value() {
    for (std::size_t i = 0; i < cones_.size(); ++i)
      for (const Sector& s : cones_[i])
        if (!walk(i, s)) return std::nullopt;
    return value_;
  }

 private:
  // Visits the parts of the sector's arc. False: both values occurred.
  bool walk(std::size_t own, const Sector& s) {
    std::vector<Direction> cuts;
    for (std::size_t j = 0; j < cones_.size(); ++j)
      if (j != own)
        for (const Sector& t : cones_[j]) add_common(s, t, cuts);
    for (std::size_t k = 0; k + 1 < s.rays.size(); ++k)
      if (!walk(own, s, s.rays[k], s.rays[k + 1], cuts)) return false;
    return true;
  }

  // The directions in which the arc of t crosses that of s or ends on it, and perhaps others in the plane of s.
  static void add_common(const Sector& s, const Sector& t, std::vector<Direction>& out) {
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

  // Visits the parts between two rays that are less than a half turn apart.
  bool walk(std::size_t own, const Sector& s, const Direction& from, const Direction& to,
            const std::vector<Direction>& cuts) {
    std::vector<Direction> stops;
    for (const Direction& d : cuts)
      if (turn(s.normal, from, d) > 0 && turn(s.normal, d, to) > 0) stops.push_back(d);
    std::sort(stops.begin(), stops.end(),
              [&](const Direction& a, const Direction& b) { return turn(s.normal, a, b) > 0; });
    stops.push_back(to);
    const Direction* last = &from;
    for (const Direction& stop : stops) {
      if (turn(s.normal, *last, stop) == 0) continue;
      if (!visit(own, s, *last + stop)) return false;
      last = &stop;
    }
    return true;
  }

  // Both sides of the arc of s at a direction in which other arcs lie along it or not at all.
  bool visit(std::size_t own, const Sector& s, const Direction& d) {
    NearbyBits front(cones_.size());
    for (std::size_t j = 0; j < cones_.size(); ++j) {
      const Sector* const along = j == own ? &s : sector_along(cones_[j], s, d);
      if (along == nullptr) {
        front[j] = bits_[j] = is_inside(cones_[j], d);
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
    if (value_ && *value_ != value) return false;
    value_ = value;
    return true;
  }

  std::span<const FlatCone> cones_;
  const std::function<bool(const NearbyBits&)>& f_;
  NearbyBits bits_;  // at the back of the arc
  std::optional<bool> value_;
};

}  // namespace

std::optional<bool> common_value(std::span<const FlatCone> cones,
                                 const std::function<bool(const NearbyBits&)>& f) {
  return Arcs(cones, f).common_value();
}

}  // namespace veritope
