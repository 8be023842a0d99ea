// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/convex_cells.h"

#include <algorithm>
#include <map>

#include "robust/base/check.h"

namespace veritope {
ConvexCells::ConvexCells(std::span<const Vec3d> points,
                         std::span<const TetrahedronCorners> tetrahedra,
                         std::vector<CellPlane> planes)
    : points_(points),
      planes_(std::move(planes)),
      vertices_(points.size()),
      marks_(points.size(), Sign::kZero),
      vertex_seen_(points.size(), 0) {
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> edge_of;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> face_of;
  const auto edge_between = [&](std::uint32_t a, std::uint32_t b) {
    const auto [at, is_new] = edge_of.try_emplace({std::min(a, b), std::max(a, b)}, 0);
    if (is_new) at->second = add_edge(a, b, {true, {a, b}});
    return at->second;
  };
  cells_.resize(tetrahedra.size());
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
    cells_[t].tetrahedron = t;
    for (const auto& local : kTetrahedronFaces) {
      CellPlane corners{};
      for (std::size_t k = 0; k < 3; ++k) corners[k] = tetrahedra[t][local[k]];
      CellPlane sorted = corners;
      std::sort(sorted.begin(), sorted.end());
      const auto [at, is_new] =
          face_of.try_emplace(sorted, static_cast<std::uint32_t>(faces_.size()));
      if (is_new) {
        CellFace face;
        face.corners.assign(corners.begin(), corners.end());
        face.plane = static_cast<std::uint32_t>(planes_.size());
        face.cells[0] = t;
        for (std::size_t k = 0; k < 3; ++k)
          face.edges.push_back(edge_between(corners[k], corners[(k + 1) % 3]));
        for (const std::uint32_t e : face.edges) edges_[e].faces.push_back(at->second);
        planes_.push_back(corners);
        faces_.push_back(std::move(face));
      } else {
        VT_CHECK(faces_[at->second].cells[1] == kNoCell, "at most two tetrahedra share a face");
        faces_[at->second].cells[1] = t;
      }
      // Faces turn counter-clockwise as seen from outside, so the first cell is on the negative side.
      cells_[t].faces.push_back(at->second);
      cells_[t].sides.push_back(
          {faces_[at->second].plane, is_new ? Sign::kNegative : Sign::kPositive});
    }
  }
}

std::uint32_t ConvexCells::add_edge(std::uint32_t a, std::uint32_t b, const CellLine& line) {
  edges_.push_back({{a, b}, line, {}});
  edge_seen_.push_back(0);
  return static_cast<std::uint32_t>(edges_.size() - 1);
}

std::uint32_t ConvexCells::add_crossing(const CellLine& line, std::uint32_t plane) {
  Vertex x;
  x.of = {line.of[0], line.of[1], plane};
  if (line.is_explicit) {
    x.kind = Vertex::Kind::kLinePlane;
    x.number = static_cast<std::uint32_t>(line_planes_.size());
    line_planes_.emplace_back(line_plane(line.of, plane));
  } else {
    x.kind = Vertex::Kind::kThreePlanes;
    x.number = static_cast<std::uint32_t>(three_planes_.size());
    three_planes_.emplace_back(three_planes(line.of, plane));
  }
  vertices_.push_back(x);
  marks_.push_back(Sign::kZero);
  vertex_seen_.push_back(0);
  return static_cast<std::uint32_t>(vertices_.size() - 1);
}

// Where both planes run through the same two points, these give the line: coordinates stay shorter.
CellLine ConvexCells::line_of(std::uint32_t plane, std::uint32_t other) const {
  std::array<std::uint32_t, 3> common{};
  std::size_t count = 0;
  for (const std::uint32_t a : planes_[plane])
    for (const std::uint32_t b : planes_[other])
      if (a == b) common[count++] = a;
  if (count >= 2) return {true, {common[0], common[1]}};
  return {false, {plane, other}};
}

const ConvexCells::Skeleton& ConvexCells::skeleton(std::uint32_t cell) const {
  ++round_;
  skeleton_.vertices.clear(), skeleton_.edges.clear();
  for (const std::uint32_t f : cells_[cell].faces) {
    for (const std::uint32_t v : faces_[f].corners)
      if (std::exchange(vertex_seen_[v], round_) != round_) skeleton_.vertices.push_back(v);
    for (const std::uint32_t e : faces_[f].edges)
      if (std::exchange(edge_seen_[e], round_) != round_) skeleton_.edges.push_back(e);
  }
  return skeleton_;
}

void ConvexCells::split_edge(std::uint32_t edge, std::uint32_t plane) {
  const std::uint32_t w = add_crossing(edges_[edge].line, plane);
  const std::uint32_t a = edges_[edge].ends[0], b = edges_[edge].ends[1];
  const std::uint32_t rest = add_edge(w, b, edges_[edge].line);
  edges_[edge].ends = {a, w};
  edges_[rest].faces = edges_[edge].faces;
  for (const std::uint32_t f : edges_[edge].faces) {
    CellFace& face = faces_[f];
    const auto at = std::find(face.edges.begin(), face.edges.end(), edge);
    const auto i = at - face.edges.begin();
    const bool is_forward = face.corners[static_cast<std::size_t>(i)] == a;
    *at = is_forward ? edge : rest;
    face.edges.insert(face.edges.begin() + i + 1, is_forward ? rest : edge);
    face.corners.insert(face.corners.begin() + i + 1, w);
  }
}

