// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interval/batch.h"

#include "interval/batch_internal.h"
#include "interval/upward.h"
#include "robust/base/check.h"
#include "robust/base/fp_guard.h"

namespace veritope {
namespace {

static_assert(static_cast<int>(Sign3::kUncertain) == 2 && sizeof(Sign3) == sizeof(int));

#if defined(__x86_64__)
bool cpu_has_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
bool cpu_has_avx512() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
}
#else
bool cpu_has_avx2() { return false; }
bool cpu_has_avx512() { return false; }
#endif

const BatchKernels* kernels_of(BatchBackEnd back_end) {
  switch (back_end) {
    case BatchBackEnd::kBaseline: return &internal::kBatchBaseline;
    case BatchBackEnd::kAvx2: return cpu_has_avx2() ? internal::batch_avx2() : nullptr;
    case BatchBackEnd::kAvx512: return cpu_has_avx512() ? internal::batch_avx512() : nullptr;
    case BatchBackEnd::kNearest: return &internal::kBatchNearest;
  }
  return nullptr;
}

BatchIn in(ConstIntervalSpan a) { return {a.neg_lo, a.hi}; }

// Runs f in the rounding mode of the kernels. Kernels are called through pointers, and the compiler does not move
// such calls across the change of the mode.
template <typename F>
void in_mode(const BatchKernels& kernels, F f) {
  if (kernels.rounds_upward) {
    const ScopedUpward upward;
    f();
  } else {
    const ScopedDefaultFp nearest;
    f();
  }
}

}  // namespace

const char* to_string(BatchBackEnd back_end) {
  switch (back_end) {
    case BatchBackEnd::kBaseline: return "baseline";
    case BatchBackEnd::kAvx2: return "avx2";
    case BatchBackEnd::kAvx512: return "avx512";
    case BatchBackEnd::kNearest: return "nearest";
  }
  return "unknown";
}

bool is_available(BatchBackEnd back_end) { return kernels_of(back_end) != nullptr; }

BatchBackEnd widest_back_end() {
  static const BatchBackEnd widest = is_available(BatchBackEnd::kAvx512) ? BatchBackEnd::kAvx512
                                     : is_available(BatchBackEnd::kAvx2) ? BatchBackEnd::kAvx2
                                                                         : BatchBackEnd::kBaseline;
  return widest;
}

IntervalBatch::IntervalBatch(BatchBackEnd back_end)
    : back_end_(back_end), kernels_(kernels_of(back_end)) {
  VT_CHECK(kernels_ != nullptr, "this processor lacks the back end's instructions");
}

void IntervalBatch::neg(ConstIntervalSpan a, IntervalSpan out) const {
  kernels_->neg(in(a), {out.neg_lo, out.hi}, out.n);
}
void IntervalBatch::add(ConstIntervalSpan a, ConstIntervalSpan b, IntervalSpan out) const {
  in_mode(*kernels_, [&] { kernels_->add(in(a), in(b), {out.neg_lo, out.hi}, out.n); });
}
void IntervalBatch::sub(ConstIntervalSpan a, ConstIntervalSpan b, IntervalSpan out) const {
  in_mode(*kernels_, [&] { kernels_->sub(in(a), in(b), {out.neg_lo, out.hi}, out.n); });
}
void IntervalBatch::mul(ConstIntervalSpan a, ConstIntervalSpan b, IntervalSpan out) const {
  in_mode(*kernels_, [&] { kernels_->mul(in(a), in(b), {out.neg_lo, out.hi}, out.n); });
}
void IntervalBatch::div(ConstIntervalSpan a, ConstIntervalSpan b, IntervalSpan out) const {
  in_mode(*kernels_, [&] { kernels_->div(in(a), in(b), {out.neg_lo, out.hi}, out.n); });
}
void IntervalBatch::sqr(ConstIntervalSpan a, IntervalSpan out) const {
  in_mode(*kernels_, [&] { kernels_->sqr(in(a), {out.neg_lo, out.hi}, out.n); });
}
void IntervalBatch::fma(ConstIntervalSpan a, ConstIntervalSpan b, ConstIntervalSpan c,
                        IntervalSpan out) const {
  in_mode(*kernels_, [&] { kernels_->fma(in(a), in(b), in(c), {out.neg_lo, out.hi}, out.n); });
}
void IntervalBatch::mul_add(ConstIntervalSpan a, ConstIntervalSpan b, ConstIntervalSpan c,
                            IntervalSpan out) const {
  in_mode(*kernels_, [&] { kernels_->mul_add(in(a), in(b), in(c), {out.neg_lo, out.hi}, out.n); });
}

Interval IntervalBatch::dot(ConstIntervalSpan a, ConstIntervalSpan b) const {
  double neg_lo = 0, hi = 0;
  in_mode(*kernels_, [&] { kernels_->dot(in(a), in(b), a.n, &neg_lo, &hi); });
  return Interval::from_bounds(-neg_lo, hi);
}

void IntervalBatch::orient3d(const IntervalPointSpan& a, const IntervalPointSpan& b,
                             const IntervalPointSpan& c, const IntervalPointSpan& d,
                             IntervalSpan out) const {
  const BatchIn p[4][3] = {{in(a.x), in(a.y), in(a.z)},
                           {in(b.x), in(b.y), in(b.z)},
                           {in(c.x), in(c.y), in(c.z)},
                           {in(d.x), in(d.y), in(d.z)}};
  in_mode(*kernels_, [&] {
    kernels_->orient3d(p[0], p[1], p[2], p[3], {out.neg_lo, out.hi}, out.n);
  });
}

void IntervalBatch::signs(ConstIntervalSpan a, Sign3* out) const {
  in_mode(*kernels_, [&] { kernels_->signs(in(a), reinterpret_cast<int*>(out), a.n); });
}

}  // namespace veritope
