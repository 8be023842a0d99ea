// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/tetrahedra/boundary_classes.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numbers>
#include <set>

#include "predicates/distance.h"
#include "solids/tetrahedra/tetrahedron_angles.h"

namespace veritope {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<bool> boundary_vertices(const TetrahedralComplex& complex) {
  std::vector<bool> out(complex.num_vertices());
  for (const TetrahedronFace f : complex.boundary())
    for (const std::uint32_t v : complex.vertices(f)) out[v] = true;
  return out;
}

// The other ends of the feature edges at each vertex, ascending.
std::map<std::uint32_t, std::vector<std::uint32_t>> ends_of(
    std::span<const std::array<std::uint32_t, 2>> edges) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> out;
  for (const auto& [a, b] : edges) {
    out[a].push_back(b);
    out[b].push_back(a);
  }
  for (auto& [v, ends] : out) std::sort(ends.begin(), ends.end());
  return out;
}

}  // namespace

const char* class_name(VertexClass c) {
  switch (c) {
    case VertexClass::kInterior: return "interior";
    case VertexClass::kSmooth: return "smooth";
    case VertexClass::kCurve: return "curve";
    default: return "corner";
  }
}

std::vector<double> approx_solid_angles(std::span<const ExactPoint3> points,
                                        const TetrahedralComplex& complex) {
  const std::vector<bool> is_boundary = boundary_vertices(complex);
  std::vector<double> out(complex.num_vertices(), 4 * kPi);
  for (std::uint32_t v = 0; v < complex.num_vertices(); ++v) {
    if (!is_boundary[v]) continue;
    out[v] = 0;
    for (const std::uint32_t t : complex.tetrahedra_at(v)) {
      const TetrahedronCorners& c = complex.tetrahedra()[t];
      const auto corner = static_cast<std::size_t>(std::find(c.begin(), c.end(), v) - c.begin());
      out[v] += approx_solid_angle(
          shape_of({&points[c[0]], &points[c[1]], &points[c[2]], &points[c[3]]}), corner);
    }
  }
  return out;
}

VertexClass class_by_solid_angle(double solid_angle) {
  constexpr double kSlack = 0x1p-40;
  const double least = std::min(solid_angle, 4 * kPi - solid_angle);
  if (least <= kPi / 2 + kSlack) return VertexClass::kCorner;
  return least <= 3 * kPi / 2 + kSlack ? VertexClass::kCurve : VertexClass::kSmooth;
}

std::vector<std::array<std::uint32_t, 2>> feature_edges(std::span<const ExactPoint3> points,
                                                        const TetrahedralComplex& complex,
                                                        const Rational& squared_cosine) {
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> opposite;  // to directed edges
  for (const TetrahedronFace f : complex.boundary()) {
    const auto v = complex.vertices(f);
    for (std::size_t i = 0; i < 3; ++i) opposite[{v[i], v[(i + 1) % 3]}] = v[(i + 2) % 3];
  }
  std::vector<std::array<std::uint32_t, 2>> out;
  for (const auto& [edge, c] : opposite) {
    const auto& [a, b] = edge;
    if (a > b) continue;
    const std::uint32_t d = opposite.at({b, a});
    if (folds_more(points[a], points[b], points[c], points[d], squared_cosine)) out.push_back(edge);
  }
  return out;
}

std::vector<VertexClass> classes_by_features(std::span<const ExactPoint3> points,
                                             const TetrahedralComplex& complex,
                                             std::span<const std::array<std::uint32_t, 2>> edges,
                                             const Rational& squared_cosine) {
  std::vector<VertexClass> out(complex.num_vertices(), VertexClass::kInterior);
  for (const TetrahedronFace f : complex.boundary())
    for (const std::uint32_t v : complex.vertices(f)) out[v] = VertexClass::kSmooth;
  for (const auto& [v, ends] : ends_of(edges)) {
    const bool is_curve = ends.size() == 2 &&
                          !turns_more(points[ends[0]], points[v], points[ends[1]], squared_cosine);
    out[v] = is_curve ? VertexClass::kCurve : VertexClass::kCorner;
  }
  return out;
}

std::vector<std::vector<std::uint32_t>> feature_lines(
    std::span<const std::array<std::uint32_t, 2>> edges, std::span<const VertexClass> classes) {
  const auto ends = ends_of(edges);
  std::set<std::array<std::uint32_t, 2>> rest(edges.begin(), edges.end());
  const auto take = [&](std::uint32_t a, std::uint32_t b) {
    return rest.erase({std::min(a, b), std::max(a, b)}) > 0;
  };
  std::vector<std::vector<std::uint32_t>> open, closed;
  // From an edge on, through vertices with two edges, to a corner or back to the beginning.
  const auto follow = [&](std::uint32_t from, std::uint32_t to) {
    std::vector<std::uint32_t> line{from, to};
    while (line.back() != from && classes[line.back()] == VertexClass::kCurve) {
      const auto& next = ends.at(line.back());
      const std::uint32_t before = line[line.size() - 2];
      line.push_back(next[0] == before ? next[1] : next[0]);
      take(line[line.size() - 2], line.back());
    }
    return line;
  };
  for (const auto& [v, others] : ends)
    if (classes[v] == VertexClass::kCorner)
      for (const std::uint32_t w : others)
        if (take(v, w)) open.push_back(follow(v, w));
  while (!rest.empty()) {
    const auto [a, b] = *rest.begin();
    take(a, b);
    closed.push_back(follow(a, b));
  }
  std::sort(open.begin(), open.end());
  std::sort(closed.begin(), closed.end());
  open.insert(open.end(), closed.begin(), closed.end());
  return open;
}

}  // namespace veritope
