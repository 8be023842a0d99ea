# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The surface of a tile (docs/certificates/microstructure.md, sections 3 to 5): S0, F1, F2, T2 and T3; F3 is in
micro_tile_boxes.py."""
from collections import Counter
from fractions import Fraction
from math import lcm

from ..common.errors import Reject
from ..patches.star_box_patches import Groups, half_of_tensor
from .micro_body import Star
from .micro_tile_boxes import test_boxes
from .micro_polynomials import Winding, at_number, curve_key, in_bernstein

MAX_VISITED, MAX_LEVEL = 1 << 16, 40

class Patch:
    """lists: in integers, over `unit`; coefficients: lists of points, one for each index in t, over `common`.
    sides[s]: None if it is collapsed, else (patch, side) of the one that it is paired with, or () without a partner."""

    def __init__(self, patch, extent):
        self.wall, self.degrees = patch.wall, patch.degrees
        self.unit = lcm(*[c.denominator for points in patch.lists for point in points for c in point])
        self.lists = [[[c.numerator * (self.unit // c.denominator) for c in point] for point in points]
                      for points in patch.lists]
        self.coefficients, common = in_bernstein(self.lists, extent)
        self.common = self.unit * common
        self.sides = [None if self.is_collapsed(s) else () for s in range(4)]
        p, q = self.degrees
        self.corners = [0, p * (q + 1), p * (q + 1) + q, q]

    def along(self, side):
        """The numbers of the side's control points, in its direction."""
        p, q = self.degrees
        return (range(0, (p + 1) * (q + 1), q + 1), range(p * (q + 1), (p + 1) * (q + 1)),
                range(p * (q + 1) + q, -1, -q - 1), range(q, -1, -1))[side]

    def curve(self, side, reverse=False):
        """The side's lists."""
        return [[points[n] for n in self.along(side)[::-1 if reverse else 1]] for points in self.lists]

    def key(self, side, reverse=False):
        return curve_key(self.wall, self.curve(side, reverse), self.unit)

    def at_number(self, number):
        """The points for one number of its wall."""
        points, common = at_number(self.lists, number)
        return [[Fraction(c, common * self.unit) for c in point] for point in points]

    def is_collapsed(self, side):
        return all(point == points[0] for points in self.curve(side) for point in points)

    def height(self, wall):
        """h over the wall times `common`: lists of numbers, one for each index in t."""
        axis, end = wall // 2, wall % 2
        return [[self.common - point[axis] if end else point[axis] for point in points] for points in self.coefficients]

