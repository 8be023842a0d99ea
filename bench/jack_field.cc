// SPDX-License-Identifier: LGPL-3.0-or-later
#include "bench/jack_field.h"

#include <algorithm>
#include <cmath>

namespace veritope::bench {

namespace {
constexpr float kNode = 0.2f;
}

JackField::JackField(const MicroGrid& grid, int degree)
    : n_(grid.shape().size[0]), degree_(degree) {
  for (std::size_t c = 0; c < grid.shape().count(); ++c) {
    const WallNumbers numbers = grid.numbers_of(grid.shape().index_of(c));
    std::array<float, 6> halves{};
    for (std::size_t w = 0; w < 6; ++w)
      halves[w] = static_cast<float>(numbers[w]) / static_cast<float>(kMaxWallNumber);
    halves_.push_back(halves);
  }
}

JackField::Place JackField::place_of(double x) const {
  const double n = static_cast<double>(n_), at = x * n;
  Place out;
  out.cell = static_cast<std::size_t>(std::clamp(std::floor(at), 0.0, n - 1));
  const double local = at - static_cast<double>(out.cell) - 0.5;
  out.end = local > 0 ? 1 : 0;
  out.distance = static_cast<float>(std::abs(local));
  const float t = std::clamp((out.distance - kNode) / (0.5f - kNode), 0.0f, 1.0f);
  out.along = degree_ == 1 ? t : t * t * (3 - 2 * t);
  out.outside = static_cast<float>(std::max(-at, at - n));
  return out;
}

// Arms, infinitely long squares of varying width, meet in the cube, which is the part of each near
// its middle.
inline float JackField::value(const std::array<Place, 3>& p, float u, float v, float w) const {
  const float x = p[0].distance, y = p[1].distance, z = p[2].distance;
  const float arm_u = std::max(y, z) - (kNode + (u - kNode) * p[0].along);
  const float arm_v = std::max(x, z) - (kNode + (v - kNode) * p[1].along);
  const float arm_w = std::max(x, y) - (kNode + (w - kNode) * p[2].along);
  const float outside = std::max({p[0].outside, p[1].outside, p[2].outside});
  return -std::max(std::min({arm_u, arm_v, arm_w}), outside);
}

double JackField::at(const Vec3d& p) const {
  const std::array<Place, 3> at{place_of(p.x), place_of(p.y), place_of(p.z)};
  const auto& h = halves(at[0].cell, at[1].cell, at[2].cell);
  return static_cast<double>(value(at, h[at[0].end], h[2 + at[1].end], h[4 + at[2].end]));
}

FieldGrid JackField::sample(int parts, double shift) const {
  FieldGrid out;
  const int size = parts + 3;
  out.size = {size, size, size};
  out.step = 1.0 / parts;
  out.origin = {(shift - 1) / parts, (shift - 1) / parts, (shift - 1) / parts};
  std::vector<Place> places;
  for (int i = 0; i < size; ++i) places.push_back(place_of((i - 1 + shift) / parts));
  out.values.resize(places.size() * places.size() * places.size());
  float* next = out.values.data();
  for (const Place& z : places)
    for (const Place& y : places)
      for (const Place& x : places) {
        const auto& h = halves(x.cell, y.cell, z.cell);
        *next++ = value({x, y, z}, h[x.end], h[2 + y.end], h[4 + z.end]);
      }
  return out;
}

}  // namespace veritope::bench
