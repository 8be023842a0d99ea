#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""tools/generate_predicates.py: what is committed is what it writes; malformed formulas are refused with their place; a predicate that is not
committed is generated, compiled and decides like fractions.

generator_test.py [COMPILER LIBRARY...]: without them nothing is compiled.
"""
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tools"))
import generate_predicates  # noqa: E402
from predicate_generator.bounds import Bound, derived_rel, round_up  # noqa: E402
from predicate_generator.formula import FormulaError, read_formula  # noqa: E402

COMPILER, LIBRARIES = None, []
CONIC = """predicate side_of_conic
question  on which side of the conic does p lie?
claim     ca x^2 + cb xy + cc y^2 + cd x + ce y + cf at p = (x, y).
points    p in 2
scalars   ca cb cc cd ce cf
evaluate
  quadratic = (ca * sqr(p.x) + cb * (p.x * p.y)) + cc * sqr(p.y)
  sign = quadratic + ((cd * p.x + ce * p.y) + cf)
"""
# Homogeneous: with integer tiers, and a factor.
CURVE = """predicate side_of_ellipse
question  on which side of the ellipse with the foci a, b and so long an axis does p lie?
claim     a polynomial made up for this test: 3 |p - a|^2 |p - b|^2 - w |a - b|^2, w a squared length.
points    a b p in 2
scalars   w scale length^2
law       swap a b : keeps
law       translate : keeps
evaluate
  u = p - a
  v = p - b
  f = a - b
  sign = 3 * (norm2(u) * norm2(v)) - w * norm2(f)
"""
MAIN = """#include "NAME.h"
#include <cstdio>
int main() {
  double v[COUNT];
  veritope::TierCounts tally;
  for (;;) {
    for (double& x : v) if (std::scanf("%la", &x) != 1) goto end;
    std::printf("%d\\n", veritope::to_int(veritope::NAME(CALL, &tally)));
  }
end:
  for (auto n : tally.decided) std::printf("tier %d\\n", static_cast<int>(n));
}
"""
GOOD = """predicate x_side
question  q?
claim     c
points    a b c in 2
law       swap a b : negates
evaluate
  u = a - c
  v = b - c
  sign = cross(u, v)
