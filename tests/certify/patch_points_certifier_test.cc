// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/patch_points_certifier.h"

#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "splines/de_casteljau.h"
#include "tests/certify/patch_round_trip.h"
#include "verify/format/claims.h"

namespace veritope {
namespace {

struct Case {
  SplineFile file;
  FilePatches patches;
  explicit Case(const std::vector<Patch>& shape)
      : file(spline_file_of(spline_json_bytes(model_of(shape)))),
        patches(file_patches(file.model, PatchOrientation::kKeep).value()) {}
};

// In batches of one point if `one_by_one`.
certificate::PointsBody body_of(const Case& c, const std::vector<ExactPoint>& exact,
                                bool one_by_one = false) {
  const PatchClassifier classifier = PatchClassifier::make(*c.patches.complex, false);
  PatchPointsCertifier certifier(c.patches, classifier);
  std::vector<Vec3d> points;
  std::vector<std::pair<std::size_t, ExactPoint>> all;
  std::vector<PointAnswer> answers;
  for (const ExactPoint& p : exact) {
    points.push_back({nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])});
    all.emplace_back(all.size(), p);
    answers.push_back(classifier.classify(p));
  }
  if (!one_by_one) {
    certifier.add(points, all, answers);
  } else {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::pair<std::size_t, ExactPoint> one{0, exact[i]};
      certifier.add(std::span(points).subspan(i, 1), std::span(&one, 1),
                    std::span(answers).subspan(i, 1));
    }
  }
  const certificate::Bytes bytes = certifier.finish(subject_of(c.file, "tests"), {}).value();
  std::string why;
  const auto decoded = certificate::decode_certificate(bytes, why);
  EXPECT_TRUE(decoded) << why;
  EXPECT_EQ(decoded->claim->name, "points-1");
  return std::get<certificate::PointsBody>(decoded->body);
}

const Rational kThird = Rational(1) / 3, kHalf = Rational(1) / 2;

TEST(PatchPointsCertifier, HasTheDirectionInWhichTheModelEndsSoonest) {
  const Case c(patch_shapes::box({0, 0, 0}, {1, 1, 1}));
  const Rational near = Rational(1) / 8, far = Rational(7) / 8;
  const certificate::PointsBody body = body_of(c, {{far, kHalf, kHalf},
                                                   {near, kHalf, kHalf},
                                                   {kHalf, far, kThird},
                                                   {kHalf, near, kThird},
                                                   {kThird, kHalf, far},
                                                   {kThird, kHalf, near},
                                                   {kHalf, 5, kHalf}});
  EXPECT_EQ(body.num_faces, 6u);
  EXPECT_EQ(body.num_vertex_ids, 6u);
  EXPECT_EQ(body.num_points, 7u);
  ASSERT_GE(body.codes.size(), 7u);
  const certificate::Bytes codes(body.codes.end() - 7, body.codes.end());
  EXPECT_EQ(codes, (certificate::Bytes{0, 1, 2, 3, 4, 5, 2}));
}

TEST(PatchPointsCertifier, HasThePatchAndTheParametersOfAPointOnIt) {
  const Case c(patch_shapes::box({0, 0, 0}, {1, 1, 1}));
  const certificate::PointsBody body = body_of(c, {{1, kThird, kHalf}});
  certificate::PatchCodes none(to_certificate(c.patches.entities));
  const std::size_t breaks = none.take().size();
  // Patch, kind, and two numbers of two bytes each.
  ASSERT_EQ(body.codes.size(), breaks + 6);
  const std::uint32_t patch = body.codes[breaks];
  EXPECT_EQ(body.codes[breaks + 1], 0);
  const auto number = [&](std::size_t at) {
    return Rational(body.codes[breaks + at] / 2) / body.codes[breaks + at + 1];
  };
  const std::vector<Rational> q =
      evaluate(c.patches.complex->patch(patch).tensor(), {number(2), number(4)});
  EXPECT_EQ(q, (std::vector<Rational>{1, kThird, kHalf}));
}

TEST(PatchCodes, WriteParametersThatAreNotRationalAsPolynomials) {
  certificate::PatchCodes codes({});
  const auto number = [](int n) {
    const certificate::Natural size = n == 0 ? certificate::Natural() : certificate::Natural{1};
    return certificate::Fraction{n < 0, size, {1}};
  };
  codes.add(certificate::AlgebraicPointOnPatch{200,
                                               {number(-1), number(1)},
                                               {number(0), number(1)},
                                               {{{number(0), number(1)}, {number(1)}}}});
  EXPECT_EQ(codes.take(), (certificate::Bytes{200, 1, 1,        //
                                              1,   1, 1, 2, 1,  // -1 + t
                                              0,   1, 2, 1,     // [0, 1]
                                              1,   0, 1, 2, 1,  // t
                                              0,   2, 1}));     // 1
}

TEST(PatchPointsCertifier, AddsBatchesInOrder) {
  const Case c(patch_shapes::octant_sphere());
  const std::vector<ExactPoint> points{
      {0, 0, 0}, {0, 0, 1}, {2, 0, 0}, {Rational(3) / 5, Rational(4) / 5, 0}, {kThird, kThird, 0}};
  const certificate::PointsBody body = body_of(c, points);
  EXPECT_EQ(body.codes, body_of(c, points, true).codes);
  EXPECT_EQ(body.num_points, 5u);
}

}  // namespace
}  // namespace veritope
