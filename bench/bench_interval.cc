// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_interval.cc: ns per interval operation, one thread, arrays of 1,024 in the cache, all candidates in turn.
// Each pass has other operands, converted before the clock starts: on the same 1,024 a branch predictor would learn
// their signs. A round is eight passes; the figure is the least of the rounds. Signs are random, one operand in fifty
// contains zero; orient3d is that of point intervals. same_bounds: the sums of all bounds equal the peer's.
#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "bench/interval_loops.h"
#include "bench/interval_peers.h"
#include "bench/stopwatch.h"
#include "interval/batch.h"
#include "interval/interval.h"
#include "predicates/side_batch.h"
#include "robust/base/random.h"

namespace {

using namespace veritope;
using namespace veritope::bench;

constexpr std::size_t kSize = 1024;
constexpr int kRounds = 60, kSlowRounds = 4, kPasses = 8;
constexpr std::size_t kSets = 64;  // sets of operands

IntervalData make_data(Random& random) {
  IntervalData data;
  data.n = kSize;
  for (IntervalData::Array* array : {&data.a, &data.b, &data.c}) {
    for (std::size_t i = 0; i < kSize; ++i) {
      const double lo = 2 * random.unit() - 1;
      array->lo.push_back(lo), array->hi.push_back(lo + 0.04 * random.unit());
    }
  }
  for (std::vector<double>& axis : data.points) {
    for (std::size_t i = 0; i < kSize; ++i) axis.push_back(random.unit());
  }
  return data;
}

struct OursTraits {
  using Type = Interval;
  using Scope = ScopedUpward;
  static Interval make(double lo, double hi) { return Interval::from_bounds(lo, hi); }
  static double lower(const Interval& x) { return x.lo(); }
  static double upper(const Interval& x) { return x.hi(); }
};

class BatchPeer : public IntervalPeer {
 public:
  BatchPeer(BatchBackEnd back_end, const IntervalData& data)
      : IntervalPeer(to_string(back_end)), batch_(back_end) {
    load(data);
    out_ = a_;
  }
  void load(const IntervalData& data) override {
    a_ = Array(data.a), b_ = Array(data.b), c_ = Array(data.c);
    points_.clear();
    for (const std::vector<double>& axis : data.points)
      points_.emplace_back(IntervalData::Array{axis, axis});
  }
  void run(IntervalOp op) override {
    const IntervalSpan out{out_.neg_lo.data(), out_.hi.data(), out_.hi.size()};
    switch (op) {
      case IntervalOp::kAdd: batch_.add(a_.in(), b_.in(), out); break;
      case IntervalOp::kMul: batch_.mul(a_.in(), b_.in(), out); break;
      case IntervalOp::kMulAdd: batch_.mul_add(a_.in(), b_.in(), c_.in(), out); break;
      case IntervalOp::kDot: {
        const Interval sum = batch_.dot(a_.in(), b_.in());
        out_.neg_lo[0] = -sum.lo(), out_.hi[0] = sum.hi();
        break;
      }
      case IntervalOp::kOrient3d:
        batch_.orient3d(point(0), point(1), point(2), point(3), out);
        break;
    }
  }
  std::array<double, 2> sums(IntervalOp op) override {
    std::array<double, 2> s{};
    for (std::size_t i = 0; i < (op == IntervalOp::kDot ? 1 : kSize); ++i)
      s[0] -= out_.neg_lo[i], s[1] += out_.hi[i];
    return s;
  }

