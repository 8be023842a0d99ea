// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/mpfr_internal.h: binary64 values of MPFR's functions, correctly rounded downward or upward. [FHL07] rounds
// each function correctly at its precision; directed roundings compose, so that the result stays correct after the
// second one, to binary64 with its subnormals and overflow.
#pragma once
#include <mpfr.h>

#include <utility>

#include "interval/bound_pair.h"
#include "interval/interval.h"
#include "robust/base/fp_guard.h"

namespace veritope::internal {

/// From construction to destruction this thread has the default floating-point environment and MPFR's default range
/// of exponents, whatever it had before: another user of MPFR in this thread may have narrowed the range, so that a
/// double would not fit. MPFR's caches of the thread are freed when the thread ends.
class MpfrScope {
 public:
  MpfrScope() : emin_(mpfr_get_emin()), emax_(mpfr_get_emax()) {
    static thread_local const CacheOwner owner;
    mpfr_set_emin(MPFR_EMIN_DEFAULT);
    mpfr_set_emax(MPFR_EMAX_DEFAULT);
  }
  ~MpfrScope() {
    mpfr_set_emin(emin_);
    mpfr_set_emax(emax_);
  }
  MpfrScope(const MpfrScope&) = delete;
  MpfrScope& operator=(const MpfrScope&) = delete;

 private:
  struct CacheOwner {
    CacheOwner() {}  // not trivial: its construction registers the destructor
    ~CacheOwner() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
  };
  ScopedDefaultFp environment_;
  mpfr_exp_t emin_, emax_;
};

/// One MPFR number. REQUIRES a live MpfrScope where doubles go in or out.
class Real {
 public:
  explicit Real(mpfr_prec_t precision = 53) { mpfr_init2(v_, precision); }
  explicit Real(double value) : Real() { mpfr_set_d(v_, value, MPFR_RNDN); }
  ~Real() { mpfr_clear(v_); }
  Real(const Real&) = delete;
  Real& operator=(const Real&) = delete;

  mpfr_ptr get() { return v_; }
  mpfr_srcptr get() const { return v_; }
  /// Rounds the value to binary64 in that direction.
  double round(mpfr_rnd_t direction) const { return mpfr_get_d(v_, direction); }

 private:
  mpfr_t v_;
};

using RealFunction = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);
using RealFunction2 = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

inline double rounded(RealFunction f, double x, mpfr_rnd_t direction) {
  Real v(x);
  f(v.get(), v.get(), direction);
  return v.round(direction);
}
inline double rounded(RealFunction2 f, double x, double y, mpfr_rnd_t direction) {
  Real v(x), w(y);
  f(v.get(), v.get(), w.get(), direction);
  return v.round(direction);
}
/// [f(lo), f(hi)] outward: the range of an increasing f.
inline Interval rising(RealFunction f, double lo, double hi) {
  return Interval::from_bounds(rounded(f, lo, MPFR_RNDD), rounded(f, hi, MPFR_RNDU));
}
inline Interval falling(RealFunction f, double lo, double hi) {
  return Interval::from_bounds(rounded(f, hi, MPFR_RNDD), rounded(f, lo, MPFR_RNDU));
}

}  // namespace veritope::internal
