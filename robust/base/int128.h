// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/int128.h: names for the compiler's 128-bit integers, without a warning under
// -Wpedantic.
#pragma once

namespace veritope {

__extension__ typedef __int128 int128;
__extension__ typedef unsigned __int128 uint128;

}  // namespace veritope