"""
BAD = [  # what is replaced in GOOD, by what, line, column, a part of the sentence
    ("predicate x_side", "predicate X side", 1, 11, "cannot be the name of a predicate"),
    ("predicate x_side", "predicate double", 1, 11, "cannot be the name of a predicate"),
    ("question  q?", "qestion q?", 2, 1, "'qestion' begins no line"),
    ("question  q?", "predicate y", 2, 1, "a second line 'predicate'"),
    ("claim     c\n", "", 9, 1, "the line 'claim' is missing"),
    ("points    a b c in 2", "points    a b c in 4", 4, 11, "points are in 2 or in 3 dimensions"),
    ("points    a b c in 2", "points    a b, c in 2", 4, 11, "expected: points NAME..."),
    ("points    a b c in 2", "points    a b a in 2", 4, 11, "'a' has been defined before"),
    ("points    a b c in 2", "points    a b c d in 2", 10, 1, "the sign does not depend on d"),
    ("points    a b c in 2", "points    a b c in 2\nscalars   w scale length^9", 5, 11, "the power of a scale is 1 to 4"),
    ("points    a b c in 2", "points    a b c in 2\norder     a b", 5, 11, "order must name every point and scalar once"),
    ("points    a b c in 2", "points    a b c in 2\n  more", 5, 3, "an indented line continues a text"),
    ("points    a b c in 2", "points    a b c in 2\nexample   1 2 -> 2", 5, 11, "expected: example NUMBERS"),
    ("points    a b c in 2", "points    a b c in 2\nexample   1 2 -> 1", 5, 11, "6 numbers expected, but there are 2"),
    ("claim     c", "claim     c\nbound     smallest", 4, 1, "the bound is S"),
    ("swap a b : negates", "swap a b : keeps", 5, 11, "this law does not hold: swapping a b"),
    ("swap a b : negates", "swap a d : negates", 5, 11, "two arguments expected"),
    ("swap a b : negates", "translate a : keeps", 5, 11, "this law does not hold: moving a by one vector"),
    ("swap a b : negates", "turn a b : negates", 5, 11, "expected: law swap"),
    ("u = a - c", "u = a - d", 7, 11, "'d' is not defined"),
    ("u = a - c", "u = a - c.w", 7, 11, "'c' has no coordinate 'w'"),
    ("u = a - c", "u = a * c", 7, 9, "'*' does not go with these"),
    ("u = a - c", "u = a - a", 7, 9, "a difference of equal things"),
    ("u = a - c", "u a - c", 7, 5, "'=' expected, but there is 'a'"),
    ("u = a - c", "u = a - c )", 7, 13, "an operation or the end of the line expected, but there is ')'"),
    ("u = a - c", "u = a -", 7, 10, "a name, a number or '(' expected, but there is the end of the line"),
    ("u = a - c", "u = (a - c", 7, 13, "')' expected, but there is the end of the line"),
    ("u = a - c", "a = a - c", 7, 3, "'a' has been defined before"),
    ("sign = cross(u, v)", "sign = cross(u, v) / u.x", 9, 22, "polynomials have no division"),
    ("sign = cross(u, v)", "sign = u.x ^ 2 - v.y", 9, 14, "write sqr(x)"),
    ("sign = cross(u, v)", "sign = -cross(u, v)", 9, 10, "there is no sign in front of a factor"),
    ("sign = cross(u, v)", "sign = sin(u.x)", 9, 10, "no function sin of such arguments"),
    ("sign = cross(u, v)", "sign = cross(u, v) + 1", 9, 22, "a number may only be multiplied"),
    ("sign = cross(u, v)", "sign = cross(u, v) $", 9, 22, "but there is '$'"),
    ("sign = cross(u, v)", "sign = u.x", 9, 13, "sign must be a number that is computed"),
    ("sign = cross(u, v)", "sign = u", 9, 11, "sign must be a number that is computed"),
    ("sign = cross(u, v)", "sign = cross(u, v) - (u.x * v.y - u.y * v.x)", 9, 22, "a difference of equal things"),
    ("sign = cross(u, v)", "sign = (u.x + v.x) * v.y - (v.y * v.x + u.x * v.y)", 10, 1, "sign is zero whatever the inputs are"),
    ("sign = cross(u, v)", "det = cross(u, v)", 9, 3, "'det' cannot be a name"),
    ("  sign = cross(u, v)\n", "", 9, 1, "evaluate does not define sign"),
]


class Committed(unittest.TestCase):
    def test_the_committed_files_are_what_the_tool_writes(self):
        files = generate_predicates.committed_files()
        for path, text in files.items():
            self.assertEqual((ROOT / path).read_text(encoding="utf-8") if (ROOT / path).exists() else None, text, f"{path}: run tools/generate_predicates.py")
        made = re.compile(r"(?m)^(//|#|) ?Made by `?tools/generate_predicates\.py`? from ")
        for folder in ("predicates/generated", "docs/bounds", "docs/bounds/gappa", "tests/predicates/generated"):
            for path in (ROOT / folder).iterdir():
                if path.suffix in (".h", ".cc", ".md", ".g") and made.search(path.read_text(encoding="utf-8")):
                    self.assertIn(str(path.relative_to(ROOT)), files, "made from a formula that is gone")


class Malformed(unittest.TestCase):
    def test_the_formula_before_it_is_malformed_is_read(self):
        self.assertEqual(read_formula(GOOD, "x_side.formula").name, "x_side")

    def test_what_is_wrong_is_named_and_placed(self):
        for old, new, line, column, part in BAD:
            with self.subTest(new):
                self.assertEqual(GOOD.count(old), 1)
                with self.assertRaises(FormulaError) as caught:
                    read_formula(GOOD.replace(old, new), "f")
                self.assertIn(part, str(caught.exception))
                self.assertTrue(str(caught.exception).startswith(f"f:{line}:{column}: "), str(caught.exception))

    def test_the_program_says_it_on_standard_error_and_ends_with_1(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "x_side.formula"
            path.write_text(GOOD.replace("cross(u, v)", "cross(u, v) / 2"))
            done = subprocess.run([sys.executable, ROOT / "tools" / "generate_predicates.py", path, "--output", folder],
                                  capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertEqual(done.stderr, f"generate_predicates: {path}:9:22: polynomials have no division\n")
            self.assertEqual([p.name for p in pathlib.Path(folder).iterdir()], ["x_side.formula"])


class Bounds(unittest.TestCase):
    def test_the_constant_of_a_known_formula(self):
        bound = Bound(read_formula(GOOD, "f"))
        self.assertEqual((bound.k, bound.k_magnitude, bound.degree), (3, 4, 0))
        self.assertEqual(bound.rel, float.fromhex("0x1.8000000000007p-52"))

    def test_a_constant_is_the_least_binary64_number_that_does(self):
        for k in range(1, 40):
            exact = derived_rel(k, k + 1)
            above = round_up(exact)
            self.assertGreaterEqual(Fraction(above), exact)
            self.assertLess(Fraction(above) * (1 - Fraction(1, 2**52)), exact)

    def test_one_more_operation_costs_a_rounding(self):
        longer = GOOD.replace("cross(u, v)", "cross(u, v) + u.x * v.x").replace("law       swap a b : negates\n", "")
        self.assertEqual(Bound(read_formula(longer, "f")).k, 4)


def conic(v):
    x, y, *c = v
    return c[0] * x * x + c[1] * x * y + c[2] * y * y + c[3] * x + c[4] * y + c[5]


def ellipse(v):
    ax, ay, bx, by, px, py, w = v
    return 3 * ((px - ax)**2 + (py - ay)**2) * ((px - bx)**2 + (py - by)**2) - w * ((ax - bx)**2 + (ay - by)**2)


def hard_cases(draw, count):
    """Small integers (many zeros), scaled by powers of two; full mantissas; all of binary64's exponents."""
    for i in range(600):
        kind = i % 4
        if kind < 2:
            yield [draw.randint(-1, 1) * 2.0 ** (draw.choice((0, -30)) if kind else 0) for _ in range(count)]
        elif kind == 2:
            yield [draw.uniform(-1, 1) * 2.0 ** draw.randint(-40, 40) for _ in range(count)]
        else:
            yield [draw.choice((0.0, 5e-324, 1.7e308, -1.0, draw.uniform(-1, 1) * 2.0 ** draw.randint(-1000, 1000))) for _ in range(count)]


