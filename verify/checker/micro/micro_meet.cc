// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_meet.cc: T4 of docs/certificates/microstructure.md for two walls: caps that are equal or apart.
#include "micro_meet.h"

namespace {

struct FlatPatch {  // of a cap, in the parameters of the first wall
  uint32_t patch;
  int wall;  // whose number it depends on, or -1
  size_t lists, m, n;
  std::vector<Big>
      v;  // of each list and point, the second parameter fastest: two coordinates times `scale`
  Big scale;

  size_t at(size_t list, size_t i, size_t j) const { return ((list * m + i) * n + j) * 2; }
};
struct FlatCap {
  uint32_t cap;
  std::vector<FlatPatch> patches;
  Ratio least[2], most[2];  // of the coefficients
};

FlatPatch flat_patch(const MicroPatch& s, uint32_t number, size_t axis) {
  FlatPatch r = {number, s.wall, s.lists, size_t(s.p) + 1, size_t(s.q) + 1, {}, s.scale};
  for (size_t i = 0; i < s.net.size(); i += 3)
    for (size_t k = 0; k < 2; ++k) r.v.push_back(s.net[i + other_axis(axis, k)]);
  return r;
}
// From the parameters of the second wall to those of the first one.
void bring(const MeetingWalls& walls, FlatPatch* s) {
  const bool is_exchanged = (walls.symmetry & 1) != 0;
  const Placement &x = *walls.place[0], &y = *walls.place[1];
  const Big common = x.shift.d * x.factor.d * y.shift.d * y.factor.d;
  const size_t first_list = s->v.size() / s->lists;
  for (size_t i = 0; i < s->v.size(); i += 2) {
    for (size_t k = 0; k < 2; ++k)
      if ((walls.symmetry & (k == 0 ? 2u : 4u)) != 0)
        s->v[i + k] = i < first_list ? s->scale - s->v[i + k] : -s->v[i + k];
    if (is_exchanged) std::swap(s->v[i], s->v[i + 1]);
    for (size_t k = 0; k < 2; ++k) {
      const Placement& p = k == 0 ? x : y;
      s->v[i + k] = s->v[i + k] * p.factor.n * divide(common, p.factor.d, nullptr);
      if (i < first_list)
        s->v[i + k] = s->v[i + k] + s->scale * p.shift.n * divide(common, p.shift.d, nullptr);
    }
  }
  s->scale = s->scale * common;
}
void enclose(const MicroTile& range, const FlatPatch& s, bool is_first, FlatCap* cap) {
  bool is_new = is_first;
  const Big scale = shifted(s.scale, 20 * int64_t(s.lists - 1));
  for (size_t i = 0; i < s.m * s.n; ++i, is_new = false)
    for (size_t k = 0; k < 2; ++k) {
      std::vector<Big> powers;
      for (size_t l = 0; l < s.lists; ++l) powers.push_back(s.v[2 * (l * s.m * s.n + i) + k]);
      const std::vector<Big> c = in_range(powers, range);
      int64_t binomial = 1;
      for (size_t t = 0; t < c.size(); ++t) {
        const Ratio x(c[t], scale * Big(binomial));
        if ((is_new && t == 0) || compare(x, cap->least[k]) < 0) cap->least[k] = x;
        if ((is_new && t == 0) || compare(x, cap->most[k]) > 0) cap->most[k] = x;
        binomial = binomial * int64_t(c.size() - 1 - t) / int64_t(t + 1);
      }
    }
}
bool are_apart(const FlatCap& a, const FlatCap& b) {
  for (size_t k = 0; k < 2; ++k)
    if (compare(a.most[k], b.least[k]) < 0 || compare(b.most[k], a.least[k]) < 0) return true;
  return false;
}

// A text that is equal for maps that are equal, in whatever degrees, after the symmetry of the square.
std::string map_text(const FlatPatch& s, unsigned symmetry) {
  FlatPatch a = s;
  if ((symmetry & 1) != 0) std::swap(a.m, a.n);
  for (size_t l = 0; l < s.lists; ++l)
    for (size_t i = 0; i < s.m; ++i)
      for (size_t j = 0; j < s.n; ++j) {
        const std::pair<size_t, size_t> to = moved(i, j, s.m, s.n, symmetry);
        for (size_t k = 0; k < 2; ++k)
          a.v[a.at(l, to.first, to.second) + k] = s.v[s.at(l, i, j) + k];
      }
  size_t lists = 1, m = 1, n = 1;
  Big common = a.scale;
  for (size_t l = 0; l < a.lists; ++l)
    for (size_t k = 0; k < 2; ++k) {
      for (size_t i = 0; i < a.m; ++i) to_powers_of_line(&a.v, a.at(l, i, 0) + k, 2, a.n);
      for (size_t j = 0; j < a.n; ++j) to_powers_of_line(&a.v, a.at(l, 0, j) + k, 2 * a.n, a.m);
      for (size_t i = 0; i < a.m; ++i)
        for (size_t j = 0; j < a.n; ++j) {
          const Big& x = a.v[a.at(l, i, j) + k];
          if (x.sign() == 0) continue;
          lists = std::max(lists, l + 1), m = std::max(m, i + 1), n = std::max(n, j + 1);
          common = gcd(common, x);
        }
    }
  std::string r;
  r += char(lists), r += char(m), r += char(n);
  put_text(divide(a.scale, common, nullptr), &r);
  for (size_t l = 0; l < lists; ++l)
    for (size_t i = 0; i < m; ++i)
      for (size_t j = 0; j < n; ++j)
        for (size_t k = 0; k < 2; ++k)
          put_text(divide(a.v[a.at(l, i, j) + k], common, nullptr), &r);
  return r;
}
// The side of the square where the symmetry takes side e.
uint32_t moved_side(uint32_t e, unsigned symmetry) {
  static const size_t kMiddles[4][2] = {{1, 0}, {2, 1}, {1, 2}, {0, 1}};  // of sides, in halves
  const std::pair<size_t, size_t> to = moved(kMiddles[e][0], kMiddles[e][1], 3, 3, symmetry);
  uint32_t r = 0;
  while (kMiddles[r][0] != to.first || kMiddles[r][1] != to.second) ++r;
  return r;
}

class WallPair {
 public:
  WallPair(const MeetingWalls& walls, const uint32_t (*numbers)[6], uint64_t* work)
      : walls_(walls), is_family_(numbers == nullptr), work_(*work) {
    for (int side = 0; side < 2; ++side) find(side, is_family_ ? nullptr : numbers[side]);
  }
  MeetingCaps compare_all() {
    for (const FlatCap& cap : caps_[1])
      for (const FlatPatch& s : cap.patches)
        for (unsigned symmetry = 0; symmetry < 8 && is_own(s, 1); ++symmetry)
          known_[map_text(s, symmetry)] = Known{cap.cap, s.patch, symmetry};
    MeetingCaps r;
    for (const FlatCap& a : caps_[0])
      for (const FlatCap& b : caps_[1]) {
        ++work_;
        EqualCaps equal = {{a.cap, b.cap}, {}};
        if (are_equal(a, b, &equal.pieces)) {
          r.equal.push_back(equal);
          for (const FlatPatch& s : a.patches) r.needs_same = r.needs_same || s.lists > 1;
        } else {
          r.is_known = r.is_known && are_apart(a, b);
        }
      }
    return r;
  }

