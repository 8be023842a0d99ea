// SPDX-License-Identifier: LGPL-3.0-or-later
// hard_models/mesh_shapes_internal.h: small meshes from which hard ones are made.
#pragma once
#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "solids/polyhedron/triangle_mesh.h"

namespace veritope::hard_models::internal {

/// The tetrahedron 0, e1, e2, e3.
TriangleMesh tetrahedron();
/// Twelve triangles. REQUIRES low < high in every coordinate for a valid mesh.
TriangleMesh box(const Vec3d& low, const Vec3d& high);
/// A triangle with the corners 0, (4, 0, 0), (0, 4, 0) is the waist of two pyramids with the apexes p and q.
TriangleMesh bipyramid(const Vec3d& p, const Vec3d& q);
/// A tetrahedron with the apex `tip` that points down to it.
TriangleMesh spike(const Vec3d& tip);
/// An octahedron of radius 1 whose faces are cut into n^2 triangles, with the vertices on the sphere.
TriangleMesh sphere(std::uint32_t n);
/// Csaszar's polyhedron: the torus with the fewest vertices, 7.
TriangleMesh small_torus();
/// A square ring with a square section: genus 1.
TriangleMesh frame();

/// x -> scale x + shift in each coordinate; an odd number of negative scales reverses the faces. REQUIRES that the
/// results are exact where the caller relies on them.
TriangleMesh placed(TriangleMesh mesh, const Vec3d& scale, const Vec3d& shift);
TriangleMesh reversed(TriangleMesh mesh);
/// All faces of the parts; equal positions become one vertex.
TriangleMesh joined(std::initializer_list<TriangleMesh> parts);
/// Merges equal positions, in the order of their first occurrence; the faces stay as they are.
TriangleMesh with_distinct_positions(const TriangleMesh& mesh);

}  // namespace veritope::hard_models::internal
