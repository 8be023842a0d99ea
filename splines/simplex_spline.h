// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/simplex_spline.h: simplex splines of three variables, M(u|V) of degree k for k + 4 knots V, by their
// recurrence. Which tetrahedra of knots contain u, and which knots are affinely independent, are arguments: nothing is
// compared here.
// Source: [HHQ04] eq. 1 and 2, with M = 1 / |d| on a tetrahedron, d six times its volume (docs/formats/dms-files.md).
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <unordered_map>
#include <utility>

#include "robust/base/check.h"
#include "splines/binomial.h"
#include "splines/ring.h"

namespace veritope {

/// Knots are numbered; equal numbers are one point, and different numbers may be equal points.
using KnotNumber = std::uint8_t;

/// At most kMaxSize numbers of knots, ascending, in which a number may repeat.
class KnotSet {
 public:
  static constexpr std::size_t kMaxSize = 15;

  KnotSet() = default;
  /// In any order. REQUIRES at most kMaxSize numbers.
  KnotSet(std::initializer_list<KnotNumber> knots) {
    for (const KnotNumber knot : knots) insert(knot);
  }
  std::size_t size() const { return size_; }
  KnotNumber operator[](std::size_t i) const { return knots_[i]; }
  const KnotNumber* begin() const { return knots_.data(); }
  const KnotNumber* end() const { return knots_.data() + size_; }

  /// REQUIRES size() < kMaxSize.
  void insert(KnotNumber knot) {
    VT_CHECK(size_ < kMaxSize, "a set of at most 15 knots");
    std::size_t i = size_++;
    for (; i > 0 && knots_[i - 1] > knot; --i) knots_[i] = knots_[i - 1];
    knots_[i] = knot;
  }
  /// Without one occurrence of the knot. REQUIRES that the knot occurs.
  KnotSet without(KnotNumber knot) const {
    const KnotNumber* const found = std::lower_bound(begin(), end(), knot);
    VT_CHECK(found != end() && *found == knot, "only a knot of the set can be left out");
    KnotSet rest = *this;
    const auto at = static_cast<std::size_t>(found - begin());
    std::copy(found + 1, end(), rest.knots_.begin() + static_cast<std::ptrdiff_t>(at));
    rest.knots_[--rest.size_] = 0;
    return rest;
  }

  friend bool operator==(const KnotSet&, const KnotSet&) = default;
  std::size_t hash() const {
    std::uint64_t low = 0, high = 0;
    std::memcpy(&low, knots_.data(), 8);
    std::memcpy(&high, knots_.data() + 8, 7);
    const std::uint64_t mixed =
        (low * 0x9e3779b97f4a7c15u) ^ ((high + size_) * 0xc2b2ae3d27d4eb4fu);
    return static_cast<std::size_t>(mixed ^ (mixed >> 29));
  }

 private:
  std::array<KnotNumber, kMaxSize> knots_{};  // 0 from size_ on
  std::uint8_t size_ = 0;
};

struct KnotSetHash {
  std::size_t operator()(const KnotSet& set) const { return set.hash(); }
};

/// Four affinely independent knots W = (a, b, c, e), their volume, and their barycentric coordinates as functions of u.
template <Ring R>
struct SimplexFrame {
  std::array<KnotNumber, 4> knots{};
  R volume;  ///< d(W) = det(b - a, c - a, e - a)
  R height;  ///< 1 / |d(W)|, the value of the spline of degree 0
  /// The coordinate m of u is lambda[m][0] + lambda[m][1] u_x + lambda[m][2] u_y + lambda[m][3] u_z.
  std::array<std::array<R, 4>, 4> lambda;

