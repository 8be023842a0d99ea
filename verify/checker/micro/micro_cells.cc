// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_cells.cc: which walls of cells meet, T4 for all of them, and the numbers of section 8 of
// docs/certificates/microstructure.md.
#include <array>

#include "micro_meet.h"

namespace {

// Limits of this checker: of the pieces and caps of all cells; of the answers that it keeps. T4: a limit of the
// coefficients of caps that it compares.
const uint64_t kFreeNodes = 1 << 26, kNodesOfCell = 32;
const size_t kMostAnswers = 1 << 16;
const uint64_t kMostWorkOfCaps = 1 << 30;
const uint32_t kTaken = 0xffffffff;  // the parent of a cap that is equal to another one

struct Overlap {  // of an interval of one grid and one of another
  size_t i[2];
  uint32_t place;
};

Ratio quotient(const Ratio& a, const Ratio& b) { return lowest(Ratio(a.n * b.d, a.d * b.n)); }

class Places {  // placements by numbers; number 0 is the identity
 public:
  Places() { number(Placement{Ratio(Big(0)), Ratio(Big(1))}); }
  uint32_t number(const Placement& p) {
    std::string key;
    for (const Big* x : {&p.shift.n, &p.shift.d, &p.factor.n, &p.factor.d}) put_text(*x, &key);
    const auto known = numbers_.emplace(key, uint32_t(all_.size()));
    if (known.second) all_.push_back(p);
    return known.first->second;
  }
  const Placement& operator[](uint32_t i) const { return all_[i]; }

 private:
  std::map<std::string, uint32_t> numbers_;
  std::vector<Placement> all_;
};

class Meetings {
 public:
  Meetings(const MicroFile& file, const std::vector<FaceCode>& faces)
      : file_(file), faces_(faces), cells_(size_t(file.cells)) {
    for (size_t g = 0; g < file.grids.size(); ++g)
      while (first_grid_.size() <= file.grids[g].volume) first_grid_.push_back(g);
    first_grid_.resize(file.cage.size() + 1, file.grids.size());
    uint64_t nodes = 0;
    first_node_.assign(size_t(file.cells), 0);
    for (const MicroGrid& g : file.grids)
      each_tile(g, [&](const size_t*, uint64_t number, size_t tile) {
        require(nodes < uint64_t(1) << 31, "T4", "this checker has a limit of pieces and caps");
        first_node_[g.first_cell + number] = uint32_t(nodes);
        nodes += file.tiles[tile].pieces + file.tiles[tile].caps.size();
      });
    require(nodes <= std::max(kFreeNodes, kNodesOfCell * file.kept), "T4",
            "this checker has a limit of pieces and caps:", nodes);
    nodes_.reset(new Classes(size_t(nodes)));
  }
  void meet_all() {
    for (const MicroGrid& g : file_.grids) meet_neighbours(g);
    for (const MicroGrid& a : file_.grids)
      for (size_t g = first_grid_[a.volume]; g < first_grid_[a.volume + 1]; ++g) {
        const MicroGrid& b = file_.grids[g];
        for (size_t axis = 0; axis < 3; ++axis)
          if (a.ends[axis][1] == b.ends[axis][0] && a.overlaps(b, axis))
            meet_grids(a, 2 * axis + 1, b, 2 * axis, 0, false);
      }
    for (uint64_t f = 0; f < faces_.size(); ++f)
      if (faces_[f].code == 3) meet_faces(f, faces_[f].other, faces_[f].symmetry);
  }
  MicroNumbers numbers() {
    for (const MicroGrid& g : file_.grids)
      each_tile(g, [&](const size_t*, uint64_t number, size_t t) {
        const uint64_t cell = g.first_cell + number;
        const MicroTile& tile = file_.tiles[t];
        out_.components += cells_.find(uint32_t(cell)) == cell;
        out_.chi += tile.chi / 2;
        for (size_t c = 0; c < tile.caps.size(); ++c)
          for (uint32_t piece : tile.caps[c].beside)
            if (!is_taken(node_of_cap(cell, tile, c)))
              nodes_->unite(node_of_cap(cell, tile, c), first_node_[cell] + piece);
      });
    for (uint32_t i = 0; i < nodes_->parent.size(); ++i) out_.shells += nodes_->parent[i] == i;
    for (const MicroBridge& b : file_.bridges)
      out_.is_meeting.push_back(is_meeting(file_.grids[b.grid], b.cell, b.wall));
    for (const MicroSweep& b : file_.sweeps)
      out_.is_meeting.push_back(is_meeting(file_.grids[b.grid], b.cell, b.wall));
    return out_;
  }
  // A class's least node belongs to its first cell.
  std::vector<PatchOfCell> first_patches() {
    std::vector<PatchOfCell> r;
    std::vector<bool> is_found(nodes_->parent.size());
    for (const MicroGrid& g : file_.grids)
      each_tile(g, [&](const size_t*, uint64_t number, size_t t) {
        const uint64_t cell = g.first_cell + number;
        const MicroTile& tile = file_.tiles[t];
        for (uint32_t s = 0; s < tile.patches.size(); ++s) {
          const uint64_t node = tile.cap[s] == kNoCap ? first_node_[cell] + tile.piece[s]
                                                      : node_of_cap(cell, tile, tile.cap[s]);
          if (is_taken(node)) continue;
          const uint32_t root = nodes_->find(uint32_t(node));
          if (!is_found[root])
            r.push_back(PatchOfCell{uint32_t(&g - file_.grids.data()), s, number});
          is_found[root] = true;
        }
      });
    return r;
  }

