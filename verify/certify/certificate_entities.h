// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/certificate_entities.h: how the patches of a complex come from the entities of the model file that a
// certificate speaks of.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "io/splines/boundary_faces.h"
#include "robust/rational.h"
#include "verify/certify/side_witness.h"
#include "verify/format/patch_entities.h"

namespace veritope {

/// An entity of the model file whose patches are numbered from first_patch on: a surface has (u pieces) x (v pieces), v
/// fastest.
struct StarBoxEntity {
  bool is_surface = true;
  /// The patches of the complex are those of the file, reversed: axes exchanged, or corners 1 and 2 of a triangle.
  bool is_reversed = false;
  std::uint32_t first_patch = 0;
  std::array<std::vector<Rational>, 2> breaks;  ///< a surface's, in the file's order of axes
  /// Where this boundary face lies, in a file of volumes.
  std::optional<VolumeFace> face = std::nullopt;
};

certificate::Fraction to_fraction(const Rational& v);

/// Whether numerators and denominators of the breaks have few enough bits for a certificate: 2048.
bool breaks_fit_certificate(const StarBoxEntity& entity);

std::vector<certificate::PatchEntity> to_certificate(const std::vector<StarBoxEntity>& entities);

/// For each of the patches, whether its entity is reversed.
std::vector<bool> reversed_patches(const std::vector<StarBoxEntity>& entities,
                                   std::size_t num_patches);

/// The outer sides of the complex's patches: see OuterSides. REQUIRES entities in order.
OuterSides outer_sides(const std::vector<StarBoxEntity>& entities, std::size_t num_patches);

}  // namespace veritope
