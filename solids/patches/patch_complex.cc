// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/patches/patch_complex.h"

#include <algorithm>
#include <utility>

#include "robust/base/check.h"
#include "robust/base/disjoint_sets.h"
#include "solids/patches/patch_complex_internal.h"

namespace veritope {

class PatchComplexBuilder {
 public:
  PatchComplexBuilder(PatchInput input, std::size_t max_listed)
      : found_(std::move(input.findings)), max_listed_(max_listed) {
    out_.patches_ = std::move(input.patches);
  }

  PatchComplex build(PatchOrientation orientation) {
    internal::MatchedSides matched = internal::match_sides(out_.patches_);
    const internal::Flips flips = internal::find_flips(out_.patches_.size(), matched);
    if (orientation == PatchOrientation::kAuto && flip(flips))
      matched = internal::match_sides(out_.patches_);
    adopt(std::move(matched));
    number_vertices();
    number_shells();
    find_defects(flips);
    return std::move(out_);
  }

 private:
  bool flip(const internal::Flips& flips) {
    for (std::uint32_t p = 0; p < out_.patches_.size(); ++p)
      if (flips.flip[p]) {
        out_.patches_[p] = reversed(out_.patches_[p]);
        out_.reversed_.push_back(p);
      }
    return !out_.reversed_.empty();
  }

  void adopt(internal::MatchedSides matched) {
    out_.edge_of_side_ = std::move(matched.edge_of_side);
    out_.travel_ = std::move(matched.travel);
    out_.first_side_ = std::move(matched.first_side);
    out_.sides_of_edges_ = std::move(matched.sides);
  }

  // Corners at the ends of mates and of collapsed sides.
  void number_vertices() {
    DisjointSets corners(4 * out_.patches_.size());
    const auto first = [&](PatchSide s) {
      return static_cast<std::uint32_t>(4 * s.patch + s.side);
    };
    const auto last = [&](PatchSide s) {
      return static_cast<std::uint32_t>(4 * s.patch + (s.side + 1) % patch(s).num_sides());
    };
    internal::for_each_side(out_.patches_, [&](PatchSide s) {
      if (out_.is_collapsed(s)) corners.join(first(s), last(s));
      const auto mate = out_.mate(s);
      if (!mate || *mate < s) return;
      const bool alike = internal::run_alike(out_.travel(s), out_.travel(*mate));
      corners.join(first(s), alike ? first(*mate) : last(*mate));
      corners.join(last(s), alike ? last(*mate) : first(*mate));
    });
    out_.vertex_of_corner_.assign(4 * out_.patches_.size(), PatchComplex::kNone);
    std::uint32_t count = 0;
    internal::for_each_side(out_.patches_, [&](PatchSide s) {
      const std::uint32_t at = first(s), least = corners.find(at);
      out_.vertex_of_corner_[at] = least == at ? count++ : out_.vertex_of_corner_[least];
    });
    out_.num_vertices_ = count;
  }

  void number_shells() {
    DisjointSets patches(out_.patches_.size());
    internal::for_each_side(out_.patches_, [&](PatchSide s) {
      if (const auto mate = out_.mate(s)) patches.join(s.patch, mate->patch);
    });
    for (std::uint32_t p = 0; p < out_.patches_.size(); ++p) {
      const std::uint32_t least = patches.find(p);
      if (least == p) out_.shells_.push_back({p});
      out_.shell_of_patch_.push_back(least == p
                                         ? static_cast<std::uint32_t>(out_.shells_.size() - 1)
                                         : out_.shell_of_patch_[least]);
      ++out_.shells_[out_.shell_of_patch_[p]].patches;
    }
    count_cells();
  }
  void count_cells() {
    std::vector<bool> seen(out_.num_vertices_, false);
    internal::for_each_side(out_.patches_, [&](PatchSide s) {
      PatchShell& shell = out_.shells_[out_.shell_of_patch_[s.patch]];
      const std::uint32_t v = out_.vertex({s.patch, s.side});
      if (!seen[v]) ++shell.vertices;
      seen[v] = true;
      if (out_.is_collapsed(s)) return;
      const auto mate = out_.mate(s);
      if (!mate || s < *mate) ++shell.edges;
      if (!mate || internal::run_alike(out_.travel(s), out_.travel(*mate))) shell.is_closed = false;
    });
  }