 private:
  uint64_t node_of_cap(uint64_t cell, const MicroTile& tile, size_t cap) const {
    return first_node_[cell] + tile.pieces + cap;
  }
  bool is_taken(uint64_t node) const { return nodes_->parent[node] == kTaken; }
  bool is_meeting(const MicroGrid& g, uint64_t cell, size_t wall) const {
    const MicroTile& tile = file_.tiles[g.tile[cell] - size_t(1)];
    for (size_t c = 0; c < tile.caps.size(); ++c)
      if (tile.caps[c].wall == wall && is_taken(node_of_cap(g.first_cell + cell, tile, c)))
        return true;
    return false;
  }

  // Walls of cells i of grid a and j of grid b.
  void meet(const MicroGrid& a, const size_t* i, size_t wall_a, const MicroGrid& b, const size_t* j,
            size_t wall_b, unsigned symmetry, uint32_t place0, uint32_t place1) {
    const uint64_t cell[2] = {a.cell(i), b.cell(j)};
    const size_t t[2] = {a.tile[cell[0]] - size_t(1), b.tile[cell[1]] - size_t(1)};
    const MeetingWalls walls = {{&file_.tiles[t[0]], &file_.tiles[t[1]]},
                                {wall_a, wall_b},
                                symmetry,
                                {&places_[place0], &places_[place1]}};
    const std::array<uint32_t, 4> key = {
        {uint32_t((t[0] * 16 + t[1]) * 64 + wall_a * 8 + wall_b), symmetry, place0, place1}};
    MeetingCaps own;
    const MeetingCaps* r = answer(key, walls, &own);
    if (!r->is_known || (r->needs_same && a.number(i, wall_a) != b.number(j, wall_b))) {
      uint32_t numbers[2][6];
      for (size_t w = 0; w < 6; ++w) {
        numbers[0][w] = a.number(i, w);
        numbers[1][w] = b.number(j, w);
      }
      own = meeting_at_numbers(walls, numbers, &work_);
      r = &own;
    }
    require(work_ <= kMostWorkOfCaps, "T4", "this checker has a limit of coefficients of caps");
    for (const EqualCaps& e : r->equal)
      join(e, a.first_cell + cell[0], *walls.tile[0], b.first_cell + cell[1], *walls.tile[1]);
  }
  const MeetingCaps* answer(const std::array<uint32_t, 4>& key, const MeetingWalls& walls,
                            MeetingCaps* own) {
    const auto known = answers_.find(key);
    if (known != answers_.end()) return &known->second;
    *own = meeting_of_families(walls, &work_);
    if (answers_.size() >= kMostAnswers) return own;
    return &(answers_[key] = *own);
  }
  void join(const EqualCaps& e, uint64_t cell_a, const MicroTile& a, uint64_t cell_b,
            const MicroTile& b) {
    const uint64_t caps[2] = {node_of_cap(cell_a, a, e.caps[0]), node_of_cap(cell_b, b, e.caps[1])};
    for (uint64_t cap : caps) {
      require(!is_taken(cap), "T4", "a cap is equal to two others, of cell", cell_a);
      nodes_->parent[cap] = kTaken;
    }
    for (const auto& piece : e.pieces)
      nodes_->unite(first_node_[cell_a] + piece.first, first_node_[cell_b] + piece.second);
    cells_.unite(cell_a, cell_b);
    ++out_.glued_caps;
    out_.chi -= a.caps[e.caps[0]].chi;
  }

