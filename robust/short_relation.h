// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/short_relation.h: integers c, not all zero and small, for which sum c_i x_i is nearly zero; with x_i = x^i,
// the polynomial of an algebraic number of which some hundred bits are known. It is a guess, which its user proves.
#pragma once
#include <vector>

#include "robust/integer.h"

namespace veritope {

/// Coefficients as a reduced basis of the lattice of (c, sum c_i x_i) has them first, where x_i = values[i] / 2^bits.
/// If a relation with coefficients of k bits exists and bits is well above k times the number of values, it is the
/// result; otherwise the coefficients have approximately bits / values.size() bits each.
/// REQUIRES 2 to 12 values, none of which is over 2^(bits + 10) in absolute value.
/// @source [LLL82], with floating-point orthogonalisation of a basis that gets its bits a few at a time
std::vector<Integer> short_relation(const std::vector<Integer>& values, int bits);

/// Coefficients of 1, x, x^2, ..., of the polynomial of least degree, at most `max_degree`, that the number seems to
/// satisfy: those of lower degrees have coefficients as long as bits allow. It is primitive, with a positive last
/// coefficient; empty if no polynomial is short. `x` is the number times 2^bits, rounded. REQUIRES |x| <= 2^bits.
std::vector<Integer> plausible_polynomial(const Integer& x, int bits, int max_degree);

}  // namespace veritope
