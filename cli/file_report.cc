// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cli/file_report.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace veritope::cli {

const char* verdict_name(FileVerdict verdict) {
  switch (verdict) {
    case FileVerdict::kValid: return "VALID";
    case FileVerdict::kInvalid: return "INVALID";
    case FileVerdict::kUndecided: return "UNDECIDED";
    case FileVerdict::kUnreadable: return "UNREADABLE";
  }
  return "UNDECIDED";
}

Fault fault_of(const Error& error) { return {code_name(error.code), error.place, error.message}; }

std::string fault_text(const Fault& fault) {
  Error error;
  error.place = fault.place;
  error.place.file.clear();
  error.message = fault.message;
  return to_string(error);
}

std::vector<Defect> share_out(std::vector<Defect> defects, std::size_t most) {
  if (defects.size() <= most) return defects;
  // turn[i] = how many of the same rule come before i. The chosen ones have the least (turn, rule).
  std::array<std::size_t, kNumMeshRules> seen{};
  std::vector<std::size_t> turn, order(defects.size());
  for (const Defect& d : defects) turn.push_back(seen[rule_index(d.rule)]++);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return turn[a] < turn[b]; });
  order.resize(most);
  std::sort(order.begin(), order.end());
  std::vector<Defect> chosen;
  for (const std::size_t i : order) chosen.push_back(std::move(defects[i]));
  return chosen;
}

std::optional<std::uint64_t> total_defects(const FileReport& report) {
  if (!report.decision) return std::nullopt;
  const auto& counts = report.decision->rule_counts;
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

}  // namespace veritope::cli
