// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/interval_c_loops.h: the benchmark's operations over an interval type of a C library, whose
// functions write into a variable.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "bench/interval_peers.h"

namespace veritope::bench {

/// V: a variable, of 53 bits; set(lo, hi), add(V& out, a, b), sub, mul, lower(), upper().
template <typename V>
class FunctionPeer : public IntervalPeer {
 public:
  FunctionPeer(std::string name, const IntervalData& data)
      : IntervalPeer(std::move(name)),
        n_(data.n),
        a_(n_),
        b_(n_),
        c_(n_),
        out_(n_),
        points_(12 * n_) {
    load(data);
  }
  void load(const IntervalData& data) override {
    for (std::size_t i = 0; i < n_; ++i) {
      a_[i].set(data.a.lo[i], data.a.hi[i]);
      b_[i].set(data.b.lo[i], data.b.hi[i]);
      c_[i].set(data.c.lo[i], data.c.hi[i]);
      for (std::size_t k = 0; k < 12; ++k)
        points_[12 * i + k].set(data.points[k][i], data.points[k][i]);
    }
  }
  void run(IntervalOp op) override {
    if (op == IntervalOp::kDot) out_[0].set(0, 0);
    for (std::size_t i = 0; i < n_; ++i) {
      switch (op) {
        case IntervalOp::kAdd: V::add(out_[i], a_[i], b_[i]); break;
        case IntervalOp::kMul: V::mul(out_[i], a_[i], b_[i]); break;
        case IntervalOp::kMulAdd:
          V::mul(t_[0], a_[i], b_[i]);
          V::add(out_[i], t_[0], c_[i]);
          break;
        case IntervalOp::kDot:
          V::mul(t_[0], a_[i], b_[i]);
          V::add(out_[0], out_[0], t_[0]);
          break;
        case IntervalOp::kOrient3d: orient3d(&points_[12 * i], out_[i]); break;
      }
    }
  }
  std::array<double, 2> sums(IntervalOp op) override {
    std::array<double, 2> s{};
    for (std::size_t i = 0; i < (op == IntervalOp::kDot ? 1 : n_); ++i)
      s[0] += out_[i].lower(), s[1] += out_[i].upper();
    return s;
  }

 private:
  void orient3d(const V* p, V& out) {
    for (int k = 0; k < 9; ++k) V::sub(t_[k], p[3 + k], p[k % 3]);
    for (int k = 0; k < 3; ++k) {  // w_k (u_i v_j - u_j v_i)
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      V::mul(t_[9], t_[i], t_[3 + j]);
      V::mul(t_[10], t_[j], t_[3 + i]);
      V::sub(t_[9], t_[9], t_[10]);
      V::mul(t_[11 + k], t_[6 + k], t_[9]);
    }
    V::add(t_[9], t_[11], t_[12]);
    V::add(out, t_[9], t_[13]);
  }
  std::size_t n_;
  std::vector<V> a_, b_, c_, out_, points_;
  V t_[14];
};

}  // namespace veritope::bench
