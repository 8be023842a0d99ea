// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/patch_transform.h: other descriptions of the same model, and images of the model, exactly: changes on
// which a verdict must not depend.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "robust/base/random.h"
#include "robust/base/result.h"
#include "solids/patches/patch.h"
#include "splines/affine_map.h"

namespace veritope {

/// The image of each patch under x -> linear x + translation; reversed if the determinant is negative, so that outward
/// normals stay outward. @error kBadArgument unless `linear` is a map of space with a determinant other than 0.
Result<std::vector<Patch>> affine_image(std::span<const Patch> patches, const AffineMap& map);

/// The image under the automorphism of space that adds factor * x_i * x_j to coordinate `target`. It is one to one and
/// of determinant 1, so the image of an embedded surface is embedded, with the same topology, volume and orientation.
/// Degrees are doubled. REQUIRES target, i, j < 3; i and j other than target; degrees of at most kMaxSplineDegree / 2.
struct QuadraticShear {
  std::size_t target, i, j;
  Rational factor;
};
std::vector<Patch> sheared(std::span<const Patch> patches, const QuadraticShear& shear);

/// The patches in another order, each turned to another corner 0, as `random` says: the same surface.
std::vector<Patch> relabelled(std::span<const Patch> patches, Random& random);
/// Each patch cut into 4: a tensor at u, v = 1/2, a triangle at the middles of its sides.
std::vector<Patch> subdivided(std::span<const Patch> patches);
/// Tensor patches cut in the middle of u, of v, of both or of neither: along closed belts of patches, which opposite
/// sides connect, each cut or left as `random` says. Belts that end at a triangle or at a defect are left.
std::vector<Patch> cut_along_belts(std::span<const Patch> patches, Random& random);
/// Raises every degree by `by`; the maps stay the same. REQUIRES by >= 0.
std::vector<Patch> elevated(std::span<const Patch> patches, int by);

}  // namespace veritope
