// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/defects.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "predicates/triangle_witness.h"
#include "robust/base/parallel.h"
#include "solids/polyhedron/improper_pairs.h"

namespace veritope {
namespace {

std::array<Rational, 3> exact(const Vec3d& p) {
  return {Rational::from_double(p.x), Rational::from_double(p.y), Rational::from_double(p.z)};
}

// (sum of weight * point) / (sum of weights).
RationalPoint weighted(std::initializer_list<std::pair<int, const Vec3d*>> terms) {
  RationalPoint out;
  Rational total;
  for (const auto& [weight, point] : terms) {
    const auto p = exact(*point);
    for (std::size_t k = 0; k < 3; ++k) out.at[k] += Rational(weight) * p[k];
    total += Rational(weight);
  }
  for (Rational& c : out.at) c /= total;
  return out;
}

// Infinite if it is beyond binary64, but never NaN.
double distance(const Vec3d& a, const Vec3d& b) {
  const double out = std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
  if (std::isfinite(out)) return out;  // differences overflowed, maybe
  return 2 * std::hypot(a.x / 2 - b.x / 2, a.y / 2 - b.y / 2, a.z / 2 - b.z / 2);
}

double diameter(const TriangleMesh& mesh, std::uint32_t face) {
  const auto& t = mesh.faces[face];
  const Vec3d &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
  return std::max({distance(a, b), distance(b, c), distance(c, a)});
}

// The root of degree 2 or 3 of a >= 0, rounded; in range whenever the root is, though a may not be.
double rounded_root(const Rational& a, int degree) {
  if (a.sign() == Sign::kZero) return 0;
  const auto bits = [](const Integer& n) { return static_cast<std::int64_t>(n.bit_length()); };
  const std::int64_t exponent = (bits(a.numerator()) - bits(a.denominator())) / degree;
  const double near_one = nearest_double(a * Rational::power_of_two(-degree * exponent));
  return std::ldexp(degree == 2 ? std::sqrt(near_one) : std::cbrt(near_one), static_cast<int>(exponent));
}

Finding new_defect(MeshRule rule) {
  Finding out;
  out.code = rule_text(rule).id;
  return out;
}

std::string list(const std::vector<std::uint32_t>& ids) {
  constexpr std::size_t kMost = 8;
  std::string out;
  for (std::size_t i = 0; i < std::min(ids.size(), kMost); ++i) out += (i == 0 ? "" : ", ") + std::to_string(ids[i]);
  return ids.size() > kMost ? out + " and " + std::to_string(ids.size() - kMost) + " more" : out;
}

// An edge may have millions of faces; the message has their number.
std::vector<std::uint32_t> first_of(const std::vector<std::uint32_t>& faces) {
  constexpr std::size_t kMost = 1000;
  return {faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(std::min(faces.size(), kMost))};
}

std::string edge_sentence(MeshRule rule, const EdgeDefect& e) {
  const std::string edge = "edge " + std::to_string(e.a) + "-" + std::to_string(e.b);
  if (rule == MeshRule::kM3) return edge + " has one face only (" + list(e.faces) + "): the surface is open there";
  if (rule == MeshRule::kM4) return edge + " has " + std::to_string(e.faces.size()) + " faces (" + list(e.faces) + ")";
  return "faces " + list(e.faces) + " both run along " + edge + " in the same direction: one of them is turned over";
}

}  // namespace

bool same_vertices(std::array<std::uint32_t, 3> f, std::array<std::uint32_t, 3> g) {
  std::sort(f.begin(), f.end());
  std::sort(g.begin(), g.end());
  return f == g;
}

RationalPoint witness_point(const TriangleMesh& mesh, std::uint32_t face) {
  const auto& t = mesh.faces[face];
  return weighted({{2, &mesh.positions[t[0]]}, {1, &mesh.positions[t[1]]}, {1, &mesh.positions[t[2]]}});
}

template <typename Size>
std::vector<std::size_t> DefectLister::largest(std::size_t count, Size size) const {
  std::vector<double> sizes;
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < count; ++i) sizes.push_back(size(i)), out.push_back(i);
  const auto precedes = [&](std::size_t i, std::size_t j) {
    return sizes[i] != sizes[j] ? sizes[i] > sizes[j] : i < j;
  };
  const std::size_t kept = std::min(count, max_listed_);
  std::partial_sort(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(kept), out.end(), precedes);
  out.resize(kept);
  return out;
}

