// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/surface.h: triangles with vertex ids as a cell complex: edges, fans, shells. Integers only, no coordinates.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/buffer.h"
#include "topology/incidence.h"

namespace veritope {

/// An undirected edge with the faces that run along it.
struct EdgeDefect {
  std::uint32_t a = 0, b = 0;              ///< a < b, or the direction (a, b) that is used twice (misoriented)
  std::vector<std::uint32_t> faces;        ///< all faces that have the edge, ascending
};

/// A vertex whose faces form several fans.
struct VertexDefect {
  std::uint32_t vertex = 0;
  std::uint32_t fans = 0;
  std::vector<std::uint32_t> faces;        ///< one face of each fan, ascending
};

/// One component of the surface: faces connected through edges.
struct Shell {
  std::uint32_t first_face = 0;            ///< its least face; shells are numbered by it
  std::uint64_t vertices = 0, edges = 0, faces = 0;
  std::int64_t euler() const {
    return static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>(edges) +
           static_cast<std::int64_t>(faces);
  }
};

/// What the incidences of a triangle complex show. A face with a repeated id is not a triangle: it is listed in
/// `collapsed` and takes part in nothing else. Counts are exact; the lists of defects hold the first `max_listed` of
/// each kind, in ascending order of (vertex ids), whatever the number of jobs.
struct SurfaceTopology {
  std::uint64_t vertices = 0;              ///< referenced by a face that is not collapsed
  std::uint64_t edges = 0, faces = 0;      ///< undirected edges; faces that are not collapsed
  std::uint64_t boundary_edges = 0;        ///< one face
  std::uint64_t nonmanifold_edges = 0;     ///< more than two faces
  std::uint64_t misoriented_edges = 0;     ///< two faces in the same direction
  std::uint64_t nonmanifold_vertices = 0;  ///< faces at the vertex form more than one fan
  bool is_cycle = false;                   ///< every edge is used equally often in both directions: volume is defined
  std::vector<std::uint32_t> collapsed;    ///< all faces with a repeated id, ascending
  std::vector<std::uint32_t> irregular;    ///< all vertices whose faces are not one closed, oriented fan, ascending
  std::vector<EdgeDefect> boundary, nonmanifold, misoriented;
  std::vector<VertexDefect> pinched;
  std::vector<Shell> shells;
  Buffer<std::uint32_t> shell_of_face;       ///< kNoShell for a collapsed face

  static constexpr std::uint32_t kNoShell = 0xffffffffu;
  std::int64_t euler() const {
    return static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>(edges) +
           static_cast<std::int64_t>(faces);
  }
  /// True if every edge has two faces in opposite directions and every vertex one fan.
  bool is_closed_oriented_manifold() const {
    return boundary_edges + nonmanifold_edges + misoriented_edges + nonmanifold_vertices == 0 && is_cycle;
  }
};

/// REQUIRES incidence built from the same faces. @cost O(F), and a sort at each vertex that is not one closed fan.
SurfaceTopology analyse_surface(std::span<const std::array<std::uint32_t, 3>> faces,
                                const Incidence& incidence, std::size_t max_listed, unsigned jobs);

}  // namespace veritope
