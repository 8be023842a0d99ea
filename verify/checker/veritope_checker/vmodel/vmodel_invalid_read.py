# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The body of a certificate of an invalid V-model (docs/certificates/vmodel-invalid.md, section 2)."""
from collections import namedtuple
from fractions import Fraction

from ..common.errors import Reject
from ..patches.star_box_read import Body
from ..patches.volume_folded_check import ends_of_piece, read_point
from .vmodel_glue import side_of

MAGIC, MAX_HALVINGS = b"VTVI", 62
KINDS = ("flat", "left-handed", "singular", "overlap", "curve-nonmanifold", "point-nonmanifold")

# at: three intervals of a span or a box, three Parameters of a point; the one interval of an arc, which is a part of
# the cell's edge, a side of the face; y: three rows.
Place = namedtuple("Place", "cell at")
Arc = namedtuple("Arc", "cell face side edge at")
Corner = namedtuple("Corner", "cell corner")

class Interval:
    """The interval [lo, hi] of an axis, in the span k between two consecutive knots."""

    def __init__(self, knots, k, part=(0, 1)):
        self.k, (first, last) = k, ends_of_piece(knots, k)
        self.lo, self.hi = [first + (last - first) * t for t in part]

    def overlaps(self, other):
        """Whether the two have an inner point in common."""
        return self.lo < other.hi and other.lo < self.hi

class Finding:
    """kind: of KINDS; what it is about: places (of a box of knots, A, or A and B), y (rows, if B is a box) and arcs, or
    the corner."""

    def __init__(self, data, volumes):
        self.body, self.volumes, self.y = Body(data), volumes, None
        if self.body.bytes(4) != MAGIC or self.body.count(0) != len(volumes):
            raise Reject("B1", "magic, or another number of entities")
        self.kind = KINDS[self.body.u8(len(KINDS) - 1)]
        self.points, self.boxes, self.arcs, self.corner = [], [], [], None
        if self.kind == "flat":
            cell = self.cell()
            self.boxes.append(Place(cell, [Interval(t, self.body.varint()) for t in volumes[cell].knots]))
        elif self.kind == "curve-nonmanifold":
            self.arcs = [self.arc() for _ in range(3)]
        elif self.kind == "point-nonmanifold":
            self.corner = Corner(self.cell(), self.body.u8(7))
        else:
            self.points.append(self.point())
            if self.kind == "overlap":
                self.read_b()
        self.body.end()

    def read_b(self):
        if self.body.u8(1) == 0:
            self.points.append(self.point())
            return
        cell = self.cell()
        self.boxes.append(Place(cell, [self.interval(t) for t in self.volumes[cell].knots]))
        self.y = [[self.body.zigzag() for _ in range(3)] for _ in range(3)]

    def cell(self):
        cell = self.body.varint()
        if cell >= len(self.volumes):
            raise Reject("B1", "there is no cell %d" % cell)
        return cell

    def point(self):
        cell = self.cell()
        return Place(cell, read_point(self.body, self.volumes[cell]))

    def interval(self, knots):
        k, e = self.body.varint(), self.body.varint(MAX_HALVINGS + 1)
        a, b = self.body.varint(), self.body.varint()
        if not a < b <= 1 << e:
            raise Reject("B1", "an interval from %d to %d, of %d" % (a, b, 1 << e))
        return Interval(knots, k, (Fraction(a, 1 << e), Fraction(b, 1 << e)))

    def arc(self):
        cell, face, side = self.cell(), self.body.u8(5), self.body.u8(3)
        edge = side_of(face, side // 2, side % 2)
        return Arc(cell, face, side, edge, self.interval(self.volumes[cell].knots[edge // 4]))
