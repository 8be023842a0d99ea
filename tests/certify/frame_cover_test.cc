// SPDX-License-Identifier: LGPL-3.0-or-later
// Thin walls: covers with boxes in frames and with several sheets, from the search to the checker.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string>

#include "models/thin_shapes.h"
#include "solids/patches/patch_transform.h"
#include "solids/pieces/exact_piece.h"
#include "tests/certify/patch_round_trip.h"
#include "tests/support/checker_call.h"

namespace veritope {
namespace {

using thin_shapes::Family;
using thin_shapes::Walls;

Rational gap_of(int digits) {
  Rational out(1);
  for (int i = 0; i < digits; ++i) out /= Rational(10);
  return out;
}
std::string name_of(const Family& family, int digits) {
  return family.name + ", gap 1e-" + std::to_string(digits);
}
const Family& family_of(const std::string& name) {
  static const std::vector<Family> all = thin_shapes::families();
  for (const Family& f : all)
    if (f.name == name) return f;
  throw std::logic_error(name);
}

// The point A P of a control point lies in the box, in integers and rationals.
void expect_leaf_inside(const PieceForest& forest, PieceForest::Id id, const CoverBox& box,
                        const std::string& what) {
  const ExactPiece piece(forest, forest.node(id));
  const BoxFrame frame = box.framed ? box.framed->sheets.frame : BoxFrame();
  const Box3d& in = box.framed ? box.framed->sheets.box : box.star.box;
  for (std::size_t i = 0; i < forest.form(forest.node(id).patch).shape.count(); ++i) {
    const auto p = piece.control(i);
    for (std::size_t r = 0; r < 3; ++r) {
      Rational y;
      for (std::size_t c = 0; c < 3; ++c)
        y += Rational(frame.rows()[r][c]) * Rational(*p[c], *p[3]);
      EXPECT_TRUE(Rational::from_double(in.lo[r]) <= y && y <= Rational::from_double(in.hi[r]))
          << what << ", node " << id << ", control point " << i << ", row " << r;
    }
  }
}

void expect_leaves_inside(const PieceForest& forest, const StarCover& cover,
                          const std::string& what) {
  std::vector<bool> is_named(cover.boxes.size());
  for (PieceForest::Id id = 0; id < cover.box_of_node.size(); ++id) {
    const std::uint32_t box = cover.box_of_node[id];
    if (box == StarCover::kNone) continue;
    is_named[box] = true;
    expect_leaf_inside(forest, id, cover.boxes[box], what);
  }
  EXPECT_EQ(std::count(is_named.begin(), is_named.end(), false), 0) << what;
}

// How many boxes in frames take a descent to more than 1,024 pieces.
std::size_t num_large_boxes(PieceForest& forest, const StarCover& cover) {
  return std::count_if(cover.boxes.begin(), cover.boxes.end(), [&](const CoverBox& box) {
    SheetPieces pieces;
    if (!box.framed) return false;
    EXPECT_TRUE(find_sheet_pieces(forest, box.framed->sheets, 1024, &pieces));
    return pieces.num_visited > 1024;
  });
}

// The patches are those of the family's sound solid, or an affine image. Returns the number of boxes.
std::size_t expect_certified(const Family& family, const patch_shapes::Patches& patches,
                             const std::string& what, const FileDecisionOptions& options = {},
                             std::size_t* num_large = nullptr) {
  const std::string bytes = spline_json_bytes(model_of(patches));
  const SplineFile file = spline_file_of(bytes);
  FilePatches model = file_patches(file.model, PatchOrientation::kKeep).value();
  FileDecision decided = decide_file_patches(model, options);
  const PatchDecision& d = decided.decision;
  EXPECT_TRUE(d.is_valid) << what << ": " << (d.open ? d.open->message : std::string("refuted"));
  if (!d.is_valid) return 0;
  EXPECT_EQ(d.bodies, static_cast<std::uint64_t>(family.bodies)) << what;
  EXPECT_EQ(d.shells.size(), family.genus.size()) << what;
  for (std::size_t s = 0; s < d.shells.size(); ++s)
    EXPECT_EQ(d.shells[s].genus, family.genus[s]) << what << ", shell " << s;
  expect_leaves_inside(*decided.forest, d.cover, what);
  const certificate::Bytes certificate =
      make_patch_certificate(model, decided, subject_of(file, "tests"));
  const std::string claim =
      d.cover.needs_version_2() ? "ACCEPT star-box-2: " : "ACCEPT star-box-1: ";
  const std::string answer =
      check_in_process(bytes, std::string(certificate.begin(), certificate.end()));
  EXPECT_EQ(answer.substr(0, claim.size()), claim) << what << ": " << answer;
  if (num_large != nullptr) *num_large = num_large_boxes(*decided.forest, d.cover);
  return d.cover.boxes.size();
}

std::size_t expect_certified(const Family& family, int digits) {
  return expect_certified(family, family.make(gap_of(digits), Walls::kApart),
                          name_of(family, digits));
}

// Gaps of ten to the minus these powers.
void expect_bounded(const std::string& name, const std::vector<int>& all_digits, double growth,
                    std::size_t most) {
  const Family& family = family_of(name);
  std::map<int, std::size_t> boxes;
  for (const int digits : all_digits) {
    boxes[digits] = expect_certified(family, digits);
    EXPECT_LE(boxes[digits], most) << name_of(family, digits);
    if (boxes.count(2) != 0) {
      EXPECT_LE(static_cast<double>(boxes[digits]), growth * static_cast<double>(boxes[2]))
          << name_of(family, digits);
    }
  }
}

TEST(FrameCover, OfSpheresDoesNotGrowAsTheirGapShrinks) {
  expect_bounded("spheres", {2, 6}, 2, 1000);
}
TEST(FrameCover, OfSpheresHasWalksAcrossVerySmallGaps) { expect_bounded("spheres", {11}, 2, 1000); }

// The rotation by the quaternion, then (x, y, z + shear y), then a shift by eighths, which takes from doubles bits that a
// gap needs.
AffineMap rotation_and_shear(const std::array<std::int64_t, 4>& quaternion, int shear,
                             const std::array<int, 3>& shift) {
  const auto [w, x, y, z] = quaternion;
  const Rational norm(w * w + x * x + y * y + z * z);
  AffineMap out{3, 3, {}, {}};
  for (const int v : shift) out.translation.push_back(Rational(v) / Rational(8));
  for (const std::int64_t v :
       {w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),
        2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),
        2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z})
    out.linear.push_back(Rational(v) / norm);
  for (std::size_t c = 0; c < 3; ++c) out.linear[6 + c] += Rational(shear) * out.linear[3 + c];
  return out;
}
// From a corner of such a plate no half-line is free in doubles, nor from a point as near to a side as the gap is long.
TEST(FrameCover, OfVeryThinPlatesThatAreShearedHasWalks) {
  for (const char* const name : {"plate", "plate-turned"})
    for (const int bits : {34, 38})
      for (const std::array<std::int64_t, 4> quaternion :
           {std::array<std::int64_t, 4>{5, 2, -2, 1}, {3, 2, 1, 1}}) {
        const Family& family = family_of(name);
        const auto image = affine_image(family.make(Rational::power_of_two(-bits), Walls::kApart),
                                        rotation_and_shear(quaternion, 4, {-48, 32, 160}));
        ASSERT_TRUE(image.has_value());
        expect_certified(family, *image,
                         std::string(name) + ", gap 2^-" + std::to_string(bits) + ", quaternion " +
                             std::to_string(quaternion[0]) + "...");
      }
}

