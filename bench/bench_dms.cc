// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_dms.cc: ns a point of simplex-spline solids of degrees 1 to 4 with four components, over Kuhn's 1,296
// tetrahedra of a cube with clouds of a tenth of the edge, in batches of 65,536 uniform points, one thread: values,
// values with proved bounds, with derivatives; beside eq. 1 in plain binary64, memoised and as a program
// (bench/dms_recurrence.h), at points of 32 of the tetrahedra, and beside one point of a tricubic FastSpline with four
// components. A figure is the least of several passes. agrees: the greatest difference of ours and the peer's numbers.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/dms_recurrence.h"
#include "bench/print_row.h"
#include "bench/stopwatch.h"
#include "robust/base/random.h"
#include "solids/dms/dms_make.h"
#include "solids/dms/fast/fast_dms.h"
#include "splines/fast_spline.h"
#include "tests/support/random_dms.h"

namespace {

using namespace veritope;
using namespace veritope::bench;

constexpr std::size_t kBatch = 65536, kComponents = 4, kPeerCells = 32, kPeerPoints = 64;

template <typename Run>
double least_ns(int passes, std::size_t points, Run run) {
  double ns = 1e300;
  for (int i = 0; i < passes; ++i) {
    const Stopwatch watch;
    run();
    ns = std::min(ns, watch.ns() / static_cast<double>(points));
  }
  return ns;
}

// The identity, but for control points moved at random by up to 1/32.
DmsModel made_model(int degree, int side, int radius_divisor) {
  DmsModel domain = kuhn_domain({side, side, side});
  domain.attributes = {"a"};
  std::vector<Rational> heights;
  for (const DmsCloud& cloud : domain.clouds) heights.push_back(cloud[0][2]);
  set_control_by_rule(domain, DmsControlRule::kGreville, heights);
  DmsModel model =
      make_dms(domain, {degree, DmsCloudDraw{Rational(1) / Rational(radius_divisor), 7},
                        DmsControlRule::kGreville})
          .value();
  Random random(3);
  for (Rational& c : model.control.values) c += Rational(random.between(-8, 8)) / Rational(256);
  return model;
}

double tricubic_ns(Random& random) {
  std::vector<double> knots = {0, 0, 0, 0, .2, .4, .6, .8, 1, 1, 1, 1}, coefficients;
  const KnotAxis<double> axis{3, knots, false};
  for (std::size_t i = 0; i < kComponents * 512; ++i) coefficients.push_back(random.unit());
  const auto fast = FastSpline<3>::prepare(
                        BSplineVolume<double>({axis, axis, axis}, kComponents, false, coefficients))
                        .value();
  std::array<std::vector<double>, 3> at;
  for (auto& a : at)
    for (std::size_t i = 0; i < kBatch; ++i) a.push_back(random.unit());
  std::vector<double> value(kComponents * kBatch);
  return least_ns(20, kBatch, [&] {
    fast.evaluate({at[0].data(), at[1].data(), at[2].data()}, kBatch,
                  {value.data(), nullptr, nullptr, nullptr});
  });
}

struct PeerFigures {
  double ns = 0, program_ns = 0, near = 0, not_zero = 0, agrees = 0;
};

PeerFigures race_peer(const DmsModel& model, FastDms& fast, Random& random, int passes) {
  const DmsKnotTable knots(model);
  std::vector<DmsRecurrence> peers;
  std::vector<Vec3d> points;
  PeerFigures out;
  for (std::size_t k = 0; k < kPeerCells; ++k) {
    const auto t = static_cast<std::uint32_t>(random.below(model.tetrahedra.size()));
    peers.emplace_back(model, knots, t);
    out.near += static_cast<double>(peers.back().num_splines()) / kPeerCells;
    const auto corners = knots.corners(t);
    for (std::size_t i = 0; i < kPeerPoints; ++i) {
      double w[4], sum = 0;
      for (double& x : w) sum += x = -std::log(1 - random.unit());
      Point3d p{};
      for (std::size_t m = 0; m < 4; ++m)
        for (std::size_t c = 0; c < 3; ++c) p[c] += w[m] / sum * nearest_double(corners[m][c]);
      points.push_back({p[0], p[1], p[2]});
    }
  }
  std::vector<double> peer(kComponents * points.size()), ours(peer.size());
  out.ns = least_ns(passes, points.size(), [&] {
    for (std::size_t i = 0; i < points.size(); ++i)
      peers[i / kPeerPoints].evaluate(to_point(points[i]), peer.data() + kComponents * i);
  });
  out.program_ns = least_ns(passes, points.size(), [&] {
    for (std::size_t i = 0; i < points.size(); ++i)
      peers[i / kPeerPoints].evaluate_program(to_point(points[i]), peer.data() + kComponents * i);
  });
  for (std::size_t i = 0; i < points.size(); ++i) {
    peers[i / kPeerPoints].evaluate_program(to_point(points[i]), peer.data() + kComponents * i);
    out.not_zero += static_cast<double>(peers[i / kPeerPoints].num_not_zero()) /
                    static_cast<double>(points.size());
  }
  fast.evaluate(points, {ours.data()});
  for (std::size_t i = 0; i < peer.size(); ++i)
    out.agrees = std::max(out.agrees, std::abs(peer[i] - ours[i]));
  return out;
}

void degree_rows(int degree, int side, int divisor, double tricubic, Random& random) {
  const DmsModel model = made_model(degree, side, divisor);
  FastDmsOptions options;
  options.with_gradient = true;
  FastDms fast(model, options);
  std::vector<Vec3d> points;
  const double length = side;
  for (std::size_t i = 0; i < kBatch; ++i)
    points.push_back({length * random.unit(), length * random.unit(), length * random.unit()});
  std::vector<double> value(kComponents * kBatch), bound(value.size()), gradient(3 * value.size()),
      gradient_bound(gradient.size());
  const Stopwatch watch;
  fast.evaluate(points, {value.data()});
  const double tables = watch.ns() * 1e-9;
  const int passes = degree <= 2 ? 24 : 8;
  const double plain = least_ns(passes, kBatch, [&] { fast.evaluate(points, {value.data()}); });
  constexpr int kBoundedPasses = 6;
  const FastDmsCounts before = fast.counts();
  const double bounded = least_ns(kBoundedPasses, kBatch, [&] {
    fast.evaluate(points, {value.data(), bound.data()});
  });
  const auto share = [](std::uint64_t count) {
    return static_cast<double>(count) / (kBoundedPasses * kBatch);
  };
  const double pairs = share(fast.counts().pairs - before.pairs);
  const double exact = share(fast.counts().exact() - before.exact());
  const double slopes = least_ns(4, kBatch, [&] {
    fast.evaluate(points, {value.data(), bound.data(), gradient.data(), gradient_bound.data()});
  });
  const double near = [&] {
    double sum = 0;
    for (std::uint32_t t = 0; t < 64; ++t)
      sum += static_cast<double>(
                 fast.num_near(static_cast<std::uint32_t>(random.below(model.tetrahedra.size())))) /
             64;
    return sum;
  }();
  double widest = 0;
  for (const double b : bound) widest = std::max(widest, b);
  const std::string name = "eval" + std::to_string(degree);
  const auto number = [](const char* key, double x) {
    char text[80];
    std::snprintf(text, sizeof text, "\"%s\":%.3g", key, x);
    return std::string(text);
  };
  print_row(name, plain, -1, number("first_pass_seconds", tables) + "," + number("near", near));
  print_row(name + "_bounds", bounded, plain,
            number("greatest_bound", widest) + "," + number("pairs_share", pairs) + "," +
                number("exact_share", exact) + (degree <= 3 ? ",\"goal\":\"<= 2 times\"" : ""));
  print_row(name + "_derivatives_bounds", slopes, plain, "");
  print_row(name + "_vs_tricubic", plain, tricubic,
            degree == 2   ? "\"goal\":\"<= 12 times\""
            : degree == 3 ? "\"goal\":\"<= 60 times\""
                          : "");
  if (degree < 2) return;
  const PeerFigures peer = race_peer(model, fast, random, degree == 2 ? 40 : 5);
  print_row(name + "_vs_recurrence", plain, peer.ns,
            number("agrees", peer.agrees) + "," + number("near", peer.near) + "," +
                number("not_zero", peer.not_zero) +
                (degree == 2   ? ",\"goal\":\"<= 1/6\""
                 : degree == 3 ? ",\"goal\":\"<= 1/12\""
                               : ""));
  print_row(name + "_bounds_vs_recurrence", bounded, peer.ns,
            degree == 2   ? "\"goal\":\"<= 1/3\""
            : degree == 3 ? "\"goal\":\"<= 1/6\""
                          : "");
  print_row(name + "_vs_program", plain, peer.program_ns, "");
}

}  // namespace

int main(int argc, char** argv) {
  int side = 6, divisor = 10, first = 1, last = 4;
  read_arguments(
      argc, argv,
      {{"--side", &side}, {"--divisor", &divisor}, {"--first", &first}, {"--last", &last}});
  Random random(42);
  const double tricubic = tricubic_ns(random);
  for (int degree = first; degree <= last; ++degree)
    degree_rows(degree, side, divisor, tricubic, random);
}
