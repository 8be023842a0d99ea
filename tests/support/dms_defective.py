# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Simplex-spline solids with one defect each, by the finding of their certificate."""
import json
from fractions import Fraction as Q

import dms_files as files


def identity(degree, points, tetrahedra, clouds=None):
    return files.model(degree, clouds or [[[Q(c) for c in p]] for p in points], tetrahedra)


def grid(degree=2, counts=(1, 1, 1), warp=lambda p: p, clouds=()):
    points, tetrahedra = files.grid_domain(counts)
    all_clouds = [[p] for p in points]
    for place, knots in clouds:
        all_clouds[points.index([Q(c) for c in place])] += [[Q(c) for c in knot] for knot in knots]
    return files.model(degree, all_clouds, tetrahedra, warp)


CORNER = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))


def bent(p):
    """Two turns of a bar along z, in eight steps: too much."""
    x, y, z = p
    turns = ((1, 0), (Q(7, 10), Q(7, 10)), (0, 1), (Q(-7, 10), Q(7, 10)), (-1, 0), (Q(-7, 10), Q(-7, 10)), (0, -1), (Q(7, 10), Q(-7, 10)))
    low = int(z // 1)
    (a, b), (c, d) = turns[low % 8], turns[(low + 1) % 8]
    part = z - low
    r = 2 + x + z / 60
    return [r * (a + part * (c - a)), y + z / 100, r * (b + part * (d - b))]


def one_in_the_other():
    """Two cubes; the image of the second is inside of that of the first. Both maps are curved."""
    points, tetrahedra = files.grid_domain((1, 1, 1))
    def warp(p):
        x, y, z = p
        if x < 2:
            return [x + y * z / 5, y - x * x / 7, z + x * y / 9]
        x -= 3
        return [Q(2, 5) + x / 5 + y * y / 40, Q(1, 3) + y / 6 - x * z / 50, Q(3, 7) + z / 5 + x * x / 60]
    both = [*points, *([x + 3, y, z] for x, y, z in points)]
    return files.model(2, [[p] for p in both], tetrahedra + [[v + len(points) for v in t] for t in tetrahedra], warp)


def defective():
    """finding: bytes of a model"""
    e = Q(1, 2**40)
    wedge_rim = ((1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1))
    wedge = [(0, 0, -1), (0, 0, 1)] + [(x, y, 0) for x, y in wedge_rim]
    wound = json.loads(identity(1, wedge, [[0, 1, 2 + i, 2 + (i + 1) % 8] for i in range(8)]))
    for i in range(8):
        x, y = wedge_rim[2 * i % 8]
        wound["control"][2 + i]["value"] = [str(x), str(y), "0"]
    return {
        "tet-reversed": identity(1, CORNER, [[1, 0, 2, 3]]),
        "tet-face-overused": identity(1, (*CORNER, (1, 1, 1)), [[0, 1, 2, 3], [0, 1, 2, 4]]),
        "cloud-degenerate": grid(2, (2, 2, 2), clouds=[((1, 1, 1), [(2 + e, 1, 1)])]),
        "cloud-no-core": grid(2, (3, 2, 2), clouds=[((1, 1, 1), [(Q(3, 2) + e, 1, 1)]), ((2, 1, 1), [(Q(3, 2), 1, 1)])]),
        "cloud-inside": grid(2, clouds=[((0, 0, 0), [(e, e, e / 2)])]),
        "jacobian": grid(2, (2, 2, 2), lambda p: [p[0] * (3 - p[0]), p[1], p[2]], [((1, 1, 1), [(Q(21, 20), 1, Q(19, 20))])]),
        "jacobian-zero": grid(2, warp=lambda p: [p[0], p[1], p[0] + p[1]]),
        "M4": identity(1, ((0, 0, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)), [[0, 2, 3, 1], [0, 4, 5, 1]]),
        "M6": identity(1, (*CORNER, (-1, 0, 0), (0, -1, 0), (0, 0, -1)), [[0, 1, 2, 3], [0, 5, 4, 6]]),
        "M7": identity(1, (*(tuple(3 * c for c in p) for p in CORNER), (1, 1, -3), (3, 0, -3), (0, 3, -3), (1, 1, 1)),
                       [[0, 1, 2, 3], [4, 5, 6, 7]]),
        "M9": identity(1, (*(tuple(9 * c for c in p) for p in CORNER), *(tuple(1 + c for c in p) for p in CORNER)),
                       [[0, 1, 2, 3], [4, 5, 6, 7]]),
        "meeting": json.dumps(wound).encode(),
        "crossing": files.model(2, [[p] for p in files.grid_domain((1, 1, 10))[0]], files.grid_domain((1, 1, 10))[1], bent),
        "covering": one_in_the_other(),
    }
