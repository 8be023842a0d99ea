# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Small models for the tests of patch-invalid-2, each with two places that have one image, known by construction."""
from fractions import Fraction as Q
from itertools import permutations, product

import patch_invalid_2_forge as forge
import patch_invalid_models as broken
import star_box_forge as star_forge
import star_box_models as models

HALF, CENTROID = (Q(1, 2), Q(1, 2)), (Q(2, 3), Q(1, 2))


def lopsided():
    """A biquadratic patch that no exchange of its parameters maps to itself."""
    return star_forge.surface([[(i, 2 * j + i * j, i * i * (j + 1) + Q(j * j, 3)) for j in range(3)] for i in range(3)])


def lopsided_triangle(degree=3):
    rk = [(r, k) for r in range(degree + 1) for k in range(r + 1)]
    return star_forge.triangle([(r, 2 * k + r * k, r * r * (k + 1) + Q(k * k, 3)) for r, k in rk], degree)


def turned(entity, swap, flip_u, flip_v):
    """Gives the surface other parameters: (u, v) becomes (u, 1 - v) and so on, and then (v, u)."""
    rows = forge.rows_of(entity)[::-1 if flip_u else 1]
    rows = [row[::-1 if flip_v else 1] for row in rows]
    return star_forge.surface([list(r) for r in zip(*rows)] if swap else rows, rational=entity["shape"]["rational"])


def all_turned(entity):
    """The eight; the first is the entity's own."""
    return [turned(entity, *way) for way in product((False, True), repeat=3)]


def all_permuted(entity):
    """A triangle with its corners in all six orders; the first is the entity's own."""
    rows, n = forge.rows_of(entity), entity["shape"]["degree"]
    for order in permutations(range(3)):
        points = []
        for r in range(n + 1):
            for k in range(r + 1):
                ijk = [0, 0, 0]
                for corner, power in zip(order, (n - r, r - k, k)):
                    ijk[corner] = power
                points.append(rows[n - ijk[0]][ijk[2]])
        yield star_forge.triangle(points, n, entity["shape"]["rational"])


def squared(c):
    """The Bernstein coefficients of (t - c)^2."""
    return c * c, c * c - c, (1 - c) ** 2


def plate():
    """[0, 2]^2 in the plane z = 0."""
    return broken.sheet((0, 0, 0), (2, 0, 0), (0, 2, 0))


def bowl():
    """It touches the plate in (2/3, 4/5) and lies above it elsewhere."""
    f, g = squared(Q(1, 3)), squared(Q(2, 5))
    return star_forge.surface([[(i, j, f[i] + g[j]) for j in range(3)] for i in range(3)])


def wheel():
    """It stands on the plate: its border v = 0 touches in (2/3, 4/5)."""
    return star_forge.surface([[(i, Q(4, 5), z + j) for j in range(2)] for i, z in enumerate(squared(Q(1, 3)))])


def pinched():
    """The line u = 1/2 is mapped to one point: ((2u - 1), (2u - 1) v, (2u - 1)^2)."""
    return star_forge.surface([[(a, a * j, b) for j in range(2)] for a, b in zip((-1, 0, 1), (1, -1, 1))])


def one_point(rational=False):
    weights = [[1 + i + 2 * j if rational else 1 for j in range(3)] for i in range(2)]
    rows = [[(3 * w, -w, Q(w, 7), w)[:4 if rational else 3] for w in row] for row in weights]
    return star_forge.surface(rows, rational=rational)


def one_curve():
    """S(u, v) depends on u alone."""
    return star_forge.surface([[(i, i * i, 1)] * 2 for i in range(4)])


def loop():
    """It crosses itself in a line: u = 1/4 and u = 3/4 have the same image."""
    return star_forge.surface([[(x, y, z) for z in (0, 1)] for x, y in zip((-1, Q(13, 9), -Q(13, 9), 1), (0, 3, 3, 0))])


def zigzag():
    """One entity of three patches, of which the first and the last cross in the line x = y = 1."""
    return star_forge.surface([[(x, y, z) for z in (0, 1)] for x, y in ((0, 0), (2, 2), (2, 0), (0, 2))], (1, 1),
                              [[0, 0, 1, 2, 3, 3], [0, 0, 1, 1]])


def spike(p):
    """A patch whose corner u = v = 0 is p."""
    return broken.sheet(p, (0, 0, 5), (1, 0, 4))


# ---------------------------------------------------------------- closed shells that touch

def mapped(x, y, z):
    """The linear map with these columns, as a shape for models.cube()."""
    return lambda p: tuple(sum(c * a[k] for c, a in zip(p, (x, y, z))) for k in range(3))


def leaning(at):
    """A parallelepiped that meets x <= at[0] in its vertex only, which is at."""
    return models.cube(1, [c + d for c, d in zip(at, (4, 3, 0))], shape=mapped((1, 1, -1), (1, 1, 1), (2, 1, 0)))


def crosswise(at, along=Q(1, 3)):
    """A parallelepiped that meets x + y <= at[0] + at[1] in an edge only: through at, in the direction (1, -1, 0). The
    edge's middle is at + along (1, -1, 0), its half is (1, -1, 0)."""
    middle = [c + d for c, d in zip(at, (2 + along, 2 - along, 0))]
    return models.cube(1, middle, shape=mapped((1, 1, -1), (1, 1, 1), (1, -1, 0)))


