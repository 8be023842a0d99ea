# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim points-1: docs/certificates/points.md."""
from math import gcd, lcm

from .answers import lines_of, read_answers
from . import expression_check, patch_points_check
from .box_tree import BoxTree, boxes_of_triangles
from ..claims import SPLINES
from ..mesh import mesh_reader
from ..mesh.mesh_model import TOO_MUCH_WORK, Body, integers_of, line_stabs, sign
from ..common.errors import Reject
from ..common.vectors import cross, dot, sub

def check(claim, statement, body, model, skip, answers, files):
    """Returns text for a chain file: how many points are not covered."""
    words = read_answers(answers, statement, skip)                              # A1, A2
    if statement["subject_format"] == "chain":
        return expression_check.check(claim, statement, body, model, skip, answers, files)
    if statement["subject_format"] in SPLINES:
        return patch_points_check.check(claim, statement, body, model, skip, answers, words)
    floats, triangles = mesh_reader.read_model(model, statement["subject_format"], statement["as_indexed"])
    codes = read_codes(claim, statement, Body(body), floats, triangles, words)
    points, unit = integers_of(floats)
    tree, work = BoxTree(list(boxes_of_triangles(points, triangles))), 10 * len(triangles) + 1000 * statement["points"]
    failure = None if "P1" in skip else p1_not_closed(triangles)
    for number, ((point, word, f), code) in enumerate(zip(lines_of(answers, statement), codes), 1):
        if word == "undecided":
            continue
        at = Point(point, unit, points, triangles)
        if word == "on":
            work -= 1
            wrong = p2_not_on(at, code)
        else:
            touched, crossed, both = tree.near(at.floors, at.ceilings, code)
            work -= both
            wrong = p3_on(at, touched) if "P3" not in skip else None
            wrong = wrong or p4_winding(at, f, crossed, code)
        if work < 0 and "B1" not in skip:                                       # B1 comes before P1 to P4
            raise Reject("B1", TOO_MUCH_WORK)
        if wrong and not failure and wrong[0] not in skip:
            failure = wrong[0], "line %d: %s" % (number, wrong[1])
    if failure:
        raise Reject(*failure)

def read_codes(claim, statement, body, floats, triangles, words):
    """The codes of the points, None for undecided ones: B1."""
    body.header(claim.magic, floats, triangles)
    if int.from_bytes(body.bytes(8), "little") != statement["points"]:
        raise Reject("B1", "the number of points differs from the statement's")
    codes = []
    for word in words:
        code = body.varint() if word == "on" else body.u8() if word == "off" else None
        if word == "on" and code >= len(triangles) or word == "off" and code > 5:
            raise Reject("B1", "a code is out of range: %d" % code)
        codes.append(code)
    body.end()
    return codes

def p1_not_closed(triangles):
    """The failure if some directed edge does not occur as often as its reverse."""
    edges = [edge for a, b, c in triangles for edge in ((a, b), (b, c), (c, a))]
    there = sorted(a << 32 | b for a, b in edges)
    back = sorted(b << 32 | a for a, b in edges)
    for edge, other in zip(there, back):
        if edge != other:
            a, b = edge >> 32, min(edge, other) & 0xffffffff    # both have one a: it ends as many edges as it starts
            return "P1", "the edges (%d, %d) and (%d, %d) do not occur equally often" % (a, b, b, a)

def p2_not_on(at, f):
    if not at.is_on(f):
        return "P2", "the point is not on triangle %d" % f

def p3_on(at, touched):
    for f in touched:
        if at.is_on(f):
            return "P3", "the point is on triangle %d" % f

def p4_winding(at, f, crossed, direction):
    total = at.winding(crossed, direction)
    if total != f:
        return "P4", "the winding number is %d, not %d" % (total, f)

class Point:
    """A point Q on the grid of the mesh: integers divided by one denominator."""

    def __init__(self, point, unit, points, triangles):
        self.points, self.triangles = points, triangles
        ratios = []
        for n, d in point:
            n, d = n * unit.denominator, d * unit.numerator
            g = gcd(n, d)
            ratios.append((n // g, d // g))
        (_, i), (_, j), (_, k) = ratios
        self.denominator = i if i == j == k else lcm(i, j, k)
        self.q = [n * (self.denominator // d) for n, d in ratios]
        self.floors = [n // d for n, d in ratios]
        self.ceilings = [-(-n // d) for n, d in ratios]

    def corners(self, f):
        """The corners of triangle f minus Q, times the denominator: in these coordinates Q is the origin."""
        (x, y, z), d = self.q, self.denominator
        return [(d * a - x, d * b - y, d * c - z) for a, b, c in [self.points[v] for v in self.triangles[f]]]

    def is_on(self, f):
        """Section 4: whether Q is in the convex hull of the corners."""
        a, b, c = self.corners(f)
        n = cross(sub(b, a), sub(c, a))
        if any(n):
            return dot(n, a) == 0 and all(dot(n, cross(p, q)) >= 0 for p, q in ((a, b), (b, c), (c, a)))
        return any(not any(cross(p, q)) and dot(p, q) <= 0 for p, q in ((a, b), (b, c), (c, a)))    # segments

    def winding(self, crossed, direction):
        """Section 4: the sum over the triangles that the ray stabs, all of which are among these."""
        u, backwards, total = direction // 2, direction % 2 == 1, 0
        for f in crossed:
            a, b, c = self.corners(f)
            if line_stabs((a, b, c), (0, 0, 0), u):
                n = cross(sub(b, a), sub(c, a))
                t = sign(dot(n, a)) * sign(n[u])
                if t == (-1 if backwards else 1):
                    total += sign(n[u]) * t
        return total
