# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim patch-invalid-1: check() is called when the statement and the hashes are right.

Written from docs/certificates/patch-invalid.md alone (and star-box.md, where it is quoted).  All numbers are integers;
a point is homogeneous, (P, w) with w > 0.
"""
from bisect import bisect_right
from math import comb, lcm

from ..common.errors import Reject
from ..common.vectors import cross, dot
from .star_box_check import MAX_DEGREE
from .model_subject import read_subject
from .star_box_nodes import extremes
from .star_box_patches import (along_u, axis_matrix, curve_key, halves, is_collapsed, outer_sides_of, surface_patch,
                               triangle_patch)
from .star_box_read import Body, read_entities

MAX_BITS = 62                           # k of an interval
MAX_HALVINGS = 200                      # of a side: D4
UNITS = 2000                            # of work for each outer side

def check(claim, statement, body, model, skip):
    Checker(claim.magic, statement, body, read_subject(model, statement["subject_format"]), skip).run()


# ---------------------------------------------------------------- section 2: the body

class Interval:
    """The interval [lo / full, hi / full]."""

    def __init__(self, body):
        k = body.varint(MAX_BITS + 1)
        self.lo, self.hi, self.full = body.varint(), body.varint(), 1 << k
        if not self.lo <= self.hi <= self.full:
            raise Reject("B1", "an interval that does not ascend, or leaves [0, 1]")

    def is_point(self):
        return self.lo == self.hi

    def is_open(self):
        """Whether it contains neither end of [0, 1]."""
        return 0 < self.lo and self.hi < self.full

    def misses(self, other):
        return self.hi * other.full < other.lo * self.full or other.hi * self.full < self.lo * other.full

    def overlaps(self, other):
        """Whether the two have an inner point in common."""
        return self.lo * other.full < other.hi * self.full and other.lo * self.full < self.hi * other.full

    def holds(self, n, level):
        """Whether it contains [n, n + 1] / 2^level."""
        return self.lo << level <= n * self.full and (n + 1) * self.full <= self.hi << level

class Rectangle:
    """A or B of a crossing."""

    def __init__(self, body, patches):
        self.patch, self.at = patches.number(body.varint()), (Interval(body), Interval(body))

class Arc:
    """A part of a side of a patch."""

    def __init__(self, body, patches):
        self.patch = patches.number(body.varint())
        self.side, self.at = body.u8(patches.num_sides(self.patch) - 1), Interval(body)

class Patches:
    """The patches by number, made on demand: a body of n breaks may define n^2 of them."""

    def __init__(self, entities, flags, breaks):
        self.entities, self.flags, self.breaks, self.made = entities, flags, breaks, {}
        self.matrices, self.columns = {}, {}
        self.sizes = [(len(b[0]) - 1, len(b[1]) - 1) if b else (1, 1) if e else (0, 0)
                      for e, b in zip(entities, breaks)]
        self.first = [0]                                    # number of the first patch of each entity
        for m, n in self.sizes:
            self.first.append(self.first[-1] + m * n)
        self.count = self.first.pop()

    def number(self, n):
        if n >= self.count:
            raise Reject("B1", "patch %d does not exist" % n)
        return n

    def place(self, n):
        """(entity, u, v) of a patch."""
        e = bisect_right(self.first, n) - 1
        return (e, *divmod(n - self.first[e], self.sizes[e][1]))

    def num_sides(self, n):
        return 4 if self.breaks[self.place(n)[0]] else 3

    def is_outer(self, n, side):
        e, u, v = self.place(n)
        return not self.breaks[e] or side in outer_sides_of(u, v, *self.sizes[e])

    def outer(self):
        """All pairs (patch, side)."""
        for first, b, (m, n) in zip(self.first, self.breaks, self.sizes):
            if not b:
                yield from ((first, side) for side in range(3))
                continue
            for u in range(m):
                for v in range(n) if u in (0, m - 1) else sorted({0, n - 1}):
                    yield from ((first + u * n + v, side) for side in outer_sides_of(u, v, m, n))

    def __getitem__(self, n):
        if n not in self.made:
            e, u, v = self.place(n)
            entity, flag = self.entities[e], self.flags[e]
            self.made[n] = self.cut(e, u, v) if self.breaks[e] else triangle_patch(entity, flag, 0)
        return self.made[n]

    def cut(self, e, u, v):
        """The patch of two intervals between breaks of a surface."""
        along_v = self.matrix(e, 1, v)
        key = e, u, along_v[0]
        if key not in self.columns:
            self.columns[key] = along_u(self.entities[e], 0, self.matrix(e, 0, u), along_v[0])
        return surface_patch(self.entities[e], self.flags[e], self.columns[key], along_v,
                             outer_sides_of(u, v, *self.sizes[e]))

    def matrix(self, e, axis, i):
        key = e, axis, i
        if key not in self.matrices:
            self.matrices[key] = axis_matrix(self.entities[e], axis, *self.breaks[e][axis][i:i + 2])
        return self.matrices[key]


# ---------------------------------------------------------------- polynomials in Bernstein form

def part(c, at):
    """The coefficients on an interval, times full^degree."""
    n, result = len(c) - 1, []
    for i in range(n + 1):
        d = c
        for r in range(n):
            t = at.lo if r < n - i else at.hi
            d = [(at.full - t) * x + t * y for x, y in zip(d, d[1:])]
        result.append(d[0])
    return result

def part_of_tensor(rows, at):
    columns = zip(*[part(row, at[1]) for row in rows])
    return list(zip(*[part(list(c), at[0]) for c in columns]))

def part_of_curve(points, at):
    return list(zip(*[part(list(c), at) for c in zip(*points)]))

def elevated(row, n, factor):
    """The coefficients in degree n, times factor, which all comb(n, i) divide."""
    r = len(row) - 1
    return [sum(comb(r, j) * comb(n - r, i - j) * c for j, c in enumerate(row) if 0 <= i - j <= n - r)
            * (factor // comb(n, i))
            for i in range(n + 1)]

def tensor_net(patch):
    """The patch's net; for a triangle, that of a tensor patch."""
    return patch.net if patch.is_tensor else over_square(patch.net)

