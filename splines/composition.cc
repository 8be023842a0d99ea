// SPDX-License-Identifier: LGPL-3.0-or-later
#include "splines/composition.h"

#include <string>

#include "robust/base/int128.h"
#include "robust/binary64.h"

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

Status check_finite(std::span<const double> coefficients, const char* which_map) {
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    if (!is_finite(coefficients[i]))
      return Error{
          Code::kNotFinite,
          {},
          "coefficient " + std::to_string(i) + " of the " + which_map + " map is not finite"};
  return ok_status();
}

}  // namespace veritope::internal
