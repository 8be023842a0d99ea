# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The body of a certificate of a simplex-spline solid, version 2 (docs/certificates/dms-solid-2.md, section 2): B1 and
B2."""
from collections import namedtuple

from ..common.errors import Reject
from ..patches.star_box_read import Body
from .dms_body import LEAF, SolidCertificate, counted, read_matrix, read_part, read_planes, read_tree

MAGIC = b"VTD2"
FACE, BLOCK, MEMBER, PAIR, EDGE = 1, 21, 1, 9, 2            # least sizes, in bytes; MEMBER: a block's tetrahedron
VALUES, CHAIN, FOLD = 0, 1, 2                               # kinds of pairs
MAX_MEMBERS, MAX_PLANES = 16, 64                            # of a block

# i < j: faces of the boundary.  directions: one or two.  vertices, tetrahedra: of a chain.  feet: a and b.
Pair = namedtuple("Pair", "i j kind vertices tetrahedra feet directions")

class Block:
    """tetrahedra: their numbers; matrix: three rows; planes: (vector, number) each."""

    def __init__(self, body, model):
        those = [body.number(model.tetrahedra, "tetrahedron") for _ in range(counted(body, MEMBER))]
        if not 0 < len(those) <= MAX_MEMBERS or any(a >= b for a, b in zip(those, those[1:])):
            raise Reject("B1", "a block of no or too many tetrahedra, or not in ascending order")
        self.tetrahedra, self.matrix, self.planes = those, read_matrix(body), read_planes(body)
        if len(self.planes) > MAX_PLANES:
            raise Reject("B1", "a block with too many planes")

class PairsBody(Body):
    """A cursor over a body of version 2."""

    def number(self, those, what):
        """The number of one of those."""
        number = self.varint()
        if number >= len(those):
            raise Reject("B1", "there is no %s %d" % (what, number))
        return number

    def rationals(self, count):
        return [self.rational() for _ in range(count)]

    def pair(self, faces, model):
        i, j, kind = self.number(faces, "face"), self.number(faces, "face"), self.u8(FOLD)
        vertices, tetrahedra = self.chain(model) if kind == CHAIN else ((), ())
        feet = self.rationals(2) if kind == FOLD else []
        if not all(0 <= foot <= 1 for foot in feet):
            raise Reject("B1", "a foot is not on its edge")
        directions = [self.rationals(3) for _ in range(2 if kind == FOLD else 1)]
        return Pair(i, j, kind, vertices, tetrahedra, feet, directions)

    def chain(self, model):
        """(vertices, tetrahedra)"""
        edges = counted(self, EDGE)
        return ([self.number(model.clouds, "vertex") for _ in range(edges + 1)],
                [self.number(model.tetrahedra, "tetrahedron") for _ in range(edges)])

class PairsCertificate(SolidCertificate):
    """blocks, pairs: in order."""

    def __init__(self, data, model):
        body = PairsBody(data)
        if body.bytes(4) != MAGIC or body.count(LEAF) != len(model.tetrahedra):
            raise Reject("B1", "magic, or another number of tetrahedra")
        num_faces, num_blocks, num_pairs = body.count(FACE), body.count(BLOCK), body.count(PAIR)
        self.trees = [read_tree(body) for _ in model.tetrahedra]
        self.planes = [read_planes(body) for _ in range(num_faces)]
        self.blocks = [Block(body, model) for _ in range(num_blocks)]
        self.pairs = [body.pair(self.planes, model) for _ in range(num_pairs)]
        self.domain = read_part(body)
        body.end()
        places = [(pair.i, pair.j) for pair in self.pairs]
        if any(i >= j for i, j in places) or any(a >= b for a, b in zip(places, places[1:])):
            raise Reject("B1", "the faces of a pair, or the pairs, are not in ascending order")

    def words(self):
        yield from super().words()
        for block in self.blocks:
            yield from block.matrix
        for pair in self.pairs:
            yield from (pair.feet, *pair.directions)

    def holders(self):
        yield from super().holders()
        yield from (block.planes for block in self.blocks)
