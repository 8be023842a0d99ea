// SPDX-License-Identifier: LGPL-3.0-or-later
// A rational is rounded by name only: nearest_double, round_up, round_down.
// EXPECT conver|no viable
#include "robust/rational.h"

void use() {
  const double a = veritope::nearest_double(veritope::Rational(1));
  (void)a;
#if defined(VT_BAD)
  const double b = veritope::Rational(1);
  (void)b;
#endif
}
