// SPDX-License-Identifier: LGPL-3.0-or-later
// An interval is not a number.
// EXPECT cannot convert|no viable
#include "interval/interval.h"

void use() {
  veritope::Interval a(1.5);
#if defined(VT_BAD)
  const double b = a;
  (void)b;
#endif
}
