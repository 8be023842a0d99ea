// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/refine_mesh.h"

#include <algorithm>
#include <numeric>

#include "robust/base/check.h"
#include "solids/dms/domain/short_vertices.h"

namespace veritope {
namespace {

using FaceCorners = std::array<std::uint32_t, 3>;

FaceCorners ascending(FaceCorners v) {
  std::sort(v.begin(), v.end());
  return v;
}

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

LinePlace place_on_line(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& p) {
  for (int axis = 0; axis < 3; ++axis)
    if (orient2d_projected(a, b, p, axis) != Sign::kZero) return LinePlace::kOff;
  std::size_t axis = 0;
  while (a.at()[axis] == b.at()[axis]) ++axis;
  const auto& [low, high] = std::minmax(a.at()[axis], b.at()[axis]);
  return low < p.at()[axis] && p.at()[axis] < high ? LinePlace::kBetween : LinePlace::kBeyond;
}

bool has_manifold_boundary(std::span<const TetrahedronCorners> tetrahedra) {
  std::map<FaceCorners, int> faces;
  for (const TetrahedronCorners& t : tetrahedra)
    for (const auto& face : kTetrahedronFaces)
      ++faces[ascending({t[face[0]], t[face[1]], t[face[2]]})];
  std::map<VertexPair, int> edges;
  for (const auto& [v, count] : faces) {
    if (count > 1) continue;
    ++edges[{v[0], v[1]}], ++edges[{v[0], v[2]}], ++edges[{v[1], v[2]}];
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 2; });
}

RefineMesh::RefineMesh(std::vector<ExactPoint3> points,
                       std::span<const TetrahedronCorners> tetrahedra)
    : points_(std::move(points)),
      complex_(static_cast<std::uint32_t>(points_.size())),
      facets_at_(points_.size()),
      at_vertex_(points_.size(), kNoFacet) {
  std::vector<std::uint32_t> all;
  for (const TetrahedronCorners& t : tetrahedra) {
    all.push_back(complex_.add(t));
    for (const std::uint32_t v : t) at_vertex_[v] = all.back();
  }
  complex_.glue_all(all);
  facet_.assign(4 * complex_.num_slots(), kNoFacet);
  find_facets();
}

void RefineMesh::find_facets() {
  std::vector<TetrahedronFace> faces;
  std::map<VertexPair, std::vector<std::uint32_t>> at_edge;
  for (TetrahedronFace f = 0; f < facet_.size(); ++f) {
    if (!is_on_boundary(f)) continue;
    const FaceCorners v = complex_.vertices(f);
    for (std::size_t k = 0; k < 3; ++k)
      at_edge[std::minmax(v[k], v[(k + 1) % 3])].push_back(
          static_cast<std::uint32_t>(faces.size()));
    faces.push_back(f);
  }
  std::vector<std::uint32_t> parent(faces.size());
  std::iota(parent.begin(), parent.end(), 0u);
  for (const auto& [edge, two] : at_edge) {
    VT_CHECK(two.size() == 2, "two faces of the boundary meet at each of its edges");
    const FaceCorners other = complex_.vertices(faces[two[1]]);
    const auto apex = std::find_if(other.begin(), other.end(), [&edge = edge](std::uint32_t v) {
      return v != edge.first && v != edge.second;
    });
    if (side(faces[two[0]], points_[*apex]) == Sign::kZero)
      parent[root_of(parent, two[0])] = root_of(parent, two[1]);
  }
  std::vector<std::uint32_t> number(faces.size(), kNoFacet);
  std::vector<std::uint64_t> bits;
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    std::uint32_t& facet = number[root_of(parent, i)];
    const FaceCorners v = complex_.vertices(faces[i]);
    const std::array<ExactPoint3, 3> frame{points_[v[0]], points_[v[1]], points_[v[2]]};
    const std::uint64_t length = num_bits(frame[0]) + num_bits(frame[1]) + num_bits(frame[2]);
    if (facet == kNoFacet) {
      facet = static_cast<std::uint32_t>(frames_.size());
      frames_.push_back(frame);
      bits.push_back(length);
    } else if (length < bits[facet]) {
      frames_[facet] = frame;
      bits[facet] = length;
    }
    facet_[faces[i]] = facet;
    for (const std::uint32_t corner : v) facets_at_[corner].push_back(facet);
  }
  for (auto& facets : facets_at_) {
    std::sort(facets.begin(), facets.end());
    facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
  }
  for (const auto& [edge, two] : at_edge) {
    const std::uint32_t f = facet_[faces[two[0]]], g = facet_[faces[two[1]]];
    if (f != g) segments_[edge] = std::minmax(f, g);
  }
}

