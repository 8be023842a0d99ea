// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/draw_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "render/flat_scene_internal.h"
#include "robust/base/check.h"
#include "tests/render/picture_test_util.h"

namespace veritope {
namespace {

using namespace picture_test;

// A marker of the default radius has this number of pixels in its colour.
constexpr std::size_t kMarkerPixels = 232;

Image drawn(const Scene& scene, const PictureOptions& options = {}) {
  Result<Image> image = draw_scene(scene, options);
  EXPECT_TRUE(image) << (image ? "" : to_string(image.error()));
  return image ? std::move(*image) : Image(options.width, options.height, kWhite);
}
PictureOptions small_picture() {
  PictureOptions options;
  options.width = 400, options.height = 300;
  return options;
}
Scene cube_scene(std::uint8_t opacity) {
  Scene scene;
  scene.surfaces = {box_surface({0, 0, 0}, {1, 1, 1}, {kGrey, opacity})};
  return scene;
}
Scene torus_scene(std::uint8_t opacity) {
  Scene scene;
  scene.surfaces = {torus_surface(60, 30, {kGrey, opacity})};
  return scene;
}

bool has_square_of(const Image& image, Colour colour, std::size_t side) {
  for (std::size_t y = 0; y + side <= image.height; ++y)
    for (std::size_t x = 0; x + side <= image.width; ++x) {
      bool is_full = true;
      for (std::size_t i = 0; is_full && i < side * side; ++i)
        is_full = image.at(x + i % side, y + i / side) == colour;
      if (is_full) return true;
    }
  return false;
}

// The number of pixels of a colour that are connected with the first one, by sides or corners.
std::size_t largest_first_component(const Image& image, Colour colour) {
  std::vector<bool> is_seen(image.pixels.size(), false);
  std::vector<std::size_t> todo;
  const auto visit = [&](std::size_t i) {
    if (!is_seen[i] && image.pixels[i] == colour) is_seen[i] = true, todo.push_back(i);
  };
  visit(static_cast<std::size_t>(std::find(image.pixels.begin(), image.pixels.end(), colour) -
                                 image.pixels.begin()));
  std::size_t count = 0;
  for (; !todo.empty(); ++count) {
    const std::size_t x = todo.back() % image.width, y = todo.back() / image.width;
    todo.pop_back();
    for (std::size_t j = std::max<std::size_t>(y, 1) - 1; j < std::min(y + 2, image.height); ++j)
      for (std::size_t i = std::max<std::size_t>(x, 1) - 1; i < std::min(x + 2, image.width); ++i)
        visit(j * image.width + i);
  }
  return count;
}

TEST(DrawScene, AMarkerCoversTwelveByTwelvePixelsOfItsColourWhereverItIs) {
  Random random(20251204);
  for (int round = 0; round < 20; ++round) {
    Scene scene = cube_scene(255);
    const auto coordinate = [&] { return static_cast<double>(random.below(1001)) / 1000; };
    scene.markers.push_back({{coordinate(), coordinate(), coordinate()}, kRed});
    const Image image = drawn(scene, small_picture());
    EXPECT_TRUE(has_square_of(image, kRed, 12)) << "seed 20251204, round " << round;
    EXPECT_EQ(count_of(image, kRed), kMarkerPixels) << "all markers cover equally many";
  }
}

TEST(DrawScene, MarksShowThroughOpaqueSurfacesWithARim) {
  Scene scene = cube_scene(255);
  scene.markers.push_back({{0.5, 0.5, 0.5}, kRed});
  const Image image = drawn(scene);
  const auto box = box_of_colour(image, kRed);
  ASSERT_TRUE(box);
  const std::size_t x = (box->left + box->right) / 2, y = (box->top + box->bottom) / 2;
  for (std::size_t i = x; i < x + 9; ++i) EXPECT_EQ(image.at(i, y), kRed);
  EXPECT_EQ(image.at(x + 9, y), kWhite);
  EXPECT_EQ(image.at(x + 10, y), kWhite);
  EXPECT_NE(image.at(x + 11, y), kWhite);
  EXPECT_NE(image.at(x + 11, y), kRed);
}

TEST(DrawScene, BrightMarksHaveADarkRim) {
  constexpr Colour kYellow{240, 228, 66};
  Scene scene;
  scene.markers.push_back({{0, 0, 0}, kYellow});
  const Image image = drawn(scene, small_picture());
  const auto box = box_of_colour(image, kYellow);
  ASSERT_TRUE(box);
  const Colour rim = image.at(box->right, (box->top + box->bottom) / 2);
  EXPECT_LT(rim.red + rim.green + rim.blue, 3 * 64);
  EXPECT_NE(rim, kWhite);
}

TEST(DrawScene, NearMarksHideFarOnes) {
  for (const bool is_first_near : {false, true}) {
    Scene scene;
    scene.markers = {{{0, is_first_near ? -1.0 : 1.0, 0}, kRed},
                     {{0, is_first_near ? 1.0 : -1.0, 0}, kBlue}};
    PictureOptions options = small_picture();
    options.view = {0, 1, 0};
    const Image image = drawn(scene, options);
    EXPECT_EQ(count_of(image, is_first_near ? kRed : kBlue), kMarkerPixels);
    EXPECT_EQ(count_of(image, is_first_near ? kBlue : kRed), 0u);
  }
  Scene crossing;
  crossing.lines = {{{{-1, -1, 0}, {1, -1, 0}}, kRed, 6}, {{{0, 1, -1}, {0, 1, 1}}, kBlue, 6}};
  PictureOptions options = small_picture();
  options.view = {0, 1, 0};
  Image image = drawn(crossing, options);
  const auto box = box_of_colour(image, kRed);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->height(), 6u);
  const std::size_t x = image.width / 2, y = (box->top + box->bottom) / 2;
  EXPECT_EQ(image.at(x, y), kRed);
  EXPECT_EQ(image.at(x, box->bottom), kWhite) << "the near line's rim hides the far line";
  crossing.lines[0].points = {{-1, 1, 0}, {1, 1, 0}},
  crossing.lines[1].points = {{0, -1, -1}, {0, -1, 1}};
  image = drawn(crossing, options);
  EXPECT_EQ(image.at(x, y), kBlue);
}

TEST(DrawScene, ALineIsConnectedInExactlyItsColour) {
  Random random(20251205);
  for (int round = 0; round < 20; ++round) {
    Scene scene;
    scene.surfaces = {box_surface({0, 0, 0}, {1, 1, 1}, {kGrey, 150})};
    SceneLine line{{}, kRed, static_cast<double>(3 + round % 4)};
    for (int i = 0; i < 8; ++i)
      line.points.push_back({static_cast<double>(random.below(101)) / 100,
                             static_cast<double>(random.below(101)) / 100, 0.5});
    scene.lines.push_back(line);
    PictureOptions options = small_picture();
    options.view = {-1, 2, -4};
    const Image image = drawn(scene, options);
    EXPECT_GT(count_of(image, kRed), 100u);
    EXPECT_EQ(largest_first_component(image, kRed), count_of(image, kRed))
        << "seed 20251205, round " << round;
  }
}

TEST(DrawScene, LinesOfSizeZeroShowAsDots) {
  for (const std::vector<Point3d>& points :
       {std::vector<Point3d>{{2, 3, 4}}, {{2, 3, 4}, {2, 3, 4}, {2, 3, 4}}}) {
    Scene scene;
    scene.lines.push_back({points, kRed, 8});
    const Image image = drawn(scene, small_picture());
    EXPECT_GE(count_of(image, kRed), 30u);
    const auto box = box_of_colour(image, kRed);
    ASSERT_TRUE(box);
    EXPECT_LE(box->width(), 8u);
    EXPECT_LE(box->height(), 8u);
  }
}

void expect_fit(const Scene& scene, const PictureOptions& options) {
  const auto box = box_of_ink(drawn(scene, options));
  ASSERT_TRUE(box);
  const std::size_t margin =
      8 * std::max<std::size_t>(1, std::min(options.width / 600, options.height / 450));
  EXPECT_GE(box->left, margin);
  EXPECT_GE(box->top, margin);
  EXPECT_LE(box->right, options.width - margin);
  EXPECT_LE(box->bottom, options.height - margin);
  // White rims do not show.
  const std::size_t frame = 2 * margin + 2 * static_cast<std::size_t>(internal::kRim) + 2;
  const bool is_full =
      box->width() + frame >= options.width || box->height() + frame >= options.height;
  EXPECT_TRUE(is_full) << box->width() << " x " << box->height();
}

TEST(DrawScene, TheSceneFillsThePictureAndNotItsMargin) {
  const double huge = std::numeric_limits<double>::max(), tiny = 1e-310;
  for (const auto& [width, height] :
       {std::pair<std::size_t, std::size_t>{400, 300}, {300, 400}, {1200, 200}}) {
    PictureOptions options;
    options.width = width, options.height = height;
    for (const Point3d& hi : {Point3d{1, 1, 1},
                              {5, 1, 1},
                              {1, 1, 20},
                              {huge, huge, huge},
                              {tiny, tiny, tiny},
                              {3, 2, 0}}) {
      Scene scene;
      scene.surfaces = {box_surface({-hi[0], -hi[1], -hi[2]}, hi, {kGrey, 255})};
      expect_fit(scene, options);
      scene.surfaces.clear();
      scene.lines.push_back({{{-hi[0], -hi[1], -hi[2]}, hi}, kBlue, 7});
      expect_fit(scene, options);
    }
  }
}

TEST(DrawScene, MarksAndTheirRimsLieInTheRoomToo) {
  constexpr Colour kYellow{240, 228, 66};  // with a dark rim, which counts as ink
  Scene scene = cube_scene(255);
  for (const Point3d& p : scene.surfaces[0].points) scene.markers.push_back({p, kYellow, 20});
  const auto box = box_of_ink(drawn(scene, small_picture()));
  ASSERT_TRUE(box);
  EXPECT_GE(box->top, 7u);
  EXPECT_LE(box->bottom, 293u);
}

TEST(DrawScene, NothingIsStretched) {
  // A ball from a great circle of points, seen from many sides, is as wide as high.
  Scene scene;
  scene.surfaces = {torus_surface(200, 4, {kGrey, 255})};
  PictureOptions options = small_picture();
  options.view = {0, 0, -1};
  const auto box = box_of_ink(drawn(scene, options));
  ASSERT_TRUE(box);
  EXPECT_NEAR(static_cast<double>(box->width()), static_cast<double>(box->height()), 2);
}

Scene scaled(Scene scene, int exponent) {
  const auto scale = [exponent](Point3d& p) {
    for (double& x : p) x = std::ldexp(x, exponent);
  };
  for (SceneSurface& s : scene.surfaces) std::for_each(s.points.begin(), s.points.end(), scale);
  for (SceneLine& line : scene.lines) std::for_each(line.points.begin(), line.points.end(), scale);
  for (SceneMarker& marker : scene.markers) scale(marker.at);
  return scene;
}

TEST(DrawScene, APowerOfTwoChangesNothing) {
  Scene scene = torus_scene(150);
  scene.lines.push_back({{{-1, -1, -1}, {1, 1, 1}}, kRed});
  scene.markers.push_back({{1, -1, 0.25}, kBlue});
  const Image image = drawn(scene, small_picture());
  for (const int exponent : {-900, -40, 3, 700, 1023})
    EXPECT_EQ(drawn(scaled(scene, exponent), small_picture()).pixels, image.pixels) << exponent;
}

TEST(DrawScene, TheNumberOfThreadsChangesNothing) {
  Scene scene = torus_scene(120);
  scene.surfaces.push_back(box_surface({-0.5, -0.5, -0.5}, {2, 0.5, 0.5}, {kBlue, 90}));
  scene.lines.push_back({{{-1, -1, -1}, {1, 1, 1}}, kRed});
  PictureOptions options = small_picture();
  const Image image = drawn(scene, options);
  for (const unsigned jobs : {0U, 2U, 5U}) {
    options.jobs = jobs;
    EXPECT_EQ(drawn(scene, options).pixels, image.pixels) << jobs;
  }
}

TEST(DrawScene, TheOrderOfTrianglesChangesNothing) {
  Random random(20251206);
  for (const int opacity : {60, 255}) {
    Scene scene = torus_scene(static_cast<std::uint8_t>(opacity));
    const Image image = drawn(scene, small_picture());
    auto& triangles = scene.surfaces[0].triangles;
    for (std::size_t i = triangles.size(); i-- > 1;)
      std::swap(triangles[i], triangles[random.below(i + 1)]);
    for (auto& t : triangles) std::swap(t[1], t[2]);
    EXPECT_EQ(drawn(scene, small_picture()).pixels, image.pixels);
  }
}

TEST(DrawScene, WhereTrianglesCoincideTheFirstListedIsInFront) {
  // One sheet twice, with the other diagonal and in another colour, at an angle that no coordinate likes.
  const Point3d a{0.1, 0.2, 0.3}, b{1.3, 0.7, 0.9}, c{0.4, 1.9, 1.1};
  const Point3d d{b[0] + c[0] - a[0], b[1] + c[1] - a[1], b[2] + c[2] - a[2]};
  const SceneSurface red{{a, b, c, d}, {{0, 1, 3}, {0, 3, 2}}, {{{200, 0, 0}, 255}}},
      blue{{a, b, c, d}, {{0, 1, 2}, {1, 3, 2}}, {{{0, 0, 200}, 255}}};
  PictureOptions options = small_picture();
  options.has_outlines = false;
  Scene scene;
  scene.surfaces = {red, blue};
  Image image = drawn(scene, options);
  EXPECT_FALSE(box_of_pixels(image, [](Colour p) { return p.blue > p.red; }));
  EXPECT_TRUE(box_of_pixels(image, [](Colour p) { return p.red > p.blue; }));
  scene.surfaces = {blue, red};
  image = drawn(scene, options);
  EXPECT_FALSE(box_of_pixels(image, [](Colour p) { return p.red > p.blue; }));
}

TEST(DrawScene, TwoSheetsCloseTogetherDoNotFlicker) {
  PictureOptions options = small_picture();
  options.has_outlines = false;
  for (const double thickness : {0.1, 1e-3, 1e-6, 1e-8, 1e-15, 0.0})
    for (const std::uint8_t opacity : {120, 255})
      for (const bool is_upper_first : {false, true}) {
        const auto sheet = [opacity](double z, Colour colour) {
          return SceneSurface{{{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}},
                              {{0, 1, 2}, {0, 2, 3}},
                              {{colour, opacity}}};
        };
        Scene scene;
        scene.surfaces = {sheet(0, {200, 0, 0}), sheet(-thickness, {0, 0, 200})};
        if (!is_upper_first) std::swap(scene.surfaces[0], scene.surfaces[1]);
        const Image image = drawn(scene, options);
        const auto box = box_of_ink(image);
        ASSERT_TRUE(box);
        // In the middle, where both are seen, all pixels are equal. The upper one is in front where depths can tell.
        const std::size_t x = (box->left + box->right) / 2, y = (box->top + box->bottom) / 2;
        const Colour middle = image.at(x, y);
        EXPECT_EQ(middle.red > middle.blue, is_upper_first || thickness >= 1e-8) << thickness;
        for (std::size_t j = y - 20; j < y + 20; ++j)
          for (std::size_t i = x - 60; i < x + 60; ++i)
            ASSERT_EQ(image.at(i, j), middle) << thickness;
      }
}

TEST(DrawScene, WhatLiesBehindShowsThroughByItsShare) {
  const auto sheet = [](double y, Paint paint) {
    return SceneSurface{
        {{-1, y, -1}, {1, y, -1}, {1, y, 1}, {-1, y, 1}}, {{0, 1, 2}, {0, 2, 3}}, {paint}};
  };
  PictureOptions options = small_picture();
  options.view = {0, 1, 0};
  const auto middle = [&](const std::vector<SceneSurface>& surfaces) {
    Scene scene;
    scene.surfaces = surfaces;
    const Image image = drawn(scene, options);
    return image.at(image.width / 2 + 5, image.height / 2 + 3);
  };
  const Colour opaque = middle({sheet(0, {{100, 100, 100}, 255})});
  EXPECT_EQ(opaque.red, opaque.blue);
  EXPECT_GT(opaque.red, 80);
  EXPECT_LE(opaque.red, 100);
  const Colour half = middle({sheet(0, {{100, 100, 100}, 51})});
  EXPECT_NEAR(half.red, 0.2 * opaque.red + 0.8 * 255, 1);
  const Colour twice =
      middle({sheet(0.2, {{100, 100, 100}, 51}), sheet(-0.2, {{100, 100, 100}, 51})});
  EXPECT_NEAR(twice.red, 0.2 * opaque.red + 0.8 * half.red, 1.5);
  EXPECT_EQ(middle({sheet(0.2, {{0, 0, 0}, 255}), sheet(-0.2, {{100, 100, 100}, 255})}), opaque);
  EXPECT_EQ(middle({sheet(0, {{0, 0, 0}, 0})}), kWhite);
}

TEST(DrawScene, AClosedOpaqueSurfaceHasNoHoles) {
  Random random(20251207);
  for (int round = 0; round < 30; ++round) {
    PictureOptions options = small_picture();
    for (double& x : options.view) x = static_cast<double>(random.between(-9, 9));
    if (options.view == Point3d{0, 0, 0}) continue;
    const Image image = drawn(cube_scene(255), options);
    for (std::size_t y = 0; y < image.height; ++y) {
      std::size_t changes = 0;
      for (std::size_t x = 1; x < image.width; ++x)
        if ((image.at(x, y) == kWhite) != (image.at(x - 1, y) == kWhite)) ++changes;
      EXPECT_LE(changes, 2u) << "seed 20251207, round " << round << ", row " << y;
    }
  }
}

TEST(DrawScene, FacesAtAnAngleDifferAndHaveOutlines) {
  PictureOptions options = small_picture();
  const Image with = drawn(cube_scene(255), options);
  options.has_outlines = false;
  const Image without = drawn(cube_scene(255), options);
  std::map<std::array<std::uint8_t, 3>, int> counts;
  for (const Colour& c : without.pixels) ++counts[{c.red, c.green, c.blue}];
  const auto num_common =
      std::count_if(counts.begin(), counts.end(), [](const auto& c) { return c.second > 1000; });
  EXPECT_EQ(num_common, 4) << "three faces and the background";
  std::size_t num_darker = 0;
  for (std::size_t i = 0; i < with.pixels.size(); ++i) {
    EXPECT_LE(with.pixels[i].red, without.pixels[i].red);
    if (with.pixels[i].red < without.pixels[i].red) ++num_darker;
  }
  EXPECT_GT(num_darker, 500u);
  EXPECT_LT(num_darker, 5000u);
}

TEST(DrawScene, DegenerateScenesHaveAPicture) {
  const SceneSurface point{{{1, 2, 3}}, {{0, 0, 0}}, {{kGrey, 255}}};
  const SceneSurface needle{
      {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}, {2, 1, 0}}, {{kGrey, 255}}};
  const SceneSurface speck{{{0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}, {1, 1, 1}},
                           {{0, 1, 2}, {0, 3, 1}},
                           {{kGrey, 255}}};
  for (const SceneSurface& surface : {point, needle, speck}) {
    Scene scene;
    scene.surfaces = {surface};
    (void)drawn(scene, small_picture());
    scene.markers.push_back({surface.points.back(), kRed});
    EXPECT_EQ(count_of(drawn(scene, small_picture()), kRed), kMarkerPixels);
  }
  Scene scene;
  const double huge = std::numeric_limits<double>::max(),
               tiny = std::numeric_limits<double>::denorm_min();
  scene.markers = {{{huge, tiny, 0}, kRed}, {{-huge, -tiny, tiny}, kBlue}};
  const Image image = drawn(scene, small_picture());
  EXPECT_EQ(count_of(image, kRed), kMarkerPixels);
  EXPECT_EQ(count_of(image, kBlue), kMarkerPixels);
}

