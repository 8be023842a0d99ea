// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/patch_complex.h: patches glued along equal boundary curves: edges, vertices, shells, orientation,
// Euler characteristic; and what keeps them from being a closed oriented surface, named and placed.
// Design: docs/design/0015-patch-complex.md.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robust/base/result.h"
#include "solids/patches/patch.h"
#include "solids/patches/patch_sides.h"

namespace veritope {

/// The most patches that a complex may have.
inline constexpr std::size_t kMaxPatches = std::size_t{1} << 24;

/// Side `side` of patch `patch`, both from 0.
struct PatchSide {
  std::uint32_t patch = 0, side = 0;
  friend auto operator<=>(const PatchSide&, const PatchSide&) = default;
};
struct PatchCorner {
  std::uint32_t patch = 0, corner = 0;
  friend auto operator<=>(const PatchCorner&, const PatchCorner&) = default;
};

/// What is wrong. With one of the defects up to kNotFinite, S0 or another assumption of the theorems does not hold; a
/// model with one of the others will be refused later.
enum class PatchDefect {
  kOpenSide,      ///< a side that occurs once
  kNearMiss,      ///< two open sides that differ slightly; each is listed as open, too
  kOverusedSide,  ///< a side that occurs three times or more
  kDirection,     ///< two equal sides that run in the same direction
  kOneSided,  ///< a shell whose patches cannot be reversed so that all directions agree, such as a Moebius strip
  kRepeatedPatch,  ///< a patch that occurs again, reversed or not
  kWeight,         ///< a weight that is zero or negative
  kDegree,         ///< a degree over kMaxPatchDegree
  kNotFinite,  ///< a facet with a coordinate that is NaN or infinite: left out, so that its neighbours are open
  kAdjacentPoles,  ///< two collapsed sides with a common corner: legal in S0; no star box covers that corner
};
inline constexpr std::size_t kNumPatchDefects = 10;
/// "open-side", for reports.
const char* defect_name(PatchDefect defect);

/// One defect. `sides` holds the side for kOpenSide; two sides for kNearMiss, kDirection, kOneSided and kAdjacentPoles;
/// all of them for kOverusedSide; for the others one entry for each patch, with side 0. For kNotFinite it is empty: see
/// `facet`.
struct PatchFinding {
  PatchDefect defect = PatchDefect::kOpenSide;
  std::vector<PatchSide> sides;
  std::size_t control =
      0;  ///< kWeight: the first such control point of the patch, in the order of its components
  double distance =
      0;  ///< kNearMiss: the greatest difference between two coordinates of control points, rounded to nearest
  bool is_one_ulp =
      false;  ///< kNearMiss: every two coordinates are equal or neighbours in binary64
  bool has_other_normal = false;  ///< kRepeatedPatch: one is the other reversed
  std::uint64_t facet = 0;        ///< kNotFinite
};

/// A component of the complex: patches connected through common sides.
struct PatchShell {
  std::uint32_t first_patch = 0;  ///< its least; shells are numbered by it
  std::uint64_t vertices = 0, edges = 0, patches = 0;
  bool is_closed =
      true;  ///< every side of its patches is collapsed or has one mate in the opposite direction
  std::int64_t euler() const {
    return static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>(edges) +
           static_cast<std::int64_t>(patches);
  }
  /// Nothing unless is_closed: then the shell is a closed oriented surface, and its Euler characteristic even.
  std::optional<std::int64_t> genus() const {
    if (!is_closed) return std::nullopt;
    return (2 - euler()) / 2;
  }
};

enum class PatchOrientation {
  kKeep,
  /// reverses whole patches, the fewest in each shell that make all directions agree (on a tie the first patch keeps
  /// its orientation)
  kAuto,
};

/// Patches from a file or a mesh, and the names of what could not be made a patch.
struct PatchInput {
  std::vector<Patch> patches;
  std::vector<PatchFinding> findings;
};

/// The abstract surface X that the patches are a map of. Vertices are the classes of corners that paired sides and
/// collapsed sides generate, never corners in equal places; an edge is a class of equal sides that are not collapsed.
class PatchComplex {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  std::span<const Patch> patches() const { return patches_; }
  const Patch& patch(std::uint32_t number) const { return patches_[number]; }
  /// The patches that PatchOrientation::kAuto reversed, ascending; patches() holds the reversed ones.
  std::span<const std::uint32_t> reversed() const { return reversed_; }