  std::array<R, 4> barycentric(const std::array<R, 3>& u) const {
    std::array<R, 4> at;
    for (std::size_t m = 0; m < 4; ++m)
      at[m] = lambda[m][0] + lambda[m][1] * u[0] + lambda[m][2] * u[1] + lambda[m][3] * u[2];
    return at;
  }
  /// Those of a direction, whose sum is 0.
  std::array<R, 4> barycentric_direction(const std::array<R, 3>& v) const {
    std::array<R, 4> at;
    for (std::size_t m = 0; m < 4; ++m)
      at[m] = lambda[m][1] * v[0] + lambda[m][2] * v[1] + lambda[m][3] * v[2];
    return at;
  }
};

/// The frame of four points. REQUIRES that they are affinely independent, and their orientation: the sign of d.
/// Exact over Rational.
template <Ring R>
SimplexFrame<R> simplex_frame(const std::array<KnotNumber, 4>& knots,
                              const std::array<std::array<R, 3>, 4>& points, Sign orientation);

/// The frame in another ring, its numbers enclosed or rounded as that ring can.
template <Ring R>
SimplexFrame<R> frame_in_ring(const SimplexFrame<Rational>& exact);

/// What a table of answers about one point u and a list of knots has:
///   frame(set)      four affinely independent knots of the set, or null if it has none. The frame must live as long as
///                   the table; of a set of four knots it has them in ascending order of their numbers
///   contains(f)     does the tetrahedron of the frame contain u, by one half-open rule?
template <typename A, typename R>
concept SimplexAnswers = requires(A& a, const KnotSet& set, const SimplexFrame<R>& frame) {
  { a.frame(set) } -> std::convertible_to<const SimplexFrame<R>*>;
  { a.contains(frame) } -> std::convertible_to<bool>;
};

/// The values at one point u of the simplex splines of all sets of a list of knots. Each is computed once.
template <Ring R, SimplexAnswers<R> Answers>
class SimplexSplines {
 public:
  /// The answers are about u; they must outlive this object.
  SimplexSplines(Answers& answers, std::array<R, 3> u) : answers_(answers), u_(std::move(u)) {}

  const std::array<R, 3>& point() const { return u_; }
  const SimplexFrame<R>* frame(const KnotSet& set) { return answers_.frame(set); }
  /// The barycentric coordinates of u.
  const std::array<R, 4>& barycentric(const SimplexFrame<R>& frame);

  /// M(u|V), of degree V.size() - 4. REQUIRES at least four knots. @cost a sum of four products for each set of knots
  /// that the recurrence meets for the first time
  R value(const KnotSet& knots) { return R(entry(knots).value); }
  /// Whether no tetrahedron of the recurrence contains u, so that the value is zero.
  bool is_off_support(const KnotSet& knots) { return entry(knots).is_zero; }
  /// The derivatives of M(.|V) along the axes at u, by eq. 2; zero for degree 0. REQUIRES at least four knots.
  std::array<R, 3> gradient(const KnotSet& knots);
  /// The derivative along v.
  R derivative(const KnotSet& knots, const std::array<R, 3>& v) {
    const std::array<R, 3> g = gradient(knots);
    return g[0] * v[0] + g[1] * v[1] + g[2] * v[2];
  }
  /// How many sets have been evaluated.
  std::size_t num_evaluated() const { return entries_.size(); }

 private:
  struct Entry {
    R value;
    bool is_zero = true;
  };
  const Entry& entry(const KnotSet& knots);
  Entry compute(const KnotSet& knots);

