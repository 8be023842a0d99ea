// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/solid_patches.h"

#include <gtest/gtest.h>

#include <string>

#include "io/read_model.h"
#include "io/splines/patch_model.h"
#include "io/splines/write_splines.h"
#include "models/patch_shapes.h"

namespace veritope {
namespace {

SplineFile file_with(const SplineModel& model) {
  const std::string bytes = spline_json_bytes(model);
  return read_spline_bytes({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()},
                           "solid.vjson", {})
      .value();
}
SplineFile file_with(const patch_shapes::Patches& patches) { return file_with(model_of(patches)); }
std::string code_of(const SplineFile& file) {
  const auto found = solid_patches_of(file, {});
  const auto* const finding = std::get_if<Finding>(&found);
  return finding == nullptr ? "" : finding->code;
}

TEST(SolidPatches, HaveABodyOfVersionTwoWhereVersionOneWouldDo) {
  for (const auto& shape :
       {patch_shapes::box({0, 0, 0}, {1, 1, 1}), patch_shapes::octant_sphere(),
        patch_shapes::thin_shell(Rational(1) / Rational(8)), patch_shapes::torus(3, 1)}) {
    const auto found = solid_patches_of(file_with(shape), {});
    ASSERT_TRUE(std::holds_alternative<SolidPatches>(found)) << std::get<Finding>(found).message;
    const auto& solid = std::get<SolidPatches>(found);
    EXPECT_EQ(solid.format, "vjson");
    EXPECT_EQ(solid.body.version, 2);
    EXPECT_EQ(solid.body.entities.size(), shape.size());
    for (const certificate::PatchEntity& e : solid.body.entities) EXPECT_FALSE(e.is_reversed);
    EXPECT_EQ(solid.patches.complex->patches().size(), shape.size());
  }
}

TEST(SolidPatches, AreNotReversed) {
  EXPECT_EQ(code_of(file_with(patch_shapes::reversed(patch_shapes::sphere()))), "model-invalid");
  patch_shapes::Patches one = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  one[2] = reversed(one[2]);
  EXPECT_EQ(code_of(file_with(one)), "model-invalid");
}

TEST(SolidPatches, BoundASolid) {
  patch_shapes::Patches open = patch_shapes::box({0, 0, 0}, {1, 1, 1});
  open.pop_back();
  const auto found = solid_patches_of(file_with(open), {});
  ASSERT_TRUE(std::holds_alternative<Finding>(found));
  EXPECT_EQ(std::get<Finding>(found).code, "model-invalid");
  EXPECT_EQ(std::get<Finding>(found).message.substr(0, 21), "the model is INVALID:");
  const auto crossing =
      patch_shapes::joined({patch_shapes::sphere(), patch_shapes::box({0, 0, 0}, {2, 2, 2})});
  EXPECT_EQ(code_of(file_with(crossing)), "model-invalid");
  CertifyOptions few;
  few.max_cells = 1;
  const auto open_question = solid_patches_of(file_with(patch_shapes::torus(3, 1)), few);
  ASSERT_TRUE(std::holds_alternative<Finding>(open_question));
  EXPECT_EQ(std::get<Finding>(open_question).message.substr(0, 23), "the model is UNDECIDED:");
}

TEST(SolidPatches, AreInTheFilesOwnBytes) {
  SplineFile file = file_with(patch_shapes::sphere());
  file.format = SplineFormat::kGismo;
  EXPECT_EQ(code_of(file), "not-covered");
  file = file_with(patch_shapes::sphere());
  file.beyond_default_limits = Error{Code::kOverLimit, {}, "long"};
  EXPECT_EQ(code_of(file), "not-covered");
  EXPECT_EQ(code_of(file_with(SplineModel())), "not-covered");
}

}  // namespace
}  // namespace veritope
