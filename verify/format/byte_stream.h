// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/byte_stream.h: little-endian numbers to and from bytes. Internal to verify/format.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace veritope::certificate::internal {

/// 0, 1, 2, 3, ... for 0, -1, 1, -2, ...
inline std::uint64_t zigzag_code(std::int64_t z) {
  return z >= 0 ? 2 * static_cast<std::uint64_t>(z) : 2 * static_cast<std::uint64_t>(-(z + 1)) + 1;
}

class ByteWriter {
 public:
  void u8(std::uint8_t v) { bytes_.push_back(v); }
  void u32(std::uint32_t v) {
    for (int i = 0; i < 4; ++i) bytes_.push_back(static_cast<unsigned char>(v >> (8 * i)));
  }
  void i32(std::int32_t v) { u32(static_cast<std::uint32_t>(v)); }
  /// Base 128, low group first.
  void varint(std::uint64_t v) {
    for (; v >= 128; v >>= 7) bytes_.push_back(static_cast<unsigned char>(v | 128));
    bytes_.push_back(static_cast<unsigned char>(v));
  }
  void zigzag(std::int64_t z) { varint(zigzag_code(z)); }
  void raw(std::span<const unsigned char> bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
  void text(std::string_view s) {
    for (const char c : s) u8(static_cast<std::uint8_t>(c));
  }
  void reserve(std::size_t n) { bytes_.reserve(n); }
  std::vector<unsigned char> take() { return std::move(bytes_); }

 private:
  std::vector<unsigned char> bytes_;
};

/// Reads until the first failure; after it every read returns zero and ok() is false.
class ByteReader {
 public:
  explicit ByteReader(std::span<const unsigned char> bytes) : bytes_(bytes) {}
  bool ok() const { return ok_; }
  bool at_end() const { return ok_ && at_ == bytes_.size(); }
  std::size_t left() const { return bytes_.size() - at_; }
  void fail() { ok_ = false; }

  std::uint8_t u8() { return need(1) ? bytes_[at_++] : 0; }
  std::uint32_t u32() {
    if (!need(4)) return 0;
    std::uint32_t v = 0;
    for (int i = 0; i < 4; ++i) v |= static_cast<std::uint32_t>(bytes_[at_++]) << (8 * i);
    return v;
  }
  std::int32_t i32() { return static_cast<std::int32_t>(u32()); }
  std::uint64_t varint() {
    std::uint64_t v = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const std::uint8_t b = u8();
      if (shift == 63 && b > 1) break;
      v |= static_cast<std::uint64_t>(b & 127u) << shift;
      if (b < 128) {
        if (b == 0 && shift > 0) break;  // not the shortest form
        return v;
      }
    }
    ok_ = false;
    return 0;
  }
  std::int64_t zigzag() {
    const std::uint64_t v = varint();
    return (v & 1u) != 0 ? -static_cast<std::int64_t>(v >> 1) - 1
                         : static_cast<std::int64_t>(v >> 1);
  }
  std::span<const unsigned char> raw(std::size_t n) {
    if (!need(n)) return {};
    at_ += n;
    return bytes_.subspan(at_ - n, n);
  }
  /// A count of items of at least `size` bytes each: fails if fewer bytes are left than they need.
  std::uint32_t count(std::size_t size) {
    const std::uint32_t n = u32();
    if (ok_ && n > left() / size) ok_ = false;
    return ok_ ? n : 0;
  }

 private:
  bool need(std::size_t n) {
    if (n > left()) ok_ = false;
    return ok_;
  }
  std::span<const unsigned char> bytes_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

}  // namespace veritope::certificate::internal
