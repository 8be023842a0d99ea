// SPDX-License-Identifier: LGPL-3.0-or-later
// An answer that may be uncertain is not a sign.
// EXPECT cannot convert|incompatible
#include "robust/base/sign.h"

void use() {
  veritope::Sign a = veritope::to_sign(veritope::Sign3::kZero);
#if defined(VT_BAD)
  a = veritope::Sign3::kUncertain;
#endif
}
