// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/v_singularities.h: where the Jacobian determinant of a V-model vanishes, cell by cell.
#pragma once
#include <vector>

#include "solids/vmodel/jacobian_sign.h"
#include "verify/certify/vmodel_facts.h"

namespace veritope {

/// The zeros of the pieces, those of neighbouring pieces joined, ascending by cell; none is a part of another.
/// REQUIRES determinants of the model that are proved.
std::vector<VSingularity> singularities_of(const VModel& model, const VDeterminants& determinants);

}  // namespace veritope
