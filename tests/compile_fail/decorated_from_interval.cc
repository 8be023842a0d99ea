// SPDX-License-Identifier: LGPL-3.0-or-later
// A bare interval gets its decoration only when that is spelled.
// EXPECT no match|no viable|invalid operands
#include "interval/decorated.h"

void use() {
  veritope::DecoratedInterval a(veritope::Interval(1.5));
#if defined(VT_BAD)
  a = veritope::Interval(1.5);
#endif
  (void)a;
}
