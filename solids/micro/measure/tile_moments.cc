// SPDX-License-Identifier: LGPL-3.0-or-later
// The divergence theorem: the integral of P_i P_j P_k over the solid is that of I_i P_j P_k times the first component
// of the normal over its surface, where I_i' = P_i along x. On a patch that is a polynomial in u, v and the number of a
// wall, so Gauss rules of enough nodes are exact.
#include <algorithm>
#include <functional>

#include "interval/numeric.h"
#include "solids/micro/measure/gauss_rule_internal.h"
#include "solids/micro/measure/node_basis_internal.h"
#include "solids/micro/measure/tile_moments_internal.h"

namespace veritope::internal {
namespace {

using Point = std::array<Interval, 3>;

// Adds the patch's part of all moments to sums; `points` are its control points.
class PatchIntegral {
 public:
  PatchIntegral(const std::array<int, 2>& degrees, std::size_t order)
      : order_(order),
        first_(node_basis(degrees[0], (order + 3) * static_cast<std::size_t>(degrees[0]) - 1)),
        second_(node_basis(degrees[1], (order + 3) * static_cast<std::size_t>(degrees[1]) - 1)) {
    for (auto& l : legendre_) l.resize(order + 2);
    primitive_.resize(order + 1);
  }

  void add(const std::vector<Point>& points, std::vector<Interval>& sums) {
    const std::size_t columns = second_.value.front().size(), rows = first_.value.front().size();
    std::vector<Point> line(columns), slope_line(columns);
    for (std::size_t g = 0; g < first_.value.size(); ++g) {
      for (std::size_t j = 0; j < columns; ++j) {
        line[j] = slope_line[j] = {};
        for (std::size_t i = 0; i < rows; ++i)
          for (std::size_t c = 0; c < 3; ++c) {
            line[j][c] += first_.value[g][i] * points[i * columns + j][c];
            slope_line[j][c] += first_.slope[g][i] * points[i * columns + j][c];
          }
      }
      for (std::size_t h = 0; h < second_.value.size(); ++h) {
        Point at{}, along_u{}, along_v{};
        for (std::size_t j = 0; j < columns; ++j)
          for (std::size_t c = 0; c < 3; ++c) {
            at[c] += second_.value[h][j] * line[j][c];
            along_u[c] += second_.value[h][j] * slope_line[j][c];
            along_v[c] += second_.slope[h][j] * line[j][c];
          }
        const Interval normal = along_u[1] * along_v[2] - along_u[2] * along_v[1];
        add_point(at, first_.weights[g] * second_.weights[h] * normal, sums);
      }
    }
  }

 private:
  void add_point(const Point& at, const Interval& factor, std::vector<Interval>& sums) {
    for (std::size_t c = 0; c < 3; ++c)
      legendre_values(Interval(2.0) * at[c] - Interval(1.0), legendre_[c]);
    for (std::size_t i = 0; i <= order_; ++i)
      primitive_[i] = i == 0 ? Interval(0.5) * legendre_[0][1]
                             : (legendre_[0][i + 1] - legendre_[0][i - 1]) /
                                   Interval(static_cast<double>(4 * i + 2));
    for (std::size_t i = 0; i <= order_; ++i) {
      const Interval f = factor * primitive_[i];
      for (std::size_t j = 0; i + j <= order_; ++j) {
        const Interval g = f * legendre_[1][j];
        for (std::size_t k = 0; i + j + k <= order_; ++k)
          sums[moment_number(i, j, k)] += g * legendre_[2][k];
      }
    }
  }

  std::size_t order_;
  NodeBasis first_, second_;
  std::array<std::vector<Interval>, 3> legendre_;
  std::vector<Interval> primitive_;
};

// The control points of a patch for a number of its wall, in [0, 1].
std::vector<Point> enclosed_points(const TilePatch& patch, const Interval& number) {
  std::vector<Point> out(patch.num_points());
  for (std::size_t n = 0; n < out.size(); ++n)
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t power = patch.points.size(); power-- > 0;)
        out[n][c] = out[n][c] * number + enclose(patch.points[power][n][c]);
  return out;
}

}  // namespace

std::vector<std::array<std::size_t, 3>> moment_indices(std::size_t order) {
  std::vector<std::array<std::size_t, 3>> out;
  for (std::size_t s = 0; s <= order; ++s)
    for (std::size_t i = 0; i <= s; ++i)
      for (std::size_t j = 0; i + j <= s; ++j) out.push_back({i, j, s - i - j});
  return out;
}

