// SPDX-License-Identifier: Apache-2.0 OR MIT
// vmodel.h: what the parts of vmodel-1 share. The page: docs/certificates/vmodel.md. Faces, edges, corners, sub-faces
// and symmetries have its numbers.
#pragma once
#include "../patches/star_bytes.h"
#include "../patches/star_extraction.h"

const uint64_t kMostCells = 1 << 20, kMostPieces = 1 << 24;
const int kMostHalvings = 64, kWholeBox = 26;

// The two other axes, ascending.
inline size_t other_axis(size_t axis, size_t which) {
  return which == 0 ? (axis == 0 ? 1 : 0) : (axis == 2 ? 1 : 2);
}
inline size_t edge_number(size_t axis, size_t e, size_t f) { return 4 * axis + e + 2 * f; }

enum class Collapse { kNone, kPoint, kFirst, kSecond };
struct VCell {
  const Entity* volume;
  bool is_reversed;
  std::vector<Ratio> breaks[3];
  Collapse faces[6];
  bool edges[12];  // collapsed

  size_t intervals(size_t axis) const { return breaks[axis].size() - 1; }
  uint64_t pieces() const { return intervals(0) * intervals(1) * intervals(2); }
};
struct FaceCode {
  uint64_t code;       // 0, 1, 2; 3: the face names another one
  uint64_t other = 0;  // that
  unsigned symmetry = 0;
};
struct VEntry {  // of the list of section 5
  uint32_t zeros;
  std::vector<uint8_t> tree;
};
struct VBody {
  std::vector<VCell> cells;
  std::vector<FaceCode> faces;  // six a cell
  std::map<uint64_t, VEntry> entries;
  uint64_t pieces = 0;
  Body rest;
};
// B1, and B2 as far as it needs no coefficients.
VBody read_vbody(const std::vector<Entity>& volumes, const Body& bytes);

struct VPiece {
  size_t index[3];
  size_t n[3];           // numbers of coefficients along the axes
  std::vector<Big> net;  // X, Y, Z, W of each coefficient, axis 2 fastest
  int64_t bits;          // of the longest of them
  bool is_rational;

  size_t at(size_t i, size_t j, size_t k) const { return 4 * ((i * n[1] + j) * n[2] + k); }
  size_t count() const { return n[0] * n[1] * n[2]; }
  size_t times(size_t factor) const {  // coefficients of a polynomial of so many times the degrees
    size_t r = 1;
    for (size_t x : n) r *= factor * (x - 1) + 1;
    return r;
  }
  size_t degrees() const { return n[0] + n[1] + n[2] - 3; }
};
struct Place3 {  // the whole cell, one of its faces, or one of its edges
  int end[3];    // across an axis: 0 or 1, its begin or end; along it: -1
};
struct AxisInterval {  // what makes control points coefficients on an interval of an axis
  Extraction made;
  bool is_unit;   // the coefficients are the control points
  bool is_fixed;  // at an end of the axis
  uint64_t bits;
};
// Cuts a cell, a face or an edge at the breaks of the cell's axes. B2: for the intervals of the axes at once, and for
// each part when it is cut. An axis across the place has one interval.
class PieceCutter {
 public:
  PieceCutter(const VCell& cell, const Place3& place, Units* units);
  size_t intervals(size_t axis) const { return axes_[axis].size(); }
  VPiece cut(size_t i, size_t j, size_t k);

 private:
  const Entity& volume_;
  Units& units_;
  std::vector<AxisInterval> axes_[3];
};
extern const Place3 kWholeCell;
// Calls use(piece) for each piece of the cell, in order. B2.
void cut_pieces(const VCell& cell, Units* units, const std::function<void(const VPiece&)>& use);
// Fills in which faces and edges of the cell are collapsed.
void find_collapses(VCell* cell);
// V1 for the edges of a piece.
void check_edges(const VCell& cell, const VPiece& piece);
// Bernstein coefficients of N with the flag 0, each times its binomials. The units' condition fails if they exceed the
// limit.
std::vector<Big> coefficients_of_n(const VPiece& piece, Units* units);
// V2. may_vanish[f]: whether face f of the piece lies in a face of the cell with the code 0 or 1.
void check_determinant(const VPiece& piece, const VEntry& entry, bool is_reversed,
                       const bool* may_vanish, Units* units);

struct CheckedCells {
  std::vector<FaceCode> faces;              // six a cell
  std::map<std::string, uint64_t> numbers;  // of the cells and of X
};
// The conditions from B1 to W2 for a body about these volumes. model_bytes: of the file that holds them.
CheckedCells check_cells(const std::vector<Entity>& volumes, uint64_t model_bytes,
                         const Body& bytes);

// Where the symmetry takes a place of m x n ones.
std::pair<size_t, size_t> moved(size_t i, size_t j, size_t m, size_t n, unsigned symmetry);
// The map of a face of the piece, taken by the symmetry: a text that is equal for maps that agree, in any degrees, up
// to a positive factor.
std::string face_key(const VPiece& piece, size_t axis, bool at_end, unsigned symmetry);
// The corner of a cell at these ends of the parameters of its face.
uint64_t corner_of(uint64_t face, size_t s, size_t t);
// The edge of a cell that is the side of its face along parameter `which`, at an end of the other one.
uint64_t side_of(uint64_t face, size_t which, size_t end);

struct Classes {
  explicit Classes(size_t count) : parent(count) {
    for (uint32_t i = 0; i < count; ++i) parent[i] = i;
  }
  std::vector<uint32_t> parent;
  uint32_t find(uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
  void unite(uint64_t i, uint64_t j) {
    const uint32_t a = find(uint32_t(i)), b = find(uint32_t(j));
    parent[std::max(a, b)] = std::min(a, b);
  }
};

class Pairs {  // of glued faces
 public:
  explicit Pairs(const VBody& body);
  void see(size_t cell, const VPiece& piece);  // keeps the piece's faces that lie in glued faces
  void check();                                // V3, after all pieces were seen
  uint64_t count() const { return count_; }
  // v_points and v_curves.
  void count_classes(uint64_t* points, uint64_t* curves) const;

 private:
  typedef std::map<std::pair<size_t, size_t>, std::string>
      Maps;  // of the pieces of a face, by their places
  void fail(uint64_t face, const std::string& why);
  void compare(uint64_t face);
  bool have_equal_breaks(uint64_t face) const;

  const VBody& body_;
  std::vector<uint64_t> first_;    // of each face, the lower one of its pair
  std::map<uint64_t, Maps> maps_;  // of faces whose other one is not complete yet
  uint64_t count_ = 0, wrong_ = ~uint64_t(0);
  std::string why_;
};
