// SPDX-License-Identifier: LGPL-3.0-or-later
#include "robust/base/check.h"

namespace veritope::internal {

void check_failed(const char* condition, const char* why, const char* file, int line) {
  throw InternalError(std::string(file) + ":" + std::to_string(line) + ": " + why + " (" + condition +
                      ")");
}

}  // namespace veritope::internal
