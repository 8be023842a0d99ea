# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Small closed models for star_box_test.py: exact, known by construction."""
from fractions import Fraction as Q

import star_box_forge as forge

CUBE_FACES = ((0, 1, 2), (1, 2, 0), (2, 0, 1))            # axis of the normal, of u, of v


def cube_faces():
    """(point of (u, v) in [-1, 1]^2) for the six faces of [-1, 1]^3, outward."""
    for n, a, b in CUBE_FACES:
        for side in (1, -1):
            def at(u, v, n=n, a=a, b=b, side=side):
                p = [0, 0, 0]
                p[n], p[a], p[b] = side, u * side, v
                return tuple(p)
            yield at


def cube(half=1, middle=(0, 0, 0), degree=1, shape=lambda p: p):
    rows = []
    grid = [Q(2 * i, degree) - 1 for i in range(degree + 1)]
    for at in cube_faces():
        rows.append([[tuple(m + half * c for m, c in zip(middle, shape(at(u, v)))) for v in grid] for u in grid])
    return [forge.surface(r) for r in rows]


def bicubic_ball():
    return cube(degree=3, shape=lambda p: [c * (Q(5, 4) - sum(x * x for x in p) * Q(3, 16)) for c in p])


def reversed_surface(entity):
    """u and v exchanged."""
    shape = entity["shape"]
    p, q = shape["degrees"]
    m, n = len(shape["knots"][0]) - p - 1, len(shape["knots"][1]) - q - 1
    shape = dict(shape, degrees=[q, p], knots=shape["knots"][::-1], points=[shape["points"][i * n + j] for j in range(n) for i in range(m)])
    return dict(entity, shape=shape)


def triangles(points, faces):
    return [forge.triangle([points[v] for v in f]) for f in faces]


def tetrahedron(scale=1, at=(0, 0, 0)):
    points = [tuple(a + scale * c for a, c in zip(at, p)) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
    return triangles(points, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])


ARC = ((1, 0, 1), (1, 1, 1), (0, 2, 2))                   # a quarter of the unit circle, homogeneous


def arc(quarter):
    points = ARC
    for _ in range(quarter % 4):
        points = tuple((-y, x, w) for x, y, w in points)
    return points


def torus(major=2, minor=1):
    """Sixteen rational biquadratic patches."""
    out = []
    for i in range(4):
        for j in range(4):
            rows = [[((major * w + minor * c) * x, (major * w + minor * c) * y, minor * s * v, w * v) for c, s, w in arc(j)]
                    for x, y, v in arc(i)]
            out.append(forge.surface(rows, rational=True))
    return out


def octant_sphere(radius=1):
    """Eight rational biquadratic octants with collapsed sides at the poles."""
    out = []
    for i in range(4):
        for j in (0, 3):
            rows = [[(radius * c * x, radius * c * y, radius * s * v, w * v) for c, s, w in arc(j)] for x, y, v in arc(i)]
            out.append(forge.surface(rows, rational=True))
    return out


def cubic_octahedron():
    """Eight cubic triangles, bulged: control points of the edges depend on the edge alone."""
    axes = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    out = []
    for x in (0, 1):
        for y in (2, 3):
            for z in (4, 5):
                corners = [axes[x], axes[y], axes[z]]
                if (x + y + z) % 2:
                    corners[1], corners[2] = corners[2], corners[1]
                points = []
                for r in range(4):
                    for k in range(r + 1):
                        weights = (3 - r, r - k, k)
                        grow = Q(6, 5) if sorted(weights) == [0, 1, 2] else Q(3, 2) if weights == (1, 1, 1) else 1
                        points.append(tuple(grow * sum(Q(w, 3) * c[a] for w, c in zip(weights, corners)) for a in range(3)))
                out.append(forge.triangle(points, 3))
    return out


VOXELS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1))


def snake(cells=VOXELS):
    """The boundary of unit cubes, two triangles a face. At (1, 1, 1) the normals of four cubes in a path lie in no open half-space."""
    faces = []
    for cell in cells:
        for at in cube_faces():
            beyond = tuple(c + int(n) for c, n in zip(cell, [sum(p[k] for p in (at(-1, -1), at(1, 1))) // 2 for k in range(3)]))
            if beyond not in cells:
                a, b, c, d = [tuple(m + (x + 1) // 2 for m, x in zip(cell, at(*uv))) for uv in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
                faces += [(a, b, c), (a, c, d)]
    return [forge.triangle(f) for f in faces]