def moved(entity, by):
    rows = [[tuple(c + d * p[3] for c, d in zip(p, by)) + p[3:] for p in row] for row in forge.rows_of(entity)]
    return star_forge.surface(rows, rational=True)


def revolved(profile):
    """The polyline of points (r, z), turned in four steps, as one surface; v is along the profile."""
    ring, n = [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 0)], len(profile)
    rows = [[(r * x, r * y, z) for r, z in profile] for x, y in ring]
    return star_forge.surface(rows, (1, 1), [[0, *range(5), 4], [0, *range(n), n - 1]])


TIPS = ((0, -2), (1, -1), (0, 0), (1, 1), (0, 2))


def tips():
    """Two octahedra, one upon the other, as one surface of 4 x 4 patches: an inner line, v = 2, is mapped to the point
    where they touch."""
    return revolved(TIPS)


PINCHED_CELLS = ((0, 0, 0), (-1, 0, 0), (-1, 1, 0), (-1, 2, 0), (0, 2, 0), (1, 2, 0), (1, 2, 1), (1, 1, 1))


def pinched_ring():
    """One shell: a path of cubes whose ends touch in the vertex (1, 1, 1)."""
    return models.snake(PINCHED_CELLS)


def touching():
    """(name, entities of the one shell, entities of the other, the point where they touch)"""
    corner, on_edge, on_face = (1, 1, 1), (1, 1, Q(1, 2)), (1, Q(1, 3), Q(1, 2))
    cube, sphere, tetrahedron = models.cube(), models.octant_sphere(), models.tetrahedron(2)
    yield "vertex on vertex", cube, models.cube(1, (2, 2, 2)), corner
    yield "vertex on vertex, leaning", cube, leaning(corner), corner
    yield "edge across edge", cube, crosswise(on_edge), on_edge
    yield "vertex on edge", cube, leaning(on_edge), on_edge
    yield "vertex on face", cube, leaning(on_face), on_face
    yield "vertex on the edge of a triangle", tetrahedron, leaning((1, 1, 0)), (1, 1, 0)
    yield "a triangle's vertex on a vertex", models.tetrahedron(1, corner), cube, corner
    yield "pole on pole", sphere, [moved(e, (0, 0, 2)) for e in sphere], (0, 0, 1)
    yield "pole on face", cube, [moved(e, (0, 0, 2)) for e in sphere], (0, 0, 1)
    yield "vertex on the equator of a torus", models.torus(), leaning((3, 0, 0)), (3, 0, 0)


def touch(one, other, at):
    """The Meeting of two shells, and all places that each of them has there."""
    finding = forge.Meeting(one + other, (0, 0, 0), (0, 0, 0))
    places = forge.places_at(finding, at)
    mine, yours = [p for p in places if p[0] < len(one)], [p for p in places if p[0] >= len(one)]
    finding.a, finding.b = yours[-1], mine[0]             # so A is not in the open domain
    return finding, mine, yours


def other_way(entity):
    """A patch of this image with its other side outside."""
    if entity["kind"] == "triangle":
        return list(all_permuted(entity))[1]
    return models.reversed_surface(entity)


def honest():
    """(name, Meeting)"""
    cube, third = models.cube(), (Q(1, 3), Q(3, 4))
    yield "a face twice", forge.Meeting(cube + cube[:1], (0, *third), (6, *third))
    yield "a face twice, turned", forge.Meeting(cube + [turned(cube[4], True, True, False)], (4, *HALF), (6, *HALF))
    yield "a rational patch twice", forge.Meeting(models.torus() + models.torus()[5:6], (16, *third), (5, *third))
    flat, bulged = models.tetrahedron(), models.cubic_octahedron()
    yield "a flat triangle twice", forge.Meeting(flat + flat[2:3], (2, *third), (4, *third))
    for n, twin in enumerate(all_permuted(bulged[3])):
        yield "a triangle twice, order %d" % n, forge.Meeting(bulged + [twin], (3, *CENTROID), (8, *CENTROID))
    yield "a point", forge.Meeting([one_point()], (0, *HALF), (0, *third))
    yield "a rational point", forge.Meeting([one_point(True)], (0, *HALF), (0, 0, Q(1, 5)))
    yield "a curve", forge.Meeting([one_curve()], (0, Q(2, 7), Q(1, 2)), (0, Q(2, 7), Q(1, 3)))
    yield "a pinched line", forge.Meeting([pinched()], (0, *HALF), (0, Q(1, 2), Q(1, 9)))
    yield "touching", forge.Meeting([plate(), bowl()], (0, Q(1, 3), Q(2, 5)), (1, Q(1, 3), Q(2, 5)))
    yield "touching with a border", forge.Meeting([plate(), wheel()], (0, Q(1, 3), Q(2, 5)), (1, Q(1, 3), 0))
    on_corner = [plate(), spike((Q(2, 3), Q(4, 5), 0))]
    yield "touching with a corner", forge.Meeting(on_corner, (0, Q(1, 3), Q(2, 5)), (1, 0, 0))
    yield "a crossing", forge.Meeting([loop()], (0, Q(1, 4), Q(1, 3)), (0, Q(3, 4), Q(1, 3)))
    yield "triangles", forge.Meeting(broken.pierced(), (0, Q(1, 2), Q(5, 12)), (1, 1, Q(2, 3)))
    yield "breaks", forge.Meeting([zigzag()], (2, *HALF), (0, *HALF))
