// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/box.h: products of intervals: sets of points in the plane, in space, in any dimension.
#pragma once
#include <array>
#include <cstddef>
#include <utility>

#include "interval/numeric.h"
#include "interval/relations.h"
#include "robust/base/check.h"

namespace veritope {

/// x[0] x ... x x[N - 1]; one empty side makes the whole set empty. Arithmetic is that of vectors.
/// REQUIRES for + and - and scaling a live ScopedUpward, as Interval does; the rest is exact.
template <std::size_t N>
class Box {
  static_assert(N > 0);

 public:
  /// The origin.
  constexpr Box() = default;
  template <typename... Sides>
  requires(sizeof...(Sides) == N) constexpr explicit Box(const Sides&... sides)
      : sides_{Interval(sides)...} {}
  static constexpr Box empty() { return filled(Interval::empty()); }
  static constexpr Box entire() { return filled(Interval::entire()); }
  static constexpr Box filled(const Interval& side) {
    Box out;
    for (Interval& s : out.sides_) s = side;
    return out;
  }

  static constexpr std::size_t dimension() { return N; }
  const Interval& operator[](std::size_t i) const { return sides_[i]; }
  Interval& operator[](std::size_t i) { return sides_[i]; }
  auto begin() const { return sides_.begin(); }
  auto end() const { return sides_.end(); }

  bool is_empty() const {
    for (const Interval& s : sides_)
      if (s.is_empty()) return true;
    return false;
  }

  friend Box operator+(const Box& a, const Box& b) {
    return each(a, b, [](const Interval& x, const Interval& y) { return x + y; });
  }
  friend Box operator-(const Box& a, const Box& b) {
    return each(a, b, [](const Interval& x, const Interval& y) { return x - y; });
  }
  friend Box operator*(const Interval& k, const Box& a) {
    return each(a, a, [&k](const Interval& x, const Interval&) { return k * x; });
  }
  /// Equal as sets.
  friend bool operator==(const Box& a, const Box& b) {
    if (a.is_empty() || b.is_empty()) return a.is_empty() && b.is_empty();
    return a.sides_ == b.sides_;
  }

  template <typename F>
  static Box each(const Box& a, const Box& b, F f) {
    Box out;
    for (std::size_t i = 0; i < N; ++i) out.sides_[i] = f(a.sides_[i], b.sides_[i]);
    return out;
  }

 private:
  std::array<Interval, N> sides_{};
};

using Box2 = Box<2>;
using Box3 = Box<3>;

template <std::size_t N>
Box<N> intersection(const Box<N>& a, const Box<N>& b) {
  return Box<N>::each(a, b,
                      [](const Interval& x, const Interval& y) { return intersection(x, y); });
}
/// The least box around both.
template <std::size_t N>
Box<N> hull(const Box<N>& a, const Box<N>& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  return Box<N>::each(a, b, [](const Interval& x, const Interval& y) { return hull(x, y); });
}
template <std::size_t N>
bool is_subset(const Box<N>& a, const Box<N>& b) {
  bool out = true;
  for (std::size_t i = 0; i < N; ++i) out = out && is_subset(a[i], b[i]);
  return out || a.is_empty();
}
/// a lies in the topological interior of b.
template <std::size_t N>
bool is_interior(const Box<N>& a, const Box<N>& b) {
  bool out = true;
  for (std::size_t i = 0; i < N; ++i) out = out && is_interior(a[i], b[i]);
  return out || a.is_empty();
}
template <std::size_t N>
bool is_disjoint(const Box<N>& a, const Box<N>& b) {
  for (std::size_t i = 0; i < N; ++i)
    if (is_disjoint(a[i], b[i])) return true;
  return false;
}
/// The point is a member.
template <std::size_t N>
bool contains(const Box<N>& a, const std::array<double, N>& point) {
  for (std::size_t i = 0; i < N; ++i)
    if (!is_member(point[i], a[i])) return false;
  return true;
}

/// A member, next to the middle of each side. REQUIRES nonempty.
template <std::size_t N>
std::array<double, N> mid(const Box<N>& a) {
  VT_CHECK(!a.is_empty(), "mid of an empty box");
  std::array<double, N> out;
  for (std::size_t i = 0; i < N; ++i) out[i] = mid(a[i]);
  return out;
}
/// The index of the widest side; on a tie the first. REQUIRES nonempty.
template <std::size_t N>
std::size_t widest_side(const Box<N>& a) {
  VT_CHECK(!a.is_empty(), "widest side of an empty box");
  std::size_t best = 0;
  for (std::size_t i = 1; i < N; ++i)
    if (internal::less(wid(a[best]), wid(a[i]))) best = i;
  return best;
}
/// The largest width of a side, rounded upward. REQUIRES nonempty.
template <std::size_t N>
double width(const Box<N>& a) {
  return wid(a[widest_side(a)]);
}
/// Two boxes whose union is a, cut at mid of that side; both are a itself if the side cannot be cut
/// (it holds fewer than three binary64 numbers). REQUIRES nonempty, side < N.
template <std::size_t N>
std::pair<Box<N>, Box<N>> split(const Box<N>& a, std::size_t side) {
  VT_CHECK(!a.is_empty() && side < N, "split of an empty box or at no side");
  const internal::Bits cut = internal::bits_of(mid(a[side]));
  std::pair<Box<N>, Box<N>> out(a, a);
  if (internal::less(a[side].lo_bits(), cut) && internal::less(cut, a[side].hi_bits())) {
    out.first[side] = Interval::from_bits(a[side].lo_bits(), cut);
    out.second[side] = Interval::from_bits(cut, a[side].hi_bits());
  }
  return out;
}

}  // namespace veritope
