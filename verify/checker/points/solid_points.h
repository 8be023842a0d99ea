// SPDX-License-Identifier: Apache-2.0 OR MIT
// solid_points.h: one solid of an expression, a mesh or patches; docs/certificates/points.md, section 7.
#pragma once
#include "cone.h"
#include "expression.h"
#include "mesh_points.h"
#include "patch_points.h"

// A point of the answers, in each form that is needed.
class AnsweredPoint {
 public:
  AnsweredPoint(const Answer& answer, bool nearest, const std::string& line) : where(line) {
    read_point(answer, nearest, coordinates_);
  }
  const Coordinate* coordinates() const { return coordinates_; }
  const RationalPoint& exact() const {
    if (exact_ == nullptr) exact_.reset(new RationalPoint(rational_point(coordinates_)));
    return *exact_;
  }
  // -1, 0, 1: coordinate k is less than x, equal, greater.
  int compare_with(int k, const Ratio& x) const {
    return compare(exact().n[k] * x.d, x.n * exact().d);
  }
  const std::string where;  // for messages

 private:
  Coordinate coordinates_[3];
  mutable std::unique_ptr<const RationalPoint> exact_;
};

struct SolidWork {
  Work triangles;
  PointUnits patches;
};

class SolidPoints {
 public:
  // Reads the solid and its part of the body, and tests B1, B2 and P1.
  SolidPoints(const Expression::Solid& solid, bool as_indexed, uint64_t body_size, Bytes* bytes);

  const Bounds3& box() const { return box_; }  // of all triangles, or of all control points
  uint64_t num_faces() const { return mesh_ != nullptr ? model_->faces() : 0; }
  bool box_holds(const AnsweredPoint& q) const;
  // Tests P2 of the place that it reads.
  PlaceOnPatch read_on(const AnsweredPoint& q, Bytes* bytes, SolidWork* work) const;
  // P3 and P4.
  void check_off(const AnsweredPoint& q, int direction, int64_t f, SolidWork* work) const;
  // The walls at a point of the boundary; false if they are not all flat. place: of a mesh unused.
  bool find_cone(const AnsweredPoint& q, const PlaceOnPatch& place, SolidWork* work,
                 Cone* cone) const;

 private:
  std::vector<BigVec> corners(const AnsweredPoint& q, uint32_t face) const;

  // One of the two.
  std::unique_ptr<const Model> model_;
  std::unique_ptr<const MeshPoints> mesh_;
  std::unique_ptr<PatchSurface> surface_;
  Bounds3 box_;
};
