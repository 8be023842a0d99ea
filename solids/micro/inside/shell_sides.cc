// SPDX-License-Identifier: LGPL-3.0-or-later
// I2: one point of each shell of a microstructure is in the interior of the solid.
#include <algorithm>
#include <string>

#include "interval/upward.h"
#include "robust/base/parallel.h"
#include "solids/micro/inside/inside_parts_internal.h"

namespace veritope::internal {

namespace {

constexpr std::size_t kShellChunk = 256;

class ShellSides {
 public:
  explicit ShellSides(const InsideParts& parts) : parts_(parts) {}

  // The winding number around S(0, 0); 0 if it is not known.
  std::int64_t winding(const CellPatch& at) const {
    const TilePoint x = point(at);
    const Value3 value = parts_.solid.value(image_box(at, x));
    if (is_constant(value)) return value == Value3::kOne ? 1 : 0;
    const PointAnswer answer = parts_.solid.classify(parts_.volumes[grid(at).volume].image(x));
    return answer.is_decided ? answer.winding : 0;
  }

 private:
  const MicroGrid& grid(const CellPatch& at) const { return parts_.micro.grids[at.grid]; }
  // In the parameters of the volume.
  TilePoint point(const CellPatch& at) const {
    const auto cell = grid(at).shape().index_of(at.cell);
    TilePoint x = parts_.exact_points(at).front();
    for (std::size_t a = 0; a < 3; ++a) {
      const auto& breaks = grid(at).breaks[a];
      x[a] = breaks[cell[a]] + (breaks[cell[a] + 1] - breaks[cell[a]]) * x[a];
    }
    return x;
  }
  Box3d image_box(const CellPatch& at, const TilePoint& x) const {
    const VolumeMaps& maps = parts_.volumes[grid(at).volume];
    std::array<std::size_t, 3> spans{};
    const ScopedUpward upward;
    Box3 in_span;
    for (std::size_t a = 0; a < 3; ++a) {
      const SpanPart part = span_part(maps.knots(a), x[a], x[a]);
      spans[a] = part.span;
      in_span[a] = part.lo_bound;
    }
    const Box3 image = maps.net(spans).value(in_span);
    return {{image[0].lo(), image[1].lo(), image[2].lo()},
            {image[0].hi(), image[1].hi(), image[2].hi()}};
  }

  const InsideParts& parts_;
};

}  // namespace

std::optional<InsideDefect> shell_defect(const InsideParts& parts,
                                         const std::vector<CellPatch>& first_patches) {
  const ShellSides sides(parts);
  const std::size_t n = first_patches.size();
  std::vector<std::size_t> bad(num_chunks(n, kShellChunk), n);
  parallel_for(n, kShellChunk, parts.jobs,
               [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                 for (std::size_t i = begin; i < end && bad[chunk] == n; ++i)
                   if (sides.winding(first_patches[i]) != 1) bad[chunk] = i;
               });
  for (const std::size_t i : bad)
    if (i < n)
      return InsideDefect{
          "I2",
          first_patches[i],
          {},
          {},
          "a point of " + parts.name(first_patches[i]) + " is not in the interior of the solid"};
  return std::nullopt;
}

}  // namespace veritope::internal
