// SPDX-License-Identifier: LGPL-3.0-or-later
// A wide integer is not cut.
// EXPECT no match|no viable|no matching
#include "robust/fixed_int.h"

void use() {
  veritope::FixedInt<2> a = 7;
  veritope::FixedInt<3> b(a);
#if defined(VT_BAD)
  a = veritope::FixedInt<2>(b);
#endif
}
