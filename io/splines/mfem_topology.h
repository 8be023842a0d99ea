// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/mfem_topology.h: how MFEM numbers the control points of the patches of a NURBS mesh.
// Source: MFEM, mesh/nurbs.hpp (NURBSPatchMap) and mesh/nurbs.cpp (NURBSExtension::GenerateOffsets), version 4.8.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace veritope {

/// The patches, their corners and edges as a mesh file lists them. Numbers are all in range.
struct MfemTopology {
  struct Edge {
    std::uint64_t knot_vector = 0;
    std::uint64_t from = 0, to = 0;  ///< the knots run this way
  };
  int dimension = 0;
  std::vector<std::vector<std::uint64_t>>
      patches;  ///< 2, 4 or 8 vertices each, as MFEM orders them
  std::vector<Edge> edges;
  std::uint64_t num_vertices = 0;
};

/// Numbers control points: vertices, then those within edges (from the lower vertex to the higher), within faces,
/// within patches. num_control[k]: of knot vector k, at least 2.
class MfemNumbering {
 public:
  MfemNumbering(const MfemTopology& topology, const std::vector<std::uint64_t>& num_control);

  /// Why the edges do not fit the patches; nothing if they do. All other functions REQUIRE that
  /// they fit.
  const std::optional<std::string>& fault() const { return fault_; }
  std::uint64_t num_points() const { return num_points_; }
  /// The number of control points of all patches, shared ones counted once a patch; saturated at
  /// 2^62.
  std::uint64_t num_patch_points() const { return num_patch_points_; }
  /// The knot vector of a patch's axis, and whether it runs in reverse there. Nothing if its edges disagree.
  std::uint64_t knot_vector(std::size_t patch, int axis) const;
  std::optional<bool> is_reversed(std::size_t patch, int axis) const;
  /// The number of control point (i, j, k) of a patch.
  std::uint64_t point(std::size_t patch, const std::array<std::uint64_t, 3>& index) const;

 private:
  struct Face {
    std::array<std::uint64_t, 4> vertices{};  // as in the first patch that has it
    std::uint64_t offset = 0;
  };
  struct Patch {
    std::vector<std::uint64_t> edges;
    std::array<std::uint64_t, 6> faces{};
    std::array<int, 6> orientations{};
    std::array<std::uint64_t, 3> size{1, 1, 1};
    std::uint64_t offset = 0;
  };
  bool find_edges();
  void number_faces();
  std::uint64_t on_edge(const Patch& patch, std::size_t p, int local, std::uint64_t n,
                        std::uint64_t size) const;
  std::uint64_t on_face(const Patch& patch, int local, std::uint64_t m, std::uint64_t n,
                        std::uint64_t size_m, std::uint64_t size_n) const;

  const MfemTopology& topology_;
  const std::vector<std::uint64_t>& num_control_;
  std::vector<Patch> patches_;
  std::vector<Face> faces_;
  std::vector<std::uint64_t> edge_offset_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::uint64_t> edge_of_;
  std::uint64_t num_points_ = 0, num_patch_points_ = 0;
  std::optional<std::string> fault_;
};

}  // namespace veritope
