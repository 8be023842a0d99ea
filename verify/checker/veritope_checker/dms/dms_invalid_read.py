# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The body of a certificate of an invalid simplex-spline solid (docs/certificates/dms-invalid.md, section 2): B1 and
B2."""
from collections import namedtuple

from ..common.errors import Reject
from ..patches.patch_invalid_check import Interval
from ..patches.star_box_read import Body
from .dms_body import MAX_BITS, counted, is_long, read_planes, why_model_too_long
from .dms_domain import boundary_of

MAGIC = b"VTDI"
KINDS = ("tet-reversed", "tet-face-overused", "cloud-degenerate", "cloud-no-core", "cloud-inside", "jacobian",
         "jacobian-zero", "M4", "M6", "M7", "M9", "meeting", "crossing", "covering")
OF_THE_MAP = ("jacobian", "jacobian-zero", "meeting", "crossing", "covering")
FACE_OF_LIST = 1                                            # least size, in bytes

# face: (tetrahedron, number).  at: two Intervals.
Term = namedtuple("Term", "gamma m y")
Piece = namedtuple("Piece", "face points planes")
Crossing = namedtuple("Crossing", "pieces at y")

class WitnessBody(Body):
    """rationals: all that have been read."""

    def __init__(self, data, model):
        super().__init__(data)
        self.model, self.rationals = model, []

    def rational(self):
        self.rationals.append(super().rational())
        return self.rationals[-1]

    def numbers(self, count):
        return [self.rational() for _ in range(count)]

    def tet(self):
        return self.existing(self.model.tetrahedra, "tetrahedron")

    def vertex(self):
        return self.existing(self.model.clouds, "vertex")

    def existing(self, those, what):
        number = self.varint()
        if number >= len(those):
            raise Reject("B1", "there is no %s %d" % (what, number))
        return number

    def face(self):
        return self.tet(), self.u8(3)

    def index(self, size):
        return tuple(self.u8() for _ in range(size))

    def terms(self):
        count = self.u8(4)
        if not count:
            raise Reject("B1", "no index")
        return [Term(self.index(4), self.u8(3), self.rational()) for _ in range(count)]

    def hull(self):
        """(face, (j, k, l), tetrahedron, weights)"""
        face, index, t = self.face(), self.index(3), self.tet()
        return face, index, t, self.numbers(sum(index) + 3)

    def leaf(self):
        """(tetrahedron, corners, planes)"""
        return self.tet(), [self.numbers(3) for _ in range(4)], read_planes(self)

    def crossing(self):
        pieces = [Piece(self.face(), [self.numbers(3) for _ in range(3)], read_planes(self)) for _ in range(2)]
        at = [(Interval(self), Interval(self)) for _ in range(2)]
        return Crossing(pieces, at, [[self.zigzag() for _ in range(3)] for _ in range(3)])

READERS = {
    "tet-reversed": lambda b: b.tet(),
    "tet-face-overused": lambda b: (b.face(), b.face()),
    "cloud-degenerate": lambda b: (b.tet(), b.index(4)),
    "cloud-no-core": lambda b: (b.tet(), b.terms()),
    "cloud-inside": WitnessBody.hull,
    "jacobian": lambda b: b.numbers(3),
    "jacobian-zero": WitnessBody.leaf,
    "M4": lambda b: (b.vertex(), b.vertex()),
    "M6": lambda b: b.vertex(),
    "M7": lambda b: (b.face(), b.face(), b.numbers(3), b.numbers(3)),
    "M9": lambda b: (b.tet(), b.tet(), b.numbers(3)),
    "meeting": lambda b: (b.numbers(3), b.numbers(3)),
    "crossing": WitnessBody.crossing,
    "covering": lambda b: (b.leaf(), b.numbers(3)),
}

class Finding:
    """kind: of KINDS; witness: what its reader makes; planes: of each face of the boundary, if the kind is of the
    map."""

    def __init__(self, data, model):
        body = WitnessBody(data, model)
        if body.bytes(4) != MAGIC or body.count(0) != len(model.tetrahedra):
            raise Reject("B1", "magic, or another number of tetrahedra")
        self.kind = KINDS[body.u8(len(KINDS) - 1)]
        self.witness = READERS[self.kind](body)
        self.planes, self.rationals = [], body.rationals
        self.is_of_the_map = self.kind in OF_THE_MAP
        if self.is_of_the_map:
            num_faces = body.count(FACE_OF_LIST)
            if num_faces != len(boundary_of(model)):
                raise Reject("B1", "another number of faces")
            self.planes = [read_planes(body) for _ in range(num_faces)]
        body.end()

    def why_too_long(self, model):
        """Why B2 does not hold, or None."""
        if is_long([self.rationals], MAX_BITS):
            return "a number of the body is too long"
        return why_model_too_long(model) if self.is_of_the_map else None
