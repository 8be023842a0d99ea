// SPDX-License-Identifier: LGPL-3.0-or-later
// Models whose signs binary64 does not decide: the exact fallback does, and both checkers accept what it found.
#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "solids/patches/patch_transform.h"
#include "tests/certify/patch_checkers.h"

namespace veritope {
namespace {

using patch_shapes::Patches;
using patch_shapes::Point;

Rational ratio(std::int64_t p, std::int64_t q = 1) { return Rational(p) / Rational(q); }
Rational two_to(int n) { return Rational::power_of_two(n); }

// Where a tensor patch has a control point at `at`, its weight becomes `weight` there and 1 elsewhere. The curves stay straight, the image is the same.
Patches with_weight(const Patches& patches, const Point& at, const Rational& weight) {
  Patches out;
  for (const Patch& patch : patches) {
    const std::size_t n = patch.num_control();
    std::vector<Rational> c(4 * n);
    bool is_there = false;
    for (std::size_t i = 0; i < n; ++i) {
      bool is_here = true;
      for (int k = 0; k < 3; ++k)
        is_here = is_here && patch.component(k)[i] == at[static_cast<std::size_t>(k)];
      is_there = is_there || is_here;
      const Rational w = is_here ? weight : Rational(1);
      for (int k = 0; k < 3; ++k)
        c[static_cast<std::size_t>(k) * n + i] = w * patch.component(k)[i];
      c[3 * n + i] = w;
    }
    out.push_back(is_there ? make_patch(BezierSurface<Rational>(patch.tensor().degrees(), 4, true,
                                                                std::move(c)),
                                        patch.origin())
                                 .value()
                           : patch);
  }
  return out;
}

// A block of 4 x 4 squares a face; the middle of one face has this weight.
Patches weighted_block(const Rational& weight) {
  Patches block = patch_shapes::box({ratio(0), ratio(0), ratio(0)}, {ratio(1), ratio(1), ratio(1)});
  block = subdivided(subdivided(block));
  return with_weight(block, {ratio(1, 2), ratio(1, 2), ratio(1)}, weight);
}

// A tetrahedron; one face is cut at a point that lies `height` beside the middle of an edge, so that one of its triangles is a sliver.
// Directions and lengths are thirds and sevenths: nothing is exact in binary64.
Patches sliver_tetrahedron(const Rational& height) {
  const std::vector<Point> p = {{ratio(0), ratio(0), ratio(0)},
                                {ratio(1), ratio(1, 3), ratio(1, 7)},
                                {ratio(1, 3), ratio(1), ratio(-1, 7)},
                                {ratio(2, 7), ratio(1, 7), ratio(1)}};
  Point cut;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational middle = (p[0][k] + p[1][k]) / Rational(2);
    cut[k] = middle + height * (p[2][k] - middle);
  }
  const auto triangle = [](const Point& a, const Point& b, const Point& c) {
    std::vector<Rational> v;
    for (std::size_t k = 0; k < 3; ++k) v.insert(v.end(), {a[k], b[k], c[k]});
    return make_patch(BezierTriangle<Rational>(1, 3, false, std::move(v))).value();
  };
  return {triangle(p[1], p[0], cut),  triangle(p[0], p[2], cut),  triangle(p[2], p[1], cut),
          triangle(p[0], p[1], p[3]), triangle(p[1], p[2], p[3]), triangle(p[2], p[0], p[3])};
}

// A ball of radius 1 about the origin and one of this radius at (2, 1/3, 1/7).
Patches big_and_small(const Rational& radius) {
  return patch_shapes::joined(
      {patch_shapes::sphere(),
       patch_shapes::placed(patch_shapes::sphere(), radius, {ratio(2), ratio(1, 3), ratio(1, 7)})});
}

void expect_certified(const Patches& patches, std::uint64_t bodies, const std::string& what) {
  const CertifiedPatches c = certified_patches(patches);
  ASSERT_TRUE(c.decision.is_valid)
      << what << ": " << (c.decision.open ? c.decision.open->message : std::string("refuted"))
      << ", " << c.decision.boxes_tried << " boxes tried";
  EXPECT_EQ(c.decision.bodies, bodies) << what;
  for (const PatchShellFacts& s : c.decision.shells) EXPECT_EQ(s.genus, 0) << what;
  expect_accepted(c, what);
}

TEST(ExactCovers, WeightsFarApartInOnePatch) {
  for (const int exponent : {-60, 60, 200})
    expect_certified(weighted_block(two_to(exponent)), 1, "weight 2^" + std::to_string(exponent));
}

TEST(ExactCovers, SliversNarrowerThanBinary64) {
  for (const int exponent : {-45, -100})
    expect_certified(sliver_tetrahedron(two_to(exponent)), 1,
                     "height 2^" + std::to_string(exponent));
}

TEST(ExactCovers, PartsThatAreTinyBesideTheModel) {
  for (const int exponent : {-50})
    expect_certified(big_and_small(two_to(exponent)), 2, "radius 2^" + std::to_string(exponent));
}

// Two tiny cubes beside a cube, where doubles are about as coarse as the grids of boxes: what is found is a certificate.
TEST(ExactCovers, PartsAtTheEndOfBinary64AreCertifiedOrLeftOpen) {
  const Patches block =
      patch_shapes::box({ratio(-1), ratio(-1), ratio(-1)}, {ratio(0), ratio(0), ratio(0)});
  const std::vector<std::array<Point, 2>> places = {
      {Point{ratio(7, 3), ratio(1, 3), ratio(2, 7)},
       Point{ratio(-13, 3), ratio(5, 3), ratio(1, 7)}},
      {Point{ratio(47, 16), ratio(15, 16), ratio(0)},
       Point{ratio(25, 8), ratio(-1, 2), ratio(-1, 4)}},
      {Point{ratio(5, 2), ratio(3, 8), ratio(-1, 2)},
       Point{ratio(57, 16), ratio(-1, 16), ratio(15, 16)}}};
  std::size_t num_valid = 0;
  for (const int exponent : {-46, -47, -50})
    for (const auto& [a, b] : places) {
      const CertifiedPatches c = certified_patches(
          patch_shapes::joined({block, patch_shapes::placed(block, two_to(exponent), a),
                                patch_shapes::placed(block, two_to(exponent), b)}));
      EXPECT_FALSE(c.decision.refutation);
      if (!c.decision.is_valid) continue;
      ++num_valid;
      expect_accepted(c, "2^" + std::to_string(exponent));
    }
  EXPECT_GE(num_valid, 3u);
}

}  // namespace
}  // namespace veritope