TEST(DrawScene, AnySceneOfFiniteCoordinatesHasAPicture) {
  Random random(20251211);
  const auto coordinate = [&] {
    constexpr double kFixed[] = {0,
                                 1,
                                 -1,
                                 1e300,
                                 -1e300,
                                 1e-300,
                                 std::numeric_limits<double>::max(),
                                 std::numeric_limits<double>::lowest(),
                                 std::numeric_limits<double>::denorm_min()};
    if (random.below(3) == 0) return kFixed[random.below(std::size(kFixed))];
    const auto mantissa = static_cast<double>(random.between(-1000, 1000));
    return std::ldexp(
        mantissa, static_cast<int>(random.between(-1, 1)) * static_cast<int>(random.below(1000)));
  };
  const auto point = [&] { return Point3d{coordinate(), coordinate(), coordinate()}; };
  for (int round = 0; round < 200; ++round) {
    Scene scene;
    scene.surfaces.resize(random.below(3));
    for (SceneSurface& s : scene.surfaces) {
      for (std::uint64_t n = 1 + random.below(9); n > 0; --n) s.points.push_back(point());
      const auto corner = [&] { return static_cast<std::uint32_t>(random.below(s.points.size())); };
      for (std::uint64_t n = random.below(20); n > 0; --n)
        s.triangles.push_back({corner(), corner(), corner()});
      s.paints = {{kGrey, static_cast<std::uint8_t>(random.below(256))}};
    }
    scene.lines.resize(random.below(3));
    for (SceneLine& line : scene.lines)
      for (std::uint64_t n = random.below(5); n > 0; --n) line.points.push_back(point());
    scene.markers.push_back({point(), kRed, 0.5 + static_cast<double>(random.below(64))});
    PictureOptions options;
    options.width = 64 + random.below(100), options.height = 64 + random.below(100);
    do options.view = point();
    while (options.view == Point3d{0, 0, 0});
    EXPECT_TRUE(box_of_ink(drawn(scene, options))) << "seed 20251211, round " << round;
  }
}

