// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_boxes.h: which boxes may meet a box, and planes that keep knots away from a leaf, a tile or a tetrahedron.
#pragma once
#include "dms.h"

struct DmsBox {  // a closed one, rounded outward; at first empty
  double lo[3], hi[3];

  DmsBox();
  explicit DmsBox(const std::vector<const DmsPoint*>& points);
  void add(const DmsPoint& p);
  void add(const DmsBox& b);
  bool may_meet(const DmsBox& b) const {
    for (int k = 0; k < 3; ++k)
      if (hi[k] < b.lo[k] || b.hi[k] < lo[k]) return false;
    return true;
  }
};
struct DmsBoxes {  // a binary tree over boxes
  explicit DmsBoxes(const std::vector<DmsBox>& boxes);
  // The numbers, in ascending order, of all boxes that may meet this one.
  std::vector<uint32_t> near(const DmsBox& b) const;

 private:
  struct Node {
    DmsBox box;
    uint32_t first, last;  // in `order`
    uint32_t child;        // the first of two, or 0
  };
  void split(size_t node);

  const std::vector<DmsBox>& boxes;
  std::vector<uint32_t> order;
  std::vector<Node> nodes;
};

// Bits, one for each way to have all knots on one closed side of a plane and the corners of a simplex on the other one.
struct DmsMask {
  uint64_t first = 0;
  std::vector<uint64_t> more;

  bool any() const {
    if (first != 0) return true;
    for (uint64_t w : more)
      if (w != 0) return true;
    return false;
  }
  DmsMask& operator&=(const DmsMask& m) {
    first &= m.first;
    for (size_t i = 0; i < more.size(); ++i) more[i] &= m.more[i];
    return *this;
  }
};
// The boxes of the tetrahedra of knots 0.
std::vector<DmsBox> dms_boxes_of_corners(const DmsModel& model);
// Adds the planes of the faces of a tetrahedron: if d > 0, it lies on their
// sides <= 0.
void add_dms_faces(const DmsPoint* const* corners, std::vector<DmsPlane>* planes);

const uint64_t kDmsAxes = 63;  // the bits of planes across axes

struct DmsSides {
  // is_strict: not all corners may lie in the plane.
  DmsSides(std::vector<const DmsPoint*> corners, const std::vector<DmsPlane>& planes,
           bool is_strict);
  DmsMask all() const;                                         // the mask of no knots
  const DmsMask& mask(const DmsModel& model, uint32_t point);  // kept
  // Whether the plane through three knots has all corners on one closed side.
  bool is_beside(const DmsPlane& plane) const;

 private:
  // Bit 0: all corners lie on its side >= 0; bit 1: on its side <= 0; and not all in it, if that is asked for.
  int sides_of(const DmsPlane& plane) const;

  std::vector<const DmsPoint*> corners;
  const bool is_strict;
  const DmsPoint *least[3], *most[3];
  bool is_flat[3];  // and is_strict
  std::vector<std::pair<DmsPlane, int>>
      halves;  // a plane; the side, 1 or -1, on which knots may lie
  std::unordered_map<uint32_t, DmsMask> known;
};
