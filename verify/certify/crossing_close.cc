// SPDX-License-Identifier: LGPL-3.0-or-later
// CrossingSolver::prove_close: crossings of sheets that nearly coincide. Their tangent planes differ by a small
// angle g, so that the equations A = B are conditioned like 1 / g, boxes are as short as g, and doubles cannot tell
// the sheets apart in them. Three things help: B's parameters follow A's as the foot of a perpendicular, which is
// well conditioned and leaves one equation, the distance along the normal; the last differences A - B are computed
// exactly; and boxes are tested exactly at once, from the length that the condition suggests.
#include <algorithm>
#include <cmath>

#include "splines/de_casteljau.h"
#include "verify/certify/crossing_solver_internal.h"

namespace veritope {
namespace {

using internal::columns_without;
using internal::cross;
using internal::dot;
using internal::largest;
using internal::length_of;
using Vector = internal::Vector3;
using Matrix = internal::Matrix3;

constexpr int kMostSteps = 24, kMostFootSteps = 4, kMostExactSteps = 12;
// Sheets are close if they are apart by less than this part of a tangent's length, and if their normals differ by less.
constexpr double kClose = 0x1p-3, kSmallAngle = 0x1p-6;
constexpr double kNoise = 0x1p-46;      // of a difference in doubles, relative to tangents
constexpr double kLastExact = 0x1p-50;  // a shorter step of the exact iteration is the last one
constexpr double kLongRow = 0x1p60;
constexpr int kShortestBox = 52;  // half widths are at least 2^-52
// The bits of half widths that are tried, relative to those that the condition suggests.
constexpr std::array<int, 5> kTried = {-2, 0, 2, 4, 6};
constexpr double kOnePlace = 0x1p-20;  // a difference of parameters

bool is_in_unit(double t) { return t >= 0 && t <= 1; }

// Between two parts of one bent patch the foot of the perpendicular may run to the point itself.
bool are_one_place(const std::array<SheetPlace, 2>& x) {
  return x[0].patch == x[1].patch && std::abs(x[0].at[0] - x[1].at[0]) < kOnePlace &&
         std::abs(x[0].at[1] - x[1].at[1]) < kOnePlace;
}

}  // namespace

/// B's normal, the distance along it, and its derivatives by A's parameters.
struct CrossingSolver::Approach {
  Vector normal;
  double distance = 0;
  std::array<double, 2> slope{};
  double unit = 0;  ///< the length of the longest tangent

