#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""The Python checker of star-box certificates of version 2: units of work."""
import pathlib
import re
import unittest
from fractions import Fraction as Q

import star_box_2_models as models2
import star_box_forge as forge
from star_box_2_judged import OnAPlate, replaced, Box2, Prover2, units

from veritope_checker.patches import star_box_2_check as check, star_box_2_sheets as sheets, star_box_work as work


class Work(OnAPlate):
    def test_units_of_work_for_a_node(self):
        """Each number by hand from the table of star-box.md, section 6, and the end of section 6 of star-box-2.md."""
        box = Box2(0, units(-1, -1, -1), units(1, 1, 1), [[units(0, 0, -Q(1, 2)), units(0, 0, Q(1, 2))]] * 2 + [[units(0, 0, Q(1, 2)), units(0, 0, -Q(1, 2))]],
                   [(3, 64, [1] + [0] * 19), (1, 0, [-1] + [0] * 3)], [[2, 1], [2, 2], [1, 0]])
        square = forge.surface([[(x, y, 0) for y in (0, 1)] for x in (0, 1)])
        for degree, level, bits, s1, first, second in ((1, 0, 21, 1, 1 + (3 * 4 * 9 * 7 ** 2 >> 7), 1),
                                                       (15, 0, 24, 1 + (2025 * 24 >> 11), 1 + (3 * 256 * 961 * 7 ** 2 >> 7), 1 + (256 * 2 ** 2 >> 7)),
                                                       (15, 2, 84, 1 + (2025 * 84 >> 11), 1 + (3 * 256 * 961 * 10 ** 2 >> 7), 1 + (256 * 3 ** 2 >> 7))):
            prover = Prover2([models2.raised(square, degree)], checked=False)
            read, node, spent = prover.probe(box), prover.forest.roots[0], []
            for _ in range(level):
                node = node.children()[0]
            self.assertEqual((work.bits_at(node.patch, level), [s.length for s in read.separators]), (bits, [19 + 19 + 64, 19 + 19]))
            signs = sheets.Signs(read, spent.append)
            self.assertEqual(signs.sheet_of(node), None)
            self.assertEqual(spent, [s1, first, s1, s1, second])  # S1 fails for the last sheet: its signs are found last
            del spent[:]
            self.assertEqual(signs.sheet_of(node.children()[3]), None)
            self.assertEqual(spent, [work.of_s1(node.children()[3])] * 3)
            read.sheets[1] = read.sheets[1]._replace(signs=[1, -1])
            del spent[:]
            self.assertEqual(sheets.Signs(read, spent.append).sheet_of(node), 1)
            self.assertEqual(spent, [s1, first, s1, second])

    def test_units_of_work_for_a_separator_that_changes_its_sign(self):
        """Its coefficients on a node are a quarter of those on the parent, until they have one sign."""
        box = Box2(0, units(-1, -1, -1), units(1, 1, 1), [[units(0, 0, -Q(1, 2)), units(0, 0, Q(1, 2))]] * 2,
                   [(1, 0, [-1, 0, 0, 1])], [[1], [2]])   # x - 1/2
        square = forge.surface([[(x, y, 0) for y in (0, 1)] for x in (0, 1)])
        for degree, quarters in ((1, (2, 2)), (15, (2 + (256 * 30 >> 8), 2 + (256 * 30 >> 8)))):
            prover, spent = Prover2([models2.raised(square, degree)], checked=False), []
            read, node = prover.probe(box), prover.forest.roots[0]
            signs = sheets.Signs(read, spent.append)
            self.assertEqual(signs.sheet_of(node), None)
            first = node.children()[0]                    # touches x = 1/2
            for kid, expected, sheet in ((first, quarters[0], None), (first.children()[0], quarters[1], 1)):
                del spent[:]
                self.assertEqual(signs.sheet_of(kid), sheet)
                self.assertEqual(spent, [expected, work.of_s1(kid), work.of_s1(kid)])

    def test_units_of_work_for_hulls_curves_g_and_pairs(self):
        square = forge.surface([[(x, y, 0) for y in (0, 1)] for x in (0, 1)])
        for degree, hull, g, products in ((1, 2, 2, 1 + (4 * 9 * 4 >> 6)), (15, 2 + (256 * 30 * 54 >> 12), 2 + (2025 * 30 * 54 >> 11), 1 + (256 * 961 * 4 >> 6))):
            node = Prover2([models2.raised(square, degree)], checked=False).forest.roots[0].children()[3]
            self.assertEqual((work.of_hull(node), work.of_half_curve(node) // 16, work.of_g(node), work.of_products(node.patch), work.of_pair(node.patch, node.patch)),
                             (hull, hull, g, products, 4))
            node.patch.bits = 200
            self.assertEqual(work.of_pair(node.patch, node.patch), 4 + 9)
            node.patch.roots = [3, 5]
            self.assertEqual(work.bits_at(node.patch, 1), 200 + 2 * degree * 6)

    def test_the_bound_of_the_work(self):
        """Exactly the work that the certificate takes is enough."""
        plan, spent = self.plate.plan, []
        with replaced((check.Checker2, "check_values", lambda checker: spent.append(checker.forest.work) or {})):
            self.says("ACCEPT", self.plate, plan, skip={"replaced"})
        taken = work.allowed(len(self.plate.model) + len(plan.body())) - spent[0]
        self.assertTrue(0 < taken < 20 * len(plan.body()), taken)
        for most, expected in ((taken, "ACCEPT"), (taken - 1, "W1"), (0, "C1")):
            with replaced((work, "allowed", lambda _, most=most: most)):
                self.says(expected, self.plate, plan, skip={"replaced"})

    def test_both_checkers_and_the_page_state_one_bound(self):
        tree = pathlib.Path(__file__).resolve().parents[2]
        page = (tree / "docs/certificates/star-box.md").read_text(encoding="utf-8")
        cpp = (tree / "verify/checker/patches/star.h").read_text(encoding="utf-8")
        power, each = re.search(r"exceeds 2\^(\d+) \+ (\d+) \(bytes", page).groups()
        self.assertEqual((work.FREE_UNITS, work.UNITS_OF_BYTE), (1 << int(power), int(each)))
        self.assertEqual(re.search(r"kFreeUnits = 1 << (\d+), kUnitsOfByte = (\d+);", cpp).groups(), (power, each))

if __name__ == "__main__":
    unittest.main()
