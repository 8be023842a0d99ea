# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim vmodel-1: check() is called when the statement and the hashes are right.

Written from docs/certificates/vmodel.md alone, and the pages that it quotes.
"""
from ..common.errors import Reject
from ..patches.model_faces import PARAMETERS, face_of
from ..patches.model_subject import read_volumes
from ..patches.star_box_2_check import Checker2
from ..patches.star_box_work import allowed
from .vmodel_glue import Faces, Gluing, count_classes, test_edges
from .vmodel_pieces import pieces_of
from .vmodel_read import PLAIN, Certificate
from .vmodel_sign import SignTest

def check(claim, statement, body, model, skip):
    """skip: conditions that are not tested, for tests only."""
    Checker(statement, body, read_volumes(model, statement["subject_format"]), skip).run()

class Checker:
    """The conditions in the order of the page. body: all of a certificate's body, or a part of another claim's."""

    def __init__(self, statement, body, volumes, skip):
        self.statement, self.volumes, self.skip, self.boundary = statement, volumes, skip, None
        self.cert = Certificate(body, volumes)
        self.work = allowed(statement["subject_bytes"] + len(body))

    def unless_skipped(self, test, *arguments):
        try:
            return test(*arguments)
        except Reject as rejection:
            if rejection.condition not in self.skip:
                raise
            return None

    def spend(self, condition):
        def spend(units):
            self.work -= units
            if self.work < 0:
                raise Reject(condition, "too much work")
        return spend

    def run(self):
        numbers = self.numbers()
        self.boundary.compare(numbers)

    def numbers(self):
        """Tests the conditions from V1 to W2; returns the numbers of section 7."""
        cert = self.cert
        faces = [Faces(volume) for volume in self.volumes]
        self.unless_skipped(self.test_codes, faces)
        gluing = Gluing(cert.codes, cert.flags, cert.breaks)
        number = 0
        for cell, volume in enumerate(self.volumes):
            counts = [len(b) - 1 for b in cert.breaks[cell]]
            for piece in pieces_of(volume, cert.breaks[cell], self.spend("B2")):
                self.unless_skipped(test_edges, piece, counts, faces[cell])
                self.unless_skipped(self.test_sign, number, cell, piece)
                gluing.see(cell, piece, counts)
                number += 1
        self.unless_skipped(gluing.test_pairs)
        return self.with_x(self.counts(faces, gluing.pairs))

    def test_codes(self, faces):
        for f, code in enumerate(self.cert.codes):
            if (code == 1) != bool(faces[f // 6].collapse[f % 6]):
                raise Reject("V1", "face %d is collapsed %s" % (f, faces[f // 6].collapse[f % 6]))

    def test_sign(self, number, cell, piece):
        breaks = self.cert.breaks[cell]

        def may_vanish(axis, end):
            is_outer = piece.index[axis] == end * (len(breaks[axis]) - 2)
            return is_outer and self.cert.codes[6 * cell + 2 * axis + end] in (0, 1)

        SignTest(piece, self.cert.entries.get(number, PLAIN), self.cert.flags[cell], self.volumes[cell].rational,
                 may_vanish, self.spend("V2")).run()

    def counts(self, faces, pairs):
        halves = sum(code != 1 for code in self.cert.codes)
        surfaces = halves - len(pairs)
        points, curves = count_classes(faces, pairs)
        euler = points - curves + surfaces - len(self.volumes)
        return {"cells": len(self.volumes), "pieces": self.cert.num_pieces, "half_v_surfaces": halves,
                "v_surfaces": surfaces, "v_curves": curves, "v_points": points,
                "euler": 2 * euler if euler >= 0 else -2 * euler - 1, "reversed": sum(self.cert.flags),
                "singular": sum(len(entry.zeros) for entry in self.cert.entries.values())}

    def with_x(self, counts):
        """Section 6; these numbers and those of X."""
        entities, breaks = [], []
        for f, code in enumerate(self.cert.codes):
            if code == 0:
                cell, axis, end = f // 6, f % 6 // 2, f % 2
                axes = PARAMETERS[axis][end][::-1 if self.cert.flags[cell] else 1]
                entities.append(face_of(self.volumes[cell], axis, end, axes))
                breaks.append([self.cert.breaks[cell][a] for a in axes])
        self.boundary = Boundary(self.statement, self.cert.rest, entities, self.skip)
        of_x = self.boundary.tested(breaks)
        return {**counts, **{key: of_x[key] for key in ("patches", "shells", "bodies", "genus", "boxes")}}

class Boundary(Checker2):
    """X: the conditions of star-box-2 for the last part of the body."""

    def __init__(self, statement, body, entities, skip):
        super().__init__(b"VTS2", statement, body, entities, skip)

    def tested(self, breaks):
        """The numbers of X, of which all conditions but W3 hold."""
        self.make_patches()
        if any(self.cert.flags) or self.cert.breaks != breaks:
            self.fail("V4", "a face of X is reversed, or has other breaks than its cell")
        return self.numbers()
