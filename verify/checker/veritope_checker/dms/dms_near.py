# SPDX-License-Identifier: Apache-2.0 OR MIT
"""What a simplex-spline solid has near a leaf or a tile (docs/certificates/dms-solid.md, sections 5 and 6): the V_gamma
that no plane parts from it, triangles of knots that cut it, the coefficients of the map and of its derivative there."""
from ..common.vectors import dot, sub
from .dms_map import Interpolation, box_of, linear_part, multi_indices, triples
from .dms_walls import Region, face_planes, upright_planes

def scaled_planes(spline, planes):
    return [(vector, spline.scale * number) for vector, number in planes]

def leaf_region(spline, corners, root, planes):
    """A tetrahedron in another one. planes: of its list."""
    return Region(corners, [*face_planes(corners), *face_planes(root), *scaled_planes(spline, planes)])

def block_region(spline, tetrahedra, planes):
    """The convex hull of some tetrahedra. planes: of its list."""
    tetrahedra = set(tetrahedra)
    corners = [spline.knots[v][0] for v in {v for t in tetrahedra for v in spline.model.tetrahedra[t]}]
    own = {plane for t in tetrahedra for plane in face_planes(spline.corners(t))}
    return Region(corners, [*own, *scaled_planes(spline, planes)])

def tile_region(spline, corners, planes):
    return Region(corners, [*upright_planes(corners), *scaled_planes(spline, planes)])

def unexcluded(spline, region, spend):
    """(tetrahedron, gamma, knots) of all V_gamma that no plane parts from the region."""
    for t in spline.tree.meeting(box_of(region.corners)):
        for gamma in spline.gammas:
            spend()
            knots = [spline.knots[v][k] for v, k in spline.v_of(t, gamma)]
            if not region.misses(knots):
                yield t, gamma, knots

def first_cut(region, near, spend):
    """(tetrahedron, gamma) of a V_gamma, of unexcluded(), with a triangle that no plane parts from the region, or
    None. Triangles in the plane of a tile do not count."""
    for t, gamma, knots in near:
        for three in triples(knots):
            spend()
            if region.normal and not any(dot(region.normal, sub(p, region.corners[0])) for p in three):
                continue
            if not region.misses_triangle(three):
                return t, gamma
    return None

def coefficients(spline, corners, near):
    """Those of s on a leaf or a tile with these corners."""
    near = [(t, gamma) for t, gamma, _ in near]
    interpolation = Interpolation.of(spline.model.degree, len(corners))
    return interpolation.coefficients([spline.at(p, near) for p in interpolation.points(corners)])

def derivatives(spline, corners, near):
    """The coefficients of Ds on a leaf, in the order of multi_indices(), times a positive factor."""
    n = spline.model.degree
    b = dict(zip(multi_indices(n, 4), coefficients(spline, corners, near)))
    for gamma in multi_indices(n - 1, 4):
        yield linear_part(corners, [b[(*gamma[:m], gamma[m] + 1, *gamma[m + 1:])] for m in range(4)])
