// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/vmodel/v_near_faces_internal.h: which faces are near (v_weld.h) and could be made one.
#pragma once
#include <cstdint>
#include <vector>

#include "robust/base/result.h"
#include "solids/vmodel/v_weld.h"

namespace veritope::internal {

struct NearPair {
  VFaceNumber f = 0, g = 0;   // f < g
  std::uint8_t symmetry = 0;  // from f to g
  Rational distance;
};
struct NearFaces {
  std::vector<NearPair> pairs;  // no face occurs twice
  std::vector<VApartPair> apart;
};

/// @error kOverLimit as weld says
Result<NearFaces> near_faces(const VModel& model, const Rational& eps);

}  // namespace veritope::internal
