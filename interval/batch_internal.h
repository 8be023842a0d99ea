// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/batch_internal.h: one table of array operations for each back end. Each back end is compiled with the
// flags of its instruction set. Its file therefore includes only this header and the intrinsics: nothing that the
// linker could share with files that must run everywhere.
#pragma once
#include <cstddef>

namespace veritope {

/// Like ConstIntervalSpan, but without a length; an array of three holds x, y, z.
struct BatchIn {
  const double* neg_lo;
  const double* hi;
};
struct BatchOut {
  double* neg_lo;
  double* hi;
};

/// REQUIRES for all entries except neg and signs that the control word is control_word() of fp_state.
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
// Null where the compiler cannot generate such code.
const BatchKernels* batch_avx2();
const BatchKernels* batch_avx512();
}  // namespace internal

}  // namespace veritope
