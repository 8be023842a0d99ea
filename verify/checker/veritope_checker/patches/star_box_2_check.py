# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claims star-box-2 and star-box-turned-2: check() is called when the statement and the hashes are right.

Written from docs/certificates/star-box-2.md alone, and star-box.md, whose conditions hold where that page replaces
nothing.  All numbers are integers or fractions.
"""
from . import star_box_check
from .star_box_2_flat import polygon_of
from .star_box_2_read import Certificate2
from .star_box_2_sheets import Signs
from .star_box_crossing import Crossing
from .model_subject import read_subject
from .star_box_nodes import misses_box
from .star_box_triangles import Flat

def check(claim, statement, body, model, skip):
    """skip: conditions that are not tested, for tests only."""
    Checker2(claim.magic, statement, body, read_subject(model, statement["subject_format"]), skip).run()


class Checker2(star_box_check.Checker):
    certificate, no_walks = Certificate2, "mesh box or a box with several sheets"

    def __init__(self, *args):
        super().__init__(*args)
        self.flat = {}                                      # the triangles of patches, by their numbers

    def check_star_box(self, i, box):
        pieces = [[] for _ in box.sheets]
        signs = Signs(box, lambda units: self.forest.spend("C2", units))

        def take(node):
            self.forest.spend_on_g("C2", node)
            sheet = signs.sheet_of(node)
            if sheet is None and "C2" in self.skip:
                sheet = 0
            if sheet is not None:
                pieces[sheet].append(node)
            return sheet is not None

        self.forest.descend(misses_box(box), "C2", take, box.frame)
        for n, (sheet, nodes) in enumerate(zip(box.sheets, pieces)):
            number = Crossing(nodes, sheet, lambda units: self.forest.spend("C2", units)).number()
            if number != 1:
                self.fail("C3", "the crossing number of sheet %d of box %d is %d" % (n, i, number))

    def triangles_of(self, patch):
        if patch.index not in self.flat:
            self.flat[patch.index] = self.cut(patch, polygon_of(patch))
        return self.flat[patch.index]

    def cut(self, patch, corners):
        """The triangles of a flat patch; () if it has no polygon."""
        if corners is None:
            return ()
        sides = [side[0] for side in patch.sides]
        if len(corners) == 3:
            return [self.triangle(patch, corners, (0, 1, 2), sides)]
        diagonal = "the diagonal of patch %d" % patch.index
        return [self.triangle(patch, corners, (0, 1, 2), [*sides[:2], diagonal]),
                self.triangle(patch, corners, (0, 2, 3), [*sides[2:], diagonal])]

    def triangle(self, patch, corners, at, edges):
        vertices = [self.vertex_of[4 * patch.index + i] for i in at]
        return Flat(patch.index, [corners[i] for i in at], vertices, set(edges))

    def may_walk(self, box):
        return len(box.sheets) == 1
