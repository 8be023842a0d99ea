// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/vmodel_work.h: whether checkers may take a certificate of a V-model: the limits of B2 and the bound on
// work of docs/certificates/vmodel.md.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "solids/base/finding.h"
#include "solids/vmodel/jacobian_sign.h"

namespace veritope {

/// Adds up the page's units: with upper bounds for lengths of numbers, and, if these exceed a limit, with the lengths
/// that checkers find.
class VModelWork {
 public:
  /// @param bytes  of the model; those of the body come on top of what is allowed
  VModelWork(const VModel& model, std::uint64_t bytes) : model_(model), bytes_(bytes) {}

  /// The pieces and their determinants. Nothing if they are within the limits.
  std::optional<Finding> of_pieces();
  /// The trees of the determinants, after of_pieces(). REQUIRES proved determinants.
  std::optional<Finding> of_trees(const VDeterminants& determinants);

 private:
  std::optional<Finding> add_cell(std::size_t number, bool is_bound);
  std::optional<Finding> add(std::uint64_t units, std::size_t cell);

  const VModel& model_;
  std::uint64_t bytes_, units_ = 0;
  std::vector<std::uint32_t> bits_;  // of each piece: at least those of its longest coefficient
};

}  // namespace veritope
