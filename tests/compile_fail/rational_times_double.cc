// SPDX-License-Identifier: LGPL-3.0-or-later
// Nor in an operation.
// EXPECT no match|invalid operands
#include "robust/rational.h"

void use() {
  veritope::Rational a(1);
#if defined(VT_BAD)
  a = a * 2.0;
#endif
}
