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

constexpr double kNearPart = 0x1p-4;  // of the length of a side

bool has_other_defects(const PatchComplex& complex) {
  for (std::size_t i = 0; i < kNumPatchDefects; ++i) {
    const auto defect = static_cast<PatchDefect>(i);
    if (defect != PatchDefect::kOpenSide && defect != PatchDefect::kNearMiss &&
        defect != PatchDefect::kAdjacentPoles && complex.count(defect) != 0)
      return true;
  }
  return false;
}

// The distance of its ends, approximately.
double length_of_side(const PatchComplex& complex, PatchSide s) {
  const Patch& patch = complex.patch(s.patch);
  const auto a = approx_point(patch.corner(s.side)),
             b = approx_point(patch.corner((s.side + 1) % patch.num_sides()));
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

OpenBorders open_borders(const PatchComplex& complex) {
  OpenBorders out;
  if (complex.count(PatchDefect::kOpenSide) == 0) return out;
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
  std::set<PatchSide> near;
  for (const PatchFinding& f : complex.findings()) {
    if (f.defect != PatchDefect::kNearMiss) continue;
    const double length =
        std::min(length_of_side(complex, f.sides[0]), length_of_side(complex, f.sides[1]));
    if (!(f.distance > 0 && f.distance <= kNearPart * length)) continue;
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
