// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/dms/fit/fit_mesh.h"

#include <algorithm>

namespace veritope {
namespace {

std::array<double, 3> rounded(const DmsPoint& p) {
  return {nearest_double(p[0]), nearest_double(p[1]), nearest_double(p[2])};
}

bool has(const TetrahedronCorners& t, std::uint32_t v) {
  return std::find(t.begin(), t.end(), v) != t.end();
}

}  // namespace

FitMesh::FitMesh(std::vector<DmsPoint> vertices, std::vector<TetrahedronCorners> tetrahedra)
    : vertices_(std::move(vertices)),
      tetrahedra_(std::move(tetrahedra)),
      at_vertex_(vertices_.size()) {
  for (const DmsPoint& p : vertices_) rounded_.push_back(rounded(p));
  for (std::uint32_t t = 0; t < tetrahedra_.size(); ++t)
    for (const std::uint32_t v : tetrahedra_[t]) at_vertex_[v].push_back(t);
}

FitMesh::Length FitMesh::length(std::uint32_t a, std::uint32_t b) const {
  Length out{0, std::minmax(a, b)};
  for (std::size_t c = 0; c < 3; ++c) {
    const double d = rounded_[a][c] - rounded_[b][c];
    out.square += d * d;
  }
  return out;
}

FitMesh::Length FitMesh::longest(std::uint32_t tetrahedron) const {
  const TetrahedronCorners& t = tetrahedra_[tetrahedron];
  Length most = length(t[0], t[1]);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j) most = std::max(most, length(t[i], t[j]));
  return most;
}

std::vector<std::uint32_t> FitMesh::tetrahedra_at(const Edge& edge) const {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t t : at_vertex_[edge.first])
    if (has(tetrahedra_[t], edge.second)) out.push_back(t);
  std::sort(out.begin(), out.end());
  return out;
}

bool FitMesh::refine(std::uint32_t tetrahedron, std::size_t most) {
  return cut(longest(tetrahedron), most);
}

// Each call for another edge is for a longer one, so the recursion ends.
bool FitMesh::cut(const Length& edge, std::size_t most) {
  for (;;) {
    const std::vector<std::uint32_t> around = tetrahedra_at(edge.edge);
    Length worst = edge;
    for (const std::uint32_t t : around) worst = std::max(worst, longest(t));
    if (edge < worst) {
      if (!cut(worst, most)) return false;
      continue;
    }
    if (tetrahedra_.size() + around.size() > most) return false;
    halve(edge.edge, around);
    return true;
  }
}

void FitMesh::halve(const Edge& edge, const std::vector<std::uint32_t>& tetrahedra) {
  const auto middle = static_cast<std::uint32_t>(vertices_.size());
  DmsPoint at;
  for (std::size_t c = 0; c < 3; ++c)
    at[c] = (vertices_[edge.first][c] + vertices_[edge.second][c]) / Rational(2);
  rounded_.push_back(rounded(at));
  vertices_.push_back(std::move(at));
  at_vertex_.emplace_back();
  for (const std::uint32_t t : tetrahedra) {
    TetrahedronCorners& old = tetrahedra_[t];
    TetrahedronCorners other = old;
    std::replace(old.begin(), old.end(), edge.second, middle);
    std::replace(other.begin(), other.end(), edge.first, middle);
    std::erase(at_vertex_[edge.second], t);
    at_vertex_[middle].push_back(t);
    const auto number = static_cast<std::uint32_t>(tetrahedra_.size());
    for (const std::uint32_t v : other) at_vertex_[v].push_back(number);
    tetrahedra_.push_back(other);
  }
}

}  // namespace veritope
