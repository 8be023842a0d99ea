// SPDX-License-Identifier: LGPL-3.0-or-later
// The numbers of docs/certificates/vmodel.md, section 7.
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "robust/base/disjoint_sets.h"
#include "solids/vmodel/v_face_parts_internal.h"
#include "solids/vmodel/v_model_maker_internal.h"

namespace veritope {

using internal::edge_of_side, internal::kSidesOfFace;

namespace {

std::uint64_t num_classes(DisjointSets<>& sets, const std::vector<bool>* left_out) {
  std::uint64_t count = 0;
  for (std::uint32_t i = 0; i < sets.size(); ++i)
    if (sets.find(i) == i && (left_out == nullptr || !(*left_out)[i])) ++count;
  return count;
}

void identify(DisjointSets<>& points, DisjointSets<>& curves, VFaceNumber f,
              const VFaceRole& role) {
  const auto cell = static_cast<std::uint32_t>(f / 6),
             other = static_cast<std::uint32_t>(role.mate / 6);
  for (const auto& side : kSidesOfFace) {
    std::array<std::uint32_t, 2> own{}, others{};
    for (std::size_t end = 0; end < 2; ++end) {
      own[end] = internal::corner_of_face(f % 6, side[end]);
      others[end] =
          internal::corner_of_face(role.mate % 6, v_symmetry_image(role.symmetry, side[end]));
      points.join(8 * cell + own[end], 8 * other + others[end]);
    }
    curves.join(12 * cell + internal::edge_between(own[0], own[1]),
                12 * other + internal::edge_between(others[0], others[1]));
  }
}
// Sides n and n + 1 of the face.
void identify_sides(DisjointSets<>& curves, VFaceNumber f, std::size_t n) {
  const auto edge = [&](std::size_t side) { return 12 * (f / 6) + edge_of_side(f % 6, side); };
  curves.join(edge(n), edge(n + 1));
}

}  // namespace

void VModelMaker::count() {
  VCounts& n = m_.counts_;
  n.cells = m_.num_cells();
  n.pieces = m_.num_pieces();
  n.reversed =
      static_cast<std::uint64_t>(std::count(m_.is_reversed_.begin(), m_.is_reversed_.end(), true));
  for (const VFaceRole& role : m_.faces_) {
    n.half_v_surfaces += role.is_collapsed() ? 0 : 1;
    n.boundary += role.is_border() ? 1 : 0;
  }
  n.internal = (n.half_v_surfaces - n.boundary) / 2;
  n.v_surfaces = n.internal + n.boundary;
  count_points_and_curves();
  n.euler = static_cast<std::int64_t>(n.v_points) - static_cast<std::int64_t>(n.v_curves) +
            static_cast<std::int64_t>(n.v_surfaces) - static_cast<std::int64_t>(n.cells);
}

void VModelMaker::count_points_and_curves() {
  DisjointSets<> points(8 * m_.num_cells()), curves(12 * m_.num_cells());
  for (VFaceNumber f = 0; f < m_.num_faces(); ++f) {
    const VFaceRole& role = m_.faces_[f];
    if (role.is_glued() && role.mate > f) identify(points, curves, f, role);
    if (role.collapse == VCollapse::kAlongFirst) identify_sides(curves, f, 2);
    if (role.collapse == VCollapse::kAlongSecond) identify_sides(curves, f, 0);
  }
  std::vector<bool> is_collapsed(curves.size(), false);
  for (std::uint32_t c = 0; c < m_.num_cells(); ++c)
    for (std::uint32_t e = 0; e < 12; ++e)
      if (m_.is_edge_collapsed(c, e)) {
        is_collapsed[curves.find(12 * c + e)] = true;
        const auto ends = internal::ends_of_edge(e);
        points.join(8 * c + ends[0], 8 * c + ends[1]);
      }
  m_.counts_.v_points = num_classes(points, nullptr);
  m_.counts_.v_curves = num_classes(curves, &is_collapsed);
}
}  // namespace veritope
