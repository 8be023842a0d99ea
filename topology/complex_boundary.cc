// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/complex_boundary.h"

#include <algorithm>
#include <array>
#include <utility>

#include "robust/base/disjoint_sets.h"

namespace veritope {
namespace {

using internal::kNone;

/// The 15 pairs of the six directions at a vertex (+x -x +y -y +z -z), as bits: the pairs that a face at the vertex
/// joins.
using Corners = std::uint16_t;
constexpr Corners pair_bit(unsigned p, unsigned q) {
  if (p > q) std::swap(p, q);
  return static_cast<Corners>(1u << (q * (q - 1) / 2 + p));
}

/// The number of classes of directions that occur in a pair.
unsigned num_classes(Corners corners) {
  std::array<unsigned, 6> reach{};  // as bit sets
  for (unsigned q = 1; q < 6; ++q)
    for (unsigned p = 0; p < q; ++p)
      if (corners & pair_bit(p, q)) {
        reach[p] |= 1u << q;
        reach[q] |= 1u << p;
      }
  unsigned open = 0, classes = 0;
  for (unsigned d = 0; d < 6; ++d) open |= reach[d] != 0 ? 1u << d : 0;
  for (; open != 0; ++classes) {
    unsigned reached = 0, front = open & (~open + 1);
    while (front != 0) {
      reached |= front;
      unsigned next = 0;
      for (unsigned d = 0; d < 6; ++d)
        if (front >> d & 1) next |= reach[d];
      front = next & ~reached;
    }
    open &= ~reached;
  }
  return classes;
}

class Analysis {
 public:
  explicit Analysis(const CommonSubdivision& complex)
      : c_(complex),
        num_at_edge_(c_.num_edges()),
        face_at_edge_(c_.num_edges(), kNone),
        corners_(c_.num_vertices()),
        face_at_vertex_(c_.num_vertices(), kNone),
        faces_(c_.num_faces()) {}

  ComplexBoundary run() {
    find_bodies();
    for (std::uint32_t f = 0; f < c_.num_faces(); ++f)
      if (c_.faces()[f].num_cells() == 1) add_boundary_face(f);
    find_bad();
    number_components();
    count_edges_and_vertices();
    return std::move(out_);
  }

 private:
  void find_bodies() {
    DisjointSets cells(c_.num_cells());
    for (const CommonSubdivision::Face& face : c_.faces())
      if (face.num_cells() == 2) cells.join(face.below, face.above);
    out_.body_of_cell.resize(c_.num_cells());
    for (std::uint32_t cell = 0; cell < c_.num_cells(); ++cell) {
      const std::uint32_t root = cells.find(cell);
      if (root == cell) {
        out_.body_of_cell[cell] = static_cast<std::uint32_t>(out_.bodies.size());
        out_.bodies.push_back({cell});
      } else {
        out_.body_of_cell[cell] = out_.body_of_cell[root];
      }
      ++out_.bodies[out_.body_of_cell[cell]].cells;
    }
  }

  void add_boundary_face(std::uint32_t f) {
    const std::span<const std::uint32_t> edges = c_.edges_of_face(f);
    for (const std::uint32_t e : edges) {
      ++num_at_edge_[e];
      if (face_at_edge_[e] == kNone)
        face_at_edge_[e] = f;
      else
        faces_.join(face_at_edge_[e], f);
    }
    add_corners(f, edges);
  }

  /// Adds the two edges of the face that meet at each of its vertices, corner or not.
  void add_corners(std::uint32_t f, std::span<const std::uint32_t> edges) {
    // edges_of_face: the sides in the order (0 1) (0 2) (2 3) (1 3) of the corners 0 least, 3 greatest, each from its
    // lower end.
    const unsigned b = (c_.faces()[f].axis + 1u) % 3, c = (c_.faces()[f].axis + 2u) % 3;
    std::uint32_t prev = kNone;
    for (const std::uint32_t e : edges) {
      const unsigned axis = c_.edge_axis(e);
      if (prev != kNone && c_.edge_axis(prev) == axis)  // of one side
        add_corner(f, c_.edges()[e].lower, pair_bit(2 * axis, 2 * axis + 1));
      prev = e;
    }
    const std::array<std::uint32_t, 4> corner = corners_of(f, edges);
    add_corner(f, corner[0], pair_bit(2 * b, 2 * c));
    add_corner(f, corner[1], pair_bit(2 * b + 1, 2 * c));
    add_corner(f, corner[2], pair_bit(2 * b, 2 * c + 1));
    add_corner(f, corner[3], pair_bit(2 * b + 1, 2 * c + 1));
  }

