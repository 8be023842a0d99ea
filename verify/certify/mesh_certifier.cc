// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/mesh_certifier.h"

#include <algorithm>
#include <numeric>

#include "predicates/orient2d.h"
#include "predicates/projection.h"
#include "predicates/triangle_witness.h"
#include "robust/base/check.h"
#include "robust/base/parallel.h"
#include "solids/polyhedron/box_order.h"
#include "solids/polyhedron/box_tree.h"
#include "solids/polyhedron/defects.h"
#include "solids/polyhedron/facet_meetings.h"
#include "solids/polyhedron/facet_signs.h"
#include "solids/polyhedron/separating_axis.h"
#include "solids/polyhedron/separator.h"
#include "verify/certify/natural.h"
#include "verify/certify/pair_codes.h"
#include "verify/certify/pair_walk.h"

namespace veritope {
namespace {

using certificate::InvalidBody;
using certificate::Natural;
using certificate::ReversedBody;
using certificate::Separator;
using certificate::ValidBody;
using certificate::Witness;

// The contribution of one part of the walk; pair numbers count from the part's start.
struct PartWitness {
  std::uint64_t pairs = 0;
  std::vector<Separator> separators;
  std::vector<std::uint8_t> codes;
};

void add_codes(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b,
               std::vector<std::uint8_t>& out) {
  if (const auto axis = separating_axis(mesh, a, b)) return out.push_back(*axis);
  const auto codes = find_pair_codes(mesh, a, b);
  VT_CHECK(!codes.empty(), "no axes for a proper pair of facets");
  out.insert(out.end(), codes.begin(), codes.end());
}

struct SeparatingWalk {
  const TriangleMesh& mesh;
  const BoxTree& tree;
  SeparatorFinder finder;
  PartWitness out;