class NotCommitted(unittest.TestCase):
    def decide(self, text, call, value, tiers):
        self.assertIsNotNone(COMPILER)
        name = text.split()[1]
        count = len(re.findall(r"v\[", call))
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / f"{name}.formula").write_text(text)
            subprocess.run([sys.executable, ROOT / "tools" / "generate_predicates.py", folder / f"{name}.formula", "--output", folder], check=True)
            self.assertEqual({p.name for p in folder.iterdir()}, {name + end for end in (".formula", ".h", ".cc", ".md", ".g", "_box.g")})
            (folder / "main.cc").write_text(MAIN.replace("NAME", name).replace("COUNT", str(count)).replace("CALL", call))
            subprocess.run([COMPILER, "-std=c++20", "-O1", "-Wall", "-Wextra", "-Wno-unused-parameter", "-Werror", "-ffp-contract=off", f"-I{ROOT}", f"-I{folder}",
                            folder / "main.cc", folder / f"{name}.cc", *LIBRARIES, "-lgmp", "-o", folder / "main"], check=True)
            cases = list(hard_cases(random.Random(5), count))
            done = subprocess.run([folder / "main"], input="".join(" ".join(x.hex() for x in case) + "\n" for case in cases), capture_output=True, text=True, check=True)
        lines = done.stdout.split("\n")
        zeros = 0
        for case, sign in zip(cases, lines):
            exact = value([Fraction(x) for x in case])
            self.assertEqual(int(sign), (exact > 0) - (exact < 0), f"seed 5: {[x.hex() for x in case]}")
            zeros += exact == 0
        self.assertGreater(zeros, 5)
        counts = [int(n) for n in re.findall(r"tier (\d+)", done.stdout)]
        self.assertEqual(sum(counts), len(cases))
        self.assertEqual([n > 0 for n in counts], tiers)

    def test_a_conic_whose_inputs_have_no_common_scale(self):
        if not COMPILER:
            self.skipTest("no compiler given")
        self.decide(CONIC, "{v[0], v[1]}, v[2], v[3], v[4], v[5], v[6], v[7]", conic, [True, False, True, True])

    def test_a_curve_of_degree_four_with_a_factor_and_all_tiers(self):
        if not COMPILER:
            self.skipTest("no compiler given")
        self.decide(CURVE, "{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}, v[6]", ellipse, [True, True, True, True])


if __name__ == "__main__":
    COMPILER, *LIBRARIES = sys.argv[1:] or [None]
    unittest.main(argv=sys.argv[:1])
