// SPDX-License-Identifier: LGPL-3.0-or-later
// render/picture_room_internal.h: the room of a picture without captions.
#pragma once
#include <algorithm>

#include "render/draw_scene.h"
#include "render/scene_camera_internal.h"

namespace veritope::internal {

/// In pixels: all but a margin of 1/32 of the shorter side.
inline PictureBox picture_room(const PictureOptions& options) {
  const auto width = static_cast<double>(options.width),
             height = static_cast<double>(options.height);
  const double margin = std::min(width, height) / 32;
  return {margin, margin, width - margin, height - margin};
}

}  // namespace veritope::internal
