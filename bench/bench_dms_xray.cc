// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_dms_xray.cc: an x-ray of 256 x 256 rays through 2,058 quadratic tetrahedra of a cube, clouds of a tenth of
// the edge, one thread. The attribute is high inside of a sphere and low outside, with a steep layer between.
//   xray_vs_sampling  ns a ray, plans and weights included, beside sums of FastDms values at a constant step: midpoints
//                     of the part of the ray in the cube, in steps of sqrt(1/2) until no ray of 1,024 is wrong by more
//                     than 1e-6. Values are taken without bounds.
//   xray_sums         ns a ray beyond the plans
//   xray_change       ns of a changed coefficient, the least of 16; same_bytes: whether all sums are those of a new
//                     picture
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/stopwatch.h"
#include "robust/base/random.h"
#include "solids/dms/dms_make.h"
#include "solids/dms/dms_xray.h"
#include "solids/dms/fast/fast_dms.h"
#include "tests/support/random_dms.h"

namespace {

using namespace veritope;
using namespace veritope::bench;

constexpr std::size_t kAttribute = 3, kComponents = 4;
constexpr double kWanted = 1e-6;

void print_row(const std::string& row, double ours, double peer, const std::string& more) {
  std::printf("{\"row\":\"%s\",\"ours\":%.0f,\"peer\":", row.c_str(), ours);
  if (peer > 0) {
    std::printf("%.0f,\"ratio\":%.4f", peer, ours / peer);
  } else {
    std::printf("null");
  }
  std::printf(",\"unit\":\"ns\",%s}\n", more.c_str());
  std::fflush(stdout);
}

DmsModel made_model(int degree, int side) {
  DmsModel domain = kuhn_domain({side, side, side});
  domain.attributes = {"a"};
  set_control_by_rule(domain, DmsControlRule::kGreville,
                      std::vector<Rational>(domain.clouds.size()));
  DmsModel model = make_dms(domain, {degree, DmsCloudDraw{Rational(1) / Rational(10), 7},
                                     DmsControlRule::kGreville})
                       .value();
  auto& values = model.control.values;
  for (std::size_t i = 0; i < values.size(); i += kComponents) {
    double square = 0;
    for (std::size_t c = 0; c < 3; ++c)
      square += std::pow(nearest_double(values[i + c]) / side - .5, 2);
    const double height = .5 + .5 * std::tanh(25 * (.3 - std::sqrt(square)));
    values[i + kAttribute] =
        Rational(static_cast<int>(std::lround(0x1p20 * height))) / Rational(1 << 20);
  }
  return model;
}

// Rays that start and end beyond the cube, across a square that its shadow fills.
DmsRayGrid grid_of(int side, std::size_t pixels) {
  const double length = side, step = 2 * length / static_cast<double>(pixels);
  DmsRayGrid grid;
  grid.columns = grid.rows = pixels;
  grid.along = {3 * length, 2.139 * length, 1.371 * length};
  grid.right = {-.713 * step * .8, step * .8, 0};
  grid.down = {0, -.457 * step * .8, .713 * step * .8};
  for (std::size_t c = 0; c < 3; ++c) {
    const double middle =
        grid.along[c] / 2 + static_cast<double>(pixels) / 2 * (grid.right[c] + grid.down[c]);
    grid.origin[c] = length / 2 - middle;
  }
  return grid;
}

struct Chord {
  Point3d from{}, way{};      // the whole ray
  double begin = 0, end = 1;  // of the part in the cube
};

Chord chord_of(const DmsRayGrid& grid, std::size_t ray, int side) {
  Chord out;
  const auto i = static_cast<double>(ray % grid.columns),
             j = static_cast<double>(ray / grid.columns);
  for (std::size_t c = 0; c < 3; ++c) {
    out.from[c] = grid.origin[c] + i * grid.right[c] + j * grid.down[c];
    out.way[c] = grid.along[c];
    const double a = -out.from[c] / out.way[c], b = (side - out.from[c]) / out.way[c];
    out.begin = std::max(out.begin, std::min(a, b));
    out.end = std::min(out.end, std::max(a, b));
  }
  return out;
}

// Sums of values at midpoints, as parts of the whole ray.
class Sampler {
 public:
  explicit Sampler(FastDms& fast) : fast_(fast) {}

