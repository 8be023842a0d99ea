// SPDX-License-Identifier: LGPL-3.0-or-later
// render/picture_bands_internal.h: a flat scene as pixels, one band of rows after the other, so that the samples of few
// rows are in memory at once.
#pragma once
#include <cstdint>

#include "render/flat_scene_internal.h"
#include "render/image.h"

namespace veritope::internal {

inline constexpr std::size_t kMostPictureSide = 8192;

/// How many samples are drawn, approximately: those under several triangles or marks count for each.
double num_drawn_samples(const FlatScene& scene);

/// Draws the scene on the image's background, with outlines around surfaces or without. The pixels do not depend on the
/// number of threads. REQUIRES coordinates in the image, at most kMostPictureSide rows and columns of one colour.
void draw_bands(const FlatScene& scene, bool with_outlines, unsigned jobs, Image* image);

}  // namespace veritope::internal
