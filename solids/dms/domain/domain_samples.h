// SPDX-License-Identifier: LGPL-3.0-or-later
// solids/dms/domain/domain_samples.h: which points of dense data become vertices of a coarse domain: on feature lines
// and on smooth parts of the boundary by their curvature, inside by the density of the data. Chosen in binary64: a
// choice makes a domain coarser or finer, and nothing else depends on it.
// Source: [HHQ04], section 5.2.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "predicates/vec.h"
#include "topology/tetrahedral_complex.h"

namespace veritope {

/// The vertices of a line that remain: its ends, and as many others as keep the line within `tolerance` of the chords
/// between neighbours, and no chord longer than `most`, as far as there are vertices. More where it is curved more.
/// A closed line begins and ends with the same vertex. Source: [DP73].
/// REQUIRES at least two vertices, numbers of points.
std::vector<std::uint32_t> sample_feature_line(std::span<const Vec3d> points,
                                               std::span<const std::uint32_t> line,
                                               double tolerance, double most);

/// Distances between samples of a surface.
struct SurfaceSteps {
  double least = 0, most = 0;  ///< where the surface is curved most, and where it is flat
  double turn =
      0.5;  ///< the angle, in radians, by which normals of neighbouring samples may differ
};

/// The curvature at each vertex of the boundary: how fast the normals of its neighbours turn, where the mean over the
/// faces at a vertex is its normal. Zero for other vertices.
std::vector<double> approx_curvatures(std::span<const Vec3d> points,
                                      const TetrahedralComplex& complex);

/// Candidates, in their order, that are not nearer than their step to those accepted before, nor to those in `taken`.
/// The step of a vertex is turn / curvature, between least and most.
std::vector<std::uint32_t> sample_surface(std::span<const Vec3d> points,
                                          std::span<const double> curvatures,
                                          std::span<const std::uint32_t> candidates,
                                          std::span<const std::uint32_t> taken,
                                          const SurfaceSteps& steps);

/// At most `count` candidates, as dense in each region as the candidates are, in proportion: each so many-th one along
/// a Hilbert curve. Ascending.
std::vector<std::uint32_t> sample_interior(std::span<const Vec3d> points,
                                           std::span<const std::uint32_t> candidates,
                                           std::size_t count);

}  // namespace veritope
