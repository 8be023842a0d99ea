// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/memory_budget.h: the bytes that the growing structures of one search may own together. They ask before
// they grow, so that a search ends with what it reached where another program would fill the machine.
// Design: docs/design/0036-bounds-on-everything.md.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "robust/base/result.h"

namespace veritope {

/// Counts bytes that are owned, not those of the process: the allocator, the code and the stacks take more. A refusal
/// is remembered until it is forgiven: structures that are refused stop growing at once, and the search that drives
/// them looks here why. For one thread.
class MemoryBudget {
 public:
  static constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

  explicit MemoryBudget(std::uint64_t limit = kUnlimited) : limit_(limit) {}
  MemoryBudget(const MemoryBudget&) = delete;
  MemoryBudget& operator=(const MemoryBudget&) = delete;

  /// Whether the bytes are granted: iff used() + bytes <= limit().
  bool take(std::uint64_t bytes) {
    if (bytes > room()) return is_spent_ = true, false;
    count(bytes);
    return true;
  }
  /// For bytes without which a step that began cannot end; beyond the limit this counts as a refusal.
  void take_anyway(std::uint64_t bytes) {
    is_spent_ = is_spent_ || bytes > room();
    count(bytes);
  }
  void give_back(std::uint64_t bytes) { used_ -= bytes; }

  std::uint64_t limit() const { return limit_; }
  std::uint64_t used() const { return used_; }
  std::uint64_t room() const { return used_ < limit_ ? limit_ - used_ : 0; }
  /// The most that was ever used: a limit of as many bytes suffices for the same calls.
  std::uint64_t most() const { return most_; }
  bool is_spent() const { return is_spent_; }
  /// For a search that starts again with less.
  void forgive() { is_spent_ = false; }

 private:
  void count(std::uint64_t bytes) {
    used_ += bytes;
    most_ = std::max(most_, used_);
  }

  std::uint64_t limit_, used_ = 0, most_ = 0;
  bool is_spent_ = false;
};

/// The part of a budget that one structure owns; it is given back with the structure. Without a budget everything is
/// granted. The budget must outlive it.
class MemoryShare {
 public:
  MemoryShare() = default;
  explicit MemoryShare(MemoryBudget* budget) : budget_(budget) {}
  MemoryShare(MemoryShare&& other) noexcept
      : budget_(std::exchange(other.budget_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}
  MemoryShare& operator=(MemoryShare&& other) noexcept {
    std::swap(budget_, other.budget_);
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  ~MemoryShare() {
    if (budget_ != nullptr) budget_->give_back(bytes_);
  }

  /// Makes the part `bytes` long; returns false, and leaves it as it is, if the budget refuses.
  bool resize(std::uint64_t bytes) {
    if (budget_ != nullptr && bytes > bytes_ && !budget_->take(bytes - bytes_)) return false;
    if (budget_ != nullptr && bytes < bytes_) budget_->give_back(bytes_ - bytes);
    bytes_ = bytes;
    return true;
  }
  void resize_anyway(std::uint64_t bytes) {
    if (budget_ != nullptr && bytes > bytes_) budget_->take_anyway(bytes - bytes_), bytes_ = bytes;
    resize(bytes);
  }
  std::uint64_t bytes() const { return bytes_; }
  MemoryBudget* budget() const { return budget_; }

 private:
  MemoryBudget* budget_ = nullptr;
  std::uint64_t bytes_ = 0;
};

/// Room in `v` for so many more elements; its capacity doubles where it must grow. Returns false, and leaves `v` as it
/// is, if the budget refuses. The share is that of the capacity: while elements move, both arrays together hold no more
/// than that many.
/// @param bytes_each  at least sizeof(T): with what other structures keep for each element
template <typename T>
bool make_room(std::vector<T>& v, std::size_t more, MemoryShare& share,
               std::size_t bytes_each = sizeof(T)) {
  if (v.capacity() - v.size() >= more) return true;
  const std::size_t capacity = std::max(v.size() + more, 2 * v.capacity());
  if (!share.resize(std::uint64_t{capacity} * bytes_each)) return false;
  v.reserve(capacity);
  return true;
}

/// "the memory allowed, 2000 MiB, does not suffice", as an error kOverLimit.
Error memory_error(const MemoryBudget& budget);

/// The limit that is asked for; without one, half of this machine's memory.
std::uint64_t memory_allowed(std::optional<std::uint64_t> asked);

}  // namespace veritope
