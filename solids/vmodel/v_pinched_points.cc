// SPDX-License-Identifier: LGPL-3.0-or-later
// Points at which the border has more than one vertex.
#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "solids/vmodel/v_border_internal.h"
#include "solids/vmodel/v_edge_internal.h"
#include "solids/vmodel/v_parts.h"

namespace veritope {
namespace {

using internal::BorderPatches;

struct Corner {
  std::uint64_t hash = 0;
  std::uint32_t cell = 0, vertex = 0;
  std::size_t corner = 0;
  VFaceNumber face = 0;
};

std::vector<Corner> cell_corners(const BorderPatches& border) {
  std::vector<Corner> out;
  const PatchComplex& complex = border.complex();
  for (std::uint32_t p = 0; p < complex.patches().size(); ++p)
    for (std::uint32_t c = 0; c < 4; ++c) {
      const auto corner = border.cell_corner({p, c});
      if (!corner) continue;
      const VFaceNumber face = border.face_of(p);
      const VVolume& cell = border.model().cell(face / 6);
      out.push_back({internal::point_hash(v_corner_point(cell, *corner)), face / 6,
                     complex.vertex({p, c}), *corner, face});
    }
  std::sort(out.begin(), out.end(), [](const Corner& a, const Corner& b) {
    return std::pair(a.hash, a.vertex) < std::pair(b.hash, b.vertex);
  });
  return out;
}

}  // namespace

std::optional<VPinchedPoint> find_pinched_point(const VModel& model, const VFaces& faces,
                                                const PatchComplex& complex) {
  const BorderPatches border(model, faces, complex);
  if (!border.complex().is_closed_oriented_surface()) return std::nullopt;
  const std::vector<Corner> corners = cell_corners(border);
  const auto point = [&](const Corner& c) {
    return v_corner_point(border.model().cell(c.cell), c.corner);
  };
  for (std::size_t i = 0; i < corners.size();) {
    std::size_t end = i + 1;
    while (end < corners.size() && corners[end].hash == corners[i].hash) ++end;
    for (std::size_t j = i + 1; j < end; ++j) {
      if (corners[j].vertex == corners[i].vertex) continue;
      const std::array<Rational, 3> at = point(corners[i]);
      if (point(corners[j]) != at || border.is_spoilt(at)) continue;
      const bool is_clear =
          std::none_of(corners.begin() + static_cast<std::ptrdiff_t>(i),
                       corners.begin() + static_cast<std::ptrdiff_t>(end),
                       [&](const Corner& c) { return border.is_repeated(c.face); });
      if (is_clear)
        return VPinchedPoint{
            {{{corners[i].cell, corners[i].corner}, {corners[j].cell, corners[j].corner}}}, at};
    }
    i = end;
  }
  return std::nullopt;
}

}  // namespace veritope
