// SPDX-License-Identifier: LGPL-3.0-or-later
// An answer that may be uncertain has no order.
// EXPECT no match|invalid operands
#include "robust/base/sign.h"

void use(veritope::Sign s, int n) {
  bool a = s > 0 && n > 0;
#if defined(VT_BAD)
  a = veritope::to_sign3(s) > 0;
#endif
}
