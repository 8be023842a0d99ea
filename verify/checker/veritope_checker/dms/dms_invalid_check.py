# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The claim dms-invalid-1: check() is called when the statement and the hashes are right.

Written from docs/certificates/dms-invalid.md and docs/formats/dms-files.md alone, and the pages that they quote.
"""
from ..common.errors import Reject
from .dms_domain import boundary_of, test_clouds, test_control, test_hulls, test_tetrahedra
from .dms_invalid_domain import TESTS
from .dms_invalid_map import MapFindings
from .dms_invalid_read import KINDS, Finding
from .dms_map import Map
from .dms_read import read_spline

def check(claim, statement, body, model, skip):
    """skip: conditions that are not tested, for tests only."""
    Checker(statement, body, model, skip).test()

class Checker:
    """The conditions in the order of the page."""

    def __init__(self, statement, body, model, skip):
        self.statement, self.skip, self.model = statement, skip, read_spline(model)
        self.finding = Finding(body, self.model)
        self.condition = "W%d" % KINDS.index(self.finding.kind)
        self.left = (1 << 24) + (len(model) + len(body) << 8)

    def fail(self, condition, why):
        if condition not in self.skip:
            raise Reject(condition, why)

    def spend(self, condition):
        self.left -= 1
        if self.left < 0:
            raise Reject(condition, "too much work")

    def test(self):
        why = self.finding.why_too_long(self.model)
        if why:
            self.fail("B2", why)
        for key, value in (("finding", self.finding.kind), ("tetrahedra", len(self.model.tetrahedra))):
            if self.statement[key] != value:
                self.fail("B3", "%s: %s in the body, %s in the statement" % (key, value, self.statement[key]))
        test = self.test_of(self.finding.kind)
        why = None if self.condition in self.skip else test(self.finding.witness)
        if why:
            self.fail(self.condition, why)

    def test_of(self, kind):
        """The function that says why W does not hold. Tests V1, if that is needed."""
        if not self.finding.is_of_the_map:
            return lambda witness: TESTS[kind](self.model, witness)
        spline = Map(self.model, lambda: self.spend(self.condition))
        self.test_map(spline)
        return MapFindings(spline, lambda: self.spend(self.condition)).tests[kind]

    def test_map(self, spline):
        """V1."""
        test_tetrahedra(spline, self.fail)
        boundary = boundary_of(self.model, self.fail)
        test_control(spline, self.fail)
        test_clouds(spline, self.fail)
        test_hulls(spline, boundary, self.finding.planes, self.spend, self.fail)
