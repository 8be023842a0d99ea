// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_body.cc: B1 of docs/certificates/star-box.md, and the part of B2 that needs no coefficients.
#include "star_bytes.h"

namespace {

struct Reader : StarBytes {
  Reader(const Body& bytes, StarBody* to) : StarBytes(bytes, to) {}

  Box box() {
    Box b = Box();
    b.component = kNoPair;
    b.is_mesh = at_most(body.natural(1), 1, "a box has the kind") == 1;
    const uint64_t s = shift();
    int64_t least[3], size[3];
    for (int64_t& v : least) v = zigzag();
    for (int64_t& v : size) {
      v = int64_t(varint());
      require(v >= 1, "B1", "a box has no size");
    }
    for (int k = 0; k < 3; ++k) {
      b.lo[k] = scaled(least[k], s);
      scaled(size[k], s);
      require(size[k] < kFarthest, "B1", "a box is too large");
      b.hi[k] = scaled(least[k] + size[k], s);
    }
    for (int i = 0; i < 2 && !b.is_mesh; ++i)
      for (int k = 0; k < 3; ++k) {
        const int64_t v = int64_t(varint());
        require(v > 0 && v < size[k], "B1", "a centre is not inside its box");
        b.c[i][k] = scaled(least[k] + v, s);
      }
    return b;
  }
  Walk walk() {
    Walk w = Walk();
    w.box = box_index();
    w.sign = int(at_most(body.natural(1), 1, "a walk starts at sign"));
    points_and_end(&w);
    return w;
  }
  // Reads the tree of one root, in preorder; returns the last leaf's box.
  int64_t tree(int64_t last) {
    uint64_t open[kLevels + 1] = {1};  // nodes to come, by level
    for (int level = 0; level >= 0;) {
      if (open[level] == 0) {
        --level;
        continue;
      }
      --open[level];
      const uint64_t symbol = varint();
      if (symbol == 0) {
        require(level < kLevels, "B1", "a tree is deeper than 24 levels");
        out->symbols.push_back(0);
        open[++level] = 4;
        continue;
      }
      const uint64_t code = symbol - 1;
      last += code % 2 == 0 ? int64_t(code / 2) : -int64_t(code / 2) - 1;
      require(last >= 0 && uint64_t(last) < out->boxes.size(), "B1", "a leaf has no box");
      out->symbols.push_back(1 + uint32_t(last));
      ++out->leaves;
    }
    return last;
  }
};

}  // namespace

uint64_t StarBytes::box_index() {
  const uint64_t i = varint();
  require(i < out->boxes.size(), "B1", "there is no box", i);
  return i;
}
void StarBytes::points_and_end(Walk* w) {
  for (uint64_t n = body.count(4); n > 0; --n) {
    const uint64_t s = shift();
    for (int k = 0; k < 3; ++k) w->points.push_back(scaled(zigzag(), s));
  }
  w->end = int(at_most(body.natural(1), 6, "a walk has the end"));
  if (w->end < 6) return;
  w->end_box = box_index();
  w->end_sign = int(at_most(body.natural(1), 1, "a walk ends at sign"));
}

StarBody read_star_body(const Statement& statement, const std::vector<Entity>& entities, Body bytes,
                        const std::function<void(StarBytes*)>& rest) {
  StarBody out;
  Reader r(bytes, &out);
  const Cuts cuts = read_cuts(entities, statement.claim->magic, true, &r);
  out.num_reversed = cuts.num_reversed;
  std::vector<Place> places;
  std::vector<uint8_t> roots;
  for (uint64_t i = 0; i < cuts.patches(); ++i) {
    const size_t entity = cuts.entity_of(i);
    places.push_back(cuts.place(entity, i));
    const bool is_triangle = entities[entity].kind == Entity::kTriangle;
    for (int a = 0; a < 2; ++a)
      roots.push_back(uint8_t(r.at_most(r.body.natural(1), is_triangle ? 0 : 12,
                                        "a patch is cut into too many roots:")));
  }
  const int64_t unit = r.zigzag();
  require(unit >= -kMostUnit && unit <= kMostUnit, "B1", "E is out of range");
  for (uint64_t n = r.body.count(8); n > 0; --n) out.boxes.push_back(r.box());
  int64_t last = 0;
  for (size_t i = 0; i < places.size(); ++i)
    for (uint64_t n = uint64_t(1) << (roots[2 * i] + roots[2 * i + 1]); n > 0; --n)
      last = r.tree(last);
  for (uint64_t n = r.body.count(7); n > 0; --n) out.walks.push_back(r.walk());
  rest(&r);
  r.end();

  check_kinds(entities);
  cut_patches(places, unit, cuts.breaks,
              [&](Patch&& patch) { out.patches.push_back(std::move(patch)); });
  for (size_t i = 0; i < places.size(); ++i) {
    Patch& made = out.patches[i];
    made.is_reversed = cuts.reversed[cuts.entity_of(i)];
    std::copy(&roots[2 * i], &roots[2 * i] + 2, made.roots);
    made.first_root = out.num_roots;
    out.num_roots += made.num_roots();
  }
  return out;
}
