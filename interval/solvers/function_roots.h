// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/solvers/function_roots.h: all roots of N equations in N unknowns that are given as a function over boxes,
// polynomial or not.
#pragma once
#include <array>
#include <optional>
#include <utility>

#include "interval/solvers/root_isolation.h"

namespace veritope {

/// Enclosures over a box of the values of N functions and of all their derivatives, derivatives[i][j] = d f_i / d x_j.
template <std::size_t N>
struct ValuesAndDerivatives {
  std::array<Interval, N> values;
  IntervalMatrix<N> derivatives;
};

/// The equations f(x) = 0 for root_isolation.h. `Function` maps a Box<N> to ValuesAndDerivatives<N> that hold on all of
/// it; the function must be continuously differentiable on the domain inflated by kInflation. It is not asked for
/// numbers more precise than double: roots that double cannot separate end in clusters with OpenReason::kPrecision.
template <std::size_t N, typename Function>
class FunctionSystem {
 public:
  using Piece = Box<N>;  // in coordinates in which the frame is [0,1]^N

  FunctionSystem(ExactBox<N> frame, Function function)
      : frame_(std::move(frame)), function_(std::move(function)) {}

  const ExactBox<N>& frame() const { return frame_; }
  int precision() const { return 53; }
  Piece whole() const { return Box<N>::filled(Interval::from_bounds(0, 1)); }
  std::pair<Piece, Piece> halves(const Piece& piece, std::size_t axis) const {
    return split(piece, axis);
  }
  bool vanishes_at(const std::array<Rational, N>&) const { return false; }
  std::optional<FunctionSystem> zoom(const ExactBox<N>& frame, int) const {
    for (const ExactInterval& s : frame.side)  // no double in between
      if (s.width() < kLeastShare * (abs(s.lo) + Rational::power_of_two(-900))) return std::nullopt;
    return FunctionSystem(frame, function_);
  }

  Examination<N> examine(const Piece& piece) const {
    using Kind = typename Examination<N>::Kind;
    Examination<N> out;
    const ValuesAndDerivatives<N> over = function_(place(piece));
    for (const Interval& v : over.values)
      if (is_certain(v.sign()) && v.sign() != Sign3::kZero) return {Kind::kNoRoot, {}, 0, false};
    out.axis = widest_side(piece);
    out.is_exhausted = wid(piece[out.axis]) < 0x1p-40;
    // Around the middle, in coordinates in which the piece, inflated, is [-1,1]^N.
    const Box<N> wide = inflated(piece),
                 at = place(Box<N>::each(
                     wide, wide, [](const auto&s, const auto&) { return Interval(mid(s)); }));
    IntervalMatrix<N> slopes = function_(place(wide)).derivatives;
    ApproxMatrix<N> matrix;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j < N; ++j) {
        slopes[i][j] *= radius(wide, j);
        matrix[i][j] = is_common(slopes[i][j]) ? mid(slopes[i][j]) : 0;
      }
    const auto inverse = eliminate(matrix).inverse;
    if (!inverse) return out;
    const auto values = times(*inverse, function_(at).values);
    IntervalMatrix<N> derivatives;
    for (std::size_t j = 0; j < N; ++j) {
      std::array<Interval, N> column;
      for (std::size_t i = 0; i < N; ++i) column[i] = slopes[i][j];
      column = times(*inverse, column);
      for (std::size_t i = 0; i < N; ++i) derivatives[i][j] = column[i];
    }
    // The mean value form, preconditioned.
    for (std::size_t i = 0; i < N; ++i) {
      Interval range = values[i];
      for (const Interval& d : derivatives[i]) range += d * Interval::from_bounds(-1, 1);
      if (range.sign() == Sign3::kPositive || range.sign() == Sign3::kNegative)
        return {Kind::kNoRoot, {}, 0, false};
    }
    if (const auto root = krawczyk(values, derivatives)) {
      out.kind = Kind::kOneRoot;
      out.root = *root;
    }
    return out;
  }

 private:
  static inline const Rational kLeastShare = Rational::power_of_two(-46);

  // Encloses the box in the function's own coordinates.
  Box<N> place(const Box<N>& local) const {
    Box<N> out;
    for (std::size_t i = 0; i < N; ++i)
      out[i] = enclose(frame_[i].lo) + enclose(frame_[i].width()) * local[i];
    return out;
  }
  static Box<N> inflated(const Box<N>& piece) {  // exact: few bits
    Box<N> out;
    for (std::size_t i = 0; i < N; ++i) {
      const Interval more =
          Interval(kInflation) * (Interval(piece[i].hi()) - Interval(piece[i].lo()));
      out[i] = Interval::from_bounds((Interval(piece[i].lo()) - more).hi(),
                                     (Interval(piece[i].hi()) + more).lo());
    }
    return out;
  }
  Interval radius(const Box<N>& wide, std::size_t j) const {
    return enclose(frame_[j].width()) * Interval(0.5) *
           (Interval(wide[j].hi()) - Interval(wide[j].lo()));
  }
  static std::array<Interval, N> times(const ApproxMatrix<N>& m, const std::array<Interval, N>& v) {
    std::array<Interval, N> out;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j < N; ++j) out[i] += Interval(m[i][j]) * v[j];
    return out;
  }

  ExactBox<N> frame_;
  Function function_;
};

/// Like polynomial_roots, but in `domain`, which must be bounded and have no side that is a point.
template <std::size_t N, typename Function>
RootReport<N> function_roots(const ExactBox<N>& domain, Function function,
                             const SolverOptions& options = {}) {
  return isolate_roots<N>(FunctionSystem<N, Function>(domain, std::move(function)), options);
}

}  // namespace veritope
