// SPDX-License-Identifier: LGPL-3.0-or-later
// certify() on files of volumes.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "splines/de_boor.h"
#include "tests/certify/certify_answers.h"

namespace veritope {
namespace {

void expect_copy(const Certified& c) {
  EXPECT_EQ(c.verdict, Verdict::kValid);
  EXPECT_EQ(c.claim, "vmodel-1");
  ASSERT_TRUE(c.copy);
  EXPECT_EQ(c.copy->what, "its 1 volume");
  EXPECT_EQ(format_of_certificate(c), "vjson");
  expect_accepted(c.copy->bytes, c);
}

TEST(Certify, VolumesAreTheCellsOfAVModel) {
  std::string points;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k)
        points += (points.empty() ? "[\"" : ", [\"") + std::to_string(i) + "\", \"" +
                  std::to_string(j) + "\", \"" + std::to_string(2 * k) + "\"]";
  const std::string axis = "[\"0\", \"0\", \"1\", \"1\"]";
  const std::string volume =
      "{\"kind\": \"volume\", \"group\": null, \"attributes\": [], \"shape\": {\"degrees\": "
      "[1, 1, 1], \"periodic\": [false, false, false], \"knots\": [" +
      axis + ", " + axis + ", " + axis +
      "], \"rational\": false, \"components\": 3, \"points\": [" + points + "]}}";
  const auto text = [](const std::string& entities) {
    return "{\"format\": \"veritope-spline-1\", \"groups\": [], \"entities\": [" + entities + "]}";
  };
  const auto file = [&](const std::string& entities) {
    return read(text(entities), "block.vjson");
  };
  const Certified own = certify(file(volume)).value();
  EXPECT_EQ(own.verdict, Verdict::kValid);
  EXPECT_EQ(patch_facts(own).patches, 6u);
  ASSERT_TRUE(patch_facts(own).vmodel);
  EXPECT_EQ(patch_facts(own).vmodel->counts.v_points, 8u);
  EXPECT_EQ(patch_facts(own).vmodel->volume, Rational(2));
  EXPECT_FALSE(own.copy || own.boundary_faces);
  EXPECT_EQ(format_of_certificate(own), "vjson");
  expect_accepted(text(volume), own);
  // A collar is one of the boundary faces.
  CertifyOptions with_collar;
  with_collar.with_collar = true;
  const Certified collar = certify(file(volume), with_collar).value();
  EXPECT_EQ(collar.claim, "collar-1");
  EXPECT_EQ(collar.boundary_faces, "the 6 boundary faces of its 1 volume");
  // With ends of an axis that are not clamped a copy is certified.
  std::string loose = volume;
  loose.replace(loose.find(axis), axis.size(), "[\"-1\", \"0\", \"1\", \"3/2\"]");
  const Certified c = certify(file(loose)).value();
  expect_copy(c);
  std::string flat = volume;
  for (std::size_t at; (at = flat.find("\"2\"]")) != flat.npos;) flat.replace(at, 4, "\"0\"]");
  const Certified no_volume = certify(file(flat)).value();
  EXPECT_EQ(no_volume.verdict, Verdict::kInvalid);
  EXPECT_EQ(no_volume.findings.at(0).code, "flat");
  expect_accepted(text(flat), no_volume);
  // Twice, each face is there twice. Beside a surface nothing says what bounds the solid.
  const Certified twice = certify(file(volume + ", " + volume)).value();
  EXPECT_EQ(twice.verdict, Verdict::kInvalid);
  EXPECT_EQ(twice.findings.at(0).code, "overlap");
  EXPECT_EQ(format_of_certificate(twice), "vjson");
  expect_accepted(text(volume + ", " + volume), twice);
  const std::string surface =
      "{\"kind\": \"surface\", \"group\": null, \"attributes\": [], \"shape\": {\"degrees\": "
      "[1, 1], \"periodic\": [false, false], \"knots\": [" +
      axis + ", " + axis +
      "], \"rational\": false, \"components\": 3, \"points\": [[\"0\", \"0\", \"0\"], [\"0\", "
      "\"1\", "
      "\"0\"], [\"1\", \"0\", \"0\"], [\"1\", \"1\", \"0\"]]}}";
  expect_undecided(certify(file(volume + ", " + surface)).value(), "not-covered",
                   "1 volume and other shapes");
}

// 2 x 1 x 1, and inside it a box of which one corner may be pulled through the middle, so that it folds there.
std::string nested_volumes(const std::string& corner) {
  const std::string outer =
      "[TRIVAR BEZIER 2 2 2 E3 [0 0 0][2 0 0][0 1 0][2 1 0][0 0 1][2 0 1][0 1 1][2 1 1]]\n";
  return outer + "[TRIVAR BEZIER 2 2 2 E3 [" + corner +
         "][1 .25 .25][.5 .75 .25][1 .75 .25][.5 .25 .75][1 .25 .75][.5 .75 .75][1 .75 .75]]\n";
}

void expect_folded(const Certified& c, const std::string& words) {
  EXPECT_EQ(c.verdict, Verdict::kInvalid);
  EXPECT_EQ(c.claim, "volume-folded-1");
  ASSERT_EQ(c.findings.size(), 1u);
  EXPECT_EQ(c.findings[0].code, "folded");
  EXPECT_NE(c.findings[0].message.find(words), std::string::npos) << c.findings[0].message;
  EXPECT_EQ(c.findings[0].place.parts.size(), 2u);
  EXPECT_TRUE(c.findings[0].witness.fold);
}

// Counted with the hand of its folded corner, the inner volume would be a cavity.
TEST(Certify, VolumesThatFoldAreInvalid) {
  const std::string nested = nested_volumes(".85 .6 .6");
  const Certified c = certify(read(nested, "folded.itd")).value();
  expect_folded(c,
                "entity 1: the volume folds: its map keeps the orientation of space at (1/2, 1/2, "
                "1/2) and reverses it at (1/4, 1/4, 1/4)");
  EXPECT_FALSE(c.copy);
  EXPECT_EQ(format_of_certificate(c), "itd");
  expect_accepted(nested, c);
  // Corners agree, and the middle does not: two inner control points are exchanged.
  const std::string inside =
      "[TRIVAR BEZIER 4 2 2 E3 [0 0 0][4 0 0][-3 0 0][1 0 0] [0 1 0][4 1 0][-3 1 0][1 1 0]"
      " [0 0 1][4 0 1][-3 0 1][1 0 1] [0 1 1][4 1 1][-3 1 1][1 1 1]]\n";
  const Certified middle = certify(read(inside, "folded.itd")).value();
  expect_folded(middle,
                "entity 0: the volume folds: its map keeps the orientation of space at (1/8, 1/8, "
                "1/8) and reverses it at (1/2, 1/2, 1/2)");
  expect_accepted(inside, middle);
}

// With an axis that is not clamped, the copy has the volumes, clamped, and is not about their faces.
TEST(Certify, VolumesThatFoldAndAreNotReadByCheckersAreInvalidByACopyOfTheVolumes) {
  const std::string loose =
      "[TRIVAR BSPLINE 2 2 2 2 2 2 E3 [KV 0 0 1 1] [KV -1 0 1 2] [KV 0 0 1 1]"
      " [0 0 0][1 0 0][0 1 0][1 1 0][0 0 1][1 0 1][0 1 1][.1 .1 .1]]\n";
  const Certified c = certify(read(loose, "loose.itd")).value();
  expect_folded(c, "entity 0: the volume folds");
  ASSERT_TRUE(c.copy);
  EXPECT_EQ(c.copy->what, "its 1 volume");
  EXPECT_FALSE(c.copy->is_of_volumes);
  EXPECT_FALSE(c.boundary_faces);
  EXPECT_EQ(format_of_certificate(c), "vjson");
  expect_accepted(c.copy->bytes, c);
}

// Where no certificate can say so, the volume still does not say which side of its faces is outside.
TEST(Certify, VolumesOfTooHighADegreeAreUndecidedThoughTheyFold) {
  std::string points;
  for (const char* const rest : {" 0 0]", " 1 0]", " 0 1]", " 1 1]"})
    for (int i = 0; i <= 16; ++i) points += " [" + std::to_string(i == 1 ? -1 : i) + rest;
  expect_undecided(certify(read("[TRIVAR BEZIER 17 2 2 E3" + points + "]\n", "high.itd")).value(),
                   "not-covered", "entity 0: the volume has the degree 16 along u");
}

// A volume says which side of its faces is outside, so that one inside another is no cavity.
TEST(Certify, NoOrientationMakesAVolumeACavity) {
  for (const auto orientation : {PatchOrientation::kKeep, PatchOrientation::kAuto}) {
    CertifyOptions options;
    options.orientation = orientation;
    const std::string nested = nested_volumes(".5 .25 .25");
    const Certified c = certify(read(nested, "nested.itd"), options).value();
    EXPECT_EQ(c.verdict, Verdict::kInvalid);
    EXPECT_EQ(c.findings.at(0).code, "overlap");
    EXPECT_FALSE(patch_facts(c).auto_helps);
    EXPECT_FALSE(c.copy);
    expect_accepted(nested, c);
  }
}

// A bar beside two halves of a bar, which cut their wall in two: arcs of its sides are shared by parts of faces.
TEST(Certify, FacesThatArePartsOfFacesAreNotGlued) {
  const std::string bar =
      "[TRIVAR BSPLINE 2 3 2 2 2 2 E3 [KV 0 0 1 1] [KV 0 0 1 2 2] [KV 0 0 1 1] [1 0 0][2 0 0]"
      "[1 1 0][2 1 0][1 2 0][2 2 0] [1 0 1][2 0 1][1 1 1][2 1 1][1 2 1][2 2 1]]\n";
  const auto half = [](const std::string& y, const std::string& z) {
    return "[TRIVAR BEZIER 2 2 2 E3 [0 " + y + " 0] [1 " + y + " 0] [0 " + z + " 0] [1 " + z +
           " 0] [0 " + y + " 1] [1 " + y + " 1] [0 " + z + " 1] [1 " + z + " 1]]\n";
  };
  const std::string bars = bar + half("0", "1") + half("1", "2");
  const Certified c = certify(read(bars, "bars.itd")).value();
  EXPECT_EQ(c.verdict, Verdict::kInvalid);
  EXPECT_EQ(c.findings.at(0).code, "curve-nonmanifold");
  expect_accepted(bars, c);
  // A cube on the middle of a plate shares no arc of a side: once the plate is cut, the two are valid.
  const auto plate = [](bool has_knots) {
    std::string points;
    for (const char* const z : {"0", "1"})
      for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
          if (has_knots || (x % 3 == 0 && y % 3 == 0))
            points +=
                "[" + std::to_string(x) + " " + std::to_string(y) + " " + std::string(z) + "]";
    const std::string size = has_knots ? "4" : "2", knots = has_knots ? "0 0 1 2 3 3" : "0 0 3 3";
    return "[TRIVAR BSPLINE " + size + " " + size + " 2 2 2 2 E3 [KV " + knots + "] [KV " + knots +
           "] [KV 0 0 1 1] " + points + "]\n";
  };
  const std::string cube =
      "[TRIVAR BEZIER 2 2 2 E3 [1 1 1][2 1 1][1 2 1][2 2 1][1 1 2][2 1 2][1 2 2][2 2 2]]\n";
  expect_undecided(certify(read(plate(true) + cube, "on.itd")).value(), "partial-contact",
                   "one cell has a part of another's face");
  expect_undecided(certify(read(plate(false) + cube, "on.itd")).value(), "contact", "touch");
}

// Decides the boundary faces of volumes alone.
CertifyOptions by_faces() {
  CertifyOptions out;
  out.with_collar = true;
  return out;
}

// Findings number the volumes and name faces and edges by the volume's parameters.
TEST(Certify, FindingsAboutVolumesNameTheirFaces) {
  const auto box = [](const std::string& x, const std::string& y, const std::string& z) {
    return "[TRIVAR BEZIER 2 2 2 E3 [" + x + " 0 0] [" + y + " 0 0] [" + x + " 1 0] [" + y +
           " 1 0] [" + x + " 0 " + z + "] [" + y + " 0 " + z + "] [" + x + " 1 " + z + "] [" + y +
           " 1 " + z + "]]\n";
  };
  const std::string crossing = box("0", "2", "1") +
                               "[TRIVAR BEZIER 2 2 2 E3 [.5 .5 .5] [1 .5 .5] "
                               "[.5 .75 .5] [1 .75 .5] [.5 .5 3] [1 .5 3] [.5 .75 3] [1 .75 3]]";
  const Certified cross = certify(read(crossing, "cross.itd"), by_faces()).value();
  EXPECT_EQ(cross.verdict, Verdict::kInvalid);
  ASSERT_EQ(cross.findings.size(), 1u);
  EXPECT_EQ(cross.findings[0].code, "patches-crossing");
  EXPECT_NE(cross.findings[0].message.find("face w = 1 of entity 0"), std::string::npos)
      << cross.findings[0].message;
  for (const EntityPart& part : cross.findings[0].place.parts) {
    ASSERT_TRUE(part.face);
    EXPECT_FALSE(part.side);
    ASSERT_EQ(part.parameters.size(), 3u);
    const auto& across = part.parameters[*part.face / 2u];
    EXPECT_EQ(across[0], *part.face % 2u);
    EXPECT_EQ(across[1], *part.face % 2u);
    // The point of the finding is the volume's at these parameters.
    const Point3d& near = *cross.findings[0].place.near;
    for (std::size_t k = 0; k < 3; ++k) {
      constexpr std::array<std::array<double, 3>, 2> kFrom = {{{0, 0, 0}, {.5, .5, .5}}},
                                                     kTo = {{{2, 1, 1}, {1, .75, 3}}};
      const double from = kFrom[part.entity][k], length = kTo[part.entity][k] - from;
      EXPECT_GE(near[k], from + length * part.parameters[k][0] - 1e-9);
      EXPECT_LE(near[k], from + length * part.parameters[k][1] + 1e-9);
    }
  }
  // Two cubes with a common edge.
  const std::string edge = box("0", "1", "1") +
                           "[TRIVAR BEZIER 2 2 2 E3 [1 1 0] [2 1 0] [1 2 0] [2 2 0] [1 1 1] [2 1 "
                           "1] [1 2 1] [2 2 1]]";
  const Certified shared = certify(read(edge, "edge.itd"), by_faces()).value();
  EXPECT_EQ(shared.verdict, Verdict::kInvalid);
  ASSERT_EQ(shared.findings.size(), 1u);
  EXPECT_EQ(shared.findings[0].message.rfind(
                "edge u = 1, v = 1 of entity 0 and 3 other sides are one curve", 0),
            0u)
      << shared.findings[0].message;
}

// The parts of a finding lie on the volumes at the parameters that they name.
void expect_in_volumes(const SplineModel& model, const Finding& f) {
  ASSERT_TRUE(f.place.near);
  for (const EntityPart& part : f.place.parts) {
    ASSERT_LT(part.entity, model.entities.size()) << f.message;
    ASSERT_TRUE(part.face && part.parameters.size() == 3) << f.message;
    EXPECT_FALSE(part.side);
    const auto& volume = std::get<ExactVolume>(model.entities[part.entity].shape);
    const auto& axis = volume.axis(*part.face / 2u);
    const auto& across = part.parameters[*part.face / 2u];
    EXPECT_EQ(across[0],
              nearest_double(*part.face % 2u == 0 ? axis.domain_begin() : axis.domain_end()));
    // These volumes are boxes, so that the images of the least and of the greatest parameters are corners.
    std::array<std::vector<Rational>, 2> corners;
    for (std::size_t end = 0; end < 2; ++end) {
      std::array<Rational, 3> at;
      for (std::size_t k = 0; k < 3; ++k) at[k] = Rational::from_double(part.parameters[k][end]);
      corners[end] = point(volume, at).value();
    }
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_LE(nearest_double(corners[0][c]), (*f.place.near)[c] + 1e-9) << f.message;
      EXPECT_GE(nearest_double(corners[1][c]), (*f.place.near)[c] - 1e-9) << f.message;
    }
  }
}

