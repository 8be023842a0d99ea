// SPDX-License-Identifier: LGPL-3.0-or-later
// A double becomes a multi-precision interval only with a precision.
// EXPECT no match|no viable|invalid operands
#include "interval/mp_interval.h"

void use() {
  veritope::MpInterval a(veritope::Interval(1.5), 100);
#if defined(VT_BAD)
  a = a + 1.5;
#endif
  (void)a;
}
