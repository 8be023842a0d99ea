// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/enclosure/range_enclosure.h: enclosures narrowed by cutting the box of parameters, with a proof of how much
// is left.
#pragma once
#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "interval/box.h"
#include "interval/upward.h"
#include "robust/base/result.h"

namespace veritope {
namespace internal {
/// How far v reaches beyond [least, most], rounded upward. REQUIRES a live ScopedUpward.
inline double excess_of(const Interval& v, double least, double most) {
  if (!is_common(v) || !(least < std::numeric_limits<double>::infinity()) ||
      !(most > -std::numeric_limits<double>::infinity()))
    return std::numeric_limits<double>::infinity();
  return std::max((Interval(v.hi()) - Interval(most)).hi(),
                  (Interval(least) - Interval(v.lo())).hi());
}
}  // namespace internal

/// Each component's exact range over the box lies in outer, and reaches within excess of both of its ends.
struct RangeEnclosure {
  std::vector<Interval> outer;
  double excess = 0;        ///< over all components, rounded upward
  std::size_t boxes = 0;    ///< how many the box was cut into
  bool is_reached = false;  ///< excess <= wanted; otherwise the limit on boxes was reached
};

/// Encloses the ranges of `enclose` over `at`: enclose(box) is a Result of one interval per component, which contains
/// its values on the box, for boxes and points of `at`; it converges as boxes shrink. Boxes are cut where a component's
/// bound is farthest from a value that is attained, until no bound is farther than `wanted` from one.
/// @error what enclose reports; kBadArgument for wanted <= 0.
template <std::size_t N, typename Enclose>
Result<RangeEnclosure> narrowed_range(const Box<N>& at, double wanted, std::size_t max_boxes,
                                      const Enclose& enclose) {
  if (!(wanted > 0))
    return Error{Code::kBadArgument, {}, "an excess of at most 0 is not reached by cutting"};
  struct Leaf {
    Box<N> box;
    std::vector<Interval> values;
  };
  std::vector<Leaf> leaves;
  std::vector<double> least, most;  // every component takes a value <= least and one >= most
  const auto add = [&](const Box<N>& box) -> Status {
    auto values = enclose(box);
    if (!values) return values.error();
    Box<N> middle;
    for (std::size_t a = 0; a < N; ++a) middle[a] = Interval(mid(box[a]));
    const auto there = enclose(middle);
    if (!there) return there.error();
    least.resize(values->size(), std::numeric_limits<double>::infinity());
    most.resize(values->size(), -std::numeric_limits<double>::infinity());
    for (std::size_t c = 0; c < least.size(); ++c) {
      least[c] = std::min(least[c], there.value()[c].hi());
      most[c] = std::max(most[c], there.value()[c].lo());
    }
    leaves.push_back({box, std::move(*values)});
    return ok_status();
  };
  if (const Status s = add(at); !s) return s.error();
  RangeEnclosure out;
  for (;;) {
    const ScopedUpward upward;
    std::size_t worst = 0;
    out.excess = 0;
    out.outer.assign(least.size(), Interval::empty());
    for (std::size_t i = 0; i < leaves.size(); ++i)
      for (std::size_t c = 0; c < least.size(); ++c) {
        const Interval& v = leaves[i].values[c];
        out.outer[c] = hull(out.outer[c], v);
        const double far = internal::excess_of(v, least[c], most[c]);
        if (far > out.excess) out.excess = far, worst = i;
      }
    out.boxes = leaves.size();
    out.is_reached = out.excess <= wanted;
    if (out.is_reached || leaves.size() >= max_boxes) return out;
    const Box<N> box = leaves[worst].box;
    const auto [left, right] = split(box, widest_side(box));
    if (left == box) return out;  // no number in between
    leaves.erase(leaves.begin() + static_cast<std::ptrdiff_t>(worst));
    if (const Status s = add(left); !s) return s.error();
    if (const Status s = add(right); !s) return s.error();
  }
}

}  // namespace veritope
