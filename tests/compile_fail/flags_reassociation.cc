// SPDX-License-Identifier: LGPL-3.0-or-later
// The filters refuse to be compiled with -fassociative-math. Clang does not tell: there the probe
// finds it at run time.
// ONLY g++
// BAD-FLAGS -fassociative-math -fno-signed-zeros -fno-trapping-math
// EXPECT veritope: -fassociative-math
#include "predicates/orient3d.h"

veritope::Sign use(const veritope::Vec3d& a) { return veritope::orient3d(a, a, a, a); }
