// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/polyhedron/separator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "robust/base/fp_state.h"

namespace veritope {
namespace {

constexpr std::size_t kSampleFacets = 16;
constexpr int kRounds = 12;
constexpr double kScale = 0x1p30;  // components of a direction stay below 2^31

Vec3d minus(const Vec3d& a, const Vec3d& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3d plus_scaled(const Vec3d& a, double t, const Vec3d& d) { return {a.x + t * d.x, a.y + t * d.y, a.z + t * d.z}; }
double dot(const Vec3d& a, const Vec3d& b) { return formulas::dot3(a.x, a.y, a.z, b.x, b.y, b.z); }
Vec3d cross(const Vec3d& a, const Vec3d& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// The unit vector of a heuristic: near the limits of the range the result may be anything.
Vec3d unit(const Vec3d& a) {
  const double length = std::sqrt(dot(a, a));
  return {a.x / length, a.y / length, a.z / length};
}

// A simplex of at most four points and its point nearest to the origin. It is a heuristic: nothing relies on its
// rounding.
class Simplex {
 public:
  void add(const Vec3d& p) { at_[size_++] = p; }
  // Reduces the simplex to the face that holds the nearest point; false if it contains the origin.
  bool nearest(Vec3d& out) {
    switch (size_) {
      case 1: out = at_[0]; return true;
      case 2: out = on_edge(0, 1); break;
      case 3: out = on_triangle(0, 1, 2); break;
      default:
        if (!on_tetrahedron(out)) return false;
    }
    keep();
    return true;
  }

 private:
  Vec3d on_edge(int i, int j) {
    const Vec3d d = minus(at_[j], at_[i]);
    const double len = dot(d, d), t = len > 0 ? std::clamp(-dot(at_[i], d) / len, 0.0, 1.0) : 0.0;
    kept_ = (t < 1 ? 1u << i : 0u) | (t > 0 ? 1u << j : 0u);
    return plus_scaled(at_[i], t, d);
  }
  Vec3d on_triangle(int i, int j, int k) {
    const Vec3d u = minus(at_[j], at_[i]), v = minus(at_[k], at_[i]), n = cross(u, v);
    const double nn = dot(n, n);
    if (nn > 0) {
      const Vec3d a = minus({0, 0, 0}, at_[i]);
      const double s = dot(cross(a, v), n) / nn, t = dot(cross(u, a), n) / nn;
      if (s > 0 && t > 0 && s + t < 1) {
        kept_ = 1u << i | 1u << j | 1u << k;
        return plus_scaled(plus_scaled(at_[i], s, u), t, v);
      }
    }
    Vec3d best{};
    double least = std::numeric_limits<double>::infinity();
    unsigned kept = 0;
    for (const auto& e : {std::array{i, j}, std::array{j, k}, std::array{k, i}}) {
      const Vec3d p = on_edge(e[0], e[1]);
      if (dot(p, p) < least) {
        least = dot(p, p);
        best = p;
        kept = kept_;
      }
    }
    kept_ = kept;
    return best;
  }
  bool on_tetrahedron(Vec3d& out) {
    double least = std::numeric_limits<double>::infinity();
    unsigned kept = 0;
    for (const auto& f : {std::array{0, 1, 2, 3}, std::array{0, 1, 3, 2}, std::array{0, 2, 3, 1},
                          std::array{1, 2, 3, 0}}) {
      const Vec3d n = cross(minus(at_[f[1]], at_[f[0]]), minus(at_[f[2]], at_[f[0]]));
      const double origin = -dot(n, at_[f[0]]), fourth = dot(n, minus(at_[f[3]], at_[f[0]]));
      if (origin * fourth > 0) continue;  // the origin is on the inner side of this face
      const Vec3d p = on_triangle(f[0], f[1], f[2]);
      if (dot(p, p) < least) {
        least = dot(p, p);
        out = p;
        kept = kept_;
      }
    }
    kept_ = kept;
    return kept != 0;
  }
  void keep() {
    int n = 0;
    for (int i = 0; i < size_; ++i)
      if ((kept_ >> i & 1u) != 0) at_[n++] = at_[i];
    size_ = n;
  }

  std::array<Vec3d, 4> at_{};
  int size_ = 0;
  unsigned kept_ = 0;
};

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
  Simplex simplex;
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
  Simplex simplex;
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
