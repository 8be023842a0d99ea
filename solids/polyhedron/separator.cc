// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/separator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robust/base/fp_state.h"
#include "solids/polyhedron/nearest_simplex.h"

namespace veritope {
namespace {

constexpr std::size_t kSampleFacets = 16;
constexpr int kRounds = 12;
constexpr double kScale = 0x1p30;  // components of a direction stay below 2^31

Vec3d minus(const Vec3d& a, const Vec3d& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Vec3d& a, const Vec3d& b) { return formulas::dot3(a.x, a.y, a.z, b.x, b.y, b.z); }

// The unit vector of a heuristic: near the limits of the range the result may be anything.
Vec3d unit(const Vec3d& a) {
  const double length = std::sqrt(dot(a, a));
  return {a.x / length, a.y / length, a.z / length};
}

const Vec3d& farthest(const std::vector<Vec3d>& points, const Vec3d& d) {
  std::size_t best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double v = dot(points[i], d);
    if (v > most) {
      most = v;
      best = i;
    }
  }
  return points[best];
}

// d rounded to integers below 2^31 in absolute value; zero if that is not possible.
IntVec3 to_integers(const Vec3d& d) {
  const double size = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  if (!(size > 0) || !std::isfinite(size)) return {0, 0, 0};
  const auto part = [&](double c) { return static_cast<std::int32_t>(std::lround(c / size * kScale)); };
  return {part(d.x), part(d.y), part(d.z)};
}

struct Extent {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
  Vec3d lowest{}, highest{};
};

Extent extent_along(const TriangleMesh& mesh, std::span<const std::uint32_t> facets, const Vec3d& d) {
  Extent e;
  for (std::uint32_t f : facets)
    for (std::uint32_t v : mesh.faces[f]) {
      const double c = dot(mesh.positions[v], d);
      if (!(c >= e.least)) {
        e.least = c;
        e.lowest = mesh.positions[v];
      }
      if (!(c <= e.greatest)) {
        e.greatest = c;
        e.highest = mesh.positions[v];
      }
    }
  return e;
}

}  // namespace

