// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/interval_peers.h: loops over other libraries' intervals, each compiled in a file of its own
// with the flags that its library needs. A library that is not installed gives no peer.
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace veritope::bench {

enum class IntervalOp { kAdd, kMul, kMulAdd, kDot, kOrient3d };
inline constexpr IntervalOp kIntervalOps[] = {IntervalOp::kAdd, IntervalOp::kMul,
                                              IntervalOp::kMulAdd, IntervalOp::kDot,
                                              IntervalOp::kOrient3d};

/// The operands of all candidates: n intervals a, b, c, and n tuples of four points, axis by axis (a.x, a.y, ..., d.z),
/// which become point intervals.
struct IntervalData {
  struct Array {
    std::vector<double> lo, hi;
  };
  std::size_t n = 0;
  Array a, b, c;
  std::array<std::vector<double>, 12> points;
};

class IntervalPeer {
 public:
  explicit IntervalPeer(std::string name) : name(std::move(name)) {}
  virtual ~IntervalPeer() = default;
  /// Replaces the operands: converts others and brings them into the cache. REQUIRES the size of
  /// the first ones.
  virtual void load(const IntervalData& data) = 0;
  /// Applies the operation to all n elements, once.
  virtual void run(IntervalOp op) = 0;
  /// The sums of the lower and of the upper bounds that run() computed, rounded to nearest.
  virtual std::array<double, 2> sums(IntervalOp op) = 0;
  std::string name;
};

using IntervalPeers = std::vector<std::unique_ptr<IntervalPeer>>;
void add_boost_peers(const IntervalData& data, IntervalPeers& out);
void add_cgal_peer(const IntervalData& data, IntervalPeers& out);
void add_mpfi_peer(const IntervalData& data, IntervalPeers& out);
void add_arb_peer(const IntervalData& data, IntervalPeers& out);

}  // namespace veritope::bench
