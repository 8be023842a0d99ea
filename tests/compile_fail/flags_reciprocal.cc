// SPDX-License-Identifier: LGPL-3.0-or-later
// The filters refuse to be compiled with -freciprocal-math. Clang does not tell; the predicates do
// not divide.
// ONLY g++
// BAD-FLAGS -freciprocal-math
// EXPECT veritope: -freciprocal-math
#include "predicates/orient3d.h"

veritope::Sign use(const veritope::Vec3d& a) { return veritope::orient3d(a, a, a, a); }
