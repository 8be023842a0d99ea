// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/refused_internal.h: the error of every refused argument of a spline.
#pragma once
#include <string>
#include <utility>

#include "robust/base/result.h"

namespace veritope::internal {

inline Error refused(std::string message) {
  return Error{Code::kBadArgument, {}, std::move(message)};
}

}  // namespace veritope::internal
