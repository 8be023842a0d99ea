// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/dms_moves.h: moves of the parts of a simplex-spline solid, exactly: control points, coefficients of
// attributes, knots, lattices of free-form deformation, and skeletons that give an attribute its coefficients.
// Source: [HHQ04], sections 4.3 and 4.4.  What they mean: docs/cli/dms-edit.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "robust/base/result.h"
#include "solids/dms/dms_model.h"

namespace veritope {

/// A move by a vector, or to a place.
struct DmsShift {
  DmsPoint amount;
  bool is_place = false;
};

struct DmsControlMove {
  std::size_t control = 0;  ///< the control point's number
  DmsShift shift;
};
struct DmsCoefficientMove {
  std::size_t control = 0, attribute = 0;
  Rational amount;
  bool is_value = false;  ///< the new coefficient; else what is added
};
struct DmsKnotMove {
  std::uint32_t vertex = 0;
  std::size_t knot = 0;  ///< a knot that the cloud has
  DmsShift shift;
};

/// A uniform clamped B-spline of displacements over a box: counts[a] nodes along axis a. Control points in the closed
/// box move by its values; all others stay.
struct DmsLattice {
  DmsPoint low, high;
  std::array<int, 3> degree{};
  std::array<std::size_t, 3> counts{};
  struct Node {
    std::array<std::size_t, 3> at{};
    DmsPoint by;
  };
  std::vector<Node> nodes;  ///< those that move; one that occurs twice moves by both
};

/// The points c + t_0 axes[0] + t_1 axes[1] + t_2 axes[2] with t_0^2 + t_1^2 + t_2^2 <= 1.
struct DmsEllipsoid {
  DmsPoint centre;
  std::array<DmsPoint, 3> axes;
};
/// w over(s) / under(s). s is the squared distance from a point or a polyline; for an ellipsoid it is 0 inside and
/// t_0^2 + t_1^2 + t_2^2 - 1 outside.
struct DmsSkeleton {
  std::variant<std::vector<DmsPoint>, DmsEllipsoid> shape;  ///< corners of a polyline, one or more
  std::vector<Rational> over, under;                        ///< from the constant term on
  Rational weight{1};
};
inline constexpr std::uint64_t kMaxRoundBits = 1000;  ///< the most that DmsSkeletonMove may ask for
/// Each coefficient of the attribute becomes the sum of the skeletons' fields at its control point.
struct DmsSkeletonMove {
  std::size_t attribute = 0;
  std::vector<DmsSkeleton> skeletons;
  /// If there is one: the sum is rounded to the nearest multiple of 2^-round_bits, of two the greater one.
  /// REQUIRES at most kMaxRoundBits.
  std::optional<std::uint64_t> round_bits;
};

using DmsMove =
    std::variant<DmsControlMove, DmsCoefficientMove, DmsKnotMove, DmsLattice, DmsSkeletonMove>;

/// Makes the move. REQUIRES numbers in range, 1 <= degree < counts of a lattice, low < high, axes that are independent.
/// @error kBadArgument for a field that has no value at a control point; kOverLimit for a number with too many bits
Status apply_move(DmsModel& model, const DmsMove& move);

}  // namespace veritope
