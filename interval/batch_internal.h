// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/batch_internal.h: one table of array operations a back end. Each back end is compiled
// with the flags of its instruction set, so that its file includes nothing that the linker could
// share with files that must run everywhere: this header and the intrinsics only.
#pragma once
#include <cstddef>

namespace veritope {

/// As ConstIntervalSpan, without its length; [3] stands for x, y, z.
struct BatchIn {
  const double* neg_lo;
  const double* hi;
};
struct BatchOut {
  double* neg_lo;
  double* hi;
};

/// REQUIRES of all entries but neg and signs that the control word is control_word() of fp_state.
struct BatchKernels {
  bool rounds_upward;  ///< else to nearest
  void (*neg)(BatchIn a, BatchOut out, std::size_t n);
  void (*add)(BatchIn a, BatchIn b, BatchOut out, std::size_t n);
  void (*sub)(BatchIn a, BatchIn b, BatchOut out, std::size_t n);
  void (*mul)(BatchIn a, BatchIn b, BatchOut out, std::size_t n);
  void (*div)(BatchIn a, BatchIn b, BatchOut out, std::size_t n);
  void (*sqr)(BatchIn a, BatchOut out, std::size_t n);
  void (*fma)(BatchIn a, BatchIn b, BatchIn c, BatchOut out, std::size_t n);
  void (*mul_add)(BatchIn a, BatchIn b, BatchIn c, BatchOut out, std::size_t n);
  void (*dot)(BatchIn a, BatchIn b, std::size_t n, double* neg_lo, double* hi);
  void (*orient3d)(const BatchIn* a, const BatchIn* b, const BatchIn* c, const BatchIn* d,
                   BatchOut out, std::size_t n);
  void (*signs)(BatchIn a, int* out, std::size_t n);
};

namespace internal {
extern const BatchKernels kBatchBaseline, kBatchNearest;
// Null where the compiler does not make such code.
const BatchKernels* batch_avx2();
const BatchKernels* batch_avx512();
}  // namespace internal

}  // namespace veritope
