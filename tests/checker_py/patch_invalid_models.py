# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Small models for patch_invalid_test.py: broken ones, known by construction, and parts of closed ones."""
from fractions import Fraction as Q

import star_box_forge as forge
import star_box_models as models


def sheet(corner, u, v, count=(1, 1)):
    """A flat surface with inner knots."""
    rows = [[tuple(c + Q(i, count[0]) * a + Q(j, count[1]) * b for c, a, b in zip(corner, u, v)) for j in range(count[1] + 1)]
            for i in range(count[0] + 1)]
    return forge.surface(rows, (1, 1), [[0, *range(n + 1), n] for n in count])


def open_loop():
    """One patch that crosses itself in a line: a plane curve with a loop, extruded along z."""
    xs, ys = (-1, 4, -4, 1), (0, 3, 3, 0)
    return forge.surface([[(x + Q(z, 9), y, z) for z in (0, 1)] for x, y in zip(xs, ys)])


def cylinder_wall():
    """Four rational patches around z, open at both ends."""
    return [forge.surface([[(x, y, z * w, w) for z in (0, 2)] for x, y, w in models.arc(i)], rational=True) for i in range(4)]


def pierced():
    """Two triangles; that from (1, 1, 2) to (3, 2, -1) ends inside the other one."""
    return [forge.triangle([(0, 0, 0), (8, 0, 0), (0, 8, 0)]), forge.triangle([(1, 1, -1), (1, 1, 2), (3, 2, -1)])]


def polygon_torus():
    """One entity of 4 x 4 flat patches that closes on itself on both axes; its seams are borders of its domain."""
    ring = [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 0)]
    rows = [[((3 + c) * x, (3 + c) * y, s) for c, s in ring] for x, y in ring]
    return [forge.surface(rows, (1, 1), [[0, *range(5), 4]] * 2)]


def drop():
    """A closed cubic loop, extruded: the ends of one patch are one curve."""
    return [forge.surface([[(x, y, z) for z in (0, 1)] for x, y in ((0, 0), (3, 3), (-3, 3), (0, 0))])]
