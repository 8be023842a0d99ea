// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_crossing.cc: the crossing number of docs/certificates/star-box.md, section 4.
#include "star_box.h"

namespace {

const int kMostHalvingsOfCurves = 64;

struct PieceSide {  // a piece's side, as an interval of a line of its patch, or of a pair of sides
  uint64_t line;
  int64_t place, lo, hi;
  bool is_forward;   // travelled with the line's parameter
  bool is_reversed;  // the node's own direction is opposite
  int e;
  const Piece* piece;
};
bool is_before(const PieceSide& a, const PieceSide& b) {
  if (a.line != b.line) return a.line < b.line;
  if (a.place != b.place) return a.place < b.place;
  if (a.is_forward != b.is_forward) return a.is_forward < b.is_forward;
  return a.lo < b.lo;
}

int64_t barycentric(const int64_t* at, int k) {
  return k == 0 ? kWholeSide - at[0] - at[1] : at[k - 1];
}
PieceSide side_of(const Piece& piece, int e) {
  const Patch& p = *piece.patch;
  const bool tri = p.shape.is_triangle, outer = piece.node->is_outer(p, e);
  const int n = p.shape.sides(), first = tri ? e + 1 : e;
  int64_t t[2];
  for (int i = 0; i < 2; ++i) {
    const int64_t* const at = piece.node->at[(first + i) % n];
    t[i] = tri ? barycentric(at, (e + 2) % 3) : at[e % 2];
    if (outer && !tri && e >= 2) t[i] = kWholeSide - t[i];  // now in the direction of travel
    if (outer && p.is_reversed != p.is_second[e]) t[i] = kWholeSide - t[i];
  }
  PieceSide s = {outer ? p.pair[e] : uint64_t(1) << 63 | (4 * p.first_root + uint64_t(tri ? e : e % 2)),
            0,
            std::min(t[0], t[1]),
            std::max(t[0], t[1]),
            (t[1] > t[0]) != p.is_reversed,
            t[1] < t[0],
            e,
            &piece};
  const int64_t* const at = piece.node->at[first % n];
  if (!outer) s.place = tri ? barycentric(at, e) : at[1 - e % 2];
  return s;
}

struct PlaneCurve {  // (x, y) of control points
  std::vector<Big> x, y;
};
struct Counter {
  const Sheet& b;
  Units& units;
  std::vector<PieceSide> sides;
  int i, j, k;  // axes
  int64_t d[3];

  Counter(const Sheet& sheet, Units& work) : b(sheet), units(work), k(0) {
    for (int a = 0; a < 3; ++a) d[a] = b.c[1][a] - b.c[0][a];
    for (int a = 1; a < 3; ++a)
      if (magnitude(d[a]) > magnitude(d[k])) k = a;
    i = (k + 1) % 3, j = (k + 2) % 3;
  }

