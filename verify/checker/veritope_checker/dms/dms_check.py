# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim dms-solid-1: check() is called when the statement and the hashes are right.

Written from docs/certificates/dms-solid.md and docs/formats/dms-files.md alone, and the pages that they quote.
"""
from ..common.errors import Reject
from ..common.vectors import cross, dot
from .dms_body import Certificate, Leaf
from .dms_domain import (boundary_of, numbers_of_surface, test_clouds, test_control, test_hulls, test_tetrahedra,
                         triangle_entity)
from .dms_map import Map, integer_rows
from .dms_near import derivatives, first_cut, leaf_region, unexcluded
from .dms_read import read_spline
from .dms_surface import Surface

EDGES = ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))

def check(claim, statement, body, model, skip):
    """skip: conditions that are not tested, for tests only."""
    checker = Checker(statement, body, model, skip)
    checker.test()
    checker.compare()

class SolidChecker:
    """The conditions up to J3, which all versions have, in the order of the page, and W3. certificate: the class that
    reads the body."""

    def __init__(self, statement, body, model, skip):
        self.statement, self.skip, self.model = statement, skip, read_spline(model)
        self.cert = self.certificate(body, self.model)
        self.left = (1 << 24) + (len(model) + len(body) << 8)

    def fail(self, condition, why):
        if condition not in self.skip:
            raise Reject(condition, why)

    def spend(self, condition, units=1):
        self.left -= units
        if self.left < 0:
            raise Reject(condition, "too much work")

    def test_map(self):
        """Tests B2 to J3; boundary: its faces; of_domain: numbers of the part; numbers: those that are known here."""
        why = self.cert.why_too_long(self.model)
        if why:
            self.fail("B2", why)
        self.stage = "J2"                                   # where values are computed
        self.spline = Map(self.model, lambda: self.spend(self.stage))
        test_tetrahedra(self.spline, self.fail)
        self.boundary = boundary_of(self.model, self.fail)
        if len(self.boundary) != len(self.cert.planes):
            raise Reject("B1", "another number of faces")
        self.of_domain = self.surface_numbers("D3", self.cert.domain, [
            triangle_entity(1, [self.model.clouds[v][0] for v in face]) for face in self.boundary])
        test_control(self.spline, self.fail)
        test_clouds(self.spline, self.fail)
        test_hulls(self.spline, self.boundary, self.cert.planes, self.spend, self.fail)
        self.test_leaves()
        self.numbers = {"tetrahedra": len(self.model.tetrahedra), "control_points": self.model.num_control,
                        "leaves": sum(type(node) is Leaf for node in self.cert.nodes())}

    def surface_numbers(self, name, data, entities):
        return numbers_of_surface(data, self.statement, entities, self.skip, name)

    def compare(self):
        """W3."""
        for key, value in self.numbers.items():
            if self.statement[key] != value:
                self.fail("W3", "%s are %d, the statement says %d" % (key, value, self.statement[key]))
            if self.of_domain.get(key, value) != value:
                self.fail("W3", "the domain has another number of %s" % key)

    # ------------------------------------------------------------ section 5

    def test_leaves(self):
        for t, tree in enumerate(self.cert.trees):
            root = self.spline.corners(t)
            stack = [root]
            for node in tree:
                corners = stack.pop()
                if type(node) is Leaf:
                    self.test_leaf(t, root, corners, node)
                    continue
                (i, j), share = EDGES[node[0]], node[1]
                middle = tuple((1 - share) * a + share * b for a, b in zip(corners[i], corners[j]))
                stack += ([middle if m == i else c for m, c in enumerate(corners)],
                          [middle if m == j else c for m, c in enumerate(corners)])

    def test_leaf(self, t, root, corners, leaf):
        a, b, c = leaf.matrix
        if dot(cross(a, b), c) <= 0:
            self.fail("J3", "det R is not positive in a leaf of tetrahedron %d" % t)
        region = leaf_region(self.spline, corners, root, leaf.planes)
        near = list(unexcluded(self.spline, region, lambda: self.spend("J2" if leaf.is_p else "J1")))
        if not leaf.is_p:
            against = first_against(leaf.matrix, self.spline, near)
            if against:
                self.fail("J1", "the derivative %s of tetrahedron %d in a leaf of %d" % (*against[::-1], t))
            return
        cut = first_cut(region, near, lambda: self.spend("J2"))
        if cut:
            return self.fail("J2", "knots %s of tetrahedron %d meet a leaf of %d" % (cut[1], cut[0], t))
        if not all(is_definite(leaf.matrix, d) for d in derivatives(self.spline, corners, near)):
            self.fail("J2", "a coefficient of the derivative in a leaf of tetrahedron %d" % t)

class Checker(SolidChecker):
    """The conditions of dms-solid-1."""
    certificate = Certificate

    def test(self):
        """Tests all conditions but W3."""
        self.test_map()
        surface = Surface(self.spline, self.boundary, self.cert, self.fail, self.spend)
        surface.test_tiling()
        self.stage = "T3"
        entities = list(surface.entities())
        self.numbers.update(patches=len(entities), **self.surface_numbers("T3", self.cert.surface, entities))

def first_against(matrix, spline, near):
    """(tetrahedron, gamma) of a V_gamma, of unexcluded(), for whose derivative G the symmetric part of R G is not
    positive definite, or None. matrix: R."""
    matrix = integer_rows(matrix)
    for t, gamma, _ in near:
        if not is_definite(matrix, spline.affine(t, gamma)[0]):
            return t, gamma
    return None

def is_definite(matrix, derivative):
    """Whether R G + (R G)^T is positive definite."""
    product = [[dot(row, column) for column in zip(*derivative)] for row in matrix]
    (a, b, c), (_, d, e), (_, _, f) = [[product[i][j] + product[j][i] for j in range(3)] for i in range(3)]
    return a > 0 and a * d > b * b and a * (d * f - e * e) - b * (b * f - e * c) + c * (b * e - d * c) > 0
