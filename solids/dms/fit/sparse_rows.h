// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/fit/sparse_rows.h: matrices of doubles, a row at a time.
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace veritope {

/// Row r has value[k] in column[k] for first[r] <= k < first[r + 1]; columns ascend.
struct SparseRows {
  std::vector<int> first{0};
  std::vector<int> column;
  std::vector<double> value;

  std::size_t num_rows() const { return first.size() - 1; }
  /// Adds a row; entries of one column are added up. The entries are sorted.
  void add(std::vector<std::pair<int, double>>& entries) {
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (i > 0 && entries[i].first == entries[i - 1].first) {
        value.back() += entries[i].second;
      } else {
        column.push_back(entries[i].first);
        value.push_back(entries[i].second);
      }
    }
    first.push_back(static_cast<int>(column.size()));
  }
  double product(std::size_t row, std::span<const double> x) const {
    double sum = 0;
    for (int k = first[row]; k < first[row + 1]; ++k)
      sum += value[static_cast<std::size_t>(k)] *
             x[static_cast<std::size_t>(column[static_cast<std::size_t>(k)])];
    return sum;
  }
};

}  // namespace veritope
