// SPDX-License-Identifier: LGPL-3.0-or-later
// io/base/read_limits.h: how much of a file the readers take before they refuse it.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace veritope {

/// Budgets. A file that needs more than a limit is refused with kOverLimit and the name of the option; one that needs
/// exactly the limit is read.
struct ReadLimits {
  std::uint64_t max_bytes = std::uint64_t{4} << 30;  ///< --max-bytes: size of the file
  std::uint64_t max_faces = 200'000'000;  ///< --max-faces: triangles, after splitting polygons
  std::uint32_t max_digits = 1000;    ///< --max-digits: digits of one number, its exponent apart
  std::uint32_t max_exponent = 4096;  ///< --max-exponent: absolute value of a written exponent
};

/// The sentence for a limit: "more than 3 faces (--max-faces 3)".
std::string over_limit(std::string_view what, std::string_view flag, std::uint64_t limit);

}  // namespace veritope
