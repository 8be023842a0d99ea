// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/chain/plane_arc.h"

#include <algorithm>
#include <string>
#include <utility>

#include "solids/chain/simplex_cell.h"
#include "solids/patches/common_roots.h"
#include "splines/scaled_bernstein.h"

namespace veritope {
namespace {

// The numbers of halvings after which it is asked whether the point is on the curve; then there is no limit.
constexpr int kLevelsBeforeAsking = 12;
// Before that coordinates are cheaper to look at.
constexpr int kLevelsBeforeSlants = 3;

using Line = std::vector<Integer>;

Rational coordinate(const PlaneArc::Curve& c, int k, std::size_t i) {
  return c.is_rational() ? c.component(k)[i] / c.component(2)[i] : c.component(k)[i];
}
PointIn<2> control_point(const PlaneArc::Curve& c, std::size_t i) {
  return {coordinate(c, 0, i), coordinate(c, 1, i)};
}

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
int is_after(const Rational& y) { return y.sign() > 0 ? 1 : 0; }

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

}  // namespace

Result<PlaneArc> PlaneArc::make(Curve curve) {
  if (curve.dimension() != 2)
    return bad_argument("a curve of the plane has two coordinates, not " +
                        std::to_string(curve.dimension()));
  if (curve.degree(0) < 1) return bad_argument("a curve of the plane has a degree of 1 or more");
  if (curve.is_rational())
    for (const Rational& w : curve.component(2))
      if (w.sign() <= 0)
        return bad_argument("the weights of a curve are positive, not " + w.to_string());
  const auto last = static_cast<std::size_t>(curve.degree(0));
  Box3d box = box_around<2>(control_point(curve, 0));
  for (std::size_t i = 1; i <= last; ++i) box = hull(box, box_around<2>(control_point(curve, i)));
  PointIn<2> start = control_point(curve, 0), end = control_point(curve, last);
  return PlaneArc(std::move(curve), std::move(start), std::move(end), box);
}

PlaneArc::PlaneArc(Curve curve, PointIn<2> start, PointIn<2> end, Box3d box)
    : curve_(std::move(curve)), start_(std::move(start)), end_(std::move(end)), box_(box) {
  const internal::OverOne all(curve_.coefficients());
  const auto n = static_cast<std::size_t>(curve_.degree(0)) + 1;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < n; ++i)
      control_[c].push_back(c == 2 && !curve_.is_rational() ? all.denominator
                                                            : all.numerators[c * n + i]);
}

std::optional<PlaneArc::Sides> PlaneArc::sides() const {
  if (start_ == end_) return std::nullopt;
  Sides out;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(curve_.degree(0)); ++i) {
    const Sign s = orientation_of<2>({start_, end_, control_point(curve_, i)});
    out.has_left = out.has_left || s > 0;
    out.has_right = out.has_right || s < 0;
  }
  return out;
}

std::optional<int> PlaneArc::passes(const ChainPoint<2>& q, std::size_t axis) const {
  const std::size_t other = 1 - axis;
  const Box3d& at = q.box();
  if (box_.hi[axis] < at.lo[axis] || box_.hi[other] < at.lo[other] || at.hi[other] < box_.lo[other])
    return 0;
  // Across the ray: y for the axis x, -x for the axis y, so that both turn counter-clockwise.
  const auto height = [&](const PointIn<2>& p) {
    return axis == 0 ? p[1] - q.exact()[1] : q.exact()[0] - p[0];
  };
  if (at.hi[axis] < box_.lo[axis]) return is_after(height(end_)) - is_after(height(start_));
  const Rational &x = q.exact()[0], &y = q.exact()[1];
  const Integer common = x.denominator() * y.denominator(), left = x.numerator() * y.denominator(),
                below = y.numerator() * x.denominator();
  std::array<Line, 2> relative;
  for (std::size_t i = 0; i < control_[0].size(); ++i) {
    relative[0].push_back(control_[0][i] * common - control_[2][i] * left);
    relative[1].push_back(control_[1][i] * common - control_[2][i] * below);
  }
  if (axis == 1) {
    std::swap(relative[0], relative[1]);
    for (Integer& v : relative[1]) v = -v;
  }
  if (const auto n = RayOverArc::count(relative[0], relative[1], kLevelsBeforeAsking)) return n;
  if (parameter_of(q.exact())) return std::nullopt;
  return RayOverArc::count(std::move(relative[0]), std::move(relative[1]), std::nullopt);
}

std::optional<ArcParameter> PlaneArc::parameter_of(const PointIn<2>& q) const {
  std::array<Polynomial, 2> relative;
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<Rational> bernstein;
    for (std::size_t i = 0; i < control_[k].size(); ++i)
      bernstein.push_back(Rational(control_[k][i]) - q[k] * Rational(control_[2][i]));
    relative[k] = polynomial_of(bernstein);
  }
  const CommonRoots roots = common_roots(relative);
  if (roots.is_everywhere) return ArcParameter{};
  if (roots.roots.empty()) return std::nullopt;
  return roots.roots.front();
}

int passes_of_segment(const PointIn<2>& a, const PointIn<2>& b, const PointIn<2>& q,
                      std::size_t axis) {
  const auto height = [&](const PointIn<2>& p) {
    return is_after(axis == 0 ? p[1] - q[1] : q[0] - p[0]);
  };
  const int turn = height(b) - height(a);
  return turn != 0 && to_int(orientation_of<2>({a, b, q})) == turn ? turn : 0;
}

}  // namespace veritope