def over_square(net):
    """The net over (s, t) of a triangle's net, at the point (1 - s, s (1 - t), s t), times a factor > 0."""
    n = len(net[0]) - 1
    factor = lcm(*[comb(n, i) for i in range(n + 1)])
    return [[elevated(row, n, factor) for row in a] for a in net]

def value_at(c, n, d):
    """The value at n / d, times d^degree."""
    while len(c) > 1:
        c = [(d - n) * x + n * y for x, y in zip(c, c[1:])]
    return c[0]

def slopes(x, w):
    """The coefficients of x' w - x w', each times a factor > 0."""
    p = len(x) - 1
    result = [0] * (2 * p)
    for i in range(p):
        for j in range(p + 1):
            result[i + j] += comb(p - 1, i) * comb(p, j) * ((x[i + 1] - x[i]) * w[j] - (w[i + 1] - w[i]) * x[j])
    return result

def less(a, b):
    """Whether a < b, each as (numerator, denominator > 0)."""
    return a[0] * b[1] < b[0] * a[1]


# ---------------------------------------------------------------- crossings

def are_independent(y):
    """X2 for three rows."""
    return dot(cross(y[0], y[1]), y[2]) != 0

def unseparated(pair, nets, y):
    """The number of a row and the end of its parameter where X3 does not hold, or None. pair: the two Intervals of A,
    and of B; nets: of the tensor patches over [0, 1] x [0, 1]."""
    nets = [[part_of_tensor(a, at) for a in net] for at, net in zip(pair, nets)]
    free = [(which, axis) for which, at in enumerate(pair) for axis in range(2) if not at[axis].is_point()]
    for i, ((which, axis), row) in enumerate(zip(free, y)):
        for end in (0, -1):
            (a_least, a_greatest), (b_least, b_greatest) = [
                control_values(row, face(net, axis, end) if which == n else net) for n, net in enumerate(nets)]
            if not (less(a_greatest, b_least) if end == 0 else less(b_greatest, a_least)):
                return i + 1, "low" if end == 0 else "high"
    return None

