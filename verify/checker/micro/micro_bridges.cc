// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_bridges.cc: R1 to R4 of docs/certificates/microstructure.md.
#include "micro_bridges.h"

namespace {

Big determinant(const Big* m) {  // of three rows
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
         m[2] * (m[3] * m[7] - m[4] * m[6]);
}

// Column `axis` of J at i, j, k: a Bernstein coefficient of the derivative along an axis of the degree n is, in the
// degree n, index (B - B of index - 1) + (n - index) (B of index + 1 - B).
void set_column(const MicroBridge& b, const int* index, size_t axis, Big* jacobian) {
  const int n = axis == 0 ? b.p : axis == 1 ? b.q : 2, at = index[axis];
  int before[3] = {index[0], index[1], index[2]}, after[3] = {index[0], index[1], index[2]};
  --before[axis], ++after[axis];
  const Big* const here = &b.net[b.at(index[0], index[1], index[2])];
  for (size_t k = 0; k < 3; ++k) {
    Big sum;
    if (at > 0) sum = Big(at) * (here[k] - b.net[b.at(before[0], before[1], before[2]) + k]);
    if (at < n) sum = sum + Big(n - at) * (b.net[b.at(after[0], after[1], after[2]) + k] - here[k]);
    jacobian[3 * k + axis] = sum;
  }
}
bool is_positive_at(const MicroBridge& b, const int* index) {
  Big jacobian[9], sum[9];  // K J + (K J)^T
  for (size_t axis = 0; axis < 3; ++axis) set_column(b, index, axis, jacobian);
  for (size_t r = 0; r < 3; ++r)
    for (size_t c = 0; c < 3; ++c) {
      Big product;
      for (size_t k = 0; k < 3; ++k)
        if (b.matrix[3 * r + k].sign() != 0)
          product = product + b.matrix[3 * r + k] * jacobian[3 * k + c];
      sum[3 * r + c] = sum[3 * r + c] + product;
      sum[3 * c + r] = sum[3 * c + r] + product;
    }
  return sum[0].sign() > 0 && (sum[0] * sum[4] - sum[1] * sum[3]).sign() > 0 &&
         determinant(sum).sign() > 0;
}
void check_injective(const MicroBridge& b, uint64_t number) {  // R1
  require(determinant(b.matrix).sign() > 0, "R1", "det K is not positive, of bridge", number);
  int i[3];
  for (i[0] = 0; i[0] <= b.p; ++i[0])
    for (i[1] = 0; i[1] <= b.q; ++i[1])
      for (i[2] = 0; i[2] <= 2; ++i[2])
        require(is_positive_at(b, i), "R1", "K J is not positive, of bridge", number);
}

Ratio sum_of(const Ratio& a, const Ratio& b) { return a - Ratio(-b.n, b.d); }
Ratio product_of(const Ratio& a, const Ratio& b) { return lowest(Ratio(a.n * b.n, a.d * b.d)); }
Ratio quotient_of(const Ratio& a, const Ratio& b) { return lowest(Ratio(a.n * b.d, a.d * b.n)); }

struct Glued {  // the face to which one is glued
  bool is = false;
  uint64_t other;
  unsigned symmetry;
  bool is_lower;  // the face is the lower one: its code has the symmetry
};

// The cap of a bridge, or its list 0: a net of points, each of three numbers, the second parameter fastest. Coordinate
// k is divided by scale[k] > 0.
struct Plate {
  size_t m, n;
  std::vector<Big> v;
  Big scale[3];

  Big& at(size_t i, size_t j, size_t k) { return v[(i * n + j) * 3 + k]; }
  // The parameters change places.
  Plate exchanged() const {
    Plate r = {n, m, {}, {scale[0], scale[1], scale[2]}};
    for (size_t j = 0; j < n; ++j)
      for (size_t i = 0; i < m; ++i)
        r.v.insert(r.v.end(), v.begin() + long((i * n + j) * 3),
                   v.begin() + long((i * n + j) * 3 + 3));
    return r;
  }
  void raise_second(size_t to) {  // the degree of the second parameter
    for (; n < to; *this = next_degree()) {
    }
  }
  Plate raised(size_t to) const {  // to so many coefficients along either parameter
    Plate r = *this;
    r.raise_second(to);
    r = r.exchanged();
    r.raise_second(to);
    return r.exchanged();
  }

