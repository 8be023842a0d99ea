// SPDX-License-Identifier: Apache-2.0 OR MIT
// vmodel_body.cc: B1 of docs/certificates/vmodel.md, and B2 as far as it needs no coefficients.
#include "vmodel.h"

namespace {

struct VModelReader : Bytes {
  VModelReader(const std::vector<Entity>& volumes, const Body& bytes) : Bytes(bytes) {
    require(body.begins_with("VTVM"), "B1", "another magic number");
    require(body.count(10) == volumes.size(), "B1", "the file's entities are", volumes.size());
    for (const Entity& e : volumes) {
      out.cells.push_back(VCell());
      out.cells.back().volume = &e;
      out.cells.back().is_reversed = at_most(body.natural(1), 1, "a flag is") == 1;
    }
  }
  VBody out;

  void breaks(VCell* cell, size_t axis) {
    uint64_t left = varint();
    require(left <= body.left() / 2, "B1", "too few bytes for the breaks", left);
    std::vector<Ratio> added;
    for (; left > 0; --left) {
      added.push_back(rational());
      require(added.size() < 2 || compare(added[added.size() - 2], added.back()) < 0, "B1",
              "added breaks do not rise");
    }
    const std::vector<Ratio>& t = cell->volume->knots[axis];
    std::vector<Ratio>& r = cell->breaks[axis];
    size_t k = 0;
    for (const Ratio& knot : t) {
      if (!r.empty() && compare(knot, r.back()) == 0) continue;
      for (; k < added.size() && compare(added[k], knot) < 0; ++k) {
        require(!r.empty(), "B1", "an added break is not in the domain");
        r.push_back(added[k]);
      }
      require(k == added.size() || compare(added[k], knot) != 0, "B1", "an added break is a knot");
      r.push_back(knot);
    }
    require(k == added.size(), "B1", "an added break is not in the domain");
  }
  void codes() {
    const uint64_t n = 6 * out.cells.size();
    for (uint64_t f = 0; f < n; ++f) {
      FaceCode c = FaceCode();
      c.code = varint();
      if (c.code >= 3) {
        c.other = (c.code - 3) / 8, c.symmetry = unsigned((c.code - 3) % 8);
        require(c.other < n - f - 1, "B1", "a code names a face that does not exist, of face", f);
        c.other += f + 1, c.code = 3;
      }
      out.faces.push_back(c);
    }
  }
  void entries() {
    uint64_t piece = 0, left = varint();
    require(left <= body.left() / 3, "B1", "too few bytes for the determinants", left);
    for (; left > 0; --left, ++piece) {
      const uint64_t skip = varint();
      require(piece < out.pieces && skip < out.pieces - piece, "B1",
              "a piece does not exist, after", piece);
      piece += skip;
      VEntry& e = out.entries[piece];
      const uint64_t zeros = varint();
      require(zeros >> 26 == 0, "B1", "a zero that is no face, edge or corner");
      e.zeros = uint32_t(zeros);
      tree(&e.tree);
    }
  }
  void tree(std::vector<uint8_t>* to) {
    std::vector<int> levels(1, 0);
    while (!levels.empty()) {
      const int level = levels.back();
      levels.pop_back();
      const uint64_t symbol = at_most(body.natural(1), 3, "a symbol of a tree is");
      require(symbol == 0 || level < kMostHalvings, "B1", "a tree of determinants is too deep");
      to->push_back(uint8_t(symbol));
      if (symbol != 0) levels.insert(levels.end(), 2, level + 1);
    }
  }
};

}  // namespace

VBody read_vbody(const std::vector<Entity>& volumes, const Body& bytes) {
  VModelReader r(volumes, bytes);
  for (VCell& cell : r.out.cells)
    for (size_t axis = 0; axis < 3; ++axis) r.breaks(&cell, axis);
  r.codes();
  for (const VCell& cell : r.out.cells) {
    uint64_t pieces = 1;
    for (size_t axis = 0; axis < 3; ++axis) {
      require(cell.intervals(axis) <= kMostPieces / pieces, "B2", "too many pieces");
      pieces *= cell.intervals(axis);
    }
    r.out.pieces += pieces;
    require(r.out.pieces <= kMostPieces, "B2", "too many pieces");
  }
  require(volumes.size() <= kMostCells, "B2", "too many cells:", volumes.size());
  for (const Entity& e : volumes)
    for (int64_t p : e.degrees) require(p <= kMostDegree, "B2", "a degree is over 15");
  r.entries();
  r.out.rest = r.body;
  return std::move(r.out);
}
