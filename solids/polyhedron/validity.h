// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/validity.h: are these triangles the boundary of a solid? Decided exactly and completely; if not,
// what and where. Theory: docs/THEORY.md, polyhedra.  Design: docs/design/0001-mesh-decision.md.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solids/base/finding.h"
#include "robust/rational.h"
#include "solids/polyhedron/facet_meetings.h"
#include "solids/polyhedron/improper_places.h"
#include "solids/polyhedron/nesting.h"
#include "solids/polyhedron/open_edges.h"
#include "solids/polyhedron/rules.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "solids/polyhedron/vertex_star.h"
#include "topology/surface.h"

namespace veritope {

class WorkShare;

/// Exact counts. Faces with a repeated id count in `faces` and `degenerate_faces` only.
struct MeshCounts {
  std::uint64_t faces = 0;
  std::uint64_t referenced_vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t boundary_edges = 0;
  std::uint64_t nonmanifold_edges = 0;
  std::uint64_t misoriented_edges = 0;
  std::uint64_t nonmanifold_vertices = 0;
  std::uint64_t degenerate_faces = 0;
  std::uint64_t duplicate_faces = 0;   ///< faces with the same three ids as an earlier one
  /// unordered pairs of non-degenerate faces that meet outside their common simplex
  std::uint64_t selfint_pairs = 0;
  std::uint64_t shells = 0;            ///< components through edges
  std::int64_t euler = 0;              ///< V - E + F
  std::optional<std::uint64_t> bodies; ///< shells at even depth; known if M1-M7 hold
  std::optional<std::int64_t> genus;   ///< sum over shells; known if M1-M6 hold
};

struct ShellReport {
  std::int64_t euler = 0;
  std::optional<std::int64_t> genus;         ///< if M1-M6 hold
  std::optional<Rational> volume;            ///< signed; if every edge is used equally often in both directions
  std::optional<std::uint32_t> depth;        ///< number of shells around it; if M1-M7 hold
  std::optional<bool> outward;               ///< volume > 0; if M1-M7 hold
  std::uint32_t first_face = 0;
};

struct ValidityOptions {
  unsigned jobs = 1;              ///< threads; the report is the same for every number
  std::size_t max_defects = 20;   ///< that list_defects can list for each rule; all are counted
  WorkShare* work = nullptr;      ///< if not null, it shows how many of the comparisons of faces are done
  bool keep_meetings = false;     ///< the report of a valid mesh has them, for a certificate
};

/// Seconds that the parts of the decision took, for bench/ and for curious users.
struct DecisionTimes {
  double incidence = 0, signs = 0, topology = 0, stars = 0, boxes = 0, pairs = 0, volume = 0, nesting = 0;
};

/// Gaps are measured in meshes with at most this number of open edges.
inline constexpr std::uint64_t kMostMeasuredEdges = std::uint64_t{1} << 20;

/// What list_defects makes findings of; everything is empty if max_defects is 0.
struct DefectEvidence {
  std::size_t max_defects = 0;
  std::vector<std::uint32_t> degenerate;  ///< faces, all of them
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
      duplicates;  ///< the first such face, a later one
  std::vector<EdgeDefect> boundary, nonmanifold, misoriented;
  std::vector<VertexDefect> pinched;
  std::vector<OpenEdge> open_edges;  ///< in place of `boundary`, if they can be measured
  std::vector<std::pair<std::uint32_t, std::uint32_t>> improper;  ///< pairs of faces
  bool is_improper_ordered = false;  ///< they are the list; if not, largest_pairs makes it of them
};

struct ValidityReport {
  bool is_valid = false;
  MeshCounts counts;
  std::array<std::uint64_t, kNumMeshRules> rule_counts{};  ///< exact, by rule_index; M8 and M9 are 0 unless M1-M7 hold
  bool nesting_decided = false;  ///< M1-M7 hold, so M8 and M9 were decided
  std::vector<ImproperPlace> places;                       ///< where faces meet improperly (M7), all of them
  std::vector<ShellReport> shells;
  std::optional<Rational> volume;                          ///< sum over shells
  Box3d box{};                                             ///< of the referenced vertices
  bool long_thin = false;                                  ///< boxes overlapped too much; decided by the separator walk
  DecisionTimes seconds;
  DefectEvidence evidence;  ///< empty if the mesh is valid

  // What the certificate is made from.
  VertexStars stars;
  Nesting nesting;
  FacetMeetings meetings;  ///< of a valid mesh, if they are kept and not long_thin
};

/// Decides rules M1-M9. REQUIRES finite coordinates, ids in range, fewer than 2^30 faces, at least one face.
/// @cost approximately 0.3 microseconds per facet on ordinary meshes; near-linear on long thin facets; plus the number
/// of intersecting pairs.
ValidityReport decide_validity(const TriangleMesh& mesh, const ValidityOptions& options);

struct DefectList {
  /// By rule, at most max_defects of each, the largest first; intersections (M7) by their approximate size, those of
  /// faces with the same vertices last. Only the first 65,536 defects of M2, M4, M5 and M6, and of M3 without
  /// open_edges, are considered.
  std::vector<Finding> defects;
  /// The open edges as a whole, without `nearest`; nothing if the mesh is closed, has more than kMostMeasuredEdges of
  /// them, or if no defects are listed.
  std::optional<OpenEdges> open_edges;
};

/// The defects with their places, sizes and exact points. REQUIRES report = decide_validity(mesh, options).
/// @cost 5 to 100 microseconds for each intersection that is listed, more at extreme scales; 0.5 microseconds for each
/// of the first 16,384 that exist; near-linear in the open edges, whose gaps are measured.
DefectList list_defects(const TriangleMesh& mesh, const ValidityReport& report, unsigned jobs = 1);

}  // namespace veritope
