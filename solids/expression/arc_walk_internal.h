// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/arc_walk_internal.h: the arcs that sectors cut out of the sphere of directions, part by part.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "solids/expression/tangent_cone.h"

namespace veritope::internal {

/// Adds the directions in which the arc of t crosses that of s or ends on it, and perhaps others in the plane of s.
void add_common_directions(const Sector& s, const Sector& t, std::vector<Direction>& out);

/// Calls `part(own, s, d)` with a direction d inside each part of the arc of each sector s, of the cone number `own`,
/// between two neighbouring common directions with sectors of other cones; and `stop(own, s, d)` at the ends of the
/// parts. In a part each arc lies along it or not at all. A call that returns false ends the walk: then it is false.
template <typename Part, typename Stop>
bool walk_arcs(std::span<const TangentCone> cones, Part&& part, Stop&& stop) {
  std::vector<Direction> cuts, stops;
  for (std::size_t own = 0; own < cones.size(); ++own)
    for (const Sector& s : cones[own].sectors) {
      cuts.clear();
      for (std::size_t j = 0; j < cones.size(); ++j)
        if (j != own)
          for (const Sector& t : cones[j].sectors) add_common_directions(s, t, cuts);
      for (std::size_t k = 0; k + 1 < s.rays.size(); ++k) {
        const Direction &from = s.rays[k], &to = s.rays[k + 1];
        stops.clear();
        for (const Direction& d : cuts)
          if (turn(s.normal, from, d) > 0 && turn(s.normal, d, to) > 0) stops.push_back(d);
        std::sort(stops.begin(), stops.end(),
                  [&](const Direction& a, const Direction& b) { return turn(s.normal, a, b) > 0; });
        stops.push_back(to);
        if (!stop(own, s, from)) return false;
        Direction last = from;
        for (const Direction& d : stops) {
          if (turn(s.normal, last, d) == 0) continue;
          if (!part(own, s, last + d) || !stop(own, s, d)) return false;
          last = d;
        }
      }
    }
  return true;
}

}  // namespace veritope::internal
