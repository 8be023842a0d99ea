// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_body.cc: B1, but for F, and B2 of docs/certificates/dms-solid.md.
#include "dms_bytes.h"

namespace {

const int kMostDmsLevels = 64;
const uint64_t kMostOfBlock = 16, kMostPlanesOfBlock = 64;
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
  uint64_t number_below(uint64_t limit, const char* what) {
    const uint64_t n = varint();
    require(n < limit, "B1", what, n);
    return n;
  }
  DmsBlock block(uint64_t all) {
    DmsBlock r;
    for (uint64_t n = at_most(number_of(1), kMostOfBlock, "tetrahedra of a block are"); n > 0;
         --n) {
      const uint64_t t = number_below(all, "there is no tetrahedron");
      require(r.tetrahedra.empty() || r.tetrahedra.back() < t, "B1",
              "tetrahedra of a block are not in ascending order, at", t);
      r.tetrahedra.push_back(t);
    }
    require(!r.tetrahedra.empty(), "B1", "a block is empty");
    r.r = rationals(9);
    r.planes = planes();
    require(r.planes.size() <= 4 * kMostPlanesOfBlock, "B1", "planes of a block are",
            r.planes.size() / 4);
    return r;
  }
  DmsPair pair(uint64_t faces, const DmsFile& file) {
    DmsPair p;
    for (uint64_t& f : p.face) f = number_below(faces, "there is no face");
    require(p.face[0] < p.face[1], "B1", "a pair is not in ascending order, of face", p.face[0]);
    p.kind = DmsPair::Kind(at_most(body.natural(1), 2, "a kind is"));
    if (p.kind == DmsPair::kChain) {
      const uint64_t edges = number_of(2);
      while (p.chain.size() <= edges)
        p.chain.push_back(number_below(file.clouds.size(), "there is no vertex"));
      while (p.tetrahedra.size() < edges)
        p.tetrahedra.push_back(number_below(file.tetrahedra.size(), "there is no tetrahedron"));
    }
    if (p.kind == DmsPair::kAtEdge) p.feet = rationals(2);
    for (const Ratio& t : p.feet)
      require(t.n.sign() >= 0 && compare(t, Ratio(Big(1))) <= 0, "B1",
              "a foot is not on its edge, of face", p.face[0]);
    p.directions = rationals(p.kind == DmsPair::kAtEdge ? 6 : 3);
    return p;
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

namespace {

// What both versions begin with; behind it comes a third count.
void read_counts(const DmsFile& file, const char* magic, DmsProofBytes* b, DmsBody* r) {
  require(b->body.begins_with(magic), "B1", "another magic number");
  const uint64_t tetrahedra = b->body.natural(4);
  require(tetrahedra == file.tetrahedra.size(), "B1", "the file's tetrahedra are",
          file.tetrahedra.size());
  r->faces = b->body.natural(4);
}
void check_size(const DmsFile& file, const DmsBody& r, uint64_t bytes_of_face, uint64_t more,
                uint64_t left) {
  require(20 * file.tetrahedra.size() <= left && bytes_of_face * r.faces <= left && more <= left,
          "B1", "too few bytes for the counts, with faces", r.faces);
}
void read_trees(const DmsFile& file, DmsProofBytes* b, DmsBody* r) {
  while (r->trees.size() < file.tetrahedra.size()) r->trees.push_back(b->tree());
  while (r->planes.size() < r->faces) r->planes.push_back(b->planes());
}
void check_numbers(const DmsFile& file, const DmsBody& r) {
  check_dms_file(file);
  for (const DmsTree& t : r.trees) {
    check_short(t.cuts, kMostWordBits);
    for (const DmsLeaf& leaf : t.leaves) {
      check_short(leaf.r, kMostWordBits);
      check_short(leaf.planes, kMostDmsBodyBits);
    }
  }
  for (const std::vector<Ratio>& v : r.planes) check_short(v, kMostDmsBodyBits);
}

}  // namespace

DmsBody read_dms_body(const DmsFile& file, const Body& body) {
  DmsProofBytes b(body);
  DmsBody r;
  read_counts(file, "VTDM", &b, &r);
  const uint64_t added = b.body.natural(4);
  check_size(file, r, 2, 6 * added, b.body.left());
  r.added = b.rationals(3 * added);
  read_trees(file, &b, &r);
  const uint64_t points = file.clouds.size() + added;
  while (r.tiles.size() < r.faces) {
    std::vector<DmsTile> tiles;
    for (uint64_t n = b.number_of(4); n > 0; --n) tiles.push_back(b.tile(points));
    r.tiles.push_back(std::move(tiles));
  }
  r.domain = b.part();
  r.surface = b.part();
  b.end();

  check_numbers(file, r);
  check_short(r.added, kMostDmsBodyBits);
  for (const std::vector<DmsTile>& tiles : r.tiles)
    for (const DmsTile& t : tiles) check_short(t.planes, kMostDmsBodyBits);
  return r;
}

DmsBody read_dms_body_2(const DmsFile& file, const Body& body) {
  DmsProofBytes b(body);
  DmsBody r;
  read_counts(file, "VTD2", &b, &r);
  const uint64_t blocks = b.body.natural(4), pairs = b.body.natural(4);
  check_size(file, r, 1, 21 * blocks, b.body.left());
  check_size(file, r, 1, 9 * pairs, b.body.left());
  read_trees(file, &b, &r);
  while (r.blocks.size() < blocks) r.blocks.push_back(b.block(file.tetrahedra.size()));
  while (r.pairs.size() < pairs) {
    r.pairs.push_back(b.pair(r.faces, file));
    if (r.pairs.size() < 2) continue;
    const DmsPair &last = r.pairs.back(), &before = r.pairs[r.pairs.size() - 2];
    require(
        std::make_pair(before.face[0], before.face[1]) < std::make_pair(last.face[0], last.face[1]),
        "B1", "pairs are not in ascending order, at pair", r.pairs.size() - 1);
  }
  r.domain = b.part();
  b.end();

  check_numbers(file, r);
  for (const DmsBlock& block : r.blocks) {
    check_short(block.r, kMostWordBits);
    check_short(block.planes, kMostDmsBodyBits);
  }
  for (const DmsPair& pair : r.pairs) {
    check_short(pair.feet, kMostWordBits);
    check_short(pair.directions, kMostWordBits);
  }
  return r;
}
