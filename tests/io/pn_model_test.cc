// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/pn_model.h"

#include "splines/pn_triangle.h"
#include "tests/io/io_test_util.h"

namespace veritope {
namespace {

// A tetrahedron whose normals are its corners, with lengths 1, 2, 1/4 and 3.
const std::string kVertices = "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\n";
const std::string kNormals = "vn 1 1 1\nvn -2 -2 2\nvn -.25 .25 -.25\nvn 3 -3 -3\n";
const std::string kFaces =
    "f 1//1 3//3 2//2\nf 1//1 2//2 4//4\nf 1//1 4//4 3//3\nf 2//2 3//3 4//4\n";

Result<SplineModel> model_of_text(const std::string& text) {
  ModelReadOptions options;
  options.with_normals = true;
  const auto file = io_test::read(MeshFormat::kObj, text, options);
  EXPECT_TRUE(file) << text;
  return pn_model(*file);
}

std::vector<Rational> coefficients(const SplineEntity& entity) {
  const auto& triangle = std::get<ExactTriangle>(entity.shape);
  return {triangle.coefficients().begin(), triangle.coefficients().end()};
}

TEST(PnModel, TakesTheNormalsOfTheFile) {
  const auto model = model_of_text(kVertices + kNormals + kFaces);
  ASSERT_TRUE(model);
  ASSERT_EQ(model->entities.size(), 4u);
  const std::array<PnPoint, 3> corners = {{{Rational(1), Rational(1), Rational(1)},
                                           {Rational(-1), Rational(1), Rational(-1)},
                                           {Rational(-1), Rational(-1), Rational(1)}}};
  const auto want = make_pn_triangle(corners, corners);
  ASSERT_TRUE(want);
  const std::vector<Rational> got = coefficients(model->entities[0]);
  EXPECT_TRUE(std::equal(got.begin(), got.end(), want->points.coefficients().begin(),
                         want->points.coefficients().end()));
}

TEST(PnModel, TakesSumsOverTrianglesWithoutNormals) {
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const auto own = model_of_text(kVertices + kNormals + kFaces),
             sums = model_of_text(kVertices + kNormals + faces);
  ASSERT_TRUE(own);
  ASSERT_TRUE(sums);
  for (std::size_t f = 0; f < 4; ++f)  // by symmetry sums point along the corners, too
    EXPECT_EQ(coefficients(own->entities[f]), coefficients(sums->entities[f]));
}

TEST(PnModel, RefusesNormalsThatDoNotFitWithFaceAndVertex) {
  const auto refusal = [](const std::string& faces, const std::string& normals = kNormals) {
    const auto model = model_of_text(kVertices + normals + faces);
    return model ? "none" : to_string(model.error());
  };
  EXPECT_EQ(refusal("f 1//1 3//3 2//2\nf 1//1 2//2 4//4\nf 1//1 4//4 3//2\nf 2//2 3//3 4//4\n"),
            "face 2: vertex 2: the vertex has two normals that differ: the patches would not fit");
  EXPECT_EQ(refusal("f 1//1 3//3 2//2\nf 1//1 2//2 4\nf 1//1 4//4 3//3\nf 2//2 3//3 4//4\n"),
            "face 1: vertex 3: the corner has no normal, and others have one");
  EXPECT_EQ(refusal(kFaces, "vn 1 1 1\nvn 0 0 0\nvn -1 1 -1\nvn 1 -1 -1\n"),
            "face 0: vertex 1: the normal of corner 2 is zero");
  EXPECT_EQ(refusal(kFaces, "vn -1 -1 -1\nvn -1 -1 1\nvn -1 1 -1\nvn 1 -1 -1\n").substr(0, 17),
            "face 0: vertex 0:");
  // Equal normals may be listed twice.
  EXPECT_EQ(refusal("f 1//1 3//3 2//2\nf 1//5 2//2 4//4\nf 1//1 4//4 3//3\nf 2//2 3//3 4//4\n",
                    kNormals + "vn 1 1 1.0\n"),
            "none");
}

}  // namespace
}  // namespace veritope