 private:
  struct Array {
    std::vector<double> neg_lo, hi;
    Array() = default;
    explicit Array(const IntervalData::Array& from) : hi(from.hi) {
      for (const double lo : from.lo) neg_lo.push_back(-lo);
    }
    ConstIntervalSpan in() const { return {neg_lo.data(), hi.data(), hi.size()}; }
  };
  IntervalPointSpan point(int k) const {
    return {points_[3 * k].in(), points_[3 * k + 1].in(), points_[3 * k + 2].in()};
  }
  IntervalBatch batch_;
  Array a_, b_, c_, out_;
  std::vector<Array> points_;
};

// Nanoseconds of one call, without those of the clock.
double timed(const std::function<void()>& run) {
  const double clock = Stopwatch().ns();
  const Stopwatch watch;
  run();
  return std::max(watch.ns() - clock, 0.0);
}
constexpr double kPerRound = kPasses * static_cast<double>(kSize);

const char* name_of(IntervalOp op) {
  switch (op) {
    case IntervalOp::kAdd: return "add";
    case IntervalOp::kMul: return "mul";
    case IntervalOp::kMulAdd: return "mul_add";
    case IntervalOp::kDot: return "dot";
    case IntervalOp::kOrient3d: return "orient3d";
  }
  return "";
}

void print_row(const std::string& row, double ours, double peer, bool same) {
  std::printf("{\"row\":\"%s\",\"ours\":%.3f,\"peer\":%.3f,\"unit\":\"ns\",\"same_bounds\":%s}\n",
              row.c_str(), ours, peer, same ? "true" : "false");
}

void interval_rows(IntervalOp op, const std::vector<IntervalData>& data, const IntervalPeers& ours,
                   const IntervalPeers& peers) {
  std::vector<double> ns(ours.size() + peers.size(), 1e300);
  const auto candidate = [&](std::size_t k) -> IntervalPeer& {
    return k < ours.size() ? *ours[k] : *peers[k - ours.size()];
  };
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t k = 0; k < ns.size(); ++k) {
      const bool is_slow = ns[k] < 1e300 && ns[k] > (op == IntervalOp::kOrient3d ? 100 : 10);
      if (is_slow && round % (kRounds / kSlowRounds) != 0) continue;
      double total = 0;
      for (int pass = 0; pass < kPasses; ++pass) {
        candidate(k).load(data[static_cast<std::size_t>(round * kPasses + pass) % kSets]);
        total += timed([&] { candidate(k).run(op); });
      }
      ns[k] = std::min(ns[k], total / kPerRound);
    }
  }
  for (std::size_t k = 0; k < ns.size(); ++k) candidate(k).load(data[0]), candidate(k).run(op);
  for (std::size_t k = 0; k < ours.size(); ++k) {
    for (std::size_t p = 0; p < peers.size(); ++p) {
      const bool same = ours[k]->sums(op) == peers[p]->sums(op);
      const std::string how = k == 0 ? "" : "_batch_" + ours[k]->name;
      print_row(std::string("interval_") + name_of(op) + how + "_vs_" + peers[p]->name, ns[k],
                ns[ours.size() + p], same);
    }
  }
  // The back end that widest_back_end() names is the batch.
  for (std::size_t k = 1; k < ours.size(); ++k) {
    if (ours[k]->name != to_string(widest_back_end())) continue;
    for (std::size_t p = 0; p < peers.size(); ++p) {
      print_row(std::string("interval_batch_") + name_of(op) + "_vs_" + peers[p]->name, ns[k],
                ns[ours.size() + p], ours[k]->sums(op) == peers[p]->sums(op));
    }
  }
}

// One plane, many points: the batch compared with the same filter point by point.
void side_rows(const std::vector<IntervalData>& sets) {
  std::vector<Sign3> batch(kSize), single(kSize);
  const std::size_t back_ends = internal::num_side_back_ends();
  std::vector<double> ns(back_ends + 1, 1e300);
  std::vector<bool> same(back_ends, true);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> total(back_ends + 1);
    for (int pass = 0; pass < kPasses; ++pass) {
      const auto& p = sets[static_cast<std::size_t>(round * kPasses + pass) % kSets].points;
      const Vec3d a{p[0][0], p[1][0], p[2][0]}, b{p[3][0], p[4][0], p[5][0]},
          c{p[6][0], p[7][0], p[8][0]};
      const PointArrays points{p[9].data(), p[10].data(), p[11].data(), kSize};
      const auto one_by_one = [&] {
        const Orient3dPlaneFilter filter(a, b, c);
        for (std::size_t i = 0; i < kSize; ++i) single[i] = filter(points.at(i));
      };
      one_by_one();  // afterwards the points are in the cache, too
      total[back_ends] += timed(one_by_one);
      for (std::size_t k = 0; k < back_ends; ++k) {
        total[k] += timed([&] { internal::orient3d_filter_on(k, a, b, c, points, batch.data()); });
        same[k] = same[k] && batch == single;
      }
    }
    for (std::size_t k = 0; k <= back_ends; ++k) ns[k] = std::min(ns[k], total[k] / kPerRound);
  }
  constexpr const char* kNames[] = {"baseline", "avx2", "avx512"};
  for (std::size_t k = 0; k < back_ends; ++k)
    print_row(std::string("side_batch_") + kNames[k] + "_vs_single", ns[k], ns[back_ends], same[k]);
}

}  // namespace

int main() {
  Random random(42);
  std::vector<IntervalData> data;
  for (std::size_t k = 0; k < kSets; ++k) data.push_back(make_data(random));
  IntervalPeers ours, peers;
  ours.push_back(std::make_unique<OperatorPeer<OursTraits>>("scalar", data[0]));
  for (const BatchBackEnd b : {BatchBackEnd::kBaseline, BatchBackEnd::kAvx2, BatchBackEnd::kAvx512,
                               BatchBackEnd::kNearest}) {
    if (is_available(b)) ours.push_back(std::make_unique<BatchPeer>(b, data[0]));
  }
  add_boost_peers(data[0], peers);
  add_cgal_peer(data[0], peers);
#if defined(VERITOPE_BENCH_MPFI)
  add_mpfi_peer(data[0], peers);
#endif
#if defined(VERITOPE_BENCH_ARB)
  add_arb_peer(data[0], peers);
#endif
  for (const IntervalOp op : kIntervalOps) interval_rows(op, data, ours, peers);
  side_rows(data);
}
