// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_body.cc: B1 of docs/certificates/star-box.md, and what of B2 needs no coefficients.
#include "star.h"

namespace {

struct Reader {
  Body body;
  StarBody* out;

  uint64_t any_varint() {  // below 2^64, in shortest form
    uint64_t v = 0;
    for (unsigned i = 0;; ++i) {
      const uint64_t byte = body.natural(1);
      require(i < 9 || byte <= 1, "B1", "a varint is 2^64 or more");
      require(i == 0 || byte != 0, "B1", "a varint is not in shortest form");
      v |= (byte & 127) << 7 * i;
      if (byte < 128) return v;
    }
  }
  uint64_t varint() {
    const uint64_t v = any_varint();
    require(v >> 63 == 0, "B1", "a varint is 2^63 or more");
    return v;
  }
  int64_t zigzag() {  // above -2^63
    const uint64_t v = any_varint();
    require(v != ~uint64_t(0), "B1", "a number is -2^63");
    return v % 2 == 0 ? int64_t(v / 2) : -int64_t(v / 2) - 1;
  }
  uint64_t at_most(uint64_t v, uint64_t most, const char* why) const {
    require(v <= most, "B1", why, v);
    return v;
  }
  Big magnitude(uint64_t size) {  // of so many bytes
    require(size <= body.left(), "B1", "the body ends too early");
    Big r;
    for (uint64_t i = 0; i < size; ++i) {
      if (i % 8 == 0) r.m.push_back(0);
      r.m.back() |= body.natural(1) << 8 * (i % 8);
    }
    require(size == 0 || body.p[-1] != 0, "B1", "the last byte of a number is 0");
    return r;
  }
  Ratio rational() {
    Ratio r;
    r.n = Big(zigzag());
    r.d = Big(int64_t(varint()));
    if (r.d.sign() == 0) {
      require(r.n.sign() == 0, "B1", "a long rational has a short numerator");
      const uint64_t size = at_most(varint(), 257, "the size of a numerator is");
      require(size >= 1, "B1", "a numerator has no sign");
      const uint64_t minus = at_most(body.natural(1), 1, "a numerator's sign is");
      r.n = magnitude(size - 1);
      r.d = magnitude(at_most(varint(), 256, "the size of a denominator is"));
      require(r.n.bits() > 63 || r.d.bits() > 63, "B1", "a short rational has the long form");
      require(r.n.sign() != 0, "B1", "a long rational is 0");
      r.n.neg = minus == 1;
    }
    require(r.d.sign() > 0, "B1", "a denominator is 0");
    require(gcd(r.n, r.d) == Big(1), "B1", "a rational is not in lowest terms");
    return r;
  }
  // v 2^s, in units 2^E.
  int64_t scaled(int64_t v, uint64_t s) const {
    require(s < 62 || v == 0, "B1", "a coordinate is too far away, s =", s);
    const int64_t far = v == 0 ? 0 : kFarthest >> s;
    require(v == 0 || (v < far && v > -far), "B1", "a coordinate is too far away");
    return v == 0 ? 0 : v * (int64_t(1) << s);
  }
  uint64_t shift() { return at_most(varint(), kMostUnit, "s is over 4096:"); }

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
  uint64_t box_index() {
    const uint64_t i = varint();
    require(i < out->boxes.size(), "B1", "there is no box", i);
    return i;
  }
  Walk walk() {
    Walk w = Walk();
    w.box = box_index();
    w.sign = int(at_most(body.natural(1), 1, "a walk starts at sign"));
    for (uint64_t n = body.count(4); n > 0; --n) {
      const uint64_t s = shift();
      for (int k = 0; k < 3; ++k) w.points.push_back(scaled(zigzag(), s));
    }
    w.end = int(at_most(body.natural(1), 6, "a walk has the end"));
    if (w.end < 6) return w;
    w.end_box = box_index();
    w.end_sign = int(at_most(body.natural(1), 1, "a walk ends at sign"));
    return w;
  }
  // Of one root, in preorder; returns the last leaf's box.
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

