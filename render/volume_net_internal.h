// SPDX-License-Identifier: LGPL-3.0-or-later
// render/volume_net_internal.h: the control net of a cell.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "io/splines/spline_model.h"
#include "robust/base/box3d.h"

namespace veritope::internal {

/// The control points in the order of the volume, divided by their weights, each coordinate rounded to nearest.
/// REQUIRES a volume in space.
std::vector<Point3d> rounded_net(const ExactVolume& volume);

/// The pairs of control points that are neighbours along an axis: first those along u, then v, then w.
std::vector<std::array<std::uint32_t, 2>> net_lines(const ExactVolume& volume);

}  // namespace veritope::internal
