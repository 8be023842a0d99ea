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

/// What all claims that build on star boxes begin with. The unit of its coordinates is 2^exponent in the forest's coordinates times 2^-scale(), where
/// exponent is at most `most_exponent` and that of every box. REQUIRES as make_star_box_certificate.
certificate::StarBoxBody make_star_box_body(const PieceForest& forest, const StarCover& cover,
                                            const ShellWalks& walks,
                                            const std::vector<StarBoxEntity>& entities,
                                            int most_exponent);
certificate::StarBoxQuantities star_box_quantities(const PatchComplex& complex,
                                                   const ShellWalks& walks);

/// REQUIRES a complete cover, a walk for every shell, winding numbers 1 inside and 0 outside, and the entities of the complex in order.
certificate::Bytes make_star_box_certificate(const PieceForest& forest, const StarCover& cover,
                                             const ShellWalks& walks,
                                             const std::vector<StarBoxEntity>& entities,
                                             const certificate::Subject& subject);

}  // namespace veritope
