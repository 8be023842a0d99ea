// SPDX-License-Identifier: Apache-2.0 OR MIT
// micro_double.h: bounds in double precision, and trees of boxes. Every bound is right for any of the roundings of IEEE
// 754, with or without excess precision: such a result r differs from the exact one by at most 2^-51 abs(r) +
// 2^-1070, which is far less than what is added here for it.
#pragma once
#include <cmath>
#include <limits>

#include "../patches/big.h"

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "infinite values and values that are no numbers mean something here"
#endif
static_assert(std::numeric_limits<double>::is_iec559, "IEEE 754");

struct Span {  // a number lies between these
  double lo, hi;
};
Span span_of(const Big& n, const Big& d);  // of n / d; REQUIRES d > 0
inline Span span_of(const Ratio& x) { return span_of(x.n, x.d); }

struct DoubleBox {  // closed
  double lo[3], hi[3];
  bool meets(const DoubleBox& b) const {
    return lo[0] <= b.hi[0] && b.lo[0] <= hi[0] && lo[1] <= b.hi[1] && b.lo[1] <= hi[1] &&
           lo[2] <= b.hi[2] && b.lo[2] <= hi[2];
  }
};

class BoxTree {
 public:
  explicit BoxTree(const std::vector<DoubleBox>& boxes);
  // Calls visit(its number) for each box that meets b, until that is false; then the result is false.
  template <class Visit>
  bool each(const DoubleBox& b, const Visit& visit) const {
    return order_.empty() || each_of(0, 0, order_.size(), b, visit);
  }

 private:
  template <class Visit>
  bool each_of(size_t node, size_t lo, size_t hi, const DoubleBox& b, const Visit& visit) const {
    if (!nodes_[node].meets(b)) return true;
    if (hi - lo == 1) return visit(order_[lo]);
    const size_t half = (hi - lo) / 2;
    return each_of(node + 1, lo, lo + half, b, visit) &&
           each_of(node + 2 * half, lo + half, hi, b, visit);
  }
  void build(size_t node, size_t lo, size_t hi, const std::vector<DoubleBox>& boxes);

  std::vector<uint32_t> order_;   // the boxes by their places in the tree
  std::vector<DoubleBox> nodes_;  // in preorder; the first half of n boxes has floor(n / 2) of them
};
