// SPDX-License-Identifier: LGPL-3.0-or-later
// cli/bad_argument.h: the error of an argument that contradicts another one or names nothing.
#pragma once
#include <string>
#include <utility>

#include "robust/base/result.h"

namespace veritope::cli {

inline Error bad_argument(std::string message) {
  return Error{Code::kBadArgument, Place{}, std::move(message)};
}

}  // namespace veritope::cli