  explicit Approach(const Linear& l) {
    normal = cross(l.columns[2], l.columns[3]);
    const double length = length_of(normal);
    for (double& v : normal) v /= length;
    distance = dot(normal, l.difference);
    for (std::size_t i = 0; i < 2; ++i) slope[i] = dot(normal, l.columns[i]);
    for (const Vector& c : l.columns) unit = std::max(unit, largest(c));
  }
  double steepness() const { return slope[0] * slope[0] + slope[1] * slope[1]; }
  bool is_close() const {
    return std::abs(distance) <= kClose * unit && steepness() > 0 &&
           steepness() <= kSmallAngle * kSmallAngle * unit * unit;
  }
};

bool CrossingSolver::drop_foot(std::array<SheetPlace, 2>* x, bool exactly) {
  for (int step = 0; step < kMostFootSteps; ++step) {
    const Linear l = exactly ? exactly_linearised(*x) : linearised(*x);
    const auto d = internal::foot_step(l.difference, l.columns[2],
                                       l.columns[3]);  // the columns are -B's tangents
    if (!d) return false;
    for (std::size_t i = 0; i < 2; ++i) {
      (*x)[1].at[i] -= (*d)[i];
      if (!is_in_unit((*x)[1].at[i])) return false;
    }
    if (std::max(std::abs((*d)[0]), std::abs((*d)[1])) < (exactly ? kLastExact : 0x1p-40)) break;
  }
  return true;
}

std::optional<CrossingWitness> CrossingSolver::prove_close(const std::array<SheetPlace, 2>& guess,
                                                           double reach) {
  std::array<SheetPlace, 2> x = guess;
  for (int step = 0; step < kMostSteps; ++step) {
    if (!drop_foot(&x, false) || are_one_place(x)) return std::nullopt;
    const Approach to(linearised(x));
    if (!to.is_close()) return std::nullopt;
    const double length = std::abs(to.distance) / std::sqrt(to.steepness());
    if (std::abs(to.distance) <= kNoise * to.unit || length < 0x1p-30) return prove_refined(x);
    const double factor = std::min(1.0, reach / 2 / length);
    for (std::size_t i = 0; i < 2; ++i) {
      double& t = x[0].at[i];
      t -= factor * to.distance * to.slope[i] / to.steepness();
      if (!is_in_unit(t) || std::abs(t - guess[0].at[i]) > reach) return std::nullopt;
    }
  }
  return std::nullopt;
}

// The difference A - B is computed exactly, then rounded.
CrossingSolver::Linear CrossingSolver::exactly_linearised(const std::array<SheetPlace, 2>& at) {
  std::array<PatchPoint, 2> p;
  for (std::size_t s = 0; s < 2; ++s) {
    const std::vector<Rational> h = evaluate(
        tensor_form(forest_.complex().patch(at[s].patch)),
        std::array{Rational::from_double(at[s].at[0]), Rational::from_double(at[s].at[1])});
    p[s] = point_of(std::span<const Rational>(h)).value();
  }
  Linear out = linearised(at);
  for (std::size_t k = 0; k < 3; ++k)
    out.difference[k] = std::ldexp(nearest_double(p[0][k] - p[1][k]), forest_.frame().scale[k]);
  return out;
}

// Moves one parameter of A, along which the sheets part fastest, to the common point; the other one of A stays. B's
// follow before each step: where they are not at the foot, the slope along the normal is that of B's curvature.
std::optional<CrossingWitness> CrossingSolver::prove_refined(std::array<SheetPlace, 2> x) {
  if (num_refined >= kMostRefinedInAll || is_near_unproved(x)) return std::nullopt;
  ++num_refined;
  const Approach first(linearised(x));
  const std::size_t moving = std::abs(first.slope[0]) > std::abs(first.slope[1]) ? 0 : 1;
  double last = HUGE_VAL;
  for (int step = 0; step < kMostExactSteps && drop_foot(&x, true); ++step) {
    const Approach to(exactly_linearised(x));
    if (to.slope[moving] == 0) break;
    const double along = to.distance / to.slope[moving];
    if (step >= 3 && !(std::abs(along) < last / 2)) break;
    last = std::abs(along);
    if (std::abs(along) < kLastExact) {
      if (auto witness = boxed_close(x, 1 - moving)) return witness;
      break;
    }
    x[0].at[moving] -= along;
    if (!is_in_unit(x[0].at[moving])) break;
  }
  unproved_.push_back(x);
  return std::nullopt;
}

std::optional<CrossingWitness> CrossingSolver::boxed_close(const std::array<SheetPlace, 2>& x,
                                                           std::size_t fixed) {
  const Matrix columns = columns_without(linearised(x).columns, fixed);
  const Matrix adjugate{cross(columns[1], columns[2]), cross(columns[2], columns[0]),
                        cross(columns[0], columns[1])};
  const double det = dot(columns[0], adjugate[0]);
  if (det == 0) return std::nullopt;
  Matrix inverse;
  double condition = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) inverse[i][k] = adjugate[i][k] / det;
    condition = std::max(condition, largest(inverse[i]) * largest(columns[i]));
  }
  if (!std::isfinite(condition) || condition < 1) return std::nullopt;
  const auto rows = internal::integer_rows(inverse, forest_.frame().scale, kLongRow);
  if (!rows) return std::nullopt;
  const PatchComplex& complex = forest_.complex();
  for (const int more : kTried) {
    const int m = std::clamp(std::ilogb(condition) + more, 2, kShortestBox);
    const auto w = internal::box_around(forest_, x, fixed, 62, static_cast<unsigned>(m), *rows);
    if (!w || num_exact >= kMostExactInAll) continue;
    ++num_exact;
    if (!broken_condition(complex.patch(w->sheets[0].patch), complex.patch(w->sheets[1].patch), *w))
      return w;
  }
  return std::nullopt;
}

}  // namespace veritope
