// SPDX-License-Identifier: LGPL-3.0-or-later
// Bounds to nearest and bounds under ScopedUpward do not mix unnoticed.
// EXPECT no match|no viable|invalid operands
#include "interval/nearest_interval.h"

void use() {
  veritope::NearestInterval a(1.5);
#if defined(VT_BAD)
  a = a + veritope::Interval(1.5);
#endif
  (void)a;
}
