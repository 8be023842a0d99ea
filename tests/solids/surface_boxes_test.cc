// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/interval_boxes/surface_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <set>
#include <utility>

#include "models/patch_shapes.h"
#include "solids/interval_boxes/box_sets_internal.h"
#include "solids/interval_boxes/box_union.h"
#include "solids/interval_boxes/condition_sweep.h"

namespace veritope {
namespace {

BoundaryModel model_of(patch_shapes::Patches patches) {
  return BoundaryModel::make(make_patch_complex(std::move(patches)).value()).value();
}

std::vector<patch_shapes::Patches> shapes() {
  return {patch_shapes::box({0, 0, 0}, {1, 1, 1}), patch_shapes::octant_sphere(),
          patch_shapes::torus(Rational(3), Rational(1)), patch_shapes::pn_torus(12, 8)};
}

TEST(SurfaceBoxes, HoldTheirPiecesAndAreNoLargerThanEps) {
  for (const auto& shape : shapes()) {
    BoundaryModel model = model_of(shape);
    for (const double eps : {1.0, 0.75}) {
      const auto cover = make_surface_cover(model, eps).value();
      EXPECT_LE(cover.largest, eps);
      std::set<PieceForest::Id> leaves;
      for (const SurfaceBox& b : cover.boxes) {
        const Box3d box = *model.to_forest(b.box);
        for (const auto id : b.pieces) {
          leaves.insert(id);
          EXPECT_TRUE(is_in_interior(model.forest().node(id).hull, box, 3));
        }
      }
      // The pieces are a complete subdivision: each root is a leaf or all four of its children are covered.
      const std::function<bool(PieceForest::Id)> is_whole = [&](PieceForest::Id id) {
        if (leaves.contains(id)) return true;
        const auto first = model.forest().node(id).first_child;
        if (first == PieceForest::kNone) return false;
        for (PieceForest::Id k = 0; k < 4; ++k)
          if (!is_whole(first + k)) return false;
        return true;
      };
      for (std::uint32_t r = 0; r < model.forest().num_roots(); ++r)
        EXPECT_TRUE(is_whole(model.forest().root(r)));
    }
  }
}

// [SSP01] 3: face boxes stand for pieces without a point on an edge, and every vertex has its cluster.
TEST(SurfaceBoxes, ACubeHasFaceEdgeAndVertexBoxesAndEightClusters) {
  BoundaryModel model = model_of(patch_shapes::box({0, 0, 0}, {1, 1, 1}));
  const auto cover = make_surface_cover(model, 0.25).value();
  std::array<std::size_t, 3> kinds{};
  for (const SurfaceBox& b : cover.boxes) {
    ++kinds[static_cast<std::size_t>(b.kind)];
    // Eighths of the unit square: a face box is off all edges.
    int on_planes = 0;
    for (std::size_t k = 0; k < 3; ++k) on_planes += (b.box.lo[k] < 0) + (b.box.hi[k] > 1);
    EXPECT_EQ(on_planes >= 2, b.kind != SurfaceBox::Kind::kFace);
  }
  EXPECT_EQ(kinds, (std::array<std::size_t, 3>{216, 48, 48}));
  ASSERT_EQ(cover.clusters.size(), 8u);
  for (const VertexCluster& c : cover.clusters)
    EXPECT_EQ(c.boxes.size(), 6u) << "two of each of three edges";
}

TEST(SurfaceBoxes, BadResolutionsAreRefused) {
  BoundaryModel model = model_of(patch_shapes::box({0, 0, 0}, {1, 1, 1}));
  for (const double eps : {0.0, -1.0, 1.0 / 0.0, 1e-30})
    EXPECT_EQ(make_surface_cover(model, eps).error().code, Code::kBadArgument) << eps;
  SurfaceBoxOptions options;
  options.margin = 0.5;
  EXPECT_EQ(make_surface_cover(model, 1, options).error().code, Code::kBadArgument);
  options.margin = 0.125, options.max_boxes = 10;
  EXPECT_EQ(make_surface_cover(model, 0.1, options).error().code, Code::kOverLimit);
}

TEST(ConditionSweep, TheCubesBoxesSatisfyThePaperAndNotC3Star) {
  BoundaryModel model = model_of(patch_shapes::box({0, 0, 0}, {1, 1, 1}));
  const auto rows = sweep_conditions(model, 0.5, 1).value();
  ASSERT_EQ(rows.size(), 2u);
  for (const SweepRow& r : rows) {
    for (std::size_t c = 0; c < kNumPaperConditions; ++c)
      EXPECT_EQ(r.conditions[c].answer, static_cast<PaperCondition>(c) == PaperCondition::kC3Star
                                            ? Answer::kFalse
                                            : Answer::kTrue)
          << name_of(static_cast<PaperCondition>(c)) << " at " << r.eps;
  }
  EXPECT_EQ(rows[1].collar, (std::array{Answer::kTrue, Answer::kTrue, Answer::kTrue}));
  EXPECT_NE(to_table(rows).find("C3*"), std::string::npos);
}

// Boxes and collars are cubes around the origin's grid: the frame that star boxes choose for such models is not theirs.
TEST(ConditionSweep, FlatAndFarModelsKeepTheModelsAxes) {
  BoundaryModel flat = model_of(patch_shapes::box({0, 0, 0}, {100, 1, 1}));
  BoundaryModel far = model_of(patch_shapes::box({1000, 0, 0}, {1001, 1, 1}));
  for (BoundaryModel* const model : {&flat, &far}) {
    const auto rows = sweep_conditions(*model, 0.5, 0).value();
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].conditions[static_cast<std::size_t>(PaperCondition::kA)].answer,
              Answer::kTrue);
    EXPECT_EQ(rows[0].conditions[static_cast<std::size_t>(PaperCondition::kB1)].answer,
              Answer::kTrue);
  }
}

