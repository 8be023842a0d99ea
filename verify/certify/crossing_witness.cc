// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verify/certify/crossing_witness.h"

#include <utility>

#include "verify/certify/miranda_internal.h"

namespace veritope {
namespace {

// k / 2^bits.
Rational dyadic(std::uint64_t k, unsigned bits) {
  return Rational(k) * Rational::power_of_two(-static_cast<std::int64_t>(bits));
}

// Whether no number lies in both.
bool has_gap(const DyadicInterval& a, const DyadicInterval& b) {
  return a.upper() < b.lower() || b.upper() < a.lower();
}

bool is_open_part(const DyadicInterval& t) { return t.lo > 0 && t.hi < std::uint64_t{1} << t.bits; }

// Tests X1; if it holds, returns the three parameters that are not fixed.
std::optional<std::array<internal::FreeParameter, 3>> free_parameters(const Patch& a,
                                                                      const Patch& b,
                                                                      const CrossingWitness& w) {
  std::array<internal::FreeParameter, 3> out{};
  std::size_t n = 0;
  for (std::size_t s = 0; s < 2; ++s)
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const DyadicInterval& t = w.sheets[s].at[axis];
      if (!t.is_part_of_unit()) return std::nullopt;
      if (t.is_point()) continue;
      if (n < 3) out[n] = {s, axis};
      ++n;
    }
  if (n != 3) return std::nullopt;
  const PatchRectangle &first = w.sheets[0], &second = w.sheets[1];
  if (!is_open_part(first.at[0]) || !is_open_part(first.at[1])) return std::nullopt;
  if ((a.is_triangle() && first.at[0].lo == 0) || (b.is_triangle() && second.at[0].lo == 0))
    return std::nullopt;
  if (!are_apart(first, second)) return std::nullopt;
  return out;
}

BezierSurface<Rational> restricted_to(const Patch& patch, const PatchRectangle& where) {
  BezierSurface<Rational> map = tensor_form(patch);
  for (std::size_t axis = 0; axis < 2; ++axis)
    map =
        internal::part_along(std::move(map), axis, where.at[axis].lower(), where.at[axis].upper());
  return map;
}

}  // namespace

Rational DyadicInterval::lower() const { return dyadic(lo, bits); }
Rational DyadicInterval::upper() const { return dyadic(hi, bits); }
DyadicInterval DyadicInterval::mirrored() const {
  const std::uint64_t all = std::uint64_t{1} << bits;
  return {bits, all - hi, all - lo};
}

bool are_apart(const PatchRectangle& a, const PatchRectangle& b) {
  return a.patch != b.patch || has_gap(a.at[0], b.at[0]) || has_gap(a.at[1], b.at[1]);
}

std::optional<CrossingCondition> broken_condition(const Patch& a, const Patch& b,
                                                  const CrossingWitness& w) {
  const auto parameters = free_parameters(a, b, w);
  if (!parameters) return CrossingCondition::kX1;
  std::array<std::array<Rational, 3>, 3> y;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) y[i][k] = Rational(w.rows[i][k]);
  Rational determinant(0);
  for (std::size_t k = 0; k < 3; ++k)
    determinant +=
        y[0][k] * (y[1][(k + 1) % 3] * y[2][(k + 2) % 3] - y[1][(k + 2) % 3] * y[2][(k + 1) % 3]);
  if (determinant.sign() == Sign::kZero) return CrossingCondition::kX2;
  const std::array<BezierSurface<Rational>, 2> maps{restricted_to(a, w.sheets[0]),
                                                    restricted_to(b, w.sheets[1])};
  if (!internal::has_opposite_signs(maps, y, *parameters)) return CrossingCondition::kX3;
  return std::nullopt;
}

// In a tensor patch the axes change places, and two rows with them if neither axis is fixed. In a triangle t becomes 1
// - t, and the row of t changes its sign.
CrossingWitness with_reversed(const Patch& a, const Patch& b, const std::array<bool, 2>& reversed,
                              CrossingWitness w) {
  const std::array<bool, 2> is_triangle{a.is_triangle(), b.is_triangle()};
  std::size_t row = 0;  // the row of the sheet's first parameter that is not fixed
  for (std::size_t s = 0; s < 2; ++s) {
    auto& at = w.sheets[s].at;
    const std::size_t num_free = (at[0].is_point() ? 0u : 1u) + (at[1].is_point() ? 0u : 1u);
    if (reversed[s] && is_triangle[s]) {
      if (!at[1].is_point())
        for (std::int64_t& v : w.rows[row + num_free - 1]) v = -v;
      at[1] = at[1].mirrored();
    } else if (reversed[s]) {
      std::swap(at[0], at[1]);
      if (num_free == 2) std::swap(w.rows[row], w.rows[row + 1]);
    }
    row += num_free;
  }
  return w;
}

BezierSurface<Rational> tensor_form(const Patch& patch) {
  return patch.is_triangle() ? tensor_of_triangle(patch.triangle()) : patch.tensor();
}

}  // namespace veritope
