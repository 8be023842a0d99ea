// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/solvers/polynomial_system.h: N polynomial equations in N unknowns over exact numbers, seen through a window:
// the form in which root_isolation.h takes them.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "interval/exact_box.h"
#include "interval/solvers/bernstein_system.h"
#include "robust/base/result.h"

namespace veritope {

/// Equations on [0,1]^N with exact coefficients, and a frame, which is a box. On the frame, independent combinations of
/// the equations are held in double intervals. They are computed from the exact coefficients with enough bits
/// (MpInterval) that their errors are at most 2^-40 of the largest coefficient of each. So double arithmetic separates
/// roots that are 1e-30 apart, once the frame is that small.
template <std::size_t N>
class PolynomialSystem {
 public:
  using Piece = Bezier<Interval, N>;

  /// Makes a system of N scalar equations in all: the components of the given maps, each map with its own degrees.
  /// @error kBadArgument: not N components, or a rational map; kOverLimit: more than kMaxCoefficients after raising
  /// degrees.
  static Result<PolynomialSystem> make(std::span<const Bezier<Rational, N>> equations);
  static constexpr std::size_t kMaxCoefficients = std::size_t{1} << 16;  ///< of one equation

  /// The number of an equation that is identically zero, if there is one.
  std::optional<std::size_t> zero_equation() const;
  const ExactBox<N>& frame() const { return frame_; }
  int precision() const { return precision_; }

  // The interface that root_isolation.h asks of a system. REQUIRES a live ScopedUpward.
  Piece whole() const { return local_; }
  Examination<N> examine(const Piece& piece) const { return veritope::examine(piece); }
  std::pair<Piece, Piece> halves(const Piece& piece, std::size_t axis) const {
    return veritope::halves(piece, axis);
  }
  /// Converts the equations to another frame; empty if max_precision bits do not suffice. REQUIRES that no side is a
  /// point.
  std::optional<PolynomialSystem> zoom(const ExactBox<N>& frame, int max_precision) const;
  /// True if all equations vanish at the point, exactly.
  bool vanishes_at(const std::array<Rational, N>& point) const;
  const Bezier<Rational, N>& equations() const { return *exact_; }

 private:
  PolynomialSystem(std::shared_ptr<const Bezier<Rational, N>> exact, ExactBox<N> frame, Piece local,
                   int precision)
      : exact_(std::move(exact)),
        frame_(std::move(frame)),
        local_(std::move(local)),
        precision_(precision) {}

  std::shared_ptr<const Bezier<Rational, N>> exact_;
  ExactBox<N> frame_;
  Piece local_;
  int precision_;
};

}  // namespace veritope