// A box from (0, 0, 0) to (4, 1, 1) of two spans along u, whose ends are not clamped there, with u from 3 to 7.
const std::string kLooseBox =
    "[TRIVAR BSPLINE 3 2 2 2 2 2 E3 [KV 2 3 5 7 9] [KV 0 0 1 1] [KV 0 0 1 1] [0 0 0][2 0 0][4 0 0]"
    "[0 1 0][2 1 0][4 1 0] [0 0 1][2 0 1][4 0 1][0 1 1][2 1 1][4 1 1]]\n";

// A copy of volumes has pieces of their faces as its entities; the file has volumes.
TEST(Certify, FindingsAboutACopyOfVolumesNameTheVolumes) {
  const std::string pin =
      "[TRIVAR BEZIER 2 2 2 E3 [2.5 .25 .5][3.5 .25 .5][2.5 .75 .5][3.5 .75 .5] [2.5 .25 3]"
      "[3.5 .25 3][2.5 .75 3][3.5 .75 3]]\n";
  const std::string crossing = kLooseBox + pin;
  const ModelFile file = read(crossing, "cross.itd");
  const Certified c = certify(file, by_faces()).value();
  EXPECT_EQ(c.verdict, Verdict::kInvalid);
  ASSERT_TRUE(c.copy);
  expect_accepted(c.copy->bytes, c);
  ASSERT_EQ(c.findings.size(), 1u);
  EXPECT_EQ(c.findings[0].code, "patches-crossing");
  EXPECT_NE(c.findings[0].message.find("face w = 1 of entity 0"), std::string::npos)
      << c.findings[0].message;
  ASSERT_EQ(c.findings[0].place.parts.size(), 2u);
  EXPECT_EQ(c.findings[0].place.parts[0].entity + c.findings[0].place.parts[1].entity, 1u);
  expect_in_volumes(std::get<SplineFile>(file).model, c.findings[0]);
  for (const EntityPart& part : c.findings[0].place.parts)
    if (part.entity == 0) {
      EXPECT_GE(part.parameters[0][0], 5);  // the second span
      EXPECT_LE(part.parameters[0][1], 7);
    }
}

