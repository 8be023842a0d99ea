// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_collar.cc: from octree keys to a proved collar: seconds for the common subdivision, for K1 with the
// boundary, for the collapse, and for the replay of the collapses, for approximately 10,000, 100,000 and 1,000,000
// cells, one thread, least of the rounds. The cells: a wall of two cells around the surface of a square frame (genus
// 1), first as it is, then with every sixteenth cell split in eight.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/stopwatch.h"
#include "robust/base/check.h"
#include "topology/collar.h"

namespace {

using namespace veritope;
using namespace veritope::bench;

bool in_frame(std::uint32_t n, std::uint32_t margin, std::uint32_t x, std::uint32_t y,
              std::uint32_t z) {
  const auto inside = [&](std::uint32_t p, std::uint32_t size) {
    return margin <= p && p < size - margin;
  };
  const auto in_hole = [&](std::uint32_t p) {
    return n / 3 <= p + margin && p < 2 * n / 3 + margin;
  };
  return inside(x, n) && inside(y, n) && inside(z, n / 2) && !(in_hole(x) && in_hole(y));
}

std::vector<OctreeKey> wall(std::uint32_t n, bool mixed) {
  constexpr std::uint32_t kLevel = 10;
  std::vector<OctreeKey> keys;
  for (std::uint32_t z = 0; z < n / 2; ++z)
    for (std::uint32_t y = 0; y < n; ++y)
      for (std::uint32_t x = 0; x < n; ++x) {
        if (!in_frame(n, 0, x, y, z) || in_frame(n, 2, x, y, z)) continue;
        const OctreeKey key = OctreeKey::make({kLevel, x, y, z}).value();
        if (!mixed || (x + 3 * y + 5 * z) % 16 != 0) {
          keys.push_back(key);
        } else {
          for (unsigned q = 0; q < 8; ++q) keys.push_back(key.child(q));
        }
      }
  return keys;
}

struct Times {
  double set = 1e300, build = 1e300, boundary = 1e300, find = 1e300, replay = 1e300;
};

void measure(const std::string& name, std::uint32_t n, bool mixed) {
  const std::vector<OctreeKey> keys = wall(n, mixed);
  Times t;
  std::size_t faces = 0, collapses = 0;
  for (int round = 0; round < (keys.size() < 200000 ? 7 : 3); ++round) {
    Stopwatch watch;
    OctreeKeySet set = OctreeKeySet::make(keys).value();
    t.set = std::min(t.set, watch.ns());
    watch = Stopwatch();
    const CommonSubdivision complex = CommonSubdivision::build(std::move(set)).value();
    t.build = std::min(t.build, watch.ns());
    watch = Stopwatch();
    const ComplexBoundary boundary = analyse_boundary(complex);
    t.boundary = std::min(t.boundary, watch.ns());
    watch = Stopwatch();
    const Collar collar = find_collar(complex).value();
    t.find = std::min(t.find, watch.ns());
    const std::vector<std::uint32_t> d_plus = collar.d_plus_faces();
    watch = Stopwatch();
    const CollapseCheck check = replay_collapse(complex, d_plus, collar.collapses);
    t.replay = std::min(t.replay, watch.ns());
    VT_CHECK(collar.outcome == CollarOutcome::kCollar && check.fault == CollapseFault::kNone,
             "the wall is a collar");
    VT_CHECK(boundary.components.at(0).genus() == 1, "its surfaces are tori");
    faces = complex.num_faces();
    collapses = collar.collapses.size();
  }
  std::printf(
      "{\"row\":\"%s, %zu "
      "cells\",\"ours\":%.4f,\"peer\":null,\"unit\":\"s\",\"sort\":%.4f,\"subdivision\":%.4f,"
      "\"K1\":%.4f,"
      "\"collapse\":%.4f,\"replay\":%.4f,\"faces\":%zu,\"collapses\":%zu}\n",
      name.c_str(), keys.size(), 1e-9 * (t.set + t.build + t.find), 1e-9 * t.set, 1e-9 * t.build,
      1e-9 * t.boundary, 1e-9 * (t.find - t.boundary), 1e-9 * t.replay, faces, collapses);
  std::fflush(stdout);
}

}  // namespace

int main() {
  for (const std::uint32_t n : {35u, 107u, 336u}) {
    measure("one level", n, false);
    measure("two levels", n, true);
  }
}
