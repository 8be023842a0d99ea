// SPDX-License-Identifier: Apache-2.0 OR MIT
// collar_body.cc: B1 of docs/certificates/collar.md, section 2: what follows the walks.
#include "collar.h"

namespace {

struct Reader {
  StarBytes* in;
  CollarBody out;

  void read() {
    out.shift = in->shift();
    for (int k = 0; k < 3; ++k) {
      const int64_t v = in->zigzag();
      out.low[k] = in->scaled(v, out.shift);
      require(v < kFarthest - kRootEdge, "B1", "a coordinate is too far away");
      in->scaled(v + kRootEdge, out.shift);
    }
    const uint64_t cells = in->body.count(2);  // each collapse takes a byte, too
    require(cells >= 1, "B1", "there are no cells");
    for (uint64_t i = 0; i < cells; ++i) {
      out.differences.push_back(in->varint());
      require(out.differences[i] >= 1, "B1", "the codes of the cells do not rise at cell", i);
    }
    for (uint64_t n = in->body.count(1); n > 0; --n)
      out.sides.push_back(uint8_t(in->body.natural(1)));
    require(cells <= in->body.left(), "B1", "too few bytes for the collapses of the cells", cells);
    for (uint64_t i = 0; i < cells; ++i) out.collapses.push_back(in->zigzag());
    leaves();
    for (size_t i = 0; i < out.sides.size(); ++i) {
      out.shores.push_back(Walk());
      in->points_and_end(&out.shores.back());
    }
  }
  // Reads a tree for each leaf of the body's trees. A symbol that comes when no level is open is a
  // root.
  void leaves() {
    uint64_t open[kLevels + 1] = {};
    int level = 0;
    for (uint32_t symbol : in->out->symbols) {
      while (level > 0 && open[level] == 0) --level;
      if (level > 0) --open[level];
      if (symbol != 0)
        leaf(level);
      else
        open[++level] = 4;
    }
  }
  void leaf(int root) {
    uint64_t open[kLevels + 1] = {};
    open[root] = 1;
    for (int level = root; level >= root;) {
      if (open[level] == 0) {
        --level;
        continue;
      }
      --open[level];
      out.symbols.push_back(
          uint8_t(in->at_most(in->body.natural(1), 1, "a symbol of a leaf's tree is")));
      if (out.symbols.back() != 0) {
        ++out.leaves;
        continue;
      }
      require(level < kLevels, "B1", "a leaf's tree is deeper than 24 levels in all");
      open[++level] = 4;
    }
  }
};

}  // namespace

CollarBody read_collar_body(StarBytes* bytes) {
  Reader r = {bytes, CollarBody()};
  r.read();
  return std::move(r.out);
}
