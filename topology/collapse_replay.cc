// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/collapse_replay.cc: replay_collapse of collapse.h; shares no state with the search.
#include "topology/collapse.h"

namespace veritope {
namespace {

class Replay {
 public:
  explicit Replay(const CommonSubdivision& complex) : c_(complex) {
    size_ = {c_.num_vertices(), c_.num_edges(), c_.num_faces(), c_.num_cells()};
    for (unsigned d = 0; d < 4; ++d) {
      num_cofaces_[d].assign(size_[d], 0);
      is_absent_[d].assign(size_[d], false);
      in_d_plus_[d].assign(size_[d], false);
    }
    for (unsigned d = 1; d < 4; ++d)
      for (std::uint32_t t = 0; t < size_[d]; ++t)
        for_each_side(d, t, [&](std::uint32_t s) { ++num_cofaces_[d - 1][s]; });
  }

  CollapseCheck run(std::span<const std::uint32_t> d_plus, const CollapseSequence& sequence) {
    if (!accept_d_plus(d_plus) || !accept_whole_components()) return out_;
    if (!accept(3, sequence.cells) || !accept(2, sequence.faces) || !accept(1, sequence.edges))
      return out_;
    accept_end();
    return out_;
  }

 private:
  template <typename Visit>
  void for_each_side(unsigned dimension, std::uint32_t t, Visit&& visit) const {
    if (dimension == 1) {
      visit(c_.edges()[t].lower);
      visit(c_.edges()[t].upper);
    } else {
      for (const std::uint32_t s : dimension == 2 ? c_.edges_of_face(t) : c_.faces_of_cell(t))
        visit(s);
    }
  }

  bool reject(CollapseFault fault, unsigned dimension, std::uint32_t id, const std::string& why) {
    out_.fault = fault;
    out_.dimension = dimension;
    out_.id = id;
    static constexpr const char* kDimension[] = {"vertex ", "edge ", "face ", "cell "};
    out_.message = id < size_[dimension] ? name_of(c_, dimension, id)
                                         : kDimension[dimension] + std::to_string(id);
    out_.message += " " + why;
    return false;
  }

  bool accept_d_plus(std::span<const std::uint32_t> d_plus) {
    for (std::size_t i = 0; i < d_plus.size(); ++i) {
      const std::uint32_t f = d_plus[i];
      if (f >= size_[2]) return reject(CollapseFault::kNoSuchCell, 2, f, "of d+ does not exist");
      if (i > 0 && d_plus[i - 1] >= f)
        return reject(CollapseFault::kNoSuchCell, 2, f, "of d+ is not after the one before it");
      if (c_.faces()[f].num_cells() != 1)
        return reject(CollapseFault::kNotBoundary, 2, f, "of d+ lies between two cells");
      in_d_plus_[2][f] = true;
      for (const std::uint32_t e : c_.edges_of_face(f)) {
        in_d_plus_[1][e] = true;
        in_d_plus_[0][c_.edges()[e].lower] = in_d_plus_[0][c_.edges()[e].upper] = true;
      }
    }
    return true;
  }

  bool accept_whole_components() {
    for (std::uint32_t f = 0; f < size_[2]; ++f) {
      if (c_.faces()[f].num_cells() != 1 || in_d_plus_[2][f]) continue;
      for (const std::uint32_t e : c_.edges_of_face(f))
        if (in_d_plus_[1][e])
          return reject(CollapseFault::kPartOfComponent, 1, e,
                        "has boundary faces in d+ and others");
    }
    return true;
  }

  // It is enough that s has one remaining coface t of the next dimension: what remains is closed, so if t had a coface
  // u, s would have a second coface in u.
  bool accept(unsigned dimension, const std::vector<Collapse>& collapses) {
    for (const Collapse& step : collapses) {
      const std::uint32_t s = step.face, t = step.coface;
      const unsigned below = dimension - 1;
      if (s >= size_[below]) return reject(CollapseFault::kNoSuchCell, below, s, "does not exist");
      if (t >= size_[dimension])
        return reject(CollapseFault::kNoSuchCell, dimension, t, "does not exist");
      if (in_d_plus_[below][s])
        return reject(CollapseFault::kInDPlus, below, s, "is removed, but lies in d+");
      if (is_absent_[below][s]) return reject(CollapseFault::kAbsent, below, s, "is removed twice");
      if (is_absent_[dimension][t])
        return reject(CollapseFault::kAbsent, dimension, t, "is removed twice");
      if (num_cofaces_[below][s] != 1)
        return reject(CollapseFault::kNotFree, below, s,
                      "is removed with " + std::to_string(num_cofaces_[below][s]) + " cofaces");
      bool incident = false;
      for_each_side(dimension, t, [&](std::uint32_t side) { incident |= side == s; });
      if (!incident)
        return reject(CollapseFault::kNotCoface, below, s,
                      "is no face of " + name_of(c_, dimension, t));
      remove(dimension, t);
      remove(below, s);
      ++out_.step;
    }
    return true;
  }

  void remove(unsigned dimension, std::uint32_t t) {
    is_absent_[dimension][t] = true;
    if (dimension > 0)
      for_each_side(dimension, t, [&](std::uint32_t s) { --num_cofaces_[dimension - 1][s]; });
  }

  bool accept_end() {
    for (unsigned d = 4; d-- > 0;)
      for (std::uint32_t id = 0; id < size_[d]; ++id)
        if (!is_absent_[d][id] && !in_d_plus_[d][id])
          return reject(CollapseFault::kLeft, d, id, "is left");
    return true;
  }

  const CommonSubdivision& c_;
  std::array<std::uint32_t, 4> size_;
  std::array<std::vector<std::uint8_t>, 4> num_cofaces_;  // of the next dimension, that remain
  std::array<std::vector<bool>, 4> is_absent_, in_d_plus_;
  CollapseCheck out_;
};

}  // namespace

CollapseCheck replay_collapse(const CommonSubdivision& complex,
                              std::span<const std::uint32_t> d_plus,
                              const CollapseSequence& sequence) {
  return Replay(complex).run(d_plus, sequence);
}

}  // namespace veritope