double largest_coordinate(const TriangleMesh& mesh) {
  double largest = 0;
  for (const auto& t : mesh.faces)
    for (std::uint32_t v : t) {
      const Vec3d& p = mesh.positions[v];
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
  return largest;
}

// Claim    true only if d.p < d.q for all p of a, q of b.
// Bound    docs/bounds/separator.md, two groups; tests/solids/separator_bound_test.cc.
// Needs    round to nearest, gradual underflow, no contraction (robust/base/fp_guard.h).
bool SeparatorFinder::proves_apart(const IntVec3& d, std::span<const std::uint32_t> a,
                                   std::span<const std::uint32_t> b) {
  if (!filters_are_sound()) return false;
  const Vec3d v{static_cast<double>(d[0]), static_cast<double>(d[1]), static_cast<double>(d[2])};
  const double size = (std::abs(v.x) + std::abs(v.y) + std::abs(v.z)) * largest_;
  if (!(size <= internal::kSeparatorMaxSize)) return false;
  const Extent ea = extent_along(mesh_, a, v), eb = extent_along(mesh_, b, v);
  if (eb.least - ea.greatest > internal::kSeparatorRel * size + internal::kSeparatorAbs) return true;
  sample_a_.push_back(ea.highest);
  sample_b_.push_back(eb.lowest);
  return false;
}

// Collects the corners of up to kSampleFacets facets, few of them twice. In the second group, vertices of the first are
// noticed (and left out); returns false if there are two of them.
bool SeparatorFinder::take_sample(std::span<const std::uint32_t> facets, bool second, std::vector<Vec3d>& out) {
  out.clear();
  ++stamp_;
  const std::size_t n = std::min(facets.size(), kSampleFacets);
  for (std::size_t i = 0; i < n; ++i)
    for (std::uint32_t v : mesh_.faces[facets[i * facets.size() / n]]) {
      Slot& slot = slots_[v % kSlots];
      if ((slot.vertex == v && slot.stamp == stamp_) || (second && v == common_)) continue;
      if (second && slot.vertex == v && slot.stamp == stamp_ - 1) {
        if (common_ != kNoVertex) return false;
        common_ = v;
        continue;
      }
      slot = {v, stamp_};
      out.push_back(mesh_.positions[v]);
    }
  return true;
}

std::optional<IntVec3> SeparatorFinder::find(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) {
  common_ = kNoVertex;
  take_sample(a, false, sample_a_);
  if (!take_sample(b, true, sample_b_)) return std::nullopt;  // no plane is known that touches both in an edge
  return common_ == kNoVertex ? find_apart(a, b) : find_at_common(a, b);
}

// Searches for the point of the hulls' difference nearest to the origin.
std::optional<IntVec3> SeparatorFinder::find_apart(std::span<const std::uint32_t> a,
                                                   std::span<const std::uint32_t> b) {
  internal::NearestSimplex simplex;
  Vec3d nearest = minus(sample_b_[0], sample_a_[0]);
  for (int round = 0; round < kRounds; ++round) {
    const Vec3d away{-nearest.x, -nearest.y, -nearest.z};
    const Vec3d w = minus(farthest(sample_b_, away), farthest(sample_a_, nearest));
    if (dot(w, nearest) > 0) {
      const IntVec3 d = to_integers(nearest);
      if (d == IntVec3{0, 0, 0}) return std::nullopt;
      if (proves_apart(d, a, b)) return d;
    }
    simplex.add(w);
    if (!simplex.nearest(nearest) || !(dot(nearest, nearest) > 0)) return std::nullopt;
  }
  return std::nullopt;
}

// The rays q - v and v - p, as unit vectors: is there a half-space that holds them all?
std::optional<IntVec3> SeparatorFinder::find_at_common(std::span<const std::uint32_t> a,
                                                       std::span<const std::uint32_t> b) {
  const Vec3d centre = mesh_.positions[common_];
  std::vector<Vec3d>& rays = sample_b_;
  for (Vec3d& q : rays) q = unit(minus(q, centre));
  for (const Vec3d& p : sample_a_)
    if (!(p == centre)) rays.push_back(unit(minus(centre, p)));
  if (rays.empty()) return std::nullopt;
  internal::NearestSimplex simplex;
  Vec3d nearest = rays[0];
  for (int round = 0; round < kRounds; ++round) {
    const Vec3d w = farthest(rays, {-nearest.x, -nearest.y, -nearest.z});
    if (dot(w, nearest) > 0) {
      const IntVec3 d = to_integers(nearest);
      if (d == IntVec3{0, 0, 0}) return std::nullopt;
      if (proves_at_common(d, a, b)) return d;
    }
    simplex.add(w);
    if (!simplex.nearest(nearest) || !(dot(nearest, nearest) > 0)) return std::nullopt;
  }
  return std::nullopt;
}

// Claim    true only if d.p < d.v < d.q for v = common_ and all other vertices p of a, q of b. A second common vertex
//          fails.
// Bound    docs/bounds/separator.md, rays from a vertex; tests/solids/separator_bound_test.cc.
// Needs    as above.
bool SeparatorFinder::proves_at_common(const IntVec3& d, std::span<const std::uint32_t> a,
                                       std::span<const std::uint32_t> b) {
  if (!filters_are_sound()) return false;
  const Vec3d v{static_cast<double>(d[0]), static_cast<double>(d[1]), static_cast<double>(d[2])};
  const Vec3d centre = mesh_.positions[common_];
  std::vector<Vec3d>& rays = sample_b_;
  const auto all_beyond = [&](std::span<const std::uint32_t> facets, double side) {
    for (std::uint32_t f : facets)
      for (std::uint32_t id : mesh_.faces[f]) {
        if (id == common_) continue;
        const Vec3d r = minus(mesh_.positions[id], centre);
        const double size = (std::abs(v.x * r.x) + std::abs(v.y * r.y)) + std::abs(v.z * r.z);
        // false if one overflows
        if (side * dot(v, r) > internal::kSeparatorRayRel * size + internal::kSeparatorAbs)
          continue;
        rays.push_back(unit({side * r.x, side * r.y, side * r.z}));
        return false;
      }
    return true;
  };
  return all_beyond(b, 1) && all_beyond(a, -1);
}

}  // namespace veritope
