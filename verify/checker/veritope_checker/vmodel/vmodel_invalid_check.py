# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim vmodel-invalid-1: check() is called when the statement and the hashes are right.

Written from docs/certificates/vmodel-invalid.md alone, and the pages that it quotes.
"""
from ..common.errors import Reject
from ..common.vectors import dot
from ..patches.model_subject import read_volumes
from ..patches.star_box_work import allowed
from ..patches.volume_folded_check import box_of, sign_at, vector_at
from .vmodel_invalid_read import Finding
from .vmodel_nonmanifold import Boundary
from .vmodel_pieces import interval, piece_on
from .vmodel_read import MAX_CELLS, MAX_DEGREE
from .vmodel_sign import determinant, of_determinant

def check(claim, statement, body, model, skip):
    """skip: conditions that are not tested, for tests only."""
    Checker(statement, body, read_volumes(model, statement["subject_format"]), skip).run()

class Checker:
    """The conditions in the order of the page."""

    def __init__(self, statement, body, volumes, skip):
        self.statement, self.volumes, self.skip = statement, volumes, skip
        self.finding = Finding(body, volumes)
        self.work = allowed(statement["subject_bytes"] + len(body))

    def fail(self, condition, why):
        if condition not in self.skip:
            raise Reject(condition, why)

    def unless_skipped(self, test, *arguments):
        try:
            test(*arguments)
        except Reject as rejection:
            self.fail(rejection.condition, rejection.why)

    def spend(self, units):
        self.work -= units
        if self.work < 0:
            self.fail("B2", "too much work")

    def run(self):
        self.test_limits()
        finding = self.finding
        for key, value in (("finding", finding.kind), ("cells", len(self.volumes))):
            if self.statement[key] != value:
                self.fail("B3", "%s is %s" % (key, value))
        if finding.kind == "flat":
            self.test_flat()
        elif finding.kind == "overlap":
            self.test_overlap()
        elif finding.points:
            self.test_sign()
        else:
            boundary = Boundary(self.volumes, self.fail, self.spend, self.unless_skipped)
            if finding.arcs:
                boundary.test_arcs(finding.arcs)
            else:
                boundary.test_point(*finding.corner)

    def test_limits(self):
        """B2, but for what is tested when something is cut or compared."""
        if len(self.volumes) > MAX_CELLS:
            self.fail("B2", "too many cells")
        for n, volume in enumerate(self.volumes):
            if max(volume.degrees) > MAX_DEGREE:
                self.fail("B2", "cell %d has a degree over %d" % (n, MAX_DEGREE))
        self.controls = [box_of(at, self.volumes[cell], self.fail) for cell, at in self.finding.points]

    # ------------------------------------------------------------ section 3

    def piece(self, place):
        volume = self.volumes[place.cell]
        return piece_on(volume, [interval(volume, axis, at.lo, at.hi, self.spend) for axis, at in enumerate(place.at)],
                        self.spend)

    def test_flat(self):
        place, = self.finding.boxes
        piece, rational = self.piece(place), self.volumes[place.cell].rational
        self.spend(of_determinant(piece, rational))
        if any(determinant(piece, rational)[0]):
            self.fail("F1", "N is not 0 on the piece")

    def test_sign(self):
        condition, expected = ("H1", -1) if self.finding.kind == "left-handed" else ("Z1", 0)
        found = sign_at(self.finding.points[0].at, self.controls[0])
        if found != expected:
            self.fail(condition, "the Jacobian determinant is %s" % ("0", "positive", "negative")[found])

    def test_overlap(self):
        a, b = self.finding.points + self.finding.boxes
        for axis, (t, knots) in enumerate(zip(a.at, self.volumes[a.cell].knots)):
            if t.at in (knots[0], knots[-1]):
                self.fail("O1", "the parameter of A along axis %d is an end" % axis)
        if a.cell == b.cell and not any(map(self.differ, a.at, b.at)):
            self.fail("O2", "A and B may be one point")
        *q, weight = vector_at(a.at, self.controls[0])
        if self.finding.y is None:
            *r, z = vector_at(b.at, self.controls[1])
            if any(x * z != y * weight for x, y in zip(q, r)):
                self.fail("O3", "A and B are different points of space")
        else:
            self.test_faces(self.piece(b), q, weight)

    def differ(self, t, u):
        """Is A's parameter not that of B, or not in that interval?"""
        return not u.lo <= t.at <= u.hi if self.finding.boxes else t.at != u.at

    def test_faces(self, piece, q, weight):
        """O4."""
        for axis, y in enumerate(self.finding.y):
            of_q = dot(y, q)
            for end, sign in ((0, -1), (1, 1)):
                for row in piece.face(axis, end):
                    for *p, w in row:
                        if sign * (weight * dot(y, p) - w * of_q) <= 0:
                            return self.fail("O4", "row %d has a wrong sign at the %s of axis %d"
                                             % (axis + 1, ("begin", "end")[end], axis))
