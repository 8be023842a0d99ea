// SPDX-License-Identifier: LGPL-3.0-or-later
#include "topology/octree_key.h"

namespace veritope {

std::string to_string(const OctreeCell& cell) {
  return "(level " + std::to_string(cell.level) + ": " + std::to_string(cell.i) + " " +
         std::to_string(cell.j) + " " + std::to_string(cell.k) + ")";
}

Result<OctreeKey> OctreeKey::make(const OctreeCell& cell) {
  if (cell.level > kMaxLevel)
    return Error{Code::kBadArgument,
                 {},
                 "cell " + to_string(cell) + ": levels end at " + std::to_string(kMaxLevel)};
  const std::uint32_t n = 1u << cell.level;
  if (cell.i >= n || cell.j >= n || cell.k >= n)
    return Error{
        Code::kBadArgument,
        {},
        "cell " + to_string(cell) + ": its level has indices 0 to " + std::to_string(n - 1)};
  const std::uint64_t m = spread(cell.i) | spread(cell.j) << 1 | spread(cell.k) << 2;
  return OctreeKey((2 * m + 1) << (3 * (kMaxLevel - cell.level)));
}

Result<OctreeKey> OctreeKey::from_code(std::uint64_t code) {
  const int zeros = std::countr_zero(code);
  if (code == 0 || code >> (3 * kMaxLevel + 1) != 0 || zeros % 3 != 0)
    return Error{Code::kBadArgument, {}, std::to_string(code) + " is the code of no octree cell"};
  return OctreeKey(code);
}

}  // namespace veritope
