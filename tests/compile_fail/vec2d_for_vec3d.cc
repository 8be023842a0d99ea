// SPDX-License-Identifier: LGPL-3.0-or-later
// A point of the plane is not a point of space.
// EXPECT invalid initialization|no viable
#include "predicates/orient3d.h"

void use() {
  veritope::Vec3d a;
  veritope::Vec2d b;
  (void)a;
  (void)b;
#if defined(VT_BAD)
  veritope::orient3d(a, a, a, b);
#endif
}
