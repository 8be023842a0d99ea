// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/interval_boxes/surface_boxes.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "solids/interval_boxes/box_union.h"
#include "solids/interval_boxes/conditions.h"
#include "solids/interval_boxes/plane_shapes.h"
#include "solids/patch_shapes.h"

namespace veritope {
namespace {

BoundaryModel model_of(patch_shapes::Patches patches) {
  return BoundaryModel::make(make_patch_complex(std::move(patches)).value()).value();
}

TEST(Probe, Print) {
  const std::vector<std::pair<const char*, patch_shapes::Patches>> shapes = {
      {"box", patch_shapes::box({0, 0, 0}, {1, 1, 1})},
      {"octant", patch_shapes::octant_sphere()},
      {"pn_torus", patch_shapes::pn_torus(12, 8)}};
  for (const auto& [name, patches] : shapes)
    for (const double eps : {0.5, 0.25}) {
      BoundaryModel model = model_of(patches);
      const auto cover = make_surface_cover(model, eps).value();
      std::size_t kinds[3]{};
      for (const auto& b : cover.boxes) ++kinds[static_cast<std::size_t>(b.kind)];
      std::printf("%s %g: %zu face %zu edge %zu vertex, largest %g\n", name, eps, kinds[0], kinds[1], kinds[2], cover.largest);
      ConditionOptions o;
      o.max_intersections = 3000;
      const auto all = decide_conditions(model, cover.plain_boxes(), o).value();
      for (std::size_t c = 0; c < kNumPaperConditions; ++c) {
        const auto& r = all.results[c];
        std::printf("  %s %s false %zu undecided %zu of %zu\n", name_of(static_cast<PaperCondition>(c)), to_string(r.answer), (size_t)r.num_false, (size_t)r.num_undecided, (size_t)r.checked);
        if (!r.offences.empty()) std::printf("     %s\n", to_string(r.offences[0]).c_str());
      }
    }
}

}  // namespace
}  // namespace veritope
