// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/crossing_solver_internal.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "verify/certify/miranda_internal.h"

namespace veritope {
namespace {

constexpr int kMaxSteps = 24;
// A shorter step is the last one: by quadratic convergence the next would be as short as rounding allows. Near a
// tangency each step only halves the error, and kMaxSteps do not suffice.
constexpr double kLastStep = 0x1p-28;
// The bits of the fixed parameter, fewer first; boxes have half widths of 2^-kFirst to 2^-kLast.
constexpr std::array<unsigned, 4> kFixedBits = {6, 14, 24, 40};
constexpr unsigned kFirst = 3, kLast = 40, kCentreBits = 20, kMostBits = 62;
constexpr double kRowSize = 0x1p40;
constexpr std::size_t kMostExact = 3;  // tests of one solution with one fixed parameter
constexpr double kNear = 0x1p-16;      // distance of parameters, in units of the patch's domain

using internal::columns_without;
using internal::dot;
using internal::invert;
using internal::largest;
using internal::tangents;
using internal::Tangents;
using Vector = internal::Vector3;
using Matrix = internal::Matrix3;

// The row, scaled by a power of two so that its largest number is between 1 and 2. Nothing if the row is 0 or not
// finite.
std::optional<Vector> stretched(const Vector& row, const std::array<int, 3>& exponent) {
  std::optional<int> top;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!std::isfinite(row[k])) return std::nullopt;
    if (row[k] == 0) continue;
    const int own = std::ilogb(row[k]) + exponent[k];
    top = top ? std::max(*top, own) : own;
  }
  if (!top) return std::nullopt;
  Vector out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = std::ldexp(row[k], exponent[k] - *top);
  return out;
}

// The interval of this radius around the multiple of 2^-bits nearest to t; the radius is a number of such multiples.
// Nothing if the interval does not lie in [0,1].
std::optional<DyadicInterval> interval_around(double t, unsigned bits, double radius) {
  const double all = std::ldexp(1.0, static_cast<int>(bits)), middle = std::nearbyint(t * all);
  if (!(middle - radius >= 0 && middle + radius <= all)) return std::nullopt;
  return DyadicInterval{bits, static_cast<std::uint64_t>(middle - radius),
                        static_cast<std::uint64_t>(middle + radius)};
}

}  // namespace

std::optional<std::array<std::array<std::int64_t, 3>, 3>> internal::integer_rows(
    const Matrix& inverse, const std::array<int, 3>& scale, double size) {
  std::array<std::array<std::int64_t, 3>, 3> rows;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::optional<Vector> row = stretched(inverse[i], scale);
    if (!row) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k)
      rows[i][k] = static_cast<std::int64_t>(std::nearbyint((*row)[k] * (size / largest(*row))));
  }
  return rows;
}

std::optional<CrossingWitness> internal::box_around(
    const PieceForest& forest, const std::array<SheetPlace, 2>& solution, std::size_t fixed,
    unsigned fixed_bits, unsigned m, const std::array<std::array<std::int64_t, 3>, 3>& rows) {
  CrossingWitness w;
  w.rows = rows;
  const unsigned bits = std::min(m + kCentreBits, kMostBits);
  for (std::size_t i = 0; i < 4; ++i) {
    PatchRectangle& sheet = w.sheets[i / 2];
    sheet.patch = solution[i / 2].patch;
    const bool is_open = i < 2 || (i == 2 && forest.form(sheet.patch).shape.is_triangle);
    const double t = parameter(solution, i);
    const auto around = i == fixed
                            ? interval_around(t, fixed_bits, 0)
                            : interval_around(t, bits, std::ldexp(1.0, static_cast<int>(bits - m)));
    if (!around || (is_open && around->lo == 0) ||
        (i < 2 && around->hi == std::uint64_t{1} << around->bits))
      return std::nullopt;
    sheet.at[i % 2] = *around;
  }
  if (!are_apart(w.sheets[0], w.sheets[1])) return std::nullopt;
  return w;
}

// J^T y with J J^T y = difference: the shortest step that solves J step = difference. Rows of J are scaled to length
// approximately one, which changes nothing but rounding.
std::optional<std::array<double, 4>> CrossingSolver::shortest_step(Linear l) {
  for (std::size_t k = 0; k < 3; ++k) {
    double unit = 0;
    for (const Vector& c : l.columns) unit = std::max(unit, std::abs(c[k]));
    if (!(unit > 0) || !std::isfinite(unit)) return std::nullopt;
    l.difference[k] /= unit;
    for (Vector& c : l.columns) c[k] /= unit;
  }
  Matrix gram{}, inverse;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      for (const Vector& c : l.columns) gram[i][k] += c[i] * c[k];
  if (!invert(gram, &inverse)) return std::nullopt;
  const Vector y{dot(inverse[0], l.difference), dot(inverse[1], l.difference),
                 dot(inverse[2], l.difference)};
  return std::array<double, 4>{dot(l.columns[0], y), dot(l.columns[1], y), dot(l.columns[2], y),
                               dot(l.columns[3], y)};
}

