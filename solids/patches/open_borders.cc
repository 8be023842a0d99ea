// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/open_borders.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <vector>

#include "robust/base/disjoint_sets.h"

namespace veritope {

namespace {

constexpr double kNearSidePart = 0x1p-4;  // of the length of a side

bool has_other_defects(const PatchComplex& complex) {
  for (std::size_t i = 0; i < kNumPatchDefects; ++i) {
    const auto defect = static_cast<PatchDefect>(i);
    if (defect != PatchDefect::kOpenSide && defect != PatchDefect::kNearMiss &&
        defect != PatchDefect::kAdjacentPoles && complex.count(defect) != 0)
      return true;
  }
  return false;
}

OpenSide open_side(const PatchComplex& complex, PatchSide s) {
  const Patch& patch = complex.patch(s.patch);
  OpenSide out{s, {}, 0, {}, 0};
  const auto a = approx_point(patch.corner(s.side)),
             b = approx_point(patch.corner((s.side + 1) % patch.num_sides()));
  out.ends = {Point3d{a[0], a[1], a[2]}, Point3d{b[0], b[1], b[2]}};
  out.length = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  // Two ends beyond binary64 have no difference. A length that is not a number would have no place in an order.
  if (std::isnan(out.length)) out.length = std::numeric_limits<double>::infinity();
  return out;
}

std::vector<PatchSide> open_sides(const PatchComplex& complex) {
  std::vector<PatchSide> out;
  for (std::uint32_t e = 0; e < complex.num_edges(); ++e)
    if (const auto sides = complex.sides(e); sides.size() == 1) out.push_back(sides[0]);
  return out;
}

std::uint64_t count_borders(const PatchComplex& complex, const std::vector<PatchSide>& sides) {
  DisjointSets<> vertices(complex.num_vertices());
  std::vector<std::uint32_t> starts;
  for (const PatchSide s : sides) {
    const std::uint32_t next = (s.side + 1) % complex.patch(s.patch).num_sides();
    starts.push_back(complex.vertex({s.patch, s.side}));
    vertices.join(starts.back(), complex.vertex({s.patch, next}));
  }
  for (std::uint32_t& v : starts) v = vertices.find(v);
  std::sort(starts.begin(), starts.end());
  return static_cast<std::uint64_t>(std::unique(starts.begin(), starts.end()) - starts.begin());
}

struct NearSide {
  PatchSide side;
  double distance = 0;
};

// Each near side with the side that differs least from it.
std::map<PatchSide, NearSide> near_sides(const PatchComplex& complex) {
  std::map<PatchSide, NearSide> out;
  for (const PatchFinding& f : complex.findings()) {
    if (f.defect != PatchDefect::kNearMiss) continue;
    const double length =
        std::min(open_side(complex, f.sides[0]).length, open_side(complex, f.sides[1]).length);
    if (!(f.distance > 0 && f.distance <= kNearSidePart * length)) continue;
    for (const int i : {0, 1}) {
      const auto [at, is_new] = out.try_emplace(f.sides[i], NearSide{f.sides[1 - i], f.distance});
      if (!is_new && f.distance < at->second.distance) at->second = {f.sides[1 - i], f.distance};
    }
  }
  return out;
}

std::vector<OpenSide> longest_sides(const PatchComplex& complex,
                                    const std::vector<PatchSide>& sides,
                                    const std::map<PatchSide, NearSide>& near,
                                    std::size_t max_listed) {
  std::vector<OpenSide> out;
  if (max_listed == 0) return out;
  for (const PatchSide s : sides) out.push_back(open_side(complex, s));
  std::stable_sort(out.begin(), out.end(),
                   [](const OpenSide& a, const OpenSide& b) { return a.length > b.length; });
  out.resize(std::min(out.size(), max_listed));
  for (OpenSide& s : out)
    if (const auto found = near.find(s.side); found != near.end())
      s.near = found->second.side, s.distance = found->second.distance;
  return out;
}

}  // namespace

OpenBorders open_borders(const PatchComplex& complex, std::size_t max_listed) {
  OpenBorders out;
  if (complex.count(PatchDefect::kOpenSide) == 0) return out;
  const std::vector<PatchSide> sides = open_sides(complex);
  const std::map<PatchSide, NearSide> near = near_sides(complex);
  out.sides = sides.size();
  out.borders = count_borders(complex, sides);
  out.near_sides = near.size();
  for (const auto& [side, other] : near) {
    out.least = out.greatest == 0 ? other.distance : std::min(out.least, other.distance);
    out.greatest = std::max(out.greatest, other.distance);
  }
  out.longest = longest_sides(complex, sides, near, max_listed);
  const auto shells = complex.shells();
  const bool are_open =
      std::none_of(shells.begin(), shells.end(), [](const PatchShell& s) { return s.is_closed; });
  if (are_open && !has_other_defects(complex)) out.sheets = shells.size();
  return out;
}

}  // namespace veritope
