// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/composition.h"

#include <string>

#include "robust/base/int128.h"

namespace veritope::internal {

Status check_composition(std::span<const int> outer_degrees, std::span<const int> inner_degrees,
                         int inner_dimension, int num_components) {
  if (inner_dimension != static_cast<int>(outer_degrees.size()))
    return Error{Code::kBadArgument,
                 {},
                 "the points of the inner map have " + std::to_string(inner_dimension) +
                     " coordinates, the outer map has " + std::to_string(outer_degrees.size()) +
                     " variables"};
  std::uint64_t sum = 0;
  for (const int a : outer_degrees) sum += static_cast<std::uint64_t>(a);
  std::uint64_t count = static_cast<std::uint64_t>(num_components);
  for (const int n : inner_degrees) {
    const uint128 product = uint128{count} * (uint128{sum} * static_cast<std::uint64_t>(n) + 1);
    if (product > kMaxComposedCoefficients)
      return Error{Code::kOverLimit,
                   {},
                   "the composed map would have more than " +
                       std::to_string(kMaxComposedCoefficients) + " coefficients"};
    count = static_cast<std::uint64_t>(product);
  }
  return ok_status();
}

}  // namespace veritope::internal