TEST(DrawScene, PointsThatNoTriangleUsesDoNotCount) {
  Scene scene = cube_scene(255);
  const Image image = drawn(scene, small_picture());
  scene.surfaces[0].points.push_back({std::numeric_limits<double>::infinity(), 1e300, -1e300});
  EXPECT_EQ(drawn(scene, small_picture()).pixels, image.pixels);
}

TEST(DrawScene, ASmallPictureWithLargeMarksStaysInTheImage) {
  Scene scene = cube_scene(255);
  for (const Point3d& p : scene.surfaces[0].points) scene.markers.push_back({p, kRed, 64});
  scene.lines.push_back({{{0, 0, 0}, {1, 1, 1}}, kBlue, 128});
  scene.title = {"title", "more"};
  scene.legend = {{kRed, "first"}, {kBlue, "second"}, {kGrey, "third"}};
  PictureOptions options;
  options.width = 64, options.height = 64;
  EXPECT_EQ(drawn(scene, options).pixels.size(), 64u * 64);
}

TEST(DrawScene, EmptyScenesAreRefused) {
  Scene scene;
  scene.title = {"nothing"};
  scene.surfaces.push_back({{{0, 0, 0}}, {}, {}});
  scene.lines.push_back({{}, kRed});
  const Result<Image> image = draw_scene(scene, {});
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, Code::kEmpty);
}

