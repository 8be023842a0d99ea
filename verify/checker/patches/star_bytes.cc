// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "star_bytes.h"

uint64_t Bytes::any_varint() {
  uint64_t v = 0;
  for (unsigned i = 0;; ++i) {
    const uint64_t byte = body.natural(1);
    require(i < 9 || byte <= 1, "B1", "a varint is 2^64 or more");
    require(i == 0 || byte != 0, "B1", "a varint is not in shortest form");
    v |= (byte & 127) << 7 * i;
    if (byte < 128) return v;
  }
}
uint64_t Bytes::varint() {
  const uint64_t v = any_varint();
  require(v >> 63 == 0, "B1", "a varint is 2^63 or more");
  return v;
}
int64_t Bytes::zigzag() {
  const uint64_t v = any_varint();
  require(v != ~uint64_t(0), "B1", "a number is -2^63");
  return v % 2 == 0 ? int64_t(v / 2) : -int64_t(v / 2) - 1;
}
Big Bytes::magnitude(uint64_t size) {
  require(size <= body.left(), "B1", "the body ends too early");
  Big r;
  for (uint64_t i = 0; i < size; ++i) {
    if (i % 8 == 0) r.m.push_back(0);
    r.m.back() |= body.natural(1) << 8 * (i % 8);
  }
  require(size == 0 || body.p[-1] != 0, "B1", "the last byte of a number is 0");
  return r;
}
Ratio Bytes::rational() {
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
int64_t Bytes::scaled(int64_t v, uint64_t s) const {
  require(s < 62 || v == 0, "B1", "a coordinate is too far away, s =", s);
  const int64_t far = v == 0 ? 0 : kFarthest >> s;
  require(v == 0 || (v < far && v > -far), "B1", "a coordinate is too far away");
  return v == 0 ? 0 : v * (int64_t(1) << s);
}

namespace {

std::vector<Ratio> breaks(const Entity& e, size_t a, Bytes* bytes) {  // along one axis
  const std::vector<Ratio>& t = e.knots[a];
  const size_t p = size_t(e.degrees[a]), n = t.size() - p - 1;
  std::vector<Ratio> r;
  for (uint64_t left = bytes->body.count(2); left > 0; --left) {
    r.push_back(bytes->rational());
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

}  // namespace

Place Cuts::place(size_t entity, uint64_t patch) const {
  const Entity& e = (*entities)[entity];
  if (e.kind != Entity::kSurface) return Place{&e, 0, {0, 0}};
  const uint64_t i = patch - first[entity], v = intervals(entity, 1);
  return Place{&e, surface[entity], {size_t(i / v), size_t(i % v)}};
}

Cuts read_cuts(const std::vector<Entity>& entities, const char* magic, bool has_kinds,
               bool take_bytes, Bytes* bytes) {
  Cuts r;
  r.entities = &entities;
  require(bytes->body.begins_with(magic), "B1", "another magic number");
  require(bytes->body.natural(4) == entities.size(), "B1", "the model's entities are",
          entities.size());
  require(!entities.empty(), "B1", "a model without entities bounds nothing");
  for (size_t i = 0; i < entities.size(); ++i) {
    require(!has_kinds || bytes->body.natural(1) == uint64_t(entities[i].kind), "B1",
            "the model has another kind of entity", i);
    r.reversed.push_back(bytes->at_most(bytes->body.natural(1), 1, "a flag is") == 1);
    r.num_reversed += r.reversed.back();
  }
  read_breaks(take_bytes, bytes, &r);
  return r;
}

void read_breaks(bool take_bytes, Bytes* bytes, Cuts* cuts) {
  const std::vector<Entity>& entities = *cuts->entities;
  Cuts& r = *cuts;
  r.first.push_back(0);
  for (size_t i = 0; i < entities.size(); ++i) {
    uint64_t n = entities[i].kind == Entity::kTriangle;
    r.surface.push_back(r.breaks.size() / 2);
    if (entities[i].kind == Entity::kSurface) {
      for (size_t a = 0; a < 2; ++a) r.breaks.push_back(breaks(entities[i], a, bytes));
      n = r.intervals(i, 0) * r.intervals(i, 1);  // below 2^64, but their sum may not be
    }
    require(n < uint64_t(1) << 62 && r.patches() < uint64_t(1) << 62, "B1", "too many patches", n);
    r.first.push_back(r.patches() + n);
    require(!take_bytes || r.patches() <= bytes->body.left() / 3, "B1",
            "too few bytes for the patches", r.patches());
  }
}

void check_kinds(const std::vector<Entity>& entities) {
  for (const Entity& e : entities) {
    require(e.kind != Entity::kOther, "B2", "an entity is neither surface nor triangle");
    require(e.components - e.is_rational == 3, "B2", "a patch has not three coordinates");
    require(e.degrees[0] <= kMostDegree && e.degrees.back() <= kMostDegree, "B2",
            "a degree is over 15");
  }
}
