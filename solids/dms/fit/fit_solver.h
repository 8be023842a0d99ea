// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fit/fit_solver.h: sparse least squares in binary64, and which unknowns the rows do not determine. Results
// are approximate; no decision depends on them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solids/dms/fit/sparse_rows.h"

namespace veritope {

/// For each column of b (b[row * num_rhs + k]) the x that minimises |A x - b|; among several that for which |S x| is
/// about least. x[unknown * num_rhs + k].
std::vector<double> solve_least_squares(const SparseRows& a, const SparseRows& s,
                                        std::size_t num_unknowns, std::span<const double> b,
                                        std::size_t num_rhs);

/// The step x that minimises |A x - b|^2 + the sum of damping[i] (A^T A)_ii x_i^2, with a little of |S x|^2.
std::vector<double> solve_damped(const SparseRows& a, const SparseRows& s,
                                 std::span<const double> damping, std::span<const double> b);

/// The unknowns that the rows do not determine, ascending: those that take part in a change of the unknowns, one of
/// them by 1 in units in which each column of A has norm 1, that changes A x by less than 2^-17.
std::vector<std::uint32_t> find_undetermined(const SparseRows& a, std::size_t num_unknowns);

}  // namespace veritope
