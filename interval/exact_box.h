// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/exact_box.h: boxes with rational bounds. The solvers name places by such boxes, as fine as the problem
// needs. No floating point is involved, and no function rounds unless its comment says so.
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "robust/rational.h"

namespace veritope {

/// { x : lo <= x <= hi }, lo <= hi.
struct ExactInterval {
  Rational lo, hi;

  Rational width() const { return hi - lo; }
  bool contains(const Rational& x) const { return lo <= x && x <= hi; }
  friend bool operator==(const ExactInterval&, const ExactInterval&) = default;
};
/// The least interval that contains both.
inline ExactInterval hull(const ExactInterval& a, const ExactInterval& b) {
  return {b.lo < a.lo ? b.lo : a.lo, a.hi < b.hi ? b.hi : a.hi};
}

/// side[0] x ... x side[N - 1].
template <std::size_t N>
struct ExactBox {
  std::array<ExactInterval, N> side;

  static ExactBox unit() {
    ExactBox out;
    for (ExactInterval& s : out.side) s = {Rational(0), Rational(1)};
    return out;
  }
  const ExactInterval& operator[](std::size_t i) const { return side[i]; }
  ExactInterval& operator[](std::size_t i) { return side[i]; }
  friend bool operator==(const ExactBox&, const ExactBox&) = default;

  bool contains(const std::array<Rational, N>& x) const {
    for (std::size_t i = 0; i < N; ++i)
      if (!side[i].contains(x[i])) return false;
    return true;
  }
  /// The length of the longest side.
  Rational width() const {
    Rational out;
    for (const ExactInterval& s : side)
      if (out < s.width()) out = s.width();
    return out;
  }
  std::array<Rational, N> middle() const {
    std::array<Rational, N> out;
    for (std::size_t i = 0; i < N; ++i) out[i] = (side[i].lo + side[i].hi) / Rational(2);
    return out;
  }
};

/// True if the closed boxes share a point.
template <std::size_t N>
bool touches(const ExactBox<N>& a, const ExactBox<N>& b) {
  for (std::size_t i = 0; i < N; ++i)
    if (a[i].hi < b[i].lo || b[i].hi < a[i].lo) return false;
  return true;
}
template <std::size_t N>
bool is_subset(const ExactBox<N>& a, const ExactBox<N>& b) {
  for (std::size_t i = 0; i < N; ++i)
    if (a[i].lo < b[i].lo || b[i].hi < a[i].hi) return false;
  return true;
}
template <std::size_t N>
ExactBox<N> hull(const ExactBox<N>& a, const ExactBox<N>& b) {
  ExactBox<N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = hull(a[i], b[i]);
  return out;
}
/// REQUIRES touches(a, b).
template <std::size_t N>
ExactBox<N> intersection(const ExactBox<N>& a, const ExactBox<N>& b) {
  ExactBox<N> out = a;
  for (std::size_t i = 0; i < N; ++i) {
    if (out[i].lo < b[i].lo) out[i].lo = b[i].lo;
    if (b[i].hi < out[i].hi) out[i].hi = b[i].hi;
  }
  return out;
}
/// The image of `local`, a box in the coordinates in which `frame` is [0,1]^N.
template <std::size_t N>
ExactBox<N> placed(const ExactBox<N>& local, const ExactBox<N>& frame) {
  ExactBox<N> out;
  for (std::size_t i = 0; i < N; ++i) {
    const Rational w = frame[i].width();
    out[i] = {frame[i].lo + w * local[i].lo, frame[i].lo + w * local[i].hi};
  }
  return out;
}
/// The box in the coordinates in which `frame` is [0,1]^N. REQUIRES that no side of the frame is a point.
template <std::size_t N>
ExactBox<N> seen_from(const ExactBox<N>& box, const ExactBox<N>& frame) {
  ExactBox<N> out;
  for (std::size_t i = 0; i < N; ++i) {
    const Rational w = frame[i].width();
    out[i] = {(box[i].lo - frame[i].lo) / w, (box[i].hi - frame[i].lo) / w};
  }
  return out;
}
/// The hulls of the connected components of the union.
template <std::size_t N>
std::vector<ExactBox<N>> component_hulls(std::vector<ExactBox<N>> boxes) {
  std::vector<ExactBox<N>> out;
  for (ExactBox<N>& box : boxes) {
    // A hull may touch a box that its own boxes do not touch; it is merged too, until no two hulls touch.
    for (std::size_t i = 0; i < out.size();) {
      if (!touches(out[i], box)) {
        ++i;
        continue;
      }
      box = hull(box, out[i]);
      out[i] = std::move(out.back());
      out.pop_back();
      i = 0;
    }
    out.push_back(std::move(box));
  }
  return out;
}

/// The largest integer e with 2^e <= |x|. REQUIRES x != 0.
std::int64_t floor_log2(const Rational& x);
/// Moves the ends outward to multiples of 2^-bits.
ExactInterval rounded_outward(const ExactInterval& a, std::int64_t bits);
/// Moves the sides outward by less than 2^-20 of their widths (of `least` if that is larger), so that bounds stay
/// short. REQUIRES least > 0.
template <std::size_t N>
ExactBox<N> shortened(const ExactBox<N>& a, const Rational& least) {
  ExactBox<N> out;
  for (std::size_t i = 0; i < N; ++i) {
    const Rational w = a[i].width();
    out[i] = rounded_outward(a[i], 21 - floor_log2(w < least ? least : w));
  }
  return out;
}
/// The fraction with the least denominator in a; on a tie the one whose numerator has the least absolute value.
Rational simplest_member(const ExactInterval& a);
/// "[lo, hi] x ...", exact.
template <std::size_t N>
std::string to_string(const ExactBox<N>& a) {
  std::string out;
  for (std::size_t i = 0; i < N; ++i)
    out += (i > 0 ? " x [" : "[") + a[i].lo.to_string() + ", " + a[i].hi.to_string() + "]";
  return out;
}

}  // namespace veritope
