// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/separator.h: an integer direction that proves two groups of facets disjoint.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "solids/polyhedron/triangle_mesh.h"
#include "solids/polyhedron/vertex_star.h"

namespace veritope {

/// The greatest absolute value of a coordinate.
double largest_coordinate(const TriangleMesh& mesh);

/// Finds d with d.p < d.q for every vertex p of a facet of the first group and q of the second: exactly, for all of them. The
/// direction is searched for in floating point (the closest points of the convex hulls, [GJK88], on a sample that grows where it was
/// wrong), then proved: the computed gap exceeds the rounding errors of both sides.
/// One finder a thread: it keeps its buffers.
class SeparatorFinder {
 public:
  /// `largest` = largest_coordinate(mesh), asked for once for all finders of a model.
  SeparatorFinder(const TriangleMesh& mesh, double largest) : mesh_(mesh), largest_(largest) {}
  /// nullopt: none was found; the groups may touch, or be disjoint by less than rounding can tell.
  std::optional<IntVec3> find(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b);

 private:
  // Vertices met lately, by the low bits of their ids: finds almost all repetitions at the price of an array access.
  struct Slot {
    std::uint32_t vertex = 0, stamp = 0;
  };
  static constexpr std::size_t kSlots = 256;

  bool take_sample(std::span<const std::uint32_t> facets, bool second, std::vector<Vec3d>& out);
  bool proves(const IntVec3& d, std::span<const std::uint32_t> a, std::span<const std::uint32_t> b);

  const TriangleMesh& mesh_;
  double largest_;
  std::vector<Vec3d> sample_a_, sample_b_;
  std::array<Slot, kSlots> slots_{};
  std::uint32_t stamp_ = 0;
};

}  // namespace veritope