  bool stop() const { return false; }
  bool node_pair(const TreeRange& a, const TreeRange& b, std::uint64_t k) {
    if (!is_worth_separating(a, b)) return false;
    const auto d = finder.find(tree.facets(a), tree.facets(b));
    if (d) out.separators.push_back({k, *d});
    return d.has_value();
  }
  void leaf_pair(std::uint32_t i, std::uint32_t j) {
    add_codes(mesh, tree.order()[i], tree.order()[j], out.codes);
  }
};

std::vector<std::uint32_t> all_facets(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> out(mesh.faces.size());
  std::iota(out.begin(), out.end(), 0u);
  return out;
}

// The pairs are the leaf pairs that the walk without separators meets: no nodes above them are apart or have a star
// vertex in common.
void add_pairs(const TriangleMesh& mesh, const ValidityReport& report, unsigned jobs,
               WorkShare* work, ValidBody& body) {
  constexpr std::size_t kPairsInChunk = 8192;
  FacetMeetings found;
  const bool is_known = !report.meetings.order.empty();
  if (!is_known) found = find_facet_meetings(mesh, report.stars, report.box, jobs, work);
  const FacetMeetings& meetings = is_known ? report.meetings : found;
  const std::vector<std::uint32_t>& order = meetings.order;
  const auto pairs = sorted_as_walked(static_cast<std::uint32_t>(order.size()), meetings.pairs);
  std::vector<std::vector<std::uint8_t>> codes(num_chunks(pairs.size(), kPairsInChunk));
  WorkStep step(work, static_cast<double>(codes.size()));
  parallel_for(pairs.size(), kPairsInChunk, jobs,
               [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                 codes[chunk].reserve(end - begin);
                 for (const FacetMeeting& m : std::span(pairs).subspan(begin, end - begin))
                   if (m.axis != FacetMeeting::kNoAxis)
                     codes[chunk].push_back(m.axis);
                   else
                     add_codes(mesh, order[m.first], order[m.second], codes[chunk]);
                 step.add(1);
               });
  for (const auto& some : codes) body.codes.insert(body.codes.end(), some.begin(), some.end());
  body.order = is_known ? order : std::move(found.order);
}

void add_walk(const TriangleMesh& mesh, const ValidityReport& report, unsigned jobs,
              WorkShare* work, ValidBody& body) {
  const BoxTree tree(mesh, median_order(mesh, all_facets(mesh), jobs), report.stars, jobs);
  const auto parts = tree.parts();
  const double largest = largest_coordinate(mesh);
  std::vector<PartWitness> found(parts.size());
  WorkStep step(work, static_cast<double>(parts.size()));
  parallel_for(parts.size(), 1, jobs, [&](std::size_t k, std::size_t, std::size_t) {
    const std::size_t i =
        parts.size() - 1 - k;  // the longest parts are the last ones: they start first
    SeparatingWalk walk{mesh, tree, SeparatorFinder(mesh, largest), {}};
    walk.out.pairs = tree.walk(parts[i], walk);
    found[i] = std::move(walk.out);
    step.add(1);
  });
  std::uint64_t pairs = 0;
  for (PartWitness& p : found) {
    for (Separator& s : p.separators) {
      s.index += pairs;
      body.separators.push_back(s);
    }
    body.codes.insert(body.codes.end(), p.codes.begin(), p.codes.end());
    pairs += p.pairs;
  }
  body.order = tree.order();
}

ValidBody valid_body(const TriangleMesh& mesh, const ValidityReport& report, unsigned jobs,
                     WorkShare* work) {
  ValidBody body;
  body.num_vertex_ids = static_cast<std::uint32_t>(mesh.positions.size());
  body.stars = report.stars.code;
  for (const auto& [vertex, direction] : report.stars.own) body.star_vectors.push_back(direction);
  if (report.long_thin)
    add_walk(mesh, report, jobs, work, body);
  else
    add_pairs(mesh, report, jobs, work, body);
  if (report.shells.size() > 1) body.nesting = report.nesting.axis_code;
  return body;
}

// Bit f mod 8 of byte f / 8.
certificate::Bytes bits_of(const std::vector<bool>& flags) {
  certificate::Bytes out(flags.size() / 8 + (flags.size() % 8 != 0));
  for (std::size_t f = 0; f < flags.size(); ++f)
    if (flags[f]) out[f / 8] = static_cast<unsigned char>(out[f / 8] | 1u << (f % 8));
  return out;
}

certificate::Quantities quantities(const ValidityReport& report) {
  certificate::Quantities q;
  q.vertices = report.counts.referenced_vertices;
  q.edges = report.counts.edges;
  q.faces = report.counts.faces;
  q.shells = report.counts.shells;
  q.bodies = report.counts.bodies.value();
  q.genus = static_cast<std::uint64_t>(report.counts.genus.value());
  const Rational& v = report.volume.value();
  q.volume = v.numerator().to_string() + "/" + v.denominator().to_string();
  return q;
}

IndexedTriangle indexed(const TriangleMesh& mesh, std::uint32_t f) {
  const auto& t = mesh.faces[f];
  return {{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}, {t[0], t[1], t[2]}};
}

// An axis along which the face's normal has a component.
std::uint8_t axis_of(const TriangleMesh& mesh, std::uint32_t face) {
  const auto& t = mesh.faces[face];
  for (int axis = 0; axis < 3; ++axis)
    if (orient2d(drop_axis(mesh.positions[t[0]], axis), drop_axis(mesh.positions[t[1]], axis),
                 drop_axis(mesh.positions[t[2]], axis)) != Sign::kZero)
      return static_cast<std::uint8_t>(axis);
  VT_CHECK(false, "a degenerate face bounds a shell");
  return 0;
}

Witness witness_of(const TriangleMesh& mesh, const Finding& defect) {
  const ModelPlace& d = defect.place;
  const MeshRule rule = rule_of(defect);
  Witness w;
  w.rule = static_cast<std::uint8_t>(rule);
  switch (rule) {
    case MeshRule::kM1: w.first = d.faces[0]; break;
    case MeshRule::kM2:
      w.first = d.faces[0];
      w.second = d.faces[1];
      break;
    case MeshRule::kM3:
    case MeshRule::kM4:
    case MeshRule::kM5:
      w.first = d.edges[0].first;
      w.second = d.edges[0].second;
      break;
    case MeshRule::kM6: w.first = d.vertices[0]; break;
    case MeshRule::kM7: {
      w.first = d.faces[0];
      w.second = d.faces[1];
      const TriangleWitness point =
          triangle_witness(indexed(mesh, w.first), indexed(mesh, w.second));
      for (std::size_t i = 0; i < 3; ++i) {
        w.weights[i] = to_natural(point.t_weight[i]);
        w.weights[3 + i] = to_natural(point.u_weight[i]);
      }
      break;
    }
    case MeshRule::kM8:
    case MeshRule::kM9:
      w.first = d.faces[0];
      w.axis = axis_of(mesh, w.first);
      break;
  }
  return w;
}

// The first listed defect of each rule that has a witness.
InvalidBody invalid_body(const TriangleMesh& mesh, std::span<const Finding> defects) {
  InvalidBody body;
  body.num_faces = static_cast<std::uint32_t>(mesh.faces.size());
  body.num_vertex_ids = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Finding& d : defects) {
    const MeshRule rule = rule_of(d);
    if (!body.witnesses.empty() && body.witnesses.back().rule == static_cast<std::uint8_t>(rule))
      continue;
    // Two faces with the same vertices have no point outside their common simplex: M2 has their witness.
    if (rule == MeshRule::kM7 &&
        same_vertices(mesh.faces[d.place.faces[0]], mesh.faces[d.place.faces[1]]))
      continue;
    body.witnesses.push_back(witness_of(mesh, d));
  }
  VT_CHECK(!body.witnesses.empty(), "an invalid report lists no defect");
  return body;
}

}  // namespace

certificate::Bytes make_mesh_certificate(const TriangleMesh& mesh, const ValidityReport& report,
                                         std::span<const Finding> defects,
                                         const certificate::Subject& subject, unsigned jobs,
                                         WorkShare* work) {
  const WorkerScope workers(std::max(1u, jobs));
  if (report.is_valid)
    return certificate::encode(subject, quantities(report), valid_body(mesh, report, jobs, work));
  return certificate::encode(subject, invalid_body(mesh, defects));
}

certificate::ValidBody make_valid_body(const TriangleMesh& mesh, const ValidityReport& report,
                                       unsigned jobs, WorkShare* work) {
  VT_CHECK(report.is_valid, "only a valid mesh has such a body");
  const WorkerScope workers(std::max(1u, jobs));
  return valid_body(mesh, report, jobs, work);
}

certificate::Bytes make_mesh_certificate(const ReversedSolid& solid,
                                         const certificate::Subject& subject, unsigned jobs,
                                         WorkShare* work) {
  const WorkerScope workers(std::max(1u, jobs));
  VT_CHECK(solid.report.is_valid, "a reversal does not make the mesh valid");
  const ReversedBody body{bits_of(solid.reversal.is_reversed),
                          valid_body(solid.mesh, solid.report, jobs, work)};
  return certificate::encode(subject, quantities(solid.report), body, solid.reversal.whole_shells);
}

}  // namespace veritope