def face(net, axis, end):
    return [[a[end]] if axis == 0 else [[row[end]] for row in a] for a in net]

def control_values(y, net):
    """The least and the greatest value of Y.P / w."""
    x, w = [], []
    for rows in zip(*net):
        for px, py, pz, pw in zip(*rows):
            x.append(y[0] * px + y[1] * py + y[2] * pz)
            w.append(pw)
    return extremes(x, w)


# ---------------------------------------------------------------- the conditions in the order of the page

class FindingChecker:
    """What the versions of the claim share: B2 and B3.  A subclass reads the body: flags, patches."""

    def __init__(self, statement, entities, skip):
        self.statement, self.entities, self.skip = statement, entities, skip

    def fail(self, condition, why):
        if condition not in self.skip:
            raise Reject(condition, why)

    def check_entities(self):
        """Tests B2, but for the lengths of numbers."""
        for i, entity in enumerate(self.entities):
            if not entity or entity.dimension != 3 or max(entity.degrees) > MAX_DEGREE:
                raise Reject("B2", "entity %d is no surface or triangle in space of degree at most %d"
                             % (i, MAX_DEGREE))
            for p, knots in zip(entity.degrees, entity.knots):
                if any(a == b and knots[p] < a < knots[-p - 1] for a, b in zip(knots, knots[p:])):
                    self.fail("B2", "entity %d has an inner knot of multiplicity %d" % (i, p + 1))

    def make_patches(self, numbers):
        """Tests the lengths of numbers (B2) of the patches that the finding is about."""
        for n in sorted(set(numbers)):
            self.patches[n]

    def check_statement(self, **found):
        """Tests B3.  found: what the statement says beside the numbers of patches and flags."""
        found.update(patches=self.patches.count, flipped=sum(self.flags))
        for key, value in found.items():
            if self.statement[key] != value:
                self.fail("B3", "%s: %s in the body, %s in the statement" % (key, value, self.statement[key]))

