// SPDX-License-Identifier: Apache-2.0 OR MIT
// dms_invalid.h: what the parts of dms-invalid-1 share. The page: docs/certificates/dms-invalid.md.
#pragma once
#include "../patches/invalid.h"
#include "dms_near.h"

enum DmsKind {
  kTetReversed,
  kTetFaceOverused,
  kCloudDegenerate,
  kCloudNoCore,
  kCloudInside,
  kNegativeJacobian,
  kZeroJacobian,
  kEdgeOverused,
  kSeveralFans,
  kFacesMeet,
  kTetrahedraMeet,
  kImagesMeet,
  kImagesCross,
  kImageCovers
};
struct DmsNamedFace {
  size_t tetrahedron;
  int number;
};
struct DmsFinding {  // of a body; the fields of other kinds are empty
  unsigned kind = 0;
  std::vector<size_t> tetrahedra;
  std::vector<DmsNamedFace> faces;
  std::vector<uint64_t> vertices;
  std::vector<DmsIndex> indices;
  std::vector<size_t> replaced;            // kind 3: the m of each index
  std::vector<Ratio> numbers;              // rationals, in the order of the body
  std::vector<std::vector<Ratio>> planes;  // lists of a leaf or of pieces
  Crossing crossing = Crossing();
  std::vector<std::vector<Ratio>> boundary;  // lists of planes of the faces of the boundary

  bool needs_map() const {
    return kind == kNegativeJacobian || kind == kZeroJacobian || kind >= kImagesMeet;
  }
  DmsPoint point(size_t i) const { return DmsPoint::of(&numbers[3 * i]); }  // in kinds of points
};
DmsFinding read_dms_finding(const DmsModel& model, const Body& body);  // B1, B2

// The place of a face in the boundary, or the number of its faces.
size_t place_in_boundary(const DmsModel& model, const DmsNamedFace& face);
// Whether u lies inside of the tetrahedron of knots 0, strictly or not. REQUIRES d > 0.
bool is_in_tetrahedron(const DmsModel& model, size_t tetrahedron, const DmsPoint& u, bool strictly);
bool have_equal_vertices(const DmsFace& f, const DmsFace& g);
// The mean of points with these weights; rejects by the id unless they are >= 0, with a sum > 0.
DmsPoint dms_mean(const std::vector<const DmsPoint*>& points, const Ratio* weights, const char* id);
int sign_of_d(const DmsPoint* const* w);

void check_dms_tetrahedra(const DmsModel& model, const DmsFinding& f);         // W0 to W4, W10
void check_dms_surface_of_domain(const DmsModel& model, const DmsFinding& f);  // W7 to W9
void check_dms_map(const DmsModel& model, const DmsFinding& f, Units* units);  // W5, W6, W11, W13
void check_dms_crossing(const DmsModel& model, const DmsFinding& f, Units* units);  // W12
