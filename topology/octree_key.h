// SPDX-License-Identifier: LGPL-3.0-or-later
// topology/octree_key.h: the cells of an octree as integers: level, position, kin, neighbours, order.
#pragma once
#include <array>
#include <bit>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>

#include "robust/base/check.h"
#include "robust/base/result.h"

namespace veritope {

/// A cell of the octree over a cubic root: [i, i + 1] x [j, j + 1] x [k, k + 1] in units of 2^-level of the root's
/// edge. It is plain data, possibly out of range: OctreeKey::make decides.
struct OctreeCell {
  std::uint32_t level = 0, i = 0, j = 0, k = 0;
  friend constexpr bool operator==(const OctreeCell&, const OctreeCell&) = default;
};

/// "(level 3: 1 0 7)"
std::string to_string(const OctreeCell& cell);

/// A cell in range, as one integer: the Morton code of (i, j, k) (bit 0: i, bit 1: j, bit 2: k), a 1, and
/// 3 (20 - level) zeros. A cell and all cells inside it are one interval of codes, [first_code(), last_code()].
/// Laws: (1) a.contains(b) iff b's code lies in a's interval; (2) codes order cells, of which none contains another, as
/// their Morton codes do, and place every cell after the cells of its first half and before those of its second.
class OctreeKey {
 public:
  static constexpr unsigned kMaxLevel = 20;
  /// The root's edge in units of the finest level's cells. Corners have coordinates in [0, kGrid].
  static constexpr std::uint32_t kGrid = 1u << kMaxLevel;

  constexpr OctreeKey() = default;  ///< the root
  /// @error kBadArgument if level > 20 or an index is not below 2^level; the message names the cell.
  static Result<OctreeKey> make(const OctreeCell& cell);
  /// @error kBadArgument if no cell has that code.
  static Result<OctreeKey> from_code(std::uint64_t code);

  constexpr std::uint64_t code() const { return code_; }
  constexpr unsigned level() const {
    return kMaxLevel - static_cast<unsigned>(std::countr_zero(code_)) / 3;
  }
  constexpr OctreeCell cell() const {
    const std::uint64_t m = code_ >> (3 * (kMaxLevel - level()) + 1);
    return {level(), compact(m), compact(m >> 1), compact(m >> 2)};
  }
  /// Edge length in units of the finest level.
  constexpr std::uint32_t size() const { return kGrid >> level(); }
  /// The corner with the least coordinates, in units of the finest level.
  constexpr std::array<std::uint32_t, 3> corner() const {
    const std::uint64_t m = (code_ ^ low_bit()) >> 1;
    return {compact(m), compact(m >> 1), compact(m >> 2)};
  }

  constexpr std::uint64_t first_code() const { return code_ - low_bit() + 1; }
  constexpr std::uint64_t last_code() const { return code_ + low_bit() - 1; }
  /// True also for the cell itself.
  constexpr bool contains(OctreeKey other) const {
    return first_code() <= other.code_ && other.code_ <= last_code();
  }

  /// REQUIRES level() > 0.
  constexpr OctreeKey parent() const { return ancestor(level() - 1); }
  /// The cell of that level that contains this one. REQUIRES level <= level().
  constexpr OctreeKey ancestor(unsigned level) const {
    const std::uint64_t bit = std::uint64_t{1} << (3 * (kMaxLevel - level));
    return OctreeKey((code_ & ~(2 * bit - 1)) | bit);
  }
  /// Bit a of `octant` selects the upper half along axis a. REQUIRES level() < 20, octant < 8.
  constexpr OctreeKey child(unsigned octant) const {
    const std::uint64_t bit = low_bit() >> 3;
    return OctreeKey((code_ ^ low_bit()) + (2 * octant + 1) * bit);
  }
  /// The cell of the same level on the other side of the face with that normal; none if it lies outside the root.
  /// REQUIRES axis < 3.
  constexpr std::optional<OctreeKey> neighbour(unsigned axis, bool upper) const {
    // Arithmetic on every third bit: the bits of the other axes are filled with ones (or zeros) so that carries pass.
    const std::uint64_t mask = (kThirds << axis) & ((std::uint64_t{1} << 3 * kMaxLevel) - 1),
                        unit = low_bit() << axis;
    const std::uint64_t m = (code_ ^ low_bit()) >> 1, mine = m & mask, top = mask & ~(unit - 1);
    if (upper ? mine == top : mine == 0) return std::nullopt;
    const std::uint64_t moved = upper ? ((mine | ~mask) + unit) & mask : (mine - unit) & mask;
    return OctreeKey((((m & ~mask) | moved) << 1) | low_bit());
  }

  friend constexpr auto operator<=>(const OctreeKey&, const OctreeKey&) = default;

 private:
  explicit constexpr OctreeKey(std::uint64_t code) : code_(code) {}
  constexpr std::uint64_t low_bit() const { return code_ & (~code_ + 1); }

  static constexpr std::uint64_t kThirds = 0x1249249249249249u;  // bits 0, 3, ..., 60
  /// Bits 0, 3, 6, ... of m as one number.
  static constexpr std::uint32_t compact(std::uint64_t m) {
    m &= kThirds;
    m = (m | (m >> 2)) & 0x10c30c30c30c30c3u;
    m = (m | (m >> 4)) & 0x100f00f00f00f00fu;
    m = (m | (m >> 8)) & 0x001f0000ff0000ffu;
    m = (m | (m >> 16)) & 0x001f00000000ffffu;
    return static_cast<std::uint32_t>((m | (m >> 32)) & 0x1fffffu);
  }
  static constexpr std::uint64_t spread(std::uint64_t x) {
    x = (x | (x << 32)) & 0x001f00000000ffffu;
    x = (x | (x << 16)) & 0x001f0000ff0000ffu;
    x = (x | (x << 8)) & 0x100f00f00f00f00fu;
    x = (x | (x << 4)) & 0x10c30c30c30c30c3u;
    return (x | (x << 2)) & kThirds;
  }

  std::uint64_t code_ = std::uint64_t{1} << (3 * kMaxLevel);
};

}  // namespace veritope
