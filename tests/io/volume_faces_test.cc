// SPDX-License-Identifier: LGPL-3.0-or-later
#include "io/splines/volume_faces.h"

#include "solids/patches/patch_complex.h"
#include "splines/de_boor.h"
#include "splines/de_casteljau.h"
#include "tests/io/spline_test_util.h"

namespace veritope {
namespace {

VolumeFaces faces_of_text(const std::string& itd) {
  auto faces = volume_faces(io_test::model_of(SplineFormat::kItd, itd));
  EXPECT_TRUE(faces) << (faces ? "" : to_string(faces.error()));
  return faces ? std::move(*faces) : VolumeFaces{};
}

bool is_closed(const VolumeFaces& faces) {
  PatchInput input;
  input.patches = faces.patches;
  return make_patch_complex(std::move(input)).value().is_closed_oriented_surface();
}

// The normal of a bilinear face in its corner (0, 0), as signs.
std::array<int, 3> normal(const Patch& face) {
  const auto at = [&](std::size_t i, int c) { return Rational(face.tensor().component(c)[i]); };
  std::array<int, 3> out{};
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Rational n = (at(2, i) - at(0, i)) * (at(1, j) - at(0, j)) -
                       (at(2, j) - at(0, j)) * (at(1, i) - at(0, i));
    out[static_cast<std::size_t>(k)] = static_cast<int>(n.sign());
  }
  return out;
}

/// The box from (x, 0, 0) to (x + 1, 1, 1), u along x.
std::string box(int x) {
  std::string text = "[TRIVAR BEZIER 2 2 2 E3";
  for (const char* const z : {" 0]", " 1]"})
    for (const char* const y : {" 0", " 1"})
      for (const int i : {x, x + 1}) text += " [" + std::to_string(i) + y + z;
  return text + "]\n";
}
/// A left-handed box: u and v are exchanged.
std::string mirrored_box(int x) {
  std::string text = "[TRIVAR BEZIER 2 2 2 E3";
  for (const char* const z : {" 0]", " 1]"})
    for (const int i : {x, x + 1})
      for (const char* const y : {" 0", " 1"}) text += " [" + std::to_string(i) + y + z;
  return text + "]\n";
}

TEST(VolumeFaces, OfABoxPointOut) {
  for (const std::string& text : {box(0), mirrored_box(0)}) {
    const VolumeFaces faces = faces_of_text(text);
    EXPECT_EQ(faces.patches.size(), 6u);
    EXPECT_TRUE(is_closed(faces));
    for (const Patch& face : faces.patches) {
      const auto n = normal(face);
      // Outward from the middle (1/2, 1/2, 1/2): the face lies at 1 on the axis of a positive normal.
      for (std::size_t k = 0; k < 3; ++k)
        if (n[k] != 0) {
          EXPECT_EQ(face.tensor().component(static_cast<int>(k))[0], Rational(n[k] > 0 ? 1 : 0));
        }
    }
  }
  EXPECT_TRUE(faces_of_text(box(0)).mirrored.empty());
  EXPECT_EQ(faces_of_text(mirrored_box(0)).mirrored, std::vector<std::uint64_t>{0});
}

TEST(VolumeFaces, WallsBetweenVolumesAndPiecesAreLeftOut) {
  const VolumeFaces row = faces_of_text(box(0) + mirrored_box(1) + box(2));
  EXPECT_EQ(row.num_volumes, 3u);
  EXPECT_EQ(row.mirrored, std::vector<std::uint64_t>{1});
  EXPECT_EQ(row.patches.size(), 14u);
  EXPECT_TRUE(is_closed(row));
  // Two spans along u, in one volume.
  const VolumeFaces bar = faces_of_text(
      "[TRIVAR BSPLINE 3 2 2 2 2 2 E3 [KV 0 0 1 2 2] [KV 0 0 1 1] [KV 0 0 1 1] [0 0 0][1 0 0][2 0 "
      "0]"
      "[0 1 0][1 1 0][2 1 0] [0 0 1][1 0 1][2 0 1][0 1 1][1 1 1][2 1 1]]");
  EXPECT_EQ(bar.patches.size(), 10u);
  EXPECT_TRUE(is_closed(bar));
}

// A wedge of a cone, rational in u; v = 0 is its axis, w = 1 its apex. Where it is collapsed, a face is a curve or a point.
TEST(VolumeFaces, FacesWithoutAreaAreLeftOut) {
  const auto wedge = [](const std::string& a, const std::string& b, const std::string& c) {
    const std::string apex = " [1 0 0 2] [.5 0 0 1] [1 0 0 2]";
    return "[TRIVAR BEZIER 3 2 2 P3 [1 0 0 0] [.5 0 0 0] [1 0 0 0] [1 " + a + " 0] [.5 " + b +
           " 0] [1 " + c + " 0]" + apex + apex + "]\n";
  };
  const VolumeFaces one = faces_of_text(wedge("1 0", "1 1", "0 1"));
  EXPECT_EQ(one.num_flat, 2u);  // the axis and the apex
  EXPECT_EQ(one.patches.size(), 4u);
  const VolumeFaces all =
      faces_of_text(wedge("1 0", "1 1", "0 1") + wedge("0 1", "-1 1", "-1 0") +
                    wedge("-1 0", "-1 -1", "0 -1") + wedge("0 -1", "1 -1", "1 0"));
  EXPECT_EQ(all.num_flat, 8u);
  EXPECT_EQ(all.patches.size(), 8u);
  EXPECT_TRUE(is_closed(all));
}

// Four faces of a flat box are segments, and the other two are one square: no piece shares it with another one.
TEST(VolumeFaces, OfWhichNoneIsLeftAreAnError) {
  std::string flat = box(0);
  for (std::size_t at = flat.find(" 1]"); at != flat.npos; at = flat.find(" 1]", at))
    flat[at + 1] = '0';
  const auto none = volume_faces(io_test::model_of(SplineFormat::kItd, flat));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, Code::kEmpty);
  EXPECT_EQ(
      none.error().message,
      "no face is left: of 6 faces, 4 have no area, and the others are equal in pairs, as walls "
      "between volumes and the two sides of a flat volume are");
}

