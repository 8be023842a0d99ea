// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/batch_baseline.cc: the instructions that every machine of this architecture has, upward.
#include "interval/batch_baseline_internal.h"

namespace veritope {
namespace {

struct UpwardLanes : BaselineLanes<UpwardLanes> {
  static constexpr bool kUpward = true, kFused = true;
  static UpwardLanes outward(UpwardLanes a) { return a; }
};

}  // namespace

constinit const BatchKernels internal::kBatchBaseline = kernels_of<UpwardLanes>();

}  // namespace veritope
