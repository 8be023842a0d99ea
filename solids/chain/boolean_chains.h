// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/boolean_chains.h: Boolean operations as sums of chains: theorems 2 to 5 of seed 001 [GRF03].
// Theory: docs/THEORY.md, CHAIN-3.
#pragma once
#include <cstddef>
#include <cstdint>

#include "robust/base/result.h"
#include "solids/chain/chain.h"

namespace veritope {

/// The most terms that a product may have unless the caller says otherwise.
inline constexpr std::uint64_t kMostChainCells = 1000000;

/// The sum of a_i b_j ExCell(E_i and F_j) over the pairs whose boxes meet, as cells of two factors; the others are
/// empty. Its f is the product of those of a and b, for any two chains.
/// @error kOverLimit for more than `max_cells` pairs
/// @cost  near-linear in the terms and pairs
template <std::size_t Dim>
Result<Chain<Dim>> product(const Chain<Dim>& a, const Chain<Dim>& b,
                           std::uint64_t max_cells = kMostChainCells);

// The chains of solids: of normal chains a and b (definition 10) again normal chains. Errors are those of product().

/// Theorem 2.
template <std::size_t Dim>
Result<Chain<Dim>> intersection_of(const Chain<Dim>& a, const Chain<Dim>& b,
                                   std::uint64_t max_cells = kMostChainCells);
/// Theorem 3: a + b - (a and b).
template <std::size_t Dim>
Result<Chain<Dim>> union_of(const Chain<Dim>& a, const Chain<Dim>& b,
                            std::uint64_t max_cells = kMostChainCells);
/// Theorem 5 in its second form, a - (a and b). The first one, a - b, is -1 where b is alone.
template <std::size_t Dim>
Result<Chain<Dim>> difference_of(const Chain<Dim>& a, const Chain<Dim>& b,
                                 std::uint64_t max_cells = kMostChainCells);
/// Theorem 4 within the closed box from lo to hi: delta_R - a.
/// @error kBadArgument unless the box has the boxes of all cells of the chain in its interior, or as box_chain()
template <std::size_t Dim>
Result<Chain<Dim>> complement_of(const Chain<Dim>& a, const PointIn<Dim>& lo,
                                 const PointIn<Dim>& hi);

}  // namespace veritope