  double mean(const Chord& chord, double step) {
    if (chord.end <= chord.begin) return 0;
    const double length = chord.end - chord.begin;
    const auto count = static_cast<std::size_t>(std::ceil(length / step));
    points_.resize(count), values_.resize(kComponents * count);
    for (std::size_t k = 0; k < count; ++k) {
      const double t =
          chord.begin + length * (static_cast<double>(k) + .5) / static_cast<double>(count);
      points_[k] = {chord.from[0] + t * chord.way[0], chord.from[1] + t * chord.way[1],
                    chord.from[2] + t * chord.way[2]};
    }
    fast_.evaluate(points_, {values_.data()});
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) sum += values_[kComponents * k + kAttribute];
    samples_ += count;
    return sum * length / static_cast<double>(count);
  }
  std::size_t samples() const { return samples_; }
  void reset() { samples_ = 0; }

 private:
  FastDms& fast_;
  std::vector<Vec3d> points_;
  std::vector<double> values_;
  std::size_t samples_ = 0;
};

struct PeerFigures {
  double ns = 0, step = 0, worst = 0, samples = 0;  // a ray
};

PeerFigures race_peer(const DmsModel& model, const DmsRayGrid& grid,
                      const std::vector<DmsRaySum>& sums, int side) {
  constexpr std::size_t kRays = 1024;
  Random random(5);
  std::vector<std::size_t> rays;
  for (std::size_t i = 0; i < kRays; ++i) rays.push_back(random.below(sums.size()));
  FastDms fast(model);
  Sampler sampler(fast);
  PeerFigures out;
  for (out.step = 1. / 64;; out.step *= std::sqrt(.5)) {
    out.worst = 0;
    sampler.reset();
    const Stopwatch watch;
    for (const std::size_t ray : rays)
      out.worst = std::max(
          out.worst, std::abs(sampler.mean(chord_of(grid, ray, side), out.step) - sums[ray].mean));
    out.ns = watch.ns() / kRays;
    out.samples = static_cast<double>(sampler.samples()) / kRays;
    if (out.worst <= kWanted || out.step < 1e-6) return out;
  }
}

bool same(const DmsXray& changed, const std::vector<DmsRaySum>& sums) {
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (changed.mean(i) != sums[i].mean) return false;
  return true;
}

void change_row(DmsModel& model, const DmsRayWeights& rays) {
  DmsXray xray(rays, DmsCoefficients(model, kAttribute), 1);
  Random random(9);
  double least = 1e300, most = 0;
  for (int k = 0; k < 16; ++k) {
    const std::size_t control = random.below(model.control.values.size() / kComponents);
    const Rational value = Rational(static_cast<int>(random.below(256))) / Rational(256);
    const Stopwatch watch;
    xray.change(control, value);
    least = std::min(least, watch.ns()), most = std::max(most, watch.ns());
    model.control.values[kComponents * control + kAttribute] = value;
  }
  const bool is_same = same(xray, ray_sums(rays, DmsCoefficients(model, kAttribute), 1));
  print_row(
      "xray_change", least, -1,
      "\"greatest\":" + std::to_string(most) + ",\"same_bytes\":" + (is_same ? "true" : "false"));
}

}  // namespace

int main(int argc, char** argv) {
  int side = 7, pixels = 256, degree = 2;
  read_arguments(argc, argv, {{"--side", &side}, {"--pixels", &pixels}, {"--degree", &degree}});
  DmsModel model = made_model(degree, side);
  const DmsRayGrid grid = grid_of(side, static_cast<std::size_t>(pixels));
  const Stopwatch watch;
  const DmsRayWeights rays(model, grid);
  const double plans = watch.ns();
  const std::vector<DmsRaySum> sums = ray_sums(rays, DmsCoefficients(model, kAttribute), 1);
  const double all = watch.ns(), count = static_cast<double>(sums.size());
  double bound = 0;
  std::size_t num_hits = 0;
  for (const DmsRaySum& s : sums) bound = std::max(bound, s.bound), num_hits += s.share > 0;
  const PeerFigures peer = race_peer(model, grid, sums, side);
  print_row("xray_vs_sampling", all / count, peer.ns,
            "\"seconds\":" + std::to_string(all / 1e9) +
                ",\"tetrahedra\":" + std::to_string(model.tetrahedra.size()) +
                ",\"rays_that_hit\":" + std::to_string(num_hits) +
                ",\"greatest_bound\":" + std::to_string(1e6 * bound) +
                "e-6,\"peer_worst\":" + std::to_string(1e6 * peer.worst) +
                "e-6,\"peer_samples\":" + std::to_string(peer.samples));
  print_row("xray_sums", (all - plans) / count, -1, "\"rays\":" + std::to_string(sums.size()));
  change_row(model, rays);
}
