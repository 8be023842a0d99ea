// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/soak_intersections.cc: --seeds N --bumps N. Compares random pairs of surfaces with marching squares, and tests
// bumps that pierce a plane by less and less. One JSON line a figure; differences in full on standard error.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/random_surfaces.h"
#include "interval/intersect/surface_intersection.h"
#include "interval/numeric.h"
#include "robust/base/disjoint_sets.h"

namespace {

using namespace veritope;
using namespace veritope::bench;

/// Values of the third component on a grid of points of the unit square.
std::vector<double> heights(const BSplineSurface<Rational>& s, std::size_t points) {
  const std::size_t n = s.grid().size[0];
  std::vector<double> knots, c;
  for (const Rational& k : s.axis(0).knots) knots.push_back(nearest_double(k));
  for (const Rational& v : s.component(2)) c.push_back(nearest_double(v));
  std::vector<double> basis(points * n, 0.0);  // values of cubic B-splines, by Cox and de Boor
  for (std::size_t p = 0; p < points; ++p) {
    const double x = static_cast<double>(p) / static_cast<double>(points - 1);
    std::size_t span = 3;
    while (span + 1 < n && knots[span + 1] <= x) ++span;
    double value[4] = {1, 0, 0, 0};
    for (std::size_t d = 1; d <= 3; ++d) {
      double saved = 0;
      for (std::size_t r = 0; r < d; ++r) {
        const double right = knots[span + r + 1] - x, left = x - knots[span + 1 - d + r];
        const double part = value[r] / (right + left);
        value[r] = saved + right * part, saved = left * part;
      }
      value[d] = saved;
    }
    for (std::size_t r = 0; r < 4; ++r) basis[p * n + span - 3 + r] = value[r];
  }
  std::vector<double> rows(points * n, 0.0), out(points * points, 0.0);
  for (std::size_t p = 0; p < points; ++p)
    for (std::size_t i = 0; i < n; ++i)
      if (basis[p * n + i] != 0)
        for (std::size_t j = 0; j < n; ++j) rows[p * n + j] += basis[p * n + i] * c[i * n + j];
  for (std::size_t p = 0; p < points; ++p)
    for (std::size_t q = 0; q < points; ++q)
      for (std::size_t j = 0; j < n; ++j) out[p * points + q] += rows[p * n + j] * basis[q * n + j];
  return out;
}

struct Count {
  std::size_t arcs = 0, loops = 0;
  friend bool operator==(const Count&, const Count&) = default;
};

/// The components of the zero set on a grid: marching squares, with saddles decided by the mean.
Count marching_squares(const std::vector<double>& f, std::size_t points) {
  // Edge ids: horizontal (p, q)-(p + 1, q), then vertical (p, q)-(p, q + 1).
  const std::size_t half = points * points;
  DisjointSets<std::size_t> classes(2 * half);
  std::vector<char> used(2 * half, 0), on_border(2 * half, 0);
  const auto join = [&](std::size_t a, std::size_t b) {
    used[a] = used[b] = 1;
    classes.join(a, b);
  };
  for (std::size_t p = 0; p + 1 < points; ++p)
    for (std::size_t q = 0; q + 1 < points; ++q) {
      const double v[4] = {f[p * points + q], f[(p + 1) * points + q], f[(p + 1) * points + q + 1],
                           f[p * points + q + 1]};
      const std::size_t edge[4] = {p * points + q, half + (p + 1) * points + q, p * points + q + 1,
                                   half + p * points + q};
      std::size_t crossed[4], n = 0;
      for (std::size_t k = 0; k < 4; ++k)
        if ((v[k] > 0) != (v[(k + 1) % 4] > 0)) crossed[n++] = edge[k];
      if (n == 2) join(crossed[0], crossed[1]);
      if (n == 4) {
        const bool middle = v[0] + v[1] + v[2] + v[3] > 0;
        const bool first = middle == (v[0] > 0);
        join(crossed[0], crossed[first ? 1 : 3]), join(crossed[2], crossed[first ? 3 : 1]);
      }
      if (q == 0) on_border[edge[0]] = 1;
      if (q + 2 == points) on_border[edge[2]] = 1;
      if (p == 0) on_border[edge[3]] = 1;
      if (p + 2 == points) on_border[edge[1]] = 1;
    }
  std::vector<char> seen(2 * half, 0), open(2 * half, 0);
  Count out;
  for (std::size_t e = 0; e < 2 * half; ++e)
    if (used[e] && on_border[e]) open[classes.find(e)] = 1;
  for (std::size_t e = 0; e < 2 * half; ++e)
    if (used[e] && !seen[classes.find(e)])
      seen[classes.find(e)] = 1, ++(open[classes.find(e)] ? out.arcs : out.loops);
  return out;
}

Count count_of(const SurfaceIntersection& x) {
  Count out;
  for (const auto& b : x.branches) ++(b.is_closed ? out.loops : out.arcs);
  return out;
}

std::string place_text(const IntersectionBranch& b) {
  Box4 all = b.segments.front().parameters;
  for (const auto& s : b.segments) all = hull(all, s.parameters);
  return std::string(b.is_closed ? "loop" : "arc") + " of length " + to_string(b.length) + " in " +
         to_string(all[0]) + " x " + to_string(all[1]);
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Returns the number of pairs that are not complete.
std::size_t random_pairs(int n, int seeds) {
  constexpr std::size_t kPoints = 901;
  std::size_t incomplete = 0, equal = 0, branches = 0;
  double worst_gap = 0;
  std::vector<double> seconds;
  for (int seed = 1; seed <= seeds; ++seed) {
    Random random(static_cast<std::uint64_t>(1000 * n + seed));
    const auto a = random_graph(n, random), b = random_graph(n, random);
    const double begin = now();
    const auto x = intersect(a, b);
    seconds.push_back(now() - begin);
    std::vector<double> difference = heights(a, kPoints);
    const std::vector<double> other = heights(b, kPoints);
    for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= other[i];
    const Count ours = count_of(*x), squares = marching_squares(difference, kPoints);
    branches += x->branches.size();
    incomplete += x->is_complete() && x->tangencies.empty() && x->overlaps.empty() ? 0 : 1;
    for (const auto& branch : x->branches) worst_gap = std::max(worst_gap, branch.gap);
    if (ours == squares) {
      ++equal;
      continue;
    }
    std::fprintf(stderr,
                 "%d x %d, seed %d: proved %zu arcs, %zu loops; marching squares %zu, %zu. The "
                 "short ones:\n",
                 n, n, seed, ours.arcs, ours.loops, squares.arcs, squares.loops);
    for (const auto& branch : x->branches)
      if (branch.length.lo() < 0.02) std::fprintf(stderr, "  %s\n", place_text(branch).c_str());
  }
  std::sort(seconds.begin(), seconds.end());
  std::printf(
      "{\"name\":\"pairs_%dx%d\",\"value\":%zu,\"goal\":\"0 not "
      "complete\",\"pairs\":%d,\"as_marching_squares\":%zu,"
      "\"branches\":%zu,\"gap\":%.3g,\"median_s\":%.4f}\n",
      n, n, incomplete, seeds, equal, branches, worst_gap, seconds[seconds.size() / 2]);
  return incomplete;
}

/// Returns the number of bumps that were neither found nor named with a box of the requested size.
std::size_t bumps(double h, int count) {
  std::size_t found = 0, named = 0, bad = 0;
  double widest = 0;
  for (int seed = 1; seed <= count; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    const auto [bump, plane] = bump_and_plane(h, random);
    const auto x = intersect(bump, plane);
    const Count c = count_of(*x);
    if (c == Count{0, 1} && x->is_complete() && x->tangencies.empty()) {
      ++found;
      continue;
    }
    double box = 0;
    for (const auto* list : {&x->tangencies, &x->unresolved})
      for (const auto& place : *list) box = std::max(box, width(place.space));
    const bool is_named =
        c == Count{} && x->tangencies.size() + x->unresolved.size() > 0 && box <= 4 * std::sqrt(h);
    named += is_named ? 1 : 0;
    bad += is_named ? 0 : 1;
    widest = std::max(widest, box);
  }
  std::printf(
      "{\"name\":\"bump_%.0e\",\"value\":%zu,\"goal\":\"%s\",\"of\":%d,\"named\":%zu,\"lost\":%zu,"
      "\"widest_box\":%.3g}\n",
      h, found, h >= 1e-9 ? "all found" : "18 of 20 found, the others named", count, named, bad,
      widest);
  return bad + (h >= 1e-9 && found < static_cast<std::size_t>(count) ? 1 : 0);
}

}  // namespace

int main(int argc, char** argv) {
  int seeds = 40, num_bumps = 20;
  bench::read_arguments(argc, argv, {{"--seeds", &seeds}, {"--bumps", &num_bumps}});
  std::size_t bad = 0;
  for (double h = 0.1; h > 0.5e-12; h /= 10) bad += bumps(h, num_bumps);
  for (const int n : {6, 10, 16}) bad += random_pairs(n, seeds);
  return bad == 0 ? 0 : 1;
}
