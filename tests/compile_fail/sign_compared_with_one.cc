// SPDX-License-Identifier: LGPL-3.0-or-later
// A sign is compared with 0 and with no other number.
// EXPECT a_sign_can_only_be_compared_with_zero|not a constant expression
#include "robust/base/sign.h"

void use(veritope::Sign s, int n) {
  bool a = s > 0 && n > 0;
#if defined(VT_BAD)
  a = s < 1;
#endif
}
