# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim patch-invalid-2: check() is called when the statement and the hashes are right.

Written from docs/certificates/patch-invalid-2.md alone (and the pages of version 1 and star-box.md, where it quotes
them).  All numbers are integers or fractions; a point is homogeneous, (P, w) with w > 0.
"""
from fractions import Fraction

from ..common.errors import Reject
from .patch_invalid_check import FindingChecker, Patches, tensor_net, value_at
from .star_box_2_read import read_entities
from .model_subject import read_subject
from .star_box_patches import glue
from .star_box_read import Body

BYTES_OF_PATCH = 3                      # of the model and the body, where all patches are cut; star-box.md, B1

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

def sides_at(patch, at):
    """The sides on which the point with these parameters lies: pairs (side, parameter in its own direction)."""
    if patch.is_tensor:
        u, v = at
        sides = (0, u, v), (1, v, 1 - u), (2, 1 - u, 1 - v), (3, 1 - v, u)
        return [(side, t) for side, t, away in sides if away == 0]
    s, t = at
    weights = 1 - s, s * (1 - t), s * t                     # barycentric: a point of side e has weight 0 at corner e
    return [(e, weights[(e + 2) % 3]) for e in range(3) if weights[e] == 0]

def point_of_x(place, patch, vertex_of):
    """The point of X at a place, as a tuple: equal tuples are one point.  patch: the place's, glued; vertex_of: as
    glue() returns it."""
    for side, t in sides_at(patch, place.at):
        if patch.sides[side] is None:                       # collapsed: both its ends are one vertex
            t = 0
        if t in (0, 1):
            return "vertex", vertex_of[4 * place.patch + patch.corner(side, int(t))]
        edge, is_first = patch.sides[side]
        is_reversed = bool(patch.flag) == is_first          # against the direction of travel of the edge's first side
        return "edge", edge, 1 - t if is_reversed else t
    return "open domain", place.patch, place.at

class Checker(FindingChecker):
    def __init__(self, magic, statement, data, entities, skip):
        super().__init__(statement, entities, skip)
        body = Body(data)
        self.most_patches = (statement["subject_bytes"] + len(data)) // BYTES_OF_PATCH
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
        if not self.has_reason_a() and "M1" not in self.skip:
            self.check_reason_b()

    def has_reason_a(self):
        """Whether A is in the open domain of its patch, and B is another place, not the first corner of a triangle."""
        a, b = self.a, self.b
        is_first_corner = not self.patches[b.patch].is_tensor and b.at[0] == 0
        return all(0 < t < 1 for t in a.at) and not is_first_corner and (a.patch, a.at) != (b.patch, b.at)

    def check_reason_b(self):
        """P1 holds, and A and B are different points of X; tests B2 for the lengths of all patches, too."""
        if self.patches.count > self.most_patches:
            self.fail("M1", "too many patches for so few bytes: %d" % self.patches.count)
        patches = [self.patches[n] for n in range(self.patches.count)]
        _, _, _, vertex_of = glue(patches, lambda condition, why: self.fail("M1", "%s: %s" % (condition, why)))
        point, other = [point_of_x(place, patches[place.patch], vertex_of) for place in (self.a, self.b)]
        if point == other:
            self.fail("M1", "A and B are one point of the surface: %s %d" % point[:2])

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