 private:
  Plate next_degree() const {
    Plate r = {m, n + 1, {}, {}};
    for (size_t k = 0; k < 3; ++k) r.scale[k] = scale[k] * Big(int64_t(n));
    for (size_t i = 0; i < m; ++i)
      for (size_t j = 0; j <= n; ++j)
        for (size_t k = 0; k < 3; ++k) {
          Big sum;
          if (j > 0) sum = Big(int64_t(j)) * v[(i * n + j - 1) * 3 + k];
          if (j < n) sum = sum + Big(int64_t(n - j)) * v[(i * n + j) * 3 + k];
          r.v.push_back(sum);
        }
    return r;
  }
};
bool are_equal(Plate a, Plate b) {  // after a symmetry of the square
  const size_t n = std::max(std::max(a.m, a.n), std::max(b.m, b.n));
  a = a.raised(n), b = b.raised(n);
  for (unsigned symmetry = 0; symmetry < 8; ++symmetry) {
    bool is = true;
    for (size_t i = 0; i < n && is; ++i)
      for (size_t j = 0; j < n && is; ++j) {
        const std::pair<size_t, size_t> to = moved(i, j, n, n, symmetry);
        for (size_t k = 0; k < 3 && is; ++k)
          is = a.at(i, j, k) * b.scale[k] == b.at(to.first, to.second, k) * a.scale[k];
      }
    if (is) return true;
  }
  return false;
}

class BridgeCheck {
 public:
  BridgeCheck(const MicroFile& file, const std::vector<FaceCode>& faces)
      : file_(file), glued_(faces.size()), slices_(file) {
    for (uint64_t f = 0; f < faces.size(); ++f) {
      if (faces[f].code != 3) continue;
      const FaceCode& code = faces[f];
      set(f, code.other, code.symmetry, true);
      set(code.other, f, code.symmetry, false);
    }
  }
  void check(const MicroBridge& b, bool is_meeting, uint64_t number) {
    check_injective(b, number);
    const OtherSide other = other_side(b, number);
    require(other.volume == b.volume, "R2", "another volume than the other side's, of bridge",
            number);
    check_cap(b, other, number);
    require(!is_meeting, "R2", "the cap is equal to another one, of bridge", number);
    check_place(b, other, number);
    slices_.check_cells(b, other);
  }
  void check_pairs() { slices_.check_pairs(); }

