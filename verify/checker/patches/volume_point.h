// SPDX-License-Identifier: Apache-2.0 OR MIT
// volume_point.h: points of volumes, and maps and determinants there: docs/certificates/volume-folded.md.
#pragma once
#include "star_bytes.h"

struct AxisPoint {     // a parameter of an axis
  size_t span, p;      // its piece is [t(span), t(span + 1)]; the axis's degree
  int64_t n, d;        // where in the piece
  std::vector<Big> t;  // the knots of the piece, in integers, and then their denominator
};
struct VolumePoint {
  AxisPoint axis[3];
};
typedef std::vector<Big> Points;  // homogeneous, in integers; last axis fastest

VolumePoint read_point(const Entity& e, Bytes* bytes);  // B1
// The control points of the box of a point, whose knots are filled in. B2.
Points box_of(const Entity& e, VolumePoint* point);
// The map at the point and its derivatives by the three parameters, homogeneous, each times a positive factor.
std::vector<Points> values_at(Points box, const VolumePoint& point);
// The sign of det J: that of -det(F, F_u, F_v, F_w). REQUIRES these four values.
int sign_of_jacobian(const std::vector<Points>& values);
