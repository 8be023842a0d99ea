// SPDX-License-Identifier: LGPL-3.0-or-later
// A double becomes a rational through from_double only.
// EXPECT no match|no viable
#include "robust/rational.h"

void use() {
  veritope::Rational a = veritope::Rational::from_double(1.5);
#if defined(VT_BAD)
  a = 1.5;
#endif
}
