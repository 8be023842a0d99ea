// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/dms_hulls.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "solids/dms/dms_core.h"

namespace veritope {
namespace {

using Points = std::vector<DmsPoint>;

// The plane of this direction that has the hull on one closed side and the tetrahedron on the other, if there is one.
std::optional<DmsPlane> parting(const DmsPoint& vector, const Points& hull,
                                const std::array<DmsPoint, 4>& corners) {
  if (vector == DmsPoint{}) return std::nullopt;
  const auto range = [&](const auto& points) {
    std::pair<Rational, Rational> out{dot_product(vector, points[0]), {}};
    out.second = out.first;
    for (const DmsPoint& p : points) {
      const Rational x = dot_product(vector, p);
      out.first = std::min(out.first, x);
      out.second = std::max(out.second, x);
    }
    return out;
  };
  const auto [low, high] = range(hull);
  const auto [first, last] = range(corners);
  if (high <= first) return DmsPlane{vector, first};
  if (last <= low) return DmsPlane{vector, last};
  return std::nullopt;
}

// Two polytopes with inner points that can be parted by a plane can be by one of the directions of a face of either
// one, or normal to an edge of each.
std::optional<DmsPlane> find_parting(const Points& hull, const std::array<DmsPoint, 4>& corners) {
  Points edges_of_hull, edges;
  for (std::size_t i = 0; i < hull.size(); ++i)
    for (std::size_t j = i + 1; j < hull.size(); ++j)
      edges_of_hull.push_back(difference(hull[j], hull[i]));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) edges.push_back(difference(corners[j], corners[i]));
  for (std::size_t i = 0; i < edges_of_hull.size(); ++i) {
    for (const DmsPoint& e : edges)
      if (auto plane = parting(cross_product(edges_of_hull[i], e), hull, corners)) return plane;
    for (std::size_t j = i + 1; j < edges_of_hull.size(); ++j)
      if (auto plane = parting(cross_product(edges_of_hull[i], edges_of_hull[j]), hull, corners))
        return plane;
  }
  return std::nullopt;
}

class HullParting {
 public:
  HullParting(const DmsModel& model, const TetrahedralComplex& complex)
      : model_(model), complex_(complex), knots_(model) {}

  std::variant<std::vector<std::vector<DmsPlane>>, DmsOpenHull> run() {
    std::vector<std::vector<DmsPlane>> out;
    for (const TetrahedronFace f : complex_.boundary()) {
      planes_.clear();
      if (const auto open = part_face(f)) return DmsOpenHull{f, *open};
      out.push_back(std::move(planes_));
    }
    return out;
  }

 private:
  std::optional<std::uint32_t> part_face(TetrahedronFace f) {
    const auto v = complex_.vertices(f);
    const int sum = model_.condition_degree();
    for (int j = sum; j >= 0; --j)
      for (int k = sum - j; k >= 0; --k)
        if (auto open = part_hull(hull_of(v, {j, k, sum - j - k}))) return open;
    return std::nullopt;
  }
  // Empty if all knots are the vertices themselves.
  std::vector<std::uint32_t> hull_of(const std::array<std::uint32_t, 3>& v,
                                     const std::array<int, 3>& last) const {
    std::vector<std::uint32_t> out;
    bool has_more = false;
    for (std::size_t m = 0; m < 3; ++m)
      for (int i = 0; i <= last[m]; ++i) {
        out.push_back(knots_.number(v[m], i));
        has_more |= out.back() != knots_.number(v[m], 0);
      }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return has_more ? out : std::vector<std::uint32_t>{};
  }
  std::optional<std::uint32_t> part_hull(const std::vector<std::uint32_t>& hull) {
    if (hull.empty()) return std::nullopt;
    Points points;
    for (const std::uint32_t k : hull) points.push_back(knots_.point(k));
    for (const std::uint32_t t : knots_.tetrahedra_near(box_around(points))) {
      const std::array<DmsPoint, 4> corners = knots_.corners(t);
      std::vector<DmsPlane> planes = face_planes(corners);
      planes.insert(planes.end(), planes_.begin(), planes_.end());
      if (DmsRegion(knots_, {corners.begin(), corners.end()}, planes).misses(hull)) continue;
      // Planes of edges and faces have short numbers.
      auto plane = find_parting(points, corners);
      if (!plane) {
        auto parted = part_from_tetrahedron(points, corners);
        if (parted.index() == 1) return t;
        plane = std::get<DmsPlane>(std::move(parted));
      }
      planes_.push_back(std::move(*plane));
    }
    return std::nullopt;
  }

  const DmsModel& model_;
  const TetrahedralComplex& complex_;
  DmsKnotTable knots_;
  std::vector<DmsPlane> planes_;  // of the face
};

}  // namespace

std::optional<std::uint32_t> find_disagreeing_control(const DmsModel& model, std::size_t component,
                                                      std::size_t count) {
  std::map<std::vector<std::uint32_t>, std::size_t> first;
  std::optional<std::uint32_t> found;
  for (std::uint32_t t = 0; t < model.tetrahedra.size() && !found; ++t)
    for_each_tetrahedral_index(model.degree, [&](const TetrahedralIndex& beta) {
      const std::size_t here = control_of(model, t, beta);
      const auto [at, is_new] = first.emplace(control_vertices(model.tetrahedra[t], beta), here);
      const auto a = model.value(here).subspan(component, count),
                 b = model.value(at->second).subspan(component, count);
      if (!is_new && !std::equal(a.begin(), a.end(), b.begin())) found = t;
    });
  return found;
}

std::variant<std::vector<std::vector<DmsPlane>>, DmsOpenHull> part_hulls(
    const DmsModel& model, const TetrahedralComplex& complex) {
  return HullParting(model, complex).run();
}

}  // namespace veritope
