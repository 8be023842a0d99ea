// SPDX-License-Identifier: Apache-2.0 OR MIT
// big.h: integers of any size, sign and magnitude. Schoolbook arithmetic, O(n m) limb operations.
#pragma once
#include "../common/numbers.h"

// Limbs, the first few of them without an allocation: most integers here have one to three. Small, because a model may
// have millions of numbers.
class LimbList {
 public:
  LimbList() {}
  LimbList(const LimbList& a) : at_(a.at_) {
    if (!a.is_far()) size_ = a.size_;
    if (a.is_far()) assign(a);
  }
  LimbList(LimbList&& a) noexcept : size_(a.size_), room_(a.room_), at_(a.at_) {
    a.size_ = 0, a.room_ = kNear;
  }
  LimbList& operator=(const LimbList& a) {
    if (this != &a) assign(a);
    return *this;
  }
  LimbList& operator=(LimbList&& a) noexcept {
    std::swap(size_, a.size_), std::swap(room_, a.room_), std::swap(at_, a.at_);
    return *this;
  }
  ~LimbList() {
    if (is_far()) delete[] at_.far;
  }
  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const uint64_t* begin() const { return is_far() ? at_.far : at_.near; }
  const uint64_t* end() const { return begin() + size_; }
  uint64_t* begin() { return is_far() ? at_.far : at_.near; }
  uint64_t* end() { return begin() + size_; }
  uint64_t operator[](size_t i) const { return begin()[i]; }
  uint64_t& operator[](size_t i) { return begin()[i]; }
  uint64_t back() const { return begin()[size_ - 1]; }
  uint64_t& back() { return begin()[size_ - 1]; }
  void push_back(uint64_t limb) { resize(size_ + 1, limb); }
  void resize(size_t n, uint64_t limb) {
    if (n > room_) {
      const size_t room = std::max<size_t>(n, 2 * room_);
      uint64_t* const far = new uint64_t[room];
      std::copy(begin(), end(), far);
      if (is_far()) delete[] at_.far;
      at_.far = far, room_ = uint32_t(room);
    }
    if (n > size_) std::fill(end(), begin() + n, limb);
    size_ = uint32_t(n);
  }
  friend bool operator==(const LimbList& a, const LimbList& b) {
    return a.size_ == b.size_ && std::equal(a.begin(), a.end(), b.begin());
  }

 private:
  static constexpr uint32_t kNear = 4;
  bool is_far() const { return room_ > kNear; }
  void assign(const LimbList& a) {
    resize(a.size_, 0);
    std::copy(a.begin(), a.end(), begin());
  }

  uint32_t size_ = 0, room_ = kNear;
  union {
    uint64_t near[kNear];
    uint64_t* far;
  } at_ = {{}};
};

struct Big {
  bool neg = false;
  LimbList m;  // least significant limb first, the last one is not 0; zero: empty

  Big(int64_t v = 0) : neg(v < 0) {
    if (v != 0) m.push_back(magnitude(v));
  }
  static Big of(const uint64_t* limbs, int n) {  // a two's complement number
    Big r;
    r.neg = limbs[n - 1] >> 63 != 0;
    u128 carry = r.neg;
    for (int i = 0; i < n; ++i, carry >>= 64) {
      carry += r.neg ? ~limbs[i] : limbs[i];
      r.m.push_back(uint64_t(carry));
    }
    return r.trim();
  }
  void store(uint64_t* limbs, int n) const {  // REQUIRES bits() < 64 n
    u128 carry = neg;
    for (int i = 0; i < n; ++i, carry >>= 64) {
      const uint64_t limb = size_t(i) < m.size() ? m[size_t(i)] : 0;
      carry += neg ? ~limb : limb;
      limbs[i] = uint64_t(carry);
    }
  }
  Big& trim() {
    size_t n = m.size();
    while (n > 0 && m[n - 1] == 0) --n;
    m.resize(n, 0);
    neg = neg && !m.empty();
    return *this;
  }
  bool is_one() const { return !neg && m.size() == 1 && m[0] == 1; }
  int sign() const { return m.empty() ? 0 : neg ? -1 : 1; }
  int64_t bits() const {  // the magnitude's
    return m.empty() ? 0 : 64 * int64_t(m.size()) - 64 + bit_length(m.back());
  }
  int64_t zeros() const {  // how often 2 divides it; 2^60 if it is 0
    for (size_t i = 0; i < m.size(); ++i)
      if (m[i] != 0) return 64 * int64_t(i) + __builtin_ctzll(m[i]);
    return int64_t(1) << 60;
  }
};

