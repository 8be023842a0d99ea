// SPDX-License-Identifier: LGPL-3.0-or-later
// Nor in a comparison.
// EXPECT no match|invalid operands
#include "robust/rational.h"

void use() {
  const bool a = veritope::Rational(1) < veritope::Rational(2);
  (void)a;
#if defined(VT_BAD)
  const bool b = veritope::Rational(1) < 0.5;
  (void)b;
#endif
}
