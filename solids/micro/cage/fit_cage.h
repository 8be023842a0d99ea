// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/micro/cage/fit_cage.h: a cage whose w lines follow a field of directions.
// Source: seed paper 003, section 6 (tiles along the principal directions of stress); the method is our own:
// docs/design/0076-cages-that-follow-a-field.md.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "robust/base/box3d.h"
#include "robust/base/result.h"
#include "solids/micro/cage/box_cage.h"
#include "solids/micro/cage/cage_content.h"

namespace veritope {

/// Axes at points. An axis is a direction without a sign: d and -d are the same.
struct DirectionField {
  std::vector<Point3d> points;
  std::vector<Point3d> axes;      ///< of any length
  std::vector<double> thickness;  ///< one a point, or none at all
  std::size_t size() const { return points.size(); }
};

/// The smallest box around the vectors and the content. REQUIRES a vector and finite points.
CageBox box_of(const DirectionField& field, const CageContent& content);

/// The most knot spans of a fit, in all.
inline constexpr std::uint64_t kMaxFitSpans = 4096;
/// The most vectors.
inline constexpr std::size_t kMaxFitVectors = 200'000;

struct FitCageOptions {
  CageGrid grid{{3, 3, 3}, {4, 4, 4}};
  /// The length by which the cage goes beyond the vectors and the content, approximately, in model units; > 0.
  Rational margin;
  unsigned jobs = 1;  ///< threads of the proofs; the result is the same for every number
};

/// Where det J > 0 shortened the last steps of the fit.
struct FitStop {
  std::array<std::size_t, 3> span{};  ///< along u, v, w, from 0
  Point3d near{};                     ///< the image of the middle of the span, approximately
};

struct FitCage {
  CellVolume cell;              ///< with a fourth coordinate, an attribute, if there is a thickness
  std::uint64_t steps = 0;      ///< that were taken
  std::uint64_t shortened = 0;  ///< halvings of steps
  std::optional<FitStop> stop;  ///< where longer last steps would not leave det J proved positive
  double smoothness = 0;        ///< the weight of second derivatives that was chosen
  std::vector<double>
      approx_angles;  ///< between each axis and the w line through its point, in degrees
  /// The differences between the attribute and the thickness of each vector.
  std::vector<double> approx_thickness_errors;
};

/// Begins with a box along the mean axis, around the vectors and the content, and moves all control points in steps of
/// Gauss and Newton: the sum of the squared angles between axes and w lines, plus a multiple of the squared second
/// derivatives, over parameters of the points that move along. The multiple falls as long as the angles of vectors that
/// are held out get smaller; then all vectors are used. Steps are halved until the determinant is proved positive
/// (jacobian_sign.h), all vectors stay inside, and the sum falls. The cage is cut to the parameters that the vectors
/// and the content need, and the margin. Control points are multiples of a power of two near a 2^20th of the diagonal.
/// Whether the cage is one to one, and whether the content is inside, is left to the caller (certify, find_gap).
/// @param content  what has to lie inside, too; may have no part
/// @error kBadArgument for a field without vectors; for numbers that are not finite, and an axis that is 0, with the
///        number of the vector as place.index; for a margin that is not positive; as check_cage_grid; kOverLimit for
///        degrees over kMaxFitDegree, more than kMaxFitSpans spans or kMaxFitVectors vectors, and places that are
///        2^30 times as far from the origin as their box is large
Result<FitCage> fit_cage(const DirectionField& field, const CageContent& content,
                         const FitCageOptions& options);

}  // namespace veritope
