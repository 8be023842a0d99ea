// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_predicates.cc: ns a call, one thread, least of the repetitions, ours and CGAL's EPICK
// turn by turn; a row names the predicate and the class of its points. Tier hit rates go with each
// row.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/epick_peer.h"
#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/triangle_triangle.h"
#include "robust/base/random.h"

namespace {

using namespace veritope;

constexpr std::size_t kTuples = 4096;
constexpr int kRepetitions = 40;

double nanoseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

// Points of one class for a predicate of `n` points in `dim` dimensions; `round` asks for
// cocircular or cospherical ones.
using Tuple = std::array<Vec3d, 5>;

void set(Vec3d& p, int k, double v) { (k == 0 ? p.x : (k == 1 ? p.y : p.z)) = v; }

Tuple degenerate(Random& random, int dim, bool round, int bits) {
  Tuple t;
  if (round) {  // corners of a box
    const std::int64_t range = std::int64_t{1} << (bits - 2);
    for (int k = 0; k < dim; ++k) {
      const double c = static_cast<double>(random.between(-range, range)),
                   h = static_cast<double>(random.between(1, range));
      for (Vec3d& p : t) set(p, k, random.below(2) == 0 ? c + h : c - h);
    }
  } else {  // a line or a plane
    const std::int64_t range = std::int64_t{1} << ((bits - 3) / 2);
    std::array<std::int64_t, 3> o, u, v;
    for (int k = 0; k < 3; ++k)
      o[k] = random.between(-range, range), u[k] = random.between(-range, range),
      v[k] = random.between(-range, range);
    for (Vec3d& p : t) {
      const std::int64_t a = random.between(-range, range),
                         b = dim == 2 ? 0 : random.between(-range, range);
      for (int k = 0; k < 3; ++k)
        set(p, k, static_cast<double>(o[k] * range + a * u[k] + b * v[k]));
    }
  }
  return t;
}

Tuple drawn(const std::string& kind, Random& random, int dim, bool round, int n) {
  Tuple t;
  const auto uniform = [&](Vec3d& p) { p = {random.unit(), random.unit(), random.unit()}; };
  if (kind == "D10") return degenerate(random, dim, round, 10);
  if (kind == "D26") return degenerate(random, dim, round, 26);
  if (kind == "D50") return degenerate(random, dim, round, 50);
  if (kind == "N") {
    t = degenerate(random, dim, round, 20);
    for (Vec3d& p : t) {
      for (int k = 0; k < 3; ++k) {
        double v = p[k] * 0x1p-20;
        for (std::int64_t s = random.between(-2, 2); s != 0; s += s > 0 ? -1 : 1)
          v = std::nextafter(v, s > 0 ? 9 : -9);
        set(p, k, v);
      }
    }
    return t;
  }
  for (Vec3d& p : t) uniform(p);
  if (kind == "P") {  // real coordinates on a plane or in a box along the axes
    if (!round) {
      for (Vec3d& p : t) set(p, dim - 1, t[0][dim - 1]);
    } else {
      const Tuple two = t;
      for (Vec3d& p : t)
        p = {two[random.below(2)].x, two[random.below(2)].y, two[random.below(2)].z};
    }
  }
  if (kind == "RW") {
    for (Vec3d& p : t) {
      for (int k = 0; k < 3; ++k) set(p, k, std::ldexp(p[k], -static_cast<int>(random.below(25))));
    }
  }
  if ((kind == "R" || kind == "RW") && !round) {  // the last point constructed, then rounded
    const double a = random.unit(), b = dim == 2 ? 0 : random.unit();
    for (int k = 0; k < 3; ++k) {
      set(t[n - 1], k, t[0][k] + a * (t[1][k] - t[0][k]) + b * (t[2][k] - t[0][k]));
    }
  } else if (kind == "R" || kind == "RW") {  // points on a circle or sphere, rounded
    for (Vec3d& p : t) {
      const double x = p.x - 0.5, y = p.y - 0.5, z = dim == 2 ? 0 : p.z - 0.5,
                   r = std::sqrt(x * x + y * y + z * z);
      p = {x / r, y / r, z / r};
    }
  }
  return t;
}

template <int N, typename Point, typename Ours, typename Peer>
void row(const char* predicate, const std::string& kind, Ours ours, Peer peer) {
  Random random(42);
  const bool flat = sizeof(Point) == sizeof(Vec2d), round = predicate[0] == 'i';
  std::vector<Point> points;
  for (std::size_t i = 0; i < kTuples; ++i) {
    const Tuple t = drawn(kind, random, flat ? 2 : 3, round, N);
    for (int k = 0; k < N; ++k) {
      if constexpr (sizeof(Point) == sizeof(Vec2d)) {
        points.push_back({t[k].x, t[k].y});
      } else {
        points.push_back(t[k]);
      }
    }
  }
  double best = 1e300, best_peer = 1e300;
  long sum = 0, peer_sum = 0;
  for (int r = 0; r < kRepetitions; ++r) {
    auto start = std::chrono::steady_clock::now();
    sum = 0;
    for (std::size_t i = 0; i < kTuples; ++i) sum += to_int(ours(&points[N * i], nullptr));
    best = std::min(best, nanoseconds_since(start));
    start = std::chrono::steady_clock::now();
    peer_sum = peer(points.data(), kTuples);
    best_peer = std::min(best_peer, nanoseconds_since(start));
  }
  TierCounts tally;
  for (std::size_t i = 0; i < kTuples; ++i) ours(&points[N * i], &tally);
  std::printf(
      "{\"row\":\"%s_%s_vs_epick\",\"ours\":%.2f,\"peer\":%.2f,\"unit\":\"ns\",\"same_signs\":%s,"
      "\"tiers\":[%llu,%llu,%llu,%llu]}\n",
      predicate, kind.c_str(), best / kTuples, best_peer / kTuples,
      sum == peer_sum ? "true" : "false", static_cast<unsigned long long>(tally.decided[0]),
      static_cast<unsigned long long>(tally.decided[1]),
      static_cast<unsigned long long>(tally.decided[2]),
      static_cast<unsigned long long>(tally.decided[3]));
}

template <typename Make>
void triangle_row(const char* name, Make make) {
  Random random(7);
  std::vector<IndexedTriangle> t(2 * kTuples);
  for (std::size_t i = 0; i < t.size(); i += 2) {
    for (int k = 0; k < 3; ++k) {
      t[i].id[k] = static_cast<std::uint32_t>(k),
      t[i + 1].id[k] = static_cast<std::uint32_t>(3 + k);
      t[i].point[k] = {random.unit(), random.unit(), random.unit()};
      t[i + 1].point[k] = {random.unit(), random.unit(), random.unit()};
    }
    make(t[i], t[i + 1], random);
  }
  double best = 1e300;
  long sum = 0;
  for (int r = 0; r < kRepetitions; ++r) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < t.size(); i += 2)
      sum += static_cast<long>(triangle_triangle(t[i], t[i + 1]));
    best = std::min(best, nanoseconds_since(start));
  }
  std::printf(
      "{\"row\":\"triangle_triangle_%s\",\"ours\":%.2f,\"peer\":null,\"unit\":\"ns\",\"sum\":%ld}"
      "\n",
      name, best / kTuples, sum / kRepetitions);
}

