// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/sha256.h: SHA-256 (FIPS 180-4), incremental.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace veritope {

using Sha256Digest = std::array<std::uint8_t, 32>;

/// Feed bytes in pieces of any size, then finish once.
class Sha256 {
 public:
  Sha256();

  void update(std::span<const unsigned char> bytes);

  /// The digest of all bytes so far. Afterwards the object may only be assigned to or destroyed.
  Sha256Digest finish();

 private:
  std::array<std::uint32_t, 8> state_;
  std::array<unsigned char, 64> block_{};  ///< the last size_ % 64 bytes
  std::uint64_t size_ = 0;                 ///< bytes so far; below 2^61
};

/// The digest of bytes that are all at hand.
Sha256Digest sha256(std::span<const unsigned char> bytes);

/// 64 lower-case hex digits.
std::string to_hex(const Sha256Digest& digest);

namespace internal {

/// Folds whole blocks of 64 bytes into `state`.
using Sha256Blocks = void (*)(std::uint32_t* state, const unsigned char* blocks, std::size_t num);
void sha256_blocks_portable(std::uint32_t* state, const unsigned char* blocks, std::size_t num);
/// The x86 SHA instructions, or nullptr if this processor or this build has none.
Sha256Blocks sha256_blocks_x86();

}  // namespace internal
}  // namespace veritope
