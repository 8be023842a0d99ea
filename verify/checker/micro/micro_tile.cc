// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_tile.cc: S0, F1 and F2 of docs/certificates/microstructure.md.
#include "micro.h"

namespace {

const int kMostNodes = 1 << 16, kMostLevel = 40;

int64_t choose(int n, int k) {
  int64_t r = 1;
  for (int i = 0; i < k; ++i) r = r * (n - i) / (i + 1);
  return r;
}

Cubic product_of(const Cubic& a, const Cubic& b) {
  Cubic r = {{a.n[0] + b.n[0] - 1, a.n[1] + b.n[1] - 1, a.n[2] + b.n[2] - 1}, {}};
  r.c.resize(size_t(r.n[0] * r.n[1] * r.n[2]));
  const Big* x = a.c.data();
  for (int i = 0; i < a.n[0]; ++i)
    for (int j = 0; j < a.n[1]; ++j)
      for (int k = 0; k < a.n[2]; ++k, ++x) {
        if (x->sign() == 0) continue;
        const Big* y = b.c.data();
        for (int l = 0; l < b.n[0]; ++l)
          for (int m = 0; m < b.n[1]; ++m)
            for (int o = 0; o < b.n[2]; ++o, ++y) {
              Big& to = r.c[size_t(((i + l) * r.n[1] + j + m) * r.n[2] + k + o)];
              to = to + *x * *y;
            }
      }
  return r;
}
Cubic added(Cubic a, const Cubic& b, bool is_minus) {
  for (size_t i = 0; i < a.c.size(); ++i) a.c[i] = is_minus ? a.c[i] - b.c[i] : a.c[i] + b.c[i];
  return a;
}

Cubic make_cubic_g(const MicroTile& tile, const MicroPatch& s) {
  Cubic du[3], dv[3], g;
  for (size_t c = 0; c < 3; ++c) {
    du[c] = coordinate_of(tile, s, c, 0, 1, Big());
    dv[c] = coordinate_of(tile, s, c, 1, 1, Big());
  }
  for (size_t c = 0; c < 3; ++c) {
    const size_t d = (c + 1) % 3, e = (c + 2) % 3;
    const Cubic normal = added(product_of(du[d], dv[e]), product_of(du[e], dv[d]), true);
    const Big others = tile.centre[d].d * tile.centre[e].d;
    const Cubic from_a = coordinate_of(tile, s, c, -1, others * tile.centre[c].d,
                                       others * tile.centre[c].n * s.scale);
    const Cubic part = product_of(normal, from_a);
    g = c == 0 ? part : added(g, part, false);
  }
  return g;
}

// A side as powers of its parameter and of t: a text that is equal for equal polynomial maps.
std::string side_text(const MicroPatch& s, uint32_t e, bool is_reversed) {
  const int degree = e % 2 == 0 ? s.p : s.q;
  const size_t n = size_t(degree) + 1;
  std::vector<Big> v;  // list by list, point by point
  for (size_t l = 0; l < s.lists; ++l)
    for (int k = 0; k <= degree; ++k) {
      const int t = (e >= 2) != is_reversed ? degree - k : k;
      for (size_t c = 0; c < 3; ++c)
        v.push_back(s.net[s.at(l,
                               e % 2 == 0 ? t
                               : e == 1   ? s.p
                                          : 0,
                               e % 2 == 1 ? t
                               : e == 2   ? s.q
                                          : 0,
                               c)]);
    }
  size_t lists = 1, points = 1;
  Big common = s.scale;
  for (size_t l = 0; l < s.lists; ++l)
    for (size_t c = 0; c < 3; ++c) {
      to_powers_of_line(&v, 3 * n * l + c, 3, n);
      for (size_t k = 0; k < n; ++k) {
        const Big& x = v[3 * (n * l + k) + c];
        if (x.sign() == 0) continue;
        lists = std::max(lists, l + 1), points = std::max(points, k + 1);
        common = gcd(common, x);
      }
    }
  std::string r;
  r += char(lists), r += char(points), r += char(lists > 1 ? s.wall : 6);
  put_text(divide(s.scale, common, nullptr), &r);
  for (size_t l = 0; l < lists; ++l)
    for (size_t k = 0; k < 3 * points; ++k) put_text(divide(v[3 * n * l + k], common, nullptr), &r);
  return r;
}
bool is_collapsed_side(const MicroPatch& s, uint32_t e) {
  const int degree = e % 2 == 0 ? s.p : s.q;
  for (size_t l = 0; l < s.lists; ++l)
    for (int k = 1; k <= degree; ++k)
      for (size_t c = 0; c < 3; ++c) {
        const int i = e == 1 ? s.p : 0, j = e == 2 ? s.q : 0;
        if (!(s.net[s.at(l, i, j, c)] == s.net[s.at(l, e % 2 == 0 ? k : i, e % 2 == 1 ? k : j, c)]))
          return false;
      }
  return true;
}

void check_g(const MicroTile& tile, uint32_t patch) {  // F1
  const uint32_t* const pair = &tile.pair[4 * patch];
  for (uint32_t e = 0; e < 4; ++e)
    require(pair[e] != kNoPair || pair[(e + 1) % 4] != kNoPair, "F1",
            "two collapsed sides share a corner, in patch", patch);
  const Cubic g = make_cubic_g(tile, tile.patches[patch]);
  for (int i = 0; i < g.n[0]; ++i)
    for (int j = 0; j < g.n[1]; ++j) {
      const bool is_in_row[] = {j == 0, i == g.n[0] - 1, j == g.n[1] - 1, i == 0};
      bool is_left_out = false;
      for (uint32_t e = 0; e < 4; ++e)
        is_left_out = is_left_out || (is_in_row[e] && pair[e] == kNoPair);
      for (int k = 0; k < g.n[2] && !is_left_out; ++k)
        require(g.sign(i, j, k) > 0, "F1", "a coefficient of G is not positive, in patch", patch);
    }
}

// A part of S*: its coefficients, times `scale`.
struct StillNode {
  MicroPatch s;
  int level;
};
// The closed box around the coefficients misses the closed box from lo to hi.
bool misses_box(const MicroPatch& s, const Ratio* lo, const Ratio* hi) {
  for (size_t c = 0; c < 3; ++c) {
    bool is_below = true, is_above = true;
    const Big least = lo[c].n * s.scale, most = hi[c].n * s.scale;
    for (size_t i = c; i < s.net.size(); i += 3) {
      is_below = is_below && s.net[i] * lo[c].d < least;
      is_above = is_above && most < s.net[i] * hi[c].d;
    }
    if (is_below || is_above) return true;
  }
  return false;
}
// The halves of a patch of one list, times 2^degree.
void halve_patch(const MicroPatch& s, bool along_v, MicroPatch* lower, MicroPatch* upper) {
  const int degree = along_v ? s.q : s.p, lines = along_v ? s.p : s.q;
  *lower = s;
  lower->scale = shifted(s.scale, degree);
  *upper = *lower;
  for (int line = 0; line <= lines; ++line)
    for (size_t c = 0; c < 3; ++c) {
      const auto at = [&](int k) { return along_v ? s.at(0, line, k, c) : s.at(0, k, line, c); };
      std::vector<Big> v;
      for (int k = 0; k <= degree; ++k) v.push_back(s.net[at(k)]);
      for (int step = 0; step <= degree; ++step) {
        lower->net[at(step)] = shifted(v[0], degree - step);
        upper->net[at(degree - step)] = shifted(v[size_t(degree - step)], degree - step);
        for (int k = 0; k < degree - step; ++k) v[size_t(k)] = v[size_t(k)] + v[size_t(k) + 1];
      }
    }
}
void check_winding(const MicroTile& tile) {  // F2
  const MicroPatch& exit = tile.patches[tile.exit];
  require(exit.p == 1 && exit.q == 1, "F2", "the exit has not the degrees (1, 1): patch",
          tile.exit);
  const MicroPatch still = at_number(exit, tile.lo);
  Ratio lo[3], hi[3];
  size_t different = 0, axis = 0;
  for (size_t c = 0; c < 3; ++c) {
    const Big &p00 = still.net[c], &p01 = still.net[3 + c], &p10 = still.net[6 + c],
              &p11 = still.net[9 + c];
    require((p00 + p11 - p01 - p10).sign() == 0, "F2", "the exit is no parallelogram: patch",
            tile.exit);
    const Ratio m = lowest(Ratio(p00 + p01 + p10 + p11, still.scale * Big(4)));
    const int order = compare(tile.centre[c], m);
    lo[c] = order < 0 ? tile.centre[c] : m;
    hi[c] = order < 0 ? m : tile.centre[c];
    if (order != 0) ++different, axis = c;
  }
  require(different == 1, "F2", "the exit's middle and a differ in coordinates:", different);
  if (compare(tile.centre[axis], lo[axis]) == 0)  // to the wall beyond the middle
    hi[axis] = Ratio(Big(1));
  else
    lo[axis] = Ratio(Big(0));
  int visited = 0;
  for (uint64_t s = 0; s < tile.patches.size(); ++s)
    if (s != tile.exit)
      check_missed(at_number(tile.patches[s], tile.lo), lo, hi, "F2", s, &visited);
}

}  // namespace

