// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/validity.h"

#include <algorithm>
#include <numeric>

#include "robust/base/check.h"
#include "robust/base/parallel.h"
#include "robust/base/stopwatch.h"
#include "solids/polyhedron/box_order.h"
#include "solids/polyhedron/duplicates.h"
#include "solids/polyhedron/facet_signs.h"
#include "solids/polyhedron/improper_pairs.h"
#include "solids/polyhedron/volume.h"

namespace veritope {
namespace {

std::vector<std::uint32_t> proper_facets(std::size_t num_faces, const std::vector<std::uint32_t>& degenerate) {
  std::vector<std::uint32_t> out;
  if (degenerate.empty()) {
    out.resize(num_faces);
    std::iota(out.begin(), out.end(), 0u);
    return out;
  }
  out.reserve(num_faces - degenerate.size());
  auto skip = degenerate.begin();
  for (std::uint32_t f = 0; f < num_faces; ++f) {
    if (skip != degenerate.end() && *skip == f) {
      ++skip;
    } else {
      out.push_back(f);
    }
  }
  return out;
}

// One decision, step by step; each step fills its part of the report.
class Decision {
 public:
  Decision(const TriangleMesh& mesh, const ValidityOptions& options) : mesh_(mesh), options_(options) {
    VT_CHECK(!mesh.faces.empty() && mesh.faces.size() < Incidence::kMaxFaces, "number of faces");
    if (options_.jobs == 0) options_.jobs = 1;
  }

  ValidityReport run() {
    decide_topology();
    decide_pairs();
    measure_volume();
    decide_nesting();
    for (std::size_t i = 0; i < kNumMeshRules; ++i) any_ = any_ || report_.rule_counts[i] != 0;
    report_.is_valid = !any_;
    if (any_) report_.meetings = {};
    if (any_) keep_evidence();
    return std::move(report_);
  }

 private:
  std::uint64_t& rule(MeshRule r) { return report_.rule_counts[rule_index(r)]; }

  // Defects from which the largest are chosen: whatever max_defects is, so that the first one does not depend on it.
  std::size_t pool() const {
    constexpr std::size_t kPool = 1 << 16;
    return options_.max_defects == 0 ? 0 : kPool;
  }

  void decide_topology() {
    const auto num_vertices = static_cast<std::uint32_t>(mesh_.positions.size());
    Incidence incidence = Incidence::build(mesh_.faces, num_vertices, options_.jobs);
    report_.seconds.incidence = watch_.lap();
    signs_ = facet_signs(mesh_, options_.jobs);
    report_.seconds.signs = watch_.lap();
    topology_ = analyse_surface(mesh_.faces, incidence, pool(), options_.jobs);
    if (options_.max_defects > 0 && topology_.boundary_edges <= kMostMeasuredEdges &&
        topology_.boundary_edges > 0)
      open_edges_ = list_open_edges(mesh_, incidence, options_.jobs);
    duplicates_ = find_duplicate_faces(mesh_.faces, topology_, pool());
    report_.seconds.topology = watch_.lap();
    report_.stars = find_vertex_stars(mesh_, incidence, signs_, topology_.irregular, options_.jobs);
    report_.seconds.stars = watch_.lap();
    MeshCounts& c = report_.counts;
    c.faces = mesh_.faces.size();
    c.referenced_vertices = topology_.vertices;
    c.edges = topology_.edges;
    rule(MeshRule::kM1) = c.degenerate_faces = signs_.degenerate.size();
    rule(MeshRule::kM2) = c.duplicate_faces = duplicates_.count;
    rule(MeshRule::kM3) = c.boundary_edges = topology_.boundary_edges;
    rule(MeshRule::kM4) = c.nonmanifold_edges = topology_.nonmanifold_edges;
    rule(MeshRule::kM5) = c.misoriented_edges = topology_.misoriented_edges;
    rule(MeshRule::kM6) = c.nonmanifold_vertices = topology_.nonmanifold_vertices;
    c.shells = topology_.shells.size();
    c.euler = topology_.euler();
    is_manifold_ = topology_.is_closed_oriented_manifold() && c.degenerate_faces + c.duplicate_faces == 0;
    for (const Shell& s : topology_.shells) {
      ShellReport r;
      r.euler = s.euler();
      r.first_face = s.first_face;
      if (is_manifold_) {
        r.genus = (2 - s.euler()) / 2;
        c.genus = c.genus.value_or(0) + *r.genus;
      }
      report_.shells.push_back(std::move(r));
    }
  }

