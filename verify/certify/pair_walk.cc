// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/pair_walk.h"

#include <algorithm>
#include <span>

#include "robust/base/check.h"

namespace veritope {
namespace {

// A node: positions [lo, hi). Its children meet at middle().
struct LeafRange {
  std::uint32_t lo, hi;
  std::uint32_t size() const { return hi - lo; }
  std::uint32_t middle() const { return lo + (hi - lo) / 2; }
};

// The middle of the node whose children hold i and j, one each: every node with two leaves or more has its own.
std::uint32_t middle_between(std::uint32_t num_leaves, const FacetMeeting& pair) {
  std::uint32_t lo = 0, size = num_leaves;
  for (;;) {
    const std::uint32_t half = size / 2, middle = lo + half;
    if (pair.second < middle) {
      size = half;
    } else if (pair.first >= middle) {
      lo = middle;
      size -= half;
    } else {
      return middle;
    }
  }
}

// The pairs of one step cross(a, b), in the order of its calls.
void sort_in_cross(LeafRange a, LeafRange b, std::span<FacetMeeting> pairs) {
  while (pairs.size() > 1) {
    VT_CHECK(a.size() + b.size() > 2, "the pairs are different");
    const bool splits_a = a.size() >= b.size();
    const std::uint32_t middle = (splits_a ? a : b).middle();
    const auto is_left = [&](const FacetMeeting& p) {
      return (splits_a ? p.first : p.second) < middle;
    };
    const auto right = std::partition(pairs.begin(), pairs.end(), is_left);
    const auto num_left = static_cast<std::size_t>(right - pairs.begin());
    LeafRange left_a = a, left_b = b;
    (splits_a ? left_a : left_b).hi = middle;
    (splits_a ? a : b).lo = middle;
    sort_in_cross(left_a, left_b, pairs.first(num_left));
    pairs = pairs.subspan(num_left);
  }
}

// Appends the pairs of self(node), which are grouped by the middles that they lie around.
class SelfOrder {
 public:
  // begin[m]: where the pairs around the middle m begin.
  SelfOrder(std::vector<std::uint32_t> begin, std::vector<FacetMeeting> by_middle,
            std::vector<FacetMeeting>& out)
      : begin_(std::move(begin)), by_middle_(std::move(by_middle)), out_(out) {}

  void append(const LeafRange& node) {
    if (node.size() < 2 || begin_[node.lo + 1] == begin_[node.hi]) return;
    const std::uint32_t middle = node.middle();
    append({node.lo, middle});
    append({middle, node.hi});
    const std::span<FacetMeeting> own(by_middle_.data() + begin_[middle],
                                      begin_[middle + 1] - begin_[middle]);
    sort_in_cross({node.lo, middle}, {middle, node.hi}, own);
    out_.insert(out_.end(), own.begin(), own.end());
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<FacetMeeting> by_middle_;
  std::vector<FacetMeeting>& out_;
};

}  // namespace

std::vector<FacetMeeting> sorted_as_walked(std::uint32_t num_leaves,
                                           std::span<const FacetMeeting> pairs) {
  VT_CHECK(pairs.size() <= 0xffffffffu, "number of pairs");
  std::vector<FacetMeeting> out;
  if (pairs.empty()) return out;
  // Counts, then begins of the groups: at first element m + 1 is that of the middle m, then element m.
  std::vector<std::uint32_t> begin(std::size_t{num_leaves} + 2, 0), middles;
  middles.reserve(pairs.size());
  for (const FacetMeeting& p : pairs) {
    middles.push_back(middle_between(num_leaves, p));
    ++begin[middles.back() + 2];
  }
  for (std::size_t m = 2; m < begin.size(); ++m) begin[m] += begin[m - 1];
  std::vector<FacetMeeting> by_middle(pairs.size());
  for (std::size_t n = 0; n < pairs.size(); ++n) by_middle[begin[middles[n] + 1]++] = pairs[n];
  middles = {};
  out.reserve(pairs.size());
  SelfOrder(std::move(begin), std::move(by_middle), out).append({0, num_leaves});
  return out;
}

}  // namespace veritope
