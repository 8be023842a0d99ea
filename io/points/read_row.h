// SPDX-License-Identifier: LGPL-3.0-or-later
// io/points/read_row.h: rows of exact numbers from lines of text, as many in each line.
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "io/base/read_limits.h"
#include "io/points/read_point.h"
#include "robust/rational.h"

namespace veritope {

/// Reads the lines of one file. Numbers are decimals, hexadecimal numbers or fractions, all exact, separated as those
/// of PointLines. The first row says how many each has.
class RowLines {
 public:
  /// REQUIRES 1 <= least <= most.
  RowLines(std::size_t least, std::size_t most, const ReadLimits& limits);

  /// Nothing for a line without a row: empty, a comment after #, or a first line that consists of words.
  /// @error the fault, in `fault`; then the result is empty, too
  std::optional<std::vector<Rational>> read(std::string_view line,
                                            std::optional<PointFault>& fault);

 private:
  std::optional<PointFault> count_fault(std::size_t count, std::size_t surplus,
                                        std::size_t end) const;

  std::size_t least_, most_;
  std::size_t columns_ = 0;  // 0: no row was read
  ReadLimits limits_;
  bool is_first_ = true;
  std::vector<std::string_view> tokens_;
};

}  // namespace veritope
