// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/star_walks.h: from each shell a path to infinity that meets the surface in star boxes only, and the
// winding numbers that follow. Theory: docs/THEORY.md §5.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "verify/certify/star_cover.h"

namespace veritope {

/// From a centre of a star box of a shell straight to infinity, or to a centre of a star box of a shell with an earlier
/// walk.
struct ShellWalk {
  std::uint32_t shell = 0, box = 0;
  bool starts_outside = true;  ///< at c+
  std::uint8_t direction = 0;  ///< 0..5: +x -x +y -y +z -z; 6: ends at end_box
  std::uint32_t end_box = 0;
  bool ends_outside = false;
  /// Winding numbers on the two sides of the shell.
  int winding_inside = 0, winding_outside = 0;
  std::uint32_t end_shell = 0;  ///< the shell of end_box
};

/// A walk for every shell, or nothing for those where no free path was found.
struct ShellWalks {
  std::vector<ShellWalk> walks;
  std::vector<std::uint32_t> missing;  ///< shells
  /// The shells of even depth: their unbounded side is their outside. REQUIRES missing is empty.
  std::uint64_t num_bodies() const;
};

/// The shells that must be reversed so that the normals of every shell at even depth, counted from outside, point to
/// its unbounded side, and those of every other shell away from it: then the winding numbers are 1 inside and 0 outside
/// of all shells. Ascending. REQUIRES walks.missing is empty.
std::vector<std::uint32_t> shells_to_reverse(const ShellWalks& walks);

/// True if no closed hull of a piece, split finely enough, meets the closed segment from a to b. False also when the
/// budget is spent.
bool is_free_segment(PieceForest& forest, const Point3d& a, const Point3d& b);

/// REQUIRES cover.is_complete().
ShellWalks find_shell_walks(PieceForest& forest, const StarCover& cover);

}  // namespace veritope
