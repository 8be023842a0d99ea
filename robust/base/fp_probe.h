// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/fp_probe.h: the arithmetic of fp_guard.h's probe. It has internal linkage on purpose: each translation
// unit that includes it judges its own compiler flags. It must not include fp_strict.h, so that a test can build it
// under wrong flags.
#pragma once

namespace veritope::internal {

/// One bit for each FpProblem, in its order.
#if defined(__clang__)
[[gnu::noinline]]
#else
[[gnu::noipa]]
#endif
[[maybe_unused]] static unsigned
probe_fp_here() {
  // Operands the compiler may not know; the operations between them are ordinary.
  volatile double one_v = 1, small_v = 0x1p-60, most_v = 0x1.8p-53, least_normal_v = 0x1p-1022,
                  least_v = 0x1p-1074, a_v = 1 + 0x1p-27, square_v = 1 + 0x1p-26,
                  half_ulp_v = 0x1p-53, quarter_ulp_v = 0x1p-54, huge_v = 1e308, ten_v = 10;
  const double one = one_v, small = small_v, most = most_v;
  unsigned problems = 0;

  volatile double up = one + small, down = -one - small, above = one + most, below = -one - most;
  if (up != 1 || down != -1 || above != 1 + 0x1p-52 || below != -1 - 0x1p-52) problems |= 1u << 0;

  volatile double half =
      least_normal_v *
      0.5;  // 2^-1023; tested by a product that DAZ could also make 0, so by its bits
  union {
    double d;
    unsigned long long u;
  } bits;
  bits.d = half;
  if (bits.u == 0) problems |= 1u << 1;
  volatile double raised = least_v * 0x1p60;
  bits.d = raised;
  if (bits.u == 0) problems |= 1u << 2;

  const double a = a_v, square = square_v;
  volatile double rest = a * a - square;  // the product's rounding error, if it was not rounded
  const bool to_nearest =
      (problems & 1u) == 0;  // only then can the next two be distinguished from another rounding mode
  if (to_nearest && rest != 0) problems |= 1u << 3;

  const double half_ulp = half_ulp_v, quarter_ulp = quarter_ulp_v, huge = huge_v, ten = ten_v;
  volatile double twice = (one + half_ulp) + quarter_ulp;
  volatile double over = huge * ten / ten;
  if (to_nearest && (twice != 1 || over <= huge)) problems |= 1u << 4;

  const double sum = one + small, part = sum - one;
  volatile double error =
      (one - (sum - part)) + (small - part);  // 2^-60 in every rounding mode; algebra makes it 0
  if (error == 0) problems |= 1u << 5;
  return problems;
}

}  // namespace veritope::internal
