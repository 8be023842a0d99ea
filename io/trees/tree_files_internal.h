// SPDX-License-Identifier: LGPL-3.0-or-later
// io/trees/tree_files_internal.h: the files that the nodes of a tree name, each read once.
#pragma once
#include <cstddef>
#include <map>
#include <string>

#include "io/splines/number_budget.h"
#include "io/trees/build_tree.h"
#include "solids/volumes/primitives.h"

namespace veritope {

class TreeFiles {
 public:
  /// Both must outlive it. The budget grows by the numbers of each file.
  TreeFiles(const LoadSplines& load, NumberBudget& budget) : load_(load), budget_(budget) {}

  /// The volumes, or the surface, that a node "file" names. @error  the message begins with the key that is wrong
  Result<Cells> volumes(const TreeNode& node);
  Result<CellSurface> surface(const TreeNode& node);

  /// The different files that were read.
  std::size_t count() const { return files_.size(); }

 private:
  Result<const SplineModel*> file_of(const TreeNode& node);

  const LoadSplines& load_;
  NumberBudget& budget_;
  std::map<std::string, SplineModel> files_;
};

}  // namespace veritope
