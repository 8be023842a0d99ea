// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/radix_sort_internal.h: sorts records by an integer key of a known number of bits, in linear time.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "robust/base/buffer.h"

namespace veritope::internal {

/// A key and the number of the record that it belongs to.
struct KeyedRecord {
  std::uint64_t key;
  std::uint32_t record;
};

/// Sorts stably. REQUIRES keys < 2^bits, fewer than 2^32 records. @cost O(n bits / 11), a second array of the same
/// size.
inline void radix_sort(Buffer<KeyedRecord>& records, unsigned bits) {
  constexpr unsigned kDigit = 11;
  Buffer<KeyedRecord> other(records.size());
  for (unsigned shift = 0; shift < bits; shift += kDigit) {
    std::array<std::uint32_t, 1u << kDigit> start{};
    const auto digit = [shift](std::uint64_t key) { return key >> shift & ((1u << kDigit) - 1); };
    for (std::size_t i = 0; i < records.size(); ++i) ++start[digit(records[i].key)];
    std::uint32_t sum = 0;
    for (std::uint32_t& s : start) {
      const std::uint32_t count = s;
      s = sum;
      sum += count;
    }
    for (std::size_t i = 0; i < records.size(); ++i)
      other[start[digit(records[i].key)]++] = records[i];
    std::swap(records, other);
  }
}

}  // namespace veritope::internal