Sign RefineMesh::side(TetrahedronFace f, const ExactPoint3& p) const {
  const TetrahedronCorners& c = complex_.corners(face_tetrahedron(f));
  std::array<const ExactPoint3*, 4> at;
  for (std::size_t m = 0; m < 4; ++m) at[m] = &points_[c[m]];
  at[face_corner(f)] = &p;
  return orient3d(*at[0], *at[1], *at[2], *at[3]);
}

bool RefineMesh::split_segment(const VertexPair& edge, std::uint32_t v) {
  const auto found = segments_.find(edge);
  if (found == segments_.end() ||
      place_on_line(points_[edge.first], points_[edge.second], points_[v]) != LinePlace::kBetween)
    return false;
  const FacetPair facets = found->second;
  segments_.erase(found);
  segments_[std::minmax(edge.first, v)] = segments_[std::minmax(edge.second, v)] = facets;
  return true;
}

void RefineMesh::note_kept(std::span<const TetrahedronFace> shell, BoundaryNotes& notes) const {
  for (const TetrahedronFace f : shell)
    if (is_on_boundary(f)) notes.kept[ascending(complex_.vertices(f))] = facet_[f];
}

void RefineMesh::take_added(std::span<const std::uint32_t> added, std::uint32_t apex,
                            const BoundaryNotes& notes) {
  facet_.resize(4 * complex_.num_slots(), kNoFacet);
  for (const std::uint32_t t : added) {
    for (const std::uint32_t v : complex_.corners(t)) at_vertex_[v] = t;
    for (TetrahedronFace f = 4 * t; f < 4 * t + 4; ++f) {
      facet_[f] = kNoFacet;
      if (!is_on_boundary(f)) continue;
      const FaceCorners corners = complex_.vertices(f);
      const auto kept = notes.kept.find(ascending(corners));
      if (kept != notes.kept.end()) {
        facet_[f] = kept->second;
        continue;
      }
      const auto k = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), apex) -
                                              corners.begin());
      facet_[f] = notes.rim.at(std::minmax(corners[(k + 1) % 3], corners[(k + 2) % 3]));
    }
  }
}

std::vector<std::uint32_t> RefineMesh::insert(ExactPoint3 p, const RefineCavity& cavity) {
  const auto v = static_cast<std::uint32_t>(points_.size());
  points_.push_back(std::move(p));
  at_vertex_.push_back(kNoFacet);
  BoundaryNotes notes;
  note_kept(cavity.shell, notes);
  std::set<std::uint32_t> facets;
  for (const TetrahedronFace f : cavity.opened) {
    facets.insert(facet_[f]);
    const FaceCorners corners = complex_.vertices(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexPair edge = std::minmax(corners[k], corners[(k + 1) % 3]);
      if (!split_segment(edge, v)) notes.rim[edge] = facet_[f];
    }
  }
  facets_at_.emplace_back(facets.begin(), facets.end());
  const std::vector<std::uint32_t> added = complex_.replace_by_cone(cavity.ball, cavity.shell, v);
  take_added(added, v, notes);
  return added;
}

std::vector<TetrahedronCorners> RefineMesh::tetrahedra() const {
  std::vector<TetrahedronCorners> out;
  for (std::uint32_t t = 0; t < complex_.num_slots(); ++t)
    if (complex_.is_used(t)) out.push_back(complex_.corners(t));
  return out;
}

}  // namespace veritope
