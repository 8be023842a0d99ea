# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The body of a star-box certificate of version 2 (docs/certificates/star-box-2.md, section 2)."""
from collections import namedtuple
from itertools import combinations

from ..common.errors import Reject
from ..common.vectors import cross, dot
from .star_box_nodes import in_frame
from .star_box_read import Certificate, read_all_breaks, read_head

MAX_SHEETS, MAX_SEPARATORS = 64, 64
MAX_ENTRY = (1 << 31) - 1               # of a frame, in absolute value
MAX_STEPS = 64                          # of a separator's unit from that of the points
KINDS = {"surface": 1, "triangle": 2}
COEFFICIENTS = {1: 4, 2: 10, 3: 20}     # of a separator, by its degree

# c: (c-, c+).  signs: 1, -1 or 0 for each separator of the box.
Sheet = namedtuple("Sheet", "c signs")

# The sum of coefficient times y1^a y2^b y3^c, y = (x - origin) / 2^exponent; terms: (coefficient, (a, b, c)).
# length: the bits that origin and exponent may add to coefficients, for the work.
Separator = namedtuple("Separator", "degree origin exponent terms length")

class Box:
    """kind 0 star, 1 mesh; frame: a matrix, or None for the unit matrix; lo, hi: bounds of the mapped points."""

    def __init__(self, body, frames):
        self.kind, number = body.u8(1), body.varint()
        if number > len(frames):
            raise Reject("B1", "frame %d does not exist" % number)
        self.frame, shift = frames[number - 1] if number else None, body.shift()
        lo = [body.zigzag() for _ in range(3)]
        size = [body.varint() for _ in range(3)]
        if not all(size):
            raise Reject("B1", "a box is empty")
        self.lo, self.hi = [x << shift for x in lo], [x + s << shift for x, s in zip(lo, size)]
        self.component = None           # of the leaves that name it
        self.sheets, self.separators = [], []
        if self.kind == 0:
            self.read_sheets(body)
        self.is_shared = len(self.sheets) > 1
        self.c = self.sheets[0].c if self.sheets else ()

    def read_sheets(self, body):
        num_sheets, num_separators = body.u8(MAX_SHEETS), body.u8(MAX_SEPARATORS)
        if num_sheets == 0 or num_sheets == 1 and num_separators:
            raise Reject("B1", "a star box without sheets, or one sheet with separators")
        shift = body.shift()
        points = [[body.zigzag() for _ in range(3)] for _ in range(2 * num_sheets)]
        points[1:] = [[x + y for x, y in zip(p, points[0])] for p in points[1:]]
        points = [tuple(x << shift for x in p) for p in points]
        for p in in_frame(self.frame, points):
            if not all(l < x < h for l, x, h in zip(self.lo, p, self.hi)):
                raise Reject("B1", "a centre is not inside its box")
        self.separators = [read_separator(body, points[0], shift) for _ in range(num_separators)]
        signs = [[(0, 1, -1)[body.u8(2)] for _ in self.separators] for _ in range(num_sheets)]
        for s, t in combinations(signs, 2):
            if not any(x * y < 0 for x, y in zip(s, t)):
                raise Reject("B1", "no separator separates two sheets")
        self.sheets = [Sheet(points[2 * i:2 * i + 2], s) for i, s in enumerate(signs)]

def read_separator(body, origin, shift):
    degree, t = body.u8(3), body.zigzag()
    if degree == 0 or abs(t) > MAX_STEPS:
        raise Reject("B1", "a separator of degree %d, with 2^%d" % (degree, t))
    powers = [(a, b, c) for a in range(degree + 1) for b in range(degree + 1 - a) for c in range(degree + 1 - a - b)]
    return Separator(degree, origin, shift + t, [(body.zigzag(), p) for p in powers], shift + abs(shift + t))

def read_frame(body):
    a = [body.zigzag() for _ in range(9)]
    rows = tuple(a[:3]), tuple(a[3:6]), tuple(a[6:])
    if max(map(abs, a)) > MAX_ENTRY or dot(rows[0], cross(rows[1], rows[2])) == 0:
        raise Reject("B1", "an entry of a frame is too large, or its determinant is 0")
    return rows

def read_entities(body, magic, entities):
    """(flags, breaks) after the magic and the number of entities."""
    read_head(body, magic, entities)
    flags = []
    for e in entities:
        if body.u8(2) != (KINDS[e.kind] if e else 0):
            raise Reject("B1", "entity %d has another kind" % len(flags))
        flags.append(body.u8(1))
    return flags, read_all_breaks(body, entities)

class Certificate2(Certificate):
    read_entities = staticmethod(read_entities)

    def read_boxes(self, body):
        frames = [read_frame(body) for _ in range(body.count(9))]
        return [Box(body, frames) for _ in range(body.count(9))]
