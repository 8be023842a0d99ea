// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/points_certifier.h"

#include <gtest/gtest.h>

#include "io/mesh/reading_rule.h"
#include "io/read_model.h"
#include "solids/classify/mesh_classifier.h"
#include "tests/support/paths.h"
#include "verify/format/claims.h"
#include "verify/format/sha256.h"

namespace veritope {
namespace {

// A box as an OFF file, and points of it with their answers.
struct Case {
  MeshFile file;
  std::vector<Vec3d> points;
  std::vector<PointAnswer> answers;
};

Case box_case(std::vector<Vec3d> points) {
  std::string off = "OFF\n8 6 0\n";
  for (int i = 0; i < 8; ++i)
    off += std::to_string(i & 1) + " " + std::to_string(i >> 1 & 1) + " " + std::to_string(i >> 2) +
           "\n";
  off += "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 1 3 7 5\n4 3 2 6 7\n4 2 0 4 6\n";
  ModelReadOptions how;
  how.format = MeshFormat::kOff;
  ModelFile model =
      read_model_bytes({reinterpret_cast<const unsigned char*>(off.data()), off.size()}, "box.off",
                       how)
          .value();
  Case out{std::get<MeshFile>(std::move(model)), std::move(points), {}};
  const MeshClassifier classifier = std::move(MeshClassifier::make(out.file.mesh).value());
  for (const Vec3d& p : out.points) out.answers.push_back(classifier.classify(p));
  return out;
}

certificate::PointsBody body_of(const Case& c) {
  PointsCertifier certifier(c.file, 1);
  certifier.add(c.points, c.answers);
  certificate::Subject subject;
  subject.reading_rule = kReadingRule;
  subject.format = "off";
  const certificate::Bytes bytes = certifier.finish(subject, {}).value();
  std::string why;
  const auto decoded = certificate::decode_certificate(bytes, why);
  EXPECT_TRUE(decoded) << why;
  EXPECT_EQ(decoded->claim->name, "points-1");
  return std::get<certificate::PointsBody>(decoded->body);
}

TEST(PointsCertifier, HasADirectionForPointsOffAndAFacetForPointsOn) {
  const Case c = box_case({{.5, .5, .5}, {2, 2, 2}, {1, .5, .25}, {0, 0, 0}});
  const certificate::PointsBody body = body_of(c);
  EXPECT_EQ(body.num_faces, 12u);
  EXPECT_EQ(body.num_vertex_ids, 8u);
  EXPECT_EQ(body.num_points, 4u);
  ASSERT_EQ(body.codes.size(), 4u);
  EXPECT_LE(body.codes[0], 5);
  EXPECT_LE(body.codes[1], 5);
  EXPECT_EQ(body.codes[2], c.answers[2].facet);
  EXPECT_EQ(body.codes[3], c.answers[3].facet);
}

TEST(PointsCertifier, TakesADirectionWithFewFacetsOnItsWay) {
  // Beside the box, a ray towards it meets two facets of each side, and one away from it none.
  for (int axis = 0; axis < 3; ++axis)
    for (const double at : {-1.0, 2.0}) {
      double p[3] = {.375, .25, .4375};
      p[axis] = at;
      const certificate::PointsBody body = body_of(box_case({{p[0], p[1], p[2]}}));
      ASSERT_EQ(body.codes.size(), 1u);
      EXPECT_LE(body.codes[0], 5);
    }
}

TEST(PointsCertifier, AddsBatchesInOrder) {
  const Case c = box_case({{.5, .5, .5}, {1, .5, .25}, {2, 2, 2}, {.25, .75, 1}});
  PointsCertifier certifier(c.file, 1);
  for (std::size_t i = 0; i < c.points.size(); ++i)
    certifier.add(std::span(c.points).subspan(i, 1), std::span(c.answers).subspan(i, 1));
  const certificate::Bytes bytes = certifier.finish({}, {}).value();
  std::string why;
  const auto decoded = certificate::decode_certificate(bytes, why);
  ASSERT_TRUE(decoded) << why;
  EXPECT_EQ(std::get<certificate::PointsBody>(decoded->body).codes, body_of(c).codes);
}

}  // namespace
}  // namespace veritope
