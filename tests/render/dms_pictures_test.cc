// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/render/dms_pictures_test.cc: rays, boundaries and level sets of pictures beside exact values.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/dms_rays.h"
#include "render/dms_slice_picture.h"
#include "render/dms_surface_scene.h"
#include "render/dms_volume_picture.h"
#include "render/dms_xray_picture.h"
#include "solids/dms/dms_evaluator.h"
#include "solids/dms/dms_iso.h"
#include "tests/support/random_dms.h"

namespace veritope {
namespace {

// A quadratic box of `length` x 1 x 1 cubes with clouds; bent: z + x^2 / 4 at the control points.
DmsModel box_model(bool is_bent, int length = 2) {
  DmsModel domain = kuhn_domain({length, 1, 1});
  domain.attributes = {"density"};
  std::vector<Rational> values;
  for (std::size_t v = 0; v < domain.clouds.size(); ++v) values.emplace_back(v % 4);
  set_control_by_rule(domain, DmsControlRule::kGreville, values);
  const Result<DmsModel> made =
      make_dms(domain, {2, DmsCloudDraw{Rational(1) / Rational(10), 5}, DmsControlRule::kGreville});
  EXPECT_TRUE(made.has_value());
  DmsModel model = *made;
  for (std::size_t c = 0; is_bent && c < model.num_control(); ++c) {
    const std::size_t at = c * model.num_components();
    model.control.values[at + 2] +=
        model.control.values[at] * model.control.values[at] / Rational(4);
  }
  return model;
}

Point3d middle_of(const DmsRayGrid& grid, double i, double j, double t) {
  Point3d p;
  for (std::size_t k = 0; k < 3; ++k)
    p[k] = grid.origin[k] + i * grid.right[k] + j * grid.down[k] + t * grid.along[k];
  return p;
}

TEST(DmsRays, EveryRayCrossesTheDepthOfTheBox) {
  const Box3d box = domain_box(box_model(false));
  EXPECT_EQ(box, (Box3d{{0, 0, 0}, {2, 1, 1}}));
  PictureOptions look;
  look.width = 90, look.height = 70;
  for (const Point3d view : {Point3d{-5, 8, -5}, {0, 0, -1}, {1, 0, 0}}) {
    look.view = view;
    const Result<DmsRayGrid> rays = rays_of_picture(box, look);
    ASSERT_TRUE(rays.has_value());
    EXPECT_TRUE(rays->is_sound());
    const Point3d &a = rays->along, &r = rays->right, &d = rays->down;
    EXPECT_NEAR(a[0] * r[0] + a[1] * r[1] + a[2] * r[2], 0, 1e-12);
    EXPECT_NEAR(d[0] * r[0] + d[1] * r[1] + d[2] * r[2], 0, 1e-12);
    EXPECT_GT(a[0] * view[0] + a[1] * view[1] + a[2] * view[2], 0);
    const Point3d middle = middle_of(*rays, 44.5, 34.5, 0.5);
    EXPECT_NEAR(middle[0], 1, 1e-12);
    EXPECT_NEAR(middle[1], 0.5, 1e-12);
    // All corners of the box are beyond the plane of t = 0, before that of t = 1, and in the picture.
    const double length = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    for (unsigned corner = 0; corner < 8; ++corner) {
      double t = 0, i = 0, j = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = ((corner >> k & 1U) != 0 ? box.hi[k] : box.lo[k]) - rays->origin[k];
        t += x * a[k] / length;
        i += x * r[k] / (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
        j += x * d[k] / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
      }
      EXPECT_TRUE(0 < t && t < 1 && -0.5 < i && i < 89.5 && -0.5 < j && j < 69.5);
    }
  }
}

TEST(DmsRays, RefuseWrongSidesViewsAndBoxes) {
  const Box3d box{{0, 0, 0}, {2, 1, 1}};
  PictureOptions look;
  look.width = 63;
  EXPECT_EQ(rays_of_picture(box, look).error().code, Code::kBadArgument);
  look.width = 8192, look.height = 2049;
  EXPECT_EQ(rays_of_picture(box, look).error().code, Code::kBadArgument);
  look.height = 64, look.view = {0, 0, 0};
  EXPECT_EQ(rays_of_picture(box, look).error().code, Code::kBadArgument);
  look.view = {0, 0, 1};
  const double huge = std::numeric_limits<double>::infinity();
  EXPECT_EQ(rays_of_picture({{0, 0, 0}, {huge, 1, 1}}, look).error().code, Code::kOverLimit);
}

TEST(DmsRays, PointsLieInPlanesAcrossAxesExactly) {
  PictureOptions look;
  look.width = look.height = 64;
  const Box3d box{{0, 0, -0.3}, {2, 1, 1}};
  const Rational third = Rational(1) / Rational(3);
  const auto grid = points_of_picture(box, {{Rational(0), Rational(0), Rational(-7)}, third}, look);
  ASSERT_TRUE(grid.has_value());
  EXPECT_EQ(grid->origin[2], nearest_double(-third / Rational(7)));
  EXPECT_EQ(grid->right[2], 0);
  EXPECT_EQ(grid->down[2], 0);
  EXPECT_GT(grid->along[2], 0) << "seen against the vector of the plane";
  const DmsSlicePlane cut = *middle_cut(box, {1, 2, 3});
  Box3d beyond = box;
  beyond.hi[1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(middle_cut(beyond, {1, 2, 3}).error().code, Code::kOverLimit);
  EXPECT_EQ(cut.number, -(Rational(1) + Rational(1) +
                          Rational(3) * (Rational(1) + Rational::from_double(-0.3)) / Rational(2)));
}

TEST(DmsBoundaryView, PointsAndValuesAreThoseOfTheMap) {
  const DmsModel model = box_model(true, 1);
  const TetrahedralComplex complex(model.tetrahedra,
                                   static_cast<std::uint32_t>(model.clouds.size()));
  const auto pieces = boundary_pieces(model, complex);
  ASSERT_EQ(pieces.index(), 0u);
  DmsSurfaceOptions how;
  how.component = 3;
  const Result<DmsSurfaceView> solid = view_of_boundary(std::get<0>(pieces), how);
  how.in_solid = false;
  const Result<DmsSurfaceView> domain = view_of_boundary(std::get<0>(pieces), how);
  ASSERT_TRUE(solid.has_value() && domain.has_value());
  ASSERT_EQ(solid->surface.points.size(), domain->surface.points.size());
  ASSERT_EQ(solid->surface.colours.size(), solid->surface.points.size());
  EXPECT_TRUE(0 <= solid->range[0] && solid->range[0] < 0.1);
  EXPECT_TRUE(2.9 < solid->range[1] && solid->range[1] <= 3);
  DmsEvaluator evaluator(model);
  std::size_t tested = 0;
  double bulge = 0;
  for (std::size_t i = 0; i < domain->surface.points.size(); i += 97) {
    DmsPoint p;
    for (std::size_t k = 0; k < 3; ++k) {
      // Rounding may have moved it outside of the box.
      p[k] = Rational::from_double(std::clamp(domain->surface.points[i][k], 0.0, 1.0));
    }
    const auto place = evaluator.locate(p);
    ASSERT_TRUE(place.has_value());
    const DmsValue value = evaluator.evaluate(*place);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(solid->surface.points[i][k], nearest_double(value.value[k]), 1e-12);
      bulge = std::max(bulge, std::abs(solid->surface.points[i][k] - domain->surface.points[i][k]));
    }
    ++tested;
  }
  EXPECT_GT(tested, 10u);
  EXPECT_GT(bulge, 0.1);
  how.range = std::array<double, 2>{-10, 10};
  EXPECT_EQ(view_of_boundary(std::get<0>(pieces), how)->range, how.range);
  EXPECT_EQ(view_of_boundary({}, how).error().code, Code::kEmpty);
}

TEST(DmsIsoView, NormalsOfAPlaneAreItsOwn) {
  DmsModel domain = kuhn_domain({1, 1, 1});
  domain.attributes = {"a"};
  std::vector<Rational> values;
  for (const DmsCloud& cloud : domain.clouds)
    values.push_back(cloud[0][0] + Rational(2) * cloud[0][1]);
  set_control_by_rule(domain, DmsControlRule::kGreville, values);
  // The image under x -> (2 x, y, z): the plane 2 x + 4 y = 2 in the domain becomes x + 4 y = 2.
  const std::size_t stride = domain.num_components();
  for (std::size_t c = 0; c < domain.num_control(); ++c)
    domain.control.values[c * stride] *= Rational(2);
  DmsIsoOptions options;
  options.level = Rational(1);
  options.within = Rational(1) / Rational(2);
  options.keeps_places = true;
  const Result<DmsIso> iso = find_dms_iso(domain, options);
  ASSERT_TRUE(iso.has_value());
  ASSERT_GT(iso->mesh.faces.size(), 4u);
  for (const bool in_solid : {false, true}) {
    const Result<SceneSurface> surface = view_of_iso(domain, 3, *iso, in_solid);
    ASSERT_TRUE(surface.has_value());
    ASSERT_EQ(surface->normals.size(), surface->points.size());
    for (std::size_t i = 0; i < surface->points.size(); ++i) {
      const Point3d &p = surface->points[i], &n = surface->normals[i];
      EXPECT_NEAR((in_solid ? p[0] / 2 : p[0]) + 2 * p[1], 1, 1e-15);
      EXPECT_NEAR(n[1] / n[0], in_solid ? 4 : 2, 1e-9);
      EXPECT_NEAR(n[2], 0, 1e-9);
      EXPECT_GT(n[0], 0);
    }
  }
}

// A cube of 2^-1000 at (1/3, 1/3, 1/3), where all vertices round to one point outside; the map brings it to the unit
// cube, or beyond binary64.
TEST(DmsIsoView, ImagesAreThoseOfPlacesBeforeRounding) {
  DmsModel domain = kuhn_domain({1, 1, 1});
  domain.attributes = {"a"};
  std::vector<Rational> values;
  for (const DmsCloud& cloud : domain.clouds) values.push_back(cloud[0][0] + cloud[0][1]);
  set_control_by_rule(domain, DmsControlRule::kGreville, values);
  const Rational third = Rational(1) / Rational(3), side = Rational::power_of_two(-1000);
  for (DmsCloud& cloud : domain.clouds)
    for (Rational& x : cloud[0]) x = third + side * x;
  DmsIsoOptions options;
  options.level = Rational(1) / Rational(2);
  options.within = side / Rational(2);
  options.keeps_places = true;
  const Result<DmsIso> iso = find_dms_iso(domain, options);
  ASSERT_TRUE(iso.has_value());
  EXPECT_TRUE(iso->certified);
  ASSERT_EQ(iso->places.size(), iso->mesh.positions.size());
  const Result<SceneSurface> surface = view_of_iso(domain, 3, *iso, true);
  ASSERT_TRUE(surface.has_value()) << surface.error().message;
  double least = 1, most = 0;
  for (std::size_t i = 0; i < surface->points.size(); ++i) {
    const Point3d &p = surface->points[i], &n = surface->normals[i];
    EXPECT_NEAR(p[0] + p[1], 0.5, 1e-15);
    EXPECT_NEAR(n[1] / n[0], 1, 1e-9);
    EXPECT_NEAR(n[2], 0, 1e-9);
    least = std::min(least, p[2]), most = std::max(most, p[2]);
  }
  EXPECT_EQ(least, 0);
  EXPECT_EQ(most, 1);
  for (std::size_t c = 0; c < domain.num_control(); ++c)
    domain.control.values[c * domain.num_components()] *= Rational::power_of_two(1100);
  EXPECT_EQ(view_of_iso(domain, 3, *iso, true).error().code, Code::kNotFinite);
  EXPECT_TRUE(view_of_iso(domain, 3, *iso, false).has_value());
}

TEST(DmsPictures, AreTheSameForEveryNumberOfThreads) {
  const DmsModel model = box_model(false);
  PictureOptions look;
  look.width = look.height = 64;
  const TransferFunction transfer = default_transfer({&model, 3, nullptr});
  const auto one = draw_dms_volume({&model, 3, nullptr}, transfer, look, 0.05);
  const auto ray = draw_dms_xray(model, 3, look, std::nullopt);
  look.jobs = 3;
  const auto three = draw_dms_volume({&model, 3, nullptr}, transfer, look, 0.05);
  ASSERT_TRUE(one.has_value() && three.has_value() && ray.has_value());
  EXPECT_EQ(one->image.pixels, three->image.pixels);
  EXPECT_EQ(ray->image.pixels, draw_dms_xray(model, 3, look, std::nullopt)->image.pixels);
  EXPECT_NEAR(ray->absorption * ray->greatest, 3, 1e-12);
  EXPECT_EQ(draw_dms_volume({&model, 3, nullptr}, transfer, look, 1e-9).error().code,
            Code::kOverLimit);
}

// A solid that is an affine image of its domain, and the domain of the same image with the same attribute.
TEST(DmsPictures, OfSolidsAreThoseOfDomainsThatAreEqualToThem) {
  DmsModel solid = box_model(false), domain = solid;
  const auto map = [](Rational* p) {
    const Rational x = p[0], y = p[1], z = p[2];
    p[0] = Rational(2) * x + y / Rational(2);
    p[1] = y - x / Rational(4) + Rational(3);
    p[2] = z + x / Rational(2) + y / Rational(8);
  };
  const std::size_t stride = solid.num_components();
  for (std::size_t c = 0; c < solid.num_control(); ++c) map(&solid.control.values[c * stride]);
  for (DmsCloud& cloud : domain.clouds)
    for (DmsPoint& knot : cloud) map(knot.data());
  DmsInverseOptions how;
  how.component = 3;
  const Result<DmsInverse> inverse = DmsInverse::make(solid, how);
  const Result<DmsInverse> bare = DmsInverse::make(solid, {});
  ASSERT_TRUE(inverse.has_value() && bare.has_value());
  const DmsField in_domain{&domain, 3, nullptr}, in_solid{&solid, 3, &*inverse};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(in_solid.box().lo[k], in_domain.box().lo[k], 1e-6);
    EXPECT_NEAR(in_solid.box().hi[k], in_domain.box().hi[k], 1e-6);
  }
  // An attribute over a domain of its own has no coordinates.
  DmsModel alone = solid;
  alone.num_coordinates = 0;
  alone.control.values.clear();
  for (std::size_t c = 0; c < solid.num_control(); ++c)
    alone.control.values.push_back(solid.value(c)[3]);
  const DmsField of_its_own{&alone, 0, &*bare};
  PictureOptions look;
  look.width = 96, look.height = 64;
  const auto count_unlike = [](const Image& a, const Image& b) {
    std::size_t out = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
      const auto off = [](int x, int y) { return std::abs(x - y) > 1; };
      const Colour &p = a.pixels[i], &q = b.pixels[i];
      out += off(p.red, q.red) || off(p.green, q.green) || off(p.blue, q.blue) ? 1 : 0;
    }
    return out;
  };
  const TransferFunction transfer = default_transfer(in_domain);
  const DmsSlicePlane cut = *middle_cut(in_domain.box(), {1, 2, 3});
  const auto volume = draw_dms_volume(in_domain, transfer, look, 0.05);
  const auto slice = draw_dms_slice(in_domain, cut, look, {std::array<double, 2>{0, 3}, 5});
  ASSERT_TRUE(volume.has_value()) << volume.error().message;
  ASSERT_TRUE(slice.has_value()) << slice.error().message;
  for (const DmsField& field : {in_solid, of_its_own}) {
    const auto other = draw_dms_volume(field, transfer, look, 0.05);
    const auto plane = draw_dms_slice(field, cut, look, {std::array<double, 2>{0, 3}, 5});
    ASSERT_TRUE(other.has_value() && plane.has_value());
    // Rims and isolines may move by a pixel.
    EXPECT_LT(count_unlike(volume->image, other->image), 12u);
    EXPECT_LT(count_unlike(slice->image, plane->image), 12u);
  }
  look.jobs = 2;
  EXPECT_EQ(draw_dms_volume(in_solid, transfer, look, 0.05)->image.pixels,
            draw_dms_volume({&solid, 3, &*inverse}, transfer, look, 0.05)->image.pixels);
}

}  // namespace
}  // namespace veritope
