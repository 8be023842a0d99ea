// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/random_solids.h: random patch models of known truth, each by a short proof that uses no star box.
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
  std::vector<std::int64_t> genus;  ///< the shells', ascending; for embedded models
  std::uint64_t bodies = 0;         ///< for embedded models
};

/// Unions of up to six unit cubes whose boundary is a manifold; their faces as tensors of degrees (n, n) or as pairs of
/// triangles of degree n, n = 2 or 3; control points moved by d, |d| <= r, equal ones alike; then an affine image,
/// sometimes with a quadratic shear.
/// Embedded if r < 1/(4n); r = share/(4n), so share < 1 suffices. Proof: points p and q on the cubes' boundary move by
/// D(p), D(q), and in a face |D'| <= sqrt(2) n 2r. If the faces of p and q share an edge or a vertex, a path of at most
/// sqrt(2)|p - q| joins them on the boundary (faces that share only a vertex see each other under a right angle or
/// more), so |D(p) - D(q)| <= 4nr|p - q| < |p - q|. Otherwise |p - q| >= 1 > 2r.
/// has_opposed: whether there are vertices where two faces looked in opposite directions: there the normals may lie in
/// no open half-space, and star boxes need not exist.
Model perturbed_blocks(Random& random, double share, bool has_opposed = false);

/// An embedded model: perturbed blocks with share in [0.2, 0.97].
Model embedded(Random& random);
/// An embedded model with opposed faces, which are beyond what the method promises to certify.
Model opposed(Random& random);
/// Not one to one: two sheets pass a planted point, each inside a patch, at an angle whose sine is at least 1/8. Either
/// there are two shells, the second an affine image moved there, or one shell, of which two patches without a common
/// vertex were made to meet by their inner control points.
Model crossing(Random& random);
/// Not one to one: a planted contact of two shells. It is tangent from outside in a point (the second one's tangent
/// plane turned to the first one's), a vertex on a vertex, on an edge or in a face, or an edge through a point of an
/// edge or of a face. Some of these models also cross nearby.
Model touching(Random& random);
/// Models of unknown truth: blocks moved beyond the bound, or two embedded models, one moved near the other.
Model unknown(Random& random);

}  // namespace veritope::random_solids
