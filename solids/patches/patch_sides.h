// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/patches/patch_sides.h: one form for each boundary curve, in whatever degree, factor and direction it is given:
// two sides are the same curve in the sense of S0 iff their forms are equal. Design: docs/design/0015-patch-complex.md.
#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solids/patches/patch.h"

namespace veritope {

/// In which direction the curve runs along its canonical form. kBoth: it is its own reverse, C(t) = C(1 - t).
enum class Travel : std::uint8_t { kForward, kBackward, kBoth };

/// Homogeneous control points, each x, y, z (w), in the least degree, divided by the absolute value of the first weight
/// that is not 0; without weights if all are then 1. The direction is the one of the two that comes first in the order
/// below.
struct CanonicalCurve {
  std::size_t width = 3;  ///< 3, or 4 with weights
  std::vector<Rational> values;
  /// Direction of the curve from which it was made; not compared.
  Travel travel = Travel::kForward;

  /// A total order without meaning.
  friend std::strong_ordering operator<=>(const CanonicalCurve& a, const CanonicalCurve& b);
  friend bool operator==(const CanonicalCurve& a, const CanonicalCurve& b) {
    return a.width == b.width && a.values == b.values;
  }
};

/// Claim   canonical(a) == canonical(b) iff a, or a run backwards, and b are equal after elevation to one degree, as
/// polynomial maps or as homogeneous maps up to one positive factor; a polynomial map is homogeneous with the weight 1.
/// A common polynomial factor of all components is not cancelled: S0 does not ask for it.
/// @cost   O(degree^2) at most; for a polynomial curve in its least degree no product except in the test of that
CanonicalCurve canonical(const Patch::Curve& curve);

/// The canonical form in the given direction: travel is kForward. Two forms are equal iff the curves are, in the same
/// direction of travel.
CanonicalCurve directed_form(const Patch::Curve& curve);
/// The directed form of the curve run backwards, made from that of the curve.
CanonicalCurve run_backwards(const CanonicalCurve& directed);

/// True if all control points are one point: S0's collapsed row. A weight of 0 gives no point, and the row is then not
/// collapsed.
bool is_collapsed(const Patch::Curve& curve);

/// Equal values have equal hashes. The low 64 bits and the lengths of numerators and denominators count: unequal hashes
/// prove that values differ, equal hashes prove nothing.
std::uint64_t hash_of(const CanonicalCurve& curve);

namespace internal {

/// The canonical form of a side, with few copies: where the side already has that form up to the direction, this points
/// at the numbers of the patch, which must live as long. It must not be copied: its pointers may point into itself.
class SideForm {
 public:
  SideForm(const Patch& patch, std::uint32_t side);
  SideForm(SideForm&&) = default;
  SideForm& operator=(SideForm&&) = default;

  bool is_collapsed() const { return is_collapsed_; }
  /// The functions below: REQUIRES !is_collapsed().
  Travel travel() const { return travel_; }
  /// hash_of(canonical(patch.side(side))).
  std::uint64_t hash() const;
  /// Compares as canonical(patch.side(side)) would.
  friend std::strong_ordering operator<=>(const SideForm& a, const SideForm& b);

 private:
  std::size_t num_points() const { return values_.size() / width_; }
  const Rational& at(std::size_t point, std::size_t c) const {
    return *values_[width_ * point + c];
  }
  void point_at(const Patch& patch, std::uint32_t side);
  bool is_one_point() const;
  bool make_in_place();
  void divide(const Rational& by);

  bool is_collapsed_ = false;
  Travel travel_ = Travel::kForward;
  std::size_t width_ = 3;
  std::vector<Rational> owned_;
  std::vector<const Rational*> values_;
};

/// Lowers the degree as far as the polynomials allow.
Patch::Curve with_least_degree(Patch::Curve curve);
std::uint64_t hash_step(std::uint64_t hash, std::uint64_t word);
std::uint64_t hash_step(std::uint64_t hash, const Rational& value);
/// Compares by numerator, then by denominator: a total order without products, not that of the values.
std::strong_ordering order_of_parts(const Rational& a, const Rational& b);

}  // namespace internal

}  // namespace veritope
