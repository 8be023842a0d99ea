// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/random_v_models.h: random V-models of known truth, each by a short proof that uses neither star boxes
// nor coefficients of determinants.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "robust/base/random.h"
#include "solids/vmodel/v_model.h"
#include "splines/affine_map.h"
#include "tests/support/v_cells.h"

namespace veritope::random_v_models {

using v_cells::Point;

/// What is known about a model whose cells exclude one another.
struct KnownSolid {
  std::vector<std::int64_t> genus;  ///< of the shells, ascending
  std::uint64_t bodies = 0;
  std::uint64_t v_surfaces = 0, v_curves = 0, v_points = 0;
  bool is_regular = true;  ///< no determinant vanishes anywhere
};

struct Model {
  std::vector<VVolume> cells;
  std::string description;  ///< how it was built, with its parameters
  std::optional<KnownSolid> solid;
  /// Folded models: the determinant of this cell is negative at this parameter, exactly.
  std::size_t folded_cell = 0;
  std::optional<Point> negative_at;
  /// Models that are not manifolds: the edges, (cell, edge), and corners, (cell, corner), on such V-curves and V-points.
  std::set<std::pair<std::size_t, std::size_t>> bad_edges, bad_corners;
};

/// The cells, right-handed or not, after the affine map.
std::vector<VVolume> affine_image(const std::vector<VVolume>& cells, const AffineMap& map);
/// Entries with few bits, a determinant of either sign over 1/4 in absolute value.
AffineMap random_affine_map(Random& random);
Rational determinant(const AffineMap& map);

// Exclusive models. All have unit cubes, moved: control points at multiples of 1/p, 1/q, 1/r of a box of cubes move by
// less than s in each coordinate, equal ones alike, with 2 s (p + q + r) < 1. Then the map is x + g(x) with
// |g(x) - g(y)| <= 2 s (p + q + r) |x - y| in the maximum norm, on the whole box, which is convex: the partial
// derivatives of g have control values of at most 2 s p, 2 s q, 2 s r. So it is one to one, and its derivative, the
// identity plus a matrix of norm below 1, has a positive determinant, as it can be contracted to the identity.
// After it comes, sometimes, a quadratic shear (x, y + a x^2, z + b x^2 + c x y + d y^2), which is one to one and has
// the determinant 1.

/// A box of 1 to 3 cubes along each axis, at most 8 in all; or one cell of 1 to 3 knot spans along v.
Model grid(Random& random);
/// A random manifold subset of a box of cubes. If it has faces that look in opposite directions at one vertex, then
/// star boxes exist in general only for flat faces, and it is neither moved nor sheared.
Model polycube(Random& random);
/// Moved or sheared, with such faces.
Model opposed(Random& random);
/// A chain of 3 to 8 cells around the z-axis, (u, v, w) -> rho(u, w) c(v), h(u, w): (rho, h) is a map of the square
/// into the half-plane rho > 0 that is moved as above; c is a curve around 0, quadratic or rational, whose angle
/// increases, as the coefficients of c x c' are positive. Sheared at times, as all that follow.
Model ring(Random& random);
/// A chain as of a ring, with a second summand of h, which rises with v and by more in a turn than h does over the
/// square.
Model helix(Random& random);

/// A box, cylinder, cone, torus or sphere of solids/volumes/primitives.h, or one cell that is a cylinder or a sphere:
/// with collapsed faces, and glued to itself. At times sheared, if its cells have no knots.
Model primitive(Random& random);

/// A grid of cells of degree 2 or 3. Inner control points of one cell are moved so that N at one inner parameter is
/// -2^-40 times what it was, up to 1/1000 of this: N is linear in one common factor of the shifts. In half of the
/// models the parameter is, up to 2^-24, the one at which N vanishes first as the factor grows: then N is hardly less
/// elsewhere, and negative in a tiny part of the cell. The faces do not change. At times two cells are one with a knot.
Model folded(Random& random);

/// Every cell has N > 0, and two cells, or parts of one, overlap, 2^-30 to 1/2 deep: a helix that rises by too little
/// in a turn, at times as a single cell; blocks pushed into one another; a cell inside another; a cell twice, moved or
/// not.
Model overlapping(Random& random);

/// Two cells or blocks that touch in a part of a face or edge, and share an arc of sides or a corner.
Model touching_at_sides(Random& random);
/// They share neither.
Model touching_inside(Random& random);

/// Cubes, moved and sheared as above, that exclude one another; two of them share an edge or a vertex and no face
/// through it. Two cubes, or a polycube.
Model non_manifold(Random& random);

}  // namespace veritope::random_v_models
