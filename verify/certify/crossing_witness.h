// SPDX-License-Identifier: LGPL-3.0-or-later
// verify/certify/crossing_witness.h: a proof that two different points of a patch complex have one image, and the exact
// test of it: conditions X1 to X3 of docs/certificates/patch-invalid.md, section 3.
#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "solids/patches/patch.h"
#include "splines/bezier.h"
#include "splines/bezier_degree.h"

namespace veritope {

/// [lo / 2^bits, hi / 2^bits].
struct DyadicInterval {
  unsigned bits = 0;
  std::uint64_t lo = 0, hi = 0;

  static DyadicInterval whole() { return {0, 0, 1}; }
  /// bits <= 62, lo <= hi <= 2^bits.
  bool is_part_of_unit() const { return bits <= 62 && lo <= hi && hi <= std::uint64_t{1} << bits; }
  bool is_point() const { return lo == hi; }
  Rational lower() const;
  Rational upper() const;
  /// The interval of 1 - t. REQUIRES is_part_of_unit().
  DyadicInterval mirrored() const;
  friend bool operator==(const DyadicInterval&, const DyadicInterval&) = default;
};

/// A patch restricted to a rectangle of the parameters of its tensor form.
struct PatchRectangle {
  std::uint32_t patch = 0;
  std::array<DyadicInterval, 2> at;
  friend bool operator==(const PatchRectangle&, const PatchRectangle&) = default;
};

/// Whether the rectangles are of different patches or have no common place: the intervals of one parameter have no
/// number in common.
bool are_apart(const PatchRectangle& a, const PatchRectangle& b);

/// A and B, exactly one of whose four parameters is fixed, and rows Y_1, Y_2, Y_3: with x_i the other parameters in
/// their order, Y_i·(A - B) is negative where x_i is least and positive where it is greatest, so all three vanish
/// somewhere (Poincare-Miranda).
struct CrossingWitness {
  std::array<PatchRectangle, 2> sheets;
  std::array<std::array<std::int64_t, 3>, 3> rows{};
  friend bool operator==(const CrossingWitness&, const CrossingWitness&) = default;
};

enum class CrossingCondition { kX1, kX2, kX3 };
/// The first condition that does not hold; nothing: the witness is a proof. Exact.
/// @param a, b  the patches that the two sheets name. REQUIRES positive weights.
std::optional<CrossingCondition> broken_condition(const Patch& a, const Patch& b,
                                                  const CrossingWitness& witness);

/// The witness with reversed(patch) in the place of a patch, for each sheet whose flag is set: their parameters change.
CrossingWitness with_reversed(const Patch& a, const Patch& b, const std::array<bool, 2>& reversed,
                              CrossingWitness witness);

/// A tensor patch itself; for a triangle of degree p, the map of degrees (p, p) from (s, t) to the point with the
/// barycentric coordinates (1 - s, s (1 - t), s t).
BezierSurface<Rational> tensor_form(const Patch& patch);

/// The tensor form of a triangle, each row in its own degree: row m of the coefficients is a curve of degree m in t.
template <Ring R>
BezierSurface<R> tensor_of_triangle(const BezierTriangle<R>& map) {
  const int p = map.degree();
  BezierSurface<R> out({p, p}, map.num_components(), map.is_rational());
  const auto columns = static_cast<std::size_t>(p + 1);
  for (int m = 0; m <= p; ++m) {
    BezierCurve<R> row({m}, map.num_components(), false);
    for (int c = 0; c < map.num_components(); ++c)
      for (int k = 0; k <= m; ++k)
        row.component(c)[static_cast<std::size_t>(k)] = map.component(c)[triangle_index(m - k, k)];
    row = elevate_to(row, {p});
    for (int c = 0; c < map.num_components(); ++c)
      for (std::size_t k = 0; k < columns; ++k)
        out.component(c)[static_cast<std::size_t>(m) * columns + k] = row.component(c)[k];
  }
  return out;
}

}  // namespace veritope
