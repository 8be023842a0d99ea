// SPDX-License-Identifier: Apache-2.0 OR MIT
// invalid_vertices.cc: V1, P1 and P2 of docs/certificates/vmodel-invalid.md: two corners of the border at one point.
#include "vmodel_invalid.h"

namespace {

const uint64_t kBorder = ~uint64_t(0);

struct Face {
  CellFace face;
  uint64_t equal;     // the other face that it equals, or kBorder
  unsigned symmetry;  // takes it there
};
struct
    SideEnd {  // an edge of a cell, given by its axis and one of its ends, after a face that has it
  uint64_t cell, corner;
  size_t axis, face_axis;

  size_t other() const { return 3 - axis - face_axis; }  // across the next face
  uint64_t next_face() const { return 2 * other() + (corner >> other() & 1); }  // of the cell
};
struct CellAtQ {
  VCell cell;
  size_t corners[8];  // numbers of their points
};

class Vertices {
 public:
  Vertices(const SpacePoint& q, InvalidModel* model) : units_(model->units) {
    std::vector<SpacePoint> points;
    for (uint64_t c = 0; c < model->volumes.size(); ++c) {
      const Entity& e = model->volumes[c];
      SpacePoint own[8];
      bool is_at_q = false;
      for (size_t corner = 0; corner < 8; ++corner) {
        own[corner] = corner_point(e, corner);
        is_at_q = is_at_q || compare(own[corner], q) == 0;
      }
      if (!is_at_q) continue;
      points.insert(points.end(), own, own + 8);
      cells_[c].cell = cell_of(e);
    }
    const PointNumbers numbers(std::move(points));
    q_ = numbers[q];
    for (auto& c : cells_)
      for (size_t corner = 0; corner < 8; ++corner)
        c.second.corners[corner] = numbers[corner_point(*c.second.cell.volume, corner)];
  }
  void pair_faces() {  // P1
    for (const auto& c : cells_)
      for (uint64_t k = 0; k < 6; ++k)
        if (c.second.cell.faces[k] == Collapse::kNone && has_corner_at_q(c.second, k))
          faces_[6 * c.first + k] = Face{{&c.second.cell, k, c.second.corners}, kBorder, 0};
    for (auto& f : faces_)
      for (const auto& g : faces_) {
        if (f.first == g.first) continue;
        units_.add(1);
        const int symmetry = equal_under(f.second.face, g.second.face, &units_);
        if (symmetry < 0) continue;
        require(f.second.equal == kBorder, "P1", "two faces are equal to face", f.first);
        f.second.equal = g.first, f.second.symmetry = unsigned(symmetry);
      }
  }
  uint64_t count() {  // P2
    std::map<uint64_t, size_t> border;
    for (const auto& f : faces_)
      if (f.second.equal == kBorder) border.insert(std::make_pair(f.first, 8 * border.size()));
    for (const auto& c : cells_)
      for (uint64_t corner = 0; corner < 8; ++corner) units_.add(is_at_q(c.second, corner));
    Classes classes(8 * border.size());
    std::vector<size_t> used;
    for (const auto& f : border)
      for (uint64_t corner = 0; corner < 8; ++corner) {
        const size_t across = size_t(f.first % 6 / 2);
        const CellAtQ& c = cells_.at(f.first / 6);
        if ((corner >> across & 1) != f.first % 2 || !is_at_q(c, corner)) continue;
        used.push_back(f.second + corner);
        for (size_t which = 0; which < 2; ++which) {
          const SideEnd side = {f.first / 6, corner, other_axis(across, which), across};
          if (c.cell.edges[edge_of(side)]) {
            classes.unite(used.back(), f.second + (corner ^ uint64_t(1) << side.axis));
            continue;
          }
          const SideEnd last = partner(side);
          classes.unite(used.back(), border.at(6 * last.cell + last.next_face()) + last.corner);
        }
      }
    uint64_t r = 0;
    for (size_t i : used) r += classes.find(uint32_t(i)) == i;
    return r;
  }

 private:
  static uint64_t edge_of(const SideEnd& s) {
    return edge_number(s.axis, s.corner >> other_axis(s.axis, 0) & 1,
                       s.corner >> other_axis(s.axis, 1) & 1);
  }
  bool is_at_q(const CellAtQ& c, size_t corner) const { return c.corners[corner] == q_; }
  bool has_corner_at_q(const CellAtQ& c, uint64_t face) const {
    for (size_t corner = 0; corner < 8; ++corner)
      if ((corner >> face / 2 & 1) == face % 2 && is_at_q(c, corner)) return true;
    return false;
  }
  // The walk; its next face is border. Each side end is a step of one walk at most, so that it ends.
  SideEnd partner(SideEnd s) {
    for (;;) {
      units_.add(1);
      const uint64_t next = s.next_face();
      const size_t across = s.other();
      if (cells_.at(s.cell).cell.faces[next] != Collapse::kNone) {
        s.corner ^= uint64_t(1) << s.face_axis, s.face_axis = across;
        continue;
      }
      const Face& h = faces_.at(6 * s.cell + next);
      if (h.equal == kBorder) return s;
      const size_t first = other_axis(across, 0), second = other_axis(across, 1);
      const std::pair<size_t, size_t> to =
          moved(s.corner >> first & 1, s.corner >> second & 1, 2, 2, h.symmetry);
      const size_t which = size_t(s.axis != first) ^ (h.symmetry & 1);
      s.cell = h.equal / 6, s.corner = corner_of(h.equal % 6, to.first, to.second);
      s.face_axis = size_t(h.equal % 6 / 2), s.axis = other_axis(s.face_axis, which);
    }
  }

  Units& units_;
  size_t q_;
  std::map<uint64_t, CellAtQ> cells_;
  std::map<uint64_t, Face> faces_;  // not collapsed, with a corner at Q
};

}  // namespace

void check_corner(const Finding& f, InvalidModel* model) {
  const SpacePoint q = corner_point(model->volumes[f.cell], f.corner);
  check_cells_near(q, model);
  Vertices vertices(q, model);
  vertices.pair_faces();
  const uint64_t count = vertices.count();
  require(count >= 2, "P2", "vertices at the point:", count);
}