// The walk from the inner sphere needs a box of the outer one beside its own.
TEST(FrameCover, OfTurnedSpheresHasAWalkAcrossAVerySmallGap) {
  const Family& family = family_of("spheres");
  const auto image =
      affine_image(family.make(Rational(7) * Rational::power_of_two(-35), Walls::kApart),
                   rotation_and_shear({-1, 2, 3, 0}, 0, {29, 35, -67}));
  ASSERT_TRUE(image.has_value());
  expect_certified(family, *image, "turned spheres");
}

// One of these two shears, after a rotation, kept a search by Euclid's lengths alone busy for a minute without an answer.
TEST(FrameCover, OfAShearedModelIsHardlyLonger) {
  const AffineMap map{3, 3, {1, 4, 0, 0, 1, 0, 4, 0, 1}, {0, 0, 0}};
  const Family& family = family_of("spheres");
  const auto image = affine_image(family.make(gap_of(3), Walls::kApart), map);
  ASSERT_TRUE(image.has_value());
  EXPECT_LE(expect_certified(family, *image, "sheared spheres"), 2000);
}
// Nodes that only tests of boxes needed are made again where later boxes need them, with other numbers. Their nets may
// be rounded otherwise.
TEST(FrameCover, HasHardlyOtherBoxesWhenNodesAreDropped) {
  for (const auto& [name, digits] :
       std::vector<std::pair<std::string, int>>{{"tube", 2}, {"eccentric", 4}, {"tori", 2}}) {
    const Family& family = family_of(name);
    FileDecisionOptions few;
    few.search.cover.most_nodes = 500;
    const auto boxes = static_cast<double>(expect_certified(family, digits));
    EXPECT_NEAR(
        static_cast<double>(expect_certified(family, family.make(gap_of(digits), Walls::kApart),
                                             name_of(family, digits) + ", few nodes", few)),
        boxes, 0.01 * boxes);
  }
}
// One test of a box makes so many nodes that no others have room. They are dropped, and the search goes on.
TEST(FrameCover, OfATubeIsFoundWithFewNodes) {
  MemoryBudget budget(std::uint64_t{50} << 20);
  FileDecisionOptions little;
  little.search.budget = &budget;
  const Family& family = family_of("tube");
  EXPECT_LE(
      expect_certified(family, family.make(gap_of(3), Walls::kApart), "tube in 50 MiB", little),
      3000);
  EXPECT_LE(budget.most(), budget.limit());
}
TEST(FrameCover, OfPlatesDoesNotGrowAsTheyGetThinner) {
  expect_bounded("plate", {2, 3, 4, 5, 6}, 2, 100);
  expect_bounded("plate-turned", {2, 3, 4, 5, 6, 10}, 2, 100);
}

