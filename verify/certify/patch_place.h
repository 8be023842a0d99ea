// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/patch_place.h: places of patches, given by exact parameters, and which of them are one point of the
// surface. Conditions: docs/certificates/patch-invalid-2.md, M1.
#pragma once
#include <array>
#include <cstdint>

#include "solids/patches/patch_complex.h"

namespace veritope {

/// A point of the tensor form of a patch (tensor_form in crossing_witness.h): (u, v), or (s, t) of a triangle.
struct PatchPlace {
  std::uint32_t patch = 0;
  std::array<Rational, 2> at;
  friend bool operator==(const PatchPlace&, const PatchPlace&) = default;
};

/// Whether both parameters lie strictly between 0 and 1.
bool is_in_open_domain(const PatchPlace& place);

/// Whether P1 holds, apart from collapsed sides inside of entities, which a complex does not know: it is a closed
/// oriented surface, and none of its sides is its own reverse.
/// @cost  linear in the number of patches
bool is_glued(const PatchComplex& complex);

/// Whether the two places are one point of the surface. REQUIRES is_glued(complex), and parameters of [0,1].
bool are_one_point(const PatchComplex& complex, const PatchPlace& a, const PatchPlace& b);

}  // namespace veritope
