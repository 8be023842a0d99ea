// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/batch_nearest.cc: rounding to nearest, then outward.
// Claim    x real, r = fl(x) to nearest: outward(r) >= x.
// Proof    u = 2^-53, ulp(r) = 2u 2^floor(log2 |r|). |x - r| <= ulp(r) / 2 for normal r, and t = fl(fl(2u |r|)
//          + 2^-1022) >= ulp(r): if 2u |r| >= 2^-1022, it is exact and >= ulp(r), else ulp(r) <= 2^-1022.
//          r + ulp(r) is a binary64 number or beyond the largest, and rounding is monotone, so
//          fl(r + t) >= r + ulp(r) > x. r subnormal or 0: |x - r| <= 2^-1075, t >= 2^-1022.
//          r = +infinity stays. r = -infinity means x < -M, M the largest number: then -M >= x is taken.
// Needs    round to nearest, gradual underflow. 2^-1022 is added, not the least subnormal, which is slow to add.
#include "interval/batch_baseline_internal.h"

namespace veritope {
namespace {

struct NearestLanes : BaselineLanes<NearestLanes> {
  static constexpr bool kUpward = false, kFused = false;
  static NearestLanes outward(NearestLanes r) {
    r = larger(all(-0x1.fffffffffffffp1023), r);  // NaN stays
    return add(r, add(mul(abs(r), all(0x1p-52)), all(0x1p-1022)));
  }
};

}  // namespace

constinit const BatchKernels internal::kBatchNearest = kernels_of<NearestLanes>();

}  // namespace veritope
