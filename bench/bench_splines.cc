// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_splines.cc: ns a point of a bicubic surface (10 x 10 control points in space) and a tricubic volume (8 x
// 8 x 8) at random parameters, one thread, all candidates in turn. A pass is 4,096 points, each with other parameters;
// a figure is the least of the passes. Rows without a peer have a goal in million points a second. agrees: the greatest
// difference of the two candidates' coordinates, for peers with a value. Enclosures: of the same surface over boxes of
// a quarter of a span, one row a quantity.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "bench/spline_peers.h"
#include "bench/stopwatch.h"
#include "interval/enclosure/surface_enclosure.h"
#include "robust/base/random.h"
#include "splines/fast_spline.h"

namespace {

using namespace veritope;
using namespace veritope::bench;

constexpr std::size_t kPoints = 4096, kSets = 16;
constexpr int kRounds = 80;

std::vector<double> clamped_knots(std::size_t num, int degree) {
  const auto p = static_cast<std::size_t>(degree);
  std::vector<double> knots;
  for (std::size_t i = 0; i < num + p + 1; ++i) {
    const double at = i <= p     ? 0
                      : i >= num ? 1
                                 : static_cast<double>(i - p) / static_cast<double>(num - p);
    knots.push_back(at);
  }
  return knots;
}

struct Candidate {
  std::string name;
  std::function<void(std::size_t set)> run;
  std::vector<double>* out;
  double ns = 1e300;
};

// Runs the candidates in turn; those that take over a microsecond a point miss most rounds.
void race(std::vector<Candidate>& candidates) {
  for (int round = 0; round < kRounds; ++round)
    for (Candidate& c : candidates) {
      if (c.ns < 1e300 && c.ns > 1000 && round % 20 != 0) continue;
      const Stopwatch watch;
      c.run(static_cast<std::size_t>(round) % kSets);
      c.ns = std::min(c.ns, watch.ns() / static_cast<double>(kPoints));
    }
}

void print_alone(const std::string& row, double ns, const char* goal) {
  std::printf(
      "{\"row\":\"%s\",\"ours\":%.2f,\"peer\":null,\"unit\":\"ns\",\"million_points_per_second\":%."
      "1f,\"goal\":\"%s\"}\n",
      row.c_str(), ns, 1e3 / ns, goal);
}
void print_pair(const std::string& row, const Candidate& ours, const Candidate& peer,
                const char* goal) {
  double most = 0;
  ours.run(0), peer.run(0);
  for (std::size_t i = 0; i < ours.out->size(); ++i)
    most = std::max(most, std::abs((*ours.out)[i] - (*peer.out)[i]));
  std::printf(
      "{\"row\":\"%s\",\"ours\":%.2f,\"peer\":%.2f,\"unit\":\"ns\",\"times_faster\":%.2f,"
      "\"agrees\":%.1e,\"goal\":\"%s\"}\n",
      row.c_str(), ours.ns, peer.ns, peer.ns / ours.ns, most, goal);
}

template <std::size_t N>
struct Sets {
  std::vector<std::array<std::vector<double>, N>> at;
  explicit Sets(Random& random) {
    at.resize(kSets);
    for (auto& set : at)
      for (auto& axis : set)
        for (std::size_t i = 0; i < kPoints; ++i) axis.push_back(random.unit());
  }
  std::array<const double*, N> operator[](std::size_t set) const {
    std::array<const double*, N> out;
    for (std::size_t a = 0; a < N; ++a) out[a] = at[set][a].data();
    return out;
  }
};

struct Buffers {
  std::vector<double> value, value_bound, partial, partial_bound;
  explicit Buffers(std::size_t axes)
      : value(3 * kPoints),
        value_bound(3 * kPoints),
        partial(3 * axes * kPoints),
        partial_bound(3 * axes * kPoints) {}
};

template <std::size_t N>
void add_ours(const FastSpline<N>& fast, const Sets<N>& sets, Buffers& b,
              std::vector<Candidate>& out) {
  const FastSplineOutput value{b.value.data(), nullptr, nullptr, nullptr};
  const FastSplineOutput bounds{b.value.data(), b.value_bound.data(), nullptr, nullptr};
  const FastSplineOutput jet{b.value.data(), nullptr, b.partial.data(), nullptr};
  const FastSplineOutput jet_bounds{b.value.data(), b.value_bound.data(), b.partial.data(),
                                    b.partial_bound.data()};
  const auto add = [&](const char* name, const FastSplineOutput& to) {
    out.push_back({name,
                   [&fast, &sets, to](std::size_t set) { fast.evaluate(sets[set], kPoints, to); },
                   &b.value});
  };
  add("value", value), add("bounds", bounds), add("derivatives", jet),
      add("derivatives_bounds", jet_bounds);
  out.push_back({"baseline",
                 [&fast, &sets, value](std::size_t set) {
                   fast.evaluate_on(FastBackEnd::kBaseline, sets[set], kPoints, value);
                 },
                 &b.value});
}

// The peers stand behind ours: from `first` their values, from `first_derivative` their derivatives.
void print_surface_figures(const std::vector<Candidate>& all, std::size_t first,
                           std::size_t first_derivative, std::size_t num_occt) {
  print_alone("bicubic_value", all[0].ns, ">= 20 million points/s"),
      print_alone("bicubic_bounds", all[1].ns, ">= 10 million points/s");
  print_alone("bicubic_derivatives", all[2].ns, ""),
      print_alone("bicubic_derivatives_bounds", all[3].ns, "");
  print_alone("bicubic_value_baseline", all[4].ns, "");
  print_alone("bicubic_rational_value", all[5].ns, ""),
      print_alone("bicubic_rational_bounds", all[6].ns, "");
  print_alone("bicubic_rational_derivatives_bounds", all[8].ns, "");
  const auto faster = [&](std::size_t from) {
    return all[from].ns < all[from + 1].ns ? all[from] : all[from + 1];
  };
  if (num_occt == 2) {
    for (std::size_t k = 0; k < 2; ++k)
      print_pair("bicubic_value_vs_" + all[first + k].name, all[0], all[first + k], "");
    print_pair("bicubic_value_vs_occt", all[0], faster(first), ">= 3 times");
    print_pair("bicubic_bounds_vs_occt", all[1], faster(first), "");
    print_pair("bicubic_derivatives_vs_occt", all[2], faster(first_derivative), "");
  }
  print_pair("bicubic_bounds_vs_boost_interval", all[1], all[first + num_occt], ">= 50 times");
  print_pair("bicubic_bounds_vs_boost_interval_unprotected", all[1], all[first + num_occt + 1], "");
}

void surface_rows(Random& random) {
  SurfaceData data;
  data.num_u = data.num_v = 10;
  data.knots_u = data.knots_v = clamped_knots(10, 3);
  std::vector<double> coefficients(300), weighted(400);
  for (std::size_t i = 0; i < 100; ++i) {
    data.points.push_back(
        {static_cast<double>(i / 10), static_cast<double>(i % 10), 2 * random.unit() - 1});
    weighted[300 + i] = 0.5 + random.unit();
    for (std::size_t c = 0; c < 3; ++c)
      coefficients[100 * c + i] = data.points[i][c],
                             weighted[100 * c + i] = data.points[i][c] * weighted[300 + i];
  }
  const KnotAxis<double> axis{3, data.knots_u, false};
  const auto fast =
      FastSpline<2>::prepare(BSplineSurface<double>({axis, axis}, 3, false, coefficients)).value();
  const auto nurbs =
      FastSpline<2>::prepare(BSplineSurface<double>({axis, axis}, 4, true, weighted)).value();
  const Sets<2> sets(random);
  Buffers ours(2), rational(2);
  std::vector<Candidate> all;
  add_ours(fast, sets, ours, all);
  add_ours(nurbs, sets, rational, all);
  SurfacePeers peers;
#if defined(VERITOPE_BENCH_OCCT)
  add_occt_surfaces(data, peers);
#endif
  const std::size_t num_occt = peers.size();
  add_boost_surfaces(data, peers);
  std::vector<double> out(3 * kPoints), du(3 * kPoints), dv(3 * kPoints);
  const std::size_t first = all.size();
  for (std::size_t k = 0; k < peers.size(); ++k)
    all.push_back({peers[k]->name,
                   [&, k](std::size_t set) {
                     peers[k]->run(sets[set][0], sets[set][1], kPoints, out.data(), nullptr,
                                   nullptr);
                   },
                   &out});
  const std::size_t first_derivative = all.size();
  for (std::size_t k = 0; k < num_occt; ++k)
    all.push_back({peers[k]->name,
                   [&, k](std::size_t set) {
                     peers[k]->run(sets[set][0], sets[set][1], kPoints, out.data(), du.data(),
                                   dv.data());
                   },
                   &out});
  race(all);
  print_surface_figures(all, first, first_derivative, num_occt);
}

void volume_rows(Random& random) {
  const KnotAxis<double> axis{3, clamped_knots(8, 3), false};
  std::vector<double> coefficients;
  for (int i = 0; i < 3 * 512; ++i) coefficients.push_back(2 * random.unit() - 1);
  const auto fast =
      FastSpline<3>::prepare(BSplineVolume<double>({axis, axis, axis}, 3, false, coefficients))
          .value();
  const Sets<3> sets(random);
  Buffers ours(3);
  std::vector<Candidate> all;
  add_ours(fast, sets, ours, all);
  race(all);
  print_alone("tricubic_value", all[0].ns, ">= 20 million points/s"),
      print_alone("tricubic_bounds", all[1].ns, ">= 10 million points/s");
  print_alone("tricubic_derivatives", all[2].ns, ""),
      print_alone("tricubic_derivatives_bounds", all[3].ns, "");
  print_alone("tricubic_value_baseline", all[4].ns, "");
}

// Nanoseconds a box, for 256 boxes inside cells, the least of eight rounds.
void enclosure_rows(Random& random) {
  std::vector<Rational> coefficients;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 100; ++i)
      coefficients.push_back(c == 0   ? Rational(i / 10)
                             : c == 1 ? Rational(i % 10)
                                      : Rational::from_double(2 * random.unit() - 1));
  std::vector<Rational> knots;
  for (const double k : clamped_knots(10, 3)) knots.push_back(Rational::from_double(k));
  const auto axis = make_knot_axis(3, knots).value();
  const auto surface =
      SplineEnclosure<2>::prepare(BSplineSurface<Rational>({axis, axis}, 3, false, coefficients), 3)
          .value();
  std::vector<Box2> boxes;
  for (int i = 0; i < 256; ++i) {
    const auto side = [&] {
      const double at = (static_cast<double>(random.below(7)) + 0.05 + 0.6 * random.unit()) / 7;
      return Interval::from_bounds(at, at + 0.25 / 7);
    };
    boxes.emplace_back(side(), side());
  }
  const auto row = [&](const char* name, const auto& run) {
    double ns = 1e300;
    for (int round = 0; round < 8; ++round) {
      const Stopwatch watch;
      for (const Box2& box : boxes) VT_CHECK(run(box), "a box in the domain");
      ns = std::min(ns, watch.ns() / static_cast<double>(boxes.size()));
    }
    std::printf("{\"row\":\"enclosure_%s\",\"ours\":%.0f,\"peer\":null,\"unit\":\"ns\"}\n", name,
                ns);
  };
  using enum EnclosureForm;
  row("value_hull", [&](const Box2& b) { return surface.value(b, kHull).has_value(); });
  row("value_mean_value", [&](const Box2& b) { return surface.value(b, kMeanValue).has_value(); });
  row("first_derivative_hull", [&](const Box2& b) {
    return surface.derivative({1, 0}, b, kHull).has_value();
  });
  row("normal_both", [&](const Box2& b) { return enclose_normal(surface, b).has_value(); });
  row("normal_cone", [&](const Box2& b) { return enclose_normal_cone(surface, b).has_value(); });
  row("curvatures_hull",
      [&](const Box2& b) { return enclose_curvatures(surface, b, kHull).has_value(); });
  row("curvatures_both", [&](const Box2& b) { return enclose_curvatures(surface, b).has_value(); });
}

}  // namespace

int main() {
  Random random(42);
  surface_rows(random);
  volume_rows(random);
  enclosure_rows(random);
}
