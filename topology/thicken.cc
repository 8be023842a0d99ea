// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/thicken.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace veritope {
namespace {

class Filler {
 public:
  Filler(const CommonSubdivision& complex, const ComplexBoundary& boundary)
      : c_(complex),
        k_(complex.cells()),
        edge_cell_(boundary.bad_edges.size()),
        vertex_level_(boundary.bad_vertices.size(), 0) {
    find_cells(boundary);
    for (std::size_t i = 0; i < boundary.bad_edges.size(); ++i)
      fill_beside(boundary.bad_edges[i].edge, edge_cell_[i]);
    for (std::size_t i = 0; i < boundary.bad_vertices.size(); ++i)
      fill_around(boundary.bad_vertices[i].vertex, vertex_level_[i]);
  }

  /// The added cells that no other added cell contains: these are disjoint.
  std::vector<OctreeKey> result() {
    const auto before = [](OctreeKey a, OctreeKey b) {  // a cell before those that it contains
      return std::pair(a.first_code(), a.level()) < std::pair(b.first_code(), b.level());
    };
    std::sort(added_.begin(), added_.end(), before);
    std::vector<OctreeKey> out;
    for (const OctreeKey key : added_)
      if (out.empty() || !out.back().contains(key)) out.push_back(key);
    return out;
  }

 private:
  /// The finest cell at each bad edge, the finest level at each bad vertex.
  void find_cells(const ComplexBoundary& boundary) {
    for (std::uint32_t f = 0; f < c_.num_faces(); ++f) {
      if (c_.faces()[f].num_cells() != 1) continue;
      const OctreeKey cell = k_[c_.faces()[f].only_cell()];
      for (const std::uint32_t e : c_.edges_of_face(f)) {
        const auto bad = std::ranges::lower_bound(boundary.bad_edges, e, {}, &BadEdge::edge);
        if (bad != boundary.bad_edges.end() && bad->edge == e) {
          OctreeKey& finest =
              edge_cell_[static_cast<std::size_t>(bad - boundary.bad_edges.begin())];
          if (finest.level() <= cell.level()) finest = cell;
        }
        for (const std::uint32_t v : {c_.edges()[e].lower, c_.edges()[e].upper}) {
          const auto at =
              std::ranges::lower_bound(boundary.bad_vertices, v, {}, &BadVertex::vertex);
          if (at == boundary.bad_vertices.end() || at->vertex != v) continue;
          unsigned& level =
              vertex_level_[static_cast<std::size_t>(at - boundary.bad_vertices.begin())];
          level = std::max(level, cell.level());
        }
      }
    }
  }

  /// `cell` and the one diagonally across the edge are in K; its neighbour across the plane through the edge is not.
  void fill_beside(std::uint32_t edge, OctreeKey cell) {
    const unsigned axis = (c_.edge_axis(edge) + 1) % 3;
    const bool is_above = cell.corner()[axis] == c_.point(c_.edges()[edge].lower)[axis];
    fill(cell.neighbour(axis, !is_above).value());
  }

  void fill_around(std::uint32_t vertex, unsigned level) {
    const std::array<std::uint32_t, 3> p = c_.point(vertex);
    const std::uint32_t bits = p[0] | p[1] | p[2];
    const unsigned aligned =
        bits == 0 ? 0 : 20u - std::min(20u, static_cast<unsigned>(std::countr_zero(bits)));
    level = std::max(level, aligned);
    const unsigned shift = OctreeKey::kMaxLevel - level;
    for (std::uint32_t q = 0; q < 8; ++q) {
      const OctreeCell cell{level, (p[0] >> shift) - (q & 1), (p[1] >> shift) - (q >> 1 & 1),
                            (p[2] >> shift) - (q >> 2)};
      if (const Result<OctreeKey> key = OctreeKey::make(cell))
        fill(*key);  // else: beyond the root's walls
    }
  }

  /// Adds the parts of `node` that K leaves free.
  void fill(OctreeKey node) {
    const std::size_t at = k_.lower_bound(node.first_code());
    const bool has_part = at < k_.size() && node.contains(k_[at]);
    if (has_part && k_[at] != node) {
      for (unsigned q = 0; q < 8; ++q) fill(node.child(q));
      return;
    }
    const bool is_inside =
        (at < k_.size() && k_[at].contains(node)) || (at > 0 && k_[at - 1].contains(node));
    if (!is_inside) added_.push_back(node);
  }

  const CommonSubdivision& c_;
  const OctreeKeySet& k_;
  std::vector<OctreeKey> edge_cell_;
  std::vector<unsigned> vertex_level_;
  std::vector<OctreeKey> added_;
};

}  // namespace

std::vector<OctreeKey> cells_at_defects(const CommonSubdivision& complex,
                                        const ComplexBoundary& boundary) {
  if (boundary.is_manifold()) return {};
  return Filler(complex, boundary).result();
}

Result<CommonSubdivision> thicken_to_manifold(OctreeKeySet cells, std::uint32_t max_faces) {
  while (true) {
    Result<CommonSubdivision> complex = CommonSubdivision::build(std::move(cells), max_faces);
    if (!complex) return complex.error();
    const std::vector<OctreeKey> more = cells_at_defects(*complex, analyse_boundary(*complex));
    if (more.empty()) return complex;
    std::vector<OctreeKey> keys(complex->cells().keys().begin(), complex->cells().keys().end());
    keys.insert(keys.end(), more.begin(), more.end());
    Result<OctreeKeySet> grown = OctreeKeySet::make(std::move(keys));
    if (!grown) return grown.error();
    cells = std::move(*grown);
  }
}

}  // namespace veritope
