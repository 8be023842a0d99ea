// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/collapse.h"

#include <algorithm>
#include <utility>

#include "robust/base/random.h"

namespace veritope {
namespace {

using internal::kNone;

/// What remains of the cells of one dimension below 3: how many cofaces each has, and the exclusive or of their ids,
/// which is the coface's id when there is only one. So no list of cofaces is needed.
class Remaining {
 public:
  explicit Remaining(std::size_t size) : state_(size, kAbsent), cofaces_(size, 0) {}

  bool is_absent(std::uint32_t s) const { return state_[s] == kAbsent; }
  bool is_free(std::uint32_t s) const { return state_[s] == 1; }
  /// Present and not in d+.
  bool is_left(std::uint32_t s) const { return state_[s] < kInDPlus; }
  std::uint32_t coface(std::uint32_t s) const { return cofaces_[s]; }  ///< REQUIRES is_free(s)

  void add(std::uint32_t s) { state_[s] = 0; }
  void add_coface(std::uint32_t s, std::uint32_t t) {
    ++state_[s];
    cofaces_[s] ^= t;
  }
  void drop_coface(std::uint32_t s, std::uint32_t t) {
    --state_[s];
    cofaces_[s] ^= t;
  }
  void put_in_d_plus(std::uint32_t s) { state_[s] |= kInDPlus; }
  void remove(std::uint32_t s) { state_[s] = kGone; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(state_.size()); }

 private:
  // Below kInDPlus: the number of remaining cofaces, at most 6. The cofaces of a removed cell were removed before it.
  static constexpr std::uint8_t kInDPlus = 0x10, kGone = 0x40, kAbsent = 0x80;
  std::vector<std::uint8_t> state_;
  std::vector<std::uint32_t> cofaces_;
};

class Collapser {
 public:
  Collapser(const CommonSubdivision& complex, const ComplexBoundary& boundary,
            std::span<const std::uint32_t> bodies, std::span<const std::uint32_t> d_plus)
      : c_(complex),
        boundary_(boundary),
        d_plus_(boundary.bodies.size(), kNone),
        faces_(c_.num_faces()),
        edges_(c_.num_edges()),
        vertices_(c_.num_vertices()) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      d_plus_[bodies[i]] = d_plus[i];
      out_.remaining[3] += boundary.bodies[bodies[i]].cells;
    }
    for (std::uint32_t f = 0; f < c_.num_faces(); ++f)
      if (d_plus_[body_of_face(f)] != kNone) add_face(f);
    for (std::uint32_t f = 0; f < c_.num_faces(); ++f)
      if (boundary_.component_of_face[f] != kNone &&
          boundary_.component_of_face[f] == d_plus_[body_of_face(f)])
        put_in_d_plus(f);
  }

  CollapseAttempt run(CollapseOrder order, std::uint64_t seed) {
    collapse_cells(order, seed);
    collapse_faces();
    collapse_edges();
    find_stuck();
    if (!out_.stuck.empty()) forget_stuck();
    return std::move(out_);
  }

 private:
  std::uint32_t body_of_face(std::uint32_t f) const {
    const CommonSubdivision::Face& face = c_.faces()[f];
    return boundary_.body_of_cell[face.below != kNone ? face.below : face.above];
  }

  void add_face(std::uint32_t f) {
    faces_.add(f);
    for (const std::uint32_t cell : {c_.faces()[f].below, c_.faces()[f].above})
      if (cell != kNone) faces_.add_coface(f, cell);
    for (const std::uint32_t e : c_.edges_of_face(f)) {
      if (edges_.is_absent(e)) add_edge(e);
      edges_.add_coface(e, f);
    }
  }
  void add_edge(std::uint32_t e) {
    edges_.add(e);
    for (const std::uint32_t v : {c_.edges()[e].lower, c_.edges()[e].upper}) {
      if (vertices_.is_absent(v)) vertices_.add(v);
      vertices_.add_coface(v, e);
    }
  }
  void put_in_d_plus(std::uint32_t f) {
    faces_.put_in_d_plus(f);
    for (const std::uint32_t e : c_.edges_of_face(f)) {
      edges_.put_in_d_plus(e);
      vertices_.put_in_d_plus(c_.edges()[e].lower);
      vertices_.put_in_d_plus(c_.edges()[e].upper);
    }
  }

  void collapse_cells(CollapseOrder order, std::uint64_t seed) {
    std::vector<std::uint32_t> front;
    for (std::uint32_t f = 0; f < faces_.size(); ++f)
      if (faces_.is_free(f)) front.push_back(f);
    Random random(seed);
    if (order != CollapseOrder::kBreadthFirst) std::shuffle(front.begin(), front.end(), random);
    for (std::size_t next = 0; next < front.size(); ++next) {
      if (order == CollapseOrder::kRandomFront)
        std::swap(front[next], front[next + random.below(front.size() - next)]);
      const std::uint32_t f = front[next];
      if (!faces_.is_free(f)) continue;
      const std::uint32_t cell = faces_.coface(f);
      out_.sequence.cells.push_back({f, cell});
      for (const std::uint32_t g : c_.faces_of_cell(cell)) {
        faces_.drop_coface(g, cell);
        if (faces_.is_free(g)) front.push_back(g);
      }
      faces_.remove(f);
      for (const std::uint32_t e : c_.edges_of_face(f)) edges_.drop_coface(e, f);
    }
  }

