// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/improper_places.h: pairs of facets that meet improperly, grouped into the places where they do.
#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "robust/base/box3d.h"
#include "robust/base/disjoint_sets.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// A cluster of facets in improper pairs: connected through these pairs and through common vertices.
struct ImproperPlace {
  std::uint64_t pairs = 0;
  std::uint64_t faces = 0;
  std::uint32_t first_face = 0;  ///< the least
  Box3d box;                     ///< contains all points in which the pairs meet
};

/// Collects pairs. What comes out depends on the set of pairs only, not on their order or on who collected them.
class ImproperPlaces {
 public:
  explicit ImproperPlaces(const TriangleMesh& mesh) : mesh_(&mesh) {}

  /// @cost a few hash lookups; memory grows with the facets, not with the pairs
  void add(std::uint32_t f, std::uint32_t g) { add(f, g, 1); }
  /// Adds this number of pairs of faces that have the vertices of f and of g; only f and g are counted as faces.
  void add(std::uint32_t f, std::uint32_t g, std::uint64_t pairs);
  /// Counts a face that lies in such pairs.
  void add_face(std::uint32_t face) { node_of(face); }
  void add(const ImproperPlaces& others);

  /// By first_face.
  std::vector<ImproperPlace> take();

 private:
  struct Cluster {
    std::uint32_t first_face;
    std::uint64_t pairs = 0;
    Box3d box;
    bool has_box = false;
  };
  std::uint32_t node_of(std::uint32_t face);
  std::uint32_t join(std::uint32_t a, std::uint32_t b);
  void add_to(Cluster& cluster, std::uint64_t pairs, const Box3d& box);

  const TriangleMesh* mesh_;
  DisjointSets<> nodes_;
  std::vector<std::uint32_t> face_of_node_;
  std::vector<Cluster> cluster_of_node_;  // valid for the first node of each class
  std::unordered_map<std::uint32_t, std::uint32_t> node_of_face_;
};

}  // namespace veritope
