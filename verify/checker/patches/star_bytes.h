// SPDX-License-Identifier: Apache-2.0 OR MIT
// star_bytes.h: what the bodies of certificates about spline models share. Everything here except
// check_kinds is B1 of docs/certificates/star-box.md, sections 2 and 3.
#pragma once
#include "star.h"

struct Bytes {
  explicit Bytes(const Body& bytes) : body(bytes) {}

  Body body;

  uint64_t any_varint();  // below 2^64, in shortest form
  uint64_t varint();      // below 2^63
  int64_t zigzag();       // above -2^63
  uint64_t at_most(uint64_t v, uint64_t most, const char* why) const {
    require(v <= most, "B1", why, v);
    return v;
  }
  Ratio rational();
  uint64_t shift() { return at_most(varint(), kMostUnit, "s is over 4096:"); }
  // v 2^s, in units 2^E.
  int64_t scaled(int64_t v, uint64_t s) const;
  void end() const { require(body.left() == 0, "B1", "bytes behind the body's end:", body.left()); }

 private:
  Big magnitude(uint64_t size);  // from this many bytes
};

struct StarBytes : Bytes {  // a body with boxes
  StarBytes(const Body& bytes, StarBody* to) : Bytes(bytes), out(to) {}

  StarBody* out;

  uint64_t box_index();
  void points_and_end(Walk* w);  // a walk without its start
};
// Reads a body of the version with this magic; a claim based on star boxes adds what comes after the walks. All claims:
// B1, B2.
StarBody read_star_body(const std::string& magic, const std::vector<Entity>& entities, Body body,
                        const std::function<void(StarBytes*)>& rest);

struct Cuts {  // how a body cuts the model into patches
  const std::vector<Entity>* entities;
  std::vector<bool> reversed;
  std::vector<std::vector<Ratio>> breaks;  // two for each surface
  std::vector<uint64_t> first;             // patch of each entity, and the number of all
  std::vector<size_t> surface;             // of each entity: how many stand before it
  uint64_t num_reversed = 0;

  uint64_t patches() const { return first.back(); }
  uint64_t intervals(size_t entity, size_t axis) const {
    return breaks[2 * surface[entity] + axis].size() - 1;
  }
  size_t entity_of(uint64_t patch) const {
    return size_t(std::upper_bound(first.begin(), first.end(), patch) - first.begin()) - 1;
  }
  Place place(size_t entity, uint64_t patch) const;  // a patch of this entity
};
// Reads magic, N, kinds (has_kinds), flags and breaks. If patches take bytes (three each), their
// number is compared with the bytes left.
Cuts read_cuts(const std::vector<Entity>& entities, const char* magic, bool has_kinds,
               bool take_bytes, Bytes* bytes);
// Fills the cuts from the breaks on. REQUIRES their entities.
void read_breaks(bool take_bytes, Bytes* bytes, Cuts* cuts);
// The part of B2 that needs no coefficients.
void check_kinds(const std::vector<Entity>& entities);
