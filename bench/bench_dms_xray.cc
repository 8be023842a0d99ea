// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/bench_dms_xray.cc: one thread draws an x-ray of 256 x 256 rays through 2,058 quadratic tetrahedra of a cube.
// Clouds reach a tenth of the edge; the attribute is the waves of table 1.
//   xray_vs_sampling   ns a ray, plans and weights included, beside sums of FastDms values, without bounds, at
//                      multiples of a constant step, times the square root of 1/2 until no ray of 64 is wrong by more
//                      than 1e-6; given up at 64 times our ns (peer_reached: false)
//   xray_vs_midpoints  beside the same at midpoints of equal parts of the ray's part in the cube, which no general
//                      domain gives so easily; 1,024 rays
//   xray_sums          ns a ray beyond the plans
//   xray_change        ns of a changed coefficient, the least of 16; same_bytes: whether all sums are those of a new
//                      picture
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "bench/arguments.h"
#include "bench/print_row.h"
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
    double x[3];
    for (std::size_t c = 0; c < 3; ++c) x[c] = nearest_double(values[i + c]) / side;
    const double height =
        .5 + .25 * std::sin(9 * x[0]) * std::cos(7 * x[1]) + .25 * std::sin(8 * x[2] + 3 * x[0]);
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

// Sums of values, as parts of the whole ray.
class Sampler {
 public:
  Sampler(FastDms& fast, bool is_fitted) : fast_(fast), is_fitted_(is_fitted) {}

  double mean(const Chord& chord, double step) {
    if (chord.end <= chord.begin) return 0;
    const double length = chord.end - chord.begin;
    double first = std::ceil(chord.begin / step) * step;
    auto count = static_cast<std::size_t>(std::max(0., std::floor((chord.end - first) / step) + 1));
    if (is_fitted_) {
      count = static_cast<std::size_t>(std::ceil(length / step));
      step = length / static_cast<double>(count), first = chord.begin + step / 2;
    }
    samples_ += count;
    double sum = 0;
    for (std::size_t k = 0; k < count; k += kBatch)
      sum += sum_of(chord, first, step, k, std::min(count, k + kBatch));
    return sum * step;
  }
  std::size_t samples() const { return samples_; }
  void reset() { samples_ = 0; }

 private:
  static constexpr std::size_t kBatch = 4096;

  double sum_of(const Chord& chord, double first, double step, std::size_t begin, std::size_t end) {
    points_.clear();
    for (std::size_t k = begin; k < end; ++k) {
      const double t = first + step * static_cast<double>(k);
      points_.push_back({chord.from[0] + t * chord.way[0], chord.from[1] + t * chord.way[1],
                         chord.from[2] + t * chord.way[2]});
    }
    values_.resize(kComponents * points_.size());
    fast_.evaluate(points_, {values_.data()});
    double sum = 0;
    for (std::size_t k = kAttribute; k < values_.size(); k += kComponents)
      if (!std::isnan(values_[k])) sum += values_[k];  // an end of the chord, rounded off the cube
    return sum;
  }

  FastDms& fast_;
  const bool is_fitted_;
  std::vector<Vec3d> points_;
  std::vector<double> values_;
  std::size_t samples_ = 0;
};

struct PeerFigures {
  double ns = 0, worst = 0, samples = 0;  // a ray
  bool is_reached = false;

  std::string text() const {
    return "\"peer_reached\":" + std::string(is_reached ? "true" : "false") +
           ",\"peer_worst\":" + std::to_string(1e6 * worst) +
           "e-6,\"peer_samples\":" + std::to_string(samples);
  }
};

PeerFigures race_peer(FastDms& fast, const DmsRayGrid& grid, const std::vector<DmsRaySum>& sums,
                      int side, bool is_fitted, std::size_t num_rays, double most_ns) {
  Random random(5);
  std::vector<std::size_t> rays;
  for (std::size_t i = 0; i < num_rays; ++i) rays.push_back(random.below(sums.size()));
  Sampler sampler(fast, is_fitted);
  for (const std::size_t ray : rays)
    sampler.mean(chord_of(grid, ray, side), 1. / 256);  // makes tables
  PeerFigures out;
  for (double step = 1. / 64; !out.is_reached && out.ns < most_ns; step *= std::sqrt(.5)) {
    out.worst = 0;
    sampler.reset();
    const Stopwatch watch;
    for (const std::size_t ray : rays)
      out.worst = std::max(
          out.worst, std::abs(sampler.mean(chord_of(grid, ray, side), step) - sums[ray].mean));
    out.ns = watch.ns() / static_cast<double>(num_rays);
    out.samples = static_cast<double>(sampler.samples()) / static_cast<double>(num_rays);
    out.is_reached = out.worst <= kWanted;
  }
  return out;
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
  FastDms fast(model);
  const PeerFigures fitted = race_peer(fast, grid, sums, side, true, 1024, 64 * all / count);
  const PeerFigures constant = race_peer(fast, grid, sums, side, false, 64, 64 * all / count);
  print_row("xray_vs_sampling", all / count, constant.ns,
            "\"seconds\":" + std::to_string(all / 1e9) +
                ",\"tetrahedra\":" + std::to_string(model.tetrahedra.size()) +
                ",\"rays_that_hit\":" + std::to_string(num_hits) +
                ",\"greatest_bound\":" + std::to_string(1e6 * bound) + "e-6," + constant.text());
  print_row("xray_vs_midpoints", all / count, fitted.ns, fitted.text());
  print_row("xray_sums", (all - plans) / count, -1, "\"rays\":" + std::to_string(sums.size()));
  change_row(model, rays);
}
