// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/tile_certifier.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "solids/micro/bifurcation.h"
#include "solids/micro/frame.h"
#include "tests/support/micro_cells.h"

namespace veritope {
namespace {

using micro_cells::at;
using micro_cells::box_tile;
using micro_cells::square;

std::string code_of(const MicroTile& tile) {
  const auto found = star_boxes_of(tile);
  const auto* const finding = std::get_if<Finding>(&found);
  return finding != nullptr ? finding->code : "";
}
MicroTile joined(MicroTile a, const MicroTile& b) {
  a.patches.insert(a.patches.end(), b.patches.begin(), b.patches.end());
  return a;
}
MicroTile inside_out(MicroTile tile) {
  for (TilePatch& p : tile.patches) std::swap(p.points[0][1], p.points[0][2]);
  return tile;
}

// PROVES MICRO-1.F3
TEST(TileCertifier, ProvesTilesThatAreNoStars) {
  JackShape bent;
  bent.arms = 31;
  for (const MicroTile& tile : {frame_tile({}).value(), bifurcation_tile(bent).value(),
                                jack_tile({}).value(), box_tile({16, 16, 0}, {48, 48, 64})}) {
    const auto found = star_boxes_of(tile);
    ASSERT_TRUE(std::holds_alternative<certificate::StarBoxBody>(found)) << tile.name;
    const auto& body = std::get<certificate::StarBoxBody>(found);
    EXPECT_EQ(body.version, 2);
    ASSERT_EQ(body.entities.size(), tile.patches.size());
    for (const certificate::PatchEntity& e : body.entities) {
      EXPECT_TRUE(e.is_surface);
      EXPECT_FALSE(e.is_reversed);
      EXPECT_EQ(e.breaks[0].size(), 2u);
      EXPECT_EQ(e.breaks[1].size(), 2u);
    }
    EXPECT_FALSE(certificate::encode(body).empty());
  }
}

// PROVES MICRO-1.F3
TEST(TileCertifier, RefusesWhatIsNotOneSolid) {
  const MicroTile box = box_tile({8, 8, 8}, {32, 32, 32});
  EXPECT_EQ(code_of(inside_out(box)), "inside-out");
  EXPECT_EQ(code_of(joined(box, box_tile({40, 40, 40}, {48, 48, 48}))), "several-shells");
  // A cavity: one body, two shells.
  EXPECT_EQ(code_of(joined(box, inside_out(box_tile({16, 16, 16}, {24, 24, 24})))),
            "several-shells");
  EXPECT_EQ(code_of(joined(box, box_tile({20, 20, 20}, {48, 48, 48}))), "patches-crossing");
  MicroTile open = box;
  open.patches.pop_back();
  EXPECT_EQ(code_of(open), "side-open");
  MicroTile twice = box;
  twice.patches.push_back(box.patches.front());
  EXPECT_NE(code_of(twice), "");
}

TEST(TileCertifier, BudgetsOfBoxesAreKept) {
  CertifyOptions options;
  options.max_cells = 3;
  const auto found = star_boxes_of(frame_tile({}).value(), options);
  ASSERT_TRUE(std::holds_alternative<Finding>(found));
  EXPECT_EQ(std::get<Finding>(found).code, "cell-limit");
}

}  // namespace
}  // namespace veritope