void check_missed(const MicroPatch& still, const Ratio* lo, const Ratio* hi, const char* id,
                  uint64_t number, int* visited) {
  std::vector<StillNode> nodes(1, StillNode{still, 0});
  while (!nodes.empty()) {
    require(++*visited <= kMostNodes, id, "the descents take too many nodes, in patch", number);
    const StillNode node = std::move(nodes.back());
    nodes.pop_back();
    if (misses_box(node.s, lo, hi)) continue;
    require(node.level < kMostLevel, id, "the patch may meet the segment or box, patch", number);
    StillNode half[2];
    halve_patch(node.s, node.level % 2 == 1, &half[0].s, &half[1].s);
    for (StillNode& h : half) {
      h.level = node.level + 1;
      nodes.push_back(std::move(h));
    }
  }
}
void put_text(const Big& x, std::string* to) {
  const uint64_t head = 2 * x.m.size() + x.neg;
  to->append(reinterpret_cast<const char*>(&head), 8);
  to->append(reinterpret_cast<const char*>(x.m.begin()), 8 * x.m.size());
}
void to_powers_of_line(std::vector<Big>* v, size_t first, size_t stride, size_t count) {
  const auto at = [&](size_t i) -> Big& { return (*v)[first + i * stride]; };
  for (size_t k = 0; k < count; ++k) {
    for (size_t i = count - 1; i > k; --i) at(i) = at(i) - at(i - 1);
    at(k) = at(k) * Big(choose(int(count) - 1, int(k)));
  }
}

