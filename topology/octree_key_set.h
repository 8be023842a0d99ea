// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/octree_key_set.h: octree cells of which none contains another, in order, with look-up.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/result.h"
#include "topology/octree_key.h"

namespace veritope {

/// A set of octree cells with disjoint interiors, ascending by code.
class OctreeKeySet {
 public:
  static constexpr std::size_t kMaxCells = std::size_t{1} << 24;

  /// Makes the set from cells in any order.
  /// @error kEmpty without a cell; kOverLimit if there are more than kMaxCells; kBadArgument if a cell is out of range
  ///        (its position is the place's entity), occurs twice or contains another one: the message names the cells.
  /// @cost  O(n log n)
  static Result<OctreeKeySet> make(std::span<const OctreeCell> cells);
  static Result<OctreeKeySet> make(std::vector<OctreeKey> keys);

  std::size_t size() const { return keys_.size(); }
  OctreeKey operator[](std::size_t i) const { return keys_[i]; }
  std::span<const OctreeKey> keys() const { return keys_; }
  unsigned finest_level() const { return finest_level_; }

  /// The position of the first key whose code is not below `code`; size() if all are below.
  /// @cost O(1) for evenly spread cells, O(log n) at worst.
  std::size_t lower_bound(std::uint64_t code) const;

 private:
  void build_index();

  std::vector<OctreeKey> keys_;
  /// bucket_[b]: the first key whose code >> shift_ is at least b.
  std::vector<std::uint32_t> bucket_;
  unsigned shift_ = 0;
  unsigned finest_level_ = 0;
};

}  // namespace veritope
