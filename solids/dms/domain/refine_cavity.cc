// SPDX-License-Identifier: LGPL-3.0-or-later
// The cavity of a new vertex. Why the cone over its shell fills it, exactly: seen from the vertex, every outer face has
// its inner side in front, or is in a plane with the vertex. So a ray from the vertex can leave the cavity, but never
// enters it, and the tetrahedra of the cone overlap nowhere.
#include <algorithm>
#include <unordered_set>

#include "predicates/exact_in_sphere.h"
#include "solids/dms/domain/refine_mesh.h"

namespace veritope {
namespace {

constexpr std::size_t kMostTetrahedra = 4000;  // of a cavity beyond those that contain the point

class CavitySearch {
 public:
  CavitySearch(const RefineMesh& mesh, const ExactPoint3& p) : mesh_(mesh), p_(p) {}

  std::optional<RefineCavity> run(std::uint32_t t) {
    if (!take_base(t)) return std::nullopt;
    grow();
    while (shrink()) {
    }
    RefineCavity out{ball_, {}, {}};
    for (const TetrahedronFace f : outer_faces())
      (mesh_.side(f, p_) == Sign::kZero ? out.opened : out.shell).push_back(f);
    return out;
  }

 private:
  // All tetrahedra that contain the point, and the facets that do. False if it is a vertex.
  bool take_base(std::uint32_t first) {
    add(first);
    for (std::size_t i = 0; i < ball_.size(); ++i) {
      int zeros = 0;
      for (TetrahedronFace f = 4 * ball_[i]; f < 4 * ball_[i] + 4; ++f) {
        if (mesh_.side(f, p_) != Sign::kZero) continue;
        ++zeros;
        if (mesh_.is_on_boundary(f))
          facets_.push_back(mesh_.facet(f));
        else
          add(face_tetrahedron(mesh_.complex().across(f)));
      }
      if (zeros > 2) return false;
    }
    base_ = in_ball_;
    return true;
  }

  void add(std::uint32_t t) {
    if (in_ball_.insert(t).second) ball_.push_back(t);
  }

  void grow() {
    const auto& points = mesh_.points();
    std::unordered_set<std::uint32_t> seen = in_ball_;
    for (std::size_t i = 0; i < ball_.size() && ball_.size() < kMostTetrahedra + base_.size(); ++i)
      for (TetrahedronFace f = 4 * ball_[i]; f < 4 * ball_[i] + 4; ++f) {
        if (mesh_.is_on_boundary(f)) continue;
        const std::uint32_t u = face_tetrahedron(mesh_.complex().across(f));
        if (!seen.insert(u).second) continue;
        const TetrahedronCorners& c = mesh_.complex().corners(u);
        if (in_sphere(points[c[0]], points[c[1]], points[c[2]], points[c[3]], p_) ==
            Sign::kPositive)
          add(u);
      }
  }

  bool is_outer(TetrahedronFace f) const {
    return mesh_.is_on_boundary(f) ||
           !in_ball_.contains(face_tetrahedron(mesh_.complex().across(f)));
  }
  std::vector<TetrahedronFace> outer_faces() const {
    std::vector<TetrahedronFace> out;
    for (const std::uint32_t t : ball_)
      for (TetrahedronFace f = 4 * t; f < 4 * t + 4; ++f)
        if (is_outer(f)) out.push_back(f);
    return out;
  }

  // Whether a face in a plane with the point may be opened: it is on a facet that contains the point, and no edge
  // would become a part of a longer one.
  bool may_open(TetrahedronFace f) const {
    if (!mesh_.is_on_boundary(f) ||
        std::find(facets_.begin(), facets_.end(), mesh_.facet(f)) == facets_.end())
      return false;
    const auto v = mesh_.complex().vertices(f);
    for (std::size_t k = 0; k < 3; ++k)
      if (place_on_line(mesh_.points()[v[k]], mesh_.points()[v[(k + 1) % 3]], p_) ==
          LinePlace::kBeyond)
        return false;
    return true;
  }

  // Takes tetrahedra away that have an outer face which the point does not see from inside, or whose corner no
  // tetrahedron of the cone would have. Those that contain the point stay: their faces are all seen.
  bool shrink() {
    std::unordered_set<std::uint32_t> gone, kept;
    for (const TetrahedronFace f : outer_faces()) {
      const std::uint32_t t = face_tetrahedron(f);
      if (gone.contains(t)) continue;
      const Sign side = mesh_.side(f, p_);
      if (side == Sign::kPositive) {
        for (const std::uint32_t v : mesh_.complex().vertices(f)) kept.insert(v);
      } else if (!base_.contains(t) && (side == Sign::kNegative || !may_open(f))) {
        gone.insert(t);
      }
    }
    if (gone.empty())
      for (const std::uint32_t t : ball_) {
        const TetrahedronCorners& c = mesh_.complex().corners(t);
        if (!base_.contains(t) &&
            std::any_of(c.begin(), c.end(), [&](std::uint32_t v) { return !kept.contains(v); }))
          gone.insert(t);
      }
    for (const std::uint32_t t : gone) in_ball_.erase(t);
    std::erase_if(ball_, [&](std::uint32_t t) { return gone.contains(t); });
    return !gone.empty();
  }

  const RefineMesh& mesh_;
  const ExactPoint3& p_;
  std::vector<std::uint32_t> ball_, facets_;
  std::unordered_set<std::uint32_t> in_ball_, base_;
};

}  // namespace

std::optional<RefineCavity> RefineMesh::find_cavity(const ExactPoint3& p, std::uint32_t t) const {
  return CavitySearch(*this, p).run(t);
}

}  // namespace veritope