  std::array<std::uint32_t, 4> corners_of(std::uint32_t f,
                                          std::span<const std::uint32_t> edges) const {
    const unsigned b = (c_.faces()[f].axis + 1u) % 3;
    std::array<std::uint32_t, 4> corner{c_.faces()[f].corner, kNone, kNone,
                                        c_.edges()[edges.back()].upper};
    std::size_t i = 0;
    while (c_.edge_axis(edges[i]) == b) ++i;
    corner[1] = c_.edges()[edges[i - 1]].upper;
    while (c_.edge_axis(edges[i]) != b) ++i;
    corner[2] = c_.edges()[edges[i - 1]].upper;
    return corner;
  }

  void add_corner(std::uint32_t f, std::uint32_t vertex, Corners pair) {
    corners_[vertex] = static_cast<Corners>(corners_[vertex] | pair);
    face_at_vertex_[vertex] = f;
  }

  void find_bad() {
    for (std::uint32_t e = 0; e < c_.num_edges(); ++e)
      if (num_at_edge_[e] != 0 && num_at_edge_[e] != 2)
        out_.bad_edges.push_back({e, num_at_edge_[e]});
    for (std::uint32_t v = 0; v < c_.num_vertices(); ++v)
      if (corners_[v] != 0)
        if (const unsigned n = num_classes(corners_[v]); n > 1) out_.bad_vertices.push_back({v, n});
  }

  void number_components() {
    out_.component_of_face.assign(c_.num_faces(), kNone);
    for (std::uint32_t f = 0; f < c_.num_faces(); ++f) {
      const CommonSubdivision::Face& face = c_.faces()[f];
      if (face.num_cells() != 1) continue;
      const std::uint32_t root = faces_.find(f);
      if (root == f) {
        out_.component_of_face[f] = static_cast<std::uint32_t>(out_.components.size());
        out_.components.push_back({f, out_.body_of_cell[face.only_cell()]});
      } else {
        out_.component_of_face[f] = out_.component_of_face[root];
      }
      ++out_.components[out_.component_of_face[f]].faces;
    }
  }

  void count_edges_and_vertices() {
    for (const std::uint32_t f : face_at_edge_)
      if (f != kNone) ++out_.components[out_.component_of_face[f]].edges;
    // A bad vertex may belong to several components.
    for (const BadVertex& bad : out_.bad_vertices) face_at_vertex_[bad.vertex] = kNone;
    for (const std::uint32_t f : face_at_vertex_)
      if (f != kNone) ++out_.components[out_.component_of_face[f]].vertices;
    for (const std::uint32_t component : components_at_bad_vertices())
      ++out_.components[component].vertices;
  }

  /// Lists each component as often as it has bad vertices.
  std::vector<std::uint32_t> components_at_bad_vertices() const {
    if (out_.bad_vertices.empty()) return {};
    std::vector<bool> is_bad(c_.num_vertices());
    for (const BadVertex& bad : out_.bad_vertices) is_bad[bad.vertex] = true;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> at;
    for (std::uint32_t f = 0; f < c_.num_faces(); ++f) {
      if (out_.component_of_face[f] == kNone) continue;
      for (const std::uint32_t e : c_.edges_of_face(f))
        for (const std::uint32_t v : {c_.edges()[e].lower, c_.edges()[e].upper})
          if (is_bad[v]) at.emplace_back(v, out_.component_of_face[f]);
    }
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    std::vector<std::uint32_t> out;
    for (const auto& entry : at) out.push_back(entry.second);
    return out;
  }

  const CommonSubdivision& c_;
  ComplexBoundary out_;
  std::vector<std::uint8_t> num_at_edge_;    // boundary faces
  std::vector<std::uint32_t> face_at_edge_;  // one of them
  std::vector<Corners> corners_;             // of boundary faces
  std::vector<std::uint32_t> face_at_vertex_;
  DisjointSets<> faces_;
};

}  // namespace

std::vector<std::uint32_t> ComplexBoundary::faces_of(std::uint32_t component) const {
  std::vector<std::uint32_t> out;
  for (std::uint32_t f = 0; f < component_of_face.size(); ++f)
    if (component_of_face[f] == component) out.push_back(f);
  return out;
}

ComplexBoundary analyse_boundary(const CommonSubdivision& complex) {
  return Analysis(complex).run();
}

}  // namespace veritope
