// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/mesh/bridge_surfaces_internal.h: the surfaces of bridges and sweeps, cut into quadrilaterals: four
// sides, which begin at the rims of caps, and end faces. Internal to solids/micro/mesh.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "robust/base/result.h"
#include "solids/micro/bridge_front.h"
#include "solids/micro/mesh/bridge_mesh_internal.h"
#include "solids/micro/mesh/cap_links_internal.h"
#include "solids/micro/mesh/part_numbers_internal.h"
#include "solids/micro/mesh/tile_mesh_internal.h"
#include "solids/micro/mesh/vertex_rounding_internal.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::internal {

/// A cap with a bridge counts as dropped; its parts are those of the bridge across its axis.
class BridgeSurfaces {
 public:
  using TileMeshes = std::vector<std::shared_ptr<const TileMesh>>;  // by kinds
  /// Writes the vertices of the whole mesh that a cell's tile has.
  using VerticesOfCell = std::function<void(std::uint32_t cell, std::vector<std::uint32_t>& ids)>;

  /// Marks the caps of bridges in the links, which must outlive it, as all else.
  BridgeSurfaces(const Microstructure& micro, const VModel& cage,
                 const std::vector<AnalysedTile>& tiles, unsigned jobs, CapLinks& links);

  bool is_empty() const { return bridges_.empty(); }
  /// @error kBadArgument: a bridge does not start at a free cap; kNotFinite: derivatives have no bounds
  std::optional<Error> find_errors();
  /// Raises the parts of the caps, and those along the axes, to what the errors and the chord need.
  /// @error kOverLimit
  std::optional<Error> choose_parts(double chord, PartNumbers& numbers);
  /// Appends vertices and facets; false if there are more than `most` facets.
  bool make(const TileMeshes& meshes, std::uint64_t most, const VerticesOfCell& vertices,
            TriangleMesh& mesh, Greatest& rounding);
  /// Whether distance() is at most the chord; else there are more parts now.
  bool are_close_enough(const TileMeshes& meshes, double chord, double rounding,
                        PartNumbers& numbers);
  /// A bound of the distance between the bridges and their facets, after are_close_enough.
  double distance() const { return distance_; }

 private:
  struct Placed {  // a bridge or a sweep
    std::uint32_t number = 0, cell = 0, patch = 0;
    unsigned symmetry = 0;  // takes the patch's parameters to those of the bridge (bridge_front.h)
    BridgeError error;
    double size = 0;          // approximate
    std::uint32_t parts = 1;  // along the axis
    double gap = 0;           // of its quadrilaterals
    std::uint64_t first_vertex = 0, first_facet = 0;

    bool is_swapped() const { return (symmetry & 1) != 0; }
  };
  struct FacetWriter;

  void add(std::uint32_t number, const CapPlace& place, std::optional<unsigned> symmetry,
           CapLinks& links);
  BridgeFront own_front(const CapPlace& place) const;
  std::uint32_t volume_of(const Placed& b) const;
  BridgeMesh in_space(const Placed& b) const;

  template <typename Visit>
  void for_each(Visit visit);
  const TileMesh& mesh_of(const TileMeshes& meshes, const Placed& b) const {
    return *meshes[links_.cells[b.cell].kind];
  }
  std::size_t cap_number(const PartNumbers& numbers, const Placed& b) const {
    return numbers.number(links_.cells[b.cell].kind, b.patch);
  }
  std::array<std::uint32_t, 2> parts_across(const TileMesh& mesh, const Placed& b) const;
  std::uint64_t num_collapsed_rim_parts(const TileMesh& mesh, const Placed& b) const;
  double distance_of(const TileMesh& mesh, const Placed& b, double rounding) const;
  void make_one(Placed& b, const BridgeMesh& bridge, const TileMesh& tile,
                const std::vector<std::uint32_t>& ids, TriangleMesh& mesh,
                Greatest& rounding) const;

  const Microstructure& micro_;
  const VModel& cage_;
  const std::vector<AnalysedTile>& tiles_;
  unsigned jobs_;
  const CapLinks& links_;
  std::vector<Placed> bridges_;
  std::optional<Error> error_;
  double distance_ = 0;
};

}  // namespace veritope::internal
