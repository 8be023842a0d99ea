// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_intersection.cc: --seeds N. Random pairs of bicubic graphs: our intersection, with proofs, and Open
// CASCADE's GeomAPI_IntSS with the tolerance 1e-7. We measure the true gap of its curves. One JSON line a row.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "bench/arguments.h"
#include "bench/random_surfaces.h"
#include "interval/intersect/surface_intersection.h"
#include "interval/numeric.h"
#include "interval/upward.h"
#ifdef VERITOPE_BENCH_OCCT
#include "bench/occt_intersections.h"
#endif

namespace {

using namespace veritope;
using namespace veritope::bench;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v.empty() ? 0 : v[v.size() / 2];
}

constexpr double kGap = 1e-7;

/// A lower bound of the largest distance between the two images of sampled parameters.
[[maybe_unused]] double true_gap(const BSplineSurface<Rational>& a,
                                 const BSplineSurface<Rational>& b,
                                 const std::vector<std::vector<std::array<double, 4>>>& lines) {
  const ScopedUpward upward;
  const auto s1 = EnclosedSurface::make(a), s2 = EnclosedSurface::make(b);
  double most = 0;
  for (const auto& line : lines)
    for (const auto& x : line) {
      const Box3 d = s1->point(x[0], x[1]) - s2->point(x[2], x[3]);
      most = std::max(most, sqrt(sqr(d[0]) + sqr(d[1]) + sqr(d[2])).lo());
    }
  return most;
}

void measure(int n, int seeds) {
  std::vector<double> ours, peer, quotient;
  double gap = 0;
  [[maybe_unused]] double peer_gap = 0;
  [[maybe_unused]] int same_count = 0, same_length = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    Random random(static_cast<std::uint64_t>(1000 * n + seed));
    const auto a = random_graph(n, random), b = random_graph(n, random);
    IntersectionOptions options;
    options.gap = kGap;
    double begin = now();
    const auto x = intersect(a, b, options);
    ours.push_back(now() - begin);
    Interval length;
    for (const auto& branch : x->branches) gap = std::max(gap, branch.gap);
#ifdef VERITOPE_BENCH_OCCT
    OcctPair pair(a, b);
    begin = now();
    const int lines = pair.intersect(kGap);
    peer.push_back(now() - begin);
    quotient.push_back(ours.back() / peer.back());
    double lo = 0, hi = 0;
    for (const auto& branch : x->branches) lo += branch.length.lo(), hi += branch.length.hi();
    same_count += lines == static_cast<int>(x->branches.size());
    const double length_found = pair.length();
    same_length += length_found > lo * 0.999 && length_found < hi * 1.001;
    peer_gap = std::max(peer_gap, true_gap(a, b, pair.sample(kGap, 1000)));
#endif
  }
  std::printf("{\"row\":\"intersection_%dx%d_vs_occt\",\"ours\":%.5g,", n, n, median(ours));
#ifdef VERITOPE_BENCH_OCCT
  std::printf(
      "\"peer\":%.5g,\"unit\":\"s\",\"pairs\":%d,\"median_of_quotients\":%.3g,\"gap\":%.3g,\"peer_"
      "true_gap\":%.3g,"
      "\"peer_right_count\":%d,\"peer_right_length\":%d}\n",
      median(peer), seeds, median(quotient), gap, peer_gap, same_count, same_length);
#else
  std::printf("\"peer\":null,\"unit\":\"s\",\"pairs\":%d,\"gap\":%.3g}\n", seeds, gap);
#endif
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  int seeds = 40;
  bench::read_arguments(argc, argv, {{"--seeds", &seeds}});
  for (const int n : {6, 10, 16}) measure(n, seeds);
  return 0;
}
