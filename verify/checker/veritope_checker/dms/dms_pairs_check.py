# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim dms-solid-2: check() is called when the statement and the hashes are right.

Written from docs/certificates/dms-solid-2.md alone, and the pages that it quotes.
"""
from ..points.box_tree import BoxTree
from .dms_check import SolidChecker, first_against
from .dms_domain import owners_of
from .dms_map import box_of
from .dms_near import block_region, unexcluded
from .dms_pairs import Pairs
from .dms_pairs_body import PairsCertificate

def check(claim, statement, body, model, skip):
    """skip: conditions that are not tested, for tests only."""
    checker = PairsChecker(statement, body, model, skip)
    checker.test()
    checker.compare()

class PairsChecker(SolidChecker):
    """The conditions of dms-solid-2."""
    certificate = PairsCertificate

    def test(self):
        """Tests all conditions but W3."""
        self.test_map()
        self.owners = owners_of(self.model, self.boundary)
        self.test_blocks()
        self.test_owners()
        pairs = Pairs(self.spline, self.boundary, self.owners, self.cert, self.fail, self.spend)
        pairs.test()
        pairs.test_shells(self.of_domain["shells"], self.of_domain["bodies"])
        self.numbers.update(faces=len(self.boundary), **self.of_domain)

    # ------------------------------------------------------------ section 3

    def test_blocks(self):
        """U1 and U2."""
        places = [[self.spline.knots[v][0] for v in face] for face in self.boundary]
        tree = BoxTree([box_of(three) for three in places])
        for number, block in enumerate(self.cert.blocks):
            region = block_region(self.spline, block.tetrahedra, block.planes)
            for i in tree.meeting(box_of(region.corners), lambda: self.spend("U1")):
                if not region.misses_triangle(places[i]):
                    self.fail("U1", "the face %s of the boundary may meet block %d" % (self.boundary[i], number))
            near = unexcluded(self.spline, region, lambda: self.spend("U2"))
            against = first_against(block.matrix, self.spline, near)
            if against:
                self.fail("U2", "the derivative %s of tetrahedron %d in block %d" % (*against[::-1], number))

    def test_owners(self):
        """U3."""
        in_blocks = {t for block in self.cert.blocks for t in block.tetrahedra}
        for face, t in zip(self.boundary, self.owners):
            tree = self.cert.trees[t]
            if t not in in_blocks and (len(tree) > 1 or tree[0].is_p):
                self.fail("U3", "tetrahedron %d of the face %s is cut, and in no block" % (t, face))
