// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/tetrahedra/occupancy.h: which tetrahedra of a point set's hull are in the object from which the points were
// sampled: those whose edges have their middles in a union of balls. Every comparison is exact.
// Source: [HHQ04], section 5.2.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "predicates/exact_point.h"
#include "robust/base/result.h"
#include "robust/rational.h"
#include "solids/base/box_hierarchy.h"
#include "topology/tetrahedral_complex.h"
#include "topology/trim_to_manifold.h"

namespace veritope {

/// For each corner of a tetrahedron the nearest point with which it shares an edge, the first one of several; its own
/// number for points that are no corners. In a Delaunay tetrahedralization that is the nearest point of all.
std::vector<std::uint32_t> nearest_neighbours(std::span<const ExactPoint3> points,
                                              std::span<const TetrahedronCorners> tetrahedra);

/// The union of closed balls around points, each of which reaches to the neighbour of its centre.
class BallUnion {
 public:
  /// The points must outlive it. REQUIRES one neighbour for each point; a point that is its own has no ball.
  BallUnion(std::span<const ExactPoint3> points, std::vector<std::uint32_t> neighbours);

  /// Whether some ball contains the middle of two points.
  bool contains_middle(std::uint32_t a, std::uint32_t b) const;
  /// Whether the sphere through the corners is at most `factor` times as large as the largest ball around one of them.
  bool is_sphere_at_most(const TetrahedronCorners& corners, const Rational& factor) const;

 private:
  bool is_in_ball(std::uint32_t centre, std::uint32_t a, std::uint32_t b) const;

  std::span<const ExactPoint3> points_;
  std::vector<std::uint32_t> neighbours_, centres_;
  BoxHierarchy boxes_;  // around the balls of centres_
};

/// For each tetrahedron: are the middles of its six edges in the union?
std::vector<bool> occupied_tetrahedra(std::span<const TetrahedronCorners> tetrahedra,
                                      const BallUnion& balls);

/// Tetrahedra that are not occupied but have small spheres become occupied: places inside that noise left free. In an
/// object that is sampled densely the empty spheres between points are not much larger than the balls; at its surface
/// and in its holes they are. (The paper has no such step: there noise makes cavities and tunnels.)
/// Returns those tetrahedra, ascending.
std::vector<std::uint32_t> fill_noise(std::span<const TetrahedronCorners> tetrahedra,
                                      const BallUnion& balls, const Rational& factor,
                                      std::vector<bool>& occupied);

/// Tetrahedra with spheres more than `factor` times as large as the largest ball around a corner are not occupied any
/// more: those that lie flat over hollows of the surface, and there make handles. (Nor has the paper this step.)
/// Returns those tetrahedra, ascending.
std::vector<std::uint32_t> clip_large_spheres(std::span<const TetrahedronCorners> tetrahedra,
                                              const BallUnion& balls, const Rational& factor,
                                              std::vector<bool>& occupied);

/// Tetrahedra that are not occupied, connected through faces, are a gap. A gap that is enclosed, so that it does not
/// reach the boundary of the complex, and whose tetrahedra all have small spheres, becomes occupied.
/// REQUIRES one entry for each tetrahedron. Returns the tetrahedra that were filled, ascending.
std::vector<std::uint32_t> fill_enclosed_gaps(const TetrahedralComplex& complex,
                                              const BallUnion& balls, const Rational& factor,
                                              std::vector<bool>& occupied);

/// The ranks of the tetrahedra by their longest edge, rounded, the longest first: the order in which rings are opened.
std::vector<std::uint32_t> order_by_longest_edge(std::span<const ExactPoint3> points,
                                                 std::span<const TetrahedronCorners> tetrahedra);

/// Takes tetrahedra that are connected through faces out of `kept` if they are fewer than a sixteenth of others with
/// which they were connected, be it through vertices only, in `before`: what trimming split off. Ascending.
/// REQUIRES that kept is a part of before, and that parts of kept have no vertex in common.
std::vector<std::uint32_t> remove_satellites(const TetrahedralComplex& complex,
                                             const std::vector<bool>& before,
                                             std::vector<bool>& kept);

enum class RemovalReason {
  kMiddle,     ///< the middle of an edge is outside of the union of balls
  kSphere,     ///< its sphere is much larger than the balls
  kEdge,       ///< TrimReason
  kVertex,     ///< TrimReason
  kRing,       ///< TrimReason
  kSatellite,  ///< split off from a much larger part
};
/// "middle", "sphere", "edge", "vertex", "ring", "satellite"
const char* reason_name(RemovalReason reason);

struct RemovedTetrahedron {
  std::uint32_t tetrahedron = 0;
  RemovalReason reason = RemovalReason::kMiddle;
};

struct Occupancy {
  std::vector<std::uint32_t> kept;          ///< numbers of tetrahedra, ascending
  std::vector<RemovedTetrahedron> removed;  ///< all others, in the order of the steps
  /// Those that are kept though a middle is outside of the union, ascending.
  std::vector<std::uint32_t> filled;
};

/// All steps: tetrahedra with a middle outside of the union are clipped, but those with spheres up to 3/2 of a ball are
/// kept as noise; those with spheres over 3 times a ball are clipped; the boundary is made a 2-manifold; gaps that this
/// enclosed, with spheres up to twice a ball, are filled; what it split off is taken away.
/// REQUIRES the Delaunay tetrahedra of the points.
/// @error kBadArgument if nothing is left
Result<Occupancy> find_occupancy(std::span<const ExactPoint3> points,
                                 const std::vector<TetrahedronCorners>& tetrahedra);

}  // namespace veritope
