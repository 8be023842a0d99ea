// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>

#include "solids/classify/shell_chain_internal.h"

namespace veritope::internal {

std::uint32_t ShellChains::add(std::vector<std::uint32_t> chain) {
  const auto [at, is_new] = numbers_.emplace(chain, static_cast<std::uint32_t>(chains_.size()));
  if (is_new) chains_.push_back(std::move(chain));
  return at->second;
}

std::vector<std::uint32_t> ShellChains::moved(std::uint32_t chain,
                                              const ShellPassages& passages) const {
  std::vector<std::uint32_t> out = chains_[chain];
  for (const auto& [shell, balance] : passages.balances()) {
    if (balance < 0) std::erase(out, shell);
    if (balance > 0) out.push_back(shell);
  }
  std::sort(out.begin(), out.end(), [&](std::uint32_t a, std::uint32_t b) {
    return shells_->depth[a] < shells_->depth[b];
  });
  return out;
}

std::uint32_t ShellChains::innermost_after(std::uint32_t chain,
                                           const ShellPassages& passages) const {
  if (shells_ == nullptr) return kNowhere;
  const std::vector<std::uint32_t>& start = chains_[chain];
  if (passages.balances().empty()) return start.empty() ? kNowhere : start.back();
  const std::vector<std::uint32_t> end = moved(chain, passages);
  return end.empty() ? kNowhere : end.back();
}

std::uint32_t ShellChains::after(std::uint32_t chain, const ShellPassages& passages) {
  if (shells_ == nullptr || passages.balances().empty()) return chain;
  return add(moved(chain, passages));
}

}  // namespace veritope::internal
