// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/solvers/bernstein_system.h"
#include "interval/box_geometry.h"

#include <algorithm>
#include <cmath>

#include "splines/de_casteljau.h"

namespace veritope {
namespace {

// If rounding errors are as large as this part of a polynomial's range, there is no hope of seeing its sign.
constexpr double kNoiseShare = 0x1p-4;

using internal::approx_middle;

struct Range {
  double low = 0, high = 0;  // bounds of all members of all coefficients
  double noise = 0;          // the widest coefficient

  bool has_zero() const { return low <= 0 && high >= 0; }
  bool is_noise() const { return !(noise < kNoiseShare * std::max(-low, high)); }
};

Range range_of(std::span<const Interval> coefficients) {
  Range r{coefficients[0].lo(), coefficients[0].hi(), 0};
  for (const Interval& c : coefficients) {
    r.low = std::min(r.low, c.lo());
    r.high = std::max(r.high, c.hi());
    r.noise = std::max(r.noise, c.hi() - c.lo());
  }
  return r;
}

// The mean over the box of each derivative: differences telescope, so only the first and last slices count.
template <std::size_t N>
ApproxMatrix<N> mean_jacobian(const Bezier<Interval, N>& system) {
  ApproxMatrix<N> out{};
  const Grid<N> grid = system.grid();
  for (std::size_t axis = 0; axis < N; ++axis) {
    if (system.degree(axis) == 0) continue;
    const std::size_t last = (grid.size[axis] - 1) * grid.stride(axis);
    for (std::size_t c = 0; c < N; ++c) {
      const auto values = system.component(static_cast<int>(c));
      double sum = 0;
      grid.for_each_line(axis, [&](std::size_t first) {
        sum += approx_middle(values[first + last]) - approx_middle(values[first]);
      });
      out[c][axis] = sum * static_cast<double>(grid.size[axis]) / static_cast<double>(grid.count());
    }
  }
  return out;
}

template <std::size_t N>
Bezier<Interval, N> inflated(Bezier<Interval, N> system) {
  const Interval total = Interval(1 + 2 * kInflation) / Interval(1 + kInflation);
  for (std::size_t axis = 0; axis < N; ++axis) {
    system = right_part(std::move(system), axis, Interval(-kInflation));
    system = left_part(std::move(system), axis, total);
  }
  return system;
}

template <std::size_t N>
std::optional<Box<N>> root_of_inflated(const Bezier<Interval, N>& preconditioned) {
  const Bezier<Interval, N> wide = inflated(preconditioned);
  std::array<Interval, N> at, centre;
  at.fill(Interval(0.5));
  const std::vector<Interval> values = evaluate(wide, at);
  IntervalMatrix<N> derivatives = derivative_hulls(wide);
  // In the coordinates [-1,1]^N derivatives are half as large, so the map is doubled to bring them near I again.
  const Interval two(2);
  std::copy(values.begin(), values.end(), centre.begin());
  for (Interval& v : centre) v = two * v / Interval(1 + 2 * kInflation);
  for (auto& row : derivatives)
    for (Interval& d : row) d = d / Interval(1 + 2 * kInflation);
  return krawczyk(centre, derivatives);
}

// True if the root of the tangent map lies well outside of the inflated box, so that the test would fail. It is a guess
// that saves time.
template <std::size_t N>
bool is_hopeless(const Bezier<Interval, N>& preconditioned) {
  std::array<Interval, N> at;
  at.fill(Interval(0.5));
  for (const Interval& v : evaluate(preconditioned, at))
    if (!(std::abs(approx_middle(v)) < 0.75 + kInflation)) return true;
  return false;
}

// The axis along which the equations vary most. Their variation is not taken relative to their ranges on this piece:
// near a multiple root a box ends with sides in proportion to what they contribute, for example w and w^2.
template <std::size_t N>
std::size_t axis_of_variation(const Bezier<Interval, N>& system) {
  std::array<double, N> variation{};
  const Grid<N> grid = system.grid();
  for (std::size_t axis = 0; axis < N; ++axis) {
    const std::size_t stride = grid.stride(axis);
    for (std::size_t c = 0; c < N; ++c) {
      const auto values = system.component(static_cast<int>(c));
      double most = 0;
      grid.for_each_line(axis, [&](std::size_t first) {
        double length = 0;
        for (std::size_t i = 1; i < grid.size[axis]; ++i)
          length += std::abs(approx_middle(values[first + i * stride]) -
                             approx_middle(values[first + (i - 1) * stride]));
        most = std::max(most, length);
      });
      variation[axis] += most;
    }
  }
  return static_cast<std::size_t>(std::max_element(variation.begin(), variation.end()) -
                                  variation.begin());
}

}  // namespace

template <std::size_t N>
std::pair<Bezier<Interval, N>, Bezier<Interval, N>> halves(const Bezier<Interval, N>& system,
                                                           std::size_t axis) {
  std::pair<Bezier<Interval, N>, Bezier<Interval, N>> out(system, system);
  const Grid<N> grid = system.grid();
  const std::size_t stride = grid.stride(axis), degree = grid.size[axis] - 1;
  const Interval half(0.5);
  for (int c = 0; c < system.num_components(); ++c) {
    Interval* const left = out.first.component(c).data();
    Interval* const right = out.second.component(c).data();
    grid.for_each_line(axis, [&](std::size_t first) {
      for (std::size_t level = 1; level <= degree; ++level) {
        for (std::size_t i = 0; i <= degree - level; ++i) {
          Interval& p = right[first + i * stride];
          p = half * (p + right[first + (i + 1) * stride]);
        }
        left[first + level * stride] = right[first];
      }
    });
  }
  return out;
}

template <std::size_t N>
Bezier<Interval, N> combined(const ApproxMatrix<N>& matrix, const Bezier<Interval, N>& system) {
  Bezier<Interval, N> out(system.degrees(), static_cast<int>(N), false);
  for (std::size_t i = 0; i < N; ++i) {
    const auto to = out.component(static_cast<int>(i));
    for (std::size_t j = 0; j < N; ++j) {
      if (matrix[i][j] == 0) continue;
      const Interval factor(matrix[i][j]);
      const auto from = system.component(static_cast<int>(j));
      for (std::size_t k = 0; k < to.size(); ++k) to[k] += factor * from[k];
    }
  }
  return out;
}

template <std::size_t N>
IntervalMatrix<N> derivative_hulls(const Bezier<Interval, N>& system) {
  IntervalMatrix<N> out;
  const Grid<N> grid = system.grid();
  for (std::size_t axis = 0; axis < N; ++axis) {
    const std::size_t stride = grid.stride(axis), degree = grid.size[axis] - 1;
    for (std::size_t c = 0; c < N; ++c) {
      const auto values = system.component(static_cast<int>(c));
      Interval range = Interval::empty();
      grid.for_each_line(axis, [&](std::size_t first) {
        for (std::size_t i = 0; i < degree; ++i)
          range = hull(range, values[first + (i + 1) * stride] - values[first + i * stride]);
      });
      out[c][axis] = degree == 0 ? Interval() : Interval(static_cast<double>(degree)) * range;
    }
  }
  return out;
}

template <std::size_t N>
Elimination<N> elimination(const Bezier<Interval, N>& system) {
  return eliminate(mean_jacobian(system));
}

template <std::size_t N>
Examination<N> examine(const Bezier<Interval, N>& system) {
  using Kind = typename Examination<N>::Kind;
  Examination<N> out;
  std::array<Range, N> ranges;
  const auto excluded = [&](const Bezier<Interval, N>& equations) {
    bool found = false;
    for (std::size_t c = 0; c < N; ++c) {
      ranges[c] = range_of(equations.component(static_cast<int>(c)));
      found = found || !ranges[c].has_zero();
    }
    if (found) out.kind = Kind::kNoRoot;
    return found;
  };
  if (excluded(system)) return out;
  out.axis = axis_of_variation(system);
  const Elimination<N> rows = elimination(system);
  if (N > 1 && excluded(combined(rows.combination, system))) return out;
  for (const Range& range : ranges) out.is_exhausted = out.is_exhausted || range.is_noise();
  if (!rows.inverse) return out;
  const Bezier<Interval, N> preconditioned = combined(*rows.inverse, system);
  if (excluded(preconditioned) || is_hopeless(preconditioned)) return out;
  if (const auto root = root_of_inflated(preconditioned)) {
    out.kind = Kind::kOneRoot;
    out.root = *root;
  }
  return out;
}

#define VT_INSTANTIATE(N)                                                                         \
  template std::pair<Bezier<Interval, N>, Bezier<Interval, N>> halves(const Bezier<Interval, N>&, \
                                                                      std::size_t);               \
  template Bezier<Interval, N> combined(const ApproxMatrix<N>&, const Bezier<Interval, N>&);      \
  template IntervalMatrix<N> derivative_hulls(const Bezier<Interval, N>&);                        \
  template Elimination<N> elimination(const Bezier<Interval, N>&);                                \
  template Examination<N> examine(const Bezier<Interval, N>&);
VT_INSTANTIATE(1)
VT_INSTANTIATE(2)
VT_INSTANTIATE(3)
VT_INSTANTIATE(4)
#undef VT_INSTANTIATE

}  // namespace veritope
