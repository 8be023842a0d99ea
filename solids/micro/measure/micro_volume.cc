// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/micro/measure/micro_volume.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "interval/numeric.h"
#include "interval/upward.h"
#include "robust/base/parallel.h"
#include "solids/micro/measure/bridge_volume_internal.h"
#include "solids/micro/measure/cell_expansion_internal.h"
#include "solids/micro/measure/span_determinant_internal.h"
#include "solids/micro/measure/sweep_volume_internal.h"
#include "solids/micro/measure/tile_moments_internal.h"

namespace veritope {
namespace {

using internal::CellExpansion;
using internal::CellSpan;
using internal::MomentTables;
using internal::SpanDeterminant;

// Orders of expansions: few, so that there are few tables of moments.
constexpr std::size_t kOrders[] = {0, 1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24};
constexpr std::size_t kMostOrder = 24;
// What an expansion leaves out, beside the greatest coefficient of the determinant.
constexpr double kSmallRest = 0x1p-35;
// Where a greater order than this seems to be needed, spans are expanded in full if that takes fewer products.
constexpr std::size_t kEasyOrder = 10, kMostProducts = std::size_t{1} << 27;

struct Volumes {
  Interval tiles, cells;
};

// The cells of a span.
class SpanVolume {
 public:
  SpanVolume(const Microstructure& micro, const MicroGrid& grid, const CellSpan& span,
             MomentTables& tables)
      : micro_(micro), grid_(grid), span_(span), tables_(tables) {}

  Volumes run(unsigned jobs) const {
    const ScopedUpward upward;
    const VVolume& volume = micro_.cage[grid_.volume];
    const SpanDeterminant determinant = internal::span_determinant(volume, span_, kSmallRest);
    std::array<std::vector<Rational>, 3> breaks;
    for (std::size_t a = 0; a < 3; ++a)
      breaks[a] = internal::breaks_in_span(volume, grid_, span_, a);
    Volumes out;
    out.cells = whole(determinant, breaks);
    if (!has_tiles()) return out;
    const std::pair<std::size_t, double> chosen = order_for(determinant.polynomial, breaks);
    const std::size_t order = chosen.first;
    const double rest = chosen.second;
    const CellExpansion expansion(determinant.polynomial, breaks, order);
    const Interval error = Interval::from_bounds(-rest, rest) +
                           Interval::from_bounds(-determinant.error, determinant.error);
    // Cells by sheets; each sheet has a place of its own, so that sums do not depend on jobs.
    std::vector<Interval> sheets(span_.cells[0][1] - span_.cells[0][0]);
    parallel_for(sheets.size(), 1, jobs, [&](std::size_t, std::size_t i, std::size_t) {
      const ScopedUpward also_here;
      sheets[i] = sheet(expansion, order, error, breaks, i);
    });
    for (const Interval& s : sheets) out.tiles += s;
    return out;
  }

 private:
  std::size_t length(std::size_t axis) const { return span_.cells[axis][1] - span_.cells[axis][0]; }
  std::uint8_t tile_at(std::size_t i, std::size_t j, std::size_t k) const {
    return grid_.tiles[grid_.shape().at(
        {span_.cells[0][0] + i, span_.cells[1][0] + j, span_.cells[2][0] + k})];
  }
  bool has_tiles() const {
    for (std::size_t i = 0; i < length(0); ++i)
      for (std::size_t j = 0; j < length(1); ++j)
        for (std::size_t k = 0; k < length(2); ++k)
          if (tile_at(i, j, k) != 0) return true;
    return false;
  }

