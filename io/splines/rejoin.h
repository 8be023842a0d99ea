// SPDX-License-Identifier: LGPL-3.0-or-later
// io/splines/rejoin.h: cuts the surfaces and triangles of a model at the corners of neighbours that lie inside their
// sides (T-junctions), exactly: the point set stays the same, and sides become equal one to one.
// Design: docs/design/0037-named-gaps-and-joints.md.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "io/splines/spline_model.h"
#include "robust/base/result.h"

namespace veritope {

/// A place of a side where a neighbour's corner lies. Entities have the numbers of the model that was given.
struct Joint {
  std::uint64_t entity = 0, neighbour = 0;
  /// The place in `entity`, in its own parameters: u and v, or the barycentric coordinates in the triangle or its part.
  std::vector<Rational> at;
};

struct Rejoined {
  SplineModel model;
  /// In order: a surface has the knot, a triangle was cut in two, the second of which is the model's last entity.
  std::vector<Joint> joined;
  std::vector<std::string> left;  ///< sides that do not fit and were left alone, a sentence each
};

/// Joins where the sides are equal as maps after an affine change of parameter, until no such place is left. An
/// insertion may make another one necessary on the opposite side.
/// @param can_hold  whether the output's format can hold the entity exactly; otherwise the side is left alone
/// @error as patch_source; kBadArgument for an entity that is not a surface or triangle in space
Result<Rejoined> rejoined(const SplineModel& model,
                          const std::function<bool(const SplineEntity&)>& can_hold);

}  // namespace veritope
