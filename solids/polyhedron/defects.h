// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/defects.h: what was found wrong, as places, sizes and sentences for the report.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "solids/polyhedron/open_edges.h"
#include "solids/polyhedron/validity.h"

namespace veritope {

/// Turns what was found wrong into Findings, whose codes are those of the rules, in the order in which functions are
/// called: at most `max_listed` of each rule, of the functions before `nesting` the largest, largest first.
class DefectLister {
 public:
  using FacePairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

  DefectLister(const TriangleMesh& mesh, std::size_t max_listed) : mesh_(mesh), max_listed_(max_listed) {}

  void degenerate(const std::vector<std::uint32_t>& faces);
  void duplicate(const FacePairs& pairs);
  /// M3 with the nearest edges, for all open edges.
  void open_edges(std::span<const OpenEdge> edges, std::span<const NearestEdge> nearest);
  /// M3 without them, M4 to M6.
  void topology(const DefectEvidence& evidence);
  void improper(const FacePairs& pairs);
  /// REQUIRES depth, outward and volume of every shell.
  void nesting(const std::vector<ShellReport>& shells);

  std::vector<Finding> take() { return std::move(defects_); }

 private:
  Finding edge_defect(MeshRule rule, const EdgeDefect& e) const;
  void add_edges(MeshRule rule, const std::vector<EdgeDefect>& edges);
  /// Numbers from 0 to count - 1: those of greatest size, at most max_listed_, largest first.
  template <typename Size>
  std::vector<std::size_t> largest(std::size_t count, Size size) const;

  const TriangleMesh& mesh_;
  std::size_t max_listed_;
  std::vector<Finding> defects_;
};

/// Whether both faces have the same three ids, in any order.
bool same_vertices(std::array<std::uint32_t, 3> f, std::array<std::uint32_t, 3> g);

/// The interior point (2a + b + c) / 4 of a face: the certificate's witness point of M8 and M9.
RationalPoint witness_point(const TriangleMesh& mesh, std::uint32_t face);

}  // namespace veritope
