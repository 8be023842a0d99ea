// SPDX-License-Identifier: LGPL-3.0-or-later
// THEORY 1: boxes that satisfy C1, C2 and C3 of the paper, and not its theorem.
#include <gtest/gtest.h>

#include "solids/interval_boxes/conditions.h"
#include "solids/patch_shapes.h"

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
void expect(const PaperConditions& all, PaperCondition c, Answer answer) {
  EXPECT_EQ(all[c].answer, answer) << name_of(c) << ": " << offences(all[c]);
}

TEST(CounterexampleC3, Corollary26TheThreeBoxesHoldTheWholeBall) {
  for (auto sphere : {patch_shapes::sphere(), patch_shapes::octant_sphere()}) {
    BoundaryModel model = model_of(std::move(sphere));
    const auto all = decide_conditions(model, three_boxes()).value();
    for (const PaperCondition c : {PaperCondition::kA, PaperCondition::kB1, PaperCondition::kB2,
                                   PaperCondition::kC1, PaperCondition::kC2, PaperCondition::kC3})
      expect(all, c, Answer::kTrue);
    expect(all, PaperCondition::kC3Star, Answer::kFalse);
    ASSERT_EQ(all[PaperCondition::kC3Star].num_false, 1u);
    const BoxOffence& o = all[PaperCondition::kC3Star].offences[0];
    EXPECT_EQ(o.boxes, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(o.euler, 2) << "two disks at the poles";
  }
}

}  // namespace
}  // namespace veritope
