// SPDX-License-Identifier: LGPL-3.0-or-later
// The filters refuse to be compiled with -ffinite-math-only: their bounds do not hold there.
// BAD-FLAGS -ffinite-math-only
// EXPECT veritope: -ffinite-math-only
#include "predicates/orient3d.h"

veritope::Sign use(const veritope::Vec3d& a) { return veritope::orient3d(a, a, a, a); }
