// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <tuple>

#include "solids/micro/inside/descent_internal.h"
#include "splines/de_casteljau_line.h"

namespace veritope::internal {

namespace {

// half (a + b), for points.
struct HalfOfPoints {
  static Box3 of(const Box3& a, const Box3& b) {
    Box3 out;
    for (std::size_t c = 0; c < 3; ++c)
      out[c] = Interval::nonnegative_multiple(a[c] + b[c], Interval(0.5));
    return out;
  }
  void into_first(Box3& a, const Box3& b) const { a = of(a, b); }
  void into_second(const Box3& a, Box3& b) const { b = of(a, b); }
};

// The spans that [lo, hi] meets, at least one.
std::pair<std::size_t, std::size_t> spans_of(const std::vector<Rational>& knots,
                                             const Interval& x) {
  std::size_t first = 0, last = knots.size() - 2;
  const Rational lo = Rational::from_double(x.lo()), hi = Rational::from_double(x.hi());
  while (first < last && knots[first + 1] < lo) ++first;
  while (last > first && hi < knots[last]) --last;
  return {first, last};
}

}  // namespace

template <std::size_t N>
std::pair<MapNode<N>, MapNode<N>> MapNode<N>::halves() const {
  std::pair<MapNode, MapNode> out{*this, *this};
  Grid<N> grid;
  for (std::size_t a = 0; a < N; ++a) grid.size[a] = static_cast<std::size_t>(degrees[a]) + 1;
  const std::size_t axis = static_cast<std::size_t>(level) % N, stride = grid.stride(axis);
  grid.for_each_line(axis, [&](std::size_t first) {
    split_keeping_right(out.second.points.data() + first, stride, degrees[axis],
                        out.first.points.data() + first, stride, HalfOfPoints{});
  });
  out.first.level = out.second.level = level + 1;
  return out;
}
template struct MapNode<2>;
template struct MapNode<3>;

BridgeNode enclosed_bridge(const MicroBridge& bridge) {
  BridgeNode out{{bridge.degrees[0], bridge.degrees[1], kBridgeAxisDegree}, {}, 0};
  for (const TilePoint& p : bridge.points)
    out.points.emplace_back(enclose(p[0]), enclose(p[1]), enclose(p[2]));
  return out;
}

Box3 lower_ends(const Box3& x) {
  return Box3(Interval(x[0].lo()), Interval(x[1].lo()), Interval(x[2].lo()));
}
Box3 upper_ends(const Box3& x) {
  return Box3(Interval(x[0].hi()), Interval(x[1].hi()), Interval(x[2].hi()));
}

bool BridgeMaps::points(const Box3& x, std::vector<NodePoints>* out) const {
  std::vector<std::vector<Box3>> all;
  if (!boxes(x, &all)) return false;
  for (const auto& points : all) out->emplace_back().assign(points);
  return true;
}

bool BridgeMaps::boxes(const Box3& x, std::vector<std::vector<Box3>>* out) const {
  std::array<std::size_t, 3> first{}, last{};
  for (std::size_t a = 0; a < 3; ++a) std::tie(first[a], last[a]) = spans_of(maps_.knots(a), x[a]);
  std::array<std::size_t, 3> at{};
  for (at[0] = first[0]; at[0] <= last[0]; ++at[0])
    for (at[1] = first[1]; at[1] <= last[1]; ++at[1])
      for (at[2] = first[2]; at[2] <= last[2]; ++at[2]) {
        Box3 begin, end;
        for (std::size_t a = 0; a < 3; ++a) {
          const std::vector<Rational>& knots = maps_.knots(a);
          const Interval origin = enclose(knots[at[a]]),
                         length = enclose(knots[at[a] + 1] - knots[at[a]]);
          const auto unit = [&](double t) {  // beyond the span: its end
            const Interval u = (Interval(t) - origin) / length;
            return Interval::from_bounds(std::clamp(u.lo(), 0.0, 1.0),
                                         std::clamp(u.hi(), 0.0, 1.0));
          };
          begin[a] = unit(x[a].lo());
          end[a] = unit(x[a].hi());
        }
        if (!maps_.net(at).part(begin, end).points(&out->emplace_back())) return false;
      }
  return true;
}

}  // namespace veritope::internal
