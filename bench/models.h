// SPDX-License-Identifier: LGPL-3.0-or-later
// bench/models.h: the models that the mesh benchmarks run on. Named in docs/benchmarks.md.
#pragma once
#include <string>

#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::bench {

/// A real model of $VERITOPE_DATA (default ../shared/data), read by the reading rule. Ends the program if the model is
/// missing.
TriangleMesh data_model(const std::string& name);

/// One step of Loop subdivision: four facets for each one, points in generic position. REQUIRES a closed manifold.
TriangleMesh loop_step(const TriangleMesh& mesh);

/// Every facet cut into four at the midpoints of its edges, rounded: (nearly) coplanar neighbours.
TriangleMesh flat_step(const TriangleMesh& mesh);

enum class Caps { kCentreFan, kRimFan, kZigzag };

/// A tilted cylinder of radius 1 with `sides` sides and 4 * sides facets (4 * sides - 4 without centres). All facets
/// are long and thin if the cylinder is long; those of the caps are if it is a plate.
TriangleMesh sliver_cylinder(unsigned sides, Caps caps, double length = 10);

/// bunny70k, blade199k, loop1115k, flat1115k, sliver20k, sliver80k; sliver20k_rim, ... with other caps; plate20k_rim,
/// ... of length 0.001.
TriangleMesh named_model(const std::string& name);

}  // namespace veritope::bench