 private:
  void set(uint64_t face, uint64_t other, unsigned symmetry, bool is_lower) {
    Glued& g = glued_[face];
    g.is = true, g.other = other, g.symmetry = symmetry, g.is_lower = is_lower;
  }
  std::pair<Ratio, Ratio> domain(uint64_t volume, size_t axis) const {  // begin and length
    const std::vector<Ratio>& t = file_.cage[volume].knots[axis];
    return std::make_pair(t[0], t.back() - t[0]);
  }
  OtherSide other_side(const MicroBridge& b, uint64_t number) const {
    const MicroGrid& g = file_.grids[b.grid];
    size_t i[3];
    g.place_of(b.cell, i);
    OtherSide r;
    const size_t axis = b.wall / 2;
    r.volume = g.volume, r.axis = axis;
    for (size_t k = 0; k < 3; ++k) {
      const Ratio &lo = g.breaks[k][i[k]], &hi = g.breaks[k][i[k] + 1];
      r.source[k] = k;
      r.placed[k] = Placement{lo, hi - lo};
    }
    r.front = g.breaks[axis][i[axis] + b.wall % 2];
    r.is_upward = b.wall % 2 == 1;
    r.is_face = i[axis] == b.wall % 2 * (g.n[axis] - 1) && reaches(file_.cage, g, b.wall);
    if (r.is_face) cross(6 * g.volume + b.wall, number, &r);
    return r;
  }
  void cross(uint64_t face, uint64_t number, OtherSide* side) const {
    require(glued_[face].is, "R2", "the wall lies in a face that is not glued, of bridge", number);
    const Glued& glued = glued_[face];
    const OtherSide here = *side;
    side->volume = glued.other / 6;
    side->axis = size_t(glued.other % 6 / 2);
    side->is_upward = glued.other % 2 == 0;
    const std::vector<Ratio>& knots = file_.cage[side->volume].knots[side->axis];
    side->front = side->is_upward ? knots[0] : knots.back();
    for (size_t k = 0; k < 2; ++k) {  // parameter k of the lower face is m of the other one
      const size_t m = (glued.symmetry & 1) != 0 ? 1 - k : k;
      const bool is_reversed = (glued.symmetry & (m == 0 ? 2u : 4u)) != 0;
      const size_t from = other_axis(here.axis, glued.is_lower ? k : m),
                   to = other_axis(side->axis, glued.is_lower ? m : k);
      const auto source = domain(here.volume, from), target = domain(side->volume, to);
      const Ratio factor = quotient_of(target.second, source.second);
      Placement p = {product_of(here.placed[from].shift - source.first, factor),
                     product_of(here.placed[from].factor, factor)};
      if (is_reversed) p.shift = target.second - p.shift, p.factor.n = -p.factor.n;
      p.shift = sum_of(p.shift, target.first);
      side->source[to] = from;
      side->placed[to] = p;
    }
  }
  void check_cap(const MicroBridge& b, const OtherSide& other, uint64_t number) const {  // R2
    const MicroGrid& g = file_.grids[b.grid];
    size_t i[3];
    g.place_of(b.cell, i);
    MicroPatch s = patch_of_cap(file_, b.grid, b.cell, b.wall, "R2", number);
    if (s.lists > 1) s = at_number(s, g.number(i, size_t(s.wall)));
    Plate plate = {size_t(s.p) + 1, size_t(s.q) + 1, std::vector<Big>(s.net.size()), {}};
    Plate list = {size_t(b.p) + 1, size_t(b.q) + 1, {}, {b.scale, b.scale, b.scale}};
    for (size_t k = 0; k < 3; ++k) {
      const bool is_across = k == other.axis;
      const Ratio shift = is_across ? other.front : other.placed[k].shift,
                  factor = is_across ? Ratio(Big(0)) : other.placed[k].factor;
      plate.scale[k] = shift.d * factor.d * s.scale;
      for (size_t at = 0; at < s.net.size(); at += 3)
        plate.v[at + k] = shift.n * factor.d * s.scale +
                          (is_across ? Big() : factor.n * shift.d * s.net[at + other.source[k]]);
    }
    for (int u = 0; u <= b.p; ++u)
      for (int v = 0; v <= b.q; ++v)
        for (size_t k = 0; k < 3; ++k) list.v.push_back(b.net[b.at(u, v, 0) + k]);
    require(are_equal(std::move(plate), std::move(list)), "R2", "list 0 is not the cap, of bridge",
            number);
  }
  void check_place(const MicroBridge& b, const OtherSide& other, uint64_t number) const {  // R3
    for (size_t k = 0; k < 3; ++k) {
      const std::vector<Ratio>& t = file_.cage[b.volume].knots[k];
      for (size_t i = 0; i < b.net.size(); i += 3) {
        if (i % 9 == 0) continue;  // list 0
        const Ratio x(b.net[i + k], b.scale);
        require(compare(t[0], x) < 0 && compare(x, t.back()) < 0, "R3",
                "a point is not inside of the volume, of bridge", number);
        const int order = k == other.axis ? compare(x, other.front) : 0;
        require(k != other.axis || order == (other.is_upward ? 1 : -1), "R3",
                "a point is not beyond the front, of bridge", number);
      }
    }
  }

  const MicroFile& file_;
  std::vector<Glued> glued_;
  Slices slices_;
};

}  // namespace

const MicroPatch& patch_of_cap(const MicroFile& file, size_t grid, uint64_t cell, size_t wall,
                               const char* id, uint64_t number) {
  const MicroTile& tile = file.tiles[file.grids[grid].tile[cell] - size_t(1)];
  const MicroCap* cap = nullptr;
  for (const MicroCap& c : tile.caps) {
    if (c.wall != wall) continue;
    require(cap == nullptr, id, "there are two caps in the wall of bridge or sweep", number);
    cap = &c;
  }
  require(cap != nullptr && cap->patches.size() == 1, id,
          "there is no cap of one patch in the wall of bridge or sweep", number);
  return tile.patches[cap->patches[0]];
}

void check_bridges(const MicroFile& file, const std::vector<FaceCode>& faces,
                   const std::vector<bool>& is_meeting) {
  BridgeCheck check(file, faces);
  for (size_t i = 0; i < file.bridges.size(); ++i)
    check.check(file.bridges[i], is_meeting[i], uint64_t(i));
  check.check_pairs();
}
