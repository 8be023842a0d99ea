// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/implicit_cache.h: an implicit point that remembers its exact digits from the first exact question on. It
// is for points that occur in many questions; it costs programs without such points nothing.
#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

#include "predicates/implicit_lattice.h"
#include "predicates/implicit_point.h"
#include "robust/digits.h"

namespace veritope {

namespace internal {

/// base + u t / denominator on the lattice; the denominator's sign is not normalised.
struct LinePlaneDigits {
  LatticeUnit lattice;
  std::array<std::int64_t, 3> base, u;
  Digits<3> t, denominator;
};
/// base + numerator / denominator.
struct ThreePlanesDigits {
  LatticeUnit lattice;
  std::array<std::int64_t, 3> base;
  std::array<Digits<7>, 3> numerator;
  Digits<6> denominator;
};
template <typename P>
using PointDigits =
    std::conditional_t<std::is_same_v<P, LinePlanePoint>, LinePlaneDigits, ThreePlanesDigits>;

/// Sets the digits; returns false if the coordinates of the defining points fit no lattice of 59 bits.
bool find_digits(const LinePlanePoint& p, LinePlaneDigits& out) noexcept;
bool find_digits(const ThreePlanePoint& p, ThreePlanesDigits& out) noexcept;
/// The sign of the orientation times that of the denominator; uncertain if a, b, c are not on the point's
/// lattice, or beyond 2^60.
Sign3 orientation_of_digits(const LinePlaneDigits& p, const Vec3d& a, const Vec3d& b,
                            const Vec3d& c) noexcept;
Sign3 orientation_of_digits(const ThreePlanesDigits& p, const Vec3d& a, const Vec3d& b,
                            const Vec3d& c) noexcept;

}  // namespace internal

/// A LinePlanePoint or a ThreePlanePoint and, from the first exact question on, its digits: 15 and 33 words. Any number
/// of threads may question the same point at the same time, and none waits: one computes the digits, the others decide
/// without them until they are there. Nothing is allocated.
template <typename P>
class CachedPoint {
 public:
  explicit CachedPoint(const P& p) noexcept : point_(p) {}
  /// The copy computes its digits again.
  CachedPoint(const CachedPoint& other) noexcept : point_(other.point_) {}
  CachedPoint& operator=(const CachedPoint&) = delete;

  const P& point() const { return point_; }
  bool is_defined() const noexcept { return point_.is_defined(); }
  /// Null if the point has no digits, or another thread is computing them just now.
  const internal::PointDigits<P>* digits() const noexcept {
    const State state = state_.load(std::memory_order_acquire);
    return state == State::kReady ? &digits_ : (state == State::kUnasked ? find() : nullptr);
  }

 private:
  enum class State : std::uint8_t { kUnasked, kBusy, kReady, kNone };

  const internal::PointDigits<P>* find() const noexcept {
    State state = State::kUnasked;
    if (!state_.compare_exchange_strong(state, State::kBusy, std::memory_order_acquire)) {  // NOT COVERED: a race
      return state == State::kReady ? &digits_ : nullptr;  // NOT COVERED: when threads meet
    }
    const bool found = internal::find_digits(point_, digits_);
    state_.store(found ? State::kReady : State::kNone, std::memory_order_release);
    return found ? &digits_ : nullptr;
  }

  P point_;
  mutable internal::PointDigits<P> digits_;  // written once, before kReady is published
  mutable std::atomic<State> state_{State::kUnasked};
};

/// Like orient3d of the point itself.
Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const CachedPoint<LinePlanePoint>& d,
              TierCounts* tally = nullptr);
Sign orient3d(const Vec3d& a, const Vec3d& b, const Vec3d& c, const CachedPoint<ThreePlanePoint>& d,
              TierCounts* tally = nullptr);

}  // namespace veritope