  bool is_collapsed(PatchSide side) const { return edge_of_side_[slot(side)] == kNone; }
  /// kNone if the side is collapsed.
  std::uint32_t edge(PatchSide side) const { return edge_of_side_[slot(side)]; }
  /// All sides of an edge, ascending.
  std::span<const PatchSide> sides(std::uint32_t edge) const {
    return std::span(sides_of_edges_)
        .subspan(first_side_[edge], first_side_[edge + 1] - first_side_[edge]);
  }
  /// The other side of an edge with two sides; nothing for a collapsed, an open or an overused side. It may belong to
  /// the same patch. Where X is a closed oriented surface, the point at t of a side is that at 1 - t of its mate,
  /// exactly, for all t of [0,1].
  std::optional<PatchSide> mate(PatchSide side) const;
  /// How a side runs along the canonical form of its curve; two mates fit iff one runs forward and one backward, or
  /// both are kBoth.
  Travel travel(PatchSide side) const { return travel_[slot(side)]; }
  std::uint32_t vertex(PatchCorner corner) const {
    return vertex_of_corner_[slot({corner.patch, corner.corner})];
  }
  std::uint32_t shell(std::uint32_t patch) const { return shell_of_patch_[patch]; }

  std::size_t num_vertices() const { return num_vertices_; }
  std::size_t num_edges() const { return first_side_.size() - 1; }
  std::span<const PatchShell> shells() const { return shells_; }
  std::int64_t euler() const;

  /// The first findings of each defect, at most max_listed, ordered by defect and by place.
  std::span<const PatchFinding> findings() const { return findings_; }
  /// The number of findings of the defect, listed or not.
  std::uint64_t count(PatchDefect defect) const {
    return counts_[static_cast<std::size_t>(defect)];
  }
  /// S0, positive weights, degrees under the cap, no patch twice: X is a closed oriented surface, its map as the
  /// certificates of star boxes ask. Nothing is said about the image. kAdjacentPoles is allowed.
  bool is_closed_oriented_surface() const;

 private:
  friend class PatchComplexBuilder;
  // Four slots a patch; a triangle leaves one unused.
  static std::size_t slot(PatchSide s) { return 4 * std::size_t{s.patch} + s.side; }

  std::vector<Patch> patches_;
  std::vector<std::uint32_t> reversed_;
  std::vector<std::uint32_t> edge_of_side_, vertex_of_corner_, shell_of_patch_;
  std::vector<Travel> travel_;
  std::vector<std::size_t> first_side_{0};
  std::vector<PatchSide> sides_of_edges_;
  std::size_t num_vertices_ = 0;
  std::vector<PatchShell> shells_;
  std::vector<PatchFinding> findings_;
  std::array<std::uint64_t, kNumPatchDefects> counts_{};
};

/// @param max_listed  the most findings of each defect that are listed; the counts are exact
/// @error kEmpty without a patch; kOverLimit over kMaxPatches. Defects of patches are no error: see findings().
/// @cost  O(n log n) for n patches, whatever the curves are: sides are sorted by hash, then exactly
Result<PatchComplex> make_patch_complex(PatchInput input,
                                        PatchOrientation orientation = PatchOrientation::kKeep,
                                        std::size_t max_listed = 1000);
Result<PatchComplex> make_patch_complex(std::vector<Patch> patches,
                                        PatchOrientation orientation = PatchOrientation::kKeep,
                                        std::size_t max_listed = 1000);

/// "open-side: surface 0, span (0, 1), side 2, from (0, 0, 1) to (1, 0, 1): occurs once".
std::string describe(const PatchComplex& complex, const PatchFinding& finding);

}  // namespace veritope