TEST(DrawScene, OptionsOutOfRangeAreRefused) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto refused = [](auto change) {
    PictureOptions options;
    change(options);
    const Result<Image> image = draw_scene(cube_scene(255), options);
    return !image && image.error().code == Code::kBadArgument;
  };
  EXPECT_TRUE(refused([](PictureOptions& o) { o.width = 63; }));
  EXPECT_TRUE(refused([](PictureOptions& o) { o.height = 0; }));
  EXPECT_TRUE(refused([](PictureOptions& o) { o.height = 8193; }));
  EXPECT_TRUE(refused([](PictureOptions& o) { o.view = {0, 0, -0.0}; }));
  EXPECT_TRUE(refused([&](PictureOptions& o) { o.view = {0, infinity, 1}; }));
  EXPECT_TRUE(refused([&](PictureOptions& o) { o.view = {0, std::nan(""), 1}; }));
  EXPECT_FALSE(refused([](PictureOptions& o) { o.width = 64, o.height = 64; }));
}

TEST(DrawScene, TooManyLayersAreRefusedBeforeTheyAreDrawn) {
  Scene scene;
  scene.surfaces = {{{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {}, {{kGrey, 9}}}};
  scene.surfaces[0].triangles.assign(3000, {0, 1, 2});
  PictureOptions options;
  options.width = options.height = 8192;
  const Result<Image> image = draw_scene(scene, options);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, Code::kOverLimit);
}

TEST(DrawScene, WhatNoCallerMayPassIsAnError) {
  const auto draw = [](auto change) {
    Scene scene = cube_scene(255);
    change(scene);
    (void)draw_scene(scene, {});
  };
  EXPECT_THROW(draw([](Scene& s) { s.surfaces[0].points[0][1] = std::nan(""); }), InternalError);
  EXPECT_THROW(draw([](Scene& s) { s.surfaces[0].triangles[2][1] = 8; }), InternalError);
  EXPECT_THROW(draw([](Scene& s) { s.surfaces[0].paints.resize(11); }), InternalError);
  EXPECT_THROW(draw([](Scene& s) {
                 s.lines.push_back({{{HUGE_VAL, 0, 0}}, kRed});
               }),
               InternalError);
  EXPECT_THROW(draw([](Scene& s) { s.lines.push_back({{{0, 0, 0}}, kRed, 0.5}); }), InternalError);
  EXPECT_THROW(draw([](Scene& s) { s.markers.push_back({{0, 0, 0}, kRed, 65}); }), InternalError);
  EXPECT_THROW(draw([](Scene& s) {
                 s.markers.push_back({{0, 0, 0}, kRed, std::nan("")});
               }),
               InternalError);
}

}  // namespace
}  // namespace veritope
