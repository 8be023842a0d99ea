// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/monotone_search.h: matrices that make many others positive definite, sought in binary64.
#pragma once
#include <functional>
#include <span>

#include "solids/dms/plain_matrix.h"

namespace veritope::internal {

/// Seeks a Q with Q K + (Q K)^T positive definite for all K, and shows accept() those that it meets, better ones later,
/// until it takes one; false if it takes none. These are linear inequalities of symmetric matrices, so the set of all Q
/// is convex: a barrier method finds it if it is not extremely thin. Affine maps of the K change the way, but hardly
/// its end. REQUIRES matrices of norm 1, at least one.
/// @cost  some 50 steps of Newton's method for 10 unknowns, each linear in the number of matrices
/// Source: S. Boyd, L. Vandenberghe, Convex Optimization, 2004, sections 11.4 and 11.6
bool search_monotone(std::span<const PlainMatrix> k,
                     const std::function<bool(const PlainMatrix&)>& accept);

}  // namespace veritope::internal
