// SPDX-License-Identifier: LGPL-3.0-or-later
// models/refined_patches.h: the same surface from other patches.
#pragma once
#include "models/patch_shapes.h"

namespace veritope::patch_shapes {

/// Each patch in four, cut at the middles of its sides: mates remain mates.
Patches quartered(const Patches& patches);
/// All degrees raised by one.
Patches elevated(const Patches& patches);
/// Each patch with another corner as its first.
Patches turned(const Patches& patches);

}  // namespace veritope::patch_shapes
