// SPDX-License-Identifier: LGPL-3.0-or-later
// THEORY 1: boxes that satisfy C1, C2 and C3 of the paper, and not its theorem.
#include <gtest/gtest.h>

#include "models/patch_shapes.h"
#include "models/plane_shapes.h"
#include "solids/interval_boxes/conditions.h"

namespace veritope {
namespace {

BoundaryModel model_of(patch_shapes::Patches patches) {
  return BoundaryModel::make(make_patch_complex(std::move(patches)).value()).value();
}
std::vector<Box3d> three_boxes() {
  return {{{-1.5, -1.5, -1.5}, {0.1, 1.5, 1.5}},
          {{-0.1, -0.1, -1.5}, {1.5, 1.5, 1.5}},
          {{-0.1, -1.5, -1.5}, {1.5, 0.1, 1.5}}};
}
std::string offences(const ConditionResult& r) {
  std::string out = to_string(r.answer);
  for (const BoxOffence& o : r.offences) out += "\n  " + to_string(o);
  return out;
}
// All conditions of the paper hold, and C3* fails at one set of boxes: at the three.
BoxOffence only_offence(BoundaryModel& model, const std::vector<Box3d>& boxes) {
  const PaperConditions all = decide_conditions(model, boxes).value();
  for (std::size_t k = 0; k < kNumPaperConditions; ++k) {
    const auto c = static_cast<PaperCondition>(k);
    EXPECT_EQ(all[c].answer, c == PaperCondition::kC3Star ? Answer::kFalse : Answer::kTrue)
        << name_of(c) << ": " << offences(all[c]);
  }
  const ConditionResult& c3_star = all[PaperCondition::kC3Star];
  EXPECT_EQ(c3_star.num_false, 1u);
  if (c3_star.offences.empty()) return {};
  EXPECT_EQ(c3_star.offences[0].boxes, (std::vector<std::uint32_t>{0, 1, 2}));
  return c3_star.offences[0];
}

TEST(CounterexampleC3, Corollary26TheThreeBoxesHoldTheWholeBall) {
  for (auto sphere : {patch_shapes::sphere(), patch_shapes::octant_sphere()}) {
    BoundaryModel model = model_of(std::move(sphere));
    EXPECT_EQ(only_offence(model, three_boxes()).euler, 2) << "two disks at the poles";
  }
}

// M = [-4,4]^3 without the open unit ball: the union of M and the nine boxes has no cavity any more.
TEST(CounterexampleC3, Theorem25WithTheSixSlabs) {
  auto boxes = three_boxes();
  for (std::size_t k = 0; k < 3; ++k)
    for (const double at : {-4.0, 4.0}) {
      Box3d slab{{-4.5, -4.5, -4.5}, {4.5, 4.5, 4.5}};
      slab.lo[k] = at - 0.5, slab.hi[k] = at + 0.5;
      boxes.push_back(slab);
    }
  BoundaryModel model =
      model_of(patch_shapes::joined({patch_shapes::box({-4, -4, -4}, {4, 4, 4}),
                                     patch_shapes::reversed(patch_shapes::sphere())}));
  EXPECT_EQ(only_offence(model, boxes).euler, 2);
}

// The unit circle and the same rectangles: their common part misses the circle altogether.
TEST(CounterexampleC3, InThePlaneTheTripleMissesTheCircle) {
  BoundaryModel model = BoundaryModel::make_planar({plane_shapes::circle()}).value();
  EXPECT_EQ(only_offence(model, three_boxes()).why, BoxOffence::Why::kMissed);
}

}  // namespace
}  // namespace veritope
