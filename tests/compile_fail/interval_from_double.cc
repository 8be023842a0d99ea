// SPDX-License-Identifier: LGPL-3.0-or-later
// A double becomes a point interval only when that is spelled.
// EXPECT no match|no viable
#include "interval/interval.h"

void use() {
  veritope::Interval a(1.5);
#if defined(VT_BAD)
  a = 1.5;
#endif
}
