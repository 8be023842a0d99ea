// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fast/fast_store_internal.h: the tables and regions that are kept, within a limit.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "solids/dms/fast/fast_cells_internal.h"

namespace veritope::internal {

class FastStore {
 public:
  /// All references must outlive this.
  FastStore(const DmsModel& model, const DmsEvaluator& evaluator, FastCells& cells,
            bool with_gradient, std::size_t max_bytes);

  /// What is evaluated inside of a tetrahedron, until the next call; null if a number near it is out of range.
  const FastRegion* region(std::uint32_t tetrahedron);
  /// The greatest control value of a component, rounded up.
  double greatest(std::size_t component) const { return greatest_[component]; }

 private:
  bool is_collapsed(std::uint32_t tetrahedron) const;
  const FastTables* tables(std::uint32_t tetrahedron);
  std::unique_ptr<FastRegion> make_region(std::uint32_t tetrahedron);

  const DmsModel& model_;
  const DmsEvaluator& evaluator_;
  FastCells& cells_;
  bool with_gradient_;
  std::size_t max_bytes_, bytes_ = 0;
  std::vector<double> greatest_;
  bool is_in_range_ = true;
  std::unordered_map<std::uint32_t, std::unique_ptr<FastTables>> tables_;
  std::unordered_map<std::uint32_t, std::unique_ptr<FastRegion>> regions_;
};

}  // namespace veritope::internal
