// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/chain/normality.h: is a chain normal, definition 10 of seed 001 [GRF03]?  Theory: docs/THEORY.md, CHAIN-4.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>

#include "robust/integer.h"
#include "solids/chain/associated_function.h"

namespace veritope {

/// Whether f is 0 or 1 at every point that is on no wall of a cell. On walls closed cells are counted more than once:
/// f, and f*, are 2 on a face that two cells share.
template <std::size_t Dim>
struct Normality {
  enum class State : std::uint8_t { kHolds, kViolated, kUndecided };
  State state = State::kUndecided;
  /// kViolated: a point off all walls, and f there.
  std::optional<PointIn<Dim>> witness;
  Integer value;
};

struct NormalityOptions {
  /// The most sets of Dim facets whose common points are computed, and the most faces that are counted around them.
  std::uint64_t max_places = 1000000;
  /// Points that are tried if a wall is curved, or if there are too many places.
  std::uint64_t num_trials = 1000;
  std::uint64_t seed = 1;  ///< of the points
};

/// Decides chains of simplices, if the limits suffice. With a free-form cell a violation may be found, and otherwise
/// the answer is undecided: that the chain of a valid model is normal follows from the model's certificate and CHAIN-1.
/// @cost  near-linear for simplices in space over the facets of a solid (CHAIN-1 of a valid mesh); else, with n facets
///        that meet each other, in space n^3 points, and the faces around each
template <std::size_t Dim>
Normality<Dim> is_normal(const AssociatedFunction<Dim>& f, const NormalityOptions& options = {});

}  // namespace veritope
