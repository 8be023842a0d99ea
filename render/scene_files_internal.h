// SPDX-License-Identifier: LGPL-3.0-or-later
// render/scene_files_internal.h: what the writers of scenes share.
#pragma once
#include <vector>

#include "render/scene.h"
#include "robust/base/result.h"

namespace veritope::internal {

/// with_solid_marks(scene). @error as scene_ply
Result<std::vector<SceneSurface>> solid_surfaces(Scene scene);

}  // namespace veritope::internal