CrossingSolver::Linear CrossingSolver::linearised(const std::array<SheetPlace, 2>& at) {
  const SheetMaps::Sheet &a = maps_.sheet(at[0].patch), &b = maps_.sheet(at[1].patch);
  const Tangents ta = tangents(a.map, at[0].at), tb = tangents(b.map, at[1].at);
  Linear out;
  for (std::size_t k = 0; k < 3; ++k) {
    out.difference[k] = (a.origin[k] - b.origin[k]) + (ta.at[k] - tb.at[k]);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      out.columns[axis][k] = ta.along[axis][k];
      out.columns[2 + axis][k] = -tb.along[axis][k];
    }
  }
  return out;
}

std::optional<std::array<SheetPlace, 2>> CrossingSolver::solve(
    const std::array<SheetPlace, 2>& guess, double reach) {
  ++num_solved;
  std::array<SheetPlace, 2> x = guess;
  double last = HUGE_VAL;
  for (int step = 0; step < kMaxSteps; ++step) {
    const std::optional<std::array<double, 4>> d = shortest_step(linearised(x));
    if (!d) return std::nullopt;
    double length = 0;
    bool is_clamped = false;
    for (std::size_t i = 0; i < 4; ++i) {
      double& t = parameter(&x, i);
      const double wanted = t - (*d)[i];
      length = std::max(length, std::abs((*d)[i]));
      t = std::clamp(wanted, 0.0, 1.0);
      is_clamped = is_clamped || t != wanted;
      if (!(std::abs(t - parameter(guess, i)) <= reach)) return std::nullopt;
    }
    if (length < kLastStep) return x;
    if (step >= 8 && !is_clamped && length > 0.3 * last) return std::nullopt;
    last = length;
  }
  return std::nullopt;
}

std::optional<CrossingWitness> CrossingSolver::prove(const std::array<SheetPlace, 2>& solution) {
  const auto depth = [](const SheetPlace& p) {
    return std::min({p.at[0], 1 - p.at[0], p.at[1], 1 - p.at[1]});
  };
  std::array<SheetPlace, 2> s = solution;
  if (depth(s[0]) < depth(s[1])) std::swap(s[0], s[1]);
  if (!(depth(s[0]) > std::ldexp(1.0, -static_cast<int>(kLast)))) return std::nullopt;
  if (is_near_unproved(s)) return std::nullopt;
  if (auto witness = prove_in_order(s)) return witness;
  std::swap(s[0], s[1]);
  if (depth(s[0]) > 0)
    if (auto witness = prove_in_order(s)) return witness;
  unproved_.push_back(s);
  return std::nullopt;
}

// Compares the two places in either order.
bool CrossingSolver::is_near_unproved(const std::array<SheetPlace, 2>& solution) const {
  const auto is_near = [](const SheetPlace& a, const SheetPlace& b) {
    return a.patch == b.patch && std::abs(a.at[0] - b.at[0]) < kNear &&
           std::abs(a.at[1] - b.at[1]) < kNear;
  };
  return std::any_of(unproved_.begin(), unproved_.end(), [&](const auto& u) {
    return (is_near(u[0], solution[0]) && is_near(u[1], solution[1])) ||
           (is_near(u[0], solution[1]) && is_near(u[1], solution[0]));
  });
}

// Fixes each parameter in turn, first the one without which the equations are conditioned best. A parameter of B on the
// border must be the fixed one, so that one comes first.
std::optional<CrossingWitness> CrossingSolver::prove_in_order(
    const std::array<SheetPlace, 2>& solution) {
  const Linear l = linearised(solution);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t fixed = 0; fixed < 4; ++fixed) {
    Matrix inverse;
    if (!invert(columns_without(l.columns, fixed), &inverse)) continue;
    double size = 0;
    for (const Vector& row : inverse) size = std::max(size, largest(row));
    for (std::size_t i = 2; i < 4; ++i) {
      const double t = parameter(solution, i);
      if (i != fixed && (t < 0x1p-30 || t > 1 - 0x1p-30)) size *= 0x1p40;
    }
    order.push_back({size, fixed});
  }
  std::sort(order.begin(), order.end());
  for (const auto& [size, fixed] : order)
    if (auto witness = prove_with(solution, fixed)) return witness;
  return std::nullopt;
}

