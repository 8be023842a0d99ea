// SPDX-License-Identifier: LGPL-3.0-or-later
// A double does not become an exact integer unseen.
// EXPECT conver|no viable|could not convert
#include "robust/integer.h"

void use() {
  veritope::Integer a(1);
#if defined(VT_BAD)
  veritope::Integer b = 1.5;
#endif
}
