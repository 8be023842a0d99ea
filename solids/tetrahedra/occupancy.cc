// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/tetrahedra/occupancy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "interval/interval.h"
#include "interval/upward.h"
#include "predicates/distance.h"
#include "robust/base/disjoint_sets.h"

namespace veritope {
namespace {

constexpr std::array<std::array<std::uint8_t, 2>, 6> kTetrahedronEdges{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

// A box around the ball: the radius is at most the sum of the coordinates' differences.
Box3d box_of_ball(const ExactPoint3& centre, const ExactPoint3& surface) {
  const ScopedUpward upward;
  const auto &c = centre.enclosure(), &s = surface.enclosure();
  Interval radius(0.0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Interval difference = c[axis] - s[axis];
    radius = radius + Interval::from_bounds(0, std::max(-difference.lo(), difference.hi()));
  }
  Box3d box{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.lo[axis] = (c[axis] - radius).lo();
    box.hi[axis] = (c[axis] + radius).hi();
  }
  return box;
}

Box3d box_of_middle(const ExactPoint3& a, const ExactPoint3& b) {
  const ScopedUpward upward;
  Box3d box{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Interval middle = Interval(0.5) * (a.enclosure()[axis] + b.enclosure()[axis]);
    box.lo[axis] = middle.lo();
    box.hi[axis] = middle.hi();
  }
  return box;
}

double approx_length(const ExactPoint3& a, const ExactPoint3& b) {
  const double x = a.rounded().x - b.rounded().x, y = a.rounded().y - b.rounded().y,
               z = a.rounded().z - b.rounded().z;
  return std::hypot(x, y, z);
}

}  // namespace

std::vector<std::uint32_t> nearest_neighbours(std::span<const ExactPoint3> points,
                                              std::span<const TetrahedronCorners> tetrahedra) {
  std::vector<std::uint32_t> nearest(points.size());
  std::iota(nearest.begin(), nearest.end(), 0u);
  const auto offer = [&](std::uint32_t v, std::uint32_t w) {
    std::uint32_t& best = nearest[v];
    if (best == w) return;
    if (best == v) {
      best = w;
      return;
    }
    const Sign sign = compare_distances(points[v], points[w], points[best]);
    if (sign == Sign::kNegative || (sign == Sign::kZero && w < best)) best = w;
  };
  for (const TetrahedronCorners& t : tetrahedra)
    for (const auto& [i, j] : kTetrahedronEdges) offer(t[i], t[j]), offer(t[j], t[i]);
  return nearest;
}

BallUnion::BallUnion(std::span<const ExactPoint3> points, std::vector<std::uint32_t> neighbours)
    : points_(points), neighbours_(std::move(neighbours)) {
  std::vector<Box3d> boxes;
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    if (neighbours_[v] == v) continue;
    centres_.push_back(v);
    boxes.push_back(box_of_ball(points_[v], points_[neighbours_[v]]));
  }
  boxes_ = BoxHierarchy(boxes);
}

bool BallUnion::is_in_ball(std::uint32_t centre, std::uint32_t a, std::uint32_t b) const {
  return compare_middle_to_ball(points_[a], points_[b], points_[centre],
                                points_[neighbours_[centre]]) != Sign::kPositive;
}

// The balls of the two points are the likeliest.
bool BallUnion::contains_middle(std::uint32_t a, std::uint32_t b) const {
  for (const std::uint32_t v : {a, b})
    if (neighbours_[v] != v && is_in_ball(v, a, b)) return true;
  const Box3d middle = box_of_middle(points_[a], points_[b]);
  bool is_found = false;
  boxes_.visit([&](const Box3d& box) { return !is_found && meets(box, middle); },
               [&](std::uint32_t i) { is_found = is_found || is_in_ball(centres_[i], a, b); });
  return is_found;
}

std::vector<bool> occupied_tetrahedra(std::span<const TetrahedronCorners> tetrahedra,
                                      const BallUnion& balls) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, bool> known;
  const auto is_in = [&](std::uint32_t a, std::uint32_t b) {
    const auto [entry, is_new] = known.try_emplace(std::minmax(a, b), false);
    if (is_new) entry->second = balls.contains_middle(a, b);
    return entry->second;
  };
  std::vector<bool> out;
  out.reserve(tetrahedra.size());
  for (const TetrahedronCorners& t : tetrahedra)
    out.push_back(std::all_of(kTetrahedronEdges.begin(), kTetrahedronEdges.end(),
                              [&](const auto& edge) { return is_in(t[edge[0]], t[edge[1]]); }));
  return out;
}

