// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/mesh/grid_map_internal.h"

#include "interval/upward.h"
#include "robust/base/fp_guard.h"

namespace veritope::internal {
namespace {

CageCells interval_cells(const VVolume& volume, const MicroGrid& grid) {
  const ScopedUpward upward;
  return CageCells(volume, grid);
}

}  // namespace

GridMap::GridMap(const VVolume& volume, const MicroGrid& grid)
    : cells_(interval_cells(volume, grid)) {
  const ScopedDefaultFp fp;
  if (!volume.is_rational()) rounded_.emplace(volume, grid);
}

double GridMap::least_rounding() const {
  const ScopedUpward upward;
  return rounded_.has_value()
             ? (sqrt(Interval(3.0)) * Interval::from_bounds(0, rounded_->value_error())).hi()
             : 0;
}

// Bound: docs/bounds/micro_mesh.md, section 3.
double GridMap::rounding_of(const TileMesh& mesh, const std::array<double, 3>& first) const {
  if (!rounded_.has_value()) return 0;
  const ScopedUpward upward;
  Interval sum = Interval::from_bounds(0, least_rounding());
  for (const double f : first)
    sum += Interval::from_bounds(0, f) * Interval::from_bounds(0, mesh.points().error);
  return sum.hi();
}

CellOnCage::CellOnCage(const GridMap& map) : map_(map) {}

void CellOnCage::enter_row(std::size_t i, std::size_t j) {
  at_ = {i, j, 0};
  has_interval_row_ = false;
  if (map_.rounded_.has_value()) map_.rounded_->enter_row(i, j, row_);
}

void CellOnCage::enter_cell(std::size_t k) {
  at_[2] = k;
  has_interval_cell_ = false;
  if (map_.rounded_.has_value()) map_.rounded_->cell(row_, k, rounded_);
}

const CellMap& CellOnCage::interval_map() {
  if (!interval_cell_.has_value()) interval_cell_.emplace(map_.cells_.new_map());
  if (!has_interval_row_) map_.cells_.enter_row(at_[0], at_[1], interval_row_);
  has_interval_row_ = true;
  if (!has_interval_cell_) map_.cells_.cell(interval_row_, at_[2], *interval_cell_);
  has_interval_cell_ = true;
  return *interval_cell_;
}

CellMapBounds CellOnCage::bounds(bool& is_loose) {
  if (map_.rounded_.has_value()) return map_.rounded_->bounds(rounded_, is_loose);
  const ScopedUpward upward;
  return interval_map().whole_bounds(is_loose);
}

CellMapBounds CellOnCage::refined_bounds(int depth) {
  const ScopedUpward upward;
  return interval_map().bounds(depth);
}

const PointColumns& CellOnCage::place(const TileMesh& mesh, std::uint32_t begin, std::uint32_t end,
                                      const WallNumbers& numbers, Greatest& rounding) {
  if (map_.rounded_.has_value()) {
    WallParameters t{};
    for (std::size_t w = 0; w < numbers.size(); ++w) t[w] = numbers[w] * 0x1p-20;
    place_points(mesh.points(), begin, end, t, points_);
    map_points(rounded_, end - begin, points_);
    return points_;
  }
  const ScopedUpward upward;
  const CellMap& map = interval_map();
  points_.resize(end - begin);
  for (std::uint32_t v = begin; v < end; ++v) {
    const Vec3d p = middle_of(map.value(mesh.position(v, numbers)), rounding);
    points_.at[0][v - begin] = p.x;
    points_.at[1][v - begin] = p.y;
    points_.at[2][v - begin] = p.z;
  }
  return points_;
}

}  // namespace veritope::internal
