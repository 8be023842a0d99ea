// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/predicate_peers.h: loops over other libraries' predicates, each compiled in a file of its own. A library that
// is not installed gives no peer.
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "predicates/vec.h"

namespace veritope::bench {

enum class Predicate { kOrient2d, kOrient3d, kInCircle, kInSphere };

class PredicatePeer {
 public:
  PredicatePeer(std::string name, std::size_t most_tuples)
      : name(std::move(name)), most_tuples(most_tuples) {}
  virtual ~PredicatePeer() = default;
  /// The points of all tuples: kept as a pointer, or converted here if the library has points of its own.
  virtual void load(const Vec2d* points, std::size_t count) { p2_ = points; }
  virtual void load(const Vec3d* points, std::size_t count) { p3_ = points; }
  /// out[i] = the sign of tuple i < n in our convention, or 2 if the peer is a filter and cannot decide.
  virtual void decide(Predicate predicate, std::size_t n, signed char* out) = 0;
  std::string name;
  std::size_t most_tuples;  ///< slow peers get fewer

 protected:
  const Vec2d* p2_ = nullptr;
  const Vec3d* p3_ = nullptr;
};

using PredicatePeers = std::vector<std::unique_ptr<PredicatePeer>>;
void add_epeck_predicates(PredicatePeers& out);
void add_boost_predicates(PredicatePeers& out);
void add_tetgen_predicates(PredicatePeers& out);
void add_mpfi_predicates(PredicatePeers& out);
void add_arb_predicates(PredicatePeers& out);

}  // namespace veritope::bench
