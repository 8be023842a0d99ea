// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/id_table.h: typed ids, and tables of elements that are named by them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "robust/base/check.h"

namespace veritope {

/// Names an element of one kind; kinds do not convert into each other.
template <class Tag>
struct TopologyId {
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::uint32_t value = kNone;

  constexpr bool is_none() const { return value == kNone; }
  friend constexpr auto operator<=>(const TopologyId&, const TopologyId&) = default;
};

/// Elements by id. An id keeps its meaning until its element is removed, and is not used again. A loop over the table
/// gives the ids of its elements, ascending.
template <class Id, class T>
class IdTable {
 public:
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  /// All ids that were ever given are less than this.
  std::uint32_t end_id() const { return static_cast<std::uint32_t>(slots_.size()); }
  bool contains(Id id) const { return id.value < slots_.size() && slots_[id.value].has_value(); }

  Id add(T element) {
    VT_CHECK(slots_.size() < Id::kNone, "more elements than 32 bits can number");
    slots_.emplace_back(std::move(element));
    ++size_;
    return Id{end_id() - 1};
  }
  /// REQUIRES contains(id).
  void remove(Id id) {
    VT_CHECK(contains(id), "an element that is not there");
    slots_[id.value].reset();
    --size_;
  }
  /// REQUIRES contains(id).
  T& operator[](Id id) {
    VT_CHECK(contains(id), "an element that is not there");
    return *slots_[id.value];
  }
  const T& operator[](Id id) const {
    VT_CHECK(contains(id), "an element that is not there");
    return *slots_[id.value];
  }

  class Iterator {
   public:
    Iterator(const IdTable* table, std::uint32_t at) : table_(table), at_(at) { skip(); }
    Id operator*() const { return Id{at_}; }
    Iterator& operator++() {
      ++at_;
      skip();
      return *this;
    }
    bool operator!=(const Iterator& other) const { return at_ != other.at_; }

   private:
    void skip() {
      while (at_ < table_->end_id() && !table_->contains(Id{at_})) ++at_;
    }
    const IdTable* table_;
    std::uint32_t at_;
  };
  Iterator begin() const { return Iterator(this, 0); }
  Iterator end() const { return Iterator(this, end_id()); }

  friend bool operator==(const IdTable&, const IdTable&) = default;

 private:
  std::vector<std::optional<T>> slots_;
  std::size_t size_ = 0;
};

}  // namespace veritope