class Checker(FindingChecker):
    def __init__(self, magic, statement, data, entities, skip):
        super().__init__(statement, entities, skip)
        body = Body(data)
        self.flags, breaks = read_entities(body, magic, entities)
        self.patches = Patches(entities, self.flags, breaks)
        self.is_crossing = body.u8(1) == 0
        if self.is_crossing:
            self.pair = [Rectangle(body, self.patches) for _ in range(2)]
            self.y = [[body.zigzag() for _ in range(3)] for _ in range(3)]
        else:
            self.arcs = [Arc(body, self.patches) for _ in range(body.count(5))]
            if not self.arcs:
                raise Reject("B1", "no arc")
            self.axis, k = body.u8(2), body.varint(MAX_BITS + 1)
            self.t0 = body.varint(), 1 << k
        body.end()

    def run(self):
        self.check_entities()
        if self.is_crossing:
            self.make_patches(r.patch for r in self.pair)
            self.check_statement(finding="crossing", same=0, opposite=0)
            self.check_places()
            self.check_rows()
            self.check_faces()
        else:
            self.outer = list(self.patches.outer())
            self.make_patches(n for n, _ in self.outer)
            self.check_statement(finding="side")
            self.check_arcs()
            self.check_curves()
            self.check_slopes()
            self.check_others()

    def check_places(self):
        """Tests X1."""
        a, b = self.pair
        if sum(at.is_point() for at in a.at + b.at) != 1:
            self.fail("X1", "not exactly one of the four intervals is a point")
        if a.patch == b.patch and not any(s.misses(t) for s, t in zip(a.at, b.at)):
            self.fail("X1", "A and B are of one patch and not disjoint")
        if not all(at.is_open() for at in a.at):
            self.fail("X1", "A is not in the open domain")
        if any(not self.patches[r.patch].is_tensor and r.at[0].lo == 0 for r in self.pair):
            self.fail("X1", "an interval of s contains 0")

    def check_rows(self):
        """Tests X2."""
        if not are_independent(self.y):
            self.fail("X2", "det Y is 0")

    def check_faces(self):
        """Tests X3."""
        found = unseparated([r.at for r in self.pair], [tensor_net(self.patches[r.patch]) for r in self.pair], self.y)
        if found:
            self.fail("X3", "row %d does not separate A and B where its parameter is %s" % found)

    def check_arcs(self):
        """Tests D1."""
        of_side = {}
        for i, arc in enumerate(self.arcs):
            if not self.patches.is_outer(arc.patch, arc.side):
                self.fail("D1", "arc %d is not on an outer side" % i)
            if arc.at.is_point() or is_collapsed(self.patches[arc.patch].side(arc.side)):
                self.fail("D1", "the side of arc %d is collapsed, or its interval is a point" % i)
            of_side.setdefault((arc.patch, arc.side), []).append(arc.at)
        for intervals in of_side.values():
            intervals.sort(key=lambda at: (at.lo << MAX_BITS) // at.full)
            if any(a.overlaps(b) for a, b in zip(intervals, intervals[1:])):
                self.fail("D1", "two arcs of one side overlap")
        (a, full), first = self.t0, self.arcs[0].at
        if not (first.lo * full < a * first.full and a * first.full < first.hi * full):
            self.fail("D1", "the point is not inside the first arc")

    def check_curves(self):
        """Tests D2."""
        keys = []
        for arc in self.arcs:
            curve = part_of_curve(self.patches[arc.patch].side(arc.side), arc.at)
            curve = curve[::-1] if self.patches[arc.patch].flag else curve
            keys.append((curve_key(curve), curve_key(curve[::-1])))
        first, same, opposite = keys[0][0], 0, 0
        for i, (key, back) in enumerate(keys):
            if key == first:
                same += 1
            elif back == first:
                opposite += 1
            else:
                self.fail("D2", "arc %d is another curve than the first" % i)
        if (same, opposite) == (1, 1):
            self.fail("D2", "one arc in each direction: an edge")
        if (same, opposite) == (2, 0) and any(self.flags):
            self.fail("D2", "two arcs in one direction, but with flags that are not the model's")
        if (self.statement["same"], self.statement["opposite"]) != (same, opposite):
            self.fail("D2", "%d the same and %d opposite, the statement says %d and %d" %
                      (same, opposite, self.statement["same"], self.statement["opposite"]))

    def check_slopes(self):
        """Tests D3."""
        arc = self.arcs[0]
        patch = self.patches[arc.patch]
        curve = part_of_curve(patch.side(arc.side), arc.at)
        x, w = [[p[c] for p in curve] for c in (self.axis, 3)]
        signs = slopes(x, w) if patch.rational else [b - a for a, b in zip(x, x[1:])]
        if not (min(signs) > 0 or max(signs) < 0):
            self.fail("D3", "the first arc is not seen to be monotone along its axis")

    def check_others(self):
        """Tests D4."""
        arcs, (a, full), first = {}, self.t0, self.arcs[0]
        for arc in self.arcs:
            arcs.setdefault((arc.patch, arc.side), []).append(arc.at)
        x = [value_at(c, a, full) for c in zip(*self.patches[first.patch].side(first.side))]
        work = UNITS * (len(self.outer) + 100)
        for n, side in self.outer:
            curve = self.patches[n].side(side)
            stack = [] if is_collapsed(curve) else [(0, 0, [list(c) for c in zip(*curve)])]
            mine = arcs.get((n, side), ())
            while stack:
                level, i, curve = stack.pop()
                work -= 1
                if work < 0:
                    return self.fail("D4", "too much work")
                if any(at.holds(i, level) for at in mine) or misses_point(curve, x):
                    continue
                if level == MAX_HALVINGS:
                    return self.fail("D4", "side %d of patch %d passes the point, too" % (side, n))
                left, right = zip(*[halves(c) for c in curve])
                stack += (level + 1, 2 * i, left), (level + 1, 2 * i + 1, right)

def misses_point(curve, p):
    """Whether the closed hull of a curve (x, y, z, w) misses the homogeneous point p."""
    for c in range(3):
        least, greatest = extremes(curve[c], curve[3])
        if less((p[c], p[3]), least) or less(greatest, (p[c], p[3])):
            return True
    return False
