// SPDX-License-Identifier: LGPL-3.0-or-later
// The filters refuse to be compiled for the x87: it keeps excess precision. Clang has no such
// option for x86-64.
// ONLY g++
// BAD-FLAGS -mfpmath=387
// EXPECT veritope: binary64 is evaluated with excess precision
#include "predicates/orient3d.h"

veritope::Sign use(const veritope::Vec3d& a) { return veritope::orient3d(a, a, a, a); }
