// SPDX-License-Identifier: Apache-2.0 OR MIT
// collar.h: the complex of a collar. The page: docs/certificates/collar.md.
#pragma once
#include "../patches/star_box.h"

struct CollarBody {  // what docs/certificates/collar.md adds to the body
  uint64_t shift = 0, leaves = 0;
  int64_t low[3];                     // corner of the root cube, in units 2^E
  std::vector<uint64_t> differences;  // between the codes of successive cells
  std::vector<uint8_t> sides, symbols;
  std::vector<int64_t> collapses;  // differences of faces' numbers
  std::vector<Walk> shores;        // from the components' least vertices
};
const int64_t kRootEdge = 1 << 20;  // in units 2^(E + shift); with both ends in range shift <= 41
CollarBody read_collar_body(StarBytes* bytes);

const uint32_t kNone = 0xffffffff;
const int kDepth = 20;                          // the level of the deepest cells
const uint64_t kMostCells = 1 << 24;            // K0
const uint64_t kMostFaces = uint64_t(1) << 26;  // a limit of this checker, about 6 GiB

// Points of the grid, [0, 2^20]^3, are ordered by (z, y, x): along an axis, the keys of its points
// rise.
const uint64_t kGrid = uint64_t(kRootEdge) + 1;
inline uint64_t point_key(const uint32_t* x) { return (x[2] * kGrid + x[1]) * kGrid + x[0]; }
inline void point_of(uint64_t key, uint32_t* x) {
  x[0] = uint32_t(key % kGrid), x[1] = uint32_t(key / kGrid % kGrid);
  x[2] = uint32_t(key / kGrid / kGrid);
}

struct Cell {
  uint32_t low[3], size;
};
Cell cell_of(uint64_t code);

struct Face {
  uint64_t key;  // its least corner's key times 3, plus its normal axis; faces are ordered by it
  uint32_t cell[2];  // below and above it along the axis, or kNone
  uint32_t
      corner[4];  // vertices; bit 0: high along the next axis after its normal, 1: the one after
  int axis() const { return int(key % 3); }
  bool is_boundary() const { return cell[0] == kNone || cell[1] == kNone; }
  uint32_t any_cell() const { return cell[0] != kNone ? cell[0] : cell[1]; }
};

// The parts of edges between neighbouring vertices of a line. Each has room for one face in either
// direction along either of the two other axes.
struct Around {
  uint32_t face[4];
};

// The common subdivision. Everything but the codes is built by sorting: O(n log n) time and about
// 90 bytes a face, n the number of faces.
struct Complex {
  std::vector<uint64_t> codes;
  std::vector<Face> faces;
  std::vector<uint64_t> vertices;  // keys, ascending
  // Along axis d: order[d] has the vertices in the order of lines; place[d] is the inverse;
  // around[d][i] is the edge from order[d][i] to order[d][i + 1], if a face has it.
  std::vector<uint32_t> order[3], place[3];
  std::vector<Around> around[3];

  explicit Complex(const CollarBody& body);  // K0

  // Calls use(axis, i, slot) for the edges of a face.
  template <class Use>
  void each_edge(const Face& f, Use use) const {
    for (int k = 0; k < 2; ++k) {  // along axis n + 1 + k
      const int d = (f.axis() + 1 + k) % 3, other = (f.axis() + 2 - k) % 3;
      for (int high = 0; high < 2; ++high) {
        const uint32_t from = place[d][f.corner[high << (1 - k)]];
        const uint32_t to = place[d][f.corner[(high << (1 - k)) | 1 << k]];
        for (uint32_t i = from; i < to; ++i) use(d, i, 2 * int(other == (d + 2) % 3) + high);
      }
    }
  }
  // Calls use(axis, i) for the at most six edges at a vertex; some of them may be empty.
  template <class Use>
  void each_edge_at(uint32_t vertex, Use use) const {
    for (int d = 0; d < 3; ++d) {
      const uint32_t i = place[d][vertex];
      if (i > 0) use(d, i - 1);
      use(d, i);
    }
  }

 private:
  void add_faces(int axis);
  void add_vertices();
  void add_edges();
};

// K1 and K2. Boundary components are numbered by their least faces.
struct Shores {
  Shores(const Complex& k, const std::vector<uint8_t>& sides);

  std::vector<uint32_t> of_face;       // the boundary component, or kNone
  std::vector<uint32_t> of_cell;       // the component of |K|
  std::vector<uint32_t> least;         // face of each boundary component
  std::vector<uint32_t> outer, inner;  // boundary components of each component of |K|
  std::vector<int64_t> chi;            // each boundary component's
  std::vector<bool> is_outer;          // whether each boundary component is in d+
  bool is_kept(uint32_t face) const { return of_face[face] != kNone && is_outer[of_face[face]]; }

 private:
  void find_components(const Complex& k);
  void pair(const Complex& k, const std::vector<uint8_t>& sides);
};
void check_collapse(const Complex& k, const Shores& shores,
                    const std::vector<int64_t>& collapses);  // K3
