// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "micro_double.h"

namespace {

// abs(a) is m 2^*exponent but for a relative error of less than 2^-51; 2^63 <= m <= 2^64. REQUIRES a != 0.
double leading(const Big& a, int64_t* exponent) {
  const size_t n = a.m.size();
  const int up = 64 - bit_length(a.m.back());
  uint64_t top = a.m.back() << up;
  if (up > 0 && n > 1) top |= a.m[n - 2] >> (64 - up);
  *exponent = 64 * int64_t(n - 1) - up;
  return double(top);
}

double middle(const DoubleBox& b, size_t axis) {  // only orders boxes; no value is infinite
  const double most = std::ldexp(1.0, 1000);
  return std::max(-most, std::min(most, b.lo[axis])) + std::max(-most, std::min(most, b.hi[axis]));
}

}  // namespace

Span span_of(const Big& n, const Big& d) {
  if (n.sign() == 0) return Span{0, 0};
  int64_t of_n, of_d;
  const double m = leading(n, &of_n), q = m / leading(d, &of_d);
  const int64_t e = of_n - of_d;
  const double relative = std::ldexp(1.0, -49);
  Span r = {std::ldexp(1.0, 900), std::numeric_limits<double>::infinity()};  // if e > 1000
  if (e < -1000) r = Span{0, std::ldexp(1.0, -900)};
  if (e >= -1000 && e <= 1000)
    r = Span{std::ldexp(q - q * relative, int(e)), std::ldexp(q + q * relative, int(e))};
  return n.neg ? Span{-r.hi, -r.lo} : r;
}

BoxTree::BoxTree(const std::vector<DoubleBox>& boxes)
    : order_(boxes.size()), nodes_(boxes.empty() ? 0 : 2 * boxes.size() - 1) {
  for (uint32_t i = 0; i < boxes.size(); ++i) order_[i] = i;
  if (!boxes.empty()) build(0, 0, boxes.size(), boxes);
}
void BoxTree::build(size_t node, size_t lo, size_t hi, const std::vector<DoubleBox>& boxes) {
  DoubleBox& n = nodes_[node];
  n = boxes[order_[lo]];
  double least[3], most[3];
  for (size_t k = 0; k < 3; ++k) least[k] = most[k] = middle(n, k);
  for (size_t i = lo + 1; i < hi; ++i)
    for (size_t k = 0; k < 3; ++k) {
      const DoubleBox& b = boxes[order_[i]];
      n.lo[k] = std::min(n.lo[k], b.lo[k]), n.hi[k] = std::max(n.hi[k], b.hi[k]);
      least[k] = std::min(least[k], middle(b, k)), most[k] = std::max(most[k], middle(b, k));
    }
  if (hi - lo == 1) return;
  size_t axis = 0;
  for (size_t k = 1; k < 3; ++k)
    if (most[k] - least[k] > most[axis] - least[axis]) axis = k;
  const size_t half = (hi - lo) / 2;
  std::nth_element(
      order_.begin() + long(lo), order_.begin() + long(lo + half), order_.begin() + long(hi),
      [&](uint32_t a, uint32_t b) { return middle(boxes[a], axis) < middle(boxes[b], axis); });
  build(node + 1, lo, lo + half, boxes);
  build(node + 2 * half, lo + half, hi, boxes);
}
