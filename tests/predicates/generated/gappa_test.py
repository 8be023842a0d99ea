#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Runs Gappa on docs/bounds/gappa/*.g: each is proved; a script whose constant is halved, or one unit in the last place smaller, is not.

gappa_test.py          the scripts of the constants (seconds)
gappa_test.py --boxes  the rounded programs on a box, too

coq_proofs.py has the same proofs checked by Coq.

Without gappa nothing is proved: exit 77, which CTest reports as skipped.
"""
import argparse
import math
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
SCRIPTS = ROOT / "docs" / "bounds" / "gappa"
PRECISION = ("-Eprecision=256", "-Eno-auto-dichotomy")  # products of 40 factors 1 + d, |d| <= 2^-53; no splitting where nothing depends on cases
REL = re.compile(r"(?m)^kRel = (\S+);$")
BOUND = re.compile(r"(?<=\|det - det_exact\| <= )\S+")
NO_GAPPA = 77
SKIPPED = "gappa is not installed (Debian: gappa): no script was proved"


def gappa(text, *options):
    """(proved, output)"""
    done = subprocess.run(["gappa", *options], input=text, capture_output=True, text=True, timeout=300, check=False)
    return done.returncode == 0, done.stdout + done.stderr


def constants():
    """{name of a script: the constant as the code has it}"""
    found = {}
    for path in SCRIPTS.glob("*.formula"):
        name, header = re.search(r"(?m)^constant +(\w+) in (\S+)$", path.read_text()).groups()
        found[path.stem] = re.search(rf"\b{name}\s*=\s*(0x\S+?)[,;]", (ROOT / header).read_text())[1]
    for path in (ROOT / "predicates" / "generated").glob("*.formula"):
        header = path.with_suffix(".h").read_text()
        found[path.stem] = re.search(r"double k\w+Rel = (0x\S+);", header)[1]
    return found


# No constants of filters: these pages list decisions, count roundings by running the code itself on counts, have constants that a
# test derives again in rationals, or bound nets whose degrees are data.
COUNTED = {"box_bounds", "composition", "decisions", "fast_dms", "fast_spline", "jacobian_net", "micro_mesh", "piece_net", "ray_net", "separating_axis"}


class Constants(unittest.TestCase):
    def test_every_constant_of_the_pages_has_a_script_and_every_script_a_constant(self):
        names = set(constants())
        self.assertEqual({path.stem for path in SCRIPTS.glob("*.g")}, names | {name + "_box" for name in names})
        pages = {path.stem for path in (ROOT / "docs" / "bounds").glob("*.md")} - {"README"} - COUNTED
        covered = {re.sub(r"^(implicit)_.*", r"\1_point", name).removesuffix("_ray") for name in names}
        self.assertEqual(pages, covered)

    def test_the_constant_of_the_script_is_that_of_the_code(self):
        for name, constant in constants().items():
            self.assertEqual(REL.findall((SCRIPTS / f"{name}.g").read_text()), [constant], name)

    def test_the_scripts_are_proved_and_smaller_constants_are_not(self):
        for name, constant in constants().items():
            text, value = (SCRIPTS / f"{name}.g").read_text(), float.fromhex(constant)
            with self.subTest(name):
                proved, output = gappa(text, *PRECISION)
                self.assertTrue(proved, output)
                for smaller in (value / 2, math.nextafter(value, 0)):
                    proved, output = gappa(REL.sub(f"kRel = {smaller.hex()};", text), *PRECISION)
                    self.assertFalse(proved, f"{smaller.hex()} would do, too")
                    self.assertIn("some properties were not satisfied", output)


class Boxes(unittest.TestCase):
    def test_the_programs_stay_within_the_bound_on_a_box_and_not_within_a_fourth_of_it(self):
        for path in sorted(SCRIPTS.glob("*_box.g")):
            text = path.read_text()
            with self.subTest(path.name):
                proved, output = gappa(text, PRECISION[1])
                self.assertTrue(proved, output)
                fourth = BOUND.sub(lambda bound: (float.fromhex(bound[0]) / 4).hex(), text)
                self.assertFalse(gappa(fourth, PRECISION[1])[0])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--boxes", action="store_true")
    options, rest = parser.parse_known_args()
    if not shutil.which("gappa"):
        print(SKIPPED, file=sys.stderr)
        return NO_GAPPA
    suite = "Boxes" if options.boxes else "Constants"
    unittest.main(argv=[sys.argv[0], *rest, *([] if rest else [suite])])
    return 0


if __name__ == "__main__":
    sys.exit(main())
