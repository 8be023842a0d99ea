// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/cage/hull_cage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "solids/micro/cage/cage_containment.h"
#include "solids/vmodel/jacobian_sign.h"
#include "tests/solids/cage_support.h"
#include "tests/support/paths.h"

namespace veritope {
namespace {

using namespace cage_test;

// Two boxes along x and y that meet at a corner: an L.
CageContent ell() {
  return content_of(together(box_mesh({0, 0, 0}, {4, 1, 1}), box_mesh({0, 0, 0}, {1, 4, 1})));
}

Rational volume_of(const CellVolume& cell) {
  const Certified answer = certified({cell});
  EXPECT_EQ(answer.verdict, Verdict::kValid);
  return std::get<PatchFacts>(answer.facts).vmodel->volume.value();
}

TEST(HullCage, IsCertifiedContainsTheModelAndIsTighterThanTheBox) {
  const CageContent content = ell();
  HullCageOptions options;
  options.margin = q(1, 4);
  options.rounds = 0;
  const Rational box = volume_of(hull_cage(content, options).value().cell);
  EXPECT_GE(box, q(9, 2) * q(9, 2) * q(3, 2));
  options.rounds = 12;
  for (const auto& [degree, part] : {std::pair{1, q(3, 4)}, {2, q(9, 10)}}) {
    options.grid.degrees = {degree, degree, degree};
    const HullCage hull = hull_cage(content, options).value();
    EXPECT_GT(hull.rounds, 0u);
    const VModel model = model_of({hull.cell});
    EXPECT_TRUE(decide_determinants(model).is_proved());
    EXPECT_FALSE(find_gap(model, content));
    EXPECT_LT(volume_of(hull.cell), box * part);
  }
}

TEST(HullCage, ControlPointsAreShortDyadics) {
  HullCageOptions options;
  options.margin = q(1, 4);
  options.rounds = 3;
  const HullCage hull = hull_cage(ell(), options).value();
  // The diagonal is between 4 and 8: multiples of 2^(2 - 16).
  for (const Rational& x : hull.cell.coefficients())
    EXPECT_EQ((x * Rational::power_of_two(14)).denominator(), Integer(1)) << x.to_string();
  EXPECT_EQ(hull_cage(ell(), options).value().cell, hull.cell);
}

TEST(HullCage, AModelOfPartsFarApartIsContained) {
  const CageContent content =
      content_of(together(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({3, 3, 3}, {4, 4, 4})));
  HullCageOptions options;
  options.margin = q(1, 8);
  options.rounds = 4;
  const HullCage hull = hull_cage(content, options).value();
  EXPECT_FALSE(find_gap(model_of({hull.cell}), content));
  EXPECT_EQ(certified({hull.cell}).verdict, Verdict::kValid);
}

TEST(HullCage, RefusesWhatHasNoCage) {
  HullCageOptions options;
  EXPECT_EQ(hull_cage(ell(), options).error().message, "margin must be positive, not 0");
  options.margin = q(1);
  EXPECT_EQ(hull_cage({}, options).error().message, "content without a part has no cage");
  options.grid.degrees[1] = 0;
  EXPECT_EQ(hull_cage(ell(), options).error().code, Code::kBadArgument);
  options.grid.degrees[1] = 1;
  options.grid.spans = {32, 32, 33};
  EXPECT_EQ(hull_cage(ell(), options).error().code, Code::kOverLimit);
  options.grid.spans = {1, 1, 1};
  const double far = 0x1p40;
  options.margin = q(1, 1024);
  EXPECT_EQ(hull_cage(content_of(box_mesh({far, 0, 0}, {far + 0x1p-10, 0x1p-10, 0x1p-10})), options)
                .error()
                .code,
            Code::kOverLimit);
}

TEST(HullCage, ContainsTheBunny) {
  const std::string path = test::data_dir() + "/mesh/solid1/pmp-data__bunny_adaptive.off";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "needs VERITOPE_DATA";
  const CageContent content = content_of(read_mesh_file(path, {}).value().mesh);
  HullCageOptions options;
  options.margin = margin_length(box_of(content), q(1, 30));
  options.rounds = 2;
  const HullCage hull = hull_cage(content, options).value();
  EXPECT_EQ(hull.rounds, 2u);
  EXPECT_FALSE(find_gap(model_of({hull.cell}), content));
  EXPECT_EQ(certified({hull.cell}).verdict, Verdict::kValid);
}

}  // namespace
}  // namespace veritope
