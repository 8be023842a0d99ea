// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/open_borders.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

#include "robust/base/disjoint_sets.h"

namespace veritope {

namespace {

constexpr double kNearPart = 0x1p-16;

bool has_other_defects(const PatchComplex& complex) {
  for (std::size_t i = 0; i < kNumPatchDefects; ++i) {
    const auto defect = static_cast<PatchDefect>(i);
    if (defect != PatchDefect::kOpenSide && defect != PatchDefect::kNearMiss &&
        defect != PatchDefect::kAdjacentPoles && complex.count(defect) != 0)
      return true;
  }
  return false;
}

// The largest absolute value of a coordinate of a corner, approximately.
double largest_coordinate(const PatchComplex& complex) {
  double out = 0;
  for (const Patch& patch : complex.patches())
    for (std::uint32_t c = 0; c < patch.num_sides(); ++c)
      for (const double v : approx_point(patch.corner(c))) out = std::max(out, std::abs(v));
  return out;
}

}  // namespace

OpenBorders open_borders(const PatchComplex& complex) {
  OpenBorders out;
  DisjointSets<> vertices(complex.num_vertices());
  std::vector<std::uint32_t> starts;
  for (std::uint32_t e = 0; e < complex.num_edges(); ++e) {
    const auto sides = complex.sides(e);
    if (sides.size() != 1) continue;
    const PatchSide s = sides[0];
    const std::uint32_t next = (s.side + 1) % complex.patch(s.patch).num_sides();
    starts.push_back(complex.vertex({s.patch, s.side}));
    vertices.join(starts.back(), complex.vertex({s.patch, next}));
  }
  out.sides = starts.size();
  for (std::uint32_t& v : starts) v = vertices.find(v);
  std::sort(starts.begin(), starts.end());
  out.borders =
      static_cast<std::uint64_t>(std::unique(starts.begin(), starts.end()) - starts.begin());
  const double reach = kNearPart * largest_coordinate(complex);
  std::set<PatchSide> near;
  for (const PatchFinding& f : complex.findings()) {
    if (f.defect != PatchDefect::kNearMiss || !(f.distance <= reach)) continue;
    out.least = near.empty() ? f.distance : std::min(out.least, f.distance);
    out.greatest = std::max(out.greatest, f.distance);
    near.insert(f.sides.begin(), f.sides.end());
  }
  out.near_sides = near.size();
  const auto shells = complex.shells();
  const bool are_open =
      std::none_of(shells.begin(), shells.end(), [](const PatchShell& s) { return s.is_closed; });
  if (are_open && !has_other_defects(complex)) out.sheets = shells.size();
  return out;
}

}  // namespace veritope
