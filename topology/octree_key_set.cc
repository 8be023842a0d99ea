// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/octree_key_set.h"

#include <algorithm>
#include <string>

namespace veritope {
namespace {

Error nested(OctreeKey outer, OctreeKey inner) {
  const std::string name = "cell " + to_string(outer.cell());
  if (outer == inner) return {Code::kBadArgument, {}, name + " occurs twice"};
  return {Code::kBadArgument,
          {},
          name + " contains cell " + to_string(inner.cell()) + ", which is in the set too"};
}

Status check_size(std::size_t n) {
  if (n == 0) return Error{Code::kEmpty, {}, "a set of octree cells needs at least one cell"};
  if (n > OctreeKeySet::kMaxCells)
    return Error{
        Code::kOverLimit,
        {},
        std::to_string(n) + " octree cells; at most " + std::to_string(OctreeKeySet::kMaxCells)};
  return ok_status();
}

}  // namespace

Result<OctreeKeySet> OctreeKeySet::make(std::span<const OctreeCell> cells) {
  if (const Status size = check_size(cells.size()); !size) return size.error();
  std::vector<OctreeKey> keys;
  keys.reserve(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Result<OctreeKey> key = OctreeKey::make(cells[i]);
    if (!key) {
      Error error = key.error();
      error.place.entity = i;
      return error;
    }
    keys.push_back(*key);
  }
  return make(std::move(keys));
}

Result<OctreeKeySet> OctreeKeySet::make(std::vector<OctreeKey> keys) {
  if (const Status size = check_size(keys.size()); !size) return size.error();
  if (!std::is_sorted(keys.begin(), keys.end())) std::sort(keys.begin(), keys.end());
  // The codes inside one cell are an interval around its own: if two keys are nested, two adjacent ones are.
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i - 1].contains(keys[i])) return nested(keys[i - 1], keys[i]);
    if (keys[i].contains(keys[i - 1])) return nested(keys[i], keys[i - 1]);
  }
  OctreeKeySet set;
  set.keys_ = std::move(keys);
  set.build_index();
  return set;
}

void OctreeKeySet::build_index() {
  for (const OctreeKey key : keys_) finest_level_ = std::max(finest_level_, key.level());
  // Buckets of equal length between the first and the last code, approximately one for each key.
  const std::uint64_t last = keys_.back().code();
  while (last >> shift_ > 2 * keys_.size()) ++shift_;
  bucket_.assign((last >> shift_) + 2, static_cast<std::uint32_t>(keys_.size()));
  for (std::size_t i = keys_.size(); i-- > 0;)
    bucket_[keys_[i].code() >> shift_] = static_cast<std::uint32_t>(i);
  for (std::size_t b = bucket_.size() - 1; b-- > 0;)
    bucket_[b] = std::min(bucket_[b], bucket_[b + 1]);
}

std::size_t OctreeKeySet::lower_bound(std::uint64_t code) const {
  const std::uint64_t b = code >> shift_;
  if (b + 1 >= bucket_.size()) return keys_.size();
  const auto first = keys_.begin() + bucket_[b], last = keys_.begin() + bucket_[b + 1];
  return static_cast<std::size_t>(
      std::lower_bound(first, last, code,
                       [](OctreeKey key, std::uint64_t c) { return key.code() < c; }) -
      keys_.begin());
}

}  // namespace veritope
