// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/patch_reasons.h: named reasons why patches have no verdict: T-junctions, sides with other
// parametrizations, inner knots of too great multiplicity, patches that occur twice, that are a point or a curve, or
// that have a singular line. Each is decided exactly. Design: docs/design/0037-named-gaps-and-joints.md.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "solids/base/finding.h"
#include "verify/certify/file_patches.h"

namespace veritope {

/// At most `most` findings, those about whole patches first. REQUIRES patches.complex.
/// @cost as find_degeneracies for at most 50,000 patches, and find_side_overlaps
std::vector<Finding> patch_reasons(const FilePatches& patches, std::size_t most);

/// "knot-multiplicity", about the first of patches.torn. REQUIRES that there is one.
Finding torn_knot_finding(const TornKnot& knot);

/// "; entity 4 is entity 2 again" if two of the witness's patches are equal; otherwise empty.
std::string repetition_text(const FilePatches& patches, const SideWitness& witness);

}  // namespace veritope
