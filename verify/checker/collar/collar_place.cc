// SPDX-License-Identifier: Apache-2.0 OR MIT
// collar_place.cc: I1 to I4 of docs/certificates/collar.md: where the surface lies in the collar.
#include "collar.h"
#include "collar_claim.h"

namespace {

struct Inside {
  const CollarBody& body;
  const Complex& k;
  Units& units;
  const Hull* hull;
  std::vector<uint32_t> met;  // cells that meet the hull

  int64_t at(int axis, uint32_t x) const {
    return body.low[axis] + int64_t(x) * (int64_t(1) << body.shift);
  }
  Bounds box(const Cell& c) const {
    Bounds b;
    for (int i = 0; i < 3; ++i) b.lo[i] = at(i, c.low[i]), b.hi[i] = at(i, c.low[i] + c.size);
    return b;
  }
  // The codes lo, ..., hi - 1 are those of the cells of K inside the cell with this code.
  bool holds(size_t lo, size_t hi, uint64_t code, const Cell& c) {
    units.add(1);
    if (hull->misses(box(c))) return true;
    if (lo == hi) return false;
    if (k.codes[lo] == code) {
      met.push_back(uint32_t(lo));
      return true;
    }
    const uint64_t quarter = (code & -code) / 4;
    const uint32_t size = c.size / 2;
    for (uint32_t q = 0; q < 8; ++q) {
      const uint64_t end = code + q * quarter - 3 * quarter;
      const size_t to = q == 7 ? hi
                               : size_t(std::lower_bound(k.codes.begin() + int64_t(lo),
                                                         k.codes.begin() + int64_t(hi), end) -
                                        k.codes.begin());
      Cell child = {{0, 0, 0}, size};
      for (int i = 0; i < 3; ++i) child.low[i] = c.low[i] + (q >> i & 1) * size;
      if (!holds(lo, to, end - quarter / 2, child)) return false;
      lo = to;
    }
    return true;
  }
  bool holds(const Hull& h) {
    hull = &h;
    met.clear();
    const Cell root = {{0, 0, 0}, uint32_t(kRootEdge)};
    const Bounds b = box(root);
    for (int i = 0; i < 3; ++i)
      if (h.in_lo[i] <= b.lo[i] || h.in_hi[i] >= b.hi[i]) return false;
    return holds(0, k.codes.size(), uint64_t(1) << (3 * kDepth), root);
  }
};

// The symbols of the body's trees, with the trees of their leaves in place of the leaves.
struct Symbols {
  const uint32_t* star;
  const uint8_t* leaf;
  uint64_t open;  // nodes to come in a leaf's tree
  bool operator()() {
    if (open == 0) {
      if (*star++ == 0) return false;
      open = 1;
    }
    --open;
    if (*leaf++ == 0) open += 4;
    return leaf[-1] != 0;
  }
};

void check_inside(const StarBody& star, const CollarBody& body, const Gluing& x, const Complex& k,
                  const Shores& shores, Forest* forest, Units* units) {
  Inside inside = {body, k, *units, nullptr, {}};
  std::vector<uint32_t> collar(x.components, kNone);  // for each component of X
  uint32_t torn = kNone;
  uint64_t leaves = 0;
  Symbols symbols = {star.symbols.data(), body.symbols.data(), 0};
  forest->each_leaf(
      [&] {
        units->add(1);
        return symbols();
      },
      [&](const Patch& p, const Node& leaf) {
        require(inside.holds(leaf.hull), "I1", "not in the open collar: leaf", leaves);
        for (uint32_t cell : inside.met) {
          uint32_t& to = collar[p.component];
          if (to == kNone) to = shores.of_cell[cell];
          if (to != shores.of_cell[cell]) torn = std::min(torn, p.component);
        }
        ++leaves;
      });
  require(torn == kNone, "I2", "in more than one component of |K|: component", torn);
  std::vector<bool> taken(shores.outer.size());
  for (uint32_t i = 0; i < x.components; ++i) {
    require(!taken[collar[i]], "I2", "another one is in the same component of |K|: component", i);
    taken[collar[i]] = true;
  }
  require(taken.size() == x.components, "I2", "the components of |K| are", taken.size());
  for (uint32_t i = 0; i < x.components; ++i)
    require(x.chi[i] == shores.chi[shores.outer[collar[i]]], "I3",
            "another chi than that of its collar: component", i);
}

void check_shores(const StarBody& star, const CollarBody& body, const Complex& k,
                  const Shores& shores, Forest* forest, Units* units) {
  std::vector<int64_t> w;
  for (uint32_t i = 0; i < body.shores.size(); ++i) {
    const Walk& walk = body.shores[i];
    const std::vector<Sheet>* const at_end =
        walk.end < 6 ? nullptr : &star.boxes[walk.end_box].sheets;
    require(at_end == nullptr || !at_end->empty(), "I4", "a mesh box is at the end of shore", i);
    require(at_end == nullptr || at_end->size() == 1, "I4",
            "a box with several sheets is at the end of shore", i);
    uint32_t x[3];
    point_of(k.faces[shores.least[i]].key / 3, x);
    int64_t first[3];
    for (int a = 0; a < 3; ++a) first[a] = body.low[a] + int64_t(x[a]) * (int64_t(1) << body.shift);
    check_polyline(walk.polyline(first, star.boxes), walk.end, i, forest, units);
    w.push_back(walk.end < 6 ? 0 : 1 - walk.end_sign);
  }
  for (uint32_t i = 0; i < shores.outer.size(); ++i)
    require(w[shores.outer[i]] != w[shores.inner[i]], "I4", "w is equal on both sides of component",
            i);
}

struct Collar : MoreThanBoxes {
  CollarBody body;

  void read(StarBytes* bytes) override { body = read_collar_body(bytes); }
  std::string check(const Statement& s, const StarBody& star, const Gluing& x, Forest* forest,
                    Units* units) override {
    const uint64_t cells = body.differences.size();
    require(s.number.at("cells") == cells, "K0", "the number of cells is", cells);
    const Complex k(body);
    const Shores shores(k, body.sides);
    check_collapse(k, shores, body.collapses);
    *units = Units{0, 2000 * (body.leaves + cells + 100), "I1"};
    check_inside(star, body, x, k, shores, forest, units);
    units->id = "I4";
    check_shores(star, body, k, shores, forest, units);
    return std::to_string(cells) + " cells";
  }
};

}  // namespace

std::string check_collar(const Statement& s, std::string model, const Body& bytes) {
  Collar collar;
  return check_star_boxes(s, model, bytes, &collar);
}