// A trilinear box of height h over the plane z = x/3 + y/7, with a number whose denominator is 3^n.
SplineModel box_with_long_number(int h, int n) {
  Integer denominator(1);
  for (int i = 0; i < n; ++i) denominator *= Integer(3);
  std::vector<Rational> values;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 8; ++i) values.push_back(Rational((i >> (2 - c) & 1) * (c == 2 ? h : 1)));
  values[7] += Rational(1) / Rational(denominator);
  for (std::size_t i = 0; i < 8; ++i)
    values[16 + i] += values[i] / Rational(3) + values[8 + i] / Rational(7);
  const KnotAxis<Rational> axis{1, {0, 0, 1, 1}};
  SplineModel out;
  out.entities.push_back(
      {ExactVolume({axis, axis, axis}, 3, false, std::move(values)), {}, {}, {}});
  return out;
}

TEST(VolumeFaces, OfLongNumbersHaveTheHandThatRoundedOnesShow) {
  EXPECT_TRUE(volume_faces(box_with_long_number(1, 45000)).value().mirrored.empty());
  EXPECT_EQ(volume_faces(box_with_long_number(-1, 45000)).value().mirrored.size(), 1u);
}

TEST(VolumeFaces, AreRefusedWhereOnlyLongNumbersWouldShowTheHand) {
  const auto refused = volume_faces(box_with_long_number(0, 45000));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, Code::kOverLimit);
  EXPECT_EQ(refused.error().place.entity, 0u);
  EXPECT_TRUE(volume_faces(box_with_long_number(0, 40)));
}

TEST(VolumeFaces, OfAPointNoneHasAnArea) {
  std::string point = "[TRIVAR BEZIER 2 2 2 E3";
  for (int i = 0; i < 8; ++i) point += " [1 2 3]";
  const auto none = volume_faces(io_test::model_of(SplineFormat::kItd, point + "]\n"));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "no face is left: none of the 6 faces has an area");
}

// Law: the point of a face at (s, t) is that of the volume at the parameters that its place gives.
TEST(VolumeFaces, LieWhereTheirPlacesSay) {
  // Knots at 1 along u and at 5 along w; the first volume is right-handed and not clamped along u, the second one is
  // left-handed.
  const std::string knots = " 2 3 2 E3 [KV %0 0 1 3 %1] [KV 0 0 0 1 1 1] [KV 4 4 5 6 6]";
  std::string text;
  for (const bool is_left_handed : {false, true}) {
    std::string head = "[TRIVAR BSPLINE 3 3 3" + knots;
    head.replace(head.find("%0"), 2, is_left_handed ? "0" : "-1");
    head.replace(head.find("%1"), 2, is_left_handed ? "3" : "4");
    text += head;
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
          text += " [" + std::to_string(is_left_handed ? 20 - 4 * i : 4 * i) + " " +
                  std::to_string(5 * j + i * k) + " " + std::to_string(6 * k + i * j) + "]";
    text += "]\n";
  }
  const SplineModel model = io_test::model_of(SplineFormat::kItd, text);
  const VolumeFaces faces = volume_faces(model).value();
  EXPECT_EQ(faces.mirrored, (std::vector<std::uint64_t>{1}));
  ASSERT_EQ(faces.places.size(), faces.patches.size());
  EXPECT_EQ(faces.patches.size(), 32u);
  for (std::size_t f = 0; f < faces.patches.size(); ++f) {
    const VolumeFace& place = faces.places[f];
    const auto& volume = std::get<ExactVolume>(model.entities[place.volume].shape);
    ASSERT_TRUE(place.piece);
    const auto& breaks = *place.piece;
    const Rational third = Rational(1) / Rational(3), fifth = Rational(1) / Rational(5);
    std::array<Rational, 3> at;
    at[place.axis] = place.at;
    at[place.axes[0]] = breaks[0][0] + (breaks[0][1] - breaks[0][0]) * third;
    at[place.axes[1]] = breaks[1][0] + (breaks[1][1] - breaks[1][0]) * fifth;
    const auto& axis = volume.axis(place.axis);
    EXPECT_EQ(place.at, place.end == 0 ? axis.domain_begin() : axis.domain_end());
    EXPECT_EQ(evaluate(faces.patches[f].tensor(), std::array{third, fifth}),
              point(volume, at).value());
  }
}

TEST(VolumeFaces, WhatIsNoVolumeIsCountedAndWhatIsNotInSpaceIsRefused) {
  const std::string flat = "[SURFACE BEZIER 2 2 E3 [0 0 0] [1 0 0] [0 1 0] [1 1 0]]\n";
  EXPECT_EQ(faces_of_text(flat + box(0)).num_others, 1u);
  const auto none = volume_faces(io_test::model_of(SplineFormat::kItd, flat));
  EXPECT_EQ(none.error().code, Code::kEmpty);
  const auto scalar = volume_faces(io_test::model_of(
      SplineFormat::kItd, flat + "[TRIVAR BEZIER 2 2 2 E1 [0][1][2][3][4][5][6][7]]"));
  EXPECT_EQ(scalar.error().code, Code::kBadArgument);
  EXPECT_EQ(scalar.error().place.entity, 1u);
}

}  // namespace
}  // namespace veritope
