// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_caps.cc: T2 and T3 of docs/certificates/microstructure.md, and what of a tile's surface is glued: caps, and the
// pieces between them.
#include "micro.h"

namespace {

// Signs of the coefficients of x_a or of 1 - x_a, for each wall of the cube.
struct WallSigns {
  WallSigns(const MicroTile& tile, const MicroPatch& s) {
    for (size_t w = 0; w < 6; ++w)
      h[w] = w % 2 == 0 ? coordinate_of(tile, s, w / 2, -1, 1, 0)
                        : coordinate_of(tile, s, w / 2, -1, -1, -s.scale);
  }
  Cubic h[6];

  bool is_everywhere(size_t wall, int sign) const {
    for (const Big& x : h[wall].c)
      if (x.sign() != sign) return false;
    return true;
  }
};

class CapsOfTile {
 public:
  explicit CapsOfTile(MicroTile* tile) : tile_(*tile) {
    for (const MicroPatch& s : tile_.patches) {
      signs_.push_back(WallSigns(tile_, s));
      tile_.in_wall.push_back(-1);
      for (size_t w = 0; w < 6; ++w)
        if (signs_.back().is_everywhere(w, 0)) tile_.in_wall.back() = int(w);
    }
    touches_.assign(tile_.vertex.size(), 0);
    for (size_t c = 0; c < tile_.vertex.size(); ++c)
      if (tile_.in_wall[c / 4] >= 0)
        touches_[tile_.vertex[c]] |= uint8_t(1 << tile_.in_wall[c / 4]);
  }
  void check_walls() const {  // T2
    for (uint32_t s = 0; s < tile_.patches.size(); ++s)
      for (size_t w = 0; w < 6; ++w) {
        const int in = tile_.in_wall[s];
        if (in < 0)
          check_off(s, w);
        else if (size_t(in) / 2 != w / 2)
          require(signs_[s].is_everywhere(w, 1), "T2", "(1): a cap reaches another wall: patch", s);
      }
  }
  void check_rims() const {  // T3
    for (int w = 0; w < 6; ++w) {
      std::map<uint32_t, int> ends;  // of rims, by vertices
      for (uint32_t side = 0; side < tile_.pair.size(); ++side) {
        if (tile_.pair[side] == kNoPair || tile_.in_wall[side / 4] != w ||
            tile_.in_wall[tile_.pair[side] / 4] == w)
          continue;
        for (const uint32_t corner : {side, side / 4 * 4 + (side + 1) % 4})
          require(++ends[tile_.vertex[corner]] <= 2, "T3",
                  "the caps of a wall are pinched at a vertex of patch", side / 4);
      }
    }
  }
  void find_caps() {
    Classes classes(tile_.patches.size());
    for (uint32_t s = 0; s < tile_.pair.size(); ++s)
      if (tile_.pair[s] != kNoPair && tile_.in_wall[s / 4] == tile_.in_wall[tile_.pair[s] / 4])
        classes.unite(s / 4, tile_.pair[s] / 4);
    tile_.cap.assign(tile_.patches.size(), kNoCap);
    tile_.piece.assign(tile_.patches.size(), 0);
    for (uint32_t s = 0; s < tile_.patches.size(); ++s) {
      const uint32_t root = classes.find(s);  // not above s
      if (tile_.in_wall[s] < 0) {
        tile_.piece[s] = root == s ? tile_.pieces++ : tile_.piece[root];
        continue;
      }
      tile_.cap[s] = root == s ? uint32_t(tile_.caps.size()) : tile_.cap[root];
      if (root == s) tile_.caps.push_back(MicroCap());
      tile_.caps[tile_.cap[s]].wall = size_t(tile_.in_wall[s]);
      tile_.caps[tile_.cap[s]].patches.push_back(s);
    }
    for (MicroCap& cap : tile_.caps) count(&cap);
  }

 private:
  // (2) for a patch that does not lie in this wall.
  void check_off(uint32_t s, size_t w) const {
    const Cubic& h = signs_[s].h[w];
    for (const Big& x : h.c) require(x.sign() >= 0, "T2", "(2): outside of the cube: patch", s);
    const uint32_t* const pair = &tile_.pair[4 * s];
    for (int k = 0; k < h.n[2]; ++k) {
      require(has_positive(h, 0, h.n[0], 0, h.n[1], k), "T2", "(2): in a wall: patch", s);
      for (uint32_t e = 0; e < 4; ++e) {
        const int i = e == 1 ? h.n[0] - 1 : 0, j = e == 2 ? h.n[1] - 1 : 0;
        const bool is_free = pair[e] == kNoPair || tile_.in_wall[pair[e] / 4] == int(w);
        require(is_free || (e % 2 == 0 ? has_positive(h, 0, h.n[0], j, j + 1, k)
                                       : has_positive(h, i, i + 1, 0, h.n[1], k)),
                "T2", "(2): a side lies in a wall, of patch", s);
        const int u = e == 1 || e == 2 ? h.n[0] - 1 : 0, v = e >= 2 ? h.n[1] - 1 : 0;
        require((touches_[tile_.vertex[4 * s + e]] >> w & 1) != 0 || h.sign(u, v, k) > 0, "T2",
                "(2): a corner lies in a wall, of patch", s);
      }
    }
  }
  static bool has_positive(const Cubic& h, int i0, int i1, int j0, int j1, int k) {
    for (int i = i0; i < i1; ++i)
      for (int j = j0; j < j1; ++j)
        if (h.sign(i, j, k) > 0) return true;
    return false;
  }
  void count(MicroCap* cap) const {
    std::vector<uint32_t> vertices;
    int64_t twice_edges = 0;
    for (uint32_t s : cap->patches)
      for (uint32_t side = 4 * s; side < 4 * s + 4; ++side) {
        vertices.push_back(tile_.vertex[side]);
        if (tile_.pair[side] == kNoPair) continue;
        const uint32_t other = tile_.pair[side] / 4;
        twice_edges += tile_.in_wall[other] == int(cap->wall) ? 1 : 2;
        if (tile_.in_wall[other] < 0) cap->beside.push_back(tile_.piece[other]);
      }
    for (std::vector<uint32_t>* v : {&vertices, &cap->beside}) {
      std::sort(v->begin(), v->end());
      v->erase(std::unique(v->begin(), v->end()), v->end());
    }
    cap->chi = int64_t(vertices.size()) - twice_edges / 2 + int64_t(cap->patches.size());
  }

  MicroTile& tile_;
  std::vector<WallSigns> signs_;
  std::vector<uint8_t>
      touches_;  // of a vertex: a bit for each wall in which one of its patches lies
};

}  // namespace

void check_caps(MicroTile* tile) {
  CapsOfTile caps(tile);
  caps.check_walls();
  caps.check_rims();
  caps.find_caps();
}
