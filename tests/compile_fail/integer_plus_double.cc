// SPDX-License-Identifier: LGPL-3.0-or-later
// Nor in an operation.
// EXPECT no match|invalid operands
#include "robust/integer.h"

void use() {
  veritope::Integer a(1);
#if defined(VT_BAD)
  a = a + 0.5;
#endif
}
