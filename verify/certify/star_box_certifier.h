// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/star_box_certifier.h: from star boxes and walks to the bytes of a star-box certificate.
#pragma once
#include <vector>

#include "verify/certify/certificate_entities.h"
#include "verify/certify/star_walks.h"
#include "verify/format/star_box_certificate.h"

namespace veritope {

/// The beginning that all claims based on star boxes share. The unit of its coordinates is 2^exponent in the forest's
/// coordinates times 2^-scale(), where exponent is at most `most_exponent` and at most that of every box. REQUIRES as
/// make_star_box_certificate.
certificate::StarBoxBody make_star_box_body(const PieceForest& forest, const StarCover& cover,
                                            const ShellWalks& walks,
                                            const std::vector<StarBoxEntity>& entities,
                                            int most_exponent);
/// A body of version 2, which demands nothing of boxes that version 1 could hold, too.
certificate::StarBoxBody make_star_box_2_body(const PieceForest& forest, const StarCover& cover,
                                              const ShellWalks& walks,
                                              const std::vector<StarBoxEntity>& entities);
certificate::StarBoxQuantities star_box_quantities(const PatchComplex& complex,
                                                   const ShellWalks& walks);

/// The least power of two in the forest's coordinates that boxes near the model may have as their unit: the boxes then
/// fit a certificate.
double least_unit_that_fits(const PieceForest& forest);

/// A power of two in the forest's coordinates: a cover with a box of a smaller unit fits no certificate. 0 for a model
/// of points at the origin. REQUIRES positive weights.
double least_unit_of_any(const PieceForest& forest);

/// The unit in which a certificate gives the coordinates of the boxes, at most `most`: a power of two, in the
/// coordinates of the forest.
double least_unit_of_boxes(const PieceForest& forest, const StarCover& cover, double most);

/// Whether the coordinates of the boxes, in units of the least one, have few enough bits for a certificate, and whether
/// the certificate can hold that unit.
bool fits_certificate(const PieceForest& forest, const StarCover& cover);

/// The claim "star-box-1", or "star-box-turned-1" if the winding number on the inner side of the last walk's shell is
/// not 1. REQUIRES fits_certificate, a complete cover, a walk for every shell, winding numbers 1 inside and 0 outside
/// on all shells or others on the last walk's, and the entities of the complex in order.
certificate::Bytes make_star_box_certificate(const PieceForest& forest, const StarCover& cover,
                                             const ShellWalks& walks,
                                             const std::vector<StarBoxEntity>& entities,
                                             const certificate::Subject& subject);

}  // namespace veritope
