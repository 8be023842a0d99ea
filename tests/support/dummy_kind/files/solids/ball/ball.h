// SPDX-License-Identifier: LGPL-3.0-or-later
// A ball given by its centre and its radius. It is an example of a kind of model: docs/how-to/add-a-solid.md.
#pragma once
#include <array>
#include <cstdint>

namespace veritope {

/// digits / 10^decimals in its shortest form: decimals is 0, or the last digit is not 0.
struct ShortDecimal {
  std::int64_t digits = 0;  ///< at most 18 of them
  std::uint8_t decimals = 0;
};

/// The points at a distance of at most `radius` from `centre`.
struct Ball {
  std::array<ShortDecimal, 3> centre;
  ShortDecimal radius;
};

/// Whether the ball is the closure of its interior and not empty: radius > 0.
bool is_solid(const Ball& ball);

/// The nearest binary64, or a neighbour of it.
double approx_value(const ShortDecimal& number);

}  // namespace veritope
