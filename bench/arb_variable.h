// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/arb_variable.h: the balls of FLINT/Arb with 53 bits, in the form that the loops of the benchmarks need.
#pragma once
#include <arb.h>

namespace veritope::bench {

class Arb {
 public:
  Arb() { arb_init(v_); }
  Arb(const Arb&) = delete;
  Arb& operator=(const Arb&) = delete;
  ~Arb() { arb_clear(v_); }

  void set(double lo, double hi) {
    arf_t a, b;
    arf_init(a), arf_init(b);
    arf_set_d(a, lo), arf_set_d(b, hi);
    arb_set_interval_arf(v_, a, b, 53);
    arf_clear(a), arf_clear(b);
  }
  static void add(Arb& out, const Arb& a, const Arb& b) { arb_add(out.v_, a.v_, b.v_, 53); }
  static void sub(Arb& out, const Arb& a, const Arb& b) { arb_sub(out.v_, a.v_, b.v_, 53); }
  static void mul(Arb& out, const Arb& a, const Arb& b) { arb_mul(out.v_, a.v_, b.v_, 53); }
  double lower() const { return bound(false); }
  double upper() const { return bound(true); }

  /// -1, 0, 1, or 2 if its members have several signs.
  static signed char sign(const Arb& x) {
    if (arb_is_positive(x.v_)) return 1;
    if (arb_is_negative(x.v_)) return -1;
    return arb_is_zero(x.v_) ? 0 : 2;
  }

 private:
  double bound(bool upper) const {
    arf_t a, b;
    arf_init(a), arf_init(b);
    arb_get_interval_arf(a, b, v_, 53);
    const double d = arf_get_d(upper ? b : a, ARF_RND_NEAR);
    arf_clear(a), arf_clear(b);
    return d;
  }
  arb_t v_;
};

}  // namespace veritope::bench
