// SPDX-License-Identifier: LGPL-3.0-or-later
// io/base/system_reason_internal.h: the system's words for an error number.
#pragma once
#include <string>
#include <system_error>

namespace veritope::internal {

// "No such file or directory" of ENOENT.
inline std::string reason(int number) { return std::generic_category().message(number); }

}  // namespace veritope::internal
