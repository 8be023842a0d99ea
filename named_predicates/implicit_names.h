// SPDX-License-Identifier: LGPL-3.0-or-later
// named_predicates/implicit_names.h: predicates on implicit points by their names. Which points a line holds: the
// letters of named_predicates/hard_implicit_points.h.
#pragma once
#include <span>

#include "named_predicates/named_predicate.h"

namespace veritope {

/// In an order for readers. `kinds` of each is not empty.
std::span<const NamedPredicate> implicit_predicates();

}  // namespace veritope
