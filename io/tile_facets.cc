// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "io/tile_facets_internal.h"

namespace veritope::internal {
namespace {

TilePoint difference(const TilePoint& a, const TilePoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
TilePoint cross_product(const TilePoint& a, const TilePoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot_product(const TilePoint& a, const TilePoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
TilePoint normal_of(const TilePoint& a, const TilePoint& b, const TilePoint& c) {
  return cross_product(difference(b, a), difference(c, a));
}
TilePoint middle_of(const TilePoint& a, const TilePoint& b) {
  TilePoint out;
  for (std::size_t c = 0; c < 3; ++c) out[c] = (a[c] + b[c]) / Rational(2);
  return out;
}

using Quadrilateral = std::array<TilePoint, 4>;  // counterclockwise

// Whether the corners lie in one plane and turn left at each of them.
bool is_flat_and_convex(const Quadrilateral& q) {
  const TilePoint n = normal_of(q[0], q[1], q[2]);
  if (dot_product(n, difference(q[3], q[0])).sign() != Sign::kZero) return false;
  for (std::size_t i = 0; i < 4; ++i)
    if (dot_product(n, normal_of(q[i], q[(i + 1) % 4], q[(i + 2) % 4])).sign() != Sign::kPositive)
      return false;
  return true;
}

// The side of a facet that starts at corner `side`, and the other facet on it.
struct FacetPair {
  std::size_t first = 0, second = 0;
  Quadrilateral corners;
  bool is_of_polygon = false;
};

class FacetJoiner {
 public:
  explicit FacetJoiner(const std::vector<TileFacet>& facets) : facets_(facets) {}

  // Triangles that are in no quadrilateral stay.
  void run(std::vector<Quadrilateral>& quadrilaterals, std::vector<TileFacet>& left) {
    std::vector<FacetPair> pairs = candidates();
    // Those of polygons first; then those whose partners have no other choice.
    std::vector<std::size_t> choices(facets_.size());
    for (const FacetPair& p : pairs) ++choices[p.first], ++choices[p.second];
    std::stable_sort(pairs.begin(), pairs.end(), [&](const FacetPair& a, const FacetPair& b) {
      const auto rank = [&](const FacetPair& p) {
        return std::pair(!p.is_of_polygon, std::min(choices[p.first], choices[p.second]));
      };
      return rank(a) < rank(b);
    });
    std::vector<bool> is_taken(facets_.size());
    std::map<std::size_t, Quadrilateral> taken;
    for (FacetPair& p : pairs) {
      if (is_taken[p.first] || is_taken[p.second]) continue;
      is_taken[p.first] = is_taken[p.second] = true;
      taken.emplace(p.first, std::move(p.corners));
    }
    for (auto& [first, corners] : taken) quadrilaterals.push_back(std::move(corners));
    for (std::size_t f = 0; f < facets_.size(); ++f)
      if (!is_taken[f]) left.push_back(facets_[f]);
  }

 private:
  std::vector<FacetPair> candidates() const {
    std::map<std::pair<TilePoint, TilePoint>, std::pair<std::size_t, std::size_t>> sides;
    for (std::size_t f = 0; f < facets_.size(); ++f)
      for (std::size_t s = 0; s < 3; ++s)
        sides[{facets_[f].corners[s], facets_[f].corners[(s + 1) % 3]}] = {f, s};
    std::vector<FacetPair> out;
    for (const auto& [ends, at] : sides) {
      const auto other = sides.find({ends.second, ends.first});
      if (other == sides.end() || other->second.first <= at.first) continue;
      const auto& a = facets_[at.first];
      const auto& b = facets_[other->second.first];
      FacetPair p{at.first,
                  other->second.first,
                  {ends.first, b.corners[(other->second.second + 2) % 3], ends.second,
                   a.corners[(at.second + 2) % 3]},
                  a.polygon.has_value() && a.polygon == b.polygon};
      if (is_flat_and_convex(p.corners)) out.push_back(std::move(p));
    }
    std::sort(out.begin(), out.end(), [](const FacetPair& a, const FacetPair& b) {
      return std::pair(a.first, a.second) < std::pair(b.first, b.second);
    });
    return out;
  }

  const std::vector<TileFacet>& facets_;
};

// The bilinear patch with these corners, counterclockwise.
TilePatch bilinear(const TilePoint& a, const TilePoint& b, const TilePoint& c, const TilePoint& d) {
  TilePatch out;
  out.points = {{a, d, b, c}};
  return out;
}

// Around a point inside, one patch for each corner of the polygon.
void add_parts(const std::vector<TilePoint>& polygon, std::vector<TilePatch>& out) {
  TilePoint inside;
  for (const TilePoint& p : polygon)
    for (std::size_t c = 0; c < 3; ++c)
      inside[c] += p[c] / Rational(static_cast<std::int64_t>(polygon.size()));
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const TilePoint &p = polygon[i], &next = polygon[(i + 1) % polygon.size()],
                    &last = polygon[(i + polygon.size() - 1) % polygon.size()];
    out.push_back(bilinear(p, middle_of(p, next), inside, middle_of(last, p)));
  }
}

}  // namespace

std::vector<TilePatch> patches_of_facets(const std::vector<TileFacet>& facets, TileFacets how) {
  std::vector<Quadrilateral> quadrilaterals;
  std::vector<TileFacet> triangles;
  FacetJoiner(facets).run(quadrilaterals, triangles);
  std::vector<TilePatch> out;
  if (triangles.empty()) how = TileFacets::kFewest;  // all patches are quadrilaterals
  for (const Quadrilateral& q : quadrilaterals) {
    if (how == TileFacets::kFewest)
      out.push_back(bilinear(q[0], q[1], q[2], q[3]));
    else
      add_parts({q.begin(), q.end()}, out);
  }
  for (const TileFacet& t : triangles) {
    if (how == TileFacets::kQuadrilaterals) {
      add_parts({t.corners.begin(), t.corners.end()}, out);
      continue;
    }
    // The side at the greatest corner is collapsed, so that triangles that face each other are equal.
    std::array<TilePoint, 3> c = t.corners;
    std::rotate(c.begin(), std::next(std::max_element(c.begin(), c.end())), c.end());
    out.push_back(bilinear(c[0], c[1], c[2], c[2]));
  }
  return out;
}

}  // namespace veritope::internal
