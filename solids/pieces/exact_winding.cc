// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solids/pieces/exact_winding.h"

#include <algorithm>
#include <vector>

namespace veritope {
namespace {

constexpr int kMostHalvings = 64;

// Homogeneous control points relative to the centre, projected: x and y up to one positive factor.
struct ExactCurve {
  std::vector<Integer> x, y;

  int degree() const { return static_cast<int>(x.size()) - 1; }
  ExactCurve part(std::uint64_t from, std::uint64_t to, int bits) const {
    ExactCurve out = *this;
    internal::restrict_line(out.x.data(), 1, degree(), from, to, bits);
    internal::restrict_line(out.y.data(), 1, degree(), from, to, bits);
    return out;
  }
};

std::optional<int> winding(const ExactCurve& curve, int halvings) {
  const auto is_negative = [](const Integer& v) { return v.sign() == Sign::kNegative; };
  const auto is_positive = [](const Integer& v) { return v.sign() == Sign::kPositive; };
  const auto below = std::count_if(curve.y.begin(), curve.y.end(), is_negative);
  if (below == 0 || below == static_cast<std::ptrdiff_t>(curve.y.size()) ||
      std::none_of(curve.x.begin(), curve.x.end(), is_positive))
    return 0;
  if (std::none_of(curve.x.begin(), curve.x.end(), is_negative))
    return int{!is_negative(curve.y.back())} - int{!is_negative(curve.y.front())};
  if (halvings == 0) return std::nullopt;
  const auto first = winding(curve.part(0, 1, 1), halvings - 1);
  if (!first) return std::nullopt;
  const auto second = winding(curve.part(1, 2, 1), halvings - 1);
  if (!second) return std::nullopt;
  return *first + *second;
}

// Both centres, times one power of two.
struct Line {
  std::array<Integer, 3> centre, direction;
  Integer unit{1};

  explicit Line(const CentreLine& line) {
    std::array<Rational, 3> c, d;
    for (std::size_t k = 0; k < 3; ++k) {
      c[k] = Rational::from_double(line.inside[k]);
      d[k] = Rational::from_double(line.outside[k]) - c[k];
      unit = std::max({unit, c[k].denominator(), d[k].denominator()});
    }
    for (std::size_t k = 0; k < 3; ++k) {
      centre[k] = (c[k] * Rational(unit)).numerator();
      direction[k] = (d[k] * Rational(unit)).numerator();
    }
  }
};

}  // namespace

std::optional<int> exact_winding(const ExactPiece& piece, const Patch& patch, std::uint32_t side,
                                 const CentreLine& centres, const ProjectionAxes& axes,
                                 std::uint64_t from, std::uint64_t to, int bits) {
  const Line line(centres);
  ExactCurve curve;
  for (std::size_t t = 0; t < patch.side_length(side); ++t) {
    const auto p = piece.control(patch.side_index(side, t));
    std::array<Integer, 3> q;  // P - w c
    for (std::size_t k = 0; k < 3; ++k) q[k] = *p[k] * line.unit - *p[3] * line.centre[k];
    const Integer& ahead = line.direction[axes.along];
    curve.x.push_back(q[axes.i] * ahead - q[axes.along] * line.direction[axes.i]);
    curve.y.push_back(q[axes.j] * ahead - q[axes.along] * line.direction[axes.j]);
  }
  return winding(curve.part(from, to, bits), kMostHalvings);
}

}  // namespace veritope