  void find_defects(const internal::Flips& flips) {
    std::vector<PatchSide> open;
    for (std::uint32_t e = 0; e < out_.num_edges(); ++e) {
      const auto sides = out_.sides(e);
      const auto add = [&](PatchDefect defect) {
        PatchFinding& f = found_.emplace_back();
        f.defect = defect;
        f.sides.assign(sides.begin(), sides.end());
      };
      if (sides.size() == 1) open.push_back(sides[0]);
      if (sides.size() == 1) add(PatchDefect::kOpenSide);
      if (sides.size() > 2) add(PatchDefect::kOverusedSide);
      if (sides.size() == 2 && internal::run_alike(out_.travel(sides[0]), out_.travel(sides[1])))
        add(PatchDefect::kDirection);
    }
    // Edges keep their numbers where patches are not reversed, as in shells with a conflict: there the sides are
    // unchanged.
    for (const auto& sides : conflicts(flips)) {
      PatchFinding& f = found_.emplace_back();
      f.defect = PatchDefect::kOneSided;
      f.sides = sides;
    }
    const internal::MatchedSides matched{out_.edge_of_side_, out_.travel_, out_.first_side_,
                                         out_.sides_of_edges_};
    internal::find_bad_patches(out_.patches_, matched, found_);
    internal::find_repeated_patches(out_.patches_, matched, found_);
    internal::find_near_misses(out_.patches_, open, found_);
    list_findings();
  }
  std::vector<std::vector<PatchSide>> conflicts(const internal::Flips& flips) const {
    std::vector<std::vector<PatchSide>> out;
    for (const std::uint32_t e : flips.conflicts) {
      const auto sides = out_.sides(e);
      out.emplace_back(sides.begin(), sides.end());
    }
    return out;
  }

  void list_findings() {
    std::stable_sort(found_.begin(), found_.end(),
                     [](const PatchFinding& a, const PatchFinding& b) {
                       return a.defect != b.defect ? a.defect < b.defect : a.sides < b.sides;
                     });
    for (PatchFinding& f : found_) {
      auto& count = out_.counts_[static_cast<std::size_t>(f.defect)];
      if (count++ < max_listed_) out_.findings_.push_back(std::move(f));
    }
  }

  const Patch& patch(PatchSide s) const { return out_.patches_[s.patch]; }

  PatchComplex out_;
  std::vector<PatchFinding> found_;
  std::size_t max_listed_;
};

std::optional<PatchSide> PatchComplex::mate(PatchSide side) const {
  if (is_collapsed(side)) return std::nullopt;
  const auto both = sides(edge(side));
  if (both.size() != 2) return std::nullopt;
  return both[0] == side ? both[1] : both[0];
}

std::int64_t PatchComplex::euler() const {
  std::int64_t sum = 0;
  for (const PatchShell& shell : shells_) sum += shell.euler();
  return sum;
}

bool PatchComplex::is_closed_oriented_surface() const {
  for (std::size_t d = 0; d <= static_cast<std::size_t>(PatchDefect::kNotFinite); ++d)
    if (counts_[d] != 0) return false;
  return true;
}

Result<PatchComplex> make_patch_complex(PatchInput input, PatchOrientation orientation,
                                        std::size_t max_listed) {
  if (input.patches.empty() && input.findings.empty())
    return Error{Code::kEmpty, {}, "there is no patch"};
  if (input.patches.size() > kMaxPatches)
    return Error{
        Code::kOverLimit,
        {},
        std::to_string(input.patches.size()) + " patches; at most " + std::to_string(kMaxPatches)};
  return PatchComplexBuilder(std::move(input), max_listed).build(orientation);
}
Result<PatchComplex> make_patch_complex(std::vector<Patch> patches, PatchOrientation orientation,
                                        std::size_t max_listed) {
  return make_patch_complex(PatchInput{std::move(patches), {}}, orientation, max_listed);
}

}  // namespace veritope
