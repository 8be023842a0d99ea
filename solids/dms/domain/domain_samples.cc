// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/domain_samples.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solids/tetrahedra/insertion_order.h"

namespace veritope {
namespace {

Vec3d vector_to(const Vec3d& a, const Vec3d& b) { return {b.x - a.x, b.y - a.y, b.z - a.z}; }
double length_of(const Vec3d& a) { return std::hypot(a.x, a.y, a.z); }
Vec3d normal_of(const Vec3d& a, const Vec3d& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double distance_of(const Vec3d& a, const Vec3d& b) { return length_of(vector_to(a, b)); }

double distance_to_chord(const Vec3d& p, const Vec3d& a, const Vec3d& b) {
  const Vec3d ab = vector_to(a, b), ap = vector_to(a, p);
  const double square = ab.x * ab.x + ab.y * ab.y + ab.z * ab.z;
  if (square == 0) return length_of(ap);
  const double at = std::clamp((ab.x * ap.x + ab.y * ap.y + ab.z * ap.z) / square, 0.0, 1.0);
  return distance_of(p, {a.x + at * ab.x, a.y + at * ab.y, a.z + at * ab.z});
}

// The place between first and last that stays, too; first if none has to.
std::size_t place_to_keep(std::span<const Vec3d> points, std::span<const std::uint32_t> line,
                          std::size_t first, std::size_t last, double tolerance, double most) {
  const Vec3d &a = points[line[first]], &b = points[line[last]];
  std::size_t farthest = first, middle = first;
  double distance = tolerance, least = HUGE_VAL;
  for (std::size_t i = first + 1; i < last; ++i) {
    const Vec3d& p = points[line[i]];
    if (const double d = distance_to_chord(p, a, b); d > distance) distance = d, farthest = i;
    const double larger = std::max(distance_of(p, a), distance_of(p, b));
    if (larger < least) least = larger, middle = i;
  }
  if (farthest != first) return farthest;
  return distance_of(a, b) > most ? middle : first;
}

}  // namespace

std::vector<std::uint32_t> sample_feature_line(std::span<const Vec3d> points,
                                               std::span<const std::uint32_t> line,
                                               double tolerance, double most) {
  std::vector<std::uint8_t> stays(line.size(), 0);
  stays.front() = stays.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const std::size_t at = place_to_keep(points, line, first, last, tolerance, most);
    if (at == first) continue;
    stays[at] = 1;
    open.push_back({first, at});
    open.push_back({at, last});
  }
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (stays[i] != 0) out.push_back(line[i]);
  return out;
}

std::vector<double> approx_curvatures(std::span<const Vec3d> points,
                                      const TetrahedralComplex& complex) {
  std::vector<Vec3d> normals(points.size(), Vec3d{0, 0, 0});
  for (const TetrahedronFace f : complex.boundary()) {
    const auto v = complex.vertices(f);
    const Vec3d n =
        normal_of(vector_to(points[v[0]], points[v[1]]), vector_to(points[v[0]], points[v[2]]));
    for (const std::uint32_t w : v)
      normals[w] = {normals[w].x + n.x, normals[w].y + n.y, normals[w].z + n.z};
  }
  std::vector<double> out(points.size(), 0);
  for (const TetrahedronFace f : complex.boundary()) {
    const auto v = complex.vertices(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = v[k], b = v[(k + 1) % 3];
      const Vec3d &m = normals[a], &n = normals[b];
      const double turn = std::atan2(length_of(normal_of(m, n)), m.x * n.x + m.y * n.y + m.z * n.z);
      const double curvature = turn / distance_of(points[a], points[b]);
      if (!std::isfinite(curvature)) continue;
      out[a] = std::max(out[a], curvature);
      out[b] = std::max(out[b], curvature);
    }
  }
  return out;
}

std::vector<std::uint32_t> sample_surface(std::span<const Vec3d> points,
                                          std::span<const double> curvatures,
                                          std::span<const std::uint32_t> candidates,
                                          std::span<const std::uint32_t> taken,
                                          const SurfaceSteps& steps) {
  std::vector<std::uint32_t> accepted(taken.begin(), taken.end());
  for (const std::uint32_t v : candidates) {
    const double step = std::clamp(steps.turn / curvatures[v], steps.least, steps.most);
    if (std::none_of(accepted.begin(), accepted.end(),
                     [&](std::uint32_t w) { return distance_of(points[v], points[w]) < step; }))
      accepted.push_back(v);
  }
  return {accepted.begin() + static_cast<std::ptrdiff_t>(taken.size()), accepted.end()};
}

std::vector<std::uint32_t> sample_interior(std::span<const Vec3d> points,
                                           std::span<const std::uint32_t> candidates,
                                           std::size_t count) {
  if (candidates.empty() || count == 0) return {};
  Vec3d low = points[candidates[0]];
  double size = 0;
  for (const std::uint32_t v : candidates)
    low = {std::min(low.x, points[v].x), std::min(low.y, points[v].y),
           std::min(low.z, points[v].z)};
  for (const std::uint32_t v : candidates)
    size = std::max({size, points[v].x - low.x, points[v].y - low.y, points[v].z - low.z});
  const auto cell = [&](double x) {
    const double at = size > 0 ? x / size * 1048575.0 : 0;
    return static_cast<std::uint32_t>(std::clamp(at, 0.0, 1048575.0));
  };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> along;
  for (const std::uint32_t v : candidates)
    along.emplace_back(hilbert_number(cell(points[v].x - low.x), cell(points[v].y - low.y),
                                      cell(points[v].z - low.z)),
                       v);
  std::sort(along.begin(), along.end());
  const std::size_t stride = (along.size() + count - 1) / count;
  std::vector<std::uint32_t> out;
  for (std::size_t i = stride / 2; i < along.size(); i += stride) out.push_back(along[i].second);
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace veritope
