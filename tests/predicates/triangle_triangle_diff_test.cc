// SPDX-License-Identifier: LGPL-3.0-or-later
// triangle_triangle against clipping: every pair of a cube of 27 points, and of a flat grid of 16.
#include "tests/predicates/grid_pairs.h"

namespace veritope {
namespace {

TEST(TriangleTriangleExhaustive, AgreesWithClippingOnEveryPairOfTheCubeOf27Points) {
  oracle::compare_on_grid(3, 3, 3, 1);
}
TEST(TriangleTriangleExhaustive, AgreesWithClippingOnEveryPairOfTheFlatGridOf16Points) {
  oracle::compare_on_grid(4, 4, 1, 1);
}

}  // namespace
}  // namespace veritope
