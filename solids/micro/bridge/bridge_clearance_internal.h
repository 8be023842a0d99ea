// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/bridge/bridge_clearance_internal.h: does a bridge or a sweep, in space, miss the surface of a mesh, and
// is its end near it? The conditions I1 and I4 of docs/certificates/micro-inside.md, for one bridge. Internal to
// solids/micro/bridge.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "predicates/vec.h"
#include "robust/base/result.h"
#include "solids/base/box_hierarchy.h"
#include "solids/micro/bridge/cage_space_internal.h"
#include "solids/micro/sweep_nodes.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// The facets of a mesh, to be found by boxes. Immutable.
class SkinFacets {
 public:
  explicit SkinFacets(const TriangleMesh& mesh);

  using Corners = std::array<Vec3d, 3>;
  const Corners& corners(std::uint32_t facet) const { return corners_[facet]; }
  template <typename Visit>
  void visit(const Box3d& box, Visit visit) const {
    tree_.visit([&](const Box3d& b) { return meets(b, box); }, visit);
  }

 private:
  std::vector<Corners> corners_;
  BoxHierarchy tree_;
};

/// True only if the bridge, mapped to space, has no point in common with a facet.
/// REQUIRES a bridge in the parameters of the volume.
bool misses_facets(const SkinFacets& skin, const internal::VolumeSpace& volume,
                   const MicroBridge& bridge);
bool misses_facets(const SkinFacets& skin, SweepNodes& sweep);

/// A bound of the distance from every point of the end face to the facets, at most `most`; nothing if none is proved.
std::optional<double> end_distance(const SkinFacets& skin, const internal::VolumeSpace& volume,
                                   const MicroBridge& bridge, double most);
std::optional<double> end_distance(const SkinFacets& skin, SweepNodes& sweep, double most);

}  // namespace veritope
