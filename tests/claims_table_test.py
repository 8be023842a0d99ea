#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""The tables of claims of both checkers are one table, and no claim lacks a page, a lie that both checkers reject, or a certificate that
the tests of the command line and of the installation have checked.

usage: claims_table_test.py FOLDER      of the programs
"""
import json
import os
import pathlib
import random
import re
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "tests" / "support"), str(ROOT / "tests" / "mutation")]
import attacks  # noqa: E402
import collar_liars  # noqa: E402
import dms_invalid_liars  # noqa: E402
import dms_liars  # noqa: E402
import dms_pairs_liars  # noqa: E402
import every_claim  # noqa: E402
import fold_liars  # noqa: E402
import invalid_liars  # noqa: E402
import meeting_liars  # noqa: E402
import micro_inside_liars  # noqa: E402
import micro_liars  # noqa: E402
import patch_liars  # noqa: E402
import points_liars  # noqa: E402
import reversed_liars  # noqa: E402
import sheet_liars  # noqa: E402
import vmodel_invalid_liars  # noqa: E402
import vmodel_liars  # noqa: E402

BIN = pathlib.Path(sys.argv.pop(1)) if len(sys.argv) > 1 and pathlib.Path(sys.argv[1]).is_dir() else ROOT / "build" / "bin"
CHECKERS = [(BIN / "veritope-check",), (sys.executable, "-B", ROOT / "verify" / "checker" / "veritope_check.py")]
os.environ["VERITOPE"] = str(BIN / "veritope")             # it proves what some liars bend
PAGES = [path.read_text() for path in sorted((ROOT / "docs" / "certificates").glob("*.md"))]


def of_mesh(source):
    return lambda rng: ((case.bytes, certificate) for _, case, certificate in source(rng))


def of_points(source):
    return lambda rng: ((case.bytes, certificate, case.answers) for _, case, certificate in source(rng))


def of_patches(source):
    return lambda rng: ((model, certificate) for _, model, certificate in source(rng))


def of_models(source):
    return lambda rng: ((subject, certificate, model) for _, subject, certificate, model in source(rng))


def turned_shells(rng):
    return ((case.bytes, case.certificate(plan)) for case, plan in patch_liars.told_as_turned(rng))


# claim: where lies about it come from; tests/mutation tells many more
LIARS = {
    "mesh-valid-1": of_mesh(attacks.false_valid_attacks),
    "mesh-invalid-1": of_mesh(attacks.false_invalid_attacks),
    "mesh-reversed-1": of_mesh(reversed_liars.reversed_attacks),
    "points-1": of_points(points_liars.false_lines),
    "star-box-1": of_patches(patch_liars.star_attacks),
    "star-box-turned-1": turned_shells,
    "star-box-2": of_patches(sheet_liars.thin_attacks),
    "star-box-turned-2": of_patches(sheet_liars.wrong_windings),
    "patch-invalid-1": of_patches(invalid_liars.invalid_attacks),
    "patch-invalid-2": of_patches(meeting_liars.meeting_attacks),
    "volume-folded-1": of_patches(fold_liars.fold_attacks),
    "collar-1": of_patches(collar_liars.lies_about_a_collar),
    "collar-2": of_patches(collar_liars.lies_about_a_collar_2),
    "vmodel-1": of_patches(vmodel_liars.vmodel_attacks),
    "microstructure-1": of_patches(micro_liars.micro_attacks),
    "dms-solid-1": of_patches(dms_liars.dms_attacks),
    "dms-solid-2": of_patches(dms_pairs_liars.dms_pairs_attacks),
    "dms-invalid-1": of_patches(dms_invalid_liars.dms_invalid_attacks),
    "micro-inside-1": of_models(micro_inside_liars.inside_attacks),
    "vmodel-invalid-1": of_patches(vmodel_invalid_liars.invalid_cells_attacks),
}


def table_of(checker):
    """The lines of --claims: [name, magic, formats, keys]."""
    status, text = every_claim.output_of(*checker, "--claims")
    assert status == 0, text
    return [line.split(" ") for line in text.splitlines()]


class Claims(unittest.TestCase):
    def test_the_checkers_have_one_table(self):
        first, second = map(table_of, CHECKERS)
        self.assertEqual(first, second)
        self.assertGreaterEqual(len(first), 6)
        self.assertTrue(all(len(row) == 4 for row in first), first)

    def test_every_claim_has_a_page_with_its_magic_its_formats_and_its_keys(self):
        for name, magic, formats, keys in table_of(CHECKERS[0]):
            pages = [page for page in PAGES if f"`{name}`" in page or f'`"{name}"`' in page]
            self.assertTrue([page for page in pages if f"`{magic}`" in page], f"{name}: no page of docs/certificates has it and {magic}")
            for word in formats.split(","):
                self.assertTrue([page for page in PAGES if f'`"{word}"`' in page], word)
            for key in keys.split(","):
                self.assertTrue([page for page in PAGES if re.search(r"`%s`" % key.split("=")[0], page)], f"{name}: {key} is on no page")

    def test_every_claim_has_liars_and_both_checkers_reject_them(self):
        self.assertEqual(sorted(LIARS), sorted(row[0] for row in table_of(CHECKERS[0])))
        with tempfile.TemporaryDirectory() as folder:
            model, certificate, third = (pathlib.Path(folder) / name for name in ("model", "certificate", "third"))
            for claim, source in LIARS.items():
                model.write_bytes(b"")
                for subject, lie, *more in source(random.Random(1)):
                    self.assertEqual(json.loads(lie.split(b"\n", 1)[0])["claim"], claim)
                    model.write_bytes(subject)
                    certificate.write_bytes(lie)
                    option = ["--model"] if claim in every_claim.SOLIDS else []
                    files = [model, certificate, *(option + [third] if more else [])]
                    for data in more:
                        third.write_bytes(data)
                    for checker in CHECKERS:
                        status, text = every_claim.output_of(*checker, *files)
                        self.assertEqual((status, text[:7]), (1, "REJECT "), f"{claim}: {checker}: {text}")
                        self.assertFalse(text.startswith("REJECT S"), f"{claim}: {text}")
                    break
                self.assertTrue(model.read_bytes(), f"{claim}: nobody lies")

    def test_every_claim_is_certified_by_the_tests_of_the_command_line_and_of_the_installation(self):
        """What they do is in every_claim.py; each compares its claims with the checkers' when it runs."""
        self.assertEqual(sorted(every_claim.COMMANDS), sorted(row[0] for row in table_of(CHECKERS[0])))
        for test in ("tests/cli/claims_test.py", "tests/install/install_test.py"):
            self.assertIn("assert_every_claim(self, ", (ROOT / test).read_text(), test)


if __name__ == "__main__":
    unittest.main()
