// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_body.cc: B1 and B2 of docs/certificates/star-box.md: the body, and the patches that its breaks
// cut the surfaces into.
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

// The numbers times a factor > 0, as integers without a common factor. B2: the least common
// denominator and the numbers times it have at most so many bits.
std::vector<Big> integers(const std::vector<Ratio>& v, int64_t most) {
  Big factor = 1, common;
  for (const Ratio& x : v) {
    factor = factor * divide(x.d, gcd(factor, x.d), nullptr);
    require(factor.bits() <= most, "B2", "a common denominator has more bits than", uint64_t(most));
  }
  std::vector<Big> r;
  for (const Ratio& x : v) {
    r.push_back(x.n * divide(factor, x.d, nullptr));
    require(r.back().bits() <= most, "B2", "a number has more bits than", uint64_t(most));
  }
  for (size_t i = r.size(); i-- > 0 && !(common == Big(1));) common = gcd(common, r[i]);
  for (Big& x : r)
    if (!(common == Big(1)) && common.sign() != 0) x = divide(x, common, nullptr);
  return r;
}

// The Bezier coefficients on [a, b] of a spline of degree p are matrix times the control points
// first, ..., first + p, up to a common positive factor. By blossoms: coefficient j is the polar
// form at p - j times a and j times b, evaluated with the knots around the interval (de Boor), the
// steps of each level times the same factor.
struct Extraction {
  size_t first;
  std::vector<std::vector<Big>> matrix;
};
Extraction extraction(const std::vector<Ratio>& knots, size_t p, const Ratio& a, const Ratio& b) {
  size_t k = p;
  while (compare(knots[k + 1], a) <= 0) ++k;  // knots[k] <= a < b <= knots[k + 1]
  std::vector<Ratio> from_a;
  for (size_t i = k - p + 1; i <= k + p; ++i) from_a.push_back(knots[i] - a);
  from_a.push_back(b - a);
  const std::vector<Big> t = integers(from_a, kMostKnotBits);
  Extraction e = {k - p, {}};
  for (size_t j = 0; j <= p; ++j) {
    std::vector<std::vector<Big>> d(p + 1, std::vector<Big>(p + 1));
    for (size_t i = 0; i <= p; ++i) d[i][i] = 1;
    for (size_t r = 1; r <= p; ++r) {
      Big common = 1;
      for (size_t i = r; i <= p; ++i) {
        const Big length = t[p + i - r] - t[i - 1];
        common = common * divide(length, gcd(common, length), nullptr);
      }
      const Big at = r <= j ? t.back() : Big();
      for (size_t i = p; i >= r; --i) {
        const Big f = divide(common, t[p + i - r] - t[i - 1], nullptr);
        const Big up = f * (at - t[i - 1]), down = f * (t[p + i - r] - at);
        for (size_t c = 0; c <= p; ++c) d[i][c] = down * d[i - 1][c] + up * d[i][c];
      }
    }
    e.matrix.push_back(d[p]);
  }
  return e;
}

// Control points i * row + j with i, j from first on, p times q of them, homogeneous.
std::vector<Big> window(const Entity& e, const size_t* first, size_t p, size_t q, size_t row,
                        int64_t unit) {
  const size_t components = size_t(e.components);
  std::vector<Ratio> r;
  for (size_t i = 0; i < p; ++i)
    for (size_t j = 0; j < q; ++j)
      for (size_t c = 0; c < 4; ++c) {
        const size_t at = ((first[0] + i) * row + first[1] + j) * components + c;
        r.push_back(c < 3 ? scaled(e.points[at], -unit) : c < components ? e.points[at] : Ratio(1));
      }
  return integers(r, kMostBits);
}
std::vector<Big> extracted(const Entity& e, const Extraction& u, const Extraction& v,
                           int64_t unit) {
  const size_t p = u.matrix.size(), q = v.matrix.size();  // degrees + 1
  const size_t first[2] = {u.first, v.first};
  const std::vector<Big> net = window(e, first, p, q, e.knots[1].size() - q, unit);
  std::vector<Big> half(4 * p * q), r(4 * p * q);
  for (size_t i = 0; i < p; ++i)
    for (size_t j = 0; j < q; ++j)
      for (size_t c = 0; c < 4; ++c)
        for (size_t k = 0; k < q; ++k) {
          Big& to = half[(i * q + j) * 4 + c];
          to = to + v.matrix[j][k] * net[(i * q + k) * 4 + c];
        }
  for (size_t i = 0; i < p; ++i)
    for (size_t j = 0; j < 4 * q; ++j)
      for (size_t k = 0; k < p; ++k)
        r[i * 4 * q + j] = r[i * 4 * q + j] + u.matrix[i][k] * half[k * 4 * q + j];
  Big common;
  for (size_t i = r.size(); i-- > 0 && !(common == Big(1));) common = gcd(common, r[i]);
  for (Big& x : r) x = divide(x, common, nullptr);
  return r;
}

struct Place {  // of a patch: its entity, and the numbers of its intervals along u and v
  const Entity* entity;
  size_t surface, interval[2];
};
Patch patch(const Place& at, int64_t unit, const std::vector<std::vector<Ratio>>& breaks,
            std::vector<std::vector<Extraction>>* cache) {
  const Entity& e = *at.entity;
  Patch r = Patch();
  r.is_rational = e.is_rational;
  r.shape = Shape{e.kind == Entity::kTriangle, int(e.degrees[0]), int(e.degrees.back())};
  if (r.shape.is_triangle) {
    const size_t first[2] = {0, 0};
    r.net = window(e, first, 1, size_t(r.shape.count()), 0, unit);
    return r;
  }
  const Extraction* part[2];
  for (size_t a = 0; a < 2; ++a) {
    std::vector<Extraction>& known = (*cache)[2 * at.surface + a];
    const std::vector<Ratio>& b = breaks[2 * at.surface + a];
    while (known.size() <= at.interval[a])
      known.push_back(
          extraction(e.knots[a], size_t(e.degrees[a]), b[known.size()], b[known.size() + 1]));
    part[a] = &known[at.interval[a]];
  }
  r.net = extracted(e, *part[0], *part[1], unit);
  return r;
}

uint64_t cost(const Patch& p) {
  int64_t bits = 0;
  for (const Big& x : p.net) bits = std::max(bits, x.bits());
  const int d = p.shape.p, c = p.shape.is_triangle ? 3 * d * (3 * d - 1) / 2 : 9 * d * p.shape.q;
  require(c * bits <= kMostSize, "B2", "the coefficients are too long for their degree, bits",
          uint64_t(bits));
  return 1 + uint64_t(c * bits) / 16384;
}

}  // namespace

StarBody read_star_body(const std::vector<Entity>& entities, Body bytes) {
  StarBody out;
  Reader r = {bytes, &out};
  require(r.body.natural(4) == 0x42535456, "B1", "another magic number");
  require(r.body.natural(4) == entities.size(), "B1", "the model's entities are", entities.size());
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
  std::vector<std::vector<Extraction>> cache(breaks.size());
  for (size_t i = 0; i < places.size(); ++i) {
    out.patches.push_back(patch(places[i], unit, breaks, &cache));
    Patch& made = out.patches.back();
    made.is_flipped = flipped[size_t(places[i].entity - entities.data())];
    made.cost = cost(made);
    std::copy(&roots[2 * i], &roots[2 * i] + 2, made.roots);
    made.first_symbol = symbols[i];
    made.first_root = out.num_roots;
    out.num_roots += made.num_roots();
  }
  return out;
}
