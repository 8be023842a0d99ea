// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "solids/patch_complex_internal.h"

namespace veritope::internal {
namespace {

struct HashedSide {
  std::uint64_t hash;
  PatchSide side;
};
struct ExactSide {
  CanonicalCurve curve;
  PatchSide side;
};

// Cuts a run of equal hashes into classes of equal curves. Forms are made again here, so that those of one run are held at a time.
void split_run(std::span<const Patch> patches, std::span<const HashedSide> run,
               std::vector<std::vector<PatchSide>>& shared, std::vector<PatchSide>& single) {
  if (run.size() == 1) {
    single.push_back(run[0].side);
    return;
  }
  std::vector<ExactSide> exact;
  exact.reserve(run.size());
  for (const HashedSide& h : run)
    exact.push_back({canonical(patches[h.side.patch].side(h.side.side)), h.side});
  std::sort(exact.begin(), exact.end(), [](const ExactSide& a, const ExactSide& b) {
    const auto order = a.curve <=> b.curve;
    return order != 0 ? order < 0 : a.side < b.side;
  });
  for (std::size_t i = 0; i < exact.size();) {
    std::size_t end = i + 1;
    while (end < exact.size() && exact[end].curve == exact[i].curve) ++end;
    if (end == i + 1) {
      single.push_back(exact[i].side);
    } else {
      auto& sides = shared.emplace_back();
      for (; i < end; ++i) sides.push_back(exact[i].side);
    }
    i = end;
  }
}

}  // namespace

MatchedSides match_sides(std::span<const Patch> patches) {
  MatchedSides out;
  out.edge_of_side.assign(4 * patches.size(), PatchComplex::kNone);
  out.travel.assign(4 * patches.size(), Travel::kForward);
  std::vector<HashedSide> hashed;
  hashed.reserve(4 * patches.size());
  for_each_side(patches, [&](PatchSide s) {
    const Patch::Curve curve = patches[s.patch].side(s.side);
    if (is_collapsed(curve)) return;
    const CanonicalCurve form = canonical(curve);
    out.travel[4 * std::size_t{s.patch} + s.side] = form.travel;
    hashed.push_back({hash_of(form), s});
  });
  std::sort(hashed.begin(), hashed.end(), [](const HashedSide& a, const HashedSide& b) {
    return a.hash != b.hash ? a.hash < b.hash : a.side < b.side;
  });
  std::vector<std::vector<PatchSide>> edges;
  std::vector<PatchSide> single;
  for (std::size_t i = 0; i < hashed.size();) {
    std::size_t end = i + 1;
    while (end < hashed.size() && hashed[end].hash == hashed[i].hash) ++end;
    split_run(patches, std::span(hashed).subspan(i, end - i), edges, single);
    i = end;
  }
  for (const PatchSide s : single) edges.push_back({s});
  std::sort(edges.begin(), edges.end());
  for (const auto& sides : edges) {
    out.first_side.push_back(out.sides.size());
    for (const PatchSide s : sides) {
      out.edge_of_side[4 * std::size_t{s.patch} + s.side] =
          static_cast<std::uint32_t>(out.first_side.size() - 1);
      out.sides.push_back(s);
    }
  }
  out.first_side.push_back(out.sides.size());
  return out;
}

}  // namespace veritope::internal
