# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Writes bodies and certificates of patch-invalid-2, whatever they say: tests only. point() is the tests' own
evaluation of a patch."""
from fractions import Fraction as Q
from itertools import product
from math import comb

import patch_invalid_forge as first
import star_box_forge as forge

KINDS = {"surface": 1, "triangle": 2}


def number(t):
    """t: a rational, or (n, d)."""
    n, d = t if isinstance(t, tuple) else (Q(t).numerator, Q(t).denominator)
    return forge.varint(n) + forge.varint(d)


class Meeting(first.Finding):
    """a, b: (patch, first parameter, second one)."""
    claim, magic = "patch-invalid-2", b"VTI2"

    def __init__(self, entities, a, b, flags=None):
        super().__init__(entities, flags)
        self.a, self.b, self.kinds = a, b, [KINDS.get(e["kind"], 0) for e in entities]

    def marks(self):
        return bytes(x for pair in zip(self.kinds, self.flags) for x in pair)

    def found(self):
        return b"".join(forge.varint(patch) + number(u) + number(v) for patch, u, v in (self.a, self.b))

    def stated(self):
        return {"finding": "meeting"}


# ---------------------------------------------------------------- points of patches, in fractions

def rows_of(entity):
    """The control points of a Bezier patch in rows; a triangle has rows of 1, 2, ... points."""
    shape = entity["shape"]
    points = [tuple(map(Q, p)) for p in shape["points"]]
    if entity["kind"] == "triangle":
        return [points[r * (r + 1) // 2:(r + 1) * (r + 2) // 2] for r in range(shape["degree"] + 1)]
    n = shape["degrees"][1] + 1
    return [points[i:i + n] for i in range(0, len(points), n)]


def bernstein(n, i, t):
    return comb(n, i) * t ** i * (1 - t) ** (n - i)


def point(entity, u, v):
    """The exact point of a Bezier patch at (u, v), or of a triangle at (s, t)."""
    return point_of(rows_of(entity), entity["shape"]["rational"], u, v)


def point_of(rows, is_rational, u, v):
    total = [0] * len(rows[0][0])
    for r, row in enumerate(rows):
        for k, p in enumerate(row):
            # In a triangle (1-s)^i (s (1-t))^j (s t)^k has the factor n! / (i! j! k!), which is comb(n, r) comb(r, k).
            factor = bernstein(len(rows) - 1, r, Q(u)) * bernstein(len(row) - 1, k, Q(v))
            total = [x + factor * c for x, c in zip(total, p)]
    w = total[3] if is_rational else 1
    return tuple(c / w for c in total[:3])


def places(finding, along):
    """(place, point) for all patches of Bezier entities, whatever their breaks, at all pairs of these parameters."""
    first = 0
    for entity, axes in zip(finding.entities, finding.breaks):
        rows, is_rational = rows_of(entity), entity["shape"]["rational"]
        pieces = list(product(*[list(zip(axis, axis[1:])) for axis in axes or [[0, 1], [0, 1]]]))
        for n, ((a, b), (c, d)) in enumerate(pieces):
            for u, v in product(along, repeat=2):
                yield (first + n, u, v), point_of(rows, is_rational, a + (b - a) * u, c + (d - c) * v)
        first += len(pieces)


def places_at(finding, p, along=(0, Q(1, 4), Q(1, 3), Q(1, 2), Q(2, 3), Q(3, 4), 1)):
    return [place for place, q in places(finding, along) if q == tuple(p)]