  void meet_neighbours(const MicroGrid& g) {
    each_tile(g, [&](const size_t* i, uint64_t, size_t) {
      for (size_t axis = 0; axis < 3; ++axis) {
        size_t j[3] = {i[0], i[1], i[2]};
        if (++j[axis] == g.n[axis] || g.tile[g.cell(j)] == 0) continue;
        meet(g, i, 2 * axis + 1, g, j, 2 * axis, 0, 0, 0);
      }
    });
  }
  // The intervals that overlap. Those of b may run in the reverse order of their numbers.
  std::vector<Overlap> overlaps(const std::vector<Ratio>& a, const std::vector<Ratio>& b,
                                bool is_reversed) {
    std::vector<Overlap> r;
    for (size_t i = 0, j = 0; i + 1 < a.size() && j + 1 < b.size();) {
      const int order = compare(a[i + 1], b[j + 1]);
      if (compare(a[i], b[j + 1]) < 0 && compare(b[j], a[i + 1]) < 0) {
        const Ratio length = a[i + 1] - a[i];
        const Placement place = {quotient(b[j] - a[i], length), quotient(b[j + 1] - b[j], length)};
        r.push_back(Overlap{{i, is_reversed ? b.size() - 2 - j : j}, places_.number(place)});
      }
      i += order <= 0, j += order >= 0;
    }
    return r;
  }
  // The breaks of grid g along an axis, counted from 0 to 1 over the axis's domain, and reversed if asked.
  std::vector<Ratio> brought(const MicroGrid& g, size_t axis, bool is_reversed) const {
    const std::vector<Ratio>& t = file_.cage[g.volume].knots[axis];
    const Ratio length = t.back() - t[0];
    std::vector<Ratio> r;
    for (const Ratio& b : g.breaks[axis])
      r.push_back(quotient(is_reversed ? t.back() - b : b - t[0], length));
    if (is_reversed) std::reverse(r.begin(), r.end());
    return r;
  }
  void meet_grids(const MicroGrid& a, size_t wall_a, const MicroGrid& b, size_t wall_b,
                  unsigned symmetry, bool is_glued) {
    std::vector<Overlap> pairs[2];
    size_t axes[2][2];  // of the two grids, by the parameters of the first one's face
    for (size_t k = 0; k < 2; ++k) {
      const size_t m = (symmetry & 1) != 0 ? 1 - k : k;
      const bool is_reversed = (symmetry & (m == 0 ? 2u : 4u)) != 0;
      axes[0][k] = other_axis(wall_a / 2, k), axes[1][k] = other_axis(wall_b / 2, m);
      pairs[k] = is_glued ? overlaps(brought(a, axes[0][k], false),
                                     brought(b, axes[1][k], is_reversed), is_reversed)
                          : overlaps(a.breaks[axes[0][k]], b.breaks[axes[1][k]], false);
    }
    require(pairs[0].empty() || pairs[1].size() <= kMostWallPairs / pairs[0].size(), "T4",
            "too many pairs of walls meet");
    overlaps_ += pairs[0].size() * pairs[1].size();
    require(overlaps_ <= kMostWallPairs, "T4", "too many pairs of walls meet");
    size_t i[3], j[3];
    i[wall_a / 2] = wall_a % 2 * (a.n[wall_a / 2] - 1);
    j[wall_b / 2] = wall_b % 2 * (b.n[wall_b / 2] - 1);
    for (const Overlap& x : pairs[0])
      for (const Overlap& y : pairs[1]) {
        i[axes[0][0]] = x.i[0], i[axes[0][1]] = y.i[0];
        j[axes[1][0]] = x.i[1], j[axes[1][1]] = y.i[1];
        if (a.tile[a.cell(i)] == 0 || b.tile[b.cell(j)] == 0) continue;
        meet(a, i, wall_a, b, j, wall_b, symmetry, x.place, y.place);
      }
  }
  std::vector<const MicroGrid*> grids_at(uint64_t face) const {
    std::vector<const MicroGrid*> r;
    for (size_t g = first_grid_[face / 6]; g < first_grid_[face / 6 + 1]; ++g)
      if (reaches(file_.cage, file_.grids[g], size_t(face % 6))) r.push_back(&file_.grids[g]);
    return r;
  }
  void meet_faces(uint64_t f, uint64_t g, unsigned symmetry) {
    const std::vector<const MicroGrid*> at_g = grids_at(g);
    for (const MicroGrid* a : grids_at(f))
      for (const MicroGrid* b : at_g)
        meet_grids(*a, size_t(f % 6), *b, size_t(g % 6), symmetry, true);
  }

  const MicroFile& file_;
  const std::vector<FaceCode>& faces_;
  Places places_;
  std::map<std::array<uint32_t, 4>, MeetingCaps> answers_;
  std::vector<size_t> first_grid_;  // of each volume
  Classes cells_;
  std::vector<uint32_t> first_node_;  // of each cell: those of its pieces, then those of its caps
  std::unique_ptr<Classes> nodes_;
  MicroNumbers out_;
  uint64_t work_ = 0, overlaps_ = 0;
};

}  // namespace

MicroNumbers check_meetings(const MicroFile& file, const std::vector<FaceCode>& faces,
                            bool with_shells) {
  Meetings meetings(file, faces);
  meetings.meet_all();
  MicroNumbers r = meetings.numbers();
  if (with_shells) r.first = meetings.first_patches();
  return r;
}
