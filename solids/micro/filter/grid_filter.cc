// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/filter/grid_filter.h"

#include <algorithm>
#include <string>
#include <utility>

#include "interval/upward.h"
#include "robust/base/check.h"
#include "robust/base/fp_guard.h"
#include "robust/base/parallel.h"
#include "solids/micro/filter/filter_model_internal.h"
#include "solids/micro/filter/tile_walk_internal.h"
#include "splines/knot_insertion.h"

namespace veritope {

using namespace internal;

namespace {

constexpr std::size_t kUnitSide = 16;  // cells along an axis that one thread takes at a time
constexpr std::size_t kMaxGridCells = std::size_t{1} << 31;

using CellNumber = std::array<std::uint32_t, 3>;

// Cells begin[a] <= i < end[a].
struct CellBlock {
  CellNumber begin, end;
  std::uint32_t size(std::size_t axis) const { return end[axis] - begin[axis]; }
  std::size_t longest() const {
    std::size_t axis = 0;
    for (std::size_t a = 1; a < 3; ++a)
      if (size(a) > size(axis)) axis = a;
    return axis;
  }
};

// The lines of an axis, each in the unit of the span of knots that ends or begins with it.
struct AxisLines {
  // For each cell its span, and its begin and end in the span's domain [0,1].
  std::vector<std::uint32_t> span;
  std::vector<Rational> begin, end;
  std::vector<Interval> enclosed_begin, enclosed_end;
  std::vector<std::uint32_t> first_of_span;  // a cell for each span, and the number of cells
};

Error bad_line(std::size_t axis, const std::string& why) {
  return bad_argument("the lines of axis " + std::to_string(axis) + " " + why);
}

Result<AxisLines> axis_lines(std::size_t axis, const std::vector<Rational>& lines,
                             const std::vector<Rational>& breaks) {
  if (lines.size() < 2) return bad_line(axis, "bound no cell");
  if (lines.front() < breaks.front() || lines.front() >= breaks.back() ||
      lines.back() > breaks.back())
    return bad_line(axis, "run from " + lines.front().to_string() + " to " +
                              lines.back().to_string() + ", but the domain from " +
                              breaks.front().to_string() + " to " + breaks.back().to_string());
  AxisLines out;
  std::size_t span = 0;
  while (lines.front() >= breaks[span + 1]) ++span;
  out.first_of_span.push_back(0);
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    if (lines[i] >= lines[i + 1])
      return bad_line(axis, "do not increase at " + lines[i + 1].to_string());
    if (lines[i] == breaks[span + 1]) {
      ++span;
      out.first_of_span.push_back(static_cast<std::uint32_t>(i));
    }
    if (lines[i + 1] > breaks[span + 1])
      return bad_line(axis, "miss the knot " + breaks[span + 1].to_string());
    const Rational length = breaks[span + 1] - breaks[span];
    out.span.push_back(static_cast<std::uint32_t>(span));
    out.begin.push_back((lines[i] - breaks[span]) / length);
    out.end.push_back((lines[i + 1] - breaks[span]) / length);
    out.enclosed_begin.push_back(enclose(out.begin.back()));
    out.enclosed_end.push_back(enclose(out.end.back()));
  }
  out.first_of_span.push_back(static_cast<std::uint32_t>(out.span.size()));
  return out;
}

// Blocks of at most kUnitSide cells along each axis, each in one span.
std::vector<CellBlock> grid_units(const std::array<AxisLines, 3>& axes) {
  std::array<std::vector<std::pair<std::uint32_t, std::uint32_t>>, 3> parts;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t s = 0; s + 1 < axes[a].first_of_span.size(); ++s) {
      const std::uint32_t begin = axes[a].first_of_span[s],
                          n = axes[a].first_of_span[s + 1] - begin;
      const auto num = static_cast<std::uint32_t>(num_chunks(n, kUnitSide));
      for (std::uint32_t i = 0; i < num; ++i)
        parts[a].emplace_back(begin + n * i / num, begin + n * (i + 1) / num);
    }
  std::vector<CellBlock> out;
  for (const auto& x : parts[0])
    for (const auto& y : parts[1])
      for (const auto& z : parts[2])
        out.push_back({{x.first, y.first, z.first}, {x.second, y.second, z.second}});
  return out;
}

class GridWalk {
 public:
  GridWalk(const TileFilter::Model& model, const BezierPieces<Rational, 3>& pieces,
           const std::array<AxisLines, 3>& axes, const TileOfCell& tile,
           const TileFilterLimits& limits, GridStatus* out)
      : model_(model), pieces_(pieces), axes_(axes), tile_(tile), limits_(limits), out_(*out) {}

