// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/certify/collar_model.h: patches with their star boxes and the collar that the search finds.
#pragma once
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "models/patch_shapes.h"
#include "robust/rational.h"
#include "solids/collar/piece_octree.h"
#include "solids/star_box/star_box.h"
#include "splines/de_casteljau.h"
#include "verify/certify/patch_collar.h"

namespace veritope::collar_model {

inline PatchComplex complex_of(patch_shapes::Patches patches) {
  return make_patch_complex(std::move(patches)).value();
}

/// REQUIRES patches that are covered by star boxes.
struct Model {
  explicit Model(patch_shapes::Patches patches, const CollarSearchOptions& options = {})
      : complex(complex_of(std::move(patches))),
        forest(PieceForest::make(complex, PieceForest::FrameChoice::kPlain).value()) {
    cover = find_star_cover(forest, {});
    if (!cover.is_complete()) return;
    search = find_patch_collar(forest, cover, options);
  }
  Model(const Model&) = delete;
  const PatchCollar& collar() const { return search.collar.value(); }
  bool has_collar() const { return search.collar.has_value(); }

  PatchComplex complex;
  PieceForest forest;
  StarCover cover;
  PatchCollarSearch search;
};

/// The genus of each shell, by the boundary of the body around it.
inline std::vector<int> genus_of_shells(const PatchCollar& collar) {
  std::vector<int> out;
  for (const std::uint32_t body : collar.place.body_of_shell)
    out.push_back(static_cast<int>(
        collar.collar.boundary.components[collar.collar.bodies[body].d_plus].genus()));
  return out;
}

/// Cells, as keys, at one level, that the hulls of pieces meet, in the root around the model.
inline CommonSubdivision uniform_cells(PieceForest& forest, const OctreeRoot& root,
                                       unsigned level) {
  PieceOctree octree(forest, root, std::size_t{1} << 29);
  for (unsigned l = 0; l < level; ++l)
    VT_CHECK(octree.split(std::vector<bool>(octree.num_cells(), true)), "too many cells");
  return CommonSubdivision::build(OctreeKeySet::make(octree.keys()).value()).value();
}

}  // namespace veritope::collar_model
