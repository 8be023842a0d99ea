# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim microstructure-1: check() is called when the statement and the hashes are right.

Written from docs/certificates/microstructure.md and docs/formats/micro-files.md alone, and the pages that they quote.
"""
from ..common.errors import Reject
from ..vmodel import vmodel_check
from .micro_body import Certificate
from .micro_bridges import test_bridges
from .micro_caps import Caps
from .micro_numbers import Glued
from .micro_read import Microstructure
from .micro_sweeps import test_sweeps
from .micro_tile import Tile
from .micro_walls import Meetings, lies_in_face, test_cells

def check(claim, statement, body, model, skip):
    """skip: conditions that are not tested, for tests only."""
    checker = Checker(statement, body, Microstructure(model), skip)
    checker.test()
    checker.compare()

class Checker:
    """The conditions in the order of the page. body: all of a certificate's body, or a part of another claim's. After
    test(): tiles, glued."""

    def __init__(self, statement, body, model, skip):
        self.statement, self.model, self.skip = statement, model, skip
        self.cert = Certificate(body, model)

    def fail(self, condition, why):
        if condition not in self.skip:
            raise Reject(condition, why)

    def test(self):
        """Tests all conditions but W3."""
        why = self.cert.why_too_long(self.model)
        if why:
            self.fail("B2", why)
        self.tiles = [Tile(*tile, proof, self.skip) for tile, proof in zip(self.model.tiles, self.cert.proofs)]
        grids, codes = self.model.grids, self.codes_of_cage()
        for tile in self.tiles:
            tile.test(self.statement)
        test_cells(grids, self.tiles, lambda grid, wall: codes[6 * grid.volume + wall] == 1
                   and lies_in_face(grid, wall, self.model.cage), self.skip)
        meetings = Meetings(grids, Caps(self.tiles, self.skip))
        meetings.find(self.model.cage, codes)
        self.glued = Glued(self.tiles, grids, meetings)
        test_bridges(self.model, self.cert.bridges, self.tiles, codes, self.glued, self.skip)
        test_sweeps(self.model, self.cert.sweeps, self.tiles, self.glued, self.skip)

    def numbers(self):
        """Those of section 8, after test()."""
        return {**self.glued.numbers(), "bridges": len(self.model.bridges) + len(self.model.sweeps)}

    def compare(self):
        """W3."""
        for key, value in self.numbers().items():
            if self.statement[key] != value:
                self.fail("W3", "%s are %s, the statement says %d" % (key, value, self.statement[key]))

    def codes_of_cage(self):
        """The codes of the faces of the cage's volumes, if the conditions of vmodel-1 hold but for W3."""
        cage = vmodel_check.Checker(self.statement, self.cert.cage, self.model.cage, self.skip)
        cage.numbers()
        return cage.cert.codes
