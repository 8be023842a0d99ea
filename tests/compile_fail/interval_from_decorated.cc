// SPDX-License-Identifier: LGPL-3.0-or-later
// Dropping a decoration is spelled: interval().
// EXPECT no match|no viable|invalid operands
#include "interval/decorated.h"

void use() {
  veritope::Interval a = veritope::DecoratedInterval().interval();
#if defined(VT_BAD)
  a = veritope::DecoratedInterval();
#endif
  (void)a;
}