void DefectLister::degenerate(const std::vector<std::uint32_t>& faces) {
  for (const std::size_t i : largest(faces.size(), [&](std::size_t k) { return diameter(mesh_, faces[k]); })) {
    const auto& t = mesh_.faces[faces[i]];
    const bool repeated = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    Finding d = new_defect(MeshRule::kM1);
    d.place.faces = {faces[i]};
    d.place.vertices.assign(t.begin(), t.end());
    d.witness.point = RationalPoint{exact(mesh_.positions[t[0]])};
    d.place.size = diameter(mesh_, faces[i]);
    d.message = "face " + std::to_string(faces[i]) + " has no area: " +
                (repeated ? "two of its corners are one vertex" : "its corners lie on one line") + " (vertices " +
                list(d.place.vertices) + ")";
    defects_.push_back(std::move(d));
  }
}

void DefectLister::duplicate(const FacePairs& pairs) {
  const auto size = [&](std::size_t k) { return diameter(mesh_, pairs[k].second); };
  for (const std::size_t i : largest(pairs.size(), size)) {
    const auto& [first, later] = pairs[i];
    const auto& t = mesh_.faces[later];
    Finding d = new_defect(MeshRule::kM2);
    d.place.faces = {first, later};
    d.place.vertices.assign(t.begin(), t.end());
    d.witness.point = witness_point(mesh_, later);
    d.place.size = diameter(mesh_, later);
    d.message = "face " + std::to_string(later) + " has the same three vertices as face " + std::to_string(first);
    defects_.push_back(std::move(d));
  }
}

Finding DefectLister::edge_defect(MeshRule rule, const EdgeDefect& e) const {
  Finding d = new_defect(rule);
  d.place.faces = first_of(e.faces);
  d.place.edges = {{e.a, e.b}};
  const Vec3d &a = mesh_.positions[e.a], &b = mesh_.positions[e.b];
  d.witness.point = weighted({{1, &a}, {1, &b}});
  d.witness.ends = {RationalPoint{exact(a)}, RationalPoint{exact(b)}};
  d.place.size = distance(a, b);
  d.message = edge_sentence(rule, e);
  return d;
}

void DefectLister::add_edges(MeshRule rule, const std::vector<EdgeDefect>& edges) {
  const auto size = [&](std::size_t k) { return distance(mesh_.positions[edges[k].a], mesh_.positions[edges[k].b]); };
  for (const std::size_t i : largest(edges.size(), size)) defects_.push_back(edge_defect(rule, edges[i]));
}

void DefectLister::open_edges(std::span<const OpenEdge> edges, std::span<const NearestEdge> nearest) {
  const auto size = [&](std::size_t k) { return distance(mesh_.positions[edges[k].a], mesh_.positions[edges[k].b]); };
  for (const std::size_t i : largest(edges.size(), size)) {
    const auto ids = [](const OpenEdge& e) { return std::minmax(e.a, e.b); };
    Finding d = edge_defect(MeshRule::kM3, {ids(edges[i]).first, ids(edges[i]).second, {edges[i].face}});
    if (nearest[i].edge != NearestEdge::kNone) {
      const OpenEdge& other = edges[nearest[i].edge];
      d.place.near_edge = {ids(other).first, ids(other).second};
      d.witness.squared_gap = squared_gap(ends_of(mesh_, edges[i]), ends_of(mesh_, other));
      d.witness.approx_distance = nearest_root(*d.witness.squared_gap);
    }
    defects_.push_back(std::move(d));
  }
}