  void unit(const CellBlock& block) const {
    const ScopedUpward upward;
    CellNet net(piece_of(block.begin));
    // The part of the span, by at most two cuts along each axis.
    for (std::size_t a = 0; a < 3; ++a) {
      const AxisLines& axis = axes_[a];
      const std::uint32_t last = block.end[a] - 1;
      const Interval end = axis.enclosed_end[last], begin = axis.enclosed_begin[block.begin[a]];
      if (axis.end[last] != Rational(1)) net = net.halves(a, end).first;
      if (axis.begin[block.begin[a]] != Rational(0)) net = net.halves(a, begin / end).second;
    }
    visit(net, block);
  }

 private:
  const BezierVolume<Rational>& piece_of(const CellNumber& cell) const {
    return pieces_.at({axes_[0].span[cell[0]], axes_[1].span[cell[1]], axes_[2].span[cell[2]]});
  }

  void visit(const CellNet& net, const CellBlock& block) const {
    const Value3 value = model_.value(net.hull());
    if (is_constant(value))
      return fill(block, value == Value3::kOne ? CellStatus::kKept : CellStatus::kOutside);
    const std::size_t axis = block.longest();
    if (block.size(axis) == 1) return fill(block, one_cell(net, block.begin));
    const std::uint32_t cut = block.begin[axis] + block.size(axis) / 2;
    const AxisLines& lines = axes_[axis];
    const Interval begin = lines.enclosed_begin[block.begin[axis]],
                   end = lines.enclosed_end[block.end[axis] - 1];
    const auto parts = net.halves(axis, (lines.enclosed_begin[cut] - begin) / (end - begin));
    CellBlock low = block, high = block;
    low.end[axis] = high.begin[axis] = cut;
    visit(parts.first, low);
    visit(parts.second, high);
  }

  CellStatus one_cell(const CellNet& net, const CellNumber& number) const {
    CellMap cell{&piece_of(number)};
    for (std::size_t a = 0; a < 3; ++a) {
      cell.lo[a] = axes_[a].begin[number[a]];
      cell.hi[a] = axes_[a].end[number[a]];
    }
    const std::shared_ptr<const TileShape> shape = shape_of(number);
    VT_CHECK(shape != nullptr, "a cell without a tile");
    return TileWalk(model_, net, cell, *shape, limits_).run().status;
  }

  // The caller's function computes as everywhere else.
  std::shared_ptr<const TileShape> shape_of(const CellNumber& number) const {
    const ScopedDefaultFp nearest;
    return tile_(number);
  }

  void fill(const CellBlock& block, CellStatus status) const {
    for (std::size_t i = block.begin[0]; i < block.end[0]; ++i)
      for (std::size_t j = block.begin[1]; j < block.end[1]; ++j) {
        const auto row = out_.status.begin() +
                         static_cast<std::ptrdiff_t>(out_.cells.at({i, j, block.begin[2]}));
        std::fill_n(row, block.size(2), status);
      }
  }

  const TileFilter::Model& model_;
  const BezierPieces<Rational, 3>& pieces_;
  const std::array<AxisLines, 3>& axes_;
  const TileOfCell& tile_;
  const TileFilterLimits& limits_;
  GridStatus& out_;
};

}  // namespace

Result<GridStatus> filter_grid(const TileFilter& filter, const BSplineVolume<Rational>& cage,
                               const std::array<std::vector<Rational>, 3>& lines,
                               const TileOfCell& tile, unsigned jobs,
                               const TileFilterLimits& limits) {
  if (cage.dimension() != 3)
    return bad_argument("the cage has " + std::to_string(cage.dimension()) +
                        " coordinates; cells lie in space");
  const BezierPieces<Rational, 3> pieces = bezier_pieces(cage);
  std::array<AxisLines, 3> axes;
  GridStatus out;
  for (std::size_t a = 0; a < 3; ++a) {
    Result<AxisLines> axis = axis_lines(a, lines[a], pieces.breaks[a]);
    if (!axis) return axis.error();
    axes[a] = std::move(axis.value());
    out.cells.size[a] = axes[a].span.size();
  }
  const std::optional<std::size_t> count = out.cells.count_up_to(kMaxGridCells);
  if (!count) return Error{Code::kOverLimit, {}, "the grid has more than 2^31 cells"};
  out.status.assign(*count, CellStatus::kUndecided);
  const GridWalk walk(filter.model(), pieces, axes, tile, limits, &out);
  const std::vector<CellBlock> units = grid_units(axes);
  parallel_for(units.size(), 1, jobs, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) walk.unit(units[i]);
  });
  for (const CellStatus s : out.status) ++out.counts[static_cast<std::size_t>(s)];
  return out;
}

}  // namespace veritope
