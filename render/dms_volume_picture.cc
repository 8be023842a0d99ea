// SPDX-License-Identifier: LGPL-3.0-or-later
#include "render/dms_volume_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "render/colour_map.h"
#include "render/dms_sampler_internal.h"

namespace veritope {
namespace {

using internal::DmsSampler;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kDark = 1e-3;    // light that does not show
constexpr int kHalvings = 10;     // of a step at an end of what is seen
constexpr std::size_t kRows = 8;  // whose rays are sampled together

double length_of(const Point3d& d) { return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]); }

double diagonal_of(const Box3d& box) {
  return length_of({box.hi[0] - box.lo[0], box.hi[1] - box.lo[1], box.hi[2] - box.lo[2]});
}

// A ray and what has been seen along it.
struct CastRay {
  double i = 0, j = 0;
  double value = kNone;  // at the last sample
  double light = 1;      // that comes from behind
  std::array<double, 3> colour{};

  bool is_alive() const { return light > kDark; }
  void pass(const TransferFunction& transfer, double from, double to, double length) {
    const TransferFunction::Mean mean = transfer.mean(from, to);
    if (!(mean.extinction > 0)) return;
    const double left = light * exp_minus(mean.extinction * length);
    for (std::size_t c = 0; c < 3; ++c)
      colour[c] += (light - left) * (mean.glow[c] / mean.extinction);
    light = left;
  }
  Colour seen() const {
    const auto channel = [this](std::size_t c) {
      const double paper = 255 * light;
      return static_cast<std::uint8_t>(std::clamp(colour[c] + paper, 0.0, 255.0) + 0.5);
    };
    return {channel(0), channel(1), channel(2)};
  }
};

// An end of what is seen between two samples of a ray.
struct Crossing {
  std::size_t ray = 0;
  double inside = 0, outside = 0;  // places along the ray
  double value = 0;                // at the inner one
};

class Caster {
 public:
  Caster(const TransferFunction& transfer, const DmsRayGrid& grid, std::size_t steps)
      : transfer_(transfer), grid_(grid), steps_(steps), depth_(length_of(grid.along)) {}

  void draw(DmsSampler& sampler, std::size_t first, std::size_t last, Image& image) {
    start(first, last);
    for (std::size_t k = 0; k <= steps_ && !alive_.empty(); ++k) advance(sampler, k);
    for (const CastRay& ray : rays_)
      image.at(static_cast<std::size_t>(ray.i), static_cast<std::size_t>(ray.j)) = ray.seen();
  }

 private:
  double place(std::size_t k) const { return static_cast<double>(k) / static_cast<double>(steps_); }

  void start(std::size_t first, std::size_t last) {
    rays_.clear(), alive_.clear();
    for (std::size_t j = first; j < last; ++j)
      for (std::size_t i = 0; i < grid_.columns; ++i) {
        CastRay& ray = rays_.emplace_back();
        ray.i = static_cast<double>(i), ray.j = static_cast<double>(j);
        alive_.push_back(rays_.size() - 1);
      }
  }

  // To sample k of all rays.
  void advance(DmsSampler& sampler, std::size_t k) {
    points_.clear();
    for (const std::size_t r : alive_)
      points_.push_back(internal::point_of(grid_, rays_[r].i, rays_[r].j, place(k)));
    const auto values = sampler.values(points_);
    now_.assign(values.begin(), values.end());
    find_crossings(sampler, k);
    for (std::size_t a = 0; a < alive_.size(); ++a) {
      CastRay& ray = rays_[alive_[a]];
      if (!std::isnan(ray.value) && !std::isnan(now_[a]))
        ray.pass(transfer_, ray.value, now_[a], depth_ / static_cast<double>(steps_));
      ray.value = now_[a];
    }
    std::erase_if(alive_, [this](std::size_t r) { return !rays_[r].is_alive(); });
  }

