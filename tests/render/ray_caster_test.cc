// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "render/parallel_view_internal.h"
#include "render/ray_caster_internal.h"
#include "robust/base/random.h"
#include "tests/render/solid_probe_test_util.h"

namespace veritope::internal {
namespace {

using picture_test::BallProbe;
using picture_test::FalseWallProbe;
using picture_test::SlabProbe;

Box3d cube_box(double lo, double hi) { return {{lo, lo, lo}, {hi, hi, hi}}; }

// Sides of samples are 1 in the units of t: rays have steps of length 1 up to rounding.
ParametricRay ray_along(const Point3d& origin, const Point3d& direction, double sample) {
  double length = 0;
  for (const double x : direction) length += x * x;
  length = std::sqrt(length);
  ParametricRay out{origin, direction};
  for (double& x : out.step) x *= sample / length;
  return out;
}

Rational dot(const ExactPoint& a, const ExactPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
ExactPoint exact(const Point3d& p) {
  return {Rational::from_double(p[0]), Rational::from_double(p[1]), Rational::from_double(p[2])};
}

// |o|^2 |d|^2 - (o.d)^2 - r^2 |d|^2: negative if the line meets the open ball.
Rational gap(const ParametricRay& ray, const Rational& radius) {
  const ExactPoint o = exact(ray.origin), d = exact(ray.step);
  const Rational od = dot(o, d);
  return dot(o, o) * dot(d, d) - od * od - radius * radius * dot(d, d);
}

// The exact first intersection lies within the tolerance before the hit.
TEST(RayCaster, HitsABallWhereItsEquationSays) {
  const BallProbe ball(Rational(1));
  const double sample = 1.0 / 64;
  const ValueCells cells(ball, cube_box(-1, 1), 9 * sample, 1, nullptr);
  const RayCaster caster(ball, cells);
  Random random(17);
  const auto coordinate = [&] { return static_cast<double>(random.between(-1000, 1000)) / 500; };
  int hits = 0, misses = 0;
  for (int i = 0; i < 1500; ++i) {
    const Point3d through = {0.6 * coordinate(), 0.6 * coordinate(), 0.6 * coordinate()},
                  direction = {coordinate() + 0.001, coordinate(), coordinate()};
    ParametricRay ray = ray_along(through, direction, sample);
    for (std::size_t k = 0; k < 3; ++k) ray.origin[k] -= 400 * ray.step[k];
    std::optional<double> guess;
    if (i % 3 == 1) guess = static_cast<double>(random.between(0, 800));
    const auto hit = caster.first_hit(ray, guess).hit;
    const Rational near = gap(ray, Rational(1) + Rational(1) / Rational(512));
    if (!hit) {
      EXPECT_GE(gap(ray, Rational(1)), Rational(0)) << i;
      ++misses;
      continue;
    }
    ++hits;
    EXPECT_LT(near, Rational(0)) << i;
    if (!(gap(ray, Rational(1)) < Rational(0))) continue;
    // The quadratic has its smaller root in (t - tolerance, t], or both roots lie that near.
    const auto at = [&](double t) {
      const ExactPoint o = exact(ray.origin), d = exact(ray.step);
      const Rational s = Rational::from_double(t);
      return dot(o, o) + Rational(2) * s * dot(o, d) + s * s * dot(d, d) - Rational(1);
    };
    const double kSlack = 0x1p-30;
    if (at(hit->t + kSlack) < Rational(0)) {
      EXPECT_GT(at(hit->t - RayCaster::kTolerance - kSlack), Rational(0)) << i;
      const double od = nearest_double(dot(exact(ray.origin), exact(ray.step)));
      const double dd = nearest_double(dot(exact(ray.step), exact(ray.step)));
      EXPECT_LT(hit->t, -od / dd + kSlack) << "not on the far side";
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_GT(misses, 300);
}

// Every sample of the picture of a ball, against the exact distance of its ray from the middle.
TEST(RayCaster, TheSilhouetteOfABallHasTheRightSamples) {
  const BallProbe ball(Rational(1));
  const ParallelView view(cube_box(-1, 1), {3, 5, -4}, {0, 0, 30, 30});
  const ValueCells cells(ball, cube_box(-1, 1), 9 * view.sample_side(), 1, nullptr);
  const RayCaster caster(ball, cells);
  const Rational wider =
      Rational(1) + Rational::from_double(RayCaster::kThinnest * 2 * view.sample_side());
  int shown = 0, inside = 0;
  for (int row = 0; row < 90; ++row)
    for (int column = 0; column < 90; ++column) {
      const Point3d& toward = view.toward();
      const ParametricRay ray{view.to_space({column + 0.5, row + 0.5, 0}),
                              {-toward[0], -toward[1], -toward[2]}};
      const bool is_hit = caster.first_hit(ray, std::nullopt).hit.has_value();
      const bool is_inside = gap(ray, Rational(1)) < Rational(0);
      if (is_inside) {
        EXPECT_TRUE(is_hit) << column << " " << row;
      }
      if (is_hit) {
        EXPECT_LT(gap(ray, wider), Rational(0)) << column << " " << row;
      }
      shown += is_hit ? 1 : 0, inside += is_inside ? 1 : 0;
    }
  EXPECT_GT(inside, 1000);
  EXPECT_LE(shown - inside, 40);
}

// However thin, and from every side.
TEST(RayCaster, FindsPlatesThatAreThinnerThanSteps) {
  for (const double thickness : {1.0, 1e-3, 1e-9, 0x1p-52}) {
    const SlabProbe plate(2, 0.5, 0.5 + thickness);
    const ValueCells cells(plate, cube_box(-1, 2), 0.09, 1, nullptr);
    const RayCaster caster(plate, cells);
    for (const Point3d& direction : {Point3d{0, 0, 1}, {0.3, 0.1, -1}, {0.9, 0, 0.2}}) {
      const ParametricRay ray =
          ray_along({0.2 - direction[0], 0.3 - direction[1], 0.5 - direction[2]}, direction, 0.01);
      const auto hit = caster.first_hit(ray, std::nullopt).hit;
      ASSERT_TRUE(hit) << thickness;
      const double z = ray.at(hit->t).z,
                   distance = direction[2] > 0 ? z - 0.5 : 0.5 + thickness - z;
      EXPECT_LT(std::abs(distance), 0.01 * RayCaster::kThinnest * 2) << thickness;
    }
  }
}

TEST(RayCaster, DoesNotHitWallsThatTheSolidDoesNotHave) {
  const FalseWallProbe none(0, 0.25);
  const ValueCells cells(none, cube_box(-1, 1), 0.09, 1, nullptr);
  const RayCaster caster(none, cells);
  EXPECT_FALSE(caster.first_hit(ray_along({-2, 0.1, 0.2}, {1, 0, 0}, 0.01), std::nullopt).hit);
  EXPECT_FALSE(caster.first_hit(ray_along({-2, 0.1, 0.2}, {1, 0.1, 0.2}, 0.01), 200).hit);
}

TEST(RayCaster, TellsCutsFromSurfaces) {
  const SlabProbe plate(0, -1, 0.5);
  const auto hit_from = [&](const Box3d& box, double x) {
    const ValueCells cells(plate, box, 0.09, 1, nullptr);
    return RayCaster(plate, cells)
        .first_hit(ray_along({x, 0.1, 0.2}, {x < 0 ? 1.0 : -1.0, 0, 0}, 0.01), std::nullopt)
        .hit;
  };
  const auto cut = hit_from(cube_box(0, 1), -3);
  ASSERT_TRUE(cut);
  EXPECT_TRUE(cut->is_cut);
  EXPECT_EQ(cut->t, 300);
  const auto at_side = hit_from({{-1, 0, 0}, {1, 1, 1}}, -3);
  ASSERT_TRUE(at_side);
  EXPECT_FALSE(at_side->is_cut) << "the side of the box is the surface";
  const auto behind = hit_from(cube_box(0, 1), 3);
  ASSERT_TRUE(behind);
  EXPECT_FALSE(behind->is_cut);
  EXPECT_NEAR(behind->t, 250, RayCaster::kTolerance);
}

TEST(ValueCells, CoverTheBoxAndAreTheSameForEveryNumberOfThreads) {
  const BallProbe ball(Rational(1));
  const ValueCells one(ball, {{-1, -1, -1}, {1, 1, 0.25}}, 0.125, 1, nullptr),
      two(ball, {{-1, -1, -1}, {1, 1, 0.25}}, 0.125, 2, nullptr);
  EXPECT_EQ(one.num_cells(), two.num_cells());
  EXPECT_EQ(one.solid_boxes(), two.solid_boxes());
  const std::vector<Box3d> boxes = one.solid_boxes();
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    Point3d p;
    for (double& x : p) x = static_cast<double>(random.between(-1000, 250)) / 1000;
    if (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] > 1) continue;
    const bool is_covered = std::any_of(boxes.begin(), boxes.end(), [&](const Box3d& box) {
      return is_inside({p, p}, box);
    });
    EXPECT_TRUE(is_covered);
  }
}

// Pieces follow each other along the ray; what lies between them is off the solid.
TEST(ValueCells, WalksAlongRays) {
  const BallProbe ball(Rational(1));
  const ValueCells cells(ball, cube_box(-1, 1), 0.0625, 1, nullptr);
  Random random(6);
  const auto coordinate = [&] { return static_cast<double>(random.between(-100, 100)) / 100; };
  for (int i = 0; i < 300; ++i) {
    const ParametricRay ray = ray_along(
        {coordinate(), coordinate(), coordinate()},
        {coordinate(), i % 5 == 0 ? 0 : coordinate(), i % 7 == 1 ? 0 : coordinate() + 0.001}, 0.01);
    if (ray.step == Point3d{0, 0, 0}) continue;
    double last = cells.clipped(ray).begin;
    std::vector<RayPiece> pieces;
    cells.walk(ray, [&](const RayPiece& piece) {
      EXPECT_LE(last, piece.begin);
      EXPECT_LE(piece.begin, piece.end);
      last = piece.end;
      pieces.push_back(piece);
      return false;
    });
    for (double t = cells.clipped(ray).begin + 0.5; t < cells.clipped(ray).end; t += 7) {
      const bool is_met = std::any_of(pieces.begin(), pieces.end(), [t](const RayPiece& piece) {
        return piece.begin - 1e-6 <= t && t <= piece.end + 1e-6;
      });
      if (!is_met) {
        EXPECT_EQ(ball.word(ray.at(t)), PointWord::kOut);
      }
      for (const RayPiece& piece : pieces)
        if (piece.value == Value3::kOne && piece.begin + 1e-6 < t && t < piece.end - 1e-6) {
          EXPECT_EQ(ball.word(ray.at(t)), PointWord::kIn);
        }
    }
  }
}

}  // namespace
}  // namespace veritope::internal