bool BallUnion::is_sphere_at_most(const TetrahedronCorners& corners, const Rational& factor) const {
  const std::array<const ExactPoint3*, 4> places{&points_[corners[0]], &points_[corners[1]],
                                                 &points_[corners[2]], &points_[corners[3]]};
  return std::any_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
    return compare_circumradius(places, points_[v], points_[neighbours_[v]], factor) !=
           Sign::kPositive;
  });
}

std::vector<std::uint32_t> fill_noise(std::span<const TetrahedronCorners> tetrahedra,
                                      const BallUnion& balls, const Rational& factor,
                                      std::vector<bool>& occupied) {
  std::vector<std::uint32_t> filled;
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
    if (occupied[t] || !balls.is_sphere_at_most(tetrahedra[t], factor)) continue;
    occupied[t] = true;
    filled.push_back(t);
  }
  return filled;
}

std::vector<std::uint32_t> clip_large_spheres(std::span<const TetrahedronCorners> tetrahedra,
                                              const BallUnion& balls, const Rational& factor,
                                              std::vector<bool>& occupied) {
  std::vector<std::uint32_t> clipped;
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
    if (!occupied[t] || balls.is_sphere_at_most(tetrahedra[t], factor)) continue;
    occupied[t] = false;
    clipped.push_back(t);
  }
  return clipped;
}

std::vector<std::uint32_t> fill_enclosed_gaps(const TetrahedralComplex& complex,
                                              const BallUnion& balls, const Rational& factor,
                                              std::vector<bool>& occupied) {
  const std::vector<TetrahedronCorners>& tetrahedra = complex.tetrahedra();
  std::vector<bool> is_seen = occupied;
  std::vector<std::uint32_t> filled;
  for (std::uint32_t first = 0; first < tetrahedra.size(); ++first) {
    if (is_seen[first]) continue;
    is_seen[first] = true;
    std::vector<std::uint32_t> gap{first};
    bool is_enclosed = true;
    for (std::size_t i = 0; i < gap.size(); ++i)
      for (std::uint32_t m = 0; m < 4; ++m) {
        const auto partner = complex.partner(4 * gap[i] + m);
        is_enclosed = is_enclosed && partner.has_value();
        if (!partner || is_seen[face_tetrahedron(*partner)]) continue;
        is_seen[face_tetrahedron(*partner)] = true;
        gap.push_back(face_tetrahedron(*partner));
      }
    if (!is_enclosed || !std::all_of(gap.begin(), gap.end(), [&](std::uint32_t t) {
          return balls.is_sphere_at_most(tetrahedra[t], factor);
        }))
      continue;
    for (const std::uint32_t t : gap) occupied[t] = true;
    filled.insert(filled.end(), gap.begin(), gap.end());
  }
  std::sort(filled.begin(), filled.end());
  return filled;
}

std::vector<std::uint32_t> order_by_longest_edge(std::span<const ExactPoint3> points,
                                                 std::span<const TetrahedronCorners> tetrahedra) {
  std::vector<double> longest;
  longest.reserve(tetrahedra.size());
  for (const TetrahedronCorners& t : tetrahedra) {
    double most = 0;
    for (const auto& [i, j] : kTetrahedronEdges)
      most = std::max(most, approx_length(points[t[i]], points[t[j]]));
    longest.push_back(most);
  }
  std::vector<std::uint32_t> by_length(tetrahedra.size()), rank(tetrahedra.size());
  std::iota(by_length.begin(), by_length.end(), 0u);
  std::stable_sort(by_length.begin(), by_length.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return longest[a] > longest[b]; });
  for (std::uint32_t i = 0; i < by_length.size(); ++i) rank[by_length[i]] = i;
  return rank;
}

