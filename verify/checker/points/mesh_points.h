// SPDX-License-Identifier: Apache-2.0 OR MIT
// mesh_points.h: points and the triangles of a mesh; docs/certificates/points.md, section 4.
#pragma once
#include "../mesh/geometry.h"
#include "coordinate.h"

struct Point {
  int64_t below[3], above[3];  // as Coordinate has them
  bool is_binary64 = true;
  Lattice lattice;  // has the model's coordinates, and the point's if it is binary64
  Integer x[3], w;  // if it is not binary64: x / w, w > 0, in units of the lattice

  Point(const Coordinate* coordinates, const Lattice& model);
  bool is_in_box(const int64_t* min, const int64_t* max) const {
    bool is_in = true;
    for (int k = 0; k < 3; ++k) is_in = is_in && min[k] <= below[k] && above[k] <= max[k];
    return is_in;
  }
};

class MeshPoints {
 public:
  explicit MeshPoints(const Model& model);  // which must outlive this

  const Model& model() const { return model_; }
  const Lattice& lattice() const { return lattice_; }
  const TreeNode& box() const { return tree_.nodes[0]; }  // of all triangles
  bool is_closed() const;                                 // P1
  bool is_on(const Point& q, uint32_t face) const;        // P2

  struct Winding {
    bool is_on;   // P3 fails
    int64_t sum;  // of P4, if the point is on no triangle
  };
  // Adds the units of section 5. If only they matter there is no answer.
  Winding winding(const Point& q, int direction, bool units_matter_only, Work* work) const;
  // The winding numbers of classes of triangles, those that are not 0; of_face: the class of each triangle. If the
  // point is on a triangle, *is_on becomes true and no class is named. Adds the same units.
  std::map<uint32_t, int64_t> windings(const Point& q, int direction,
                                       const std::vector<uint32_t>& of_face, Work* work,
                                       bool* is_on) const;
  // All triangles on which the point lies. Adds a unit for each triangle whose box holds it.
  std::vector<uint32_t> triangles_at(const Point& q, Work* work) const;

 private:
  template <class Visit>
  void search(const Range& r, const Point& q, int direction, const Visit& visit) const;
  template <class Visit>
  void search_boxes(const Range& r, const Point& q, const Visit& visit) const;
  int ask_of(uint32_t place, const Point& q, int direction, bool may_contain,
             bool may_be_stabbed) const;
  const int64_t* key(uint32_t v) const { return &model_.key[3 * size_t(v)]; }

  const Model& model_;
  const Lattice lattice_;
  const Tree tree_;
};