void ConvexCells::split_face(std::uint32_t f, std::uint32_t plane) {
  const auto g = static_cast<std::uint32_t>(faces_.size());
  CellFace old = std::move(faces_[f]);
  const std::size_t n = old.corners.size();
  std::size_t i = 0;
  while (mark(old.corners[i]) != Sign::kZero) ++i;
  std::size_t j = i + 1;
  while (mark(old.corners[j]) != Sign::kZero) ++j;
  const std::uint32_t cut = add_edge(old.corners[i], old.corners[j], line_of(old.plane, plane));
  CellFace first, second;
  first.plane = second.plane = old.plane;
  first.cells = second.cells = old.cells;
  const auto take = [&](std::size_t from, std::size_t to, CellFace& out) {
    for (std::size_t k = from; k != to; k = (k + 1) % n) {
      out.corners.push_back(old.corners[k]);
      out.edges.push_back(old.edges[k]);
    }
    out.corners.push_back(old.corners[to]);
    out.edges.push_back(cut);
  };
  take(i, j, first);
  take(j, i, second);
  for (const std::uint32_t e : second.edges)
    if (e != cut) std::replace(edges_[e].faces.begin(), edges_[e].faces.end(), f, g);
  edges_[cut].faces = {f, g};
  for (const std::uint32_t c : old.cells)
    if (c != kNoCell) cells_[c].faces.push_back(g);
  faces_[f] = std::move(first);
  faces_.push_back(std::move(second));
}

// The face in the plane: a loop of all edges whose ends lie in it.
std::uint32_t ConvexCells::add_section(std::uint32_t cell, std::uint32_t plane) {
  std::vector<std::uint32_t> rim;
  for (const std::uint32_t e : skeleton(cell).edges)
    if (mark(edges_[e].ends[0]) == Sign::kZero && mark(edges_[e].ends[1]) == Sign::kZero)
      rim.push_back(e);
  VT_CHECK(rim.size() >= 3, "a plane that cuts a cell meets it in a polygon");
  CellFace face;
  face.plane = plane;
  std::uint32_t at = edges_[rim[0]].ends[0];
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const auto next = std::find_if(
        rim.begin() + static_cast<std::ptrdiff_t>(k), rim.end(),
        [&](std::uint32_t e) { return edges_[e].ends[0] == at || edges_[e].ends[1] == at; });
    VT_CHECK(next != rim.end(), "the edges in a section form a loop");
    std::iter_swap(rim.begin() + static_cast<std::ptrdiff_t>(k), next);
    const CellEdge& edge = edges_[rim[k]];
    face.corners.push_back(at);
    face.edges.push_back(rim[k]);
    at = edge.ends[0] == at ? edge.ends[1] : edge.ends[0];
  }
  VT_CHECK(at == face.corners[0], "the edges in a section form one loop");
  const auto number = static_cast<std::uint32_t>(faces_.size());
  for (const std::uint32_t e : face.edges) edges_[e].faces.push_back(number);
  faces_.push_back(std::move(face));
  return number;
}

std::uint32_t ConvexCells::part_faces(std::uint32_t cell, std::uint32_t section) {
  const auto other = static_cast<std::uint32_t>(cells_.size());
  ConvexCell upper, lower;
  upper.tetrahedron = lower.tetrahedron = cells_[cell].tetrahedron;
  for (const std::uint32_t f : cells_[cell].faces) {
    Sign side = Sign::kZero;
    for (const std::uint32_t v : faces_[f].corners)
      if (mark(v) != Sign::kZero) side = mark(v);
    VT_CHECK(side != Sign::kZero, "no face of a cell lies in the plane that cuts it");
    (side == Sign::kPositive ? upper : lower).faces.push_back(f);
    if (side == Sign::kNegative)
      std::replace(faces_[f].cells.begin(), faces_[f].cells.end(), cell, other);
  }
  for (ConvexCell* const part : {&upper, &lower}) {
    for (const CellHalfSpace& s : cells_[cell].sides)
      if (std::any_of(part->faces.begin(), part->faces.end(),
                      [&](std::uint32_t f) { return faces_[f].plane == s.plane; }))
        part->sides.push_back(s);
    part->faces.push_back(section);
    part->sides.push_back(
        {faces_[section].plane, part == &upper ? Sign::kPositive : Sign::kNegative});
  }
  faces_[section].cells = {cell, other};
  cells_[cell] = std::move(upper);
  cells_.push_back(std::move(lower));
  return other;
}

std::uint32_t ConvexCells::cut(std::uint32_t cell, std::uint32_t plane) {
  const Skeleton& parts = skeleton(cell);
  for (const std::uint32_t v : parts.vertices) mark(v) = side(plane, v);
  const std::vector<std::uint32_t> old_edges = parts.edges;
  for (const std::uint32_t e : old_edges)
    if (mark(edges_[e].ends[0]) * mark(edges_[e].ends[1]) == Sign::kNegative) split_edge(e, plane);
  const std::vector<std::uint32_t> old_faces = cells_[cell].faces;
  for (const std::uint32_t f : old_faces) {
    bool is_above = false, is_below = false;
    for (const std::uint32_t v : faces_[f].corners) {
      is_above |= mark(v) == Sign::kPositive;
      is_below |= mark(v) == Sign::kNegative;
    }
    if (is_above && is_below) split_face(f, plane);
  }
  return part_faces(cell, add_section(cell, plane));
}

}  // namespace veritope
