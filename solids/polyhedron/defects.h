// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/defects.h: what was found wrong, as places, sizes and sentences for the report.
#pragma once
#include <vector>

#include "solids/polyhedron/duplicates.h"
#include "solids/polyhedron/improper_pairs.h"
#include "solids/polyhedron/validity.h"

namespace veritope {

/// Turns what was found wrong into Findings, whose codes are those of the rules, at most `max_listed` of each rule, in
/// the order in which the functions are called.
class DefectLister {
 public:
  DefectLister(const TriangleMesh& mesh, std::size_t max_listed) : mesh_(mesh), max_listed_(max_listed) {}

  void degenerate(const std::vector<std::uint32_t>& faces);
  void duplicate(const DuplicateFaces& duplicates);
  void topology(const SurfaceTopology& topology);
  void improper(const ImproperPairs& pairs);
  /// REQUIRES depth, outward and volume of every shell.
  void nesting(const std::vector<ShellReport>& shells);

  std::vector<Finding> take() { return std::move(defects_); }

 private:
  void add_edges(MeshRule rule, const std::vector<EdgeDefect>& edges);

  const TriangleMesh& mesh_;
  std::size_t max_listed_;
  std::vector<Finding> defects_;
};

/// Whether both faces have the same three ids, in any order.
bool same_vertices(std::array<std::uint32_t, 3> f, std::array<std::uint32_t, 3> g);

/// The interior point (2a + b + c) / 4 of a face: the certificate's witness point of M8 and M9.
RationalPoint witness_point(const TriangleMesh& mesh, std::uint32_t face);

}  // namespace veritope
