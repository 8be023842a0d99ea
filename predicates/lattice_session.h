// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/lattice_session.h: the predicates for a model whose coordinates fit one lattice: each vertex becomes
// integers once, and a decision is a few integer products of the width that the model needs. It complements session.h
// for models of few digits, where degenerate tuples are the rule.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "predicates/vec.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"

namespace veritope {

namespace internal {

/// How wide the differences of a model's coordinates are; none is greater than 2^11, 2^30, 2^61.
enum class LatticeSpan : unsigned char { kTiny, kShort, kOneLimb, kTooWide };

/// Coordinates as integers, the first point's being 0. An axis is in units of its own, the greatest
/// power of two that divides all of its differences; `shift` leads to the least of these units.
template <std::size_t Dim>
struct LatticeModel {
  using Point = std::array<std::int64_t, Dim>;
  std::vector<Point> vertices;
  std::array<int, Dim> shift{};
  LatticeSpan own = LatticeSpan::kTiny;     ///< each axis in its own units
  LatticeSpan common = LatticeSpan::kTiny;  ///< all axes in the least unit
};

}  // namespace internal

/// The exact signs of orient2d and in_circle for the vertices of one model, by their indices. Immutable: threads may
/// share it. It takes 16 bytes per vertex, or 32 if the differences exceed 2^30 units, because then the filter goes
/// first.
class LatticeSession2d {
 public:
  /// The session of n points, with their indices. Empty iff a coordinate is not finite or, on some axis, two differ by
  /// more than 2^61 times the greatest power of two that divides all differences of that axis: use Session2d then. n =
  /// 0 is allowed. O(n), in integers only: correct in every floating-point environment.
  static std::optional<LatticeSession2d> of(const Vec2d* points, std::size_t n);

  std::size_t size() const noexcept { return model_.vertices.size(); }
  /// Do both axes fit 2^61 of one unit? Otherwise orient2d is the only predicate.
  bool has_circles() const noexcept { return model_.common != internal::LatticeSpan::kTooWide; }

  /// Like the functions of these names. REQUIRES indices < size(); in_circle REQUIRES has_circles(),
  /// else InternalError. Counted as Tier::kLattice, or Tier::kFilter where that goes first.
  Sign orient2d(std::size_t a, std::size_t b, std::size_t c, TierCounts* tally = nullptr) const;
  Sign in_circle(std::size_t a, std::size_t b, std::size_t c, std::size_t d,
                 TierCounts* tally = nullptr) const;

 private:
  LatticeSession2d() = default;
  internal::LatticeModel<2> model_;
  std::vector<Vec2d> points_;  // for the filter; empty if the filter is never used
};

/// The predicates for vertices in space. 24 bytes per vertex; 48 if the differences exceed 2^11 units.
class LatticeSession3d {
 public:
  /// Like LatticeSession2d::of.
  static std::optional<LatticeSession3d> of(const Vec3d* points, std::size_t n);

  std::size_t size() const noexcept { return model_.vertices.size(); }
  /// Do all axes fit 2^61 of one unit? Otherwise orient3d is the only predicate.
  bool has_spheres() const noexcept { return model_.common != internal::LatticeSpan::kTooWide; }

  /// Like the functions of these names. REQUIRES indices < size(); in_sphere REQUIRES has_spheres(),
  /// else InternalError. Counted as above.
  Sign orient3d(std::size_t a, std::size_t b, std::size_t c, std::size_t d,
                TierCounts* tally = nullptr) const;
  Sign in_sphere(std::size_t a, std::size_t b, std::size_t c, std::size_t d, std::size_t e,
                 TierCounts* tally = nullptr) const;

 private:
  LatticeSession3d() = default;
  internal::LatticeModel<3> model_;
  std::vector<Vec3d> points_;
};

}  // namespace veritope