TEST(FrameCover, OfCurvedWallsAndWedgesIsAcceptedByTheChecker) {
  for (const auto& [name, digits] : std::vector<std::pair<std::string, int>>{{"tube", 1},
                                                                             {"tube", 2},
                                                                             {"cone", 1},
                                                                             {"tori", 1},
                                                                             {"wedge", 1},
                                                                             {"wedge", 6},
                                                                             {"eccentric", 2},
                                                                             {"curved-plate", 2},
                                                                             {"nested", 1},
                                                                             {"nested", 3},
                                                                             {"eccentric", 6}})
    expect_bounded(name, {digits}, 2, 4000);
}

// Its certificate takes half of the checkers' budget, more than that of other models does. It takes 0.8 of it where oblique
// frames are not tried, and then more than 200 boxes beside the rims meet many pieces.
TEST(FrameCover, OfAThinCurvedPlateHasFewBoxesThatMeetManyPieces) {
  const Family& family = family_of("curved-plate");
  std::size_t num_large = 0;
  EXPECT_LE(expect_certified(family, family.make(gap_of(4), Walls::kApart), name_of(family, 4), {},
                             &num_large),
            6500);
  EXPECT_LE(num_large, 40);
}

// A row of solids of one family, 16 apart along x, and a family that has the genus and the bodies of the whole row.
struct Row {
  Family family;
  patch_shapes::Patches patches;
};
Row row_of(const Family& one, const Rational& gap, int count) {
  const patch_shapes::Patches patches = one.make(gap, Walls::kApart);
  Row out{{std::to_string(count) + " of " + one.name, one.make, {}, count * one.bodies}, {}};
  for (int i = 0; i < count; ++i) {
    const auto next =
        patch_shapes::placed(patches, Rational(1), {Rational(16 * i), Rational(), Rational()});
    out.patches = i == 0 ? next : patch_shapes::joined({out.patches, next});
    out.family.genus.insert(out.family.genus.end(), one.genus.begin(), one.genus.end());
  }
  return out;
}

