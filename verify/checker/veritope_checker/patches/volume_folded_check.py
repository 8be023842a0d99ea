# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim volume-folded-1: check() is called when the statement and the hashes are right.

Written from docs/certificates/volume-folded.md alone (and reading-rule-faces.md, which it quotes).  A point of the
volume is a sum of control points with the values of B-splines as factors; factors are brought to integers.
"""
from fractions import Fraction
from itertools import groupby
from math import prod

from ..common.errors import Reject
from .model_faces import orientation
from .model_powers import scaled
from .model_subject import read_volumes
from .star_box_read import Body

MAX_DEGREE, MAX_BITS, MAX_KNOT_BITS, MAX_SIZE = 15, 8192, 256, 1 << 22

def check(claim, statement, body, model, skip):
    Checker(claim.magic, statement, Body(body), read_volumes(model, statement["subject_format"]), skip).run()

def read_point(body, volume):
    return [Parameter(body, p, t) for p, t in zip(volume.degrees, volume.knots)]

def different(knots):
    """The different ones, ascending.  A set would take long for knots that are chosen to have one hash."""
    return [t for t, _ in groupby(knots)]

def ends_of_piece(knots, piece):
    ends = different(knots)
    if piece >= len(ends) - 1:
        raise Reject("B1", "there is no piece %d" % piece)
    return ends[piece:piece + 2]

class Parameter:
    """A parameter of an axis, and the piece in which derivatives are taken."""

    def __init__(self, body, degree, knots):
        piece, n, d = body.varint(), body.varint(), body.varint()
        low, high = ends_of_piece(knots, piece)
        if d == 0 or n > d:
            raise Reject("B1", "the number %d/%d is not in [0, 1]" % (n, d))
        self.at = low + (high - low) * Fraction(n, d)
        self.degree, self.last = degree, len(knots) - 1 - knots[::-1].index(low)    # the piece begins at knot `last`
        self.knots = knots[self.last - degree + 1:self.last + degree + 1]

    def splines(self, degree):
        """The values of the degree + 1 B-splines of this degree that are not 0 on the piece."""
        t, values = self.knots[self.degree - degree:self.degree + degree], [Fraction(1)]
        for p in range(1, degree + 1):                      # those of degree p from those of degree p - 1
            raised = [Fraction(0)] * (p + 1)
            for i, value in enumerate(values):
                low, high = t[degree - p + i], t[degree + i]
                part = (self.at - low) / (high - low)
                raised[i] += (1 - part) * value
                raised[i + 1] += part * value
            values = raised
        return values

    def slopes(self):
        """The derivatives of the B-splines of the axis's degree on the piece, times a factor > 0."""
        p, slopes = self.degree, [Fraction(0)] * (self.degree + 1)
        for i, value in enumerate(self.splines(p - 1)):
            slope = value / (self.knots[p + i] - self.knots[i])
            slopes[i] -= slope
            slopes[i + 1] += slope
        return slopes

def combined(points, factors):
    """Sums of len(factors) consecutive points each."""
    n = len(factors)
    return [[sum(f * c for f, c in zip(factors, column)) for column in zip(*points[i:i + n])]
            for i in range(0, len(points), n)]

class Checker:
    def __init__(self, magic, statement, body, volumes, skip):
        self.statement, self.volumes, self.skip = statement, volumes, skip
        if body.bytes(4) != magic or int.from_bytes(body.bytes(4), "little") != len(volumes):
            raise Reject("B1", "magic, or another number of entities")
        self.number = body.varint()
        if self.number >= len(volumes):
            raise Reject("B1", "there is no entity %d" % self.number)
        self.volume = volumes[self.number]
        self.a, self.b = [read_point(body, self.volume) for _ in "AB"]
        body.end()

    def fail(self, condition, why):
        if condition not in self.skip:
            raise Reject(condition, why)

    def run(self):
        if max(self.volume.degrees) > MAX_DEGREE:
            self.fail("B2", "a degree is over %d" % MAX_DEGREE)
        boxes = [box_of(point, self.volume, self.fail) for point in (self.a, self.b)]
        for key, value in (("volumes", len(self.volumes)), ("entity", self.number)):
            if self.statement[key] != value:
                self.fail("B3", "%s is %d" % (key, value))
        for condition, sign, point, box in zip(("J1", "J2"), (1, -1), (self.a, self.b), boxes):
            found = sign_at(point, box)
            if found != sign:
                self.fail(condition, "the Jacobian determinant at %s is %s" % (
                    "A" if sign > 0 else "B", ("0", "positive", "negative")[found]))

def box_of(point, volume, fail):
    """The control points of the point's box in integers, the first axis fastest: B2."""
    for axis in point:
        if longest(scaled(axis.knots)) > MAX_KNOT_BITS:
            fail("B2", "the knots of a piece have integers of more than %d bits" % MAX_KNOT_BITS)
    u, v, w = [range(axis.last - axis.degree, axis.last + 1) for axis in point]
    integers = scaled([c for k in w for j in v for i in u for c in volume.at(i, j, k)])
    bits = longest(integers)
    if bits > MAX_BITS or bits * prod(map(len, (u, v, w))) > MAX_SIZE:
        fail("B2", "the control points of a box have integers of %d bits" % bits)
    values, _ = integers
    return [values[i:i + 4] for i in range(0, len(values), 4)]

def longest(integers):
    """The most bits of the numbers and of their common denominator."""
    values, common = integers
    return max(common, *map(abs, values)).bit_length()

def vector_at(point, box, by=None):
    """F at the point, or its derivative along the axis `by`, times a factor > 0."""
    for axis, parameter in enumerate(point):
        factors = parameter.slopes() if axis == by else parameter.splines(parameter.degree)
        box = combined(box, scaled(factors)[0])
    return box[0]

def sign_at(point, box):
    """The sign of det J: that of -det(F, F_u, F_v, F_w)."""
    return orientation(*[vector_at(point, box, by) for by in (None, 0, 1, 2)])
