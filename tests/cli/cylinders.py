# SPDX-License-Identifier: LGPL-3.0-or-later
"""Cylinders and cones as spline models, whose ends are discs of patches with a side that is collapsed to the disc's centre."""
import json
from fractions import Fraction as Q

# Arcs of the unit circle from (1, 0): x, y and the weight. Copies of them make the circle: an arc's last point is the start of the next one.
QUARTER = ((1, 0, 1), (1, 1, 1), (0, 2, 2))
HALF = ((3, 0, 3), (1, 2, 1), (-1, 2, 1), (-3, 0, 3))


def cylinder(x, low, high, arc=QUARTER, radius=1, top=None, turn=(1, 0), place=lambda p: p):
    """Around the line of the points (x, 0, z). top: the upper radius, if it is another one; 0: a cone. turn: the direction in which the first arc
    starts, of length 1. place: an affine map."""
    entities, top = [], radius if top is None else top
    a, b = arc[-1][0] / Q(arc[-1][2]), arc[-1][1] / Q(arc[-1][2])
    c, s = turn
    for _ in range(4 if arc is QUARTER else 2):
        rim = {z: [(r * (c * p - s * q) + x * w, r * (s * p + c * q), w * z, w) for p, q, w in arc] for z, r in ((low, radius), (high, top))}
        axis = {z: [(x * w, 0, w * z, w) for _, _, w in arc] for z in (low, high)}
        for rows in [(rim[low], rim[high]), (axis[low], rim[low])] + [(rim[high], axis[high])] * (top != 0):
            points = [(*(w * k for k in place([Q(k) / w for k in (p, q, z)])), w) for row in zip(*rows) for p, q, z, w in row]
            entities.append({"kind": "surface", "group": None, "attributes": [], "shape": {
                "degrees": [len(arc) - 1, 1], "periodic": [False, False], "knots": [["0"] * len(arc) + ["1"] * len(arc), ["0", "0", "1", "1"]],
                "rational": True, "components": 4, "points": [[str(k) for k in p] for p in points]}})
        c, s = a * c - b * s, b * c + a * s
    return json.dumps({"format": "veritope-spline-1", "groups": [], "entities": entities})