void DefectLister::topology(const DefectEvidence& evidence) {
  add_edges(MeshRule::kM3, evidence.boundary);
  add_edges(MeshRule::kM4, evidence.nonmanifold);
  add_edges(MeshRule::kM5, evidence.misoriented);
  for (std::size_t i = 0; i < std::min(evidence.pinched.size(), max_listed_); ++i) {
    const VertexDefect& v = evidence.pinched[i];
    Finding d = new_defect(MeshRule::kM6);
    d.place.faces = first_of(v.faces);
    d.place.vertices = {v.vertex};
    d.witness.point = RationalPoint{exact(mesh_.positions[v.vertex])};
    d.message = "the faces at vertex " + std::to_string(v.vertex) + " form " + std::to_string(v.fans) +
                " fans that touch in this point only (one face of each: " + list(v.faces) + ")";
    defects_.push_back(std::move(d));
  }
}

void DefectLister::improper(const FacePairs& pairs) {
  const auto indexed = [&](std::uint32_t f) {
    const auto& t = mesh_.faces[f];
    return IndexedTriangle{{mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]]}, {t[0], t[1], t[2]}};
  };
  for (const auto& [f, g] : pairs) {
    Finding d = new_defect(MeshRule::kM7);
    d.place.faces = {f, g};
    if (same_vertices(mesh_.faces[f], mesh_.faces[g])) {
      d.witness.point = witness_point(mesh_, f);
      d.place.size = diameter(mesh_, f);
      d.message = "faces " + std::to_string(f) + " and " + std::to_string(g) + " cover each other: same vertices (M2)";
      defects_.push_back(std::move(d));
      continue;
    }
    TriangleWitness w = triangle_witness(indexed(f), indexed(g));
    d.place.size = rounded_root(w.squared_extent, 2);
    if (w.squared_extent.sign() != Sign::kZero)
      d.witness.ends = {RationalPoint{std::move(w.ends[0])}, RationalPoint{std::move(w.ends[1])}};
    d.witness.point = RationalPoint{std::move(w.point)};
    d.message = "faces " + std::to_string(f) + " and " + std::to_string(g) +
                (w.squared_extent.sign() == Sign::kZero ? " touch in a point that is no common vertex"
                                                        : " meet outside their common vertex or edge");
    defects_.push_back(std::move(d));
  }
}

void DefectLister::nesting(const std::vector<ShellReport>& shells) {
  for (const MeshRule rule : {MeshRule::kM8, MeshRule::kM9}) {
    std::size_t listed = 0;
    for (std::size_t s = 0; s < shells.size() && listed < max_listed_; ++s) {
      const std::uint32_t depth = *shells[s].depth;
      if (*shells[s].outward == (depth % 2 == 0) || (depth == 0) != (rule == MeshRule::kM8)) continue;
      ++listed;
      Finding d = new_defect(rule);
      d.place.faces = {shells[s].first_face};
      d.witness.point = witness_point(mesh_, shells[s].first_face);
      d.place.size = rounded_root(abs(*shells[s].volume), 3);
      d.message = "shell " + std::to_string(s) + " (face " + std::to_string(shells[s].first_face) +
                  " is one of its faces) lies inside " + std::to_string(depth) + " shells and faces " +
                  (*shells[s].outward ? "outward" : "inward") + "; it should face " +
                  (depth % 2 == 0 ? "outward" : "inward");
      defects_.push_back(std::move(d));
    }
  }
}

DefectList list_defects(const TriangleMesh& mesh, const ValidityReport& report, unsigned jobs) {
  const DefectEvidence& evidence = report.evidence;
  DefectList out;
  if (evidence.max_defects == 0) return out;
  const WorkerScope workers(std::max(1u, jobs));
  DefectLister lister(mesh, evidence.max_defects);
  lister.degenerate(evidence.degenerate);
  lister.duplicate(evidence.duplicates);
  if (!evidence.open_edges.empty()) {
    out.open_edges = analyse_open_edges(mesh, evidence.open_edges, std::max(1u, jobs));
    lister.open_edges(evidence.open_edges, out.open_edges->nearest);
    out.open_edges->nearest = {};
  }
  lister.topology(evidence);
  lister.improper(evidence.is_improper_ordered
                      ? evidence.improper
                      : largest_pairs(mesh, evidence.improper, evidence.max_defects));
  if (report.nesting_decided) lister.nesting(report.shells);
  out.defects = lister.take();
  return out;
}

}  // namespace veritope
