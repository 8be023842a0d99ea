// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/volumes.h: the volumes of a file that has nothing else, the cells of a V-model.
#pragma once
#include <vector>

#include "io/splines/read_splines.h"
#include "robust/base/result.h"

namespace veritope {

/// The volumes of the file in their order, with clamped axes, which are restricted to their domains.
/// @error kBadArgument: an entity that is not a volume (named), shapes of the file that were left out; kEmpty without
///        an entity
Result<std::vector<ExactVolume>> volumes_of(const SplineFile& file);

/// Whether volumes of the model have attributes: coordinates from the fourth on.
bool has_attributes(const SplineModel& model);
/// The model with the first three coordinates of its volumes with attributes.
SplineModel without_attributes(const SplineModel& model);

}  // namespace veritope
