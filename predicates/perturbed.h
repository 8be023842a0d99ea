// SPDX-License-Identifier: LGPL-3.0-or-later
// predicates/perturbed.h: the predicates on points that are moved by infinitesimal amounts, so that no
// answer is zero: for algorithms without degenerate cases. Each call chooses; there is no state.
// Source: [EM90]; the weights of in_circle and in_sphere come first, as in [DT11].
#pragma once
#include <array>
#include <cstdint>

#include "predicates/vec.h"
#include "robust/base/sign.h"
#include "robust/cascade.h"

namespace veritope {

/// What tells points apart, whatever their coordinates: an index that a point keeps.
using PointId = std::uint64_t;

// Each answers as the predicate of the same name where that is not zero. Where it is zero, all points count as
// moved: coordinate j of the point with the k-th smallest id by an amount e(k, j) > 0, and for in_circle and
// in_sphere the sum of the squares x^2 + y^2 (+ z^2) of the unmoved point by a further one, e(k). (That is a
// weight: the circle is that of a power diagram.) Every amount is less than any product of larger ones:
//   e(0) >> e(1) >> ... >> e(0, x) >> e(0, y) >> e(0, z) >> e(1, x) >> ...
// More precisely, the r-th one in this order is e^(2^r) for one e > 0 that is smaller than any given number.
// Laws:
//   (1) never zero;
//   (2) swapping two points together with their ids negates it: the order of the arguments does not matter;
//   (3) only the order of the ids matters, and all answers about the same points and ids are those of one set of
//       moved (and weighted) points: no two of them contradict each other.
// REQUIRES finite coordinates; distinct ids, else InternalError where the answer depends on them.

Sign orient2d_perturbed(const std::array<Vec2d, 3>& points, const std::array<PointId, 3>& ids,
                        TierCounts* tally = nullptr);
Sign orient3d_perturbed(const std::array<Vec3d, 4>& points, const std::array<PointId, 4>& ids,
                        TierCounts* tally = nullptr);
Sign in_circle_perturbed(const std::array<Vec2d, 4>& points, const std::array<PointId, 4>& ids,
                         TierCounts* tally = nullptr);
Sign in_sphere_perturbed(const std::array<Vec3d, 5>& points, const std::array<PointId, 5>& ids,
                         TierCounts* tally = nullptr);

}  // namespace veritope