inline int compare_magnitudes(const Big& a, const Big& b) {
  if (a.m.size() != b.m.size()) return a.m.size() < b.m.size() ? -1 : 1;
  for (size_t i = a.m.size(); i-- > 0;)
    if (a.m[i] != b.m[i]) return a.m[i] < b.m[i] ? -1 : 1;
  return 0;
}
inline Big operator-(Big a) {
  a.neg = !a.neg && !a.m.empty();
  return a;
}
inline Big operator+(const Big& a, const Big& b) {
  const bool is_less = compare_magnitudes(a, b) < 0, differ = a.neg != b.neg;
  const Big &l = is_less ? b : a, &s = is_less ? a : b;
  Big r = l;
  u128 carry = differ;  // l - s = l + ~s + 1
  for (size_t i = 0; i < r.m.size(); ++i, carry >>= 64) {
    const uint64_t limb = i < s.m.size() ? s.m[i] : 0;
    carry += u128(r.m[i]) + (differ ? ~limb : limb);
    r.m[i] = uint64_t(carry);
  }
  if (!differ && carry != 0) r.m.push_back(1);
  return r.trim();
}
inline Big operator-(const Big& a, const Big& b) { return a + -b; }
inline Big operator*(const Big& a, const Big& b) {
  Big r;
  r.neg = a.neg != b.neg;
  if (a.m.size() == 1 && b.m.size() == 1) {
    const u128 product = u128(a.m[0]) * b.m[0];
    r.m.push_back(uint64_t(product));
    if (product >> 64 != 0) r.m.push_back(uint64_t(product >> 64));
    return r;
  }
  r.m.resize(a.m.size() + b.m.size(), 0);
  for (size_t i = 0; i < a.m.size(); ++i) {
    u128 carry = 0;
    for (size_t j = 0; j < b.m.size(); ++j, carry >>= 64) {
      carry += u128(a.m[i]) * b.m[j] + r.m[i + j];
      r.m[i + j] = uint64_t(carry);
    }
    r.m[i + b.m.size()] = uint64_t(carry);
  }
  return r.trim();
}
inline Big shifted(const Big& a, int64_t up) {  // a 2^up; if up < 0, the magnitude is rounded down
  if (up == 0) return a;
  Big r;
  r.neg = a.neg;
  const int64_t limbs = up >= 0 ? up / 64 : -((63 - up) / 64), n = int64_t(a.m.size());
  const int low = int(up - 64 * limbs);
  r.m.resize(size_t(std::max<int64_t>(0, n + limbs + 1)), 0);
  for (int64_t k = std::max<int64_t>(0, -limbs - 1); k < n; ++k) {
    const u128 limb = u128(a.m[size_t(k)]) << low;
    if (k + limbs >= 0) r.m[size_t(k + limbs)] |= uint64_t(limb);
    r.m[size_t(k + limbs + 1)] |= uint64_t(limb >> 64);
  }
  return r.trim();
}
inline int compare(const Big& a, const Big& b) {
  if (a.neg != b.neg) return a.neg ? -1 : 1;
  return a.neg ? compare_magnitudes(b, a) : compare_magnitudes(a, b);
}
inline bool operator==(const Big& a, const Big& b) { return a.neg == b.neg && a.m == b.m; }
inline bool operator<(const Big& a, const Big& b) { return compare(a, b) < 0; }

