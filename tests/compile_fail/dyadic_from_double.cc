// SPDX-License-Identifier: LGPL-3.0-or-later
// A double becomes a dyadic through from_double only.
// EXPECT no match|no viable
#include "robust/dyadic.h"

void use() {
  veritope::Dyadic a = veritope::Dyadic::from_double(1.5);
#if defined(VT_BAD)
  a = 1.5;
#endif
}