// A wall that is cut in halves on one side only: the corner of a half lies inside a side.
TEST(Certify, WhatIsOpenOfACopyIsNamedByVolumes) {
  const std::string half =
      "[TRIVAR BEZIER 2 2 2 E3 [0 1 0][2 1 0][0 2 0][2 2 0] [0 1 1/2][2 1 1/2][0 2 1/2][2 2 "
      "1/2]]\n";
  std::string lower = half;
  for (std::size_t at; (at = lower.find("1/2")) != lower.npos;) lower.replace(at, 3, ".5");
  const ModelFile file = read(kLooseBox + lower, "step.itd");
  const Certified c = certify(file, by_faces()).value();
  EXPECT_TRUE(c.copy);
  ASSERT_FALSE(c.findings.empty());
  EXPECT_NE(c.verdict, Verdict::kValid);
  for (const Finding& f : c.findings) {
    EXPECT_EQ(f.message.find("surface "), std::string::npos) << f.message;
    for (const EntityPart& part : f.place.parts) {
      EXPECT_LT(part.entity, 2u) << f.message;
      EXPECT_TRUE(part.face) << f.message;
    }
    EXPECT_LT(f.place.source.entity.value_or(0), 2u) << f.message;
  }
  for (const OpenSideFacts& side : patch_facts(c).open_sides) {
    EXPECT_LT(side.part.entity, 2u);
    EXPECT_TRUE(side.part.face);
  }
}

