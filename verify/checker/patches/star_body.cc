// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_body.cc: B1 of docs/certificates/star-box.md and star-box-2.md, and the part of B2 that needs no coefficients.
#include "star_box.h"

namespace {

__extension__ typedef __int128 i128;
const int64_t kMostSteps = 64;  // abs(t)
const uint64_t kMostSheets = 64;  // and as many separators

struct StarBodyReader : StarBytes {
  StarBodyReader(const Body& bytes, StarBody* to) : StarBytes(bytes, to) {}

  uint64_t bounds(Box* b, int64_t* least, int64_t* size) {  // the result is the shift
    uint64_t s = shift();
    for (int k = 0; k < 3; ++k) least[k] = zigzag();
    for (int k = 0; k < 3; ++k) {
      size[k] = int64_t(varint());
      require(size[k] >= 1, "B1", "a box has no size");
    }
    if (b->frame != 0) {
      require(s <= uint64_t(kMostShift), "B1", "a coordinate is too far away, s =", s);
      b->shift = int(s);
      s = 0;
    }
    for (int k = 0; k < 3; ++k) {
      b->lo[k] = scaled(least[k], s);
      scaled(size[k], s);
      require(size[k] < kFarthest, "B1", "a box is too large");
      b->hi[k] = scaled(least[k] + size[k], s);
    }
    return s;
  }
  Box box_1() {
    Box b = Box();
    b.component = kNoPair;
    b.is_mesh = at_most(body.natural(1), 1, "a box has the kind") == 1;
    int64_t least[3], size[3];
    const uint64_t s = bounds(&b, least, size);
    std::copy(b.lo, b.lo + 3, b.place);
    if (b.is_mesh) return b;
    b.sheets.resize(1);
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 3; ++k) {
        const int64_t v = int64_t(varint());
        require(v > 0 && v < size[k], "B1", "a centre is not inside its box");
        b.sheets[0].c[i][k] = scaled(least[k] + v, s);
      }
    return b;
  }

  Frame frame() {
    Frame f;
    for (auto& row : f.a)
      for (int64_t& a : row) {
        a = zigzag();
        require(::magnitude(a) >> 31 == 0, "B1", "an entry of a frame is 2^31 or more");
      }
    i128 det = 0;  // six products below 2^93
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      det += i128(f.a[0][k]) * (f.a[1][i] * f.a[2][j] - f.a[1][j] * f.a[2][i]);
    }
    require(det != 0, "B1", "the determinant of a frame is 0");
    return f;
  }
  Box box_2() {
    Box b = Box();
    b.component = kNoPair;
    b.is_mesh = at_most(body.natural(1), 1, "a box has the kind") == 1;
    b.frame = uint32_t(at_most(varint(), out->frames.size() - 1, "there is no frame"));
    int64_t least[3], size[3];
    bounds(&b, least, size);
    std::copy(b.lo, b.lo + 3, b.place);
    if (!b.is_mesh) sheets(&b);
    return b;
  }
  void sheets(Box* b) {
    b->sheets.resize(at_most(body.natural(1), kMostSheets, "a box has too many sheets:"));
    b->separators.resize(at_most(body.natural(1), kMostSheets, "a box has too many separators:"));
    const bool is_one = b->sheets.size() == 1;
    require(!b->sheets.empty(), "B1", "a star box has no sheet");
    require(!is_one || b->separators.empty(), "B1", "a box with one sheet has separators");
    const uint64_t r = shift();
    int64_t first[3] = {0, 0, 0};  // the first point, which the others are stored minus
    for (Sheet& sheet : b->sheets)
      for (int i = 0; i < 2; ++i) {
        int64_t v[3];
        for (int k = 0; k < 3; ++k) {
          v[k] = zigzag();
          require(::magnitude(v[k]) <= uint64_t(2 * kFarthest), "B1",
                  "a coordinate is too far away");
          v[k] += first[k];
          sheet.c[i][k] = scaled(v[k], r);
        }
        require(is_inside(*b, sheet.c[i]), "B1", "a centre is not inside its box");
        if (i == 0 && &sheet == &b->sheets[0]) std::copy(v, v + 3, first);
      }
    for (Separator& q : b->separators) separator(&q, int64_t(r));
    for (Sheet& sheet : b->sheets)
      for (size_t i = 0; i < b->separators.size(); ++i) {
        const uint64_t sign = at_most(body.natural(1), 2, "the sign of a sheet is");
        sheet.signs.push_back(sign == 2 ? -1 : int8_t(sign));
      }
    for (size_t i = 0; i < b->sheets.size(); ++i)
      for (size_t j = 0; j < i; ++j)
        require(are_apart(b->sheets[i], b->sheets[j]), "B1",
                "no separator is between two sheets of the box", out->boxes.size());
  }
  bool is_inside(const Box& b, const int64_t* c) const {
    for (int row = 0; row < 3; ++row) {
      i128 at = 0;
      for (int k = 0; k < 3; ++k) at += i128(out->frames[b.frame].a[row][k]) * c[k];
      // at <= lo 2^shift or at >= hi 2^shift.
      if ((at - 1) >> b.shift < b.lo[row] || at >> b.shift >= b.hi[row]) return false;
    }
    return true;
  }
  void separator(Separator* q, int64_t r) {
    q->degree = int(at_most(body.natural(1), 3, "the degree of a separator is"));
    require(q->degree >= 1, "B1", "the degree of a separator is 0");
    const int64_t t = zigzag();
    require(t >= -kMostSteps && t <= kMostSteps, "B1", "t is out of range");
    q->scale = r + t;
    q->length = r + int64_t(::magnitude(q->scale));
    const int d = q->degree;
    for (int n = (d + 1) * (d + 2) * (d + 3) / 6; n > 0; --n) q->coefficients.push_back(zigzag());
  }
  static bool are_apart(const Sheet& a, const Sheet& b) {
    for (size_t i = 0; i < a.signs.size(); ++i)
      if (a.signs[i] * b.signs[i] == -1) return true;
    return false;
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

StarBody read_star_body(const std::string& magic, const std::vector<Entity>& entities, Body bytes,
                        const std::function<void(StarBytes*)>& rest) {
  StarBody out;
  StarBodyReader r(bytes, &out);
  out.version = magic == "VTS2" ? 2 : 1;
  Cuts cuts = read_cuts(entities, magic.c_str(), out.version == 2, true, &r);
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
  out.unit = unit;
  if (out.version == 1) {
    for (uint64_t n = r.body.count(8); n > 0; --n) out.boxes.push_back(r.box_1());
  } else {
    for (uint64_t n = r.body.count(9); n > 0; --n) out.frames.push_back(r.frame());
    for (uint64_t n = r.body.count(9); n > 0; --n) out.boxes.push_back(r.box_2());
  }
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
  const bool has_mesh =
      std::any_of(out.boxes.begin(), out.boxes.end(), [](const Box& b) { return b.is_mesh; });
  for (size_t i = 0; i < places.size(); ++i) {
    Patch& made = out.patches[i];
    made.is_reversed = cuts.reversed[cuts.entity_of(i)];
    made.is_flat = out.version == 1
                       ? made.shape.is_triangle && made.shape.p == 1 && !made.is_rational
                       : has_mesh && is_flat_patch(made);
    std::copy(&roots[2 * i], &roots[2 * i] + 2, made.roots);
    made.first_root = out.num_roots;
    out.num_roots += made.num_roots();
  }
  out.breaks.swap(cuts.breaks);
  return out;
}
