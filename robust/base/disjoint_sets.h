// SPDX-License-Identifier: LGPL-3.0-or-later
// robust/base/disjoint_sets.h: classes of 0, 1, ..., n - 1 that are joined step by step (union-find), for one thread
// and for several. The result depends on the joins only, not on their order: a class is named by its least element.
#pragma once
#include <atomic>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace veritope {

/// @cost a call of find or join: nearly constant, O(log n) amortised at worst
template <std::unsigned_integral Id = std::uint32_t>
class DisjointSets {
 public:
  /// Every element is a class of its own. REQUIRES that Id can hold n.
  explicit DisjointSets(std::size_t n = 0) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), Id{0});
  }
  std::size_t size() const { return parent_.size(); }
  /// Adds the element size() as a class of its own.
  Id add() {
    parent_.push_back(static_cast<Id>(parent_.size()));
    return parent_.back();
  }

  /// The least element of x's class.
  Id find(Id x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  /// Makes one class of a's and b's.
  void join(Id a, Id b) {
    a = find(a), b = find(b);
    if (b < a) std::swap(a, b);
    parent_[b] = a;
  }

 private:
  std::vector<Id>
      parent_;  // of each element one of its class that is not greater; of the least: itself
};

/// Classes as above, for several threads that call find and join at once. What find returns while other threads join
/// is an element of x's class.
class ConcurrentDisjointSets {
 public:
  /// REQUIRES n < 2^32. No element may be used before reset() has seen it, so that threads can share that work, too.
  explicit ConcurrentDisjointSets(std::size_t n) : size_(n), parent_(new std::uint32_t[n]) {}
  std::size_t size() const { return size_; }
  /// Makes each of begin, ..., end - 1 a class of its own.
  void reset(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) parent_[i] = static_cast<std::uint32_t>(i);
  }

  /// The least element of x's class.
  std::uint32_t find(std::uint32_t x) {
    for (;;) {
      std::uint32_t p = load(x);
      if (p == x) return x;
      const std::uint32_t g = load(p);
      if (g == p) return p;
      std::atomic_ref<std::uint32_t>(parent_[x])
          .compare_exchange_weak(p, g, std::memory_order_relaxed);
      x = g;
    }
  }
  /// Makes one class of a's and b's.
  void join(std::uint32_t a, std::uint32_t b) {
    for (;;) {
      a = find(a);
      b = find(b);
      if (a == b) return;
      if (a < b) std::swap(a, b);
      std::uint32_t expected = a;
      if (std::atomic_ref<std::uint32_t>(parent_[a])
              .compare_exchange_strong(expected, b, std::memory_order_relaxed))
        return;
    }
  }

 private:
  std::uint32_t load(std::uint32_t x) {
    return std::atomic_ref<std::uint32_t>(parent_[x]).load(std::memory_order_relaxed);
  }
  std::size_t size_;
  std::unique_ptr<std::uint32_t[]> parent_;
};

}  // namespace veritope
