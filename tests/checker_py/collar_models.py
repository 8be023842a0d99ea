# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Cells and surfaces for collar_test.py: shells of cubes, the referees' traps. Cells are (x, y, z, size) in units of the model."""
from fractions import Fraction as Q

import star_box_forge as forge
import star_box_models as models


def shell(outer, inner, size=4):
    """The cells of a grid in the box `outer` (lo, hi) that are not in the box `inner`."""
    (lo, hi), (a, b) = outer, inner
    return [(x, y, z, size) for x in range(lo[0], hi[0], size) for y in range(lo[1], hi[1], size) for z in range(lo[2], hi[2], size)
            if not all(l <= c < h for c, l, h in zip((x, y, z), a, b))]


def cube_shell(lo, hi, a, b, size=4):
    return shell(((lo,) * 3, (hi,) * 3), ((a,) * 3, (b,) * 3), size)


def brick(lo, hi, turned=False):
    """Six bilinear patches around a box."""
    middle, half = [Q(a + b) / 2 for a, b in zip(lo, hi)], [Q(b - a) / 2 for a, b in zip(lo, hi)]
    faces = [forge.surface([[tuple(m + h * c for m, h, c in zip(middle, half, at(u, v))) for v in (-1, 1)] for u in (-1, 1)])
             for at in models.cube_faces()]
    return [models.reversed_surface(f) for f in faces] if turned else faces


def on_lattice(cells, *lines):
    """The boundary of cubes of a lattice, whose planes are moved: lines[axis][i] is where plane i goes."""
    out = []
    for entity in models.snake(cells):
        points = [tuple(lines[k][int(c)] for k, c in enumerate(p)) for p in entity["shape"]["points"]]
        out.append(forge.triangle(points))
    return out


RING = [(x, y, 0) for x in range(3) for y in range(3) if (x, y) != (1, 1)]


def ring(xs, ys, zs):
    """A frame around the hole [xs[1], xs[2]] x [ys[1], ys[2]]."""
    return on_lattice(RING, xs, ys, zs)


def cube_with_a_handle():
    """[-8, 8]^3 and an ear of half a unit on it."""
    cells = [(x, y, 0) for x in range(3) for y in range(3)] + [(0, 1, 1), (2, 1, 1), (0, 1, 2), (1, 1, 2), (2, 1, 2)]
    lines = (-8, Q(-1, 2), Q(1, 2), 8)
    return on_lattice(cells, lines, lines, (-8, 8, Q(17, 2), 9))


# ---------------------------------------------------------------- a torus collar with a knot around its core (referee-2, 2.6)

OUTER, HOLE = ((-28, -6, -8), (36, 52, 8)), ((-14, 18, -8), (-6, 38, 8))
KNOTTED = ((0, 12, 0), (0, 12, 2), (16, 12, 2), (16, 12, -2), (30, 12, -2), (30, 12, 2), (30, 24, 2), (12, 24, 2), (12, 24, -2), (12, 0, -2),
           (12, 0, 2), (21, 0, 2), (21, 18, 2), (21, 18, -2), (21, 44, -2), (-20, 44, -2), (-20, 12, -2), (0, 12, -2), (0, 12, 0))


# the strands y = 24 and x = 21 with their heights exchanged where they cross
UNKNOTTED = ((0, 12, 0), (0, 12, 2), (16, 12, 2), (16, 12, -2), (30, 12, -2), (30, 24, -2), (12, 24, -2), (12, 0, -2), (12, 0, 2), (21, 0, 2),
             (21, 44, 2), (-20, 44, 2), (-20, 12, 2), (-20, 12, -2), (0, 12, -2), (0, 12, 0))


def knot_collar(path):
    """A block with a hole, less a tube along a closed path: the region between two tori."""
    tube = set()
    for p, q in zip(path, path[1:]):
        step = [(b > a) - (a > b) for a, b in zip(p, q)]
        while p != q:
            tube.add(p)
            p = tuple(a + s for a, s in zip(p, step))
    return [(*p, 1) for *p, _ in map(tuple, shell(OUTER, HOLE, 1)) if tuple(p) not in tube]


def torus_in_knot_collar():
    """Half a unit inside the outer boundary."""
    h = Q(1, 2)
    return ring((-28 + h, -14 - h, -6 + h, 36 - h), (-6 + h, 18 - h, 38 + h, 52 - h), (-8 + h, 8 - h))
