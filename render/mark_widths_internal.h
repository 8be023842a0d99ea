// SPDX-License-Identifier: LGPL-3.0-or-later
// render/mark_widths_internal.h: marks that others would hide become wide enough to be seen around them.
#pragma once
#include <cstddef>

#include "render/flat_scene_internal.h"

namespace veritope::internal {

/// Widens marks of layers from 1 on, from the highest layer down: those of which marks of other colours in higher
/// layers hide more than half and leave fewer than 144 pixels (markers that lie on top of each other become rings), if
/// that helps and the layer has at most 2,000 marks; and a mark of each colour that would cover fewer than 144 pixels
/// in all. A mark's radius grows to at most 64 pixels.
/// REQUIRES marks by layer, as flatten gives them. @cost O(pixels + pixels under marks)
void widen_hidden_marks(std::size_t width, std::size_t height, FlatScene* scene);

}  // namespace veritope::internal
