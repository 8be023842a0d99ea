// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/star_box_certifier.h: from star boxes and walks to the bytes of a star-box certificate.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "verify/certify/star_walks.h"
#include "verify/format/star_box_certificate.h"

namespace veritope {

/// An entity of the model file whose patches are numbered from first_patch on: of a surface (u pieces) x (v pieces), v fastest.
struct StarBoxEntity {
  bool is_surface = true;
  /// The patches of the complex are those of the file with their normals turned: axes exchanged, or corners 1 and 2 of a triangle.
  bool is_reversed = false;
  std::uint32_t first_patch = 0;
  std::array<std::vector<Rational>, 2> breaks;  ///< of a surface, in the file's order of axes
};

/// Whether the coordinates of the boxes, in units of the least one, have few enough bits for a certificate.
bool fits_certificate(const PieceForest& forest, const StarCover& cover);

/// REQUIRES fits_certificate, a complete cover, a walk for every shell, winding numbers 1 inside and 0 outside, and the entities of the complex in order.
certificate::Bytes make_star_box_certificate(const PieceForest& forest, const StarCover& cover,
                                             const ShellWalks& walks,
                                             const std::vector<StarBoxEntity>& entities,
                                             const certificate::Subject& subject);

}  // namespace veritope
