// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms.h: what the parts of dms-solid-1 share. The pages: docs/certificates/dms-solid.md and docs/formats/dms-files.md.
#pragma once
#include <array>
#include <unordered_map>

#include "../patches/star_bytes.h"
#include "dms_number.h"

const uint64_t kMostDmsItems = 1 << 24;
const int kMostDmsDegree = 9, kMostProvedDegree = 6;

// All lists of four (or three) natural numbers with this sum, the first one falling, then the second, ...
typedef std::array<int, 4> DmsIndex;
std::vector<DmsIndex> dms_indices(int sum);
inline size_t dms_place(const DmsIndex& i, int sum) {  // in that list
  const int a = sum - i[0], b = a - i[1];
  return size_t(a * (a + 1) * (a + 2) / 6 + b * (b + 1) / 2 + i[3]);
}
inline DmsIndex dms_raised(DmsIndex i, size_t m) {
  ++i[m];
  return i;
}

struct DmsFile {
  int n = 0;
  bool is_separate = false;
  std::vector<Ratio> knots;                   // three coordinates each
  std::vector<std::vector<uint32_t>> clouds;  // numbers of n + 1 knots each
  std::vector<std::array<uint32_t, 4>> tetrahedra;
  std::vector<Ratio> values;      // x, y, z of the control points
  std::vector<uint32_t> control;  // of each tetrahedron and each place of a beta: the control point

  int sum() const { return is_separate ? n : n - 1; }  // N of the page
  size_t controls() const { return values.size() / 3; }
  size_t of_each() const { return size_t((n + 1) * (n + 2) * (n + 3) / 6); }
  const Ratio* value(size_t tetrahedron, const DmsIndex& beta) const {
    return &values[3 * control[tetrahedron * of_each() + dms_place(beta, n)]];
  }
};
DmsFile read_dms(const std::string& text);  // or throws Refused

struct DmsLeaf {
  bool is_polynomial;
  std::vector<Ratio> r;
  std::vector<Ratio> planes;  // four numbers each
};
struct DmsTree {
  std::vector<uint8_t> symbols;  // preorder
  std::vector<Ratio> cuts;       // of the symbols 6 to 11
  std::vector<DmsLeaf> leaves;
};
struct DmsTile {
  uint64_t corner[3];
  std::vector<Ratio> planes;
};
struct DmsBlock {  // the convex hull of some tetrahedra
  std::vector<uint64_t> tetrahedra;
  std::vector<Ratio> r;
  std::vector<Ratio> planes;  // four numbers each
};
struct DmsPair {  // of faces of the boundary, by their numbers
  enum Kind { kApart, kChain, kAtEdge };
  uint64_t face[2];
  Kind kind;
  std::vector<uint64_t> chain, tetrahedra;  // of vertices; with the edges between them
  std::vector<Ratio> feet;                  // two, of kAtEdge
  std::vector<Ratio> directions;            // three numbers each
};
struct DmsBody {
  uint64_t faces = 0;
  std::vector<DmsTree> trees;
  std::vector<std::vector<Ratio>> planes;  // of each face of the boundary
  Body domain = {nullptr, nullptr};
  // Parts of dms-solid-1.
  std::vector<Ratio> added;  // three coordinates each
  std::vector<std::vector<DmsTile>> tiles;
  Body surface = {nullptr, nullptr};
  // Parts of dms-solid-2.
  std::vector<DmsBlock> blocks;
  std::vector<DmsPair> pairs;
};
DmsBody read_dms_body(const DmsFile& file, const Body& body);    // B1 but F, B2
DmsBody read_dms_body_2(const DmsFile& file, const Body& body);  // the same of dms-solid-2

struct DmsFace {  // of the boundary
  std::array<uint32_t, 3> vertex;
  size_t tetrahedron;
  int number;  // of the tetrahedron's faces
};

struct DmsBoxes;
// The file with points that are known to be equal or not.
struct DmsModel {
  explicit DmsModel(const DmsFile& file);

  const DmsFile& file;
  std::vector<DmsPoint> points;               // all different
  std::vector<std::vector<uint32_t>> clouds;  // numbers of points
  std::vector<DmsFace> faces;                 // of the boundary; by find_dms_boundary
  std::vector<DmsIndex> gammas;               // of the sum n - 1

  uint32_t knot(size_t tetrahedron, size_t corner, int i) const {
    return clouds[file.tetrahedra[tetrahedron][corner]][size_t(i)];
  }
  const DmsPoint& place(uint32_t vertex) const { return points[clouds[vertex][0]]; }
  const DmsPoint& corner(size_t tetrahedron, size_t c) const {
    return points[knot(tetrahedron, c, 0)];
  }
};
// The work that is allowed: of the file's and the body's bytes.
inline Units dms_units(uint64_t bytes) { return Units{0, (1 << 24) + (bytes << 8), "E3"}; }
// Four corners: face m is opposite to corner m, and seen from outside.
extern const int kDmsFace[4][3];

struct DmsNumbers {
  uint64_t shells, bodies, genus;
};
// D3 or T3: triangles of this degree, with these points, three coordinates each.
DmsNumbers check_dms_boxes(const std::vector<std::vector<Ratio>>& triangles, int degree,
                           const Body& part, uint64_t file_bytes, const char* id);

// A face that occurs twice in one order is in the boundary twice.
void find_dms_boundary(DmsModel* model);
void check_dms_domain(const DmsModel& model);  // D1, D2
// D3.
DmsNumbers check_dms_boundary(const DmsModel& model, const Body& part, uint64_t file_bytes);
// E1 to E3. planes: the lists of the faces of the boundary.
void check_dms_clouds(const DmsModel& model, const std::vector<std::vector<Ratio>>& planes,
                      Units* units);
// J1 to J3.
void check_dms_jacobian(const DmsModel& model, const DmsBody& body, Units* units);
// T1 to T3.
DmsNumbers check_dms_surface(const DmsModel& model, const DmsBody& body, uint64_t file_bytes,
                             Units* units);
// U1 to U7.
void check_dms_pairs(const DmsModel& model, const DmsBody& body, const DmsNumbers& of_domain,
                     Units* units);