  // The integral of the determinant over the box of all cells.
  Interval whole(const SpanDeterminant& d,
                 const std::array<std::vector<Rational>, 3>& breaks) const {
    std::array<std::vector<Interval>, 3> weights;
    Interval size(1.0);
    for (std::size_t a = 0; a < 3; ++a) {
      weights[a] = internal::legendre_matrices(d.polynomial.degree(a), 0,
                                               {breaks[a].front(), breaks[a].back()})
                       .front();
      size *= enclose(breaks[a].back() - breaks[a].front());
    }
    Interval mean = Interval::from_bounds(-d.error, d.error);
    const Grid<3> net = d.polynomial.grid();
    for (std::size_t n = 0; n < net.count(); ++n) {
      const auto at = net.index_of(n);
      mean +=
          weights[0][at[0]] * weights[1][at[1]] * weights[2][at[2]] * d.polynomial.component(0)[n];
    }
    return mean * size;
  }

  // The least order that leaves little out, and what it leaves out.
  std::pair<std::size_t, double> order_for(
      const BezierVolume<Interval>& f, const std::array<std::vector<Rational>, 3>& breaks) const {
    std::array<double, 3> half_widths{};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t i = 0; i + 1 < breaks[a].size(); ++i)
        half_widths[a] =
            std::max(half_widths[a], 0.5 * enclose(breaks[a][i + 1] - breaks[a][i]).hi());
    const auto first = least_order(f, internal::expansion_errors(f, half_widths, kMostOrder));
    const Grid<3> net = f.grid();
    const std::size_t products = net.count() * std::max({net.size[0], net.size[1], net.size[2]});
    if (first.first <= kEasyOrder || length(0) * length(1) * length(2) > kMostProducts / products)
      return first;
    return least_order(f, internal::exact_expansion_errors(f, breaks, kMostOrder));
  }
  static std::pair<std::size_t, double> least_order(const BezierVolume<Interval>& f,
                                                    const std::vector<double>& errors) {
    const double small = kSmallRest * internal::greatest_coefficient(f);
    for (const std::size_t order : kOrders) {
      const double rest = errors[std::min(order, errors.size() - 1)];
      if (rest <= small || order == kMostOrder) return {order, rest};
    }
    return {kMostOrder, errors.back()};
  }

  Interval sheet(const CellExpansion& expansion, std::size_t order, const Interval& error,
                 const std::array<std::vector<Rational>, 3>& breaks, std::size_t i) const {
    const auto width = [&](std::size_t axis, std::size_t n) {
      return enclose(breaks[axis][n + 1] - breaks[axis][n]);
    };
    std::vector<Interval> widths;
    for (std::size_t k = 0; k < length(2); ++k) widths.push_back(width(2, k));
    CellExpansion::Sheet shared;
    CellExpansion::Row row;
    std::vector<Interval> coefficients, moments;
    std::uint8_t known_tile = 0;
    WallNumbers known_numbers{};
    Interval sum;
    bool has_sheet = false;
    for (std::size_t j = 0; j < length(1); ++j) {
      Interval row_sum;
      bool has_row = false;
      for (std::size_t k = 0; k < length(2); ++k) {
        const std::uint8_t tile = tile_at(i, j, k);
        if (tile == 0) continue;
        if (!has_sheet) expansion.enter_sheet(i, shared), has_sheet = true;
        if (!has_row) expansion.enter_row(shared, j, row), has_row = true;
        expansion.cell(row, k, coefficients);
        const WallNumbers numbers =
            grid_.numbers_of({span_.cells[0][0] + i, span_.cells[1][0] + j, span_.cells[2][0] + k});
        if (tile != known_tile || numbers != known_numbers) {
          tables_.of(tile - 1u, order).at(numbers, moments);
          known_tile = tile;
          known_numbers = numbers;
        }
        Interval value = error * moments[0];
        for (std::size_t m = 0; m < coefficients.size(); ++m) value += coefficients[m] * moments[m];
        row_sum += value * widths[k];
      }
      if (has_row) sum += row_sum * width(1, j);
    }
    return sum * width(0, i);
  }