// The half-line from a shell that needs a box for its walk meets a side of the next copy, which lies across it and has
// boxes on its parts only.
TEST(FrameCover, OfTwoCopiesBesideEachOtherIsAcceptedByTheChecker) {
  for (const auto& [name, denominator] :
       {std::pair{"curved-plate", 30}, {"plate-turned", 100}, {"spheres", 100}, {"tube", 30}}) {
    const Row row = row_of(family_of(name), Rational(1) / Rational(denominator), 2);
    expect_certified(row.family, row.patches, row.family.name);
  }
}
// The row takes 63 of the checkers' units of work for each byte. A single pair of spheres would be accepted with 40 a byte, because
// of the units that every certificate has.
TEST(FrameCover, OfManyCopiesIsWithinTheCheckersBudget) {
  const Row row = row_of(family_of("eccentric"), gap_of(6), 10);
  expect_certified(row.family, row.patches, row.family.name);
}

// The numbers of roots of the patches of a model, the least and the greatest.
std::pair<std::uint32_t, std::uint32_t> roots_of(const patch_shapes::Patches& patches) {
  const PatchComplex complex = make_patch_complex(patches).value();
  const PieceForest forest = PieceForest::make(complex, PieceForest::FrameChoice::kWhole).value();
  std::pair<std::uint32_t, std::uint32_t> out{~std::uint32_t{0}, 0};
  for (std::uint32_t p = 0; p < forest.num_patches(); ++p) {
    out.first = std::min(out.first, forest.form(p).num_roots);
    out.second = std::max(out.second, forest.form(p).num_roots);
  }
  return out;
}
TEST(FrameCover, CutsRimsToTheSquareRootOfTheirWidthAndStraightOnesNot) {
  for (const int bits : {10, 20, 34, 44}) {
    const Rational gap = Rational::power_of_two(-bits);
    EXPECT_EQ(roots_of(thin_shapes::turned(thin_shapes::plate(gap, gap))), std::pair(1u, 1u))
        << bits;
  }
  for (const int bits : {8, 12, 16, 20}) {
    const Rational gap = Rational::power_of_two(-bits);
    const auto [wall, rim] = roots_of(thin_shapes::cone(1, gap, gap));
    EXPECT_EQ(wall, 1u) << bits;
    EXPECT_EQ(rim, 1u << (bits / 2)) << bits;
  }
}

// Without frames along creases 7,500 boxes, without tight boxes 5,600: an acute rim needs both.
TEST(FrameCover, OfAnAcuteRimHasLongBoxes) { expect_bounded("cone", {3}, 2, 4800); }

TEST(FrameCover, OfWallsThatTouchOrCrossIsNone) {
  for (const Family& family : thin_shapes::families())
    for (const Walls walls : {Walls::kTouching, Walls::kCrossing}) {
      constexpr int digits = 3;
      const auto complex = make_patch_complex(family.make(gap_of(digits), walls));
      if (!complex) continue;  // a ring without a width
      std::optional<PieceForest> forest;
      PatchDecisionOptions options;
      options.with_frames = true;
      options.cover.max_boxes = 3000;
      const PatchDecision decision = decide_patches(complex.value(), options, &forest);
      const std::string what =
          name_of(family, digits) + (walls == Walls::kTouching ? ", touching" : ", crossing");
      EXPECT_FALSE(decision.is_valid) << what;
      // Without the search for crossings, too.
      PieceForest whole =
          PieceForest::make(complex.value(), PieceForest::FrameChoice::kWhole).value();
      options.cover.with_frames = true;
      options.cover.max_level = 9;
      EXPECT_FALSE(find_star_cover(whole, options.cover).is_complete()) << what;
    }
}

}  // namespace
}  // namespace veritope