// divide() by a number of one limb.
inline Big divide_by_limb(const Big& a, const Big& b, Big* rest) {
  Big q = a;
  uint64_t r = 0;
  for (size_t i = q.m.size(); i-- > 0;) {
    const u128 t = u128(r) << 64 | q.m[i];
    q.m[i] = r == 0 ? q.m[i] / b.m[0] : uint64_t(t / b.m[0]);
    r = uint64_t(t - u128(q.m[i]) * b.m[0]);
  }
  q.neg = a.neg != b.neg;
  if (rest != nullptr) {
    Big left;
    left.m.push_back(r);
    left.neg = a.neg;
    *rest = left.trim();
  }
  return q.trim();
}
// The quotient rounded towards zero; *rest has the sign of a. REQUIRES b != 0. [Knuth, 4.3.1 D]
inline Big divide(const Big& a, const Big& b, Big* rest) {
  if (b.m.size() == 1) return divide_by_limb(a, b, rest);
  Big q;
  const int up = 64 - bit_length(b.m.back());
  Big r = shifted(a, up);
  const Big d = shifted(b, up);
  const size_t n = d.m.size();
  r.m.resize(std::max(r.m.size(), n) + 1, 0);
  q.m.resize(r.m.size() - n, 0);
  for (size_t k = q.m.size(); k-- > 0;) {
    const u128 top = u128(r.m[k + n]) << 64 | r.m[k + n - 1];
    u128 guess = std::min<u128>(top / d.m[n - 1], ~uint64_t(0));  // too large by 2 at most
    for (;; --guess) {
      u128 carry = 0, borrow = 0;
      std::vector<uint64_t> next(n + 1);
      for (size_t i = 0; i <= n; ++i, carry >>= 64) {
        carry += i < n ? guess * d.m[i] : 0;
        const u128 t = u128(r.m[k + i]) - uint64_t(carry) - borrow;
        next[i] = uint64_t(t);
        borrow = t >> 64 != 0;
      }
      if (borrow != 0) continue;
      std::copy(next.begin(), next.end(), r.m.begin() + k);
      break;
    }
    q.m[k] = uint64_t(guess);
  }
  q.neg = a.neg != b.neg;
  if (rest != nullptr) *rest = shifted(r.trim(), -up);
  return q.trim();
}
inline Big gcd(Big a, Big b) {  // >= 0
  a.neg = b.neg = false;
  const int64_t twos = std::min(a.zeros(), b.zeros());
  while (!b.m.empty()) {  // powers of two were counted, and may be divided out of either
    if (!a.m.empty()) a = shifted(a, -a.zeros());
    b = shifted(b, -b.zeros());
    if (b.is_one()) return shifted(b, twos);
    if (a.m.size() <= 1 && b.m.size() == 1) {
      uint64_t x = a.m.empty() ? 0 : a.m[0], y = b.m[0];
      for (; x != 0; std::swap(x, y)) y %= x;
      b.m[0] = y;
      return shifted(b, twos);
    }
    Big rest;
    if (!a.m.empty()) divide(a, b, &rest);
    a = b;
    b = rest;
  }
  return a.m.empty() ? a : shifted(shifted(a, -a.zeros()), twos);
}

struct
    Ratio {  // n / d, d > 0; results of functions are in lowest terms, and then equal iff n and d are
  Big n, d;
  Ratio(Big num = Big(), Big den = Big(1)) : n(std::move(num)), d(std::move(den)) {}
};
inline bool operator==(const Ratio& a, const Ratio& b) { return a.n == b.n && a.d == b.d; }
inline int compare(const Ratio& a, const Ratio& b) { return compare(a.n * b.d, b.n * a.d); }
inline Ratio lowest(const Ratio& a) {
  const Big g = gcd(a.n, a.d);
  if (g.is_one()) return a;
  return Ratio(divide(a.n, g, nullptr), divide(a.d, g, nullptr));
}
inline Ratio operator-(const Ratio& a, const Ratio& b) {
  return lowest(Ratio(a.n * b.d - b.n * a.d, a.d * b.d));
}
inline Ratio scaled(const Ratio& a, int64_t up) {  // a 2^up; lowest terms stay lowest
  const int64_t both = std::min(up < 0 ? -up : up, (up < 0 ? a.n : a.d).zeros());
  if (up < 0) return Ratio(shifted(a.n, -both), shifted(a.d, -up - both));
  return Ratio(shifted(a.n, up - both), shifted(a.d, -both));
}
