// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/separator.h: an integer direction that proves two groups of facets disjoint.
// Bound: docs/bounds/separator.md.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "solids/polyhedron/box_tree.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "solids/polyhedron/vertex_star.h"

namespace veritope {

namespace formulas {
/// A dot product, in the order in which it is rounded.
template <typename T, typename U>
constexpr auto dot3(const T& dx, const T& dy, const T& dz, const U& x, const U& y, const U& z) {
  return (dx * x + dy * y) + dz * z;
}
}  // namespace formulas

namespace internal {
// docs/bounds/separator.md
inline constexpr double kSeparatorRel = 0x1.8000000000004p-51;
inline constexpr double kSeparatorRayRel = 0x1.8000000000007p-52;
inline constexpr double kSeparatorAbs = 0x1p-960;
inline constexpr double kSeparatorMaxSize = 0x1p1020;
}  // namespace internal

/// The greatest absolute value of a coordinate of a vertex that a face has.
double largest_coordinate(const TriangleMesh& mesh);

/// Smaller nodes are cheaper to take apart than to separate.
inline bool is_worth_separating(const TreeRange& a, const TreeRange& b) {
  return a.size() >= 4 && b.size() >= 4;
}

/// Finds d with d.p < d.q for every vertex p of a facet of the first group and q of the second, exactly; or, if the
/// groups have one vertex v in common, d.p < d.v < d.q for all others. Either way each two facets of the groups meet
/// exactly in their common simplex (docs/THEORY.md, MESH-4). The direction is searched for in floating point (the point
/// of a convex hull nearest to the origin, [GJK88], on a sample that grows where it was wrong), then proved: the
/// computed gap exceeds the rounding errors of both sides. Each thread needs a finder of its own, which keeps its
/// buffers.
class SeparatorFinder {
 public:
  /// `largest` = largest_coordinate(mesh), computed once for all finders of a model.
  SeparatorFinder(const TriangleMesh& mesh, double largest) : mesh_(mesh), largest_(largest) {}
  /// Empty if none was found; the groups may touch, or be disjoint by less than rounding can tell.
  std::optional<IntVec3> find(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b);

  /// One step, for tests: true only if d.p < d.q for all p of a, q of b.
  bool proves_apart(const IntVec3& d, std::span<const std::uint32_t> a, std::span<const std::uint32_t> b);

 private:
  // Vertices met recently, by the low bits of their ids: they show almost all repetitions at the cost of an array
  // access.
  struct Slot {
    std::uint32_t vertex = 0, stamp = 0;
  };
  static constexpr std::size_t kSlots = 256;

  static constexpr std::uint32_t kNoVertex = 0xffffffffu;

  bool take_sample(std::span<const std::uint32_t> facets, bool second, std::vector<Vec3d>& out);
  std::optional<IntVec3> find_apart(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b);
  std::optional<IntVec3> find_at_common(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b);
  bool proves_at_common(const IntVec3& d, std::span<const std::uint32_t> a, std::span<const std::uint32_t> b);

  const TriangleMesh& mesh_;
  double largest_;
  std::vector<Vec3d> sample_a_, sample_b_;
  std::uint32_t common_ = kNoVertex;  // seen in both samples
  std::array<Slot, kSlots> slots_{};
  std::uint32_t stamp_ = 0;
};

}  // namespace veritope
