// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/vmodel_facts.h: what certify says of a V-model beside its verdict.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/vmodel/v_model.h"

namespace veritope {

/// A closed box in a cell's parameters on which the Jacobian determinant vanishes.
struct VSingularity {
  /// A corner, an edge or a face of a piece; or a face that is collapsed to a point or onto a curve.
  enum class Kind { kCorner, kEdge, kFace, kPoint, kCurve };

  std::uint64_t cell = 0;
  std::array<std::array<Rational, 2>, 3> box;
  Kind kind = Kind::kCorner;
};

struct VModelFacts {
  VCounts counts;
  std::vector<VSingularity> singular;   ///< of a valid model; none: it is regular
  std::vector<std::uint64_t> reversed;  ///< cells, ascending
  std::optional<Rational> volume;       ///< of a valid model whose cells are all polynomial
};

}  // namespace veritope
