#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The C++ checker of collar certificates against the Python one, whose tests it runs: same exit code, same condition."""
import unittest

import judges
import collar_test as python_tests

judges.judge(python_tests.vc)
Collars, Lies, Knot, Hostile = python_tests.Collars, python_tests.Lies, python_tests.Knot, python_tests.Hostile


class Cpp(python_tests.CollarTest):
    """What only this checker limits."""

    def far(self, collar, plan):
        code, condition, text = judges.in_cpp(collar.model, plan.certificate(collar.model))
        self.assertEqual((code, condition, "far" in text), (1, "B1", True), text)

    def test_coordinates_of_more_than_61_bits_are_refused_by_name(self):
        collar = python_tests.forge.Collar(python_tests.proved("cube", python_tests.models.cube), (-2,) * 3, 2, 1)
        collar.build(collar.cells_at(3))
        self.says("ACCEPT", collar)
        for shift, least in ((41, 1 << 20), (42, -(1 << 19)), (62, 1), (4096, 0), (0, (1 << 61) - (1 << 20)), (0, -(1 << 61)), (0, (1 << 63) - 1)):
            self.far(collar, self.changed(collar, shift=shift, least=[0, least, 0]))
        for point in ((1 << 61, 0, 0), (0, 0, -(1 << 61))):
            self.far(collar, self.changed(collar, shores=[([point], 1), *collar.plan.shores[1:]]))


if __name__ == "__main__":
    unittest.main()
