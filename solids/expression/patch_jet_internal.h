// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/expression/patch_jet_internal.h: points, derivatives and planes of patches, exactly.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "solids/patches/patch.h"

namespace veritope::internal {

using Vector = std::array<Rational, 3>;

Vector minus(const Vector& a, const Vector& b);
Vector negated(const Vector& a);
Vector crossed(const Vector& a, const Vector& b);
Rational dotted(const Vector& a, const Vector& b);
bool is_zero(const Vector& a);
Rational rounded_down(const Rational& x);

/// A point of the domain of a patch: (u, v), or the barycentric coordinates of corners 1 and 2.
using DomainPlace = std::array<Rational, 2>;

/// A point and the derivatives along both axes of the domain.
struct PatchJet {
  Vector at;
  std::array<Vector, 2> derivative;
};
/// Inside the domain or not. REQUIRES a weight that is not 0 there.
PatchJet jet(const Patch& patch, const DomainPlace& at);
struct CurveJet {
  Vector at, derivative;
};
CurveJet jet(const Patch::Curve& curve, const Rational& at);

/// All components at a point, homogeneous if the patch is rational; and their derivatives along an axis.
std::vector<Rational> homogeneous_at(const Patch& patch, const DomainPlace& at);
std::vector<Rational> homogeneous_derivative_at(const Patch& patch, std::size_t axis,
                                                const DomainPlace& at);

/// The point at t of a side, in its direction of travel.
DomainPlace on_side(const Patch& patch, std::uint32_t side, const Rational& t);
/// The derivative along a side, in its direction of travel.
Vector along_side(const Patch& patch, std::uint32_t side, const PatchJet& at);

/// The normal of a patch in a plane; nothing if it is in none, or has no normal in the middle.
std::optional<Vector> flat_normal(const Patch& patch);
/// The direction of a side in a straight line, from its start to its end.
std::optional<Vector> straight_direction(const Patch& patch, std::uint32_t side);

}  // namespace veritope::internal
