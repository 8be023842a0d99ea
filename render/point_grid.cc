// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/point_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robust/base/check.h"
#include "robust/base/parallel.h"

namespace veritope {

PointGrid::PointGrid(ExactBox<3> bounds, std::uint32_t n)
    : bounds_(std::move(bounds)), n_(n), num_((n + kSide - 1) / kSide) {
  VT_CHECK(1 <= n && n <= kMostGridSide, "a grid has 1 to 1024 points along each axis");
  for (const ExactInterval& side : bounds_.side)
    VT_CHECK(side.lo < side.hi, "the box of a grid has an interior");
  blocks_.resize(std::size_t{num_} * num_ * num_);
}

Rational PointGrid::coordinate(std::size_t axis, std::uint32_t i) const {
  return bounds_[axis].lo + bounds_[axis].width() * Rational(2 * i + 1) / Rational(2 * n_);
}

std::array<std::uint32_t, 2> PointGrid::range(std::size_t number) const {
  const auto first = static_cast<std::uint32_t>(number * kSide);
  return {first, std::min(first + kSide, n_)};
}

void PointGrid::set(std::uint32_t i, std::uint32_t j, std::uint32_t k, GridMark mark) {
  Block& block = blocks_[block_of(i, j, k)];
  if (block.marks.empty()) block.marks.assign(std::size_t{kSide} * kSide * kSide, block.all);
  block.marks[place_of(i, j, k)] = mark;
}

std::uint64_t PointGrid::count(GridMark mark) const {
  std::uint64_t sum = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const auto [i0, i1] = range(b / num_ / num_);
    const auto [j0, j1] = range(b / num_ % num_);
    const auto [k0, k1] = range(b % num_);
    const Block& block = blocks_[b];
    if (block.marks.empty()) {
      if (block.all == mark) sum += std::uint64_t{i1 - i0} * (j1 - j0) * (k1 - k0);
      continue;
    }
    for (std::uint32_t i = i0; i < i1; ++i)
      for (std::uint32_t j = j0; j < j1; ++j)
        for (std::uint32_t k = k0; k < k1; ++k)
          if (block.marks[place_of(i, j, k)] == mark) ++sum;
  }
  return sum;
}

namespace {

GridMark mark_of(PointWord word) {
  switch (word) {
    case PointWord::kIn: return GridMark::kIn;
    case PointWord::kOn: return GridMark::kOn;
    case PointWord::kOut: return GridMark::kNone;
    case PointWord::kUndecided: break;
  }
  return GridMark::kUndecided;
}

// A coordinate, and doubles around it: equal if it is one.
struct GridCoordinate {
  Rational exact;
  double below = 0, above = 0;
};

}  // namespace

class GridFiller {
 public:
  GridFiller(const SolidProbe& solid, PointGrid& grid) : solid_(solid), grid_(grid) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::uint32_t i = 0; i < grid.n(); ++i) {
        Rational x = grid.coordinate(axis, i);
        const double below = round_down(x), above = round_up(x);
        coordinates_[axis].push_back({std::move(x), below, above});
      }
  }

  void fill(unsigned jobs, WorkShare* work) {
    WorkStep step(work, static_cast<double>(grid_.blocks_.size()));
    parallel_for(grid_.blocks_.size(), 1, jobs, [&](std::size_t, std::size_t b, std::size_t) {
      const std::size_t num = grid_.num_;
      fill(grid_.blocks_[b],
           {{grid_.range(b / num / num), grid_.range(b / num % num), grid_.range(b % num)}});
      step.add(1);
    });
  }

 private:
  // The numbers of points along each axis: [first, last).
  using Ranges = std::array<std::array<std::uint32_t, 2>, 3>;

  Box3d box_of(const Ranges& r) const {
    Box3d box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.lo[axis] = coordinates_[axis][r[axis][0]].below;
      box.hi[axis] = coordinates_[axis][r[axis][1] - 1].above;
    }
    return box;
  }

  void fill(PointGrid::Block& block, const Ranges& r) {
    const Box3d box = box_of(r);
    const Value3 value = is_finite(box) ? solid_.value(box) : Value3::kMixed;
    if (is_constant(value)) {
      block.all = value == Value3::kOne ? GridMark::kIn : GridMark::kNone;
      return;
    }
    constexpr std::size_t kPoints =
        std::size_t{PointGrid::kSide} * PointGrid::kSide * PointGrid::kSide;
    block.marks.assign(kPoints, GridMark::kNone);
    halve(block, r);
  }

  // The points of a box whose value is mixed: both halves along the axis that has most of them.
  void halve(PointGrid::Block& block, const Ranges& r) {
    std::size_t axis = 0;
    const auto length = [&](std::size_t a) { return r[a][1] - r[a][0]; };
    for (std::size_t a = 1; a < 3; ++a)
      if (length(axis) < length(a)) axis = a;
    if (length(axis) == 1) {
      set(block, r, mark_at(r[0][0], r[1][0], r[2][0]));
      return;
    }
    const std::uint32_t middle = r[axis][0] + length(axis) / 2;
    Ranges low = r, high = r;
    low[axis][1] = high[axis][0] = middle;
    for (const Ranges& half : {low, high}) descend(block, half);
  }

  void descend(PointGrid::Block& block, const Ranges& r) {
    constexpr std::uint32_t kFew = 8;  // a box costs as much as some points
    const std::uint32_t points = (r[0][1] - r[0][0]) * (r[1][1] - r[1][0]) * (r[2][1] - r[2][0]);
    if (points >= kFew) {
      const Box3d box = box_of(r);
      const Value3 value = is_finite(box) ? solid_.value(box) : Value3::kMixed;
      if (is_constant(value))
        return set(block, r, value == Value3::kOne ? GridMark::kIn : GridMark::kNone);
    }
    halve(block, r);
  }

  static void set(PointGrid::Block& block, const Ranges& r, GridMark mark) {
    for (std::uint32_t i = r[0][0]; i < r[0][1]; ++i)
      for (std::uint32_t j = r[1][0]; j < r[1][1]; ++j)
        for (std::uint32_t k = r[2][0]; k < r[2][1]; ++k)
          block.marks[PointGrid::place_of(i, j, k)] = mark;
  }

  // For a point that binary64 does not have, the box of its neighbours there is asked first.
  GridMark mark_at(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    const GridCoordinate &x = coordinates_[0][i], &y = coordinates_[1][j], &z = coordinates_[2][k];
    const Box3d box{{x.below, y.below, z.below}, {x.above, y.above, z.above}};
    if (is_finite(box)) {
      if (box.lo == box.hi) return mark_of(solid_.word(Vec3d{x.below, y.below, z.below}));
      const Value3 value = solid_.value(box);
      if (is_constant(value)) return value == Value3::kOne ? GridMark::kIn : GridMark::kNone;
    }
    return mark_of(solid_.word(ExactPoint{x.exact, y.exact, z.exact}));
  }

  const SolidProbe& solid_;
  PointGrid& grid_;
  std::array<std::vector<GridCoordinate>, 3> coordinates_;
};

PointGrid classify_grid(const SolidProbe& solid, const ExactBox<3>& bounds, std::uint32_t n,
                        unsigned jobs, WorkShare* work) {
  PointGrid grid(bounds, n);
  GridFiller(solid, grid).fill(jobs, work);
  return grid;
}

}  // namespace veritope
