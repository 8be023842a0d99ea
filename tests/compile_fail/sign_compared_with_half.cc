// SPDX-License-Identifier: LGPL-3.0-or-later
// A sign is compared with the int 0, not with a number of another type.
// EXPECT no match for|invalid operands
#include "robust/base/sign.h"

void use(veritope::Sign s) {
  bool a = s > 0;
#if defined(VT_BAD)
  a = s > 0.5;
#endif
}
