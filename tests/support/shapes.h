// SPDX-License-Identifier: LGPL-3.0-or-later
// tests/support/shapes.h: small models for tests, as text and by generator. tests/solids/validity_diff_test.cc tests
// against brute force what the generators promise.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robust/base/random.h"
#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::shapes {

/// Commands are separated by ';', words by blanks. Numbers are decimals, hexadecimal floats or quotients a/b (rounded
/// to nearest).
///   tri P P P             one triangle, as given
///   tet P P P P           outward if orient3d of its points is positive
///   box P P               outward, least and greatest corner, 12 triangles
///   flip                  reverses the triangles of the last command
///   v P ...  f i,j,k ...  vertices and triangles as they are, ids counted from the first v of the text
/// Vertices of tri, tet and box that have equal coordinates become one. "tet 0,0,0 1,0,0 0,1/3,0 0,0,1"
TriangleMesh parse(std::string_view text);
/// The text "v ... ; f ...", which parse reads back bit for bit.
std::string to_text(const TriangleMesh& mesh);

// Closed, outward, embedded, one shell, unless the line says otherwise.
TriangleMesh box(Vec3d lo, Vec3d hi, int parts = 1);              ///< each side cut into parts * parts squares
TriangleMesh prism(int sides, double radius, double height);      ///< over a regular polygon; caps are fans from a corner
TriangleMesh torus(int around, int across, double big, double small);
TriangleMesh star_polyhedron(Random& random, int level);          ///< 8 * 4^level facets, radii 1..4
TriangleMesh bipyramid(int sides);                                ///< two poles of that valence
TriangleMesh cone(int sides);                                     ///< apex of that valence, base a fan from a rim corner
enum class Cap { kCentreFan, kRimFan, kZigzag };
TriangleMesh tilted_cylinder(int sides, Cap cap, double length = 10);  ///< radius 1, along (3, 2, 1)
TriangleMesh hyperboloid(int sides, int twist);                   ///< one sheet; the facets run askew from ring to ring; centre fans
TriangleMesh saddle();                                            ///< four octants; its centre has no star direction
TriangleMesh wave(int sides, double height);                      ///< a pole of that valence whose rim goes up and down

/// The boundary of a set of unit cells, with equal places as one vertex: closed and oriented; embedded only if no two
/// cells meet in just an edge or a corner.
TriangleMesh polycube(const std::vector<std::array<int, 3>>& cells);
TriangleMesh random_polycube(Random& random, int size, int num_cells);

// Several shells.
TriangleMesh nested_boxes(int depth);                             ///< alternately out and in: valid, that many shells
TriangleMesh box_grid(int n, double gap);                         ///< n^3 boxes, apart
TriangleMesh nested_scene(Random& random, int shells);            ///< valid: boxes side by side and in each other, nested up to 6 deep
TriangleMesh needles(Random& random, int num);                    ///< thin tetrahedra, one a cell of a grid: valid

// Not valid, or valid by chance.
TriangleMesh needle_soup(Random& random, int num_triangles);      ///< open; long thin triangles that cross
TriangleMesh grid_soup(Random& random, int num_triangles, int grid);  ///< corners in {0..grid-1}^3, merged; degenerate ones too
TriangleMesh random_indexed(Random& random, int num_triangles, int num_vertices, int grid);  ///< ids at random

// Functions of models.
TriangleMesh joined(std::span<const TriangleMesh> parts);         ///< ids one after the other, no merging
TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b);
TriangleMesh reversed(TriangleMesh mesh);
TriangleMesh moved(TriangleMesh mesh, Vec3d by);                  ///< rounded
TriangleMesh scaled(TriangleMesh mesh, int exponent);             ///< times 2^exponent
TriangleMesh merged(const TriangleMesh& mesh);                    ///< equal coordinates become one vertex, by first occurrence
using Matrix = std::array<std::array<int, 3>, 3>;
int determinant(const Matrix& m);
/// REQUIRES (checked) that the image is exact, as it is for coordinates with few bits.
TriangleMesh mapped(const TriangleMesh& mesh, const Matrix& m, std::array<int, 3> shift);
Matrix random_matrix(Random& random, int size);                   ///< |determinant| > 0
/// The model with vertices renumbered, facets in another order and corners rotated.
TriangleMesh relabelled(const TriangleMesh& mesh, Random& random);
/// Every facet cut into four at the midpoints of its edges. REQUIRES (checked) midpoints that binary64 holds.
TriangleMesh subdivided(const TriangleMesh& mesh);

}  // namespace veritope::shapes