  const Microstructure& micro_;
  const MicroGrid& grid_;
  const CellSpan& span_;
  MomentTables& tables_;
};

struct PlacedSpan {
  std::size_t grid;
  CellSpan span;
};

// What x has in common with [lo, hi]. REQUIRES that they contain a common number.
Interval clamped(const Interval& x, double lo, double hi) {
  return Interval::from_bounds(std::clamp(x.lo(), lo, hi), std::clamp(x.hi(), lo, hi));
}

// Bridges that cross knots may add this part of the volume of the tiles to the width of the bounds.
constexpr double kSmallWidth = 0x1p-31;

Interval bridges_beside(const Microstructure& micro, const VModel& cage, const Interval& tiles,
                        unsigned jobs) {
  std::vector<int> hands;
  for (std::uint32_t v = 0; v < micro.cage.size(); ++v)
    hands.push_back(cage.hand(v) == Sign::kNegative ? -1 : 1);
  return micro.sweeps.empty()
             ? internal::volume_of_bridges(micro, hands, kSmallWidth * mag(tiles), jobs)
             : internal::volume_of_sweeps(micro, hands, jobs);
}

// Whether the grids of all volumes with bridges fill their parameters; they do not overlap.
bool cells_hold_bridges(const Microstructure& micro) {
  std::vector<Rational> filled(micro.cage.size());
  for (const MicroGrid& grid : micro.grids) {
    Rational size(1);
    for (const auto& breaks : grid.breaks) size *= breaks.back() - breaks.front();
    filled[grid.volume] += size;
  }
  return std::all_of(micro.bridges.begin(), micro.bridges.end(), [&](const MicroBridge& b) {
    Rational size(1);
    for (std::size_t a = 0; a < 3; ++a) {
      const KnotAxis<Rational>& axis = micro.cage[b.volume].axis(a);
      size *= axis.domain_end() - axis.domain_begin();
    }
    return filled[b.volume] == size;
  });
}

}  // namespace

Result<MicroVolume> volume_of(const Microstructure& micro, const VModel& cage, unsigned jobs) {
  std::vector<PlacedSpan> spans;
  for (std::size_t g = 0; g < micro.grids.size(); ++g)
    for (const CellSpan& s : internal::spans_of(micro.cage[micro.grids[g].volume], micro.grids[g]))
      spans.push_back({g, s});
  MomentTables tables(micro.tiles);
  std::vector<Volumes> volumes(spans.size());
  // Threads share spans where there are many of them, else the cells of each.
  const bool has_many = spans.size() >= 64;
  parallel_for(spans.size(), 1, has_many ? jobs : 1, [&](std::size_t, std::size_t n, std::size_t) {
    const MicroGrid& grid = micro.grids[spans[n].grid];
    volumes[n] = SpanVolume(micro, grid, spans[n].span, tables).run(has_many ? 1 : jobs);
  });
  const ScopedUpward upward;
  MicroVolume out;
  for (std::size_t n = 0; n < spans.size(); ++n) {
    const bool is_left = cage.hand(micro.grids[spans[n].grid].volume) == Sign::kNegative;
    out.tiles += is_left ? -volumes[n].tiles : volumes[n].tiles;
    out.cells += is_left ? -volumes[n].cells : volumes[n].cells;
  }
  if (micro.num_bridges() != 0) out.bridges = bridges_beside(micro, cage, out.tiles, jobs);
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (!(mag(out.tiles) < kInfinite && mag(out.cells) < kInfinite && mag(out.bridges) < kInfinite))
    return Error{Code::kNotFinite, {}, "the volume of the microstructure is not bounded"};
  // No volume is negative, and the tiles lie in the cells.
  out.tiles = clamped(out.tiles, 0, kInfinite);
  out.bridges = clamped(out.bridges, 0, kInfinite);
  out.cells = clamped(out.cells, out.tiles.lo(), kInfinite);
  out.solid = out.tiles + out.bridges;
  out.density = out.cells.lo() > 0 ? clamped(out.tiles / out.cells, 0, 1) + out.bridges / out.cells
                                   : Interval::from_bounds(0, kInfinite);
  if (cells_hold_bridges(micro)) out.density = clamped(out.density, 0, 1);
  return out;
}

}  // namespace veritope