std::optional<CrossingWitness> CrossingSolver::prove_with(const std::array<SheetPlace, 2>& solution,
                                                          std::size_t fixed) {
  const double wanted = parameter(solution, fixed);
  for (const unsigned bits : kFixedBits) {
    std::array<SheetPlace, 2> s = solution;
    double& t = parameter(&s, fixed);
    t = std::ldexp(std::nearbyint(std::ldexp(wanted, static_cast<int>(bits))),
                   -static_cast<int>(bits));
    if (fixed < 2 && (t <= 0 || t >= 1)) continue;
    const std::optional<Rows> rows = settle(&s, fixed);
    if (!rows) continue;
    if (auto witness = boxed(s, fixed, bits, *rows)) return witness;
  }
  return std::nullopt;
}

// Newton's method with the parameter fixed; returns the rows of the last inverse, each as integers of approximately 40
// bits.
std::optional<CrossingSolver::Rows> CrossingSolver::settle(std::array<SheetPlace, 2>* solution,
                                                           std::size_t fixed) {
  double last = HUGE_VAL;
  for (int step = 0; step < kMaxSteps; ++step) {
    const Linear l = linearised(*solution);
    Matrix inverse;
    if (!invert(columns_without(l.columns, fixed), &inverse)) return std::nullopt;
    double length = 0;
    for (std::size_t i = 0, n = 0; i < 4; ++i) {
      if (i == fixed) continue;
      const double d = dot(inverse[n++], l.difference);
      double& t = parameter(solution, i);
      length = std::max(length, std::abs(d));
      t -= d;
      if (!(t >= 0 && t <= 1)) return std::nullopt;
    }
    if (length < kLastStep && length >= 0.25 * last)
      return internal::integer_rows(inverse, forest_.frame().scale, kRowSize);
    if (length == 0) return internal::integer_rows(inverse, forest_.frame().scale, kRowSize);
    last = length;
  }
  return std::nullopt;
}

std::optional<CrossingWitness> CrossingSolver::boxed(const std::array<SheetPlace, 2>& solution,
                                                     std::size_t fixed, unsigned fixed_bits,
                                                     const Rows& rows) {
  const PatchComplex& complex = forest_.complex();
  std::size_t exact = 0;
  for (unsigned m = kFirst; m <= kLast && exact < kMostExact && num_exact < kMostExactInAll; ++m) {
    const auto w = internal::box_around(forest_, solution, fixed, fixed_bits, m, rows);
    if (!w || !is_forecast(*w)) continue;
    ++exact, ++num_exact;
    if (!broken_condition(complex.patch(w->sheets[0].patch), complex.patch(w->sheets[1].patch), *w))
      return w;
  }
  return std::nullopt;
}

// Whether X3 holds in doubles, computed relative to the second sheet's origin.
bool CrossingSolver::is_forecast(const CrossingWitness& w) {
  const SheetMaps::Sheet &a = maps_.sheet(w.sheets[0].patch), &b = maps_.sheet(w.sheets[1].patch);
  std::array<BezierSurface<double>, 2> maps{a.map, b.map};
  for (std::size_t c = 0; c < 3; ++c) {
    const double shift = a.origin[c] - b.origin[c];
    const std::size_t n = maps[0].component(0).size();
    for (std::size_t i = 0; i < n; ++i)
      maps[0].component(static_cast<int>(c))[i] +=
          shift * (a.map.is_rational() ? a.map.component(3)[i] : 1);
  }
  std::array<internal::FreeParameter, 3> parameters{};
  std::size_t n = 0;
  for (std::size_t s = 0; s < 2; ++s)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const DyadicInterval& t = w.sheets[s].at[axis];
      if (!t.is_point()) parameters[n++] = {s, axis};
      const int bits = -static_cast<int>(t.bits);
      maps[s] = internal::part_along(std::move(maps[s]), axis,
                                     std::ldexp(static_cast<double>(t.lo), bits),
                                     std::ldexp(static_cast<double>(t.hi), bits));
    }
  const std::array<int, 3>& scale = forest_.frame().scale;
  Matrix rows;
  for (std::size_t i = 0; i < 3; ++i) {
    Vector row;
    for (std::size_t k = 0; k < 3; ++k) row[k] = static_cast<double>(w.rows[i][k]);
    const auto framed = stretched(row, {-scale[0], -scale[1], -scale[2]});
    if (!framed) return false;
    rows[i] = *framed;
  }
  return internal::has_opposite_signs(maps, rows, parameters);
}

}  // namespace veritope
