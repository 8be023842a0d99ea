// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/plane_classification.h: classify for regions of the plane, which closed loops of curves bound.
#pragma once
#include "cli/classification.h"
#include "cli/point_source.h"
#include "io/model_file.h"
#include "report/classify_report.h"
#include "solids/chain/plane_region.h"

namespace veritope::cli {

/// Whether a file holds curves with two coordinates, and nothing else.
bool is_plane_model(const ModelFile& file);

/// @error kBadArgument with the entity if the loops are not closed. REQUIRES is_plane_model(file).
Result<PlaneRegion> plane_region_of(const ModelFile& file);

/// Answers all points of the source, which have two coordinates.
/// @param is_winding  words of points off the curves are not given
/// @error  as PointSource and WriteAnswers
Status classify_points(const PlaneRegion& region, PointSource& source, unsigned jobs,
                       bool is_winding, const WriteAnswers& write, report::ClassifyReport& report);

}  // namespace veritope::cli
