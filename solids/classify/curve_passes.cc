// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/classify/curve_passes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace veritope {
namespace {

// The numbers of halvings after which it is asked whether the point is on the curve; then there is no limit.
constexpr int kLevelsBeforeAsking = 12;
// Before that coordinates are cheaper to look at.
constexpr int kLevelsBeforeSlants = 3;

using Line = std::vector<Integer>;

// The two halves, times 2^degree.
std::array<Line, 2> halves(Line row) {
  const std::size_t n = row.size() - 1;
  std::array<Line, 2> out{Line(n + 1), Line(n + 1)};
  for (std::size_t step = 0; step <= n; ++step) {
    out[0][step] = row[0] << (n - step);
    out[1][n - step] = row[n - step] << (n - step);
    for (std::size_t i = 0; i + step < n; ++i) row[i] += row[i + 1];
  }
  return out;
}

bool are_all(const Line& line, Sign sign) {
  return std::all_of(line.begin(), line.end(), [&](const Integer& v) { return v.sign() == sign; });
}
int is_after(const Integer& y) { return y.sign() > 0 ? 1 : 0; }

// The pieces of a curve, in coordinates relative to a point along the ray and across it: CHAIN-5.
class RayOverArc {
 public:
  // Nothing if pieces remain after `levels` halvings.
  static std::optional<int> count(Line along, Line across, std::optional<int> levels) {
    RayOverArc out;
    out.take({std::move(along), std::move(across), 0});
    while (!out.open_.empty()) {  // a few: most pieces are done when they are made
      const Piece piece = std::move(out.open_.back());
      out.open_.pop_back();
      if (levels && piece.level == *levels) return std::nullopt;
      auto a = halves(piece.along), b = halves(piece.across);
      for (std::size_t i = 0; i < 2; ++i)
        out.take({std::move(a[i]), std::move(b[i]), piece.level + 1});
    }
    return out.sum_;
  }

 private:
  struct Piece {
    Line along, across;
    int level;
  };

  void take(Piece piece) {
    if (are_all(piece.across, Sign::kPositive) || are_all(piece.across, Sign::kNegative)) return;
    Sign side = are_all(piece.along, Sign::kNegative)   ? Sign::kNegative
                : are_all(piece.along, Sign::kPositive) ? Sign::kPositive
                                                        : Sign::kZero;
    if (side == 0 && piece.level >= kLevelsBeforeSlants) side = slanted_side(piece);
    if (side > 0)
      sum_ += is_after(piece.across.back()) - is_after(piece.across.front());
    else if (side == 0)
      open_.push_back(std::move(piece));
  }

  // If all control points are strictly on one side of the parallel to the chord through the point, the sign of the
  // angle between this side's normal and the ray; else 0. A small piece lies near its chord: pieces with a length like
  // the root of the point's distance are done.
  static Sign slanted_side(const Piece& piece) {
    const Integer dx = piece.along.back() - piece.along.front(),
                  dy = piece.across.back() - piece.across.front();
    Sign side = Sign::kZero;
    for (std::size_t i = 0; i < piece.along.size(); ++i) {
      const Sign s = (dy * piece.along[i] - dx * piece.across[i]).sign();
      if (s == 0 || s * side < 0) return Sign::kZero;
      side = s;
    }
    return side * dy.sign();
  }

  int sum_ = 0;
  std::vector<Piece> open_;
};

Polynomial powers_of(const Line& line) {
  const std::vector<Rational> bernstein(line.begin(), line.end());
  return polynomial_of(bernstein);
}

}  // namespace

std::optional<int> passes_of(const RelativeCurve& curve) {
  if (const auto n = RayOverArc::count(curve.along, curve.across, kLevelsBeforeAsking)) return n;
  const CommonRoots roots = roots_of(curve);
  if (roots.is_everywhere || !roots.roots.empty()) return std::nullopt;
  return RayOverArc::count(curve.along, curve.across, std::nullopt);
}

CommonRoots roots_of(const RelativeCurve& curve) {
  const std::array<Polynomial, 2> both{powers_of(curve.along), powers_of(curve.across)};
  return common_roots(both);
}

}  // namespace veritope
