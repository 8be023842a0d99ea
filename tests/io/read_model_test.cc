// SPDX-License-Identifier: LGPL-3.0-or-later
// The front door: every format by name, ending and content, and what is refused.
#include "io/read_model.h"

#include "io/formats.h"
#include "tests/io/io_test_util.h"

namespace veritope {
namespace {

const std::string kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const std::string kG2 = "100 1 0 0\n1 0\n2 2\n0 0 1 1\n0\n1\n";

Result<ModelFile> read_as(const std::string& name, std::string_view text,
                          const ModelReadOptions& options = {}) {
  return read_model_bytes(io_test::bytes(text), name, options);
}

TEST(ReadModel, TheAlternativeIsTheKindOfTheFormat) {
  const auto mesh = read_as("x", kObj), splines = read_as("x", kG2);
  ASSERT_TRUE(mesh.has_value() && splines.has_value());
  EXPECT_EQ(kind_of(*mesh), ModelKind::kMesh);
  EXPECT_EQ(kind_of(*splines), ModelKind::kSplines);
  EXPECT_EQ(format_of(*mesh), FormatId(MeshFormat::kObj));
  EXPECT_EQ(format_of(*splines), FormatId(SplineFormat::kG2));
  EXPECT_EQ(num_bytes(*splines), kG2.size());
  EXPECT_EQ(sha256_of(*mesh), std::get<MeshFile>(*mesh).sha256);
  EXPECT_EQ(sha256_of(*mesh).size(), 64u);
}

}  // namespace
}  // namespace veritope
