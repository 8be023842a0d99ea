// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/arb_peer.cc: the balls of FLINT/Arb with 53 bits.
#include <arb.h>

#include "bench/interval_c_loops.h"

namespace veritope::bench {
namespace {

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

}  // namespace

void add_arb_peer(const IntervalData& data, IntervalPeers& out) {
  out.push_back(std::make_unique<FunctionPeer<Arb>>("arb", data));
}

}  // namespace veritope::bench
