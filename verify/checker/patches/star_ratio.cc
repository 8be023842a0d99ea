// SPDX-License-Identifier: Apache-2.0 OR MIT
#include "star_ratio.h"

namespace {

__extension__ typedef __int128 i128;

int64_t limited(i128 q) {
  return int64_t(std::max<i128>(-kFarthest, std::min<i128>(kFarthest, q)));
}
// floor(q / 2^shift); *exact becomes false where this is less.
i128 shifted(i128 q, int shift, bool* exact) {
  if ((q & ((i128(1) << shift) - 1)) != 0) *exact = false;
  return q >> shift;
}

int bits_of_natural(const uint64_t* a, int n) {
  while (n > 0 && a[n - 1] == 0) --n;
  return n == 0 ? 0 : 64 * n - 64 + bit_length(a[n - 1]);
}
// floor(a / 2^from) mod 2^64; from may be negative: then a 2^-from.
uint64_t bits_from(const uint64_t* a, int n, int from) {
  const int limb = from >> 6, bit = from & 63;
  const auto at = [&](int i) { return i >= 0 && i < n ? a[i] : 0; };
  return bit == 0 ? at(limb) : at(limb) >> bit | at(limb + 1) << (64 - bit);
}

// y = floor(abs(x) / 2^shift); *exact: whether nothing was cut off.
void set_magnitude(const uint64_t* x, int n, int shift, uint64_t* y, bool* exact) {
  const bool is_negative = x[n - 1] >> 63 != 0;
  bool carry = is_negative;
  for (int i = 0; i < n; ++i) {
    y[i] = (is_negative ? ~x[i] : x[i]) + carry;
    carry = carry && y[i] == 0;
  }
  const int limbs = shift >> 6, bits = shift & 63;
  uint64_t lost = bits == 0 || limbs >= n ? 0 : y[limbs] << (64 - bits);
  for (int i = 0; i < limbs && i < n; ++i) lost |= y[i];
  *exact = lost == 0;
  if (shift == 0) return;
  for (int i = 0; i < n; ++i) y[i] = bits_from(y, n, 64 * i + shift);
}

// The sign of y - q w.
int sign_of_rest(const uint64_t* y, const uint64_t* w, int n, uint64_t q) {
  uint64_t carry = 0, any = 0;
  bool borrow = false;
  for (int i = 0; i < n; ++i) {
    const u128 product = u128(q) * w[i] + carry;
    const u128 difference = u128(y[i]) - uint64_t(product) - borrow;
    carry = uint64_t(product >> 64);
    borrow = difference >> 64 != 0;
    any |= uint64_t(difference);
  }
  return carry != 0 || borrow ? -1 : any != 0;
}

// floor(y / w) for natural numbers, w > 0; 2^62 if it may be over 2^61. *exact becomes false where something was
// rounded.
//
// With d the highest 64 bits of w, from 2^k on, and t = floor(y / 2^k), floor(t / d) is the quotient or one more: y
// / w < (t + 1) / d, and y / w > t / (d + 1) > t / d - 1, since t / d < 2^63 and d >= 2^63. If it is one more, the
// quotient is not exact: y = Q w would give t / d <= Q (1 + 1 / d) < Q + 1.
uint64_t quotient(const uint64_t* y, const uint64_t* w, int n, bool* exact) {
  const int of_y = bits_of_natural(y, n), of_w = bits_of_natural(w, n), k = of_w - 64;
  if (of_y - of_w > 61) return uint64_t(1) << 62;
  const u128 t = u128(bits_from(y, n, k + 64)) << 64 | bits_from(y, n, k);
  const uint64_t q = uint64_t(t / bits_from(w, n, k));
  const int rest = sign_of_rest(y, w, n, q);
  if (rest != 0) *exact = false;
  return q - (rest < 0);
}

}  // namespace

int64_t floor_ratio(const uint64_t* x, const uint64_t* w, int n, int shift, bool* exact) {
  while (n > 2 && x[n - 1] == 0 - (x[n - 2] >> 63) && w[n - 1] == 0 && w[n - 2] >> 63 == 0) --n;
  if (n == 1) {
    const int64_t a = int64_t(*x), d = int64_t(*w), q = a / d - (a % d < 0);
    *exact = a % d == 0;
    return limited(shifted(q, shift, exact));
  }
  if (n == 2) {
    const i128 a = i128(u128(x[1]) << 64 | x[0]), d = i128(u128(w[1]) << 64 | w[0]);
    const i128 q = a / d - (a % d < 0);
    *exact = a % d == 0;
    return limited(shifted(q, shift, exact));
  }
  static thread_local std::vector<uint64_t> y;  // kept, so that no memory is asked for
  y.resize(size_t(n));
  set_magnitude(x, n, shift, y.data(), exact);
  const i128 q = i128(quotient(y.data(), w, n, exact));
  return limited(x[n - 1] >> 63 != 0 ? -q - !*exact : q);
}
