// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/facet_tests_internal.h: exact tests of a point and a facet, and of a segment and a facet. Internal to
// solids/classify.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "predicates/session.h"
#include "solids/classify/scaled_point_internal.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::internal {

/// How a segment from `from` to `to` passes the triangle, for endpoints on different sides of its plane.
enum class Passage { kMisses, kCrosses, kTouchesRim };

/// The three turns of the segment's line about the edges decide: equal signs cross, opposite signs miss.
inline Passage passage_of(Sign ab, Sign bc, Sign ca) {
  const auto differ = [](Sign s, Sign t) { return s * t == Sign::kNegative; };
  if (differ(ab, bc) || differ(bc, ca) || differ(ca, ab)) return Passage::kMisses;
  const bool has_zero = ab == Sign::kZero || bc == Sign::kZero || ca == Sign::kZero;
  return has_zero ? Passage::kTouchesRim : Passage::kCrosses;
}

/// What the tests need of a facet, in one line of the cache.
struct alignas(64) FacetRecord {
  SessionPlane plane;
  std::uint32_t id;  ///< the facet's number in the mesh
  std::array<std::uint32_t, 3> corners;
};

/// The facets of a mesh, for points in a box around it. Functions take the number of a record: that of the facet, until
/// the records are put into another order.
class FacetTests {
 public:
  /// REQUIRES a box that contains the vertices of the faces. The mesh must outlive this.
  FacetTests(const TriangleMesh& mesh, const Vec3d& lo, const Vec3d& hi);

  std::array<Vec3d, 3> corners(std::uint32_t facet) const {
    const auto& t = records_[facet].corners;
    return {mesh_->positions[t[0]], mesh_->positions[t[1]], mesh_->positions[t[2]]};
  }

  /// Positive on the side to which the facet's normal points; zero on its plane, and everywhere for a degenerate facet.
  Sign side(std::uint32_t facet, const Vec3d& q) const {
    const Sign3 s = session_.orient3d_filter(records_[facet].plane, q);
    if (is_certain(s)) [[likely]]
      return to_sign(s);
    return exact_side(facet, q);
  }
  Sign side(std::uint32_t facet, const ScaledPoint& q) const;

  /// REQUIRES endpoints on different sides of the facet's plane.
  Passage passage(std::uint32_t facet, const Vec3d& from, const Vec3d& to) const;
  Passage passage(std::uint32_t facet, const Vec3d& from, const ScaledPoint& to) const;

  /// Whether the closed facet, degenerate ones included, contains q. REQUIRES side(facet, q) == kZero.
  bool contains(std::uint32_t facet, const Vec3d& q) const;
  bool contains(std::uint32_t facet, const ScaledPoint& q) const;

  bool is_degenerate(std::uint32_t facet) const;

  void prefetch(std::uint32_t facet) const { __builtin_prefetch(&records_[facet]); }
  const SessionPlane& plane(std::uint32_t facet) const { return records_[facet].plane; }
  /// The number in the mesh.
  std::uint32_t id(std::uint32_t facet) const { return records_[facet].id; }
  const Session3d& session() const { return session_; }
  std::uint64_t bytes() const { return records_.size() * sizeof(FacetRecord); }

  /// Record i becomes what record order[i] was. REQUIRES a permutation.
  void reorder(const std::vector<std::uint32_t>& order);

 private:
  Sign exact_side(std::uint32_t facet, const Vec3d& q) const;

  const TriangleMesh* mesh_;
  Session3d session_;
  std::vector<FacetRecord> records_;
};

}  // namespace veritope::internal
