// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fit/fit_knots.h: knots as unknowns of a fit.
// Source: [HHQ04], section 5.3; steps by the method of Levenberg and Marquardt, for the knots of all vertices whose
// neighbourhood has errors and all control points at once.
#pragma once
#include <span>

#include "solids/dms/dms_region.h"
#include "solids/dms/fit/fit_state.h"

namespace veritope {

enum class FitKnots {
  kVertices,  ///< each cloud moves as one
  kClouds,    ///< each knot moves by itself
};

/// Moves knots until the errors do not become less, at most `most_steps` times. The domain stays the same set, and
/// planes of features stay unions of faces. The conditions (a), (b) and (c) hold by the tests of dms_admissible.h. No
/// knot is nearer to the first one of its cloud than 1/256 of the vertex' shortest edge, unless it is equal to it.
/// Returns whether the errors became less. REQUIRES a state after refit().
bool improve_knots(FitState& state, FitKnots knots, std::span<const DmsPlane> features,
                   int most_steps);

}  // namespace veritope
