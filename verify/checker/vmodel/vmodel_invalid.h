// SPDX-License-Identifier: Apache-2.0 OR MIT
// vmodel_invalid.h: what the parts of vmodel-invalid-1 share. The page: docs/certificates/vmodel-invalid.md.
#pragma once
#include "../patches/volume_point.h"
#include "vmodel.h"

struct CellPoint {
  uint64_t cell;
  VolumePoint at;
};
struct CellInterval {  // from a / 2^e to b / 2^e of span k of an axis
  uint64_t k, a, b;
  int e;
};
struct CellArc {
  uint64_t cell;
  unsigned face, side;
  CellInterval t;
};
struct Finding {  // of a body; the fields of other kinds are not used
  uint64_t kind, cell, spans[3], corner;
  CellPoint a, b;
  bool b_is_box;
  uint64_t box_cell;
  CellInterval box[3];
  Big y[3][3];
  CellArc arcs[3];
};
struct InvalidModel {
  std::vector<Entity> volumes;
  Units units;
};

std::vector<Ratio> different_knots(const Entity& e, size_t axis);
VCell cell_of(
    const Entity&
        e);  // its breaks are its different knots; faces and edges as find_collapses() says
// The part of the axis, as breaks.
std::vector<Ratio> ends_of(const Entity& e, size_t axis, const CellInterval& t);

void check_overlap(const Finding& f, const Points& box_of_a, const Points& box_of_b,
                   InvalidModel* model);                   // O1 to O4
void check_curve(const Finding& f, InvalidModel* model);   // C1 to C3, V1
void check_corner(const Finding& f, InvalidModel* model);  // V1, P1, P2

struct SpacePoint {  // in coordinates
  Ratio x[3];
};
SpacePoint corner_point(const Entity& e, size_t corner);
int compare(const SpacePoint& a, const SpacePoint& b);
// V1 for each cell that is near the point.
void check_cells_near(const SpacePoint& x, InvalidModel* model);

class PointNumbers {  // different points have different numbers
 public:
  explicit PointNumbers(std::vector<SpacePoint> points);
  size_t operator[](const SpacePoint& p) const;  // kNone for another point
  static const size_t kNone = ~size_t(0);

 private:
  std::vector<SpacePoint> points_;
};
struct CellFace {
  const VCell* cell;
  size_t number;          // 0 to 5
  const size_t* corners;  // numbers of the points at the cell's eight corners
};
// Whether the faces have equal corners under a symmetry. Their cells are not used.
bool may_be_equal(const CellFace& f, const CellFace& g);
// The lowest symmetry under which the faces are equal, or -1. REQUIRES that neither is collapsed.
int equal_under(const CellFace& f, const CellFace& g, Units* units);
