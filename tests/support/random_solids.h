// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/random_solids.h: random patch models whose truth is known by construction, each by a short proof that uses no star box.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "robust/base/random.h"
#include "solids/patches/patch.h"
#include "splines/affine_map.h"

namespace veritope::random_solids {

using Patches = std::vector<Patch>;

/// Entries with few bits, a determinant of either sign over 1/4 in absolute value.
AffineMap random_map(Random& random);

struct Model {
  Patches patches;
  std::string description;          ///< how it was built, with its parameters
  std::vector<std::int64_t> genus;  ///< of the shells, ascending: of embedded models
  std::uint64_t bodies = 0;         ///< of embedded models
};

/// Unions of up to six unit cubes whose boundary is a manifold; its faces as tensors of degrees (n, n) or as pairs of triangles of degree n, n = 2 or 3; control points
/// moved by d, |d| <= r, equal ones alike; an affine image, sometimes a quadratic shear of all that.
/// Embedded if r < 1/(4n), for which `share` < 1 says r = share/(4n). Proof: p and q on the cubes' boundary are moved by D(p), D(q), and in a face |D'| <= sqrt(2) n 2r. If the
/// faces of p and q share an edge or a vertex, a path of at most sqrt(2)|p - q| joins them on the boundary (faces that share a vertex only see each other under a right
/// angle or more), so |D(p) - D(q)| <= 4nr|p - q| < |p - q|. Otherwise |p - q| >= 1 > 2r.
/// Without or with vertices where two faces looked in opposite directions: there the normals may lie in no open half-space, and star boxes need not exist.
Model perturbed_blocks(Random& random, double share, bool has_opposed = false);

/// An embedded model: perturbed blocks with share in [0.2, 0.97].
Model embedded(Random& random);
/// Such a model with opposed faces: embedded, but beyond what the method promises to certify.
Model opposed(Random& random);
/// Not one to one: two sheets pass a planted point, inside a patch each, at an angle whose sine is at least 1/8. Two shells, the second an affine image moved there, or one
/// shell, two of whose patches without a common vertex were made to meet by their inner control points.
Model crossing(Random& random);
/// Not one to one: a planted contact of two shells: tangent from outside in a point (the second one's tangent plane turned to the first one's), vertex on vertex, on an
/// edge or in a face, an edge through a point of an edge or of a face. Some of them cross nearby as well.
Model touching(Random& random);
/// Nothing is known: blocks moved beyond the bound, or two embedded models, one moved near the other.
Model unknown(Random& random);

}  // namespace veritope::random_solids
