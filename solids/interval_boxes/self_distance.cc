// SPDX-License-Identifier: LGPL-3.0-or-later
// The least distance of patches that are no neighbours, by branch and bound over pairs of hulls.
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "solids/interval_boxes/box_bounds.h"
#include "solids/interval_boxes/c3_exceptions.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;

bool are_neighbours(const PatchComplex& complex, std::uint32_t p, std::uint32_t q) {
  if (p == q) return true;
  for (std::uint32_t i = 0; i < complex.patch(p).num_sides(); ++i)
    for (std::uint32_t j = 0; j < complex.patch(q).num_sides(); ++j)
      if (complex.vertex({p, i}) == complex.vertex({q, j})) return true;
  return false;
}

struct Pair {
  double bound;
  Id a, b;
  friend bool operator<(const Pair& x, const Pair& y) { return x.bound > y.bound; }
};

}  // namespace

double SelfDistance::box_bound() const { return lo * internal::kPerRootOfThree; }

std::optional<SelfDistance> self_distance(BoundaryModel& model, std::uint64_t max_pairs) {
  PieceForest& forest = model.forest();
  const PatchComplex& complex = model.complex();
  std::priority_queue<Pair> queue;
  double upper = std::numeric_limits<double>::infinity();
  const auto push = [&](Id a, Id b) {
    const Box3d &x = forest.node(a).hull, &y = forest.node(b).hull;
    upper = std::min(upper, internal::greatest_distance(x, y));
    const double bound = internal::least_distance(x, y);
    if (bound <= upper) queue.push({bound, a, b});
  };
  std::uint64_t pairs = 0;
  for (std::uint32_t r = 0; r < forest.num_roots(); ++r)
    for (std::uint32_t s = r + 1; s < forest.num_roots(); ++s) {
      const Id a = forest.root(r), b = forest.root(s);
      if (++pairs > max_pairs) return SelfDistance{0, std::ldexp(upper, -forest.scale()), false};
      if (!are_neighbours(complex, forest.node(a).patch, forest.node(b).patch)) push(a, b);
    }
  if (queue.empty()) return std::nullopt;
  SelfDistance out;
  for (;;) {
    const Pair top = queue.top();
    const double lower = std::min(top.bound, upper);
    out = {std::ldexp(lower, -forest.scale()), std::ldexp(upper, -forest.scale()),
           internal::is_close_above(lower, upper)};
    if (out.is_as_asked || ++pairs > max_pairs) return out;
    queue.pop();
    const bool first = extent(forest.node(top.a).hull) >= extent(forest.node(top.b).hull);
    const Id split = first ? top.a : top.b;
    if (!forest.may_split(split)) return out;
    const Id child = forest.children(split);
    for (Id k = 0; k < 4; ++k) first ? push(child + k, top.b) : push(top.a, child + k);
    if (queue.empty()) return out;
  }
}

}  // namespace veritope
