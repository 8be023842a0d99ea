// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/v_cells.h: cells of V-models, made by hand and at random, and other descriptions of them.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/random.h"
#include "solids/vmodel/v_model.h"
#include "splines/bspline_degree.h"
#include "splines/bspline_domain.h"
#include "splines/bspline_pieces.h"

namespace veritope::v_cells {

using Point = std::array<Rational, 3>;

/// The cell on [0,1]^3 of these degrees, without inner knots, whose control point (i, j, k) is point(i, j, k), and
/// whose weight is weight(i, j, k).
template <typename AtIndex>
VVolume polynomial(std::array<int, 3> degrees, AtIndex point) {
  BezierVolume<Rational> map(degrees, 3, false);
  const Grid<3> grid = map.grid();
  for (std::size_t n = 0; n < grid.count(); ++n) {
    const auto at = grid.index_of(n);
    const Point p = point(at[0], at[1], at[2]);
    for (std::size_t c = 0; c < 3; ++c) map.component(static_cast<int>(c))[n] = p[c];
  }
  return to_bspline(map);
}
template <typename AtIndex, typename Weight>
VVolume rational(std::array<int, 3> degrees, AtIndex point, Weight weight) {
  BezierVolume<Rational> map(degrees, 4, true);
  const Grid<3> grid = map.grid();
  for (std::size_t n = 0; n < grid.count(); ++n) {
    const auto at = grid.index_of(n);
    const Point p = point(at[0], at[1], at[2]);
    const Rational w = weight(at[0], at[1], at[2]);
    for (std::size_t c = 0; c < 3; ++c) map.component(static_cast<int>(c))[n] = p[c] * w;
    map.component(3)[n] = w;
  }
  return to_bspline(map);
}

inline VVolume box(const Point& low, const Point& high) {
  return polynomial({1, 1, 1}, [&](std::size_t i, std::size_t j, std::size_t k) {
    return Point{i == 0 ? low[0] : high[0], j == 0 ? low[1] : high[1], k == 0 ? low[2] : high[2]};
  });
}
inline VVolume cube(int x, int y, int z) {
  return box({Rational(x), Rational(y), Rational(z)},
             {Rational(x + 1), Rational(y + 1), Rational(z + 1)});
}

/// The cell with another map after it.
template <typename Map>
VVolume mapped(VVolume cell, Map map) {
  for (std::size_t n = 0; n < cell.grid().count(); ++n) {
    Point p;
    const Rational w = cell.is_rational() ? cell.component(3)[n] : Rational(1);
    for (int c = 0; c < 3; ++c) p[static_cast<std::size_t>(c)] = cell.component(c)[n] / w;
    p = map(p);
    for (int c = 0; c < 3; ++c) cell.component(c)[n] = p[static_cast<std::size_t>(c)] * w;
  }
  return cell;
}

/// Multiplies all homogeneous coordinates by `factor`; the points stay.
inline VVolume with_factor(const VVolume& cell, const Rational& factor) {
  const std::size_t count = cell.grid().count();
  std::vector<Rational> values;
  for (int c = 0; c < 4; ++c)
    for (std::size_t n = 0; n < count; ++n)
      values.push_back((c < 3 || cell.is_rational() ? cell.component(c)[n] : Rational(1)) * factor);
  return {cell.axes(), 4, true, std::move(values)};
}

/// Symmetry s of 48: axes in another order, some of them reversed.
inline VVolume turned(VVolume cell, unsigned s) {
  std::array<std::size_t, 3> order{0, 1, 2};
  for (unsigned i = 0; i < s / 8 % 6; ++i) std::next_permutation(order.begin(), order.end());
  cell = permuted(cell, order);
  for (std::size_t a = 0; a < 3; ++a)
    if ((s >> a & 1) != 0) cell = reversed(cell, a);
  return cell;
}
inline bool is_turn_odd(unsigned s) {
  const unsigned number =
      s / 8 % 6;  // of permutations in lexicographic order: even, odd, odd, even, even, odd
  const bool is_odd = number == 1 || number == 2 || number == 5;
  return is_odd != ((((s & 1) + (s >> 1 & 1) + (s >> 2 & 1)) & 1) != 0);
}

/// Another description of the same map up to an affine change of its domain, at random: degrees, knots, domain, factor.
inline VVolume redescribed(VVolume cell, Random& random) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (random.below(3) == 0) cell = elevate(cell, a, static_cast<int>(1 + random.below(2)));
    const auto& axis = cell.axis(a);
    if (random.below(3) == 0) {
      const Rational t = Rational(static_cast<std::int64_t>(1 + random.below(6))) / Rational(7);
      const Rational u = axis.domain_begin() + t * (axis.domain_end() - axis.domain_begin());
      if (multiplicity(axis, u) < axis.degree) cell = insert_knot(cell, a, u);
    }
    if (random.below(3) == 0) {
      const Rational begin = Rational(random.between(-5, 5)) / Rational(3);
      cell = with_domain(cell, a, begin,
                         begin + Rational(static_cast<std::int64_t>(1 + random.below(9))))
                 .value();
    }
  }
  if (random.below(3) == 0)
    cell =
        with_factor(cell, Rational(static_cast<std::int64_t>(1 + random.below(20))) / Rational(7));
  return cell;
}

/// All numbers, to be pasted back.
inline std::string text_of(const VVolume& cell) {
  std::string out = cell.is_rational() ? "rational" : "polynomial";
  for (std::size_t a = 0; a < 3; ++a) {
    out += " | degree " + std::to_string(cell.axis(a).degree) + " knots";
    for (const Rational& t : cell.axis(a).knots) out += " " + t.to_string();
  }
  for (int c = 0; c < cell.num_components(); ++c) {
    out += "\n ";
    for (const Rational& x : cell.component(c)) out += " " + x.to_string();
  }
  return out + "\n";
}

/// n x n x n cells of a cube, as `map` bends it; map takes a point of [0, n]^3.
template <typename Map>
std::vector<VVolume> grid(int n, std::array<int, 3> degrees, Map map) {
  std::vector<VVolume> out;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        out.push_back(polynomial(degrees, [&](std::size_t i, std::size_t j, std::size_t k) {
          const auto at = [&](int begin, std::size_t index, std::size_t axis) {
            return Rational(begin) +
                   Rational(static_cast<std::int64_t>(index)) / Rational(degrees[axis]);
          };
          return map(Point{at(x, i, 0), at(y, j, 1), at(z, k, 2)});
        }));
  return out;
}

}  // namespace veritope::v_cells
