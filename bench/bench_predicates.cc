// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_predicates.cc: ns a call, one thread, least of the repetitions: ours, naive double arithmetic and the
// peers, in turn. A row names the predicate, the class of its points and the peer; tier hit rates go with each row.
// Peers named _filter may be uncertain; "wrong" counts certain signs that differ from ours. Slow peers get fewer
// tuples. Classes: U uniform; N degenerate on a grid, moved by up to 2 ulp; D, D26, D50 exactly degenerate integers of
// up to 10, 26, 50 bits; P real coordinates on a plane along the axes, or corners of such a box; R the last point
// constructed, then rounded; RW the same with exponents spread over 2^-24..1; DW two coincident points, wide exponents.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "bench/epick_peer.h"
#include "bench/predicate_peers.h"
#include "bench/stopwatch.h"
#include "predicates/in_circle.h"
#include "predicates/in_sphere.h"
#include "predicates/lattice_session.h"
#include "predicates/orient2d.h"
#include "predicates/orient3d.h"
#include "predicates/session.h"
#include "predicates/triangle_triangle.h"
#include "robust/base/random.h"

namespace {

using namespace veritope;

// There are too many tuples for a branch predictor to learn their signs. It learns those of 4,096, and a filter that
// branches on the sign then seems three times as fast as it is.
constexpr std::size_t kTuples = 32768;
constexpr int kRepetitions = 20;

// Points of one class for a predicate of `n` points in `dim` dimensions; `round` requests
// cocircular or cospherical ones.
using Tuple = std::array<Vec3d, 5>;

void set(Vec3d& p, int k, double v) { (k == 0 ? p.x : (k == 1 ? p.y : p.z)) = v; }

// Points on a circle: products of Gaussian integers, each factor or its conjugate, times a unit.
Tuple circle_tuple(Random& random, int bits) {
  constexpr int kFactors = 3;
  const std::int64_t range = std::int64_t{1} << ((bits - 2) / kFactors - 1);
  std::array<std::int64_t, kFactors> re, im;
  for (int f = 0; f < kFactors; ++f)
    re[f] = random.between(1, range), im[f] = random.between(1, range);
  const std::int64_t x0 = random.between(-(1 << 8), 1 << 8), y0 = random.between(-(1 << 8), 1 << 8);
  Tuple t;
  for (Vec3d& p : t) {
    std::int64_t x = random.below(2) == 0 ? 1 : -1, y = 0;
    if (random.below(2) == 0) std::swap(x, y);
    for (int f = 0; f < kFactors; ++f) {
      const std::int64_t i = random.below(2) == 0 ? im[f] : -im[f], old = x;
      x = x * re[f] - y * i, y = old * i + y * re[f];
    }
    p = {static_cast<double>(x + x0), static_cast<double>(y + y0), 0};
  }
  return t;
}

// Points on a sphere: q v conj(q) for quaternions q of one norm.
Tuple sphere_tuple(Random& random, int bits) {
  const std::int64_t range = std::int64_t{1} << ((bits - 4) / 3);
  std::array<std::int64_t, 4> q;
  std::array<std::int64_t, 3> v;
  for (auto& c : q) c = random.between(1, range);
  for (auto& c : v) c = random.between(-range, range);
  Tuple t;
  for (Vec3d& p : t) {
    for (int k = 3; k > 0; --k) std::swap(q[k], q[random.below(k + 1)]);
    const auto sign = [&](std::int64_t c) { return random.below(2) == 0 ? c : -c; };
    const std::int64_t w = q[0], x = sign(q[1]), y = sign(q[2]), z = sign(q[3]);
    p = {static_cast<double>((w * w + x * x - y * y - z * z) * v[0] + 2 * (x * y - w * z) * v[1] +
                             2 * (x * z + w * y) * v[2]),
         static_cast<double>(2 * (x * y + w * z) * v[0] + (w * w - x * x + y * y - z * z) * v[1] +
                             2 * (y * z - w * x) * v[2]),
         static_cast<double>(2 * (x * z - w * y) * v[0] + 2 * (y * z + w * x) * v[1] +
                             (w * w - x * x - y * y + z * z) * v[2])};
  }
  return t;
}

Tuple round_tuple(Random& random, int dim, int bits) {
  return dim == 2 ? circle_tuple(random, bits) : sphere_tuple(random, bits);
}

// Points on a line or, in space, on a plane.
Tuple flat_tuple(Random& random, int dim, int bits) {
  const std::int64_t range = std::int64_t{1} << ((bits - 3) / 2);
  std::array<std::int64_t, 3> o, u, v;
  for (int k = 0; k < 3; ++k) {
    o[k] = random.between(-range, range), u[k] = random.between(-range, range),
    v[k] = random.between(-range, range);
  }
  Tuple t;
  for (Vec3d& p : t) {
    const std::int64_t a = random.between(-range, range),
                       b = dim == 2 ? 0 : random.between(-range, range);
    for (int k = 0; k < 3; ++k) set(p, k, static_cast<double>(o[k] * range + a * u[k] + b * v[k]));
  }
  return t;
}

Tuple degenerate(Random& random, int dim, bool round, int bits) {
  return round ? round_tuple(random, dim, bits) : flat_tuple(random, dim, bits);
}

Tuple drawn(const std::string& kind, Random& random, int dim, bool round, int n) {
  Tuple t;
  const auto uniform = [&](Vec3d& p) { p = {random.unit(), random.unit(), random.unit()}; };
  if (kind == "D") return degenerate(random, dim, round, 10);
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
  if (kind == "DW") {
    for (Vec3d& p : t) {
      for (int k = 0; k < 3; ++k) set(p, k, std::ldexp(p[k], -static_cast<int>(random.below(25))));
    }
    const int first = static_cast<int>(random.below(n));
    t[first] = t[(first + 1 + static_cast<int>(random.below(n - 1))) % n];
    return t;
  }
  if (kind == "P") {  // real coordinates on a plane or in a box along the axes
    if (!round) {
      for (Vec3d& p : t) set(p, dim - 1, t[0][dim - 1]);
    } else {
      const Tuple two = t;  // different corners of a box
      std::array<int, 8> corner{0, 1, 2, 3, 4, 5, 6, 7};
      const int corners = 1 << dim;
      for (int k = corners - 1; k > 0; --k) std::swap(corner[k], corner[random.below(k + 1)]);
      for (int i = 0; i < n; ++i) {
        const int c = corner[i];
        t[i] = {two[c & 1].x, two[c >> 1 & 1].y, two[c >> 2].z};
      }
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

template <int N, typename Point>
std::vector<Point> tuples(const char* predicate, const std::string& kind) {
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
  return points;
}

struct Timed {
  double ns = 1e300;  // a call
  long sum = 0;       // the sum of the signs
  template <typename Run>
  void run(Run run_all, std::size_t tuples = kTuples) {
    const bench::Stopwatch watch;
    sum = run_all();
    ns = std::min(ns, watch.ns() / static_cast<double>(tuples));
  }
};

void print_row(const char* predicate, const std::string& kind, const char* how, const char* name,
               const Timed& ours, const Timed& peer, const TierCounts& tally) {
  std::printf(
      "{\"row\":\"%s_%s%s_vs_%s\",\"ours\":%.2f,\"peer\":%.2f,\"unit\":\"ns\",\"same_signs\":%s,"
      "\"tiers\":[%llu,%llu,%llu,%llu]}\n",
      predicate, kind.c_str(), how, name, ours.ns, peer.ns, ours.sum == peer.sum ? "true" : "false",
      static_cast<unsigned long long>(tally[Tier::kFilter]),
      static_cast<unsigned long long>(tally[Tier::kLattice]),
      static_cast<unsigned long long>(tally[Tier::kInterval]),
      static_cast<unsigned long long>(tally[Tier::kExact]));
}

const bench::PredicatePeers& peers() {
  static const bench::PredicatePeers all = [] {
    bench::PredicatePeers p;
    bench::add_epeck_predicates(p);
    bench::add_boost_predicates(p);
#if defined(VERITOPE_BENCH_TETGEN)
    bench::add_tetgen_predicates(p);
#endif
#if defined(VERITOPE_BENCH_MPFI)
    bench::add_mpfi_predicates(p);
#endif
#if defined(VERITOPE_BENCH_ARB)
    bench::add_arb_predicates(p);
#endif
    return p;
  }();
  return all;
}

bench::Predicate which(const std::string& predicate) {
  if (predicate == "orient2d") return bench::Predicate::kOrient2d;
  if (predicate == "orient3d") return bench::Predicate::kOrient3d;
  return predicate == "in_circle" ? bench::Predicate::kInCircle : bench::Predicate::kInSphere;
}

// Times ours beside the peers of peers(), and prints their rows.
template <int N, typename Point, typename Ours>
void peer_rows(const char* predicate, const std::string& kind, const std::vector<Point>& points,
               Ours ours, const TierCounts& tally) {
  constexpr int kRounds = 6;
  std::vector<signed char> signs(kTuples), theirs(kTuples);
  Timed plain;
  const auto decide = [&] {
    for (std::size_t i = 0; i < kTuples; ++i)
      signs[i] = static_cast<signed char>(to_int(ours(&points[N * i], nullptr)));
    return 0L;
  };
  std::vector<Timed> timed(peers().size());
  std::vector<std::array<std::size_t, 2>> faults(peers().size());  // wrong, uncertain
  plain.run(decide);
  for (std::size_t k = 0; k < peers().size(); ++k) {
    bench::PredicatePeer& peer = *peers()[k];
    const std::size_t n = std::min(kTuples, peer.most_tuples);
    peer.load(points.data(), N * n);
    const bool is_slow = n < kTuples;
    for (int r = 0; r < (is_slow ? kRounds / 2 : kRounds); ++r) {
      plain.run(decide);
      timed[k].run([&] { return peer.decide(which(predicate), n, theirs.data()), 0L; }, n);
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (theirs[i] == 2) {
        ++faults[k][1];
      } else {
        faults[k][0] += theirs[i] != signs[i];
      }
    }
  }
  for (std::size_t k = 0; k < peers().size(); ++k) {
    const std::size_t n = std::min(kTuples, peers()[k]->most_tuples);
    std::printf(
        "{\"row\":\"%s_%s_vs_%s\",\"ours\":%.2f,\"peer\":%.2f,\"unit\":\"ns\",\"tuples\":%zu,"
        "\"wrong\":%zu,\"uncertain\":%zu,\"tiers\":[%llu,%llu,%llu,%llu]}\n",
        predicate, kind.c_str(), peers()[k]->name.c_str(), plain.ns, timed[k].ns, n, faults[k][0],
        faults[k][1], static_cast<unsigned long long>(tally[Tier::kFilter]),
        static_cast<unsigned long long>(tally[Tier::kLattice]),
        static_cast<unsigned long long>(tally[Tier::kInterval]),
        static_cast<unsigned long long>(tally[Tier::kExact]));
  }
}

// ours(p, tally) and session(p, tally) decide one tuple, naive(p) computes its determinant; peer sums over all tuples.
template <int N, typename Point, typename Session, typename Ours, typename InSession,
          typename Naive, typename Peer>
void rows(const char* predicate, const std::string& kind, Ours ours, InSession in_session,
          Naive naive, Peer peer) {
  const std::vector<Point> points = tuples<N, Point>(predicate, kind);
  const Session session = Session::around(points.data(), points.size());
  const auto sum = [&](auto sign) {
    long total = 0;
    for (std::size_t i = 0; i < kTuples; ++i) total += sign(&points[N * i]);
    return total;
  };
  Timed plain, inside, rough, epick;
  for (int r = 0; r < kRepetitions; ++r) {
    plain.run([&] { return sum([&](const Point* p) { return to_int(ours(p, nullptr)); }); });
    inside.run([&] {
      return sum([&](const Point* p) { return to_int(in_session(session, p, nullptr)); });
    });
    rough.run([&] {
      return sum([&](const Point* p) {
        const double d = naive(p);
        return (d > 0) - (d < 0);
      });
    });
    epick.run([&] { return peer(points.data(), kTuples); });
  }
  TierCounts tally, session_tally;
  sum([&](const Point* p) {
    return to_int(ours(p, &tally)) + to_int(in_session(session, p, &session_tally));
  });
  print_row(predicate, kind, "", "epick", plain, epick, tally);
  print_row(predicate, kind, "_session", "epick", inside, epick, session_tally);
  peer_rows<N>(predicate, kind, points, ours, tally);
  if (kind != "U") return;
  print_row(predicate, kind, "", "naive", plain, rough, tally);
  print_row(predicate, kind, "_session", "naive", inside, rough, session_tally);
}

// in_lattice(session, i, tally) decides the tuple from vertex i of the model of all tuples. REQUIRES
// that it fits.
template <int N, typename Point, typename Lattice, typename InLattice, typename Peer>
void lattice_row(const char* predicate, const std::string& kind, InLattice in_lattice, Peer peer) {
  const std::vector<Point> points = tuples<N, Point>(predicate, kind);
  const Lattice lattice = Lattice::of(points.data(), points.size()).value();
  const auto sum = [&](TierCounts* tally) {
    long total = 0;
    for (std::size_t i = 0; i < points.size(); i += N)
      total += to_int(in_lattice(lattice, i, tally));
    return total;
  };
  Timed inside, epick;
  for (int r = 0; r < kRepetitions; ++r) {
    inside.run([&] { return sum(nullptr); });
    epick.run([&] { return peer(points.data(), kTuples); });
  }
  TierCounts tally;
  sum(&tally);
  print_row(predicate, kind, "_lattice", "epick", inside, epick, tally);
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
    const bench::Stopwatch watch;
    for (std::size_t i = 0; i < t.size(); i += 2)
      sum += static_cast<long>(triangle_triangle(t[i], t[i + 1]));
    best = std::min(best, watch.ns());
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

void orientation_rows(const char* kind) {
  rows<3, Vec2d, Session2d>(
      "orient2d", kind, [](const Vec2d* p, TierCounts* t) { return orient2d(p[0], p[1], p[2], t); },
      [](const Session2d& s, const Vec2d* p, TierCounts* t) {
        return s.orient2d(p[0], p[1], p[2], t);
      },
      [](const Vec2d* p) {
        return formulas::Orient2d<double>(p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y).det();
      },
      bench::epick_orient2d);
  rows<4, Vec3d, Session3d>(
      "orient3d", kind,
      [](const Vec3d* p, TierCounts* t) { return orient3d(p[0], p[1], p[2], p[3], t); },
      [](const Session3d& s, const Vec3d* p, TierCounts* t) {
        return s.orient3d(p[0], p[1], p[2], p[3], t);
      },
      [](const Vec3d* p) {
        return formulas::Plane3<double>(p[0].x, p[0].y, p[0].z, p[1].x, p[1].y, p[1].z, p[2].x,
                                        p[2].y, p[2].z)
            .det(p[3].x - p[0].x, p[3].y - p[0].y, p[3].z - p[0].z);
      },
      bench::epick_orient3d);
}

void sphere_rows(const char* kind) {
  rows<4, Vec2d, Session2d>(
      "in_circle", kind,
      [](const Vec2d* p, TierCounts* t) { return in_circle(p[0], p[1], p[2], p[3], t); },
      [](const Session2d& s, const Vec2d* p, TierCounts* t) {
        return s.in_circle(p[0], p[1], p[2], p[3], t);
      },
      [](const Vec2d* p) {
        return formulas::InCircle<double>(p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y, p[3].x,
                                          p[3].y)
            .det();
      },
      bench::epick_in_circle);
  rows<5, Vec3d, Session3d>(
      "in_sphere", kind,
      [](const Vec3d* p, TierCounts* t) { return in_sphere(p[0], p[1], p[2], p[3], p[4], t); },
      [](const Session3d& s, const Vec3d* p, TierCounts* t) {
        return s.in_sphere(p[0], p[1], p[2], p[3], p[4], t);
      },
      [](const Vec3d* p) {
        return formulas::InSphere<double>(p[0].x, p[0].y, p[0].z, p[1].x, p[1].y, p[1].z, p[2].x,
                                          p[2].y, p[2].z, p[3].x, p[3].y, p[3].z, p[4].x, p[4].y,
                                          p[4].z)
            .det();
      },
      bench::epick_in_sphere);
}

void lattice_rows(const char* kind) {
  using In2d = LatticeSession2d;
  using In3d = LatticeSession3d;
  const auto o2 = [](const In2d& s, auto i, auto* t) { return s.orient2d(i, i + 1, i + 2, t); };
  const auto ic = [](const In2d& s, auto i, auto* t) {
    return s.in_circle(i, i + 1, i + 2, i + 3, t);
  };
  const auto o3 = [](const In3d& s, auto i, auto* t) {
    return s.orient3d(i, i + 1, i + 2, i + 3, t);
  };
  const auto is = [](const In3d& s, auto i, auto* t) {
    return s.in_sphere(i, i + 1, i + 2, i + 3, i + 4, t);
  };
  lattice_row<3, Vec2d, In2d>("orient2d", kind, o2, bench::epick_orient2d);
  lattice_row<4, Vec3d, In3d>("orient3d", kind, o3, bench::epick_orient3d);
  lattice_row<4, Vec2d, In2d>("in_circle", kind, ic, bench::epick_in_circle);
  lattice_row<5, Vec3d, In3d>("in_sphere", kind, is, bench::epick_in_sphere);
}

void triangle_rows() {
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

}  // namespace

int main() {
  for (const char* kind : {"U", "N", "D", "D26", "D50", "P", "R", "RW", "DW"}) {
    orientation_rows(kind);
    sphere_rows(kind);
  }
  for (const char* kind : {"U", "D", "D26", "D50"}) lattice_rows(kind);
  triangle_rows();
}
