// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_implicit.cc: implicit points compared with CGAL's EPECK, ns a call, one thread, least of the repetitions.
// lpi: line and plane; tpi: three planes. G: everything uniform. Z: the query plane passes exactly through the point:
// it contains the line, or is the third plane. cached: points that know their digits already. Rows without a peer:
// predicates on several implicit points; N: points that the filter decides, Z: exact zeros.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "bench/epeck_peer.h"
#include "predicates/implicit_cache.h"
#include "predicates/implicit_predicates.h"
#include "robust/base/random.h"

namespace {
std::size_t allocations = 0;
}
void* operator new(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace {

using namespace veritope;

constexpr std::size_t kTuples = 2000;
constexpr int kRepetitions = 20;

template <typename Run>
double nanoseconds(Run run) {
  const auto start = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start)
             .count() /
         kTuples;
}

struct Cells {
  double construct = 1e300, orient = 1e300;
  long sum = 0;
};

void print_row(const char* kind, const char* cell, const char* step, double ours, double peer,
               bool same, std::size_t allocated, const TierCounts& tally) {
  std::printf(
      "{\"row\":\"%s_%s_%s_vs_epeck\",\"ours\":%.1f,\"peer\":%.1f,\"unit\":\"ns\",\"same_signs\":%"
      "s,"
      "\"allocations\":%zu,\"tiers\":[%llu,%llu,%llu,%llu]}\n",
      kind, step, cell, ours, peer, same ? "true" : "false", allocated,
      static_cast<unsigned long long>(tally[Tier::kFilter]),
      static_cast<unsigned long long>(tally[Tier::kLattice]),
      static_cast<unsigned long long>(tally[Tier::kInterval]),
      static_cast<unsigned long long>(tally[Tier::kExact]));
}

// Calls make(p) for the implicit point of each tuple.
template <std::size_t Defining, typename Point, typename Make>
void rows(const char* kind, bool through, Make make) {
  constexpr std::size_t kStride = Defining + 3;
  Random random(5);
  std::vector<Vec3d> p(kTuples * kStride);
  for (Vec3d& v : p) v = {random.unit(), random.unit(), random.unit()};
  for (std::size_t i = 0; through && i < kTuples; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      p[kStride * i + Defining + k] = p[kStride * i + Defining - 3 + k];
  }
  Cells ours, peer;
  std::vector<Point> made;
  made.reserve(kTuples);
  TierCounts tally;
  const auto orient = [&](TierCounts* t) {
    long sum = 0;
    for (std::size_t i = 0; i < kTuples; ++i) {
      const Vec3d* q = &p[kStride * i + Defining];
      sum += to_int(orient3d(q[0], q[1], q[2], made[i], t));
    }
    return sum;
  };
  const std::size_t before = allocations;
  for (int r = 0; r < kRepetitions; ++r) {
    made.clear();
    ours.construct = std::min(ours.construct, nanoseconds([&] {
                                for (std::size_t i = 0; i < kTuples; ++i)
                                  made.push_back(make(&p[kStride * i]));
                              }));
    ours.orient = std::min(ours.orient, nanoseconds([&] { ours.sum = orient(nullptr); }));
  }
  const std::size_t allocated = allocations - before;
  for (int r = 0; r < 3; ++r) {  // made anew each time: its points remember their exact coordinates
    bench::EpeckPoints epeck(p.data(), kTuples, Defining == 9);
    peer.construct = std::min(peer.construct, nanoseconds([&] { epeck.construct(); }));
    peer.orient = std::min(peer.orient, nanoseconds([&] { peer.sum = epeck.orient(); }));
  }
  orient(&tally);
  std::vector<CachedPoint<Point>> cached;
  for (const Point& point : made) cached.emplace_back(point);
  Cells remembered;
  TierCounts cached_tally;
  const auto orient_cached = [&](TierCounts* t) {
    long sum = 0;
    for (std::size_t i = 0; i < kTuples; ++i) {
      const Vec3d* q = &p[kStride * i + Defining];
      sum += to_int(orient3d(q[0], q[1], q[2], cached[i], t));
    }
    return sum;
  };
  orient_cached(&cached_tally);
  for (int r = 0; r < kRepetitions; ++r) {
    remembered.orient =
        std::min(remembered.orient, nanoseconds([&] { remembered.sum = orient_cached(nullptr); }));
  }
  const char* cell = through ? "Z" : "G";
  print_row(kind, cell, "construct", ours.construct, peer.construct, true, allocated, {});
  print_row(kind, cell, "orient3d", ours.orient, peer.orient, ours.sum == peer.sum, allocated,
            tally);
  print_row(kind, cell, "cached_orient3d", remembered.orient, peer.orient,
            remembered.sum == peer.sum, 0, cached_tally);
}

// ask(i, tally) returns a sign.
template <typename Ask>
void row_alone(const char* name, Ask ask) {
  constexpr std::size_t kCalls = 500;
  TierCounts tally;
  double best = 1e300;
  const std::size_t before = allocations;
  for (std::size_t i = 0; i < kCalls; ++i) ask(i, &tally);
  for (int r = 0; r < kRepetitions; ++r) {
    const double all = nanoseconds([&] {
      for (std::size_t i = 0; i < kCalls; ++i) ask(i, nullptr);
    });
    best = std::min(best, all * kTuples / kCalls);
  }
  std::printf(
      "{\"row\":\"%s\",\"ours\":%.1f,\"peer\":null,\"unit\":\"ns\",\"allocations\":%zu,\"tiers\":[%"
      "llu,"
      "%llu,%llu,%llu]}\n",
      name, best, allocations - before, static_cast<unsigned long long>(tally[Tier::kFilter]),
      static_cast<unsigned long long>(tally[Tier::kLattice]),
      static_cast<unsigned long long>(tally[Tier::kInterval]),
      static_cast<unsigned long long>(tally[Tier::kExact]));
}

// Points of several lines on one plane (the first five), and points of other planes.
void rows_of_several() {
  Random random(6);
  const auto draw = [&]() -> Vec3d { return {random.unit(), random.unit(), random.unit()}; };
  const std::array<Vec3d, 3> plane{draw(), draw(), draw()};
  std::vector<LinePlanePoint> flat, apart;
  std::vector<CachedPoint<LinePlanePoint>> cached;
  std::vector<ThreePlanePoint> corners;
  for (std::size_t i = 0; i < 512; ++i) {
    flat.emplace_back(draw(), draw(), plane[0], plane[1], plane[2]);
    apart.emplace_back(draw(), draw(), draw(), draw(), draw());
    cached.emplace_back(flat.back());
    corners.emplace_back(std::array<Vec3d, 9>{plane[0], plane[1], plane[2], draw(), draw(), draw(),
                                              draw(), draw(), draw()});
  }
  const Vec3d far = draw();
  row_alone("any_orient3d_4lpi_N", [&](std::size_t i, TierCounts* t) {
    return orient3d(apart[i], apart[i + 1], apart[i + 2], apart[i + 3], t);
  });
  row_alone("any_orient3d_4lpi_Z", [&](std::size_t i, TierCounts* t) {
    return orient3d(flat[i], flat[i + 1], flat[i + 2], flat[i + 3], t);
  });
  row_alone("any_orient3d_4cachedlpi_Z", [&](std::size_t i, TierCounts* t) {
    return orient3d(cached[i], cached[i + 1], cached[i + 2], cached[i + 3], t);
  });
  row_alone("any_orient3d_4tpi_Z", [&](std::size_t i, TierCounts* t) {
    return orient3d(corners[i], corners[i + 1], corners[i + 2], corners[i + 3], t);
  });
  row_alone("any_in_sphere_1explicit_4lpi_N", [&](std::size_t i, TierCounts* t) {
    return in_sphere(apart[i], apart[i + 1], apart[i + 2], apart[i + 3], far, t);
  });
  row_alone("any_in_sphere_5lpi_Z", [&](std::size_t i, TierCounts* t) {
    return in_sphere(apart[i], apart[i + 1], apart[i + 2], apart[i + 3], apart[i], t);
  });
  row_alone("any_compare_x_2lpi_N", [&](std::size_t i, TierCounts* t) {
    return compare_axis(apart[i], apart[i + 1], 0, t);
  });
  row_alone("any_compare_x_2lpi_Z", [&](std::size_t i, TierCounts* t) {
    const auto& v = apart[i].points();
    return compare_axis(apart[i], LinePlanePoint(v[1], v[0], v[3], v[2], v[4]), 0, t);
  });
}

}  // namespace

int main() {
  for (const bool through : {false, true}) {
    rows<5, LinePlanePoint>("lpi", through, [](const Vec3d* p) {
      return LinePlanePoint(p[0], p[1], p[2], p[3], p[4]);
    });
    rows<9, ThreePlanePoint>("tpi", through, [](const Vec3d* p) {
      return ThreePlanePoint({p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8]});
    });
  }
  rows_of_several();
}
