// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/chain_picture.h: the cells of the normal chain of a model as a file for viewers.
#pragma once
#include <string>

#include "robust/base/result.h"
#include "solids/classify/point_answer.h"
#include "solids/patches/patch_complex.h"

namespace veritope::cli {

/// A .vtu file with the simplices from the origin that have a volume, and for each patch that is not its base what lies
/// between both. A patch of four sides has two such cells, over its two base triangles. @error as ChainCells
Result<std::string> chain_picture(const PatchComplex& complex, const ExactPoint& origin);

}  // namespace veritope::cli
