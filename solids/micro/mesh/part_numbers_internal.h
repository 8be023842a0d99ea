// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/mesh/part_numbers_internal.h: into how many parts patches are cut, so that glued sides and equal rims
// have one number. Internal to solids/micro/mesh.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "robust/base/disjoint_sets.h"
#include "solids/micro/mesh/cap_links_internal.h"
#include "solids/micro/mesh/tile_mesh_internal.h"

namespace veritope::internal {

/// How far a patch of a kind, cut into m x n parts, may lie from its triangles: along[0] / m^2 + along[1] / n^2 +
/// twist / (m n).
struct PatchError {
  std::array<double, 2> along{};
  double twist = 0;
};

class PartNumbers {
 public:
  static constexpr std::uint32_t kMost = std::uint32_t{1} << 20;

  PartNumbers(const CapLinks& links, const std::vector<AnalysedTile>& tiles);

  /// The number of a patch among those of all kinds.
  std::size_t number(std::uint32_t kind, std::size_t patch) const { return first_[kind] + patch; }
  std::size_t num_patches() const { return first_.back(); }
  PatchParts of(std::size_t number) {
    return {parts_[classes_.find(element(number, 0))], parts_[classes_.find(element(number, 1))]};
  }
  /// Raises numbers until no error exceeds the chord. Returns false if one would be over kMost.
  bool raise_for(const std::vector<PatchError>& errors, double chord);
  /// One more part along both axes of a patch.
  void raise(std::size_t number);

 private:
  static std::uint32_t element(std::size_t number, std::size_t axis) {
    return static_cast<std::uint32_t>(2 * number + axis);
  }
  std::vector<std::size_t> first_;
  DisjointSets<> classes_;
  std::vector<std::uint32_t> parts_;  // of the least element of a class
};

}  // namespace veritope::internal
