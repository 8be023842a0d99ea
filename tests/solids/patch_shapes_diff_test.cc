// SPDX-License-Identifier: LGPL-3.0-or-later
// The truth of the example models against the mesh decision on tessellations, which shares no code with their construction.
#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "solids/polyhedron/validity.h"
#include "tests/solids/patch_support.h"

namespace veritope {
namespace {

TEST(PatchShapesDiff, TessellationsOfSoundShapesAreValidWithTheirGenusAndBodies) {
  for (const auto& shape : patch_shapes::sound_shapes()) {
    SCOPED_TRACE(shape.name);
    const ValidityReport report = decide_validity(tessellated(shape.patches, 4), {});
    EXPECT_TRUE(report.is_valid);
    std::int64_t genus = 0;
    for (const int g : shape.genus) genus += g;
    EXPECT_EQ(report.counts.genus, std::optional(genus));
    EXPECT_EQ(report.counts.bodies, std::optional(static_cast<std::uint64_t>(shape.bodies)));
  }
}
// A tessellation of a tangent shape need not touch itself; those with four points per side do, but for the lid that is
// tangent along an irrational line.
TEST(PatchShapesDiff, TessellationsOfBrokenShapesAreNot) {
  for (const auto& shape : patch_shapes::broken_shapes())
    EXPECT_EQ(decide_validity(tessellated(shape.patches, 4), {}).is_valid,
              shape.name == "lid-touching-in-an-irrational-line")
        << shape.name;
}

}  // namespace
}  // namespace veritope
