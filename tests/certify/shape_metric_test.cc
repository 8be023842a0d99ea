// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/shape_metric.h"

#include <gtest/gtest.h>

#include "models/thin_shapes.h"
#include "solids/patches/patch_complex.h"
#include "solids/patches/patch_transform.h"
#include "verify/certify/sheet_tangents_internal.h"

namespace veritope {
namespace {

using patch_shapes::Patches;

struct Measured {
  PatchComplex complex;
  PieceForest forest;
  ShapeMetric metric;
  explicit Measured(const Patches& patches)
      : complex(make_patch_complex(patches).value()),
        forest(PieceForest::make(complex, PieceForest::FrameChoice::kWhole).value()),
        metric(forest) {}
};

// The control points of all patches, in the forest's coordinates.
std::vector<Point3d> points_of(const PieceForest& forest) {
  std::vector<Point3d> out;
  for (std::uint32_t p = 0; p < forest.num_patches(); ++p) {
    const PieceForest::Form& form = forest.form(p);
    const std::size_t n = form.shape.count();
    for (std::size_t i = 0; i < n; ++i) {
      Point3d x = form.origin;
      for (std::size_t k = 0; k < 3; ++k)
        x[k] +=
            form.root_control[k * n + i] / (form.is_rational ? form.root_control[3 * n + i] : 1);
      out.push_back(x);
    }
  }
  return out;
}
Point3d difference(const Point3d& a, const Point3d& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Patches image(const Patches& patches, std::vector<Rational> linear) {
  return affine_image(patches, {3, 3, std::move(linear), {1, 2, 3}}).value();
}
Patches tube() {
  return thin_shapes::cone(1, Rational(1) / Rational(8), Rational(1) / Rational(8));
}

TEST(ShapeMetric, GivesTheControlPointsTheCovarianceOne) {
  const Measured m(image(tube(), {1, 8, 0, 0, 3, 0, -2, 0, 5}));
  const std::vector<Point3d> points = points_of(m.forest);
  const auto count = static_cast<double>(points.size());
  Point3d middle{};
  for (const Point3d& x : points)
    for (std::size_t k = 0; k < 3; ++k) middle[k] += x[k] / count;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      double sum = 0;
      for (const Point3d& x : points) {
        const Point3d y = m.metric.image(difference(x, middle));
        sum += y[i] * y[k] / count;
      }
      EXPECT_NEAR(sum, i == k ? 1 : 0, 1e-9) << i << ", " << k;
    }
}

TEST(ShapeMetric, GivesAffineImagesTheSameLengths) {
  const Patches patches = tube();
  const Measured plain(patches);
  const std::vector<Point3d> x = points_of(plain.forest);
  for (const std::vector<Rational>& linear : {std::vector<Rational>{1, 0, 0, 0, 1, 0, 1024, 0, 1},
                                              {1, 8, 0, 0, 3, 0, -2, 0, 5},
                                              {2, -1, 2, 2, 2, -1, -1, 2, 2}}) {
    const Measured sheared(image(patches, linear));
    const std::vector<Point3d> y = points_of(sheared.forest);
    ASSERT_EQ(x.size(), y.size());
    for (std::size_t i = 1; i < x.size(); ++i) {
      const double length = plain.metric.length(difference(x[i], x[0]));
      EXPECT_NEAR(sheared.metric.length(difference(y[i], y[0])), length, 1e-6)
          << "point " << i << ", map " << linear[6].to_string();
    }
  }
}

TEST(ShapeMetric, KeepsNormalsAndRowsOnTheirPlanes) {
  const Measured m(image(tube(), {1, 8, 0, 0, 3, 0, -2, 0, 5}));
  const Point3d u{1, 2, -3}, v{0, 5, 4}, row{7, -1, 2};
  const Point3d normal = m.metric.image_of_normal(internal::cross(u, v));
  EXPECT_NEAR(internal::dot(normal, m.metric.image(u)), 0, 1e-9);
  EXPECT_NEAR(internal::dot(normal, m.metric.image(v)), 0, 1e-9);
  EXPECT_NEAR(internal::dot(m.metric.row_of_image(row), u), internal::dot(row, m.metric.image(u)),
              1e-9);
}

TEST(ShapeMetric, OfAWallThatIsFlatUpToRoundingIsEuclids) {
  const Rational thickness = Rational::power_of_two(-40);
  const Measured m(thin_shapes::turned(thin_shapes::plate(thickness, thickness)));
  EXPECT_EQ(m.metric.length({3, 4, 12}), 13);
  EXPECT_DOUBLE_EQ(m.metric.distortion(), 1);
}

TEST(ShapeMetric, NamesTheDistortion) {
  EXPECT_DOUBLE_EQ(ShapeMetric().distortion(), 1);
  const Patches spheres = thin_shapes::eccentric_spheres(0);
  EXPECT_NEAR(Measured(spheres).metric.distortion(), 1, 0.01);
  EXPECT_GT(Measured(image(spheres, {1, 0, 0, 0, 8, 0, 0, 0, 1})).metric.distortion(), 8.0 / 3);
}

}  // namespace
}  // namespace veritope
