// SPDX-License-Identifier: LGPL-3.0-or-later
// A sign is compared with 0, not with a number that is known at run time only.
// EXPECT not a constant expression
#include "robust/base/sign.h"

void use(veritope::Sign s, int n) {
  bool a = s > 0 && n > 0;
#if defined(VT_BAD)
  a = s < n;
#endif
}
