# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Models in IRIT's .itd: docs/certificates/reading-rule-itd.md, section by section."""
import re
from fractions import Fraction
from itertools import product
from math import lcm, prod

from ..common.errors import Refused
from .model_maps import map_of, sizes_of
from .model_powers import bernstein, factor_of
from .model_tokens import decimal
from .star_box_read import axis_size

PASSED_OVER = {b"NUMBER", b"STRING", b"POINT", b"VECTOR", b"PLANE", b"MATRIX", b"CTLPT"}
REFUSED = {b"CURVE", b"SURFACE", b"TRIVAR", b"TRIMSRF", b"MODEL", b"POLYGON", b"POLYLINE", b"POINTLIST", b"POLYSTRIP",
           b"TRISRF", b"INSTANCE"}
NO_ATTRIBUTE = {b"KV", b"KVP", b"SURFACE", b"CURVE", b"TRIMCRV"}
MAX_ORDER = 64

BLANKS = re.compile(rb"[ \t\v\f\n\r]*")
WORD = re.compile(rb'[^ \t\v\f\n\r\[\]"]*')
STRING = re.compile(rb'"[^"\\]*(?:\\.[^"\\]*)*"', re.DOTALL)
MARK = re.compile(rb'[\[\]"]')
COUNT = re.compile(rb"[-+]?[0-9]+")
SURFACE_TYPE, VOLUME_TYPE = re.compile(rb"[EP]3"), re.compile(rb"[EP][1-9]")