 private:
  struct
      Known {  // a patch of the second wall, and the symmetry that takes its square to that of its equal
    uint32_t cap, patch;
    unsigned symmetry;
  };
  // Whether the patch depends on no other wall's number than that of the wall in which it lies.
  bool is_own(const FlatPatch& s, int side) const {
    return s.lists == 1 || s.wall == int(walls_.wall[side]);
  }
  void find(int side, const uint32_t* numbers) {
    const MicroTile& tile = *walls_.tile[side];
    static const MicroTile kNoRange;
    for (uint32_t c = 0; c < tile.caps.size(); ++c) {
      if (tile.caps[c].wall != walls_.wall[side]) continue;
      FlatCap cap = {c, {}, {}, {}};
      for (uint32_t p : tile.caps[c].patches) {
        const MicroPatch& s = tile.patches[p];
        cap.patches.push_back(flat_patch(
            is_family_ || s.lists == 1 ? s : at_number(s, numbers[s.wall]), p, cap_axis(side)));
        if (side == 1) bring(walls_, &cap.patches.back());
        enclose(is_family_ ? tile : kNoRange, cap.patches.back(), cap.patches.size() == 1, &cap);
        work_ += 16 * s.net.size();
      }
      caps_[side].push_back(std::move(cap));
    }
  }
  size_t cap_axis(int side) const { return walls_.wall[side] / 2; }
  bool are_equal(const FlatCap& a, const FlatCap& b,
                 std::vector<std::pair<uint32_t, uint32_t>>* pieces) const {
    if (a.patches.size() != b.patches.size() || are_apart(a, b)) return false;
    for (const FlatPatch& s : a.patches) {
      const auto other = is_own(s, 0) ? known_.find(map_text(s, 0)) : known_.end();
      if (other == known_.end() || other->second.cap != b.cap) return false;
      for (uint32_t e = 0; e < 4; ++e) {
        const uint32_t sides[2] = {4 * s.patch + moved_side(e, other->second.symmetry),
                                   4 * other->second.patch + e};
        uint32_t piece[2];
        bool is_rim[2];
        for (int side = 0; side < 2; ++side) {
          const MicroTile& tile = *walls_.tile[side];
          const uint32_t pair = tile.pair[sides[side]];
          is_rim[side] = pair != kNoPair && tile.cap[pair / 4] == kNoCap;
          piece[side] = is_rim[side] ? tile.piece[pair / 4] : 0;
        }
        require(is_rim[0] == is_rim[1], "T4", "equal caps have different rims");
        if (is_rim[0]) pieces->push_back(std::make_pair(piece[0], piece[1]));
      }
    }
    std::sort(pieces->begin(), pieces->end());
    pieces->erase(std::unique(pieces->begin(), pieces->end()), pieces->end());
    return true;
  }

  const MeetingWalls& walls_;
  const bool is_family_;
  uint64_t& work_;
  std::vector<FlatCap> caps_[2];
  std::map<std::string, Known> known_;
};

}  // namespace

MeetingCaps meeting_of_families(const MeetingWalls& walls, uint64_t* work) {
  return WallPair(walls, nullptr, work).compare_all();
}
MeetingCaps meeting_at_numbers(const MeetingWalls& walls, const uint32_t (*numbers)[6],
                               uint64_t* work) {
  const MeetingCaps r = WallPair(walls, numbers, work).compare_all();
  require(r.is_known, "T4", "two caps are neither equal nor apart");
  return r;
}
