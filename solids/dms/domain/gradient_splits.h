// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/gradient_splits.h: more vertices of a domain where the gradients of data differ much.
// Source: [HHQ04], section 5.2.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "predicates/exact_point.h"
#include "robust/base/result.h"
#include "solids/dms/dms_model.h"

namespace veritope {

/// The gradient of one attribute at each point: the mean, weighted by volume, of those of the linear functions that
/// have the values at the corners of the tetrahedra there. Zero at points without a tetrahedron. Rounded.
/// REQUIRES a value for each point, positive tetrahedra.
std::vector<std::array<double, 3>> approx_gradients(std::span<const ExactPoint3> points,
                                                    std::span<const TetrahedronCorners> tetrahedra,
                                                    std::span<const double> values);

struct GradientSplits {
  DmsModel model;  ///< of degree 1, the identity; the first vertices are those of the domain
  std::size_t inserted = 0;
};

/// In the tetrahedron where the gradients at its data, vertices left out, deviate most from their mean, by the root of
/// the mean square times the cube root of its volume, the datum with the greatest gradient becomes a vertex; and so on,
/// while a deviation is greater than `threshold` times the greatest one at the beginning, and at most `most` are
/// inserted and there are at most `max_tetrahedra`. The domain stays the same set.
/// (The paper splits a tetrahedron into four, with the vertex where the gradient is greatest; here the vertex is
/// inserted with its Delaunay cavity, so that edges are cut, too.)
/// @param gradients  of several attributes, one after the other for each point
/// @error kBadArgument as refine_domain
Result<GradientSplits> split_by_gradients(const DmsModel& domain,
                                          std::span<const ExactPoint3> points,
                                          std::span<const std::array<double, 3>> gradients,
                                          double threshold, std::size_t most,
                                          std::size_t max_tetrahedra);

}  // namespace veritope
