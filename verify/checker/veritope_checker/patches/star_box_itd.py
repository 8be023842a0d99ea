# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Models in IRIT's .itd (docs/certificates/reading-rule-itd.md, section by section), and the choice of a reader."""
import re
from fractions import Fraction
from math import comb, lcm

from ..common.errors import Refused
from .star_box_read import MAX_DIGITS, Entity, axis_size, number, read_model

PASSED_OVER = {b"NUMBER", b"STRING", b"POINT", b"VECTOR", b"PLANE", b"MATRIX", b"CTLPT"}
REFUSED = {b"CURVE", b"TRIVAR", b"TRIMSRF", b"MODEL", b"POLYGON", b"POLYLINE", b"POINTLIST", b"POLYSTRIP",
           b"TRISRF", b"INSTANCE"}
NO_ATTRIBUTE = {b"KV", b"KVP", b"SURFACE", b"CURVE", b"TRIMCRV"}
MAX_ORDER = 64

BLANKS = re.compile(rb"[ \t\v\f\n\r]*")
WORD = re.compile(rb'[^ \t\v\f\n\r\[\]"]*')
STRING = re.compile(rb'"[^"\\]*(?:\\.[^"\\]*)*"', re.DOTALL)
MARK = re.compile(rb'[\[\]"]')
DECIMAL = re.compile(r"[-+]?([0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][-+]?[0-9]+)?")
COUNT = re.compile(rb"[-+]?[0-9]+")

def read_subject(data, subject_format):
    """The entities of a model in the format that the statement names."""
    if subject_format not in ("vjson", "itd"):
        raise Refused("models in the format %s are not read yet" % subject_format)
    return Reader(data).model() if subject_format == "itd" else read_model(data)

class Reader:
    def __init__(self, data):
        self.data, self.pos = data, 3 if data[:3] == b"\xef\xbb\xbf" else 0

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
        word = self.word().decode("latin-1")
        m = DECIMAL.fullmatch(word)
        if not m or len(m[1].replace(".", "")) > MAX_DIGITS:
            raise Refused("byte %d: %r is no decimal, or has too many digits" % (self.pos, word[:40]))
        return number(word)

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
        if keyword in REFUSED:
            raise Refused("byte %d: geometry other than surfaces: %s" % (self.pos, keyword.decode()))
        if keyword == b"OBJECT":
            named.append(False)
        elif keyword in (b"SURFACE", b"MULTIVAR"):
            entities.append(self.surface(keyword == b"MULTIVAR"))
        elif named or keyword in PASSED_OVER:
            self.group()
        else:
            raise Refused("byte %d: neither an object nor data" % self.pos)

    # -- section 3

    def surface(self, is_multivariate):
        basis = self.word()
        if basis not in (b"BEZIER", b"BSPLINE", b"POWER"):
            raise Refused("byte %d: %r is no basis" % (self.pos, basis[:40]))
        while self.peek() == b"[":
            self.pos += 1
            if self.word() in NO_ATTRIBUTE:
                raise Refused("byte %d: no attribute" % self.pos)
            self.group()
        if is_multivariate and self.count() != 2:
            raise Refused("byte %d: a multivariate of another number of parameters" % self.pos)
        given = [self.count(), self.count()]
        orders = [self.count(), self.count()] if basis == b"BSPLINE" else given
        kind = self.word()
        if any(not 2 <= k <= min(n, MAX_ORDER) for k, n in zip(orders, given)) or kind not in (b"E3", b"P3"):
            raise Refused("byte %d: an order is out of range, or no E3 or P3" % self.pos)
        entity = Entity("surface")
        entity.degrees, entity.rational, entity.dimension = tuple(k - 1 for k in orders), kind == b"P3", 3
        if basis == b"BSPLINE":
            entity.knots = [self.knots(n, k) for n, k in zip(given, orders)]
        else:
            entity.knots = [[Fraction(0)] * k + [Fraction(1)] * k for k in orders]
        sizes = [axis_size(p, t) for p, t in zip(entity.degrees, entity.knots)]
        if given[0] * given[1] > len(self.data):
            raise Refused("more control points than the file can hold")
        columns = [[self.point(entity.rational) for _ in range(given[0])] for _ in range(given[1])]
        self.take(b"]")
        rows = list(zip(*columns))                  # rows[i][j]: i along u
        rows = bernstein_net(rows) if basis == b"POWER" else rows
        weight = [] if entity.rational else [Fraction(1)]
        entity.rows = [[rows[i % given[0]][j % given[1]] + weight for j in range(sizes[1])] for i in range(sizes[0])]
        if any(point[3] <= 0 for row in entity.rows for point in row):
            raise Refused("a weight is not positive")
        return entity

    def knots(self, num_points, order):
        self.take(b"[")
        word = self.word()
        if word not in (b"KV", b"KVP"):
            raise Refused("byte %d: expected KV or KVP" % self.pos)
        knots = [self.decimal() for _ in range(num_points + order + (order - 1 if word == b"KVP" else 0))]
        self.take(b"]")
        return knots

    def point(self, rational):
        self.take(b"[")
        numbers = [self.decimal() for _ in range(4 if rational else 3)]
        self.take(b"]")
        return numbers[1:] + numbers[:1] if rational else numbers

def bernstein(a):
    """Integers: the Bernstein coefficients of sum a_r t^r over [0, 1], times factor_of(their degree)."""
    d = len(a) - 1
    b = [factor_of(d) // comb(d, r) * x for r, x in enumerate(a)]
    for r in range(1, d + 1):                               # adds one to the i of C(i, r)
        b[r:] = [x + y for x, y in zip(b[r - 1:], b[r:])]
    return b

def factor_of(d):
    return lcm(*[comb(d, r) for r in range(d + 1)])

def bernstein_net(rows):
    """The Bernstein net of rows of points along both axes, in integers, since sums of long fractions are slow."""
    components = []
    for net in [[[point[c] for point in row] for row in rows] for c in range(len(rows[0][0]))]:
        common = lcm(*[x.denominator for row in net for x in row])
        net = [bernstein([x.numerator * (common // x.denominator) for x in row]) for row in net]
        columns = [bernstein(column) for column in zip(*net)]
        common *= factor_of(len(net) - 1) * factor_of(len(columns) - 1)
        components.append([[Fraction(x, common) for x in row] for row in zip(*columns)])
    return [[list(point) for point in zip(*row)] for row in zip(*components)]
