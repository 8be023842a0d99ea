// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/mpfi_peer.cc: MPFI with 53 bits.
#include <mpfi.h>

#include "bench/interval_c_loops.h"

namespace veritope::bench {
namespace {

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

 private:
  mpfi_t v_;
};

}  // namespace

void add_mpfi_peer(const IntervalData& data, IntervalPeers& out) {
  out.push_back(std::make_unique<FunctionPeer<Mpfi>>("mpfi", data));
}

}  // namespace veritope::bench
