# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The slices of bridges and their boxes (docs/certificates/microstructure.md, section 7): R3 and R4."""
from bisect import bisect_left, bisect_right
from fractions import Fraction
from itertools import product
from math import inf, nextafter

from ..common.errors import Reject
from ..patches.model_powers import scaled
from ..points.box_tree import BoxTree
from .inside_nodes import nearest

FREE_BOXES, BOXES_OF_BRIDGE, FREE_PAIRS, PAIRS_OF_BRIDGE = 1 << 20, 64, 1 << 26, 1024
CELLS_OF_UNIT = 64                                          # cells of a row that are looked at in one go

def boxes_of_slices(bridge, cuts):
    """(lower corner, upper corner) of each slice."""
    numbers, common = scaled([c for point in bridge.points for c in point])
    lists = [[numbers[3 * k + c::9] for k in range(3)] for c in range(3)]       # for each coordinate
    hulls = {}

    def hull(s, t):
        """The hull of the blossoms at s and t: coefficients on a slice that begins or ends there."""
        a, b, d, e = s.numerator, t.numerator, s.denominator, t.denominator
        first, second, third = (d - a) * (e - b), a * (e - b) + b * (d - a), a * b
        found = []
        for x, y, z in lists:
            values = [first * p + second * q + third * r for p, q, r in zip(x, y, z)]
            found.append([Fraction(f(values), d * e * common) for f in (min, max)])
        return found

    places, boxes = [Fraction(0), *cuts, Fraction(1)], []
    for s, t in zip(places, places[1:]):
        for u in (s, t):
            hulls.setdefault(u, None)
            hulls[u] = hulls[u] or hull(u, u)
        boxes.append(hull_of(hulls.pop(s), hull(s, t), hulls[t]))
    return boxes

def hull_of(*boxes):
    """The least box that contains these; a box is [(least, greatest) of each coordinate]."""
    return [(min(lo for lo, _ in of_axis), max(hi for _, hi in of_axis)) for of_axis in zip(*boxes)]

def are_apart(box, other):
    return any(a > d or b < c for (a, b), (c, d) in zip(box, other))

def outward(box):
    """In binary64, rounded outward: (least x, greatest x, least y, ...)"""
    return tuple(nextafter(nearest(c), -inf if end == 0 else inf) for of_axis in box for end, c in enumerate(of_axis))

class Slices:
    def __init__(self, model):
        self.model, self.boxes, self.pairs, self.of_grids = model, [], 0, {}
        self.num_boxes, self.most_boxes = 0, FREE_BOXES + BOXES_OF_BRIDGE * len(model.bridges)
        self.most_pairs = FREE_PAIRS + PAIRS_OF_BRIDGE * len(model.bridges)
        for grid in model.grids:
            self.of_grids.setdefault(grid.volume, []).append(grid)
        self.trees = {volume: BoxTree([outward([(b[0], b[-1]) for b in grid.breaks]) for grid in grids])
                      for volume, grids in self.of_grids.items()}

    def add(self, bridge, cuts):
        self.num_boxes += len(cuts) + 1
        if self.num_boxes > self.most_boxes:
            raise Reject("R3", "bridges have more than %d slices" % self.most_boxes)
        self.boxes.append(boxes_of_slices(bridge, cuts))

    def see(self, condition, pairs):
        self.pairs += pairs
        if self.pairs > self.most_pairs:
            raise Reject(condition, "more than %d pairs of slices and what may be near them" % self.most_pairs)

    # ------------------------------------------------------------ R3

    def test_r3(self, bridge, side):
        """Tests the bridge that was added last.  side: OtherSide, or None where R2 is not tested."""
        knots = self.model.cage[bridge.volume].knots
        for k in (1, 2):
            for point in bridge.of_list(k):
                if not all(t[0] < c < t[-1] for c, t in zip(point, knots)):
                    raise Reject("R3", "a point of list %d is not inside of the volume's parameters" % k)
                if side and (point[side.axis] - side.at) * side.beyond <= 0:
                    raise Reject("R3", "a point of list %d is not beyond the wall" % k)
        own = side and not side.in_face and (self.model.grids[bridge.grid], bridge.cell)
        for n, box in enumerate(self.boxes[-1]):
            for grid in self.grids_near(bridge.volume, box):
                for cell in self.cells_near(grid, box):
                    if not (n == 0 and own and own[0] is grid and own[1] == cell):
                        raise Reject("R3", "slice %d meets cell %d of a grid, which holds a tile" % (n, cell))

    def grids_near(self, volume, box):
        if volume in self.trees:
            for n in self.trees[volume].meeting(outward(box)):
                yield self.of_grids[volume][n]

    def cells_near(self, grid, box):
        """The cells that hold a tile and have a point in common with the box."""
        ranges = []
        for breaks, (lo, hi) in zip(grid.breaks, box):
            first = max(0, bisect_left(breaks, lo) - 1)
            ranges.append(range(first, min(len(breaks) - 1, bisect_right(breaks, hi))))
        along = ranges[2]
        self.see("R3", len(ranges[0]) * len(ranges[1]) * (1 + len(along) // CELLS_OF_UNIT))
        for i, j in product(*ranges[:2]) if along else ():
            start = (i * grid.counts[1] + j) * grid.counts[2] + along[0]
            row = grid.cells[start:start + len(along)]
            if any(row):
                yield from (start + k for k, held in enumerate(row) if held)

    # ------------------------------------------------------------ R4

    def test_r4(self):
        volumes = {}
        for n, bridge in enumerate(self.model.bridges):
            volumes.setdefault(bridge.volume, []).append(n)
        for numbers in volumes.values():
            hulls = [hull_of(*self.boxes[n]) for n in numbers]
            rounded = [outward(hull) for hull in hulls]
            tree = BoxTree(rounded)
            for i, n in enumerate(numbers):
                for j in tree.meeting(rounded[i], lambda: self.see("R4", 1)):
                    if j < i and not are_apart(hulls[i], hulls[j]):
                        self.test_pair(n, numbers[j])

    def test_pair(self, n, m):
        for box in self.boxes[n]:
            self.see("R4", len(self.boxes[m]))
            if not all(are_apart(box, other) for other in self.boxes[m]):
                raise Reject("R4", "slices of bridges %d and %d meet" % (m, n))
