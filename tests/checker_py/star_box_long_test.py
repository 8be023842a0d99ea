#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Star-box certificates of both versions with a centre exactly in the plane of a face whose normal needs more than 64 bits. A checker may look
at the highest bits first; this near to a plane they decide nothing, and a checker that trusts them takes the wrong side for half of the faces."""
import copy
import random
import unittest
from fractions import Fraction as Q

import star_box_forge as forge
import star_box_models as models
from star_box_2_judged import SCALE, Box2, Judged, Prover2

FINE = Q(1, 1 << 40)
UNIT = Q(1, 1 << 20)                                      # of the forge


class LongTetrahedron:
    """The faces (a, b, d) and (b, a, e) meet at a convex edge, which the box crosses. c+ of the box lies exactly in the plane of (a, b, d),
    beyond the edge. The corners are multiples of 2^-44, so the normal of a face has some 90 bits."""

    def __init__(self, rng):
        mirror = [rng.choice((-1, 1)) for _ in range(3)]
        axes = rng.sample(range(3), 3)

        def turned(x, y, z):
            point = (x, y, z)
            return [mirror[k] * point[axes[k]] for k in range(3)]

        def noisy(x, y, z):
            return [c + rng.randrange(1 << 34) * FINE for c in turned(x, y, z)]

        self.plus = [rng.randrange(-64 << 20, 64 << 20) * UNIT for _ in range(3)]
        to_d, along, to_e = noisy(8, 0, 0), noisy(0, 4, 0), noisy(2, 0, -6)
        a, b, d, e = [[c + s * x + t * y + r * z for c, x, y, z in zip(self.plus, to_d, along, to_e)]
                      for s, t, r in ((Q(1, 16), -1, 0), (Q(1, 16), 1, 0), (1, 0, 0), (Q(1, 16), 0, 1))]
        is_mirrored = (mirror.count(-1) + sum(axes[i] > axes[j] for i in range(3) for j in range(i + 1, 3))) % 2
        corners = [b, a, d, e] if is_mirrored else [a, b, d, e]
        self.entities = models.triangles([tuple(p) for p in corners], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])
        self.minus = [c + x for c, x in zip(self.plus, turned(Q(3, 2), 0, -1))]
        self.up, self.middle = turned(0, 0, 1), [(x + y) / 2 for x, y in zip(a, b)]
        ends = [[c + x for c, x in zip(self.plus, turned(*p))] for p in ((-Q(1, 2), -1, -Q(3, 2)), (2, 1, Q(1, 2)))]
        self.lo, self.hi = [[pick(pair) for pair in zip(*ends)] for pick in (min, max)]

    def box(self, units_up):
        """Its c+ lies so many units of the forge above the plane's point."""
        minus, plus, lo, hi = [[int(x / UNIT) for x in p] for p in (self.minus, self.plus, self.lo, self.hi)]
        return Box2(0, lo, hi, [(minus, [c + units_up * u for c, u in zip(plus, self.up)])])


class AroundThePoint(Prover2):
    """Nodes that contain the point are split until they lie in the given box."""

    def star_box(self, node):
        lo, hi = node.hull()
        contains = all(n * UNIT <= x * d and x * e <= m * UNIT for (n, d), (m, e), x in zip(lo, hi, self.point))
        return None if contains else super().star_box(node)


def proved(tetrahedron):
    """The proof, and the number of the box beside the edge."""
    prover = AroundThePoint(tetrahedron.entities, [tetrahedron.box(1)], search=True)
    prover.point = tetrahedron.middle
    plan = prover.prove().plan
    return prover, next(i for i, box in enumerate(plan.boxes) if box.centres == tetrahedron.box(1).centres)


def in_version_1(plan):
    """The plan of version 2, whose boxes have one sheet each, as one of version 1."""
    result = forge.Plan(plan.entities, plan.unit)
    for name in ("flags", "breaks", "roots", "trees", "walks"):
        setattr(result, name, getattr(plan, name))
    result.values = {key: value for key, value in plan.values.items() if key != "claim"}
    for box in plan.boxes:
        (minus, plus), = box.centres
        result.boxes.append(forge.Box(0, box.lo, [h - l for l, h in zip(box.lo, box.hi)], *[[c - l for c, l in zip(p, box.lo)] for p in (minus, plus)]))
    return result


class LongNumbers(Judged):
    def judged(self, expected, prover, plan):
        self.says(expected, prover, plan)
        first = in_version_1(plan)
        self.says(expected, prover, first, claim="star-box-1")

    def test_a_centre_exactly_in_the_plane_of_a_face(self):
        for seed in range(4 * SCALE):
            tetrahedron = LongTetrahedron(random.Random(seed))
            with self.subTest(seed=seed):
                prover, box = proved(tetrahedron)
                self.judged("ACCEPT", prover, prover.plan)
                for up in (0, -1):
                    plan = copy.deepcopy(prover.plan)
                    plan.boxes[box].centres[0][1] = tetrahedron.box(up).centres[0][1]
                    self.judged("C2", prover, plan)


if __name__ == "__main__":
    unittest.main()
