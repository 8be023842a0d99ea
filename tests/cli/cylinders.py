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


def revolved(profiles, place=lambda p: p):
    """Profiles, lists of (rho w, z w, w), each in four quarters around the z axis. They run counterclockwise, rho to the right."""
    entities = []
    for profile in profiles:
        c, s = 1, 0
        for _ in range(4):
            circle = [(c * x - s * y, s * x + c * y, w) for x, y, w in QUARTER]
            points = []
            for x, y, w in circle:
                for rho, z, v in profile:
                    weight = Q(w * v)
                    points.append((*(weight * k for k in place([rho * x / weight, rho * y / weight, z * w / weight])), weight))
            knots = [["0"] * 3 + ["1"] * 3, ["0"] * len(profile) + ["1"] * len(profile)]
            entities.append({"kind": "surface", "group": None, "attributes": [], "shape": {
                "degrees": [2, len(profile) - 1], "periodic": [False, False], "knots": knots, "rational": True, "components": 4,
                "points": [[str(k) for k in p] for p in points]}})
            c, s = -s, c
    return json.dumps({"format": "veritope-spline-1", "groups": [], "entities": entities})


def ball_with_neck(place=lambda p: p):
    """The ball of radius 5 around the origin and the cylinder of radius 3 around the z axis from 0 to 8, as one surface with poles at its ends."""
    return revolved([[(0, -10, 2), (5, -5, 1), (5, 0, 1)], [(5, 0, 1), (5, Q(5, 2), 1), (Q(15, 4), 5, Q(5, 4))],
                     [(3, 4, 1), (3, 8, 1)], [(3, 8, 1), (0, 8, 1)]], place)
