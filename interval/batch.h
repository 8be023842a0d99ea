// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/batch.h: interval operations on arrays. The bounds lie in two arrays, -lo and hi, so
// that one vector instruction serves 2, 4 or 8 intervals; the instruction set is chosen at run time.
// Source: {-lo, hi} with one rounding direction, [Lam08].
#pragma once
#include <cstddef>

#include "interval/interval.h"
#include "robust/base/sign.h"

namespace veritope {

/// Interval i, for i < n, is [-neg_lo[i], hi[i]]; NaN in both arrays is the empty set. The arrays need no alignment.
/// REQUIRES of operands what Interval requires: lo <= hi, lo < +infinity, hi > -infinity, or empty.
struct ConstIntervalSpan {
  const double* neg_lo = nullptr;
  const double* hi = nullptr;
  std::size_t n = 0;
};
struct IntervalSpan {
  double* neg_lo = nullptr;
  double* hi = nullptr;
  std::size_t n = 0;
  operator ConstIntervalSpan() const { return {neg_lo, hi, n}; }
};

/// kBaseline, kAvx2 and kAvx512 give the same bits. kNearest rounds to nearest and then moves each bound outward by
/// one or two units in the last place, at least 2^-1022: it serves machines that cannot round upward, and gives tests
/// a second opinion. Its results enclose, but they are not tight.
enum class BatchBackEnd { kBaseline, kAvx2, kAvx512, kNearest };

const char* to_string(BatchBackEnd back_end);
/// True if this processor and operating system support the back end's instructions.
bool is_available(BatchBackEnd back_end);
/// The widest of the first three that is available.
BatchBackEnd widest_back_end();

/// Points whose coordinates are intervals. REQUIRES that the three spans have equal lengths.
struct IntervalPointSpan {
  ConstIntervalSpan x, y, z;
};

/// The operations, on one back end. Each loads the control word that it needs, with FTZ and DAZ off, and restores the
/// caller's: callers need no ScopedUpward, and a live one is not disturbed.
/// Laws:
///   (1) out[i] encloses { x op y : x in a[i], y in b[i] }; an operation with an empty operand is empty;
///   (2) except with kNearest, each bound of add, sub, mul, fma, sqr and div is the nearest binary64
///       number outside;
///   (3) the order of the intervals in an array does not matter, nor does what follows its end.
/// REQUIRES operands as long as out; out is the memory of an operand, index by index, or disjoint from it.
class IntervalBatch {
 public:
  /// REQUIRES is_available(back_end).
  explicit IntervalBatch(BatchBackEnd back_end = widest_back_end());
  BatchBackEnd back_end() const { return back_end_; }

  void neg(ConstIntervalSpan a, IntervalSpan out) const;
  void add(ConstIntervalSpan a, ConstIntervalSpan b, IntervalSpan out) const;
  void sub(ConstIntervalSpan a, ConstIntervalSpan b, IntervalSpan out) const;
  void mul(ConstIntervalSpan a, ConstIntervalSpan b, IntervalSpan out) const;
  /// a / b as IEEE 1788 defines it: the hull of the quotients that exist. b = [0, 0] gives the empty
  /// set, b with zero inside the whole line unless a = [0, 0].
  void div(ConstIntervalSpan a, ConstIntervalSpan b, IntervalSpan out) const;
  /// a b + c, rounded once. Slow on kBaseline, which has no such instruction.
  void fma(ConstIntervalSpan a, ConstIntervalSpan b, ConstIntervalSpan c, IntervalSpan out) const;
  /// a b + c, rounded twice.
  void mul_add(ConstIntervalSpan a, ConstIntervalSpan b, ConstIntervalSpan c,
               IntervalSpan out) const;
  void sqr(ConstIntervalSpan a, IntervalSpan out) const;
  /// Encloses the sum of a[i] b[i]; [0, 0] if n = 0. Computes eight sums first, one for each residue of i modulo 8,
  /// and then adds them. REQUIRES spans of equal lengths.
  Interval dot(ConstIntervalSpan a, ConstIntervalSpan b) const;
  /// Encloses det(b - a, c - a, d - a) as predicates/orient3d.h orients it, for n tuples of points.
  void orient3d(const IntervalPointSpan& a, const IntervalPointSpan& b, const IntervalPointSpan& c,
                const IntervalPointSpan& d, IntervalSpan out) const;
  /// The sign that all members of a[i] have, or uncertain; uncertain if a[i] is empty.
  void signs(ConstIntervalSpan a, Sign3* out) const;

 private:
  BatchBackEnd back_end_;
  const struct BatchKernels* kernels_;
};

}  // namespace veritope
