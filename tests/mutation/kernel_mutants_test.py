#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 OR MIT
"""Which places kernel_mutants.py changes. Needs no compiler."""
import pathlib
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import kernel_mutants                                     # noqa: E402

SNIPPET = """// 0.5 < 1 is no code
int f(double x, int n) {
  for (int i = 0; i < n; ++i) {}
  if (x >= 0.25 && n == 3) return 2 * n;
  if (const int m = n; m < 4) return 1;
  return x < 1 ? 1 : 0;
}
constexpr double kUnit = 0x1p-52;
"""


def places(layer):
    paths = sorted({str(p.relative_to(kernel_mutants.ROOT)) for pattern in kernel_mutants.LAYERS[layer]["files"]
                    for p in kernel_mutants.ROOT.glob(pattern)})
    return [m for p in paths for m in kernel_mutants.Instrumented(p, 0, set()).mutants]


class Places(unittest.TestCase):
    def test_constants_comparisons_and_conditions_are_changed_and_nothing_else(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(kernel_mutants, "ROOT", pathlib.Path(folder)):
            (pathlib.Path(folder) / "f.cc").write_text(SNIPPET)
            made = kernel_mutants.Instrumented("f.cc", 7, set())
            left = kernel_mutants.Instrumented("f.cc", 7, {4})
        found = [(m.line, m.what) for m in made.mutants]
        self.assertEqual(sorted(found), sorted(
            [(4, ">= to <"), (4, ">= to >"), (4, "== to !="), (4, "condition true"), (4, "condition false")] +
            [(4, c + " " + x) for c in ("0.25", "2") for x in ("halved", "doubled", "zeroed")] +
            [(5, "< to >="), (5, "< to <=")] + [(6, "< to >="), (6, "< to <=")] +
            [(8, "0x1p-52 " + x) for x in ("halved", "doubled", "zeroed")]))
        self.assertEqual([m.number for m in made.mutants], list(range(7, 7 + len(found))))
        self.assertFalse([m for m in left.mutants if m.line == 4])
        self.assertIn("for (int i = 0; i < n; ++i)", made.text)
        self.assertIn("const double kUnit = vt::number(", made.text)

    def test_every_layer_has_enough_places(self):
        for layer, least in (("pieces", 400), ("side_witness", 200), ("crossing", 200), ("tubes", 200)):
            self.assertGreater(len(places(layer)), least, layer)

    def test_equivalent_mutants_are_mutants(self):
        keys = {kernel_mutants.key_of(m) for layer in kernel_mutants.LAYERS for m in places(layer)}
        for key in kernel_mutants.equivalents():
            self.assertTrue(key in keys, f"no layer has the mutant {key}")

    def test_every_rule_names_a_place_of_some_layer(self):
        mutants = [m for layer in kernel_mutants.LAYERS for m in places(layer)]
        files = {m.file for m in mutants}
        for file, _, _, reason in kernel_mutants.rules():
            self.assertIn(file, files)
            self.assertTrue(reason)
        self.assertEqual(kernel_mutants.excused(mutants)[1], [])

    def test_a_rule_for_a_function_ends_with_it(self):
        code = kernel_mutants.masked("""int a(int x) const {
  if (x < 1) return b(x);
  return 2;
}
Result K::b(int x, std::optional<int> y) {
  return a(x) < 3;
}
int c(int x) : d_(x) {}
int b(int x);
""")
        self.assertEqual(kernel_mutants.lines_of_function(code, "a"), {1, 2, 3, 4})
        self.assertEqual(kernel_mutants.lines_of_function(code, "b"), {5, 6, 7})


if __name__ == "__main__":
    unittest.main()
