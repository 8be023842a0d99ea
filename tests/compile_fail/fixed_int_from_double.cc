// SPDX-License-Identifier: LGPL-3.0-or-later
// A double does not become a fixed-width integer unseen.
// EXPECT no match|no viable|no matching
#include "robust/fixed_int.h"

void use() {
  veritope::FixedInt<2> a = 7;
#if defined(VT_BAD)
  a = veritope::FixedInt<2>(1.5);
#endif
}
