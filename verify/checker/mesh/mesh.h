// SPDX-License-Identifier: Apache-2.0 OR MIT
// mesh.h: what the mesh claims compute from a model without exact arithmetic, and nesting.
#pragma once
#include "../common/checker.h"

struct Model {
  std::vector<int64_t> key;   // three coordinates a vertex, as keys (numbers.h)
  std::vector<uint32_t> tri;  // three vertex ids a triangle; at most 2^30 triangles
  uint32_t vertices() const { return uint32_t(key.size() / 3); }
  uint32_t faces() const { return uint32_t(tri.size() / 3); }
};
Model read_model(std::string file, const std::string& format, bool as_indexed);

struct Work {  // what section 5 of mesh.md counts and bounds; units: 1000 (F + size of the body)
  uint64_t done, limit;
  const char* id = "B1";
  Work(const Model& model, const Body& body)
      : done(0), limit(1000 * (model.faces() + body.left())) {}
  explicit Work(uint64_t most, const char* condition = "B1")
      : done(0), limit(most), id(condition) {}
  void add(uint64_t units) {
    done += units;
    require(done <= limit, id, "more work than allowed, units", limit);
  }
};

const uint32_t kNone = 0xffffffff;  // no id: there are fewer vertices, triangles and edges

Model read_triangles(std::string file, const std::string& format);  // not yet merged

// Shells and neighbours. Edge 3 f + i goes from corner i of triangle f to the next corner.
struct Surface {
  explicit Surface(const Model& model);
  // If V4 holds: the next edge that starts where e does; it belongs to the neighbour triangle.
  uint32_t around(uint32_t e) const { return twin[e % 3 == 0 ? e + 2 : e - 1]; }

  std::vector<uint32_t> shell;              // for each triangle; triangles with a common edge agree
  std::vector<uint32_t> twin;               // for each edge, if V4 holds
  std::vector<uint32_t> first;              // if V4 holds: an edge from each vertex, or kNone
  uint32_t shells = 0, vertices = 0;        // vertices: the referenced ones, if V4 holds
  uint64_t edges = 0;                       // undirected ones
  uint32_t bad[3] = {kNone, kNone, kNone};  // a vertex where V4, V5, V6 fails
};

// The box tree of section 5.
struct TreeNode {
  int64_t min[3], max[3];  // the box, as keys
  uint32_t common[3];      // the star vertices of all its triangles, then kNone
  bool has(uint32_t v) const {
    return v != kNone && (v == common[0] || v == common[1] || v == common[2]);
  }
};
struct Range {  // the number of a node in preorder, and its positions [lo, hi)
  uint32_t node, lo, hi;
  uint32_t size() const { return hi - lo; }
  Range left() const { return Range{node + 1, lo, lo + size() / 2}; }
  Range right() const { return Range{node + 2 * (size() / 2), lo + size() / 2, hi}; }
};
struct Tree {
  Tree(const Model& model, const std::vector<uint32_t>& order, const std::vector<uint8_t>& star);
  Range root() const { return Range{0, 0, uint32_t(order.size())}; }

  std::vector<uint32_t> order, corners;  // triangles by position, and their vertices
  std::vector<TreeNode> nodes;

 private:
  void build(const Range& r, const Model& model, const std::vector<uint8_t>& star);
};

// V10, and the quantities of section 6. codes: one a shell, or none if there is only one shell.
struct Nesting {
  uint64_t bodies;
  std::string volume;
  std::vector<uint64_t> depth;  // of each shell
};
Nesting check_nesting(const Model& model, const Surface& surface, const Tree& tree,
                      const std::vector<uint8_t>& codes, Work work);
