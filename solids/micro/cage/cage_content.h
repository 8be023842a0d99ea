// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/cage_content.h: what a cage has to contain: the convex hulls of the parts of a model.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/result.h"
#include "solids/patches/patch.h"
#include "solids/polyhedron/triangle_mesh.h"
#include "solids/volumes/axis_turn.h"
#include "solids/volumes/cell_maps.h"

namespace veritope {

/// Each part of the model lies in the convex hull of its corners, so that what contains the hulls contains the model.
/// Points are different; parts with a common point belong together.
struct CageContent {
  std::vector<CellPoint> points;       ///< each is a corner of some part
  std::vector<std::uint32_t> corners;  ///< numbers of points, part after part
  std::vector<std::size_t> ends;       ///< where the corners of each part end

  std::size_t num_parts() const { return ends.size(); }
  std::span<const std::uint32_t> part(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends[i - 1];
    return std::span(corners).subspan(begin, ends[i] - begin);
  }
};

/// The parts are the triangles.
CageContent content_of(const TriangleMesh& mesh);
/// Tensor patches are cut into 2^rounds by 2^rounds parts; triangles stay as they are for rounds <= 2, and are cut as
/// tensor patches with a collapsed side for more. The corners are the control points.
/// REQUIRES positive weights, 0 <= rounds < 16.
CageContent content_of(std::span<const Patch> patches, int rounds = 2);
/// How many parts a patch has there.
std::size_t num_content_parts(const Patch& patch, int rounds = 2);

/// A box with sides along the axes.
struct CageBox {
  CellPoint min, max;
};
/// The smallest box that contains all hulls, exactly. REQUIRES a part.
CageBox box_of(const CageContent& content);

/// `part` times the diagonal of the box, rounded up by at most one 1024th. REQUIRES part >= 0.
Rational margin_length(const CageBox& box, const Rational& part);

/// The box, grown by this length on all sides.
CageBox grown(const CageBox& box, const Rational& length);

}  // namespace veritope
