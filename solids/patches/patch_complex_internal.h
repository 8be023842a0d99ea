// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/patch_complex_internal.h: the steps of make_patch_complex, for its parts and for tests.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "solids/patches/patch_complex.h"

namespace veritope::internal {

/// Items with the hashes of their forms, cut into classes of equal forms; classes of one item included. form_of(item)
/// is called only where a hash occurs again; two forms are held at any time, or, of items that are equal in their hash
/// and differ from the first of them, all. Items of a class ascend; the order of the classes is not fixed.
/// @cost O(n log n) comparisons of hashes; of forms, one for each item, and O(n log n) for those of items that differ
///       from the first one of their hash
template <typename Item, typename FormOf>
std::vector<std::vector<Item>> equal_classes(std::vector<std::pair<std::uint64_t, Item>> hashed,
                                             FormOf form_of) {
  using Form = decltype(form_of(hashed[0].second));
  std::sort(hashed.begin(), hashed.end());
  std::vector<std::vector<Item>> classes;
  std::vector<Form> forms;
  std::vector<std::size_t> others, run;
  for (std::size_t i = 0; i < hashed.size();) {
    std::size_t end = i + 1;
    while (end < hashed.size() && hashed[end].first == hashed[i].first) ++end;
    std::vector<Item>& first_class = classes.emplace_back();
    first_class.push_back(hashed[i].second);
    forms.clear(), others.clear();
    if (end > i + 1) {
      const Form first = form_of(hashed[i].second);
      for (std::size_t k = i + 1; k < end; ++k) {
        Form form = form_of(hashed[k].second);
        if ((form <=> first) == 0) {
          first_class.push_back(hashed[k].second);
          continue;
        }
        forms.push_back(std::move(form));
        others.push_back(k);
      }
    }
    run.resize(others.size());
    std::iota(run.begin(), run.end(), std::size_t{0});
    std::sort(run.begin(), run.end(), [&](std::size_t a, std::size_t b) {
      const auto order = forms[a] <=> forms[b];
      return order != 0 ? order < 0 : a < b;
    });
    for (std::size_t k = 0; k < run.size(); ++k) {
      if (k == 0 || (forms[run[k - 1]] <=> forms[run[k]]) != 0) classes.emplace_back();
      classes.back().push_back(hashed[others[run[k]]].second);
    }
    i = end;
  }
  return classes;
}

/// Calls visit(PatchSide) for every side of every patch, in order.
template <typename Visit>
void for_each_side(std::span<const Patch> patches, Visit visit) {
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    for (std::uint32_t s = 0; s < patches[p].num_sides(); ++s) visit(PatchSide{p, s});
}

/// Four slots per patch; PatchComplex::kNone for collapsed sides and unused slots. Edges are numbered by their first
/// sides.
struct MatchedSides {
  std::vector<std::uint32_t> edge_of_side;
  std::vector<Travel> travel;
  std::vector<std::size_t> first_side;  ///< the first of each edge in `sides`, and one past the last
  std::vector<PatchSide> sides;
};
MatchedSides match_sides(std::span<const Patch> patches);

/// Two sides of one edge that would fit if one of their patches were reversed: neither is its own reverse and both run
/// alike.
inline bool run_alike(Travel a, Travel b) { return a == b && a != Travel::kBoth; }

/// For each patch, whether it must be reversed so that no edge has two sides that run alike; in a shell where that is
/// impossible no patch is reversed. `conflicts`: one edge of each such shell.
struct Flips {
  std::vector<bool> flip;
  std::vector<std::uint32_t> conflicts;
};
/// @cost linear
Flips find_flips(std::size_t num_patches, const MatchedSides& matched);

/// Adds the findings kWeight, kDegree and kAdjacentPoles, by patch.
void find_bad_patches(std::span<const Patch> patches, const MatchedSides& matched,
                      std::vector<PatchFinding>& out);
/// Adds each patch that repeats an earlier one, once, with that earlier patch.
void find_repeated_patches(std::span<const Patch> patches, const MatchedSides& matched,
                           std::vector<PatchFinding>& out);
/// Adds, for each open side, the nearest other one, if their ends lie within a small part (2^-16) of the largest
/// coordinate of each other; each pair once. The search compares a side only with the few next ones, so it may miss a
/// pair: it gives people a hint and decides nothing.
void find_near_misses(std::span<const Patch> patches, std::span<const PatchSide> open,
                      std::vector<PatchFinding>& out);

}  // namespace veritope::internal
