// SPDX-License-Identifier: LGPL-3.0-or-later
// By separating axes: two convex polygons, segments or boxes are disjoint iff their projections are, to one of the
// normals of their faces, products of their edges' directions, or, in a plane, normals of edges.
#include "solids/star_box/mesh_box.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "interval/ring_numbers.h"
#include "interval/upward.h"

namespace veritope {
namespace {

using Id = PieceForest::Id;

bool is_less(const Rational& a, const Rational& b) { return a < b; }
bool is_less(const Interval& a, const Interval& b) { return a.hi() < b.lo(); }  // certainly
bool is_positive(const Rational& a) { return a.sign() == Sign::kPositive; }
bool is_positive(const Interval& a) { return a.lo() > 0; }
bool is_nonzero(const Rational& a) { return a.sign() != Sign::kZero; }
bool is_nonzero(const Interval& a) { return a.lo() > 0 || a.hi() < 0; }

// In rationals every answer is exact; in intervals true is certain. K: Interval (in a ScopedUpward) or Rational.
template <typename K>
struct Separation {
  using Vec = std::array<K, 3>;
  using Points = std::vector<Vec>;

  static Vec minus(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static K dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static bool is_vector(const Vec& a) {
    return is_nonzero(a[0]) || is_nonzero(a[1]) || is_nonzero(a[2]);
  }
  // The values of d on p all lie below those on q.
  static bool is_below(const Vec& d, const Points& p, const Points& q) {
    for (const Vec& a : p) {
      const K at_a = dot(d, a);
      for (const Vec& b : q)
        if (!is_less(at_a, dot(d, b))) return false;
    }
    return true;
  }
  static bool separates(const Vec& d, const Points& p, const Points& q) {
    return is_below(d, p, q) || is_below(d, q, p);
  }

  struct Triangle {
    explicit Triangle(Points corners) : v(std::move(corners)) {
      for (std::size_t i = 0; i < 3; ++i) edges.push_back(minus(v[(i + 1) % 3], v[i]));
      normal = cross(edges[0], minus(v[2], v[0]));
    }
    Points v, edges;
    Vec normal;
  };

  // From a plane polygon, or a segment, with these edges; `normal` of the polygon, if it is one.
  static bool is_apart(const Triangle& t, const Points& q, const Points& edges, const Vec* normal) {
    if (separates(t.normal, t.v, q) || (normal != nullptr && separates(*normal, t.v, q)))
      return true;
    for (const Vec& f : edges) {
      for (const Vec& g : t.edges)
        if (separates(cross(g, f), t.v, q)) return true;
      if (separates(cross(normal != nullptr ? *normal : t.normal, f), t.v, q)) return true;
    }
    for (const Vec& g : t.edges)
      if (separates(cross(t.normal, g), t.v, q)) return true;
    return false;
  }
  static bool misses_box(const Triangle& t, const Points& corners) {
    if (separates(t.normal, t.v, corners)) return true;
    for (std::size_t k = 0; k < 3; ++k) {
      Vec axis{K(0), K(0), K(0)};
      axis[k] = K(1);
      if (separates(axis, t.v, corners)) return true;
      for (const Vec& e : t.edges)
        if (separates(cross(axis, e), t.v, corners)) return true;
    }
    return false;
  }
};

// One of the triangles that a flat patch consists of.
struct Facet {
  std::uint32_t patch;
  std::array<std::uint32_t, 3> corners;  // of the patch
  std::array<std::uint64_t, 3> edges;    // of X, or the patch's diagonal; edge i starts at corner i
};
constexpr std::uint64_t kDiagonal = std::uint64_t{1} << 32;  // above the numbers of edges

void append_facets(const PatchComplex& complex, std::uint32_t patch, std::vector<Facet>* out) {
  const auto edge = [&](std::uint32_t side) -> std::uint64_t {
    return complex.edge({patch, side});
  };
  if (complex.patch(patch).is_triangle())
    return out->push_back({patch, {0, 1, 2}, {edge(0), edge(1), edge(2)}});
  const std::uint64_t diagonal = kDiagonal + patch;
  out->push_back({patch, {0, 1, 2}, {edge(0), edge(1), diagonal}});
  out->push_back({patch, {0, 2, 3}, {diagonal, edge(2), edge(3)}});
}

class MeshBox {
 public:
  MeshBox(PieceForest& forest, FlatPatches& flat, const Box3d& box, std::size_t most)
      : forest_(forest), flat_(flat), box_(box), most_(most) {}

