# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim patch-invalid-2: check() is called when the statement and the hashes are right.

Written from docs/certificates/patch-invalid-2.md alone (and the pages of version 1 and star-box.md, where it quotes
them).  All numbers are integers or fractions; a point is homogeneous, (P, w) with w > 0.
"""
from fractions import Fraction

from ..common.errors import Reject
from .patch_invalid_check import FindingChecker, Patches, tensor_net, value_at
from .star_box_2_read import read_entities
from .star_box_itd import read_subject
from .star_box_read import Body

def check(claim, statement, body, model, skip):
    Checker(claim.magic, statement, body, read_subject(model, statement["subject_format"]), skip).run()

def read_number(body):
    n, d = body.varint(), body.varint()
    if d == 0 or n > d:
        raise Reject("B1", "the number %d/%d is not in [0, 1]" % (n, d))
    return Fraction(n, d)

class Place:
    """A point of a patch, given by its parameters: A or B."""

    def __init__(self, body, patches):
        self.patch, self.at = patches.number(body.varint()), (read_number(body), read_number(body))

class Checker(FindingChecker):
    def __init__(self, magic, statement, data, entities, skip):
        super().__init__(statement, entities, skip)
        body = Body(data)
        self.flags, breaks = read_entities(body, magic, entities)
        self.patches = Patches(entities, self.flags, breaks)
        self.a, self.b = Place(body, self.patches), Place(body, self.patches)
        body.end()

    def run(self):
        self.check_entities()
        self.make_patches((self.a.patch, self.b.patch))
        self.check_statement()
        self.check_places()
        self.check_points()

    def check_places(self):
        """Tests M1."""
        a, b = self.a, self.b
        if not all(0 < t < 1 for t in a.at):
            self.fail("M1", "A is not in the open domain of its patch")
        if not self.patches[b.patch].is_tensor and b.at[0] == 0:
            self.fail("M1", "B is the first corner of a triangle")
        if (a.patch, a.at) == (b.patch, b.at):
            self.fail("M1", "A and B are one place")

    def check_points(self):
        """Tests M2."""
        (*p, w), (*q, z) = self.point(self.a), self.point(self.b)
        for axis, x, y in zip("xyz", p, q):
            if x * z != y * w:
                self.fail("M2", "A and B have different %s" % axis)

    def point(self, place):
        """The homogeneous point (x, y, z, w) at a place, times a factor > 0."""
        (s, t), net = [(c.numerator, c.denominator) for c in place.at], tensor_net(self.patches[place.patch])
        return [value_at([value_at(row, *t) for row in rows], *s) for rows in net]
