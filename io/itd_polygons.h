// SPDX-License-Identifier: LGPL-3.0-or-later
// io/itd_polygons.h: the polygons of IRIT's .itd as the mesh that they are.
// The rule: docs/formats/spline-files.md.
#pragma once
#include "io/base/read_limits.h"
#include "io/base/source.h"
#include "io/mesh/read_mesh.h"
#include "io/splines/read_splines.h"
#include "robust/base/result.h"

namespace veritope {

/// Whether the file has polygons, and no other shape but polylines and point lists, which bound nothing.
bool holds_only_polygons(const SplineFile& file);

/// The mesh of the polygons, and an OFF file with the same polygons (MeshFile::copy), from which it was read. Neither
/// sha256 nor the seconds are set. REQUIRES that read_splines reads the source, and holds_only_polygons(splines).
/// @error kSyntax, kTruncated, kNotFinite, kOverLimit, with the line
Result<MeshFile> read_itd_polygons(const Source& source, const SplineFile& splines,
                                   const ReadLimits& limits);

}  // namespace veritope
