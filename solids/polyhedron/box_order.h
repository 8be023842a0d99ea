// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/polyhedron/box_order.h: orders of the facets in which neighbours in space are neighbours in the list.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/box3d.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope {

/// The least box of some points; empty_box() of none.
Box3d bounding_box(std::span<const Vec3d> points, unsigned jobs);
/// The box of the vertices that faces have: a stray vertex that no face has would spoil every scale. REQUIRES at least
/// one face.
Box3d bounding_box_of_faces(const TriangleMesh& mesh, unsigned jobs);

/// A monotone map of coordinates to [0, 1] floats: x <= y implies map(x) <= map(y), because subtraction, scaling by a
/// power of two and conversion are rounded monotonically. So boxes that overlap still do after it; no outward rounding
/// is needed.
class UnitScale {
 public:
  /// The scale for points in a box. REQUIRES a finite box that is not empty.
  explicit UnitScale(const Box3d& box);
  float x(double v) const { return static_cast<float>((v * pre_ - low_[0]) * scale_); }
  float y(double v) const { return static_cast<float>((v * pre_ - low_[1]) * scale_); }
  float z(double v) const { return static_cast<float>((v * pre_ - low_[2]) * scale_); }

 private:
  double pre_ = 1;  // brings huge and tiny models into range; a power of two
  double low_[3] = {0, 0, 0};
  double scale_ = 1;
};

/// The facets along a Morton curve through the centres of their boxes (2048^3 cells), ties by facet number. The result
/// does not depend on jobs. REQUIRES fewer than 2^32 facets. @cost O(F).
std::vector<std::uint32_t> morton_order(const TriangleMesh& mesh,
                                        const std::vector<std::uint32_t>& facets,
                                        const UnitScale& scale, unsigned jobs);

/// The facets in the leaf order of a balanced tree whose nodes are halved at the median centre along their longest
/// axis, large fans (64 facets at one vertex) apart from the rest: dearer than morton_order, but long thin facets stay
/// beside their neighbours. @cost O(F log F).
std::vector<std::uint32_t> median_order(const TriangleMesh& mesh,
                                        const std::vector<std::uint32_t>& facets, unsigned jobs);

}  // namespace veritope
