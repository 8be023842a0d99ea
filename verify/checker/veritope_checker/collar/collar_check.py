# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claims collar-1 and collar-2: check() is called when the statement and the hashes are right.

Written from docs/certificates/collar.md and collar-2.md alone (and star-box.md, where it is quoted).  Integers only.
"""
from collections import Counter

from ..common.errors import Reject
from ..patches import star_box_2_check, star_box_check
from ..patches.model_subject import read_subject
from ..patches.star_box_2_read import Certificate2
from ..patches.star_box_nodes import root_nodes
from ..patches.star_box_read import MAX_DEPTH, Certificate
from .collar_complex import FULL, LEVELS, MAX_CELLS, Cells, Complex

UNITS = 2000                            # of work for each leaf and cell

def check(claim, statement, body, model, skip):
    checker = Checker2 if claim.name == "collar-2" else Checker
    checker(claim.magic, statement, body, read_subject(model, statement["subject_format"]), skip).run()

class CollarBody:
    """Reads what follows the walks: section 2."""

    def read_rest(self, body):
        shift = body.shift()
        self.step, self.least = 1 << shift, [body.zigzag() << shift for _ in range(3)]
        self.codes = [0]
        for _ in range(body.count(1)):
            difference = body.varint()
            if difference == 0:
                raise Reject("B1", "a code twice")
            self.codes.append(self.codes[-1] + difference)
        del self.codes[0]
        if not self.codes:
            raise Reject("B1", "no cell")
        self.sides = [body.u8() for _ in range(body.count(1))]
        if len(self.codes) > body.left():
            raise Reject("B1", "more collapses than the body has room for")
        self.collapses, face = [], 0
        for _ in self.codes:
            face += body.zigzag()
            self.collapses.append(face)
        self.finer = [[self.with_finer(body, tree) for tree in trees] for trees in self.trees]
        self.shores = [self.way(body) for _ in self.sides]

    def with_finer(self, body, tree):
        """Replaces each leaf of a tree by the tree that the body has for it: True for a node with children, False for a
        leaf."""
        result, levels = [], [0]
        for box in tree:
            level = levels.pop()
            if box is None:
                levels += [level + 1] * 4
                result.append(True)
                continue
            below = [level]
            while below:
                level = below.pop()
                result.append(body.u8(1) == 0)
                if result[-1]:
                    if level == MAX_DEPTH:
                        raise Reject("B1", "a tree is too deep")
                    below += [level + 1] * 4
        return result

class CollarCertificate(CollarBody, Certificate):
    pass

class CollarCertificate2(CollarBody, Certificate2):
    pass

class CollarConditions:
    """K0 to K3 and I1 to I4, after the conditions of star boxes."""

    def run(self):
        super().run()
        cert = self.cert
        if not len(cert.codes) == self.statement["cells"] <= MAX_CELLS:
            self.fail("K0", "%d cells, the statement says %d" % (len(cert.codes), self.statement["cells"]))
        cells = Cells(cert.codes, self.statement["cells"])
        complex_ = Complex(cells)
        self.unless(complex_.bad_edge(), "K1E")
        self.unless(complex_.bad_vertex(), "K1V")
        if len(cert.sides) != complex_.num_components or max(cert.sides) > 1:
            raise Reject("K2", "%d sides for %d components of the boundary, or one is neither 0 nor 1" %
                         (len(cert.sides), complex_.num_components))
        self.unless(complex_.bad_sides(cert.sides), "K2")
        if "K3" not in self.skip:
            self.unless(complex_.bad_collapse(cert.sides, cert.collapses), "K3")
        leaves = sum(tree.count(False) for trees in cert.finer for tree in trees)
        self.forest.work = UNITS * (leaves + len(cert.codes) + 100)
        body_of = self.check_places(cells, complex_)
        self.check_chi(complex_, body_of)
        self.check_shores(complex_)

    def unless(self, why, condition):
        if why:
            self.fail(condition, why)

    # ------------------------------------------------------------ I1, I2

    def check_places(self, cells, complex_):
        """I1 and I2: the component of |K| for each component of X."""
        bodies, split = {}, None
        for patch, trees in zip(self.patches, self.cert.finer):
            for node in self.leaves_of(patch, trees):
                met = {complex_.body_of[i] for i in self.cells_met(cells, node)}
                bodies.setdefault(patch.component, set()).update(met)
                if len(met) != 1:
                    split = split or "a leaf of patch %d meets %d components of K" % (patch.index, len(met))
        for component, of in bodies.items():
            if len(of) != 1:
                split = split or "component %d of the surface lies in %d components of K" % (component, len(of))
        self.unless(split, "I2")
        times = Counter(body for of in bodies.values() for body in of)
        if sorted(times) != list(range(complex_.num_bodies)) or set(times.values()) != {1}:
            self.fail("I2", "components of K and of the surface do not correspond")
        return {component: min(of, default=0) for component, of in bodies.items()}

    def leaves_of(self, patch, trees):
        for root, tree in zip(root_nodes(patch), trees):
            stack = [root]
            for has_children in tree:
                node = stack.pop()
                self.forest.spend("I1")
                if has_children:
                    stack += node.children()[::-1]
                    node.kids = None
                else:
                    yield node

    def cells_met(self, cells, node):
        """I1: the cells of K that the hull of a leaf meets."""
        least, step, lo, hi, met = self.cert.least, self.cert.step, [], [], []
        for (a, m), (b, n), c in zip(*node.hull(), least):
            if a <= c * m or b >= (c + FULL * step) * n:
                self.fail("I1", "a leaf of patch %d is not in the open root" % node.patch.index)
            lo.append(-((c * m - a) // (m * step)))         # up, since the corners of cells are integers
            hi.append((b - c * n) // (n * step))            # down
        stack = [(LEVELS, 0, 0, 0, 0)]
        while stack:
            level, m, x, y, z = stack.pop()
            self.forest.spend("I1")
            size = 1 << level
            if x + size < lo[0] or x > hi[0] or y + size < lo[1] or y > hi[1] or z + size < lo[2] or z > hi[2]:
                continue
            code = 2 * m + 1 << 3 * level
            if code in cells.index:
                met.append(cells.index[code])
            elif level == 0 or not cells.any_inside(code, size):
                self.fail("I1", "a leaf of patch %d meets the cell of size %d at %s, which is not in K"
                          % (node.patch.index, size, (x, y, z)))
            else:
                half = size >> 1
                stack += [(level - 1, 8 * m + i, x + (i & 1) * half, y + (i >> 1 & 1) * half, z + (i >> 2) * half)
                          for i in range(8)]
        return met

    # ------------------------------------------------------------ I3, I4

    def check_chi(self, complex_, body_of):
        outer = {complex_.body_of_component[c]: c for c, side in enumerate(self.cert.sides) if side == 1}
        for component, body in body_of.items():
            if body in outer and complex_.chi(outer[body]) != self.chi[component]:
                self.fail("I3", "chi of component %d is %d, of its collar's side %d" %
                          (component, self.chi[component], complex_.chi(outer[body])))

    def check_shores(self, complex_):
        cert, values = self.cert, [[] for _ in range(complex_.num_bodies)]
        for component, (points, end, direction) in enumerate(cert.shores):
            if end and not self.may_walk(cert.boxes[end[0]]):
                raise Reject("I4", "shore %d ends at a %s" % (component, self.no_walks))
            start = [a + b * cert.step for a, b in zip(cert.least, complex_.least_vertex(component))]
            self.follow(start, points, end, direction, "I4")
            w = self.inner[cert.boxes[end[0]].component] - end[1] if end else 0
            values[complex_.body_of_component[component]].append(w)
        for body, of in enumerate(values):
            if sorted(of) != [0, 1]:
                self.fail("I4", "w is %s on the boundary components of component %d of K" % (sorted(of), body))

class Checker(CollarConditions, star_box_check.Checker):
    certificate = CollarCertificate

class Checker2(CollarConditions, star_box_2_check.Checker2):
    certificate = CollarCertificate2