  Answers& answers_;
  std::array<R, 3> u_;
  std::unordered_map<KnotSet, Entry, KnotSetHash> entries_;
  std::unordered_map<const SimplexFrame<R>*, std::array<R, 4>> barycentric_;
};

// ---- bodies

template <Ring R>
SimplexFrame<R> simplex_frame(const std::array<KnotNumber, 4>& knots,
                              const std::array<std::array<R, 3>, 4>& points, Sign orientation) {
  VT_CHECK(orientation != Sign::kZero, "a frame has affinely independent points");
  const auto& a = points[0];
  std::array<std::array<R, 3>, 3> edge;  // from a
  for (std::size_t m = 0; m < 3; ++m)
    for (std::size_t c = 0; c < 3; ++c) edge[m][c] = points[m + 1][c] - a[c];
  const auto cross = [](const std::array<R, 3>& p, const std::array<R, 3>& q) {
    return std::array<R, 3>{p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
                            p[0] * q[1] - p[1] * q[0]};
  };
  const std::array<std::array<R, 3>, 3> normal{cross(edge[1], edge[2]), cross(edge[2], edge[0]),
                                               cross(edge[0], edge[1])};
  SimplexFrame<R> frame;
  frame.knots = knots;
  frame.volume = edge[0][0] * normal[0][0] + edge[0][1] * normal[0][1] + edge[0][2] * normal[0][2];
  const R reciprocal = one<R>() / frame.volume;
  frame.height = orientation == Sign::kPositive ? reciprocal : -reciprocal;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t m = 0; m < 3; ++m) frame.lambda[m + 1][c + 1] = normal[m][c] * reciprocal;
    frame.lambda[0][c + 1] =
        -(frame.lambda[1][c + 1] + frame.lambda[2][c + 1] + frame.lambda[3][c + 1]);
  }
  for (std::size_t m = 0; m < 4; ++m) {
    const auto& l = frame.lambda[m];
    const R at_a = l[1] * a[0] + l[2] * a[1] + l[3] * a[2];
    frame.lambda[m][0] = m == 0 ? R(one<R>() - at_a) : R(-at_a);
  }
  return frame;
}

template <Ring R>
SimplexFrame<R> frame_in_ring(const SimplexFrame<Rational>& exact) {
  SimplexFrame<R> frame;
  frame.knots = exact.knots;
  frame.volume = ring_number<R>(exact.volume);
  frame.height = ring_number<R>(exact.height);
  for (std::size_t m = 0; m < 4; ++m)
    for (std::size_t c = 0; c < 4; ++c) frame.lambda[m][c] = ring_number<R>(exact.lambda[m][c]);
  return frame;
}

template <Ring R, SimplexAnswers<R> Answers>
const std::array<R, 4>& SimplexSplines<R, Answers>::barycentric(const SimplexFrame<R>& frame) {
  const auto found = barycentric_.find(&frame);
  if (found != barycentric_.end()) return found->second;
  return barycentric_.emplace(&frame, frame.barycentric(u_)).first->second;
}

template <Ring R, SimplexAnswers<R> Answers>
auto SimplexSplines<R, Answers>::entry(const KnotSet& knots) -> const Entry& {
  const auto found = entries_.find(knots);
  if (found != entries_.end()) return found->second;
  Entry computed = compute(knots);
  return entries_.emplace(knots, std::move(computed)).first->second;
}

template <Ring R, SimplexAnswers<R> Answers>
auto SimplexSplines<R, Answers>::compute(const KnotSet& knots) -> Entry {
  VT_CHECK(knots.size() >= 4, "a simplex spline has at least four knots");
  const SimplexFrame<R>* const frame = answers_.frame(knots);
  if (frame == nullptr) return {};
  if (knots.size() == 4) {
    if (!answers_.contains(*frame)) return {};
    return {frame->height, false};
  }
  Entry sum;
  for (std::size_t m = 0; m < 4; ++m) {
    const Entry& part = entry(knots.without(frame->knots[m]));
    if (part.is_zero) continue;
    R term = barycentric(*frame)[m] * part.value;
    sum.value = sum.is_zero ? std::move(term) : R(sum.value + term);
    sum.is_zero = false;
  }
  return sum;
}

template <Ring R, SimplexAnswers<R> Answers>
std::array<R, 3> SimplexSplines<R, Answers>::gradient(const KnotSet& knots) {
  VT_CHECK(knots.size() >= 4, "a simplex spline has at least four knots");
  std::array<R, 3> sum{};
  const SimplexFrame<R>* const frame = knots.size() > 4 ? answers_.frame(knots) : nullptr;
  if (frame == nullptr) return sum;
  const R degree = RingNumbers<R>::ratio(static_cast<std::int64_t>(knots.size()) - 4, 1);
  for (std::size_t m = 0; m < 4; ++m) {
    const Entry& part = entry(knots.without(frame->knots[m]));
    if (part.is_zero) continue;
    const R factor = degree * part.value;
    for (std::size_t c = 0; c < 3; ++c) sum[c] = sum[c] + frame->lambda[m][c + 1] * factor;
  }
  return sum;
}

}  // namespace veritope
