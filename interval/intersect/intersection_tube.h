// SPDX-License-Identifier: LGPL-3.0-or-later
// interval/intersect/intersection_tube.h: proofs that two surfaces meet in exactly one arc inside of a slanted box of
// their four parameters. Krawczyk's operator for a system of three equations with a parameter; slanted boxes as in
// parallelotope continuation [MGG13].
#pragma once
#include <array>
#include <optional>

#include "interval/enclosure/enclosed_surface.h"

namespace veritope {

using Box4 = Box<4>;
using Point4 = std::array<double, 4>;

/// Parameters x = (u, v, s, t): u, v of the first surface, s, t of the second, all of them working parameters. The tube
/// is
///   { x : x[pivot] = w in [w_lo, w_hi], x[i] - center[i] - slope[i] (w - center[pivot]) in offset[i] for i != pivot }.
/// Claim: for every w in [w_lo, w_hi] the surfaces S1(u, v) = S2(s, t) have exactly one common point in the tube, and
/// these points form one arc. Beyond their domains the surfaces are continued. Proved by THEORY, TUBE-1 from two
/// hypotheses: T1, Krawczyk's image of the offsets lies in the offsets, borders included, and T2, it contracts. Neither
/// implies the other.
struct IntersectionTube {
  int pivot = 0;
  double w_lo = 0, w_hi = 0;
  Point4 center{}, slope{};
  Box4 offset;      // [0, 0] at the pivot
  Box4 derivative;  // of the arc's parameters by w
  /// +1 if the arc runs along n1 x n2 with increasing w, -1 if against it; 0 before the claim is proved.
  int direction = 0;
  std::array<std::array<double, 3>, 3> inverse{};  // of the other columns' Jacobian, approximately
  std::array<std::array<Interval, 3>, 3> excess;   // identity - inverse * Jacobian, over the tube

  /// Whether the other tube, as a set, lies in this one. The other's claim does not matter.
  bool contains(const IntersectionTube& other) const;
  /// A box around the part of the tube over w.
  Box4 over(const Interval& w) const;
  /// Whether all of x lies in the tube, or in the tube's interior.
  bool contains(const Box4& x) const;
};

/// All functions REQUIRE a live ScopedUpward.

enum class Contraction {
  kEmpty,    ///< no common point in the box
  kSlanted,  ///< all common points in the box lie in the slanted box
  kUnknown,  ///< too large, or close to tangential
};
/// One step of Krawczyk's operator. @param x  a rectangle of parameters of each surface; du, dv, ds, dt: their
/// derivatives over
/// it.  @param region  on kSlanted, a tube whose claim is not proved
Contraction contract(const EnclosedSurface& s1, const EnclosedSurface& s2, const Box4& x,
                     const Box3& du, const Box3& dv, const Box3& ds, const Box3& dt,
                     IntersectionTube* region);
/// A tube that contains the region of contract(), or nothing. It reaches beyond the region by `reach` times its range
/// on both sides.
std::optional<IntersectionTube> find_tube(const EnclosedSurface& s1, const EnclosedSurface& s2,
                                          const IntersectionTube& region, double reach);

/// The arc's parameters at w: a narrow box. REQUIRES w in [w_lo, w_hi].
/// @param slope  if not null: approximate derivatives of the parameters by w
Box4 locate(const EnclosedSurface& s1, const EnclosedSurface& s2, const IntersectionTube& tube,
            double w, Point4* slope = nullptr);

/// The derivatives of the arc's parameters by w, over the part of the arc that lies in the box x of the tube: tighter
/// than the tube's own where x is small. @param du... derivatives of the surfaces over x
Box4 derivative_over(const IntersectionTube& tube, const Box3& du, const Box3& dv, const Box3& ds,
                     const Box3& dt);

/// The tube restricted to a part of its range, with tighter offsets and derivatives. Nothing if they do not get
/// tighter.
std::optional<IntersectionTube> shortened(const EnclosedSurface& s1, const EnclosedSurface& s2,
                                          const IntersectionTube& tube, double w_lo, double w_hi);

}  // namespace veritope
