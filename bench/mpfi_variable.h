// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/mpfi_variable.h: MPFI with 53 bits, in the form that the loops of the benchmarks need.
#pragma once
#include <mpfi.h>

namespace veritope::bench {

class Mpfi {
 public:
  Mpfi() { mpfi_init2(v_, 53); }
  Mpfi(const Mpfi&) = delete;
  Mpfi& operator=(const Mpfi&) = delete;
  ~Mpfi() { mpfi_clear(v_); }

  void set(double lo, double hi) { mpfi_interv_d(v_, lo, hi); }
  static void add(Mpfi& out, const Mpfi& a, const Mpfi& b) { mpfi_add(out.v_, a.v_, b.v_); }
  static void sub(Mpfi& out, const Mpfi& a, const Mpfi& b) { mpfi_sub(out.v_, a.v_, b.v_); }
  static void mul(Mpfi& out, const Mpfi& a, const Mpfi& b) { mpfi_mul(out.v_, a.v_, b.v_); }
  double lower() const { return mpfr_get_d(&v_->left, MPFR_RNDN); }
  double upper() const { return mpfr_get_d(&v_->right, MPFR_RNDN); }

  /// -1, 0, 1, or 2 if its members have several signs.
  static signed char sign(const Mpfi& x) {
    if (mpfi_is_strictly_pos(x.v_)) return 1;
    if (mpfi_is_strictly_neg(x.v_)) return -1;
    return mpfi_is_zero(x.v_) ? 0 : 2;
  }

 private:
  mpfi_t v_;
};

}  // namespace veritope::bench
