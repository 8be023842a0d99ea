// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "solids/patches/patch_complex_internal.h"

namespace veritope::internal {
namespace {

struct Link {
  std::uint32_t patch, edge;
  bool differs;  // one of the two patches must be reversed, the other not
};
// The links of each patch, one list after the other.
struct Links {
  std::vector<std::size_t> first;
  std::vector<Link> links;
};

template <typename Visit>
void for_each_pair(const MatchedSides& m, Visit visit) {
  for (std::uint32_t e = 0; e + 1 < m.first_side.size(); ++e) {
    if (m.first_side[e + 1] - m.first_side[e] != 2) continue;
    const PatchSide a = m.sides[m.first_side[e]], b = m.sides[m.first_side[e] + 1];
    const Travel s = m.travel[4 * std::size_t{a.patch} + a.side],
                 t = m.travel[4 * std::size_t{b.patch} + b.side];
    if (s == Travel::kBoth) continue;  // fits either way
    visit(e, a.patch, b.patch, run_alike(s, t));
  }
}

Links links_of(std::size_t num_patches, const MatchedSides& m) {
  Links out;
  out.first.assign(num_patches + 1, 0);
  for_each_pair(m, [&](std::uint32_t, std::uint32_t p, std::uint32_t q, bool) {
    ++out.first[p + 1], ++out.first[q + 1];
  });
  for (std::size_t p = 0; p < num_patches; ++p) out.first[p + 1] += out.first[p];
  out.links.resize(out.first.back());
  std::vector<std::size_t> next(out.first.begin(), out.first.end() - 1);
  for_each_pair(m, [&](std::uint32_t e, std::uint32_t p, std::uint32_t q, bool alike) {
    out.links[next[p]++] = {q, e, alike};
    out.links[next[q]++] = {p, e, alike};
  });
  return out;
}

}  // namespace

Flips find_flips(std::size_t num_patches, const MatchedSides& matched) {
  const Links links = links_of(num_patches, matched);
  Flips out{std::vector<bool>(num_patches, false), {}};
  std::vector<bool> seen(num_patches, false);
  std::vector<std::uint32_t> shell;
  for (std::uint32_t seed = 0; seed < num_patches; ++seed) {
    if (seen[seed]) continue;
    shell.assign(1, seed);
    seen[seed] = true;
    std::size_t num_reversed = 0;
    std::uint32_t conflict = PatchComplex::kNone;
    for (std::size_t i = 0; i < shell.size(); ++i) {
      const std::uint32_t p = shell[i];
      for (std::size_t l = links.first[p]; l < links.first[p + 1]; ++l) {
        const Link& link = links.links[l];
        const bool wanted = out.flip[p] != link.differs;
        if (!seen[link.patch]) {
          seen[link.patch] = true;
          out.flip[link.patch] = wanted;
          num_reversed += wanted ? 1 : 0;
          shell.push_back(link.patch);
        } else if (out.flip[link.patch] != wanted) {
          conflict = std::min(conflict, link.edge);
        }
      }
    }
    const bool fewer_others = 2 * num_reversed > shell.size();
    for (const std::uint32_t p : shell)
      out.flip[p] = conflict == PatchComplex::kNone && out.flip[p] != fewer_others;
    if (conflict != PatchComplex::kNone) out.conflicts.push_back(conflict);
  }
  return out;
}

}  // namespace veritope::internal