namespace {

// The parts of the tetrahedra that are wanted: connected through faces, or through vertices.
DisjointSets<std::uint32_t> parts_of(const TetrahedralComplex& complex,
                                     const std::vector<bool>& wanted, bool through_vertices) {
  DisjointSets<std::uint32_t> parts(complex.tetrahedra().size());
  for (std::uint32_t t = 0; t < wanted.size(); ++t)
    for (std::uint32_t m = 0; wanted[t] && m < 4; ++m) {
      const auto partner = complex.partner(4 * t + m);
      if (partner && wanted[face_tetrahedron(*partner)]) parts.join(t, face_tetrahedron(*partner));
    }
  for (std::uint32_t v = 0; through_vertices && v < complex.num_vertices(); ++v) {
    std::optional<std::uint32_t> first;
    for (const std::uint32_t t : complex.tetrahedra_at(v)) {
      if (!wanted[t]) continue;
      if (first) parts.join(*first, t);
      first = t;
    }
  }
  return parts;
}

RemovalReason reason_of(TrimReason reason) {
  switch (reason) {
    case TrimReason::kEdge: return RemovalReason::kEdge;
    case TrimReason::kVertex: return RemovalReason::kVertex;
    default: return RemovalReason::kRing;
  }
}

}  // namespace

const char* reason_name(RemovalReason reason) {
  switch (reason) {
    case RemovalReason::kMiddle: return "middle";
    case RemovalReason::kSphere: return "sphere";
    case RemovalReason::kEdge: return "edge";
    case RemovalReason::kVertex: return "vertex";
    case RemovalReason::kRing: return "ring";
    default: return "satellite";
  }
}

std::vector<std::uint32_t> remove_satellites(const TetrahedralComplex& complex,
                                             const std::vector<bool>& before,
                                             std::vector<bool>& kept) {
  auto clusters = parts_of(complex, before, true), parts = parts_of(complex, kept, false);
  std::vector<std::size_t> size(kept.size()),
      largest(kept.size());  // by the number of a part, of a cluster
  for (std::uint32_t t = 0; t < kept.size(); ++t)
    if (kept[t]) ++size[parts.find(t)];
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    std::size_t& most = largest[clusters.find(t)];
    most = std::max(most, size[t]);
  }
  std::vector<std::uint32_t> out;
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    if (!kept[t] || 16 * size[parts.find(t)] >= largest[clusters.find(t)]) continue;
    kept[t] = false;
    out.push_back(t);
  }
  return out;
}

Result<Occupancy> find_occupancy(std::span<const ExactPoint3> points,
                                 const std::vector<TetrahedronCorners>& tetrahedra) {
  const BallUnion balls(points, nearest_neighbours(points, tetrahedra));
  const TetrahedralComplex complex(tetrahedra, static_cast<std::uint32_t>(points.size()));
  const std::vector<bool> occupied = occupied_tetrahedra(tetrahedra, balls);
  std::vector<bool> kept = occupied;
  fill_noise(tetrahedra, balls, Rational(Integer(3), Integer(2)), kept);
  std::vector<RemovedTetrahedron> removed;
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
    if (!kept[t]) removed.push_back({t, RemovalReason::kMiddle});
  for (const std::uint32_t t : clip_large_spheres(tetrahedra, balls, Rational(3), kept))
    removed.push_back({t, RemovalReason::kSphere});
  std::vector<bool> before = kept;
  for (const TrimmedTetrahedron& t :
       trim_to_manifold(complex, order_by_longest_edge(points, tetrahedra), kept))
    removed.push_back({t.tetrahedron, reason_of(t.reason)});
  for (const std::uint32_t t : fill_enclosed_gaps(complex, balls, Rational(2), kept))
    before[t] = true;
  for (const std::uint32_t t : remove_satellites(complex, before, kept))
    removed.push_back({t, RemovalReason::kSatellite});
  Occupancy out;
  for (const RemovedTetrahedron& r : removed)
    if (!kept[r.tetrahedron]) out.removed.push_back(r);
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
    if (!kept[t]) continue;
    out.kept.push_back(t);
    if (!occupied[t]) out.filled.push_back(t);
  }
  if (out.kept.empty())
    return bad_argument(
        "no tetrahedron has the middles of its edges in the union of the balls around the points");
  return out;
}

}  // namespace veritope
