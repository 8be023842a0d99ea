// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/tetrahedral_complex.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "robust/base/check.h"

namespace veritope {
namespace {

// A face with its vertices in ascending order.
struct SortedFace {
  std::array<std::uint32_t, 3> vertices;
  TetrahedronFace face;
  bool is_even;  // whether sorting them was an even permutation

  friend bool operator<(const SortedFace& a, const SortedFace& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.face < b.face;
  }
};

SortedFace sorted_face(std::array<std::uint32_t, 3> v, TetrahedronFace face) {
  bool is_even = true;
  const auto order = [&](std::size_t i, std::size_t j) {
    if (v[i] > v[j]) std::swap(v[i], v[j]), is_even = !is_even;
  };
  order(0, 1), order(1, 2), order(0, 1);
  return {v, face, is_even};
}

}  // namespace

TetrahedralComplex::TetrahedralComplex(std::vector<TetrahedronCorners> tetrahedra,
                                       std::uint32_t num_vertices)
    : tetrahedra_(std::move(tetrahedra)), first_(std::size_t{num_vertices} + 1) {
  VT_CHECK(tetrahedra_.size() <= kMaxTetrahedra, "a complex has at most 2^29 tetrahedra");
  for (const TetrahedronCorners& t : tetrahedra_)
    for (std::size_t m = 0; m < 4; ++m) {
      VT_CHECK(t[m] < num_vertices, "the vertices of a tetrahedron exist");
      for (std::size_t n = 0; n < m; ++n)
        VT_CHECK(t[m] != t[n], "a tetrahedron has four different vertices");
    }
  collect_corners();
  pair_faces();
}

void TetrahedralComplex::collect_corners() {
  for (const TetrahedronCorners& t : tetrahedra_)
    for (const std::uint32_t v : t) ++first_[v + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  at_vertex_.resize(4 * tetrahedra_.size());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t t = 0; t < tetrahedra_.size(); ++t)
    for (const std::uint32_t v : tetrahedra_[t]) at_vertex_[next[v]++] = t;
}

void TetrahedralComplex::pair_faces() {
  const auto num_faces = static_cast<TetrahedronFace>(4 * tetrahedra_.size());
  partner_.resize(num_faces);
  std::iota(partner_.begin(), partner_.end(), TetrahedronFace{0});
  std::vector<SortedFace> faces;
  faces.reserve(num_faces);
  for (TetrahedronFace f = 0; f < num_faces; ++f) faces.push_back(sorted_face(vertices(f), f));
  std::sort(faces.begin(), faces.end());
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    while (end < faces.size() && faces[end].vertices == faces[begin].vertices) ++end;
    ++num_triangles_;
    const std::size_t uses = end - begin;
    if (uses == 1) {
      boundary_.push_back(faces[begin].face);
    } else if (uses == 2 && faces[begin].is_even != faces[begin + 1].is_even) {
      partner_[faces[begin].face] = faces[begin + 1].face;
      partner_[faces[begin + 1].face] = faces[begin].face;
    } else {
      FaceOveruse& over = overused_.emplace_back();
      over.vertices = faces[begin].vertices;
      for (std::size_t i = begin; i < end; ++i) over.faces.push_back(faces[i].face);
    }
  }
  std::sort(boundary_.begin(), boundary_.end());
}

std::array<std::uint32_t, 3> TetrahedralComplex::vertices(TetrahedronFace f) const {
  const TetrahedronCorners& t = tetrahedra_[face_tetrahedron(f)];
  const auto& face = kTetrahedronFaces[face_corner(f)];
  return {t[face[0]], t[face[1]], t[face[2]]};
}

std::optional<TetrahedronFace> TetrahedralComplex::partner(TetrahedronFace f) const {
  VT_CHECK(f < partner_.size(), "the face exists");
  if (partner_[f] == f) return std::nullopt;
  return partner_[f];
}

std::vector<std::uint32_t> TetrahedralComplex::tetrahedra_at(std::uint32_t a,
                                                             std::uint32_t b) const {
  VT_CHECK(a < num_vertices() && b < num_vertices() && a != b, "an edge has two vertices");
  if (tetrahedra_at(b).size() < tetrahedra_at(a).size()) std::swap(a, b);
  std::vector<std::uint32_t> both;
  for (const std::uint32_t t : tetrahedra_at(a)) {
    const TetrahedronCorners& corners = tetrahedra_[t];
    if (std::find(corners.begin(), corners.end(), b) != corners.end()) both.push_back(t);
  }
  return both;
}

std::vector<std::array<std::uint32_t, 3>> TetrahedralComplex::link(std::uint32_t v) const {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const std::uint32_t t : tetrahedra_at(v)) {
    const TetrahedronCorners& corners = tetrahedra_[t];
    const auto m = std::find(corners.begin(), corners.end(), v) - corners.begin();
    triangles.push_back(vertices(4 * t + static_cast<std::uint32_t>(m)));
  }
  return triangles;
}

std::vector<std::array<std::uint32_t, 2>> TetrahedralComplex::link(std::uint32_t a,
                                                                   std::uint32_t b) const {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (const std::uint32_t t : tetrahedra_at(a, b)) {
    const TetrahedronCorners& corners = tetrahedra_[t];
    std::array<std::uint32_t, 2> rest{};
    std::size_t count = 0;
    for (const std::uint32_t v : corners)
      if (v != a && v != b) rest[count++] = v;
    if (is_even({a, b, rest[0], rest[1]}) != is_even(corners)) std::swap(rest[0], rest[1]);
    pairs.push_back(rest);
  }
  return pairs;
}

std::array<std::uint64_t, 4> TetrahedralComplex::counts() const {
  std::uint64_t num_used = 0, num_edges = 0;
  std::vector<std::uint32_t> greater;
  for (std::uint32_t v = 0; v < num_vertices(); ++v) {
    const auto at = tetrahedra_at(v);
    num_used += at.empty() ? 0 : 1;
    greater.clear();
    for (const std::uint32_t t : at)
      for (const std::uint32_t w : tetrahedra_[t])
        if (w > v) greater.push_back(w);
    std::sort(greater.begin(), greater.end());
    num_edges +=
        static_cast<std::uint64_t>(std::unique(greater.begin(), greater.end()) - greater.begin());
  }
  return {num_used, num_edges, num_triangles_, tetrahedra_.size()};
}

std::int64_t TetrahedralComplex::euler() const {
  const auto n = counts();
  return static_cast<std::int64_t>(n[0]) - static_cast<std::int64_t>(n[1]) +
         static_cast<std::int64_t>(n[2]) - static_cast<std::int64_t>(n[3]);
}

bool is_even(const TetrahedronCorners& corners) {
  bool even = true;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      if (corners[i] > corners[j]) even = !even;
  return even;
}

}  // namespace veritope
