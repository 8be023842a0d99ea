// SPDX-License-Identifier: LGPL-3.0-or-later
// splines/simplex_line.h: moments of simplex splines along a line, the integrals of t^k M(x + t d|V) dt. Where the line
// is inside a tetrahedron of knots is an argument: nothing is compared here.
// Source: [HHQ04] eq. 13, before its integration by parts.  Design: docs/design/0096-x-rays.md.
#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "robust/base/check.h"
#include "splines/simplex_spline.h"

namespace veritope {

/// The barycentric coordinates of x + t d with respect to a frame: at[m] + t along[m].
template <Ring R>
struct LineCoordinates {
  std::array<R, 4> at, along;
};

/// What a table of answers about one line and a list of knots has:
///   frame(set)        as SimplexAnswers have it
///   inside(f, c)      the parameters [a, b] for which x + t d is in the tetrahedron of the frame, by one half-open
///                     rule, and within the part of the line that is integrated over; c are the coordinates
template <typename A, typename R>
concept LineAnswers = requires(A& a, const KnotSet& set, const SimplexFrame<R>& frame,
                               const LineCoordinates<R>& coordinates) {
  { a.frame(set) } -> std::convertible_to<const SimplexFrame<R>*>;
  { a.inside(frame, coordinates) } -> std::convertible_to<std::optional<std::array<R, 2>>>;
};

/// The moments of the simplex splines of all sets of a list of knots. Each is computed once.
/// Eq. 1 multiplies a spline of lower degree by a linear function of t, so that moment k of a set is made of the
/// moments k and k + 1 of sets with one knot fewer, down to tetrahedra, where they are those of an interval. Nothing is
/// integrated by parts; so knots may be multiple or coplanar, and no jump has to be known.
template <Ring R, LineAnswers<R> Answers>
class SimplexLineMoments {
 public:
  /// The answers must outlive this object. Moments 0 to top - k are computed for sets of degree k. REQUIRES top >= 0.
  SimplexLineMoments(Answers& answers, std::array<R, 3> x, std::array<R, 3> d, int top)
      : answers_(answers), x_(std::move(x)), d_(std::move(d)), top_(top) {}

  const SimplexFrame<R>* frame(const KnotSet& set) { return answers_.frame(set); }
  const LineCoordinates<R>& coordinates(const SimplexFrame<R>& frame);
  /// Moments 0, 1, ...; empty if the line misses all tetrahedra of the recurrence, so that they are zero.
  /// REQUIRES at least four knots, of degree at most top. @cost two products for each moment of the sets of the
  /// recurrence, and each of four knots of it
  const std::vector<R>& moments(const KnotSet& knots);

 private:
  std::vector<R> compute(const KnotSet& knots);
  std::vector<R> of_interval(const SimplexFrame<R>& frame);

  Answers& answers_;
  std::array<R, 3> x_, d_;
  int top_;
  std::unordered_map<KnotSet, std::vector<R>, KnotSetHash> moments_;
  std::unordered_map<const SimplexFrame<R>*, LineCoordinates<R>> coordinates_;
};

// ---- bodies

template <Ring R, LineAnswers<R> Answers>
const LineCoordinates<R>& SimplexLineMoments<R, Answers>::coordinates(
    const SimplexFrame<R>& frame) {
  const auto found = coordinates_.find(&frame);
  if (found != coordinates_.end()) return found->second;
  return coordinates_
      .emplace(&frame, LineCoordinates<R>{frame.barycentric(x_), frame.barycentric_direction(d_)})
      .first->second;
}

template <Ring R, LineAnswers<R> Answers>
const std::vector<R>& SimplexLineMoments<R, Answers>::moments(const KnotSet& knots) {
  const auto found = moments_.find(knots);
  if (found != moments_.end()) return found->second;
  std::vector<R> computed = compute(knots);
  return moments_.emplace(knots, std::move(computed)).first->second;
}

template <Ring R, LineAnswers<R> Answers>
std::vector<R> SimplexLineMoments<R, Answers>::of_interval(const SimplexFrame<R>& frame) {
  const std::optional<std::array<R, 2>> ends = answers_.inside(frame, coordinates(frame));
  if (!ends) return {};
  const auto& [a, b] = *ends;
  std::vector<R> out;
  R low = a, high = b;
  for (int k = 0; k <= top_; ++k) {
    out.push_back(frame.height * RingNumbers<R>::ratio(1, k + 1) * (high - low));
    low = low * a;
    high = high * b;
  }
  return out;
}

template <Ring R, LineAnswers<R> Answers>
std::vector<R> SimplexLineMoments<R, Answers>::compute(const KnotSet& knots) {
  VT_CHECK(knots.size() >= 4 && static_cast<int>(knots.size()) - 4 <= top_,
           "a set of knots of a degree whose moments are wanted");
  const SimplexFrame<R>* const frame = answers_.frame(knots);
  if (frame == nullptr) return {};
  if (knots.size() == 4) return of_interval(*frame);
  std::vector<R> sum;
  for (std::size_t m = 0; m < 4; ++m) {
    const std::vector<R>& part = moments(knots.without(frame->knots[m]));
    if (part.empty()) continue;
    sum.resize(part.size() - 1);
    const LineCoordinates<R>& c = coordinates(*frame);
    for (std::size_t k = 0; k < sum.size(); ++k)
      sum[k] = sum[k] + c.at[m] * part[k] + c.along[m] * part[k + 1];
  }
  return sum;
}

}  // namespace veritope