  // The breaks of one axis.
  std::vector<Ratio> breaks(const Entity& e, size_t a) {
    const std::vector<Ratio>& t = e.knots[a];
    const size_t p = size_t(e.degrees[a]), n = t.size() - p - 1;
    std::vector<Ratio> r;
    for (uint64_t left = body.count(2); left > 0; --left) {
      r.push_back(rational());
      require(r.size() < 2 || compare(r[r.size() - 2], r.back()) < 0, "B1", "breaks do not rise");
    }
    require(r.size() >= 2 && compare(r[0], t[p]) == 0 && compare(r.back(), t[n]) == 0, "B1",
            "breaks do not begin and end with the domain");
    for (size_t i = p, k = 0; i <= n; ++i) {
      while (k < r.size() && compare(r[k], t[i]) < 0) ++k;
      require(k < r.size() && compare(r[k], t[i]) == 0, "B1", "a knot is no break");
    }
    return r;
  }
};

}  // namespace

StarBody read_star_body(const std::vector<Entity>& entities, Body bytes) {
  StarBody out;
  Reader r = {bytes, &out};
  require(r.body.natural(4) == 0x42535456, "B1", "another magic number");
  require(r.body.natural(4) == entities.size(), "B1", "the model's entities are", entities.size());
  require(!entities.empty(), "B1", "a model without entities bounds nothing");
  std::vector<bool> flipped;
  for (size_t i = 0; i < entities.size(); ++i) {
    flipped.push_back(r.at_most(r.body.natural(1), 1, "a flag is") == 1);
    out.flipped += flipped.back();
  }
  std::vector<std::vector<Ratio>> breaks;  // two for each surface
  std::vector<Place> places;
  for (const Entity& e : entities) {
    if (e.kind == Entity::kTriangle) places.push_back(Place{&e, 0, {0, 0}});
    if (e.kind != Entity::kSurface) continue;
    for (size_t a = 0; a < 2; ++a) breaks.push_back(r.breaks(e, a));
    const size_t v = breaks.back().size() - 1, n = (breaks[breaks.size() - 2].size() - 1) * v;
    require(n <= r.body.left() / 3, "B1", "too few bytes for the patches of a surface", n);
    for (size_t i = 0; i < n; ++i)
      places.push_back(Place{&e, breaks.size() / 2 - 1, {i / v, i % v}});
    require(places.size() <= r.body.left() / 3, "B1", "too few bytes for the patches");
  }
  std::vector<uint8_t> roots;
  for (const Place& at : places)
    for (int a = 0; a < 2; ++a)
      roots.push_back(
          uint8_t(r.at_most(r.body.natural(1), at.entity->kind == Entity::kTriangle ? 0 : 12,
                            "a patch is cut into too many roots:")));
  const int64_t unit = r.zigzag();
  require(unit >= -kMostUnit && unit <= kMostUnit, "B1", "E is out of range");
  for (uint64_t n = r.body.count(8); n > 0; --n) out.boxes.push_back(r.box());
  std::vector<uint64_t> symbols;
  int64_t last = 0;
  for (size_t i = 0; i < places.size(); ++i) {
    symbols.push_back(out.symbols.size());
    for (uint64_t n = uint64_t(1) << (roots[2 * i] + roots[2 * i + 1]); n > 0; --n)
      last = r.tree(last);
  }
  for (uint64_t n = r.body.count(7); n > 0; --n) out.walks.push_back(r.walk());
  require(r.body.left() == 0, "B1", "bytes behind the body's end:", r.body.left());

  for (const Entity& e : entities) {
    require(e.kind != Entity::kOther, "B2", "an entity is neither surface nor triangle");
    require(e.components - e.is_rational == 3, "B2", "a patch has not three coordinates");
    require(e.degrees[0] <= kMostDegree && e.degrees.back() <= kMostDegree, "B2",
            "a degree is over 15");
  }
  out.patches = cut_patches(places, unit, breaks);
  for (size_t i = 0; i < places.size(); ++i) {
    Patch& made = out.patches[i];
    made.is_flipped = flipped[size_t(places[i].entity - entities.data())];
    std::copy(&roots[2 * i], &roots[2 * i] + 2, made.roots);
    made.first_symbol = symbols[i];
    made.first_root = out.num_roots;
    out.num_roots += made.num_roots();
  }
  return out;
}
