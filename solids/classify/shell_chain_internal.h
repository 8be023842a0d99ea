// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/shell_chain_internal.h: which shells of a valid mesh lie around a region, from the outermost to the
// innermost. Internal to solids/classify.
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "solids/classify/mesh_classifier.h"
#include "solids/classify/point_answer.h"

namespace veritope::internal {

/// Shells that a segment enters and leaves, with the balance of both.
class ShellPassages {
 public:
  void enter(std::uint32_t shell, int count) {
    for (auto& [known, balance] : balances_)
      if (known == shell) {
        balance += count;
        return;
      }
    balances_.emplace_back(shell, count);
  }
  void clear() { balances_.clear(); }
  std::span<const std::pair<std::uint32_t, int>> balances() const { return balances_; }

 private:
  std::vector<std::pair<std::uint32_t, int>> balances_;
};

/// Chains of nested shells, numbered; number 0 is the empty one, of the outside.
class ShellChains {
 public:
  /// Without shells all chains are number 0, and facets have no shell.
  explicit ShellChains(const MeshShells* shells) : shells_(shells) { add({}); }

  const MeshShells* shells() const { return shells_; }  ///< null: none were given
  std::uint32_t shell_of(std::uint32_t facet) const {
    return shells_ == nullptr ? kNowhere : shells_->shell_of_face[facet];
  }
  /// The innermost shell around the region at the end of a segment that begins in `chain`.
  std::uint32_t innermost_after(std::uint32_t chain, const ShellPassages& passages) const;
  /// The chain of that region; it is numbered if it is new.
  std::uint32_t after(std::uint32_t chain, const ShellPassages& passages);

 private:
  std::uint32_t add(std::vector<std::uint32_t> chain);
  std::vector<std::uint32_t> moved(std::uint32_t chain, const ShellPassages& passages) const;

  const MeshShells* shells_;
  std::vector<std::vector<std::uint32_t>> chains_;
  std::map<std::vector<std::uint32_t>, std::uint32_t> numbers_;
};

}  // namespace veritope::internal
