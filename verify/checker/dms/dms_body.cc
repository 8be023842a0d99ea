// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_body.cc: B1, but for F, and B2 of docs/certificates/dms-solid.md.
#include "dms_bytes.h"

namespace {

const int kMostDmsLevels = 64;
const int64_t kMostFileBits = 256, kMostWordBits = 64;

struct DmsProofBytes : DmsBytes {
  explicit DmsProofBytes(const Body& bytes) : DmsBytes(bytes) {}

  DmsTree tree() {
    DmsTree t;
    uint64_t open[kMostDmsLevels + 1] = {1};  // nodes to come, by level
    for (int level = 0; level >= 0;) {
      if (open[level] == 0) {
        --level;
        continue;
      }
      --open[level];
      const uint64_t symbol = at_most(body.natural(1), 13, "a symbol is");
      t.symbols.push_back(uint8_t(symbol));
      if (symbol >= 12) {
        DmsLeaf leaf;
        leaf.is_polynomial = symbol == 13;
        leaf.r = rationals(9);
        leaf.planes = planes();
        t.leaves.push_back(std::move(leaf));
        continue;
      }
      require(level < kMostDmsLevels, "B1", "a tree is deeper than 64 levels");
      if (symbol >= 6) {
        t.cuts.push_back(rational());
        require(t.cuts.back().n.sign() > 0 && compare(t.cuts.back(), Ratio(Big(1))) < 0, "B1",
                "an edge is not cut between its ends");
      }
      open[++level] = 2;
    }
    return t;
  }
  DmsTile tile(uint64_t points) {
    DmsTile t;
    for (uint64_t& c : t.corner) {
      c = varint();
      require(c < points, "B1", "there is no point", c);
    }
    t.planes = planes();
    return t;
  }
  Body part() {
    const uint64_t length = body.count(1);
    const Body r = {body.p, body.p + length};
    body.p += length;
    return r;
  }
};

}  // namespace

uint64_t DmsBytes::number_of(uint64_t bytes_each) {
  const uint64_t n = varint();
  require(n <= body.left() / bytes_each, "B1", "too few bytes for the count", n);
  return n;
}
std::vector<Ratio> DmsBytes::rationals(size_t n) {
  std::vector<Ratio> r;
  while (r.size() < n) r.push_back(rational());
  return r;
}
std::vector<Ratio> DmsBytes::planes() {
  std::vector<Ratio> r;
  for (uint64_t n = number_of(8); n > 0; --n) {
    for (int k = 0; k < 4; ++k) r.push_back(rational());
    const Ratio* const v = &r[r.size() - 4];
    require(v[0].n.sign() != 0 || v[1].n.sign() != 0 || v[2].n.sign() != 0, "B1",
            "a plane has no normal");
  }
  return r;
}
void check_short(const std::vector<Ratio>& v, int64_t most) {
  for (const Ratio& x : v)
    require(x.n.bits() <= most && x.d.bits() <= most, "B2", "a number is too long, bits",
            uint64_t(std::max(x.n.bits(), x.d.bits())));
}
void check_dms_file(const DmsFile& file) {
  require(file.n <= kMostProvedDegree, "B2", "the degree is", uint64_t(file.n));
  check_short(file.knots, kMostFileBits);
  check_short(file.values, kMostFileBits);
}

DmsBody read_dms_body(const DmsFile& file, const Body& body) {
  DmsProofBytes b(body);
  DmsBody r;
  require(b.body.begins_with("VTDM"), "B1", "another magic number");
  const uint64_t tetrahedra = b.body.natural(4);
  require(tetrahedra == file.tetrahedra.size(), "B1", "the file's tetrahedra are",
          file.tetrahedra.size());
  r.faces = b.body.natural(4);
  const uint64_t added = b.body.natural(4), left = b.body.left();
  require(20 * tetrahedra <= left && 2 * r.faces <= left && 6 * added <= left, "B1",
          "too few bytes for the counts of faces and points", r.faces);
  r.added = b.rationals(3 * added);
  while (r.trees.size() < tetrahedra) r.trees.push_back(b.tree());
  while (r.planes.size() < r.faces) r.planes.push_back(b.planes());
  const uint64_t points = file.clouds.size() + added;
  while (r.tiles.size() < r.faces) {
    std::vector<DmsTile> tiles;
    for (uint64_t n = b.number_of(4); n > 0; --n) tiles.push_back(b.tile(points));
    r.tiles.push_back(std::move(tiles));
  }
  r.domain = b.part();
  r.surface = b.part();
  b.end();

  check_dms_file(file);
  check_short(r.added, kMostDmsBodyBits);
  for (const DmsTree& t : r.trees) {
    check_short(t.cuts, kMostWordBits);
    for (const DmsLeaf& leaf : t.leaves) {
      check_short(leaf.r, kMostWordBits);
      check_short(leaf.planes, kMostDmsBodyBits);
    }
  }
  for (const std::vector<Ratio>& v : r.planes) check_short(v, kMostDmsBodyBits);
  for (const std::vector<DmsTile>& tiles : r.tiles)
    for (const DmsTile& t : tiles) check_short(t.planes, kMostDmsBodyBits);
  return r;
}