std::vector<Big> in_range(const std::vector<Big>& powers, const MicroTile& tile) {
  const int n = int(powers.size()) - 1;
  const Big lo = int64_t(tile.lo), length = int64_t(tile.hi - tile.lo);
  std::vector<Big> sum(powers.size());  // powers of t = (lo + length s) / 2^20, times 2^(20 n)
  for (int k = n; k >= 0; --k) {        // Horner's scheme in the polynomial lo + length s
    for (int i = n; i >= 0; --i)
      sum[size_t(i)] = sum[size_t(i)] * lo + (i > 0 ? sum[size_t(i) - 1] * length : Big());
    sum[0] = sum[0] + shifted(powers[size_t(k)], 20 * (n - k));
  }
  if (tile.lo == tile.hi) return {sum[0]};
  std::vector<Big> r(powers.size());
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= i; ++k)
      r[size_t(i)] = r[size_t(i)] + sum[size_t(k)] * Big(choose(n - k, i - k));
  return r;
}
Cubic coordinate_of(const MicroTile& tile, const MicroPatch& s, size_t c, int axis,
                    const Big& factor, const Big& minus) {
  Cubic r = {{s.p + (axis != 0), s.q + (axis != 1), 0}, {}};
  for (int i = 0; i < r.n[0]; ++i)
    for (int j = 0; j < r.n[1]; ++j) {
      std::vector<Big> powers;
      for (size_t l = 0; l < s.lists; ++l) {
        const Big& x = s.net[s.at(l, i, j, c)];
        powers.push_back(axis >= 0 ? s.net[s.at(l, i + (axis == 0), j + (axis == 1), c)] - x
                         : l == 0  ? x * factor - minus
                                   : x * factor);
      }
      const std::vector<Big> t = in_range(powers, tile);
      const Big binomials = choose(r.n[0] - 1, i) * choose(r.n[1] - 1, j);
      for (const Big& x : t) r.c.push_back(x * binomials);
      r.n[2] = int(t.size());
    }
  return r;
}
MicroPatch at_number(const MicroPatch& s, uint32_t k) {
  MicroPatch r;
  r.p = s.p, r.q = s.q, r.lists = 1;
  r.scale = shifted(s.scale, 20 * int64_t(s.lists - 1));
  const size_t n = s.net.size() / s.lists;
  for (size_t i = 0; i < n; ++i) {
    Big sum;  // Horner's scheme
    for (size_t l = s.lists; l-- > 0;)
      sum = sum * Big(int64_t(k)) + shifted(s.net[l * n + i], 20 * int64_t(s.lists - 1 - l));
    r.net.push_back(sum);
  }
  return r;
}

void check_surface(MicroTile* tile) {
  const uint32_t sides = uint32_t(4 * tile->patches.size());
  std::map<std::string, uint32_t> known;
  tile->pair.assign(sides, kNoPair);
  for (uint32_t s = 0; s < sides; ++s)
    if (!is_collapsed_side(tile->patches[s / 4], s % 4))
      require(known.emplace(side_text(tile->patches[s / 4], s % 4, false), s).second, "S0",
              "another side is the same curve as side", s);
  for (const auto& side : known) {
    const uint32_t s = side.second;
    const auto other = known.find(side_text(tile->patches[s / 4], s % 4, true));
    require(other != known.end(), "S0", "no side is the opposite curve of side", s);
    require(other->second != s, "S0", "a side is its own opposite: side", s);
    tile->pair[s] = other->second;
  }
  Classes corners(sides);
  for (uint32_t s = 0; s < sides; ++s) {
    const uint32_t end = s / 4 * 4 + (s + 1) % 4, other = tile->pair[s];
    corners.unite(s, other == kNoPair ? end : other / 4 * 4 + (other + 1) % 4);
  }
  for (uint32_t c = 0; c < sides; ++c) tile->vertex.push_back(corners.find(c));
  for (uint32_t c = 0; c < sides; ++c)
    tile->chi += (tile->vertex[c] == c) - (tile->pair[c] != kNoPair && tile->pair[c] < c);
  tile->chi += int64_t(tile->patches.size());
}
void check_family(const MicroTile& tile) {
  for (uint32_t s = 0; s < tile.patches.size(); ++s) check_g(tile, s);
  check_winding(tile);
}