  std::optional<std::vector<std::uint32_t>> run() {
    bool is_good = true;
    forest_.roots().visit(
        [&](const Box3d& b) { return is_good && meets(b, box_); },
        [&](std::uint32_t number) { is_good = is_good && visit(forest_.root(number)); });
    if (!is_good) return std::nullopt;
    // A patch may have several roots.
    std::sort(patches_.begin(), patches_.end());
    patches_.erase(std::unique(patches_.begin(), patches_.end()), patches_.end());
    for (const std::uint32_t patch : patches_)
      append_facets(forest_.complex(), patch, &candidates_);
    if (!decide<Interval>() && !decide<Rational>()) return std::nullopt;
    std::vector<std::uint32_t> out;
    for (const Facet& f : tested_)
      if (out.empty() || out.back() != f.patch) out.push_back(f.patch);
    return out;
  }

 private:
  static constexpr int kMostVisits = 1000;

  bool visit(Id id) {
    const std::uint32_t patch = forest_.node(id).patch;
    if (!meets(forest_.node(id).hull, box_)) return true;
    if (flat_.contain(patch)) {
      patches_.push_back(patch);
      return patches_.size() <= 4 * most_;
    }
    if (++visits_ > kMostVisits || forest_.node(id).level + 2 >= PieceForest::kMaxLevel ||
        !forest_.may_split(id))
      return false;
    const Id first = forest_.children(id);
    for (Id k = 0; k < 4; ++k)
      if (!visit(first + k)) return false;
    return true;
  }

  template <typename K>
  typename Separation<K>::Triangle triangle(const Facet& facet) const {
    const Patch& patch = forest_.complex().patch(facet.patch);
    typename Separation<K>::Points corners;
    for (const std::uint32_t corner : facet.corners) {
      const std::size_t at = patch.side_index(corner, 0);
      typename Separation<K>::Vec v;
      for (std::size_t k = 0; k < 3; ++k) {
        const Rational x = forest_.in_frame(k, patch.component(static_cast<int>(k))[at]);
        if constexpr (std::is_same_v<K, Rational>)
          v[k] = x;
        else
          v[k] = enclose(x);
      }
      corners.push_back(v);
    }
    return typename Separation<K>::Triangle(std::move(corners));
  }

  template <typename K>
  typename Separation<K>::Points corners_of_box() const {
    typename Separation<K>::Points out;
    for (std::size_t i = 0; i < 8; ++i) {
      typename Separation<K>::Vec v;
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = (i >> k & 1) != 0 ? box_.hi[k] : box_.lo[k];
        if constexpr (std::is_same_v<K, Rational>)
          v[k] = Rational::from_double(x);
        else
          v[k] = Interval(x);
      }
      out.push_back(v);
    }
    return out;
  }

  template <typename K>
  bool decide() {
    using S = Separation<K>;
    const ScopedUpward upward;
    const typename S::Points corners = corners_of_box<K>();
    std::vector<typename S::Triangle> triangles;
    tested_.clear();
    for (const Facet& facet : candidates_) {
      typename S::Triangle t = triangle<K>(facet);
      if (!S::is_vector(t.normal)) return false;
      if (S::misses_box(t, corners)) continue;
      triangles.push_back(std::move(t));
      tested_.push_back(facet);
    }
    if (tested_.size() > most_) return false;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!meet_properly<K>(triangles[i], triangles[j], tested_[i], tested_[j])) return false;
    return true;
  }

  template <typename K>
  bool meet_properly(const typename Separation<K>::Triangle& t,
                     const typename Separation<K>::Triangle& u, const Facet& a,
                     const Facet& b) const {
    using S = Separation<K>;
    const PatchComplex& complex = forest_.complex();
    int vertices = 0, edges = 0;
    std::size_t at_t = 0, at_u = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        if (complex.vertex({a.patch, a.corners[i]}) == complex.vertex({b.patch, b.corners[j]}))
          ++vertices, at_t = i, at_u = j;
        if (a.edges[i] == b.edges[j]) ++edges;
      }
    if (vertices == 0) return S::is_apart(t, u.v, u.edges, &u.normal);
    const auto opposite_edge_misses = [](const auto& x, std::size_t corner, const auto& y) {
      const std::size_t from = (corner + 1) % 3;
      return S::is_apart(y, {x.v[from], x.v[(from + 1) % 3]}, {x.edges[from]}, nullptr);
    };
    if (vertices == 1) return opposite_edge_misses(t, at_t, u) && opposite_edge_misses(u, at_u, t);
    if (vertices != 2 || edges != 1) return false;
    // In one plane: with opposite directions on the common edge, normals that agree are different sides.
    return S::is_vector(S::cross(t.normal, u.normal)) || is_positive(S::dot(t.normal, u.normal));
  }

  PieceForest& forest_;
  FlatPatches& flat_;
  const Box3d box_;
  const std::size_t most_;
  int visits_ = 0;
  std::vector<std::uint32_t> patches_;
  std::vector<Facet> candidates_, tested_;
};

}  // namespace

std::optional<std::vector<std::uint32_t>> mesh_box_patches(PieceForest& forest, FlatPatches& flat,
                                                           const Box3d& box, std::size_t most) {
  return MeshBox(forest, flat, box, most).run();
}

}  // namespace veritope
