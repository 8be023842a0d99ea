// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/base/read_limits.h"

namespace veritope {

std::string over_limit(std::string_view what, std::string_view flag, std::uint64_t limit) {
  const std::string number = std::to_string(limit);
  return "more than " + number + " " + std::string(what) + " (" + std::string(flag) + " " + number +
         ")";
}

}  // namespace veritope
