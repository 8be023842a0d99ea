// SPDX-License-Identifier: LGPL-3.0-or-later
// io/mesh/vertex_table.h: ids for positions, equal positions one id, in the order of their first occurrence.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "predicates/vec.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// Open addressing over (32 bits of hash, id) pairs; lookups go in batches that prefetch. The hash is keyed by
/// a number drawn at start, so that no file can be made to collide; ids do not depend on the key.
/// REQUIRES that no coordinate is NaN or -0, and fewer than 2^32 - 1 positions.
class VertexTable {
 public:
  static constexpr std::size_t kBatch = 96;

  explicit VertexTable(std::uint64_t key) : key_(key) {}
  VertexTable();

  /// Makes room for `num` positions, so that insert() need not rehash meanwhile.
  void reserve(std::size_t num);

  /// ids[i] = id of points[i]. REQUIRES points.size() <= kBatch. New positions go to store[num_positions()...]:
  /// REQUIRES room for them there and the earlier ones unchanged; `points` may lie after them in the same array.
  void insert(std::span<const Vec3d> points, Vec3d* store, std::uint32_t* ids);

  std::size_t num_positions() const { return num_; }

 private:
  struct Slot {
    std::uint32_t tag;
    std::uint32_t id_plus_1;  ///< 0: empty
  };
  struct Free {
    void operator()(Slot* slots) const;
  };
  std::uint64_t hash(const Vec3d& p) const;
  void rehash(std::size_t num_slots, const Vec3d* store);

  std::uint64_t key_;
  std::unique_ptr<Slot[], Free> slots_;
  std::size_t num_slots_ = 0;  ///< a power of two, or 0
  std::size_t num_ = 0;
};

/// Merges equal positions in place and renames the corners of `faces`.
/// @return the number of distinct positions = mesh.positions.size() afterwards
std::size_t merge_equal_positions(TriangleMesh& mesh);

/// Counts distinct positions without changing the mesh.
std::size_t count_distinct_positions(const TriangleMesh& mesh);

}  // namespace veritope