  // The groups of equal faces that are not degenerate.
  FaceCopies proper_copies() {
    auto groups = std::move(duplicates_.groups);
    std::erase_if(groups, [&](const FaceCopies::Group& g) {
      return std::binary_search(signs_.degenerate.begin(), signs_.degenerate.end(), g.front());
    });
    return FaceCopies(std::move(groups));
  }

  void decide_pairs() {
    report_.box = topology_.vertices == mesh_.positions.size() ? bounding_box(mesh_.positions, options_.jobs)
                                                                         : bounding_box_of_faces(mesh_, options_.jobs);
    const UnitScale scale(report_.box);
    facets_ = proper_facets(mesh_.faces.size(), signs_.degenerate);
    copies_ = proper_copies();
    if (!copies_.groups().empty()) facets_ = copies_.without_copies(facets_);
    std::vector<std::uint32_t> order = morton_order(mesh_, facets_, scale, options_.jobs);
    boxes_.emplace(mesh_, order, report_.stars, scale, options_.jobs);
    std::optional<MeetingCollector> collector;
    if (options_.keep_meetings && facets_.size() == mesh_.faces.size())
      collector.emplace(mesh_, std::move(order), *boxes_);
    report_.seconds.boxes = watch_.lap();
    pairs_ = find_improper_pairs(mesh_, *boxes_, facets_, report_.stars, options_.max_defects, options_.jobs,
                                 copies_, options_.work, collector ? &*collector : nullptr);
    report_.long_thin = pairs_.long_thin;
    if (collector && !pairs_.long_thin && pairs_.count == 0) report_.meetings = collector->finish();
    report_.places = std::move(pairs_.places);
    rule(MeshRule::kM7) = report_.counts.selfint_pairs = pairs_.count;
    report_.seconds.pairs = watch_.lap();
  }

  void measure_volume() {
    if (topology_.is_cycle && !topology_.shells.empty()) {
      const auto volumes =
          shell_volumes(mesh_, topology_.shell_of_face, topology_.shells.size(), options_.jobs);
      Rational sum;
      for (std::size_t s = 0; s < volumes.size(); ++s) {
        sum += volumes[s];
        report_.shells[s].volume = volumes[s];
      }
      report_.volume = std::move(sum);
    }
    report_.seconds.volume = watch_.lap();
  }

  void decide_nesting() {
    report_.nesting_decided = is_manifold_ && pairs_.count == 0;
    if (report_.nesting_decided) {
      report_.nesting =
          nest_shells(mesh_, *boxes_, topology_.shell_of_face, report_.shells.size(), options_.jobs);
      std::uint64_t bodies = 0;
      for (std::size_t s = 0; s < report_.shells.size(); ++s) {
        ShellReport& shell = report_.shells[s];
        const std::uint32_t depth = report_.nesting.depth[s];
        shell.depth = depth;
        shell.outward = shell.volume->sign() == Sign::kPositive;
        bodies += depth % 2 == 0;
        if (*shell.outward != (depth % 2 == 0)) ++rule(depth == 0 ? MeshRule::kM8 : MeshRule::kM9);
      }
      report_.counts.bodies = bodies;
    }
    report_.seconds.nesting = watch_.lap();
  }

  void keep_evidence() {
    DefectEvidence& e = report_.evidence;
    e.max_defects = options_.max_defects;
    if (e.max_defects == 0) return;
    e.degenerate = std::move(signs_.degenerate);
    e.duplicates = std::move(duplicates_.first);
    if (open_edges_.empty()) e.boundary = std::move(topology_.boundary);
    e.nonmanifold = std::move(topology_.nonmanifold);
    e.misoriented = std::move(topology_.misoriented);
    e.pinched = std::move(topology_.pinched);
    e.open_edges = std::move(open_edges_);
    e.improper = std::move(pairs_.pairs);
    e.is_improper_ordered = pairs_.is_ordered;
  }

  const TriangleMesh& mesh_;
  ValidityOptions options_;
  ValidityReport report_;
  Stopwatch watch_;
  FacetSigns signs_;
  SurfaceTopology topology_;
  std::vector<OpenEdge> open_edges_;  // empty if they are not measured
  DuplicateFaces duplicates_;
  std::vector<std::uint32_t> facets_;  // those that are not degenerate, copies left out
  FaceCopies copies_;
  std::optional<BoxGroups> boxes_;
  ImproperPairs pairs_;
  bool is_manifold_ = false;
  bool any_ = false;
};

}  // namespace

ValidityReport decide_validity(const TriangleMesh& mesh, const ValidityOptions& options) {
  const WorkerScope workers(std::max(1u, options.jobs));
  return Decision(mesh, options).run();
}

}  // namespace veritope
