// SPDX-License-Identifier: LGPL-3.0-or-later
// The last tier of a cascade always answers.
// EXPECT the last tier always answers
#include "robust/cascade.h"

void use() {
  veritope::cascade(nullptr, [] { return veritope::Sign::kZero; });
#if defined(VT_BAD)
  veritope::cascade(nullptr, [] { return veritope::Sign3::kUncertain; });
#endif
}
