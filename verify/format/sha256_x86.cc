// SPDX-License-Identifier: Apache-2.0 OR MIT
// verify/format/sha256_x86.cc: the compression function with the x86 SHA instructions, chosen at run time.
// Source: Intel, "Intel SHA Extensions" (2013): the instructions keep the state as (A,B,E,F) and (C,D,G,H).
// This folder includes the standard library only; GCC (from 12) and clang know these instructions without a header.
#include <cstring>

#include "verify/format/sha256.h"
#include "verify/format/sha256_constants.h"

#if defined(__x86_64__) && (defined(__clang__) || (defined(__GNUC__) && __GNUC__ >= 12))

namespace veritope::internal {
namespace {

using Int4 = int __attribute__((vector_size(16)));
using Word4 = unsigned __attribute__((vector_size(16)));
using Char16 = char __attribute__((vector_size(16)));

#define VT_SHA_TARGET __attribute__((target("sha,sse4.1,ssse3")))

struct CpuId {
  unsigned a = 0, b = 0, c = 0, d = 0;
  explicit CpuId(unsigned leaf) {
    __asm__("cpuid" : "=a"(a), "=b"(b), "=c"(c), "=d"(d) : "a"(leaf), "c"(0));
  }
};

bool has_sha_instructions() {
  if (CpuId(0).a < 7) return false;
  const bool has_sse = (CpuId(1).c >> 9 & 1) != 0 && (CpuId(1).c >> 19 & 1) != 0;  // SSSE3, SSE4.1
  return has_sse && (CpuId(7).b >> 29 & 1) != 0;
}

VT_SHA_TARGET inline Int4 load(const void* p) {
  Int4 words;
  std::memcpy(&words, p, sizeof words);
  return words;
}

VT_SHA_TARGET inline Int4 add(Int4 a, Int4 b) {
  return reinterpret_cast<Int4>(reinterpret_cast<Word4>(a) + reinterpret_cast<Word4>(b));
}

VT_SHA_TARGET inline Int4 load_big_endian(const unsigned char* p) {
  const auto bytes = reinterpret_cast<Char16>(load(p));
  return reinterpret_cast<Int4>(
      __builtin_shufflevector(bytes, bytes, 3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12));
}

VT_SHA_TARGET void blocks_sha(std::uint32_t* state, const unsigned char* blocks, std::size_t num) {
  const Int4 abcd = load(state), efgh = load(state + 4);
  Int4 abef = __builtin_shufflevector(abcd, efgh, 5, 4, 1, 0);  // lane 0 holds F
  Int4 cdgh = __builtin_shufflevector(abcd, efgh, 7, 6, 3, 2);
  for (; num > 0; --num, blocks += 64) {
    const Int4 abef_before = abef, cdgh_before = cdgh;
    Int4 w[4];  // the last sixteen words of the schedule
#pragma GCC unroll 16
    for (int i = 0; i < 16; ++i) {
      if (i < 4) {
        w[i] = load_big_endian(blocks + 16 * i);
      } else {
        const Int4 w1 = w[(i + 1) & 3], w2 = w[(i + 2) & 3], w3 = w[(i + 3) & 3];
        const Int4 w7 = __builtin_shufflevector(w2, w3, 1, 2, 3, 4);
        w[i & 3] = __builtin_ia32_sha256msg2(add(__builtin_ia32_sha256msg1(w[i & 3], w1), w7), w3);
      }
      const Int4 input = add(w[i & 3], load(kSha256Rounds + 4 * i));
      const Int4 upper = __builtin_shufflevector(input, input, 2, 3, 0, 0);
      cdgh = __builtin_ia32_sha256rnds2(cdgh, abef, input);
      abef = __builtin_ia32_sha256rnds2(abef, cdgh, upper);
    }
    abef = add(abef, abef_before);
    cdgh = add(cdgh, cdgh_before);
  }
  const Int4 after_abcd = __builtin_shufflevector(abef, cdgh, 3, 2, 7, 6);
  const Int4 after_efgh = __builtin_shufflevector(abef, cdgh, 1, 0, 5, 4);
  std::memcpy(state, &after_abcd, sizeof after_abcd);
  std::memcpy(state + 4, &after_efgh, sizeof after_efgh);
}

}  // namespace

Sha256Blocks sha256_blocks_x86() { return has_sha_instructions() ? blocks_sha : nullptr; }

}  // namespace veritope::internal

#else

namespace veritope::internal {
Sha256Blocks sha256_blocks_x86() { return nullptr; }
}  // namespace veritope::internal

#endif
