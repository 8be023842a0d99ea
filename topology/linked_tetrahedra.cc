// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/linked_tetrahedra.h"

#include <algorithm>
#include <utility>

#include "robust/base/check.h"

namespace veritope {
namespace {

struct KeyedFace {
  std::array<std::uint32_t, 3> vertices;  // ascending
  TetrahedronFace face;
  friend auto operator<=>(const KeyedFace&, const KeyedFace&) = default;
};

// Glues faces with equal keys.
void glue_equal(std::vector<KeyedFace>& faces, LinkedTetrahedra& tetrahedra) {
  std::sort(faces.begin(), faces.end());
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (faces[i].vertices == faces[i - 1].vertices)
      tetrahedra.glue(faces[i].face, faces[i - 1].face);
}

}  // namespace

std::array<std::uint32_t, 3> LinkedTetrahedra::vertices(TetrahedronFace f) const {
  const TetrahedronCorners& t = cells_[face_tetrahedron(f)].corners;
  const auto& face = kTetrahedronFaces[face_corner(f)];
  return {t[face[0]], t[face[1]], t[face[2]]};
}

std::uint32_t LinkedTetrahedra::add(const TetrahedronCorners& corners) {
  const Cell cell{corners, {kNoFace, kNoFace, kNoFace, kNoFace}};
  if (!unused_.empty()) {
    const std::uint32_t t = unused_.back();
    unused_.pop_back();
    cells_[t] = cell;
    return t;
  }
  VT_CHECK(cells_.size() < kMaxSlots, "there are too many tetrahedra");
  cells_.push_back(cell);
  return static_cast<std::uint32_t>(cells_.size() - 1);
}

void LinkedTetrahedra::glue(TetrahedronFace f, TetrahedronFace g) {
  cells_[face_tetrahedron(f)].across[face_corner(f)] = g;
  cells_[face_tetrahedron(g)].across[face_corner(g)] = f;
}

void LinkedTetrahedra::glue_all(std::span<const std::uint32_t> tetrahedra) {
  std::vector<KeyedFace> faces;
  for (const std::uint32_t t : tetrahedra)
    for (std::uint32_t m = 0; m < 4; ++m) {
      KeyedFace& face = faces.emplace_back(KeyedFace{vertices(4 * t + m), 4 * t + m});
      std::sort(face.vertices.begin(), face.vertices.end());
    }
  glue_equal(faces, *this);
}

std::uint32_t LinkedTetrahedra::cone(std::span<const std::uint32_t> ball,
                                     std::span<const TetrahedronFace> shell, std::uint32_t apex) {
  take_shell(shell);
  take_slots(ball);
  number_vertices();
  for (const ShellFace& s : shell_) {
    Cell& cell = cells_[s.slot];
    cell.corners = s.corners;
    cell.corners[s.corner] = apex;
    cell.across[s.corner] = s.outer;
    if (s.outer != kNoFace)
      cells_[face_tetrahedron(s.outer)].across[face_corner(s.outer)] = 4 * s.slot + s.corner;
  }
  if (on_shell_.size() <= kManyVertices)
    glue_by_table();
  else
    glue_by_sort();
  return shell_.back().slot;
}

std::vector<std::uint32_t> LinkedTetrahedra::replace_by_cone(std::span<const std::uint32_t> ball,
                                                             std::span<const TetrahedronFace> shell,
                                                             std::uint32_t apex) {
  const auto keyed = [&](std::array<std::uint32_t, 3> v, TetrahedronFace f) {
    std::sort(v.begin(), v.end());
    return KeyedFace{v, f};
  };
  std::vector<KeyedFace> faces;
  std::vector<TetrahedronCorners> cells;
  for (const TetrahedronFace f : shell) {
    const auto v = vertices(f);
    if (across(f) != kNoFace) faces.push_back(keyed(v, across(f)));
    if (std::find(v.begin(), v.end(), apex) != v.end()) continue;
    TetrahedronCorners& cell = cells.emplace_back(corners(face_tetrahedron(f)));
    cell[face_corner(f)] = apex;
  }
  for (const std::uint32_t t : ball) {
    cells_[t].corners[0] = kUnused;
    unused_.push_back(t);
  }
  std::vector<std::uint32_t> added;
  for (const TetrahedronCorners& cell : cells) {
    const std::uint32_t t = add(cell);
    added.push_back(t);
    for (std::uint32_t m = 0; m < 4; ++m) faces.push_back(keyed(vertices(4 * t + m), 4 * t + m));
  }
  glue_equal(faces, *this);
  return added;
}

void LinkedTetrahedra::take_shell(std::span<const TetrahedronFace> shell) {
  shell_.clear();
  for (const TetrahedronFace f : shell) {
    const Cell& cell = cells_[face_tetrahedron(f)];
    shell_.push_back({cell.corners, face_corner(f), cell.across[face_corner(f)], 0});
  }
}

void LinkedTetrahedra::take_slots(std::span<const std::uint32_t> ball) {
  for (const std::uint32_t t : ball) {
    cells_[t].corners[0] = kUnused;
    unused_.push_back(t);
  }
  for (ShellFace& s : shell_) {
    if (unused_.empty()) {
      VT_CHECK(cells_.size() < kMaxSlots, "there are too many tetrahedra");
      s.slot = static_cast<std::uint32_t>(cells_.size());
      cells_.emplace_back();
    } else {
      s.slot = unused_.back();
      unused_.pop_back();
    }
  }
}

void LinkedTetrahedra::number_vertices() {
  on_shell_.clear();
  for (const ShellFace& s : shell_)
    for (const std::uint8_t m : kTetrahedronFaces[s.corner]) {
      const std::uint32_t v = s.corners[m], i = number_[v];
      if (i < on_shell_.size() && on_shell_[i] == v) continue;
      number_[v] = static_cast<std::uint32_t>(on_shell_.size());
      on_shell_.push_back(v);
    }
}

// Each edge of the shell runs in both directions, once in each: the table's entries that are read were written before,
// and the others do not matter.
void LinkedTetrahedra::glue_by_table() {
  const std::size_t stride = on_shell_.size();
  if (by_edge_.size() < stride * stride) by_edge_.resize(stride * stride);
  const auto for_each_edge = [&](auto&& visit) {
    for (const ShellFace& s : shell_) {
      const auto& face = kTetrahedronFaces[s.corner];
      const std::array<std::size_t, 3> at{number_[s.corners[face[0]]], number_[s.corners[face[1]]],
                                          number_[s.corners[face[2]]]};
      visit(at[0], at[1], 4 * s.slot + face[2]);
      visit(at[1], at[2], 4 * s.slot + face[0]);
      visit(at[2], at[0], 4 * s.slot + face[1]);
    }
  };
  for_each_edge(
      [&](std::size_t a, std::size_t b, TetrahedronFace f) { by_edge_[a * stride + b] = f; });
  for_each_edge([&](std::size_t a, std::size_t b, TetrahedronFace f) {
    cells_[face_tetrahedron(f)].across[face_corner(f)] = by_edge_[b * stride + a];
  });
}

void LinkedTetrahedra::glue_by_sort() {
  std::vector<KeyedFace> faces;
  for (const ShellFace& s : shell_)
    for (const std::uint8_t m : kTetrahedronFaces[s.corner]) {
      KeyedFace& face = faces.emplace_back(KeyedFace{vertices(4 * s.slot + m), 4 * s.slot + m});
      std::sort(face.vertices.begin(), face.vertices.end());
    }
  glue_equal(faces, *this);
}

}  // namespace veritope