class Reader:
    """num_axes: 2 for a model of surfaces, 3 for one of volumes (section 4)."""

    def __init__(self, data, num_axes=2):
        self.data, self.pos = data, 3 if data[:3] == b"\xef\xbb\xbf" else 0
        self.num_axes, self.keyword = num_axes, {2: b"SURFACE", 3: b"TRIVAR"}[num_axes]

    # -- section 1

    def peek(self):
        """The byte after any blanks; empty at the end."""
        self.pos = BLANKS.match(self.data, self.pos).end()
        return self.data[self.pos:self.pos + 1]

    def take(self, byte):
        if self.peek() != byte:
            raise Refused("byte %d: expected %s" % (self.pos, byte.decode()))
        self.pos += 1

    def word(self):
        """The next word; empty if something else comes first."""
        self.peek()
        m = WORD.match(self.data, self.pos)
        self.pos = m.end()
        return m[0]

    def string(self):
        m = STRING.match(self.data, self.pos)
        if not m:
            raise Refused("byte %d: a string does not end" % self.pos)
        self.pos = m.end()

    def group(self):
        """Moves from within a group to after it."""
        depth = 1
        while depth:
            m = MARK.search(self.data, self.pos)
            if not m:
                raise Refused("a group does not end")
            self.pos = m.start()
            if m[0] == b'"':
                self.string()
            else:
                depth += 1 if m[0] == b"[" else -1
                self.pos += 1

    def count(self):
        word = self.word()
        digits = word.lstrip(b"+-").lstrip(b"0")
        if not COUNT.fullmatch(word) or word[:1] == b"-" or not 0 < len(digits) < 16:
            raise Refused("byte %d: %r is no count" % (self.pos, word[:40]))
        return int(digits)

    def decimal(self):
        word = self.word()
        return decimal(word, self.pos - len(word))

    # -- section 2

    def model(self):
        entities, named, is_empty = [], [], True    # named: of the objects that are open
        while True:
            if not named:
                self.pos = self.data.find(b"[", self.pos)
                if self.pos < 0:
                    break
            byte = self.peek()
            if byte == b"]":
                self.pos += 1
                named.pop()
            elif byte == b"[":
                is_empty = False
                self.pos += 1
                self.item(self.word(), entities, named)
            elif not byte or named[-1]:
                raise Refused("byte %d: an object does not end, or has a second name" % self.pos)
            else:
                named[-1] = True
                self.string() if byte == b'"' else self.word()
        if is_empty:
            raise Refused("there is no group in the file")
        return entities

    def item(self, keyword, entities, named):
        if keyword in (self.keyword, b"MULTIVAR"):
            entities.append(self.entity(keyword == b"MULTIVAR"))
        elif keyword in REFUSED:
            raise Refused("byte %d: geometry other than %s: %s" %
                          (self.pos, {2: "surfaces", 3: "volumes"}[self.num_axes], keyword.decode()))
        elif keyword == b"OBJECT":
            named.append(False)
        elif named or keyword in PASSED_OVER:
            self.group()
        else:
            raise Refused("byte %d: neither an object nor data" % self.pos)

    # -- section 3

    def entity(self, is_multivariate):
        basis = self.word()
        if basis not in (b"BEZIER", b"BSPLINE", b"POWER"):
            raise Refused("byte %d: %r is no basis" % (self.pos, basis[:40]))
        while self.peek() == b"[":
            self.pos += 1
            if self.word() in NO_ATTRIBUTE:
                raise Refused("byte %d: no attribute" % self.pos)
            self.group()
        if is_multivariate and self.count() != self.num_axes:
            raise Refused("byte %d: a multivariate of another number of parameters" % self.pos)
        given = [self.count() for _ in range(self.num_axes)]
        orders = [self.count() for _ in given] if basis == b"BSPLINE" else given
        kind = self.word()
        if not {2: SURFACE_TYPE, 3: VOLUME_TYPE}[self.num_axes].fullmatch(kind):
            raise Refused("byte %d: %r is no type of a point" % (self.pos, kind[:40].decode("latin-1")))
        for k, n in zip(orders, given):
            if not 2 <= k <= min(n, MAX_ORDER):
                raise Refused("byte %d: an order of %d with %d control points" % (self.pos, k, n))
        if basis == b"BSPLINE":
            knots = [self.knots(n, k) for n, k in zip(given, orders)]
        else:
            knots = [[Fraction(0)] * k + [Fraction(1)] * k for k in orders]
        degrees, rational, dimension = [k - 1 for k in orders], kind[:1] == b"P", int(kind[1:])
        for p, t in zip(degrees, knots):
            axis_size(p, t)
        if prod(given) > len(self.data):
            raise Refused("more control points than the file can hold")
        points = [self.point(rational, dimension) for _ in range(prod(given))]
        self.take(b"]")
        if basis == b"POWER":
            points = bernstein_net(points, given)
        points = repeated(points, given, sizes_of(degrees, knots))
        if not rational:
            points = [point + [Fraction(1)] for point in points]
        if any(point[-1] <= 0 for point in points):
            raise Refused("a weight is not positive")
        return map_of(degrees, knots, rational, dimension, points)

    def knots(self, num_points, order):
        self.take(b"[")
        word = self.word()
        if word not in (b"KV", b"KVP"):
            raise Refused("byte %d: expected KV or KVP" % self.pos)
        knots = [self.decimal() for _ in range(num_points + order + (order - 1 if word == b"KVP" else 0))]
        self.take(b"]")
        return knots

    def point(self, rational, dimension):
        self.take(b"[")
        numbers = [self.decimal() for _ in range(dimension + rational)]
        self.take(b"]")
        return numbers[1:] + numbers[:1] if rational else numbers

def repeated(points, given, sizes):
    """All control points, the first axis fastest: those of KVP come again after the given ones."""
    if given == sizes:
        return points
    strides = [prod(given[:axis]) for axis in range(len(given))]
    rows = product(*[[i % n * stride for i in range(size)] for n, size, stride in zip(given, sizes, strides)][::-1])
    return [points[sum(row)] for row in rows]

def bernstein_net(points, sizes):
    """The Bernstein net of points along all axes, in integers, since sums of long fractions are slow."""
    components = []
    for values in zip(*points):
        common = lcm(*[x.denominator for x in values])
        net, stride = [x.numerator * (common // x.denominator) for x in values], 1
        for n in sizes:
            for start in range(0, len(net), n * stride):
                for first in range(start, start + stride):
                    net[first:start + n * stride:stride] = bernstein(net[first:start + n * stride:stride])
            common, stride = common * factor_of(n - 1), n * stride
        components.append([Fraction(x, common) for x in net])
    return [list(point) for point in zip(*components)]
