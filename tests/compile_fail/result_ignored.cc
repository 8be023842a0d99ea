// SPDX-License-Identifier: LGPL-3.0-or-later
// An error may not be overlooked.
// EXPECT nodiscard|unused-result
#include "robust/base/result.h"

void use() {
  (void)veritope::ok_status();
#if defined(VT_BAD)
  veritope::ok_status();
#endif
}
