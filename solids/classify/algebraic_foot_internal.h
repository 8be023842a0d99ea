// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/algebraic_foot_internal.h: irrational parameters at which a patch passes through a point, guessed
// from their first bits and proved by algebra. Theory: docs/THEORY.md, POINT-4. Internal to solids/classify.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "robust/dyadic.h"
#include "solids/classify/algebraic_number.h"
#include "solids/classify/tensor_form.h"

namespace veritope::internal {

/// Parameters in [0,1]^2 at which the map whose control points, relative to a point, are `net` (x, y, z in the order of
/// the form; homogeneous) is 0; nothing if no roots of polynomials up to degree 6 with short coefficients were found
/// near `at`, of which `bits` bits are right, or if substitution does not confirm them.
std::optional<AlgebraicPair> algebraic_parameters(const TensorForm& form,
                                                  const std::array<std::vector<Integer>, 3>& net,
                                                  const std::array<Dyadic, 2>& at, int bits);

}  // namespace veritope::internal