  void find_crossings(DmsSampler& sampler, std::size_t k) {
    crossings_.clear();
    for (std::size_t a = 0; a < alive_.size() && k > 0; ++a) {
      const double before = rays_[alive_[a]].value, now = now_[a];
      if (std::isnan(before) == std::isnan(now)) continue;
      const bool enters = std::isnan(before);
      crossings_.push_back(
          {alive_[a], place(enters ? k : k - 1), place(enters ? k - 1 : k), enters ? now : before});
    }
    const std::vector<Crossing> begun = crossings_;
    for (int round = 0; round < kHalvings && !crossings_.empty(); ++round) halve(sampler);
    for (std::size_t c = 0; c < crossings_.size(); ++c) {
      const Crossing& end = crossings_[c];
      const double length = depth_ * std::abs((end.inside + end.outside) / 2 - begun[c].inside);
      if (begun[c].inside < begun[c].outside)
        rays_[end.ray].pass(transfer_, begun[c].value, end.value, length);
      else
        rays_[end.ray].pass(transfer_, end.value, begun[c].value, length);
    }
  }

  void halve(DmsSampler& sampler) {
    points_.clear();
    for (const Crossing& c : crossings_)
      points_.push_back(
          internal::point_of(grid_, rays_[c.ray].i, rays_[c.ray].j, (c.inside + c.outside) / 2));
    const auto values = sampler.values(points_);
    for (std::size_t c = 0; c < crossings_.size(); ++c) {
      Crossing& crossing = crossings_[c];
      const double middle = (crossing.inside + crossing.outside) / 2;
      if (std::isnan(values[c]))
        crossing.outside = middle;
      else
        crossing.inside = middle, crossing.value = values[c];
    }
  }

  const TransferFunction& transfer_;
  const DmsRayGrid& grid_;
  const std::size_t steps_;
  const double depth_;
  std::vector<CastRay> rays_;
  std::vector<std::size_t> alive_;
  std::vector<Vec3d> points_;
  std::vector<double> now_;
  std::vector<Crossing> crossings_;
};

}  // namespace

Result<DmsVolumePicture> draw_dms_volume(const DmsField& field, const TransferFunction& transfer,
                                         const PictureOptions& look, std::optional<double> step) {
  constexpr double kMostSteps = 1 << 16, kStepsOfDiagonal = 200;
  if (const Status status = field.check(); !status) return status.error();
  const Box3d box = field.box();
  const Result<DmsRayGrid> rays = rays_of_picture(box, look);
  if (!rays) return rays.error();
  const double depth = length_of(rays->along);
  const double steps = std::ceil(depth / step.value_or(diagonal_of(box) / kStepsOfDiagonal));
  if (!(steps <= kMostSteps))
    return Error{Code::kOverLimit, {}, "rays have at most 65536 steps; a greater step is needed"};
  DmsVolumePicture out{Image(look.width, look.height, Colour{255, 255, 255}), *rays,
                       depth / std::max(steps, 1.0)};
  internal::draw_rows(
      field, look.height, look.jobs, [&](DmsSampler& sampler, std::size_t first, std::size_t last) {
        Caster caster(transfer, *rays, static_cast<std::size_t>(std::max(steps, 1.0)));
        for (std::size_t j = first; j < last; j += kRows)
          caster.draw(sampler, j, std::min(j + kRows, last), out.image);
      });
  return out;
}

TransferFunction default_transfer(const DmsField& field) {
  constexpr double kLeast = 1, kMost = 24;  // for the diagonal
  constexpr int kParts = 4;
  double low = std::numeric_limits<double>::max(), high = -low;
  for (std::size_t c = 0; c < field.spline->num_control(); ++c) {
    const double value =
        std::clamp(nearest_double(field.spline->value(c)[field.component]),
                   -std::numeric_limits<double>::max() / 4, std::numeric_limits<double>::max() / 4);
    low = std::min(low, value), high = std::max(high, value);
  }
  const double diagonal = diagonal_of(field.box());
  std::vector<TransferNode> nodes;
  for (int i = 0; i <= kParts; ++i) {
    const double share = static_cast<double>(i) / kParts;
    const Colour c = map_colour(share);
    nodes.push_back(
        {low + share * (high - low),
         {static_cast<double>(c.red), static_cast<double>(c.green), static_cast<double>(c.blue)},
         (kLeast + (kMost - kLeast) * share * share) / diagonal});
  }
  return TransferFunction(std::move(nodes));
}

}  // namespace veritope
