// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/classify/patch_foot_internal.h: the parameters at which a patch passes through a point, found by Newton's
// method in ever more bits and proved by substitution. Internal to solids/classify.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "robust/dyadic.h"
#include "robust/rational.h"
#include "solids/classify/algebraic_foot_internal.h"
#include "solids/classify/ray_point.h"
#include "solids/classify/tensor_form.h"

namespace veritope::internal {

class PatchFoot {
 public:
  /// @param start  parameters of the square near which to search
  PatchFoot(const TensorForm& form, const RayPoint& point, const std::array<double, 2>& start);

  /// Improves the parameters until the distance from the point is below 2^-bits of the patch's size. False if it does
  /// not fall: the patch seems to pass the point, or to have no tangent plane there.
  bool refine(int bits);

  /// Parameters in [0,1]^2, exactly those of the point; nothing if none that are simple within 2^-bits of the current
  /// ones are.
  std::optional<std::array<Rational, 2>> exact_parameters(int bits) const;

  /// Approximately.
  const std::array<Dyadic, 2>& parameters() const { return at_; }

  /// Parameters that are roots of polynomials; see algebraic_parameters.
  std::optional<AlgebraicPair> irrational_parameters(int bits) const {
    return algebraic_parameters(*form_, net_, at_, bits);
  }

  /// Parameters of the point where it is the end of a collapsed side of the square.
  static std::optional<std::array<Rational, 2>> at_collapsed_side(const TensorForm& form,
                                                                  const RayPoint& point);

 private:
  using Values = std::array<Integer, 3>;
  /// The homogeneous point relative to `point_`, times a positive number. u and v are fractions of [0,1].
  Values at(const std::array<Integer, 2>& numerators,
            const std::array<Integer, 2>& denominators) const;
  void find_tangents();

  const TensorForm* form_;
  std::array<std::vector<Integer>, 3> net_;  // relative to the point
  std::int64_t net_bits_ = 0;
  std::array<Dyadic, 2> at_;
  std::array<std::array<double, 2>, 3> tangents_{};  // of the net divided by 2^net_bits_
};

}  // namespace veritope::internal
