// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/linked_tetrahedra.h: tetrahedra with vertex ids that know the faces they are glued to, for algorithms that
// replace some of them at a time. Integers only, no coordinates.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "topology/tetrahedral_complex.h"

namespace veritope {

/// Tetrahedra in numbered slots. A slot whose tetrahedron is removed is used again.
class LinkedTetrahedra {
 public:
  /// Across a face that is glued to none.
  static constexpr TetrahedronFace kNoFace = 0xffffffffu;
  /// So many slots have faces below kNoFace.
  static constexpr std::size_t kMaxSlots = (std::size_t{1} << 30) - 1;

  explicit LinkedTetrahedra(std::uint32_t num_vertices) : number_(num_vertices) {}

  std::size_t num_slots() const { return cells_.size(); }
  std::size_t num_tetrahedra() const { return cells_.size() - unused_.size(); }
  bool is_used(std::uint32_t t) const { return cells_[t].corners[0] != kUnused; }
  /// REQUIRES is_used(t).
  const TetrahedronCorners& corners(std::uint32_t t) const { return cells_[t].corners; }
  /// The face that f is glued to: the same vertices in the opposite orientation; or kNoFace.
  TetrahedronFace across(TetrahedronFace f) const {
    return cells_[face_tetrahedron(f)].across[face_corner(f)];
  }
  /// The vertices of a face in the order of kTetrahedronFaces.
  std::array<std::uint32_t, 3> vertices(TetrahedronFace f) const;

  /// A tetrahedron whose faces are glued to none. REQUIRES four different vertices that exist, fewer than kMaxSlots
  /// slots.
  std::uint32_t add(const TetrahedronCorners& corners);
  /// REQUIRES faces with the same vertices in opposite orientations.
  void glue(TetrahedronFace f, TetrahedronFace g);
  /// Glues all faces of these tetrahedra that have the same vertices. REQUIRES that each set of vertices is one face
  /// of them, or two in opposite orientations, all of them glued to none. @cost a sort
  void glue_all(std::span<const std::uint32_t> tetrahedra);

  /// Replaces the tetrahedra `ball` by one over each face of `shell`, in which `apex` is in the place of the corner
  /// opposite to the face. Returns one of them. (The flips 1-4, 2-6 and n-2n, and the insertion of Bowyer and Watson.)
  /// REQUIRES that the shell is all faces of the ball whose partner is not in the ball, and a closed surface: each of
  /// its edges belongs to two of them; that apex is no vertex of the shell; fewer than kMaxSlots slots afterwards.
  /// @cost linear, but for a sort if the shell has more than kManyVertices vertices
  std::uint32_t cone(std::span<const std::uint32_t> ball, std::span<const TetrahedronFace> shell,
                     std::uint32_t apex);
  static constexpr std::size_t kManyVertices = 256;
  /// The general form: the apex may be a vertex of the shell, whose faces at the apex have no new tetrahedron, and
  /// faces may be left out of `shell` that lie on the boundary, in a plane with the apex; the new faces there are glued
  /// to none. Returns the new tetrahedra.
  /// REQUIRES a shell as above, but for those faces; at least one face without the apex. @cost a sort
  std::vector<std::uint32_t> replace_by_cone(std::span<const std::uint32_t> ball,
                                             std::span<const TetrahedronFace> shell,
                                             std::uint32_t apex);

 private:
  static constexpr std::uint32_t kUnused = 0xffffffffu;
  struct Cell {
    TetrahedronCorners corners;
    std::array<TetrahedronFace, 4> across;
  };
  struct ShellFace {
    TetrahedronCorners corners;
    std::uint32_t corner;  // opposite to the face
    TetrahedronFace outer;
    std::uint32_t slot;  // of the new tetrahedron
  };

  void take_shell(std::span<const TetrahedronFace> shell);
  void take_slots(std::span<const std::uint32_t> ball);
  void number_vertices();
  void glue_by_table();
  void glue_by_sort();

  std::vector<Cell> cells_;
  std::vector<std::uint32_t> unused_;
  // Working memory of cone(): a vertex v of the shell is numbered i = number_[v] if i < on_shell_.size() and
  // on_shell_[i] = v; the rest of number_ has any value.
  std::vector<ShellFace> shell_;
  std::vector<std::uint32_t> number_, on_shell_;
  std::vector<TetrahedronFace> by_edge_;
};

}  // namespace veritope
