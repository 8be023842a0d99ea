// SPDX-License-Identifier: LGPL-3.0-or-later
// named_predicates/named_predicate.h: the predicates by their names, on operands in one row.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "robust/base/sign.h"
#include "robust/cascade.h"

namespace veritope {

/// The operands are the coordinates of the arguments in their order; a predicate ignores those that
/// it does not take.
inline constexpr std::size_t kMostOperands = 62;
using Operands = std::array<double, kMostOperands>;

struct NamedPredicate {
  std::string_view name;
  std::string_view arguments;  ///< "a b c"; for people
  int dimension;               ///< of its points: 2 or 3
  std::size_t num_operands;
  Sign (*decide)(const Operands&,
                 TierCounts*);  ///< the library's cascade. REQUIRES finite operands
  /// The predicate's formula over rationals: no filter, no tier. Slow. REQUIRES finite operands
  Sign (*decide_by_formula)(const Operands&);
  /// The kinds of the points, in order, as letters of named_predicates/hard_implicit_points.h; empty if all are
  /// explicit.
  std::string_view kinds = {};
  /// Whether the implicit points exist; if not, there is no sign. Null if all points are explicit.
  bool (*is_defined)(const Operands&) = nullptr;
};

/// The predicates on explicit points, in an order for readers; named_predicates/implicit_names.h has the others.
std::span<const NamedPredicate> named_predicates();

/// Null for an unknown name.
const NamedPredicate* predicate_from_name(std::string_view name);

/// "orient2d, orient3d, ...".
std::string predicate_names();

/// "filter 12, lattice 3, interval 0, exact 1": the number of cases that each tier decided.
std::string tiers_text(const TierCounts& tiers);

}  // namespace veritope
