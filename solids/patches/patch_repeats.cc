// SPDX-License-Identifier: LGPL-3.0-or-later
// Patches that occur twice: equal up to degree, factor, corner 0 and normal.
#include <algorithm>
#include <array>
#include <compare>
#include <deque>

#include "solids/patches/patch_complex_internal.h"
#include "solids/patches/patch_net.h"

namespace veritope::internal {
namespace {

using SideEdges = std::array<std::uint32_t, 4>;

// The edges of a patch, ascending; nothing if one of them has no other side: then the patch does not occur again.
std::optional<SideEdges> edges_of(const Patch& patch, std::uint32_t p, const MatchedSides& m) {
  SideEdges out;
  out.fill(PatchComplex::kNone - 1);  // of a triangle: no edge has this number
  for (std::uint32_t s = 0; s < patch.num_sides(); ++s) {
    const std::uint32_t e = out[s] = m.edge_of_side[4 * std::size_t{p} + s];
    if (e != PatchComplex::kNone && m.first_side[e + 1] - m.first_side[e] == 1) return std::nullopt;
  }
  std::sort(out.begin(), out.end());
  return out;
}

struct Net {
  const CanonicalNet* net;  // several patches with equal numbers have one
  std::uint32_t patch;
};

std::strong_ordering order_of(const Net& a, const Net& b) {
  return a.net == b.net ? std::strong_ordering::equal : *a.net <=> *b.net;
}
bool have_equal_numbers(const Patch& a, const Patch& b) {
  if (a.is_triangle() != b.is_triangle()) return false;
  return a.is_triangle() ? a.triangle() == b.triangle() : a.tensor() == b.tensor();
}

void compare_run(std::span<const Patch> patches, std::span<const std::uint32_t> run,
                 std::vector<PatchFinding>& out) {
  std::vector<Net> nets;
  std::deque<CanonicalNet> made{canonical_net(patches[run.front()])};
  for (const std::uint32_t p : run) {
    const bool is_copy = have_equal_numbers(patches[run.front()], patches[p]);
    nets.push_back({is_copy ? &made.front() : &made.emplace_back(canonical_net(patches[p])), p});
  }
  std::sort(nets.begin(), nets.end(), [](const Net& a, const Net& b) {
    const auto order = order_of(a, b);
    return order != 0 ? order < 0 : a.patch < b.patch;
  });
  for (std::size_t i = 1; i < nets.size(); ++i) {
    if (order_of(nets[i - 1], nets[i]) != 0) continue;
    PatchFinding& f = out.emplace_back();
    f.defect = PatchDefect::kRepeatedPatch;
    f.sides = {{nets[i - 1].patch, 0}, {nets[i].patch, 0}};
    f.has_other_normal = nets[i - 1].net->is_reversed != nets[i].net->is_reversed;
  }
}

}  // namespace

void find_repeated_patches(std::span<const Patch> patches, const MatchedSides& matched,
                           std::vector<PatchFinding>& out) {
  std::vector<std::pair<SideEdges, std::uint32_t>> keys;
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    if (const auto edges = edges_of(patches[p], p, matched)) keys.emplace_back(*edges, p);
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> run;
  for (std::size_t i = 0; i < keys.size();) {
    run.clear();
    const SideEdges& edges = keys[i].first;
    for (; i < keys.size() && keys[i].first == edges; ++i) run.push_back(keys[i].second);
    if (run.size() > 1) compare_run(patches, run, out);
  }
}

}  // namespace veritope::internal
