// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/domain/small_angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>

#include "predicates/distance.h"

namespace veritope {
namespace {

const Rational kSquaredCosine(Integer(1), Integer(4));  // of 60 degrees

using Direction = std::array<double, 3>;

Direction from_to(const ExactPoint3& a, const ExactPoint3& b) {
  Direction out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = nearest_double(b.at()[k] - a.at()[k]);
  return out;
}
Direction normal_to(const Direction& u, const Direction& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
double degrees_between(const Direction& u, const Direction& v) {
  const Direction n = normal_to(u, v);
  return std::atan2(std::hypot(n[0], n[1], n[2]), u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) * 180 /
         std::numbers::pi;
}

}  // namespace

SmallAngles::SmallAngles(const RefineMesh& mesh) {
  add_segments(mesh);
  add_facets(mesh);
}

void SmallAngles::add_segments(const RefineMesh& mesh) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> ends;
  for (const auto& [edge, facets] : mesh.segments()) {
    ends[edge.first].push_back(edge.second);
    ends[edge.second].push_back(edge.first);
  }
  const auto& p = mesh.points();
  for (const auto& [v, others] : ends)
    for (std::size_t i = 0; i < others.size(); ++i)
      for (std::size_t j = i + 1; j < others.size(); ++j) {
        const std::uint32_t a = others[i], b = others[j];
        if (!is_angle_less(p[a], p[v], p[b], kSquaredCosine)) continue;
        list_.push_back(
            {false, {a, v, b}, degrees_between(from_to(p[v], p[a]), from_to(p[v], p[b]))});
        apexes_.insert(v);
        lines_.insert(std::minmax(mesh.segments().at(std::minmax(v, a)),
                                  mesh.segments().at(std::minmax(v, b))));
      }
}

void SmallAngles::add_facets(const RefineMesh& mesh) {
  std::map<VertexPair, std::vector<TetrahedronFace>> faces;
  for (std::uint32_t t = 0; t < mesh.complex().num_slots(); ++t)
    for (TetrahedronFace f = 4 * t; f < 4 * t + 4; ++f) {
      if (!mesh.complex().is_used(t) || !mesh.is_on_boundary(f)) continue;
      const auto v = mesh.complex().vertices(f);
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexPair edge = std::minmax(v[k], v[(k + 1) % 3]);
        if (mesh.segments().contains(edge)) faces[edge].push_back(f);
      }
    }
  const auto& p = mesh.points();
  for (const auto& [edge, two] : faces) {
    std::array<std::uint32_t, 2> off{};
    for (std::size_t i = 0; i < 2; ++i)
      for (const std::uint32_t v : mesh.complex().vertices(two[i]))
        if (v != edge.first && v != edge.second) off[i] = v;
    // Facets that enclose a small angle outside of the domain have no tetrahedra between them.
    if (mesh.side(two[0], p[off[1]]) != Sign::kPositive ||
        !is_dihedral_less(p[edge.first], p[edge.second], p[off[0]], p[off[1]], kSquaredCosine))
      continue;
    const Direction along = from_to(p[edge.first], p[edge.second]);
    list_.push_back({true,
                     {edge.first, edge.second},
                     degrees_between(normal_to(along, from_to(p[edge.first], p[off[0]])),
                                     normal_to(along, from_to(p[edge.first], p[off[1]])))});
    facets_.insert(mesh.segments().at(edge));
  }
}

bool SmallAngles::is_between(const RefineMesh& mesh, std::uint32_t v, std::uint32_t w) const {
  const auto &f = mesh.facets_at(v), &g = mesh.facets_at(w);
  const auto for_each_pair = [](const std::vector<std::uint32_t>& facets, auto&& is_found) {
    for (std::size_t i = 0; i < facets.size(); ++i)
      for (std::size_t j = i + 1; j < facets.size(); ++j)
        if (is_found(Line(facets[i], facets[j]))) return true;
    return false;
  };
  if (for_each_pair(f, [&](const Line& one) {
        return for_each_pair(
            g, [&](const Line& two) { return lines_.contains(std::minmax(one, two)); });
      }))
    return true;
  std::vector<std::uint32_t> common;
  std::set_intersection(f.begin(), f.end(), g.begin(), g.end(), std::back_inserter(common));
  return common.empty() && std::any_of(f.begin(), f.end(), [&](std::uint32_t i) {
           return std::any_of(g.begin(), g.end(),
                              [&](std::uint32_t j) { return facets_.contains(std::minmax(i, j)); });
         });
}

}  // namespace veritope