// Four sides of patches are one curve, a line inside a face of a bar and an edge of a box: no proof names it, and the message is all.
TEST(Certify, WhatKeepsFacesFromASurfaceIsNamedByTheVolumes) {
  std::string bar = kLooseBox;
  bar.replace(bar.find("[KV 2 3 5 7 9]"), 14, "[KV 3 3 5 7 7]");
  const std::string standing =
      "[TRIVAR BEZIER 2 2 2 E3 [2 1 0][3 2 0][1 2 0][2 3 0] [2 1 1][3 2 1][1 2 1][2 3 1]]\n";
  const Certified c = certify(read(bar + standing, "standing.itd")).value();
  EXPECT_FALSE(c.copy);
  expect_undecided(c, "not-certified",
                   "surface; overused-side: edge u = 5, v = 1 of entity 0, edge u = 5, v = 1 of "
                   "entity 0, edge u = 0, v = 0 of entity 1, ...");
}

// A patch of degree 16 has no certificate. The volume is flat, too, which is found only when its faces are made.
TEST(Certify, VolumesOfTooHighADegreeAreRefusedBeforeTheirFacesAreMade) {
  std::string points;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 17; ++j)
      for (int i = 0; i < 2; ++i)
        points += " [" + std::to_string(i) + " " + std::to_string(j) + " 0]";
  const std::string cube =
      "[TRIVAR BEZIER 2 2 2 E3 [5 0 0][6 0 0][5 1 0][6 1 0] [5 0 1][6 0 1][5 1 1][6 1 1]]\n";
  expect_undecided(
      certify(read(cube + "[TRIVAR BEZIER 2 17 2 E3" + points + "]\n", "high.itd")).value(),
      "not-covered",
      "entity 1: the volume has the degree 16 along v, and certificates are about volumes of a "
      "degree of at most 15");
}

// The number lies in the second volume, and its pieces are the entities 10 to 19 of the copy.
TEST(Certify, LongNumbersInACopyOfVolumesAreThoseOfAVolume) {
  std::string high = kLooseBox;
  for (std::size_t at; (at = high.find(" 1]")) != high.npos;)
    high.replace(at, 3, " 3." + std::string(5200, '3') + "]");
  for (std::size_t at; (at = high.find(" 0]")) != high.npos;) high.replace(at, 3, " 2]");
  ModelReadOptions wide;
  wide.limits.max_digits = 6000;
  SplineFile file = std::get<SplineFile>(read(kLooseBox + high, "long.itd", wide));
  file.beyond_default_limits.reset();
  expect_undecided(certify(file).value(), "not-covered", "about: entity 1: ");
}

}  // namespace
}  // namespace veritope
