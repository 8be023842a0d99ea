// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/preorder_internal.h: trees of four children a node, in preorder. Internal to verify/format.
#pragma once
#include <array>
#include <cstddef>

namespace veritope::certificate::internal {

inline constexpr int kMostLevels = 24;

/// Walks through one tree whose root has level `root`. is_leaf(level) reads the next symbol; go_on() is called before
/// each symbol.
/// @return false if a node that is no leaf lies on the last level, or if go_on() was false
template <class IsLeaf, class GoOn>
bool each_node(int root, IsLeaf is_leaf, GoOn go_on) {
  std::array<int, kMostLevels + 2> open{};
  open[static_cast<std::size_t>(root)] = 1;
  for (int level = root; level >= root;) {
    int& left = open[static_cast<std::size_t>(level)];
    if (left == 0) {
      --level;
      continue;
    }
    if (!go_on()) return false;
    --left;
    if (is_leaf(level)) continue;
    if (level == kMostLevels) return false;
    open[static_cast<std::size_t>(++level)] = 4;
  }
  return true;
}

}  // namespace veritope::certificate::internal
