// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/solvers/polynomial_roots.h: all roots of N polynomial equations in N unknowns, N = 1 to 4, in the closed box
// [0,1]^N, each isolated and proved. Design: docs/design/0012-certified-solvers.md.
#pragma once
#include <span>

#include "interval/solvers/polynomial_system.h"
#include "interval/solvers/root_report.h"

namespace veritope {

/// Returns what RootReport promises for the equations sum_i c_i B_i(x) = 0. Their Bernstein coefficients are the
/// components of `equations`, N in all; each map has its own degrees. Simple roots are isolated as soon as double
/// intervals on a small enough window suffice; multiple roots, and roots closer than options.least_width, end in
/// clusters.
/// @error as PolynomialSystem::make; kBadArgument also for options out of their range.
template <std::size_t N>
Result<RootReport<N>> polynomial_roots(std::span<const Bezier<Rational, N>> equations,
                                       const SolverOptions& options = {});
/// Takes the coefficients as exact numbers. @error kNotFinite: a coefficient that is not finite.
template <std::size_t N>
Result<RootReport<N>> polynomial_roots(std::span<const Bezier<double, N>> equations,
                                       const SolverOptions& options = {});

/// The root in a box at most `width` wide if max_precision bits suffice; otherwise as narrow as they allow. REQUIRES a
/// root of these equations, width > 0.
template <std::size_t N>
IsolatedRoot<N> refined(const PolynomialSystem<N>& system, IsolatedRoot<N> root,
                        const Rational& width, int max_precision = 1 << 16);

Status check_options(const SolverOptions& options);

}  // namespace veritope