// PROVES SWEEP-1.K2
TEST(ConditionSweep, CoarseCellsFillTheModelAndAreNoCollar) {
  BoundaryModel model = model_of(patch_shapes::octant_sphere());
  const auto rows = sweep_conditions(model, 2, 0).value();
  EXPECT_EQ(rows[0].collar, (std::array{Answer::kTrue, Answer::kFalse, Answer::kUndecided}));
}

// A cube with sides of n cells, its planes 0.328 cells past those of the octree: n + 1 cells along each edge, and those inside are not met.
// PROVES SWEEP-1, SWEEP-1.COVER
TEST(ConditionSweep, TheCellsAreThoseThatTheCubeMeets) {
  BoundaryModel model = model_of(patch_shapes::box({0, 0, 0}, {1, 1, 1}));
  const auto rows = sweep_conditions(model, 0.5, 3).value();
  std::uint64_t n = 2;
  for (const SweepRow& row : rows) {
    EXPECT_EQ(row.cells, (n + 1) * (n + 1) * (n + 1) - (n - 1) * (n - 1) * (n - 1)) << row.eps;
    n *= 2;
  }
}

// Two cubes near one corner of each: their cells have a vertex in common, or, farther apart, nothing.
// PROVES SWEEP-1.K1
TEST(ConditionSweep, CellsThatTouchInAVertexAreNoManifold) {
  for (const bool touch : {true, false}) {
    const Rational low = Rational(touch ? 6 : 8) / Rational(5), high = low + Rational(1);
    BoundaryModel model =
        model_of(patch_shapes::joined({patch_shapes::box({0, 0, 0}, {1, 1, 1}),
                                       patch_shapes::box({low, low, low}, {high, high, high})}));
    const auto row = sweep_conditions(model, 0.25, 0).value()[0];
    if (touch) {
      EXPECT_EQ(row.collar, (std::array{Answer::kFalse, Answer::kUndecided, Answer::kUndecided}));
    } else {
      EXPECT_EQ(row.collar, (std::array{Answer::kTrue, Answer::kTrue, Answer::kTrue}));
    }
  }
}

// A solid torus without a ring that lies in a ball inside of it: two boundary components of genus 1, and no product.
// Each cell holds a small cube of the model, and no cube reaches another cell.
// PROVES SWEEP-1.K3
TEST(ConditionSweep, CellsThatDoNotCollapseAreNoCollarThoughTheirSidesHaveOneGenus) {
  patch_shapes::Patches cubes;
  std::uint64_t count = 0;
  const auto add = [&](int x, int y, int z) {
    const Rational quarter = Rational(1) / Rational(4);
    const Rational a(x), b(y), c(z);
    cubes = patch_shapes::joined(
        {cubes, patch_shapes::box({a, b, c}, {a + quarter, b + quarter, c + quarter})});
    ++count;
  };
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y)
      for (int z = 0; z < 3; ++z) {
        const int from_axis = std::max(std::abs(x - 2), std::abs(y - 2));
        if (z != 1 || from_axis != 1) add(x, y, z);
      }
  for (const auto& [x, y] : {std::pair{5, 1}, {6, 1}, {6, 2}, {6, 3}, {5, 3}}) add(x, y, 1);
  BoundaryModel model = model_of(cubes);
  SweepOptions options;
  options.boxes.max_boxes = 1;  // the cells only
  const auto row = sweep_conditions(model, 1, 0, options).value()[0];
  EXPECT_EQ(row.cells, count);
  EXPECT_EQ(row.collar, (std::array{Answer::kTrue, Answer::kTrue, Answer::kUndecided}));
}

// In the forest's coordinates these sizes, or planes two cells beside the model, are not doubles.
TEST(ConditionSweep, SizesBeyondBinary64EndARow) {
  BoundaryModel model = model_of(patch_shapes::placed(patch_shapes::box({0, 0, 0}, {1, 1, 1}),
                                                      Rational::power_of_two(-40), {0, 0, 0}));
  for (const double eps : {0x1p1023, 0x1p982}) {
    EXPECT_NE(sweep_conditions(model, eps, 0).value()[0].why_not.find("cells: eps is too large"),
              std::string::npos)
        << eps;
  }
  EXPECT_EQ(make_surface_cover(model, 0x1p1023).error().code, Code::kBadArgument);
}

TEST(ConditionSweep, BadArgumentsAreRefusedAndLimitsEndARow) {
  BoundaryModel model = model_of(patch_shapes::box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(sweep_conditions(model, 0, 1).error().code, Code::kBadArgument);
  EXPECT_EQ(sweep_conditions(model, 1, -1).error().code, Code::kBadArgument);
  EXPECT_EQ(sweep_conditions(model, 1, kMaxSweep + 1).error().code, Code::kBadArgument);
  SweepOptions options;
  options.boxes.max_boxes = 4;
  const auto rows = sweep_conditions(model, 0.25, 0, options).value();
  EXPECT_FALSE(rows[0].why_not.empty());
  EXPECT_EQ(rows[0].conditions[0].answer, Answer::kUndecided);
}

}  // namespace
}  // namespace veritope