void share(IndexedTriangle& t, IndexedTriangle& u, int corners) {
  for (int k = 0; k < corners; ++k) u.point[k] = t.point[k], u.id[k] = t.id[k];
}
void flatten(IndexedTriangle& t, IndexedTriangle& u) {
  for (IndexedTriangle* x : {&t, &u}) {
    for (Vec3d& p : x->point) p.z = 0.1;
  }
}

}  // namespace

int main() {
  for (const char* kind : {"U", "N", "D10", "D26", "D50", "P", "R", "RW"}) {
    row<3, Vec2d>(
        "orient2d", kind,
        [](const Vec2d* p, TierCounts* t) { return orient2d(p[0], p[1], p[2], t); },
        bench::epick_orient2d);
    row<4, Vec3d>(
        "orient3d", kind,
        [](const Vec3d* p, TierCounts* t) { return orient3d(p[0], p[1], p[2], p[3], t); },
        bench::epick_orient3d);
    row<4, Vec2d>(
        "in_circle", kind,
        [](const Vec2d* p, TierCounts* t) { return in_circle(p[0], p[1], p[2], p[3], t); },
        bench::epick_in_circle);
    row<5, Vec3d>(
        "in_sphere", kind,
        [](const Vec3d* p, TierCounts* t) { return in_sphere(p[0], p[1], p[2], p[3], p[4], t); },
        bench::epick_in_sphere);
  }
  triangle_row("strangers_apart", [](IndexedTriangle& t, IndexedTriangle& u, Random&) {
    for (Vec3d& p : t.point) p.z *= 0.1;
    for (Vec3d& p : u.point) p.z = p.z * 0.1 + 0.1;
  });
  triangle_row("strangers_random", [](IndexedTriangle&, IndexedTriangle&, Random&) {});
  triangle_row("shared_vertex",
               [](IndexedTriangle& t, IndexedTriangle& u, Random&) { share(t, u, 1); });
  triangle_row("shared_edge",
               [](IndexedTriangle& t, IndexedTriangle& u, Random&) { share(t, u, 2); });
  triangle_row("coplanar_strangers",
               [](IndexedTriangle& t, IndexedTriangle& u, Random&) { flatten(t, u); });
  triangle_row("coplanar_shared_vertex", [](IndexedTriangle& t, IndexedTriangle& u, Random&) {
    flatten(t, u), share(t, u, 1);
  });
  triangle_row("coplanar_shared_edge", [](IndexedTriangle& t, IndexedTriangle& u, Random&) {
    flatten(t, u), share(t, u, 2);
  });
}