class Tile:
    """vertex: the class of corner c of patch n at 4 n + c.  edges: pairs of sides (patch, side), the second one () if a
    side has no partner.  in_wall: for each wall the numbers of its patches.  caps: (wall, patches).  cap_of: {patch:
    number of its cap}."""

    def __init__(self, extent, patches, proof, skip):
        """proof: of micro_body.py."""
        self.extent, self.proof, self.skip = extent, proof, skip
        self.patches = [Patch(patch, extent) for patch in patches]

    def fail(self, condition, why, part=None):
        """part: a name for a part of the condition."""
        if condition not in self.skip and part not in self.skip:
            raise Reject(condition, why)

    def test(self, statement):
        """statement: of the certificate, whose model's size bounds the work of star boxes."""
        self.pair_sides()
        self.make_vertices()
        if type(self.proof) is Star:
            for n, patch in enumerate(self.patches):
                self.test_f1(n, patch)
            self.test_f2(self.proof.centre, self.proof.exit)
        else:
            test_boxes(self, self.proof.data, statement)
        self.find_caps()
        for wall in range(6):
            vertices = {self.vertex[4 * n + c] for n in self.in_wall[wall] for c in range(4)}
            for n, patch in enumerate(self.patches):
                self.test_t2(wall, vertices, n, patch)
        for wall in range(6):
            self.test_t3(wall)

    # ------------------------------------------------------------ section 3

    def pair_sides(self):
        """S0."""
        places, opposite = {}, {}
        for n, patch in enumerate(self.patches):
            for s in range(4):
                if patch.sides[s] is not None:
                    places.setdefault(patch.key(s), []).append((n, s))
                    opposite[n, s] = patch.key(s, True)
        self.edges = []
        for key, sides in places.items():
            back = opposite[sides[0]]
            others = places.get(back, [])
            if len(sides) != 1 or len(others) != 1 or key == back:
                self.fail("S0", "side %d of patch %d has %d opposite and %d equal sides" % (
                    sides[0][1], sides[0][0], len(others), len(sides) - 1))
            for one, other in zip(sides, others if key != back else []):
                if one < other:
                    self.set_side(one, other)
                    self.set_side(other, one)
                    self.edges.append((one, other))
        self.edges += [((n, s), ()) for n, patch in enumerate(self.patches) for s in range(4) if patch.sides[s] == ()]

    def set_side(self, one, other):
        self.patches[one[0]].sides[one[1]] = other

    def make_vertices(self):
        corners = Groups(4 * len(self.patches))
        for n, patch in enumerate(self.patches):
            for s, other in enumerate(patch.sides):
                start, end = 4 * n + s, 4 * n + (s + 1) % 4
                if other is None:
                    corners.unite(start, end)
                elif other:
                    m, t = other
                    corners.unite(start, 4 * m + (t + 1) % 4)
                    corners.unite(end, 4 * m + t)
        self.vertex = corners.number()

    # ------------------------------------------------------------ section 4

    def test_f1(self, n, patch):
        left_out = [side is None for side in patch.sides]
        if any(left_out[s] and left_out[(s + 1) % 4] for s in range(4)):
            self.fail("F1", "two collapsed sides of patch %d share a corner" % n)
        winding = Winding(patch.coefficients, patch.common, patch.degrees, self.proof.centre)
        p, q, _ = winding.of_g
        for (i, j, k), c in winding.coefficients().items():
            on = j == 0, i == p - 1, j == q - 1, i == 0
            if c <= 0 and not any(out and is_on for out, is_on in zip(left_out, on)):
                self.fail("F1", "the coefficient %d, %d, %d of G of patch %d is not positive" % (i, j, k, n))

    def test_f2(self, centre, exit):
        lo, patch = (self.extent or (0, 0))[0], self.patches[exit]
        points = patch.at_number(lo)
        middle = [sum(column) / 4 for column in zip(*points)]
        apart = [axis for axis in range(3) if middle[axis] != centre[axis]]
        if patch.degrees != (1, 1) or any(a - b - c + d for a, b, c, d in zip(*points)):
            self.fail("F2", "patch %d is no parallelogram" % exit)
        if len(apart) != 1:
            self.fail("F2", "the middle of patch %d is not across from the centre" % exit)
        end = list(centre)
        for axis in apart:                                  # the wall beyond the middle
            end[axis] = Fraction(0 if middle[axis] < end[axis] else 1)
        visited = [0]
        for n, other in enumerate(self.patches):
            if n != exit and not is_missed(other.at_number(lo), other.degrees, centre, end, visited):
                self.fail("F2", "patch %d may meet the segment from the centre" % n)

    # ------------------------------------------------------------ section 5

    def find_caps(self):
        self.in_wall = [{n for n, patch in enumerate(self.patches) if not any(map(any, patch.height(wall)))}
                        for wall in range(6)]
        self.caps, self.cap_of = [], {}
        for wall, inside in enumerate(self.in_wall):
            groups = Groups(len(self.patches))
            for n in inside:
                for other in self.patches[n].sides:
                    if other and other[0] in inside:
                        groups.unite(n, other[0])
            for cap in sorted({groups.find(n) for n in inside}):
                self.caps.append((wall, sorted(n for n in inside if groups.find(n) == cap)))
        for number, (_, patches) in enumerate(self.caps):
            self.cap_of.update((n, number) for n in patches)

    def test_t2(self, wall, vertices, n, patch):
        heights = patch.height(wall)
        if n in self.in_wall[wall]:
            for other in range(6):
                if other // 2 != wall // 2 and min(map(min, patch.height(other))) <= 0:
                    self.fail("T2", "patch %d in wall %d reaches wall %d" % (n, wall, other), "T2 cap")
            return
        for h in heights:
            if min(h) < 0 or max(h) <= 0:
                self.fail("T2", "patch %d leaves the cube through wall %d, or lies in it" % (n, wall), "T2 body")
            for s, other in enumerate(patch.sides):
                if other is not None and not (other and other[0] in self.in_wall[wall]):
                    if max(h[m] for m in patch.along(s)) <= 0:
                        self.fail("T2", "side %d of patch %d may lie in wall %d" % (s, n, wall), "T2 side")
            for c, m in enumerate(patch.corners):
                if self.vertex[4 * n + c] not in vertices and h[m] <= 0:
                    self.fail("T2", "corner %d of patch %d may lie in wall %d" % (c, n, wall), "T2 corner")

    def test_t3(self, wall):
        ends, inside = Counter(), self.in_wall[wall]
        for one, other in self.edges:
            if other and (one[0] in inside) != (other[0] in inside):
                for c in (one[1], (one[1] + 1) % 4):
                    ends[self.vertex[4 * one[0] + c]] += 1
        if max(ends.values(), default=0) > 2:
            self.fail("T3", "the patches of wall %d are not one run at a vertex" % wall)

    # ------------------------------------------------------------ section 8

    def chi(self, patches=None):
        """V - E + F of the surface, or of these patches with all their sides and corners."""
        chosen = set(range(len(self.patches)) if patches is None else patches)
        edges = sum(one[0] in chosen or bool(other) and other[0] in chosen for one, other in self.edges)
        return len({self.vertex[4 * n + c] for n in chosen for c in range(4)}) - edges + len(chosen)

    def pieces(self, mask):
        """For each patch the number of its class among those that are in no cap of the mask; and the number of
        classes."""
        kept = {n for n in range(len(self.patches)) if not mask >> self.cap_of.get(n, len(self.caps)) & 1}
        groups, numbers = Groups(len(self.patches)), {}
        for one, other in self.edges:
            if other and one[0] in kept and other[0] in kept:
                groups.unite(one[0], other[0])
        return {n: numbers.setdefault(groups.find(n), len(numbers)) for n in sorted(kept)}, len(numbers)

def is_missed(points, degrees, start, end, visited):
    """Does the descent of F2 end? The segment is parallel to an axis, or F2 has failed. visited: [nodes of the tile]"""
    common = lcm(*[c.denominator for p in [*points, start, end] for c in p])
    width = degrees[1] + 1
    rows = [[[int(p[c] * common) for p in points[i:i + width]] for i in range(0, len(points), width)] for c in range(3)]
    low, high = [[int(f(pair) * common) for pair in zip(start, end)] for f in (min, max)]
    nodes = [(rows, 0, 0)]
    while nodes:
        arrays, shift, level = nodes.pop()
        visited[0] += 1
        if visited[0] > MAX_VISITED:
            return False
        if any(min(map(min, a)) > h << shift or max(map(max, a)) < l << shift for a, l, h in zip(arrays, low, high)):
            continue
        if level == MAX_LEVEL:
            return False
        axis = level % 2
        for which in (0, 1):
            nodes.append(([half_of_tensor(a, axis, which) for a in arrays], shift + degrees[axis], level + 1))
    return True
