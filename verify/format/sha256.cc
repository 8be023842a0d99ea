// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/sha256.cc: padding, and the portable compression function.  Source: FIPS 180-4, sections 5 and 6.2.
#include "verify/format/sha256.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "verify/format/sha256_constants.h"

namespace veritope {
namespace {

std::uint32_t load_big_endian(const unsigned char* p) {
  return (std::uint32_t{p[0]} << 24) | (std::uint32_t{p[1]} << 16) | (std::uint32_t{p[2]} << 8) |
         std::uint32_t{p[3]};
}

void store_big_endian(std::uint32_t value, unsigned char* p) {
  for (int i = 0; i < 4; ++i) p[i] = static_cast<unsigned char>(value >> (24 - 8 * i));
}

internal::Sha256Blocks best_blocks() {
  static const internal::Sha256Blocks best = internal::sha256_blocks_x86() != nullptr
                                                 ? internal::sha256_blocks_x86()
                                                 : internal::sha256_blocks_portable;
  return best;
}

}  // namespace

namespace internal {
namespace {

// The message schedule of one block.
void expand(const unsigned char* block, std::uint32_t* w) {
  for (int t = 0; t < 16; ++t) w[t] = load_big_endian(block + 4 * t);
  for (int t = 16; t < 64; ++t) {
    const std::uint32_t a = w[t - 15], b = w[t - 2];
    w[t] = w[t - 16] + w[t - 7] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ (a >> 3)) +
           (std::rotr(b, 17) ^ std::rotr(b, 19) ^ (b >> 10));
  }
}

// One round; the caller renames the variables instead of moving them.
inline void round(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t& d,
                  std::uint32_t e, std::uint32_t f, std::uint32_t g, std::uint32_t& h,
                  std::uint32_t input) {
  const std::uint32_t t1 =
      h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + ((e & f) ^ (~e & g)) + input;
  const std::uint32_t t2 =
      (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
  d += t1;
  h = t1 + t2;
}

}  // namespace

void sha256_blocks_portable(std::uint32_t* state, const unsigned char* blocks, std::size_t num) {
  for (; num > 0; --num, blocks += 64) {
    std::uint32_t w[64];
    expand(blocks, w);
    std::uint32_t a = state[0], b = state[1], c = state[2], d = state[3];
    std::uint32_t e = state[4], f = state[5], g = state[6], h = state[7];
    const std::uint32_t* k = kSha256Rounds;
    for (int t = 0; t < 64; t += 8) {
      round(a, b, c, d, e, f, g, h, k[t] + w[t]);
      round(h, a, b, c, d, e, f, g, k[t + 1] + w[t + 1]);
      round(g, h, a, b, c, d, e, f, k[t + 2] + w[t + 2]);
      round(f, g, h, a, b, c, d, e, k[t + 3] + w[t + 3]);
      round(e, f, g, h, a, b, c, d, k[t + 4] + w[t + 4]);
      round(d, e, f, g, h, a, b, c, k[t + 5] + w[t + 5]);
      round(c, d, e, f, g, h, a, b, k[t + 6] + w[t + 6]);
      round(b, c, d, e, f, g, h, a, k[t + 7] + w[t + 7]);
    }
    const std::uint32_t sums[8] = {a, b, c, d, e, f, g, h};
    for (int i = 0; i < 8; ++i) state[i] += sums[i];
  }
}

}  // namespace internal

Sha256::Sha256()
    : state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
             0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19} {}

void Sha256::update(std::span<const unsigned char> bytes) {
  const std::size_t used = size_ % 64;
  size_ += bytes.size();
  if (used > 0) {
    const std::size_t take = std::min(64 - used, bytes.size());
    std::copy_n(bytes.data(), take, block_.data() + used);
    bytes = bytes.subspan(take);
    if (used + take < 64) return;
    best_blocks()(state_.data(), block_.data(), 1);
  }
  const std::size_t num = bytes.size() / 64;
  if (num > 0) best_blocks()(state_.data(), bytes.data(), num);
  bytes = bytes.subspan(num * 64);
  std::copy(bytes.begin(), bytes.end(), block_.begin());
}

Sha256Digest Sha256::finish() {
  const std::uint64_t bits = size_ * 8;
  std::array<unsigned char, 72> tail{0x80};
  const std::size_t zeros = (119 - size_ % 64) % 64;  // leaves the last 8 bytes of a block
  unsigned char* const length = tail.data() + 1 + zeros;
  store_big_endian(static_cast<std::uint32_t>(bits >> 32), length);
  store_big_endian(static_cast<std::uint32_t>(bits), length + 4);
  update({tail.data(), 1 + zeros + 8});
  Sha256Digest digest;
  for (std::size_t i = 0; i < 8; ++i) store_big_endian(state_[i], digest.data() + 4 * i);
  return digest;
}

Sha256Digest sha256(std::span<const unsigned char> bytes) {
  Sha256 hash;
  hash.update(bytes);
  return hash.finish();
}

std::string to_hex(const Sha256Digest& digest) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += kHex[byte >> 4];
    text += kHex[byte & 15];
  }
  return text;
}

}  // namespace veritope
