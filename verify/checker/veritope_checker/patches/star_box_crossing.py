# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The crossing number of the tested nodes of a star box (section 4 of star-box.md)."""
from ..common.errors import Reject
from . import star_box_work as work_of
from .star_box_patches import FULL, halves

MAX_HALVINGS = 64                       # of one curve

class Crossing:
    """The crossing number of the tested nodes of a star box; spend: called with the units of a curve that is halved."""

    def __init__(self, nodes, box, spend):
        self.box, self.spend = box, spend
        self.d = [b - a for a, b in zip(*box.c)]
        self.k = max(range(3), key=lambda k: (abs(self.d[k]), -k))
        # line: (from, to, direction, curve, units of a half) of each side of a node on it
        self.lines = {}
        for node in nodes:
            for s in range(node.patch.num_sides):
                self.add_side(node, s)

    def add_side(self, node, s):
        patch = node.patch
        side, e, value = node.line(s)
        a, b = [end[1 - e if patch.is_tensor else (e + 2) % 3] for end in node.ends(s)]
        curve, direction = self.project(patch.side(s, node.net)), -1 if patch.flag else 1
        if a > b:
            a, b, curve, direction = b, a, [c[::-1] for c in curve], -direction
        line = patch, e, value
        if side is not None:
            if patch.sides[side] is None:
                return
            line, is_first = patch.sides[side]
            # the first of the two sides rises along the edge, the other falls
            if (direction < 0) == is_first:
                a, b, curve = FULL - b, FULL - a, [c[::-1] for c in curve]
            direction = 1 if is_first else -1
        self.lines.setdefault(line, []).append((a, b, direction, curve, work_of.of_half_curve(node)))

    def project(self, points):
        k, d, c = self.k, self.d, self.box.c[0]
        def coordinate(i):
            return [(p[i] - p[3] * c[i]) * d[k] - (p[k] - p[3] * c[k]) * d[i] for p in points]
        return [coordinate((k + 1) % 3), coordinate((k + 2) % 3)]

    def number(self):
        total = 0
        for sides in self.lines.values():
            steps, multiplicity = {}, 0
            for a, b, direction, _, _ in sides:
                steps[a] = steps.get(a, 0) + direction
                steps[b] = steps.get(b, 0) - direction
            places = sorted(steps)
            for a, b in zip(places, places[1:]):
                multiplicity += steps[a]
                if multiplicity:
                    side = next(side for side in sides if side[0] <= a and b <= side[1])
                    total += multiplicity * self.part(side, a, b)
        return total if self.d[self.k] > 0 else -total

    def part(self, side, a, b):
        """The winding number of the part [a, b] of a side."""
        stack, total, units = [(side[0], side[1], *side[3])], 0, side[4]
        while stack:
            lo, hi, xs, ys = stack.pop()
            if a <= lo and hi <= b:
                total += self.of_curve(xs, ys, units)
            elif a < hi and lo < b:
                self.spend(units)
                mid = (lo + hi) // 2
                (x0, x1), (y0, y1) = halves(xs), halves(ys)
                stack += (lo, mid, x0, y0), (mid, hi, x1, y1)
        return total

    def of_curve(self, xs, ys, units=1):
        stack, total = [(0, xs, ys)], 0
        while stack:
            level, xs, ys = stack.pop()
            if min(ys) >= 0 or max(ys) < 0 or max(xs) <= 0:
                continue
            if min(xs) >= 0:
                total += (ys[-1] >= 0) - (ys[0] >= 0)
                continue
            self.spend(units)
            if level == MAX_HALVINGS:
                raise Reject("C3", "a boundary curve comes too close to the line through the centres")
            (x0, x1), (y0, y1) = halves(xs), halves(ys)
            stack += (level + 1, x0, y0), (level + 1, x1, y1)
        return total
