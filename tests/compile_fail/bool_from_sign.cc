// SPDX-License-Identifier: LGPL-3.0-or-later
// A sign is not a truth value.
// EXPECT cannot convert|incompatible
#include "robust/base/sign.h"

void use() {
  bool a = veritope::Sign::kZero == veritope::sign_of(1);
#if defined(VT_BAD)
  a = veritope::Sign::kPositive;
#endif
}
