// SPDX-License-Identifier: Apache-2.0 OR MIT
// sha256.h: SHA-256 (FIPS 180-4) of a block of bytes, as 64 lower-case hex digits.
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>

const uint32_t kRound[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

inline uint32_t rotated(uint32_t x, int n) { return x >> n | x << (32 - n); }

// One round. It computes the new first word at *h and the new fifth word at *d; the other six words only move on.
inline void sha256_round(uint32_t a, uint32_t b, uint32_t c, uint32_t* d, uint32_t e, uint32_t f,
                         uint32_t g, uint32_t* h, uint32_t added) {
  const uint32_t t =
      *h + (rotated(e, 6) ^ rotated(e, 11) ^ rotated(e, 25)) + ((e & f) ^ (~e & g)) + added;
  *d += t;
  *h = t + (rotated(a, 2) ^ rotated(a, 13) ^ rotated(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
}

inline void sha256_block(uint32_t* h, const uint8_t* p) {
  uint32_t w[64], a = h[0], b = h[1], c = h[2], d = h[3], e = h[4], f = h[5], g = h[6], k = h[7];
  for (int i = 0; i < 16; ++i, p += 4)
    w[i] = uint32_t(p[0]) << 24 | uint32_t(p[1]) << 16 | uint32_t(p[2]) << 8 | p[3];
  for (int i = 16; i < 64; ++i) {
    const uint32_t x = w[i - 15], y = w[i - 2];
    w[i] = w[i - 16] + w[i - 7] + (rotated(x, 7) ^ rotated(x, 18) ^ x >> 3) +
           (rotated(y, 17) ^ rotated(y, 19) ^ y >> 10);
  }
  for (int i = 0; i < 64; i += 8) {  // the eight words change their names instead of their places
    sha256_round(a, b, c, &d, e, f, g, &k, kRound[i] + w[i]);
    sha256_round(k, a, b, &c, d, e, f, &g, kRound[i + 1] + w[i + 1]);
    sha256_round(g, k, a, &b, c, d, e, &f, kRound[i + 2] + w[i + 2]);
    sha256_round(f, g, k, &a, b, c, d, &e, kRound[i + 3] + w[i + 3]);
    sha256_round(e, f, g, &k, a, b, c, &d, kRound[i + 4] + w[i + 4]);
    sha256_round(d, e, f, &g, k, a, b, &c, kRound[i + 5] + w[i + 5]);
    sha256_round(c, d, e, &f, g, k, a, &b, kRound[i + 6] + w[i + 6]);
    sha256_round(b, c, d, &e, f, g, k, &a, kRound[i + 7] + w[i + 7]);
  }
  h[0] += a, h[1] += b, h[2] += c, h[3] += d, h[4] += e, h[5] += f, h[6] += g, h[7] += k;
}

inline std::string sha256(const void* data, uint64_t size) {
  const uint8_t* p = static_cast<const uint8_t*>(data);
  uint32_t h[8] = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                   0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  uint64_t left = size;
  for (; left >= 64; left -= 64, p += 64) sha256_block(h, p);
  uint8_t end[128] = {0};  // the rest of the bytes, a bit 1, zeros, the number of bits
  const int total = left < 56 ? 64 : 128;
  std::copy(p, p + left, end);
  end[left] = 0x80;
  for (int i = 0; i < 8; ++i) end[total - 1 - i] = uint8_t(8 * size >> 8 * i);
  for (int i = 0; i < total; i += 64) sha256_block(h, end + i);
  std::string hex;
  for (int i = 0; i < 64; ++i) hex += "0123456789abcdef"[h[i / 8] >> (28 - 4 * (i % 8)) & 15];
  return hex;
}
