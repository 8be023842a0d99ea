// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/interval_loops.h: the benchmark's operations over any interval type with operators.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "bench/interval_peers.h"

namespace veritope::bench {

/// Traits: Type; make(lo, hi); lower(x), upper(x); Scope, an object that lives while operations run.
template <typename Traits>
class OperatorPeer : public IntervalPeer {
 public:
  using T = typename Traits::Type;

  OperatorPeer(std::string name, const IntervalData& data) : IntervalPeer(std::move(name)) {
    load(data);
    out_ = a_;
  }
  void load(const IntervalData& data) override {
    for (std::vector<T>* v : {&a_, &b_, &c_, &points_}) v->clear();
    for (std::size_t i = 0; i < data.n; ++i) {
      a_.push_back(Traits::make(data.a.lo[i], data.a.hi[i]));
      b_.push_back(Traits::make(data.b.lo[i], data.b.hi[i]));
      c_.push_back(Traits::make(data.c.lo[i], data.c.hi[i]));
      for (const std::vector<double>& axis : data.points)
        points_.push_back(Traits::make(axis[i], axis[i]));
    }
  }
  void run(IntervalOp op) override {
    const typename Traits::Scope scope;
    const std::size_t n = a_.size();
    switch (op) {
      case IntervalOp::kAdd:
        for (std::size_t i = 0; i < n; ++i) out_[i] = a_[i] + b_[i];
        break;
      case IntervalOp::kMul:
        for (std::size_t i = 0; i < n; ++i) out_[i] = a_[i] * b_[i];
        break;
      case IntervalOp::kMulAdd:
        for (std::size_t i = 0; i < n; ++i) out_[i] = a_[i] * b_[i] + c_[i];
        break;
      case IntervalOp::kDot: {
        T sum = Traits::make(0, 0);
        for (std::size_t i = 0; i < n; ++i) sum = sum + a_[i] * b_[i];
        out_[0] = sum;
        break;
      }
      case IntervalOp::kOrient3d:
        for (std::size_t i = 0; i < n; ++i) out_[i] = orient3d(&points_[12 * i]);
        break;
    }
    asm volatile("" : : "r"(out_.data()) : "memory");
  }
  std::array<double, 2> sums(IntervalOp op) override {
    std::array<double, 2> s{};
    const std::size_t n = op == IntervalOp::kDot ? 1 : out_.size();
    for (std::size_t i = 0; i < n; ++i)
      s[0] += Traits::lower(out_[i]), s[1] += Traits::upper(out_[i]);
    return s;
  }

 private:
  static T orient3d(const T* p) {
    const T ux = p[3] - p[0], uy = p[4] - p[1], uz = p[5] - p[2];
    const T vx = p[6] - p[0], vy = p[7] - p[1], vz = p[8] - p[2];
    const T wx = p[9] - p[0], wy = p[10] - p[1], wz = p[11] - p[2];
    return (wx * (uy * vz - uz * vy) + wy * (uz * vx - ux * vz)) + wz * (ux * vy - uy * vx);
  }
  std::vector<T> a_, b_, c_, points_, out_;
};

}  // namespace veritope::bench