TileMoments::TileMoments(const MicroTile& tile, std::size_t order)
    : order_(order), range_(tile.range.value_or(std::array<std::int32_t, 2>{0, 0})) {
  fixed_.resize(num_moments(order));
  std::array<std::vector<std::size_t>, 7> patches;  // by walls; last: without one
  for (std::size_t p = 0; p < tile.patches.size(); ++p) {
    const TilePatch& patch = tile.patches[p];
    const bool is_fixed = !patch.wall.has_value() || patch.points.size() == 1;
    patches[is_fixed ? 6 : static_cast<std::size_t>(*patch.wall)].push_back(p);
  }
  for (int w = 0; w < 7; ++w)
    if (!patches[static_cast<std::size_t>(w)].empty())
      add_patches(tile, w, patches[static_cast<std::size_t>(w)]);
}

void TileMoments::add_patches(const MicroTile& tile, int wall,
                              const std::vector<std::size_t>& patches) {
  std::size_t powers = 1;
  for (const std::size_t p : patches) powers = std::max(powers, tile.patches[p].points.size());
  const bool varies = wall < 6 && range_[0] < range_[1];
  const std::size_t degree = varies ? (order_ + 3) * (powers - 1) : 0;
  const GaussRule& rule = gauss_rule(degree + 1);
  std::map<std::array<int, 2>, PatchIntegral> integrals;
  std::vector<std::vector<Interval>> coefficients(fixed_.size(), std::vector<Interval>(degree + 1));
  std::vector<Interval> legendre(degree + 1);
  for (std::size_t g = 0; g <= degree; ++g) {
    const Interval half(0x1p-21), low(static_cast<double>(range_[0])),
        high(static_cast<double>(range_[1]));
    const Interval number = half * (low + high + rule.nodes[g] * (high - low));
    std::vector<Interval> sums(fixed_.size());
    for (const std::size_t p : patches) {
      const TilePatch& patch = tile.patches[p];
      const auto known = integrals.try_emplace(patch.degrees, patch.degrees, order_).first;
      known->second.add(enclosed_points(patch, number), sums);
    }
    legendre_values(rule.nodes[g], legendre);
    for (std::size_t e = 0; e <= degree; ++e) {
      const Interval factor =
          Interval(static_cast<double>(e) + 0.5) * rule.weights[g] * legendre[e];
      for (std::size_t m = 0; m < sums.size(); ++m) coefficients[m][e] += factor * sums[m];
    }
  }
  if (!varies) {
    for (std::size_t m = 0; m < fixed_.size(); ++m) fixed_[m] += coefficients[m][0];
    return;
  }
  depends_on_walls_ = true;
  OfWall& of = walls_[static_cast<std::size_t>(wall)];
  // Trailing coefficients that are small beside the patches' part of the volume go into the first one.
  const double small = mag(coefficients[0][0]) * 0x1p-50;
  for (std::vector<Interval>& c : coefficients) {
    Interval rest;
    while (c.size() > 1 && mag(c.back()) <= small) {
      rest += Interval::from_bounds(-mag(c.back()), mag(c.back()));
      c.pop_back();
    }
    c[0] += rest;
    of.first.push_back(static_cast<std::uint32_t>(of.coefficients.size()));
    of.coefficients.insert(of.coefficients.end(), c.begin(), c.end());
    of.most = std::max(of.most, c.size());
  }
  of.first.push_back(static_cast<std::uint32_t>(of.coefficients.size()));
}

void TileMoments::at(const WallNumbers& numbers, std::vector<Interval>& out) const {
  out = fixed_;
  const Interval width(static_cast<double>(range_[1] - range_[0]));
  std::vector<Interval> legendre;
  for (std::size_t w = 0; w < 6; ++w) {
    const OfWall& of = walls_[w];
    if (of.first.empty()) continue;
    legendre.resize(of.most);
    // Numbers and ranges have 21 bits: the numerator is exact.
    legendre_values(Interval(2.0 * numbers[w] - static_cast<double>(range_[0] + range_[1])) / width,
                    legendre);
    for (std::size_t m = 0; m < out.size(); ++m) {
      const Interval* c = of.coefficients.data() + of.first[m];
      const std::size_t count = of.first[m + 1] - of.first[m];
      for (std::size_t e = 0; e < count; ++e) out[m] += c[e] * legendre[e];
    }
  }
}

const TileMoments& MomentTables::of(std::size_t tile, std::size_t order) {
  const std::lock_guard lock(mutex_);
  const auto known = tables_.find({tile, order});
  if (known != tables_.end()) return known->second;
  return tables_.try_emplace({tile, order}, tiles_[tile], order).first->second;
}

}  // namespace veritope::internal