  // A control point of a side, from the first centre, along an axis, times its weight.
  Big from_centre(const PieceSide& s, int at, int axis) const {
    const Patch& p = *s.piece->patch;
    const Node& node = *s.piece->node;
    const int n = node.net.n;
    return Big::of(node.coordinate(p, at, axis), n) -
           Big::of(node.weight(p, at), n) * Big(b.c[0][axis]);
  }
  // The curve of the side, in the node's own direction; without x if y has one sign, so that the
  // side crosses nothing.
  PlaneCurve curve(const PieceSide& s) const {
    const Shape& shape = s.piece->patch->shape;
    const int degree = shape.side_degree(s.e);
    std::vector<Big> along;
    PlaneCurve c;
    bool up = true, down = true;
    for (int m = 0; m <= degree; ++m) {
      const int at = shape.on_side(s.e, m);
      along.push_back(from_centre(s, at, k));
      c.y.push_back(from_centre(s, at, j) * Big(d[k]) - along.back() * Big(d[j]));
      up = up && c.y.back().sign() >= 0, down = down && c.y.back().sign() < 0;
    }
    for (int m = 0; m <= degree && !up && !down; ++m)
      c.x.push_back(from_centre(s, shape.on_side(s.e, m), i) * Big(d[k]) -
                    along[size_t(m)] * Big(d[i]));
    return c;
  }
  void halve(const std::vector<Big>& c, std::vector<Big>* lower, std::vector<Big>* upper) const {
    const size_t n = c.size();
    std::vector<Big> v = c;
    lower->resize(n), upper->resize(n);
    for (size_t s = 0; s < n; ++s) {  // 2^(n - 1) times the points
      (*lower)[s] = shifted(v[0], int64_t(n - 1 - s));
      (*upper)[n - 1 - s] = shifted(v[n - 1 - s], int64_t(n - 1 - s));
      for (size_t m = 0; m + 1 < n - s; ++m) v[m] = v[m] + v[m + 1];
    }
  }
  void halve(const PieceSide& s, const PlaneCurve& c, PlaneCurve* half) {
    units.add(s.piece->patch->cost_of_half_curve(s.piece->node->level));
    halve(c.x, &half[0].x, &half[1].x);
    halve(c.y, &half[0].y, &half[1].y);
  }
  int64_t crossings(const PieceSide& s, const PlaneCurve& c, int halvings) {
    bool up = true, down = true, left = true, right = true;
    for (const Big& y : c.y) up = up && y.sign() >= 0, down = down && y.sign() < 0;
    for (const Big& x : c.x) left = left && x.sign() <= 0, right = right && x.sign() >= 0;
    if (up || down || left) return 0;
    if (right) return int(c.y.back().sign() >= 0) - int(c.y[0].sign() >= 0);
    require(halvings < kMostHalvingsOfCurves, "C3", "a curve comes too close to the centres' line");
    PlaneCurve half[2];
    halve(s, c, half);
    return crossings(s, half[0], halvings + 1) + crossings(s, half[1], halvings + 1);
  }
  // The part [lo, hi] of a side, whose curve is c, without what other pieces pass in the opposite
  // direction. Intervals are dyadic: one ends inside another only if it lies in it.
  int64_t remaining(const PieceSide& s, int64_t lo, int64_t hi, const PlaneCurve& c) {
    PieceSide key = s;
    key.is_forward = !s.is_forward;
    key.lo = lo;
    auto next = std::upper_bound(sides.begin(), sides.end(), key, is_before);
    const auto is_opposite = [&](std::vector<PieceSide>::const_iterator o) {
      return o->line == key.line && o->place == key.place && o->is_forward == key.is_forward;
    };
    if (next != sides.begin() && is_opposite(next - 1) && (next - 1)->hi > lo) --next;
    if (next == sides.end() || !is_opposite(next) || next->lo >= hi) return crossings(s, c, 0);
    if (next->lo <= lo && next->hi >= hi) return 0;
    PlaneCurve half[2];
    halve(s, c, half);
    const int64_t middle = lo + (hi - lo) / 2;
    return remaining(s, lo, middle, half[s.is_reversed]) +
           remaining(s, middle, hi, half[!s.is_reversed]);
  }
};

}  // namespace

int64_t crossing_number(const std::vector<Piece>& pieces, const Sheet& sheet, Units* units) {
  Counter counter(sheet, *units);
  for (const Piece& piece : pieces)
    for (int e = 0; e < piece.patch->shape.sides(); ++e)
      if (!piece.patch->is_collapsed(e) || !piece.node->is_outer(*piece.patch, e))
        counter.sides.push_back(side_of(piece, e));
  std::sort(counter.sides.begin(), counter.sides.end(), is_before);
  int64_t sum = 0;
  for (const PieceSide& s : counter.sides) {
    // Most sides are cancelled whole: their curves are not needed.
    PieceSide key = s;
    key.is_forward = !s.is_forward;
    const auto o = std::lower_bound(counter.sides.begin(), counter.sides.end(), key, is_before);
    if (o != counter.sides.end() && !is_before(key, *o) && o->hi >= s.hi) continue;
    const int64_t one = counter.remaining(s, s.lo, s.hi, counter.curve(s));
    sum += s.piece->patch->is_reversed ? -one : one;
  }
  return counter.d[counter.k] < 0 ? -sum : sum;
}
