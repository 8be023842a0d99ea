// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/draw_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "render/mark_widths_internal.h"
#include "render/picture_bands_internal.h"
#include "render/picture_caption_internal.h"

namespace veritope {

Status check_picture_options(const PictureOptions& options) {
  constexpr std::size_t kLeast = 64;
  for (const std::size_t side : {options.width, options.height})
    if (side < kLeast || side > internal::kMostPictureSide)
      return bad_argument("a picture has 64 to 8192 pixels a side, not " + std::to_string(side));
  bool is_zero = true;
  for (const double x : options.view) {
    if (!std::isfinite(x)) return bad_argument("the direction of view is not finite");
    if (x != 0) is_zero = false;
  }
  if (is_zero) return bad_argument("the direction of view is 0");
  return ok_status();
}

namespace {

Status check_scene_size(const Scene& scene) {
  std::size_t points = 0, triangles = 0, marks = scene.markers.size();
  for (const SceneSurface& s : scene.surfaces)
    points += s.points.size(), triangles += s.triangles.size();
  for (const SceneLine& line : scene.lines) marks += line.points.size();
  if (triangles + marks == 0) return Error{Code::kEmpty, {}, "there is nothing to draw"};
  if (std::max({points, triangles, marks}) >= std::numeric_limits<std::uint32_t>::max())
    return Error{Code::kOverLimit, {}, "a picture has fewer than 2^32 points, triangles and marks"};
  return ok_status();
}

// Six minutes of one processor, approximately.
constexpr double kMostSamples = 0x1p33;

}  // namespace

Result<Image> draw_scene(const Scene& scene, const PictureOptions& options) {
  if (Status status = check_picture_options(options); !status) return status.error();
  if (Status status = check_scene_size(scene); !status) return status.error();
  const internal::CaptionLayout captions(scene, options.width, options.height);
  internal::FlatScene flat = internal::flatten(scene, options.view, captions.room());
  internal::widen_hidden_marks(options.width, options.height, &flat);
  if (internal::num_drawn_samples(flat) > kMostSamples)
    return Error{
        Code::kOverLimit, {}, "too much lies on top of each other; a smaller picture may do"};
  constexpr Colour kBackground{255, 255, 255};
  Image image(options.width, options.height, kBackground);
  internal::draw_bands(flat, options.has_outlines, options.jobs, &image);
  captions.draw(&image);
  return image;
}

}  // namespace veritope