  void collapse_faces() {
    std::vector<std::uint32_t> front;
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
      if (edges_.is_free(e)) front.push_back(e);
    while (!front.empty()) {
      const std::uint32_t e = front.back();
      front.pop_back();
      if (!edges_.is_free(e)) continue;
      const std::uint32_t f = edges_.coface(e);
      out_.sequence.faces.push_back({e, f});
      for (const std::uint32_t g : c_.edges_of_face(f)) {
        edges_.drop_coface(g, f);
        if (edges_.is_free(g)) front.push_back(g);
      }
      faces_.remove(f);
      remove_edge(e);
    }
  }

  void collapse_edges() {
    std::vector<std::uint32_t> front;
    for (std::uint32_t v = 0; v < vertices_.size(); ++v)
      if (vertices_.is_free(v)) front.push_back(v);
    while (!front.empty()) {
      const std::uint32_t v = front.back();
      front.pop_back();
      if (!vertices_.is_free(v)) continue;
      const std::uint32_t e = vertices_.coface(v);
      out_.sequence.edges.push_back({v, e});
      remove_edge(e);
      for (const std::uint32_t w : {c_.edges()[e].lower, c_.edges()[e].upper})
        if (vertices_.is_free(w)) front.push_back(w);
      vertices_.remove(v);
    }
  }

  void remove_edge(std::uint32_t e) {
    edges_.remove(e);
    vertices_.drop_coface(c_.edges()[e].lower, e);
    vertices_.drop_coface(c_.edges()[e].upper, e);
  }

  void note_left(unsigned dimension, std::uint32_t id) {
    ++out_.remaining[dimension];
    if (out_.remaining[dimension] == 1) out_.remains_at = {dimension, id};
  }

  void find_stuck() {
    out_.remaining[3] -= out_.sequence.cells.size();
    VT_CHECK(out_.remaining[3] == 0, "a body whose boundary is d+ alone");
    for (std::uint32_t v = 0; v < vertices_.size(); ++v)
      if (vertices_.is_left(v)) note_left(0, v);
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
      if (edges_.is_left(e)) note_left(1, e);
    for (std::uint32_t f = 0; f < faces_.size(); ++f)
      if (faces_.is_left(f)) note_left(2, f);
    if (out_.remaining == std::array<std::uint64_t, 4>{}) return;
    std::vector<bool> is_stuck(d_plus_.size());
    for (std::uint32_t f = 0; f < c_.num_faces(); ++f)
      if (d_plus_[body_of_face(f)] != kNone && is_left_at(f)) is_stuck[body_of_face(f)] = true;
    for (std::uint32_t b = 0; b < d_plus_.size(); ++b)
      if (is_stuck[b]) out_.stuck.push_back(b);
  }

  bool is_left_at(std::uint32_t f) const {
    if (faces_.is_left(f)) return true;
    for (const std::uint32_t e : c_.edges_of_face(f))
      if (edges_.is_left(e) || vertices_.is_left(c_.edges()[e].lower) ||
          vertices_.is_left(c_.edges()[e].upper))
        return true;
    return false;
  }

  void forget_stuck() {
    std::vector<bool> is_stuck(d_plus_.size());
    for (const std::uint32_t b : out_.stuck) is_stuck[b] = true;
    std::vector<bool> stuck_edge(c_.num_edges());
    for (std::uint32_t f = 0; f < c_.num_faces(); ++f)
      if (is_stuck[body_of_face(f)])
        for (const std::uint32_t e : c_.edges_of_face(f)) stuck_edge[e] = true;
    std::erase_if(out_.sequence.cells,
                  [&](const Collapse& c) { return is_stuck[boundary_.body_of_cell[c.coface]]; });
    std::erase_if(out_.sequence.faces,
                  [&](const Collapse& c) { return is_stuck[body_of_face(c.coface)]; });
    std::erase_if(out_.sequence.edges, [&](const Collapse& c) { return stuck_edge[c.coface]; });
  }

  const CommonSubdivision& c_;
  const ComplexBoundary& boundary_;
  std::vector<std::uint32_t> d_plus_;  // of each body; kNone: not to be collapsed
  Remaining faces_, edges_, vertices_;
  CollapseAttempt out_;
};

}  // namespace

CollapseAttempt collapse_greedily(const CommonSubdivision& complex, const ComplexBoundary& boundary,
                                  std::span<const std::uint32_t> bodies,
                                  std::span<const std::uint32_t> d_plus, CollapseOrder order,
                                  std::uint64_t seed) {
  return Collapser(complex, boundary, bodies, d_plus).run(order, seed);
}

std::string name_of(const CommonSubdivision& complex, unsigned dimension, std::uint32_t id) {
  if (dimension == 3) return "cell " + to_string(complex.cells()[id].cell());
  const unsigned level = complex.cells().finest_level(), up = OctreeKey::kMaxLevel - level;
  const auto point = [&](std::uint32_t v) {
    const std::array<std::uint32_t, 3> p = complex.point(v);
    return "(" + std::to_string(p[0] >> up) + " " + std::to_string(p[1] >> up) + " " +
           std::to_string(p[2] >> up) + ")";
  };
  const std::string unit = " / " + std::to_string(1u << level);
  if (dimension == 0) return "vertex " + point(id) + unit;
  if (dimension == 1)
    return "edge " + point(complex.edges()[id].lower) + "-" + point(complex.edges()[id].upper) +
           unit;
  const std::span<const std::uint32_t> edges = complex.edges_of_face(id);
  return "face " + point(complex.faces()[id].corner) + "-" +
         point(complex.edges()[edges.back()].upper) + unit;
}

}  // namespace veritope
