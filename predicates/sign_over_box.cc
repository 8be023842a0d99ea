// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/sign_over_box.cc: sign_over_patch.h on boxes.
#include "predicates/sign_over_patch_internal.h"

namespace veritope {
namespace {

template <std::size_t N>
struct BoxDomain {
  static constexpr std::size_t kDimension = N, kCorners = 2;
  using Point = std::array<Rational, N>;
  using Cut = std::size_t;  // the axis
  struct Region {
    Point lo, hi;
  };
  Grid<N> grid;

  Region whole() const {
    Region r;
    r.hi.fill(Rational(1));
    return r;
  }
  std::vector<std::pair<std::size_t, Point>> corners(const Region& r) const {
    std::vector<std::pair<std::size_t, Point>> out;
    for (std::size_t bits = 0; bits < std::size_t{1} << N; ++bits) {
      std::array<std::size_t, N> index;
      Point at;
      for (std::size_t a = 0; a < N; ++a) {
        const bool is_high = (bits >> a & 1) != 0;
        index[a] = is_high ? grid.size[a] - 1 : 0, at[a] = is_high ? r.hi[a] : r.lo[a];
      }
      out.emplace_back(grid.at(index), std::move(at));
    }
    return out;
  }
  Point middle(const Region& r) const {
    Point at;
    for (std::size_t a = 0; a < N; ++a) at[a] = internal::halved(r.lo[a] + r.hi[a]);
    return at;
  }
  std::array<Point, 2> place(const Region& r) const { return {r.lo, r.hi}; }

  // The axis along which coefficients differ most; every (N + 1)-th cut takes the axes in turn, so that none starves.
  Cut choose(const Region&, const std::vector<Interval>& values, std::size_t depth) const {
    if (depth % (N + 1) == N) return depth / (N + 1) % N;
    Cut best = 0;
    double most = -1;
    for (std::size_t a = 0; a < N; ++a) {
      const std::size_t stride = grid.stride(a);
      double here = 0;
      grid.for_each_line(a, [&](std::size_t first) {
        for (std::size_t i = 1; i < grid.size[a]; ++i)
          here = std::max(here, mag(values[first + i * stride] - values[first + (i - 1) * stride]));
      });
      if (here > most) most = here, best = a;
    }
    return best;
  }
  std::pair<Region, Region> halves(const Region& r, Cut axis) const {
    std::pair<Region, Region> out(r, r);
    out.first.hi[axis] = out.second.lo[axis] = internal::halved(r.lo[axis] + r.hi[axis]);
    return out;
  }
  template <typename R>
  std::vector<R> half(std::vector<R> values, Cut axis, int which) const {
    const std::size_t stride = grid.stride(axis);
    std::vector<R> line, left;
    grid.for_each_line(axis, [&](std::size_t first) {
      line.clear();
      for (std::size_t i = 0; i < grid.size[axis]; ++i) line.push_back(values[first + i * stride]);
      internal::halve_keeping_right(line, left);
      for (std::size_t i = 0; i < grid.size[axis]; ++i)
        values[first + i * stride] = which == 0 ? left[i] : line[i];
    });
    return values;
  }
};

}  // namespace

template <std::size_t N>
BoxSign<N> sign_over_box(const Bezier<Rational, N>& map, int component, const SignBudget& budget) {
  VT_CHECK(component >= 0 && component < map.num_components(), "the component exists");
  const BoxDomain<N> domain{map.grid()};
  const auto values = map.component(component);
  return internal::SignSearch<BoxDomain<N>>(domain, {values.begin(), values.end()}, budget).run();
}

template BoxSign<1> sign_over_box(const Bezier<Rational, 1>&, int, const SignBudget&);
template BoxSign<2> sign_over_box(const Bezier<Rational, 2>&, int, const SignBudget&);
template BoxSign<3> sign_over_box(const Bezier<Rational, 3>&, int, const SignBudget&);

}  // namespace veritope
