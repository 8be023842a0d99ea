// SPDX-License-Identifier: LGPL-3.0-or-later
// triangle_triangle, triangle_witness and segment_triangle against clipping over GMP's rationals,
// on all kinds of coordinates.
#include <gtest/gtest.h>

#include <algorithm>

#include "predicates/triangle_witness.h"
#include "tests/predicates/point_generators.h"
#include "tests/predicates/rational_clip_oracle.h"
#include "tests/predicates/test_scale.h"

namespace veritope {
namespace {

using generate::Points;

// A point of the triangle, or near it: so that touching, crossing and lying in one plane are
// common.
Vec3d affine(const std::array<Vec3d, 3>& t, Random& random) {
  const double s = std::ldexp(static_cast<double>(random.between(-2, 6)), -2),
               r = std::ldexp(static_cast<double>(random.between(-2, 6)), -2);
  return {t[0].x + s * (t[1].x - t[0].x) + r * (t[2].x - t[0].x),
          t[0].y + s * (t[1].y - t[0].y) + r * (t[2].y - t[0].y),
          t[0].z + s * (t[1].z - t[0].z) + r * (t[2].z - t[0].z)};
}
bool finite(const Vec3d& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

struct Pair {
  IndexedTriangle t, u;
};

bool draw(generate::Kind kind, Random& random, Pair& out) {
  const Points p = generate::points(kind, random), q = generate::points(kind, random);
  out.t = {{p[0], p[1], p[2]}, {0, 1, 2}};
  out.u = {{p[3], p[4], q[0]}, {3, 4, 5}};
  for (int i = 0; i < 3; ++i) {
    if (random.below(3) == 0) out.u.point[i] = affine(out.t.point, random);
    if (!finite(out.u.point[i])) out.u.point[i] = q[i];
  }
  for (std::uint64_t common = random.below(3), i = 0; i < common; ++i)
    out.u.point[i] = out.t.point[i], out.u.id[i] = out.t.id[i];
  const std::uint64_t turn = random.below(3);
  std::rotate(out.u.point.begin(), out.u.point.begin() + turn, out.u.point.end());
  std::rotate(out.u.id.begin(), out.u.id.begin() + turn, out.u.id.end());
  if (random.below(2) == 0)
    std::swap(out.u.point[0], out.u.point[1]), std::swap(out.u.id[0], out.u.id[1]);
  return !oracle::degenerate(out.t.point) && !oracle::degenerate(out.u.point);
}

std::string text(const IndexedTriangle& t) {
  return generate::text({t.point[0], t.point[1], t.point[2], {}, {}}) + std::to_string(t.id[0]) +
         " " + std::to_string(t.id[1]) + " " + std::to_string(t.id[2]) + "\n";
}

TEST(TriangleDifferential, ContactsAgreeWithRationalClipping) {
  std::array<long, 6> seen{};
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    Random random(77u + static_cast<unsigned>(kind));
    for (long i = 0; i < scaled(1500); ++i) {
      Pair pair;
      if (!draw(static_cast<generate::Kind>(kind), random, pair)) continue;
      const TriangleContact expected = oracle::contact(pair.t, pair.u);
      ++seen[static_cast<std::size_t>(expected)];
      ASSERT_EQ(triangle_triangle(pair.t, pair.u), expected)
          << generate::kKindNames[kind] << ' ' << i << '\n'
          << text(pair.t) << text(pair.u);
      ASSERT_EQ(triangle_triangle(pair.u, pair.t), expected)
          << generate::kKindNames[kind] << ' ' << i << '\n'
          << text(pair.u) << text(pair.t);
    }
  }
  for (int c = 0; c < 5; ++c) EXPECT_GT(seen[c], 50) << "contact " << c;
}

TEST(TriangleDifferential, WitnessesLieInBothTriangles) {
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    Random random(99u + static_cast<unsigned>(kind));
    for (long i = 0; i < scaled(400); ++i) {
      Pair pair;
      if (!draw(static_cast<generate::Kind>(kind), random, pair)) continue;
      const TriangleContact c = triangle_triangle(pair.t, pair.u);
      if (c != TriangleContact::kImproper && c != TriangleContact::kCoplanarOverlap) continue;
      const TriangleWitness w = triangle_witness(pair.t, pair.u);
      bool outside = false;
      const auto check = [&](const std::array<Integer, 3>& weight, const IndexedTriangle& a,
                             const IndexedTriangle& b) {
        Integer sum;
        for (int k = 0; k < 3; ++k) {
          ASSERT_NE(weight[k].sign(), Sign::kNegative);
          sum += weight[k];
          const bool shared = std::find(b.id.begin(), b.id.end(), a.id[k]) != b.id.end();
          outside = outside || (!shared && !weight[k].is_zero());
        }
        for (int axis = 0; axis < 3; ++axis) {
          Rational v;
          for (int k = 0; k < 3; ++k)
            v += Rational(weight[k]) * Rational::from_double(a.point[k][axis]);
          ASSERT_EQ(v, w.point[axis] * Rational(sum));
        }
      };
      check(w.t_weight, pair.t, pair.u);
      check(w.u_weight, pair.u, pair.t);
      ASSERT_TRUE(outside) << generate::kKindNames[kind] << ' ' << i << '\n'
                           << text(pair.t) << text(pair.u);
    }
  }
}

TEST(TriangleDifferential, SegmentsAgreeWithRationalClipping) {
  std::array<long, 5> seen{};
  for (int kind = 0; kind < generate::kNumKinds; ++kind) {
    Random random(55u + static_cast<unsigned>(kind));
    for (long i = 0; i < scaled(1000); ++i) {
      const Points p = generate::points(static_cast<generate::Kind>(kind), random);
      const std::array<Vec3d, 3> t{p[0], p[1], p[2]};
      if (oracle::degenerate(t)) continue;
      Vec3d a = p[3], b = p[4];
      if (random.below(3) == 0) a = affine(t, random);
      if (random.below(3) == 0) b = affine(t, random);
      if (!finite(a) || !finite(b)) continue;
      const SegmentTriangleContact expected = oracle::contact(a, b, t),
                                   got = segment_triangle(a, b, t);
      ++seen[static_cast<std::size_t>(expected.kind)];
      ASSERT_EQ(got, expected) << generate::kKindNames[kind] << ' ' << i << ": "
                               << generate::text({t[0], t[1], t[2], a, b});
    }
  }
  for (int c = 0; c < 5; ++c) EXPECT_GT(seen[c], 25) << "kind " << c;
}

}  // namespace
}  // namespace veritope
