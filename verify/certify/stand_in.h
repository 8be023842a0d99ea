// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/stand_in.h: what certificates speak of where they cannot speak of a spline file itself: a .vjson model
// with its surfaces and triangles, or with the boundary faces of its volumes.
#pragma once
#include <optional>
#include <string>

#include "io/splines/read_splines.h"
#include "robust/base/result.h"

namespace veritope {

struct StandIn {
  std::string bytes;  ///< of a .vjson file
  SplineFile file;    ///< these bytes, read
  std::string what;   ///< "its 7 surfaces", "the 24 boundary faces of its 7 volumes"
  bool is_of_volumes = false;
};

/// Nothing for a file of a format that the checkers read, unless it has volumes; and nothing where there is no such
/// model: entities that are not in space, or that are neither surfaces, triangles nor volumes; volumes beside others; a
/// file from which shapes were left out.
/// @error as volume_faces, with the entity
Result<std::optional<StandIn>> stand_in_of(const SplineFile& file);

/// Why certificates cannot speak of the file or of a stand-in for it, in words that say what the file holds, and what
/// helps if something does. Nothing if they can.
std::optional<std::string> uncovered_shapes(const SplineFile& file);

}  // namespace veritope
